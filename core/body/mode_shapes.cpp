#include "core/body/mode_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "core/body/static_columns.hpp"
#include "core/chance/philox.hpp"
#include "core/door/eigen.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// Of a mode, relative: shapes that are right to this leave energies right to its square.
constexpr double kTolerance = 1e-8;
/// Of the Krylov vectors, over the modes asked for.
constexpr std::size_t kMostVectors = 8;
/// A vector that is this small once what is there already is taken out of it says nothing new.
constexpr double kLeastNew = 1e-10;
/// Of a stretch, beyond what modes carry: less is rounding.
constexpr double kLeastLeft = 1e-8;
constexpr std::uint64_t kSeed = 0x6d6f646573;  // any; the same for every body

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Vectors scaled by the root of the masses, in which M is 1.
class ScaledBody {
 public:
  explicit ScaledBody(const BodyModel& body) : body_(body), root_(freedoms(body)) {
    for (Eigen::Index i = 0; i < root_.size(); ++i) {
      root_[i] = std::sqrt(body.mass_kg[static_cast<std::size_t>(i) / 3]);
    }
  }
  static Eigen::Index freedoms(const BodyModel& body) {
    return static_cast<Eigen::Index>(3 * body.particle_count);
  }
  [[nodiscard]] const Vector& root_mass() const { return root_; }

  /// M^1/2 (share K + shift M)^-1 M^1/2 on up to kLanes columns, share being what of K is left at rest.
  [[nodiscard]] Matrix inverse(const Matrix& columns) const {
    return root_.asDiagonal() * shifted_columns(*body_.statics, root_.asDiagonal() * columns);
  }
  /// M^-1/2 K M^-1/2 on one column.
  [[nodiscard]] Vector stiffness(const Vector& column) const {
    const Vector moved = column.cwiseQuotient(root_);
    Vector force(moved.size());
    multiply(body_.K, std::span<const double>(moved.data(), static_cast<std::size_t>(moved.size())),
             std::span<double>(force.data(), static_cast<std::size_t>(force.size())));
    return force.cwiseQuotient(root_);
  }
  /// Orthonormal: translations, then rotations about the axes of inertia.
  [[nodiscard]] Matrix rigid(std::array<std::array<double, 3>, 3>& turn) const {
    Matrix motions = Matrix::Zero(root_.size(), kRigidModes);
    const Eigen::Map<const Eigen::Matrix3d> inverse_inertia(body_.inverse_inertia.data());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(inverse_inertia);
    const double translation = 1.0 / std::sqrt(body_.total_mass_kg);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d about = inertia.eigenvectors().col(axis) * std::sqrt(inertia.eigenvalues()[axis]);
      std::copy_n(about.data(), 3, turn[static_cast<std::size_t>(axis)].begin());
      for (std::size_t p = 0; p < body_.particle_count; ++p) {
        const auto row = static_cast<Eigen::Index>(3 * p);
        const Eigen::Vector3d X = Eigen::Map<const Eigen::Vector3d>(body_.position_m[p].data()) -
                                  Eigen::Map<const Eigen::Vector3d>(body_.center_of_mass_m.data());
        motions(row + axis, axis) = translation * root_[row];
        motions.block<3, 1>(row, 3 + axis) = about.cross(X) * root_[row];
      }
    }
    return motions;
  }

 private:
  const BodyModel& body_;
  Vector root_;
};

struct Deforming {
  Vector square_1_s2;
  Matrix vectors;  ///< scaled, orthonormal
  double residual;
};

/// Of vectors of norm 1, how far they are from modes.
double residual_of(const ScaledBody& body, const Vector& square_1_s2, const Matrix& vectors) {
  double largest = 0.0;
  for (Eigen::Index j = 0; j < vectors.cols(); ++j) {
    const Vector off = body.stiffness(vectors.col(j)) - square_1_s2[j] * vectors.col(j);
    largest = std::max(largest, off.norm() / square_1_s2[j]);
  }
  return largest;
}

/// An orthonormal basis that grows block by block.
class Basis {
 public:
  Basis(const Matrix& rigid, Eigen::Index most) : rigid_(rigid), vectors_(rigid.rows(), most) {}

  [[nodiscard]] Eigen::Index size() const { return size_; }
  [[nodiscard]] auto vectors() const { return vectors_.leftCols(size_); }
  /// Adds what of the columns is new. @return the columns that were added
  Matrix add(Matrix columns) {
    const Eigen::Index first = size_;
    clear_of_others(columns);
    for (Eigen::Index j = 0; j < columns.cols() && size_ < vectors_.cols(); ++j) {
      const double before = columns.col(j).norm();
      if (!(before > 0.0)) continue;
      Vector column = columns.col(j) / before;
      for (int pass = 0; pass < 2; ++pass) {
        const auto added = vectors_.middleCols(first, size_ - first);
        column -= added * (added.transpose() * column).eval();
      }
      const double left = column.norm();
      if (left < kLeastNew) continue;
      column /= left;
      Matrix one = column;
      clear_of_others(one);  // what division by a small norm has brought back
      vectors_.col(size_++) = one.col(0).normalized();
    }
    return vectors_.middleCols(first, size_ - first);
  }

 private:
  void clear_of_others(Matrix& columns) const {
    for (int pass = 0; pass < 2; ++pass) {
      columns -= rigid_ * (rigid_.transpose() * columns).eval();
      columns -= vectors() * (vectors().transpose() * columns).eval();
    }
  }

  const Matrix& rigid_;
  Matrix vectors_;
  Eigen::Index size_ = 0;
};

Matrix random_block(Eigen::Index rows) {
  Matrix block(rows, kLanes);
  for (Eigen::Index j = 0; j < block.cols(); ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) {
      block(i, j) = standard_normal(kSeed, static_cast<std::uint64_t>(j), static_cast<std::uint64_t>(i));
    }
  }
  return block;
}

/// omega^2 behind an eigenvalue of `ScaledBody::inverse`.
struct Inverted {
  double shift_1_s2, share;
  [[nodiscard]] double square_1_s2(double value) const { return (1.0 / value - shift_1_s2) / share; }
};

/// The modes in the span of some vectors. @param mapped the inverse of each of them
Deforming ritz(const ScaledBody& body, const Inverted& inverted, const Matrix& vectors, const Matrix& mapped,
               Eigen::Index wanted) {
  Matrix projected = vectors.transpose() * mapped;
  projected = 0.5 * (projected + projected.transpose()).eval();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(projected);
  Deforming modes;
  modes.square_1_s2.resize(wanted);
  Matrix weights(vectors.cols(), wanted);
  for (Eigen::Index j = 0; j < wanted; ++j) {
    const Eigen::Index from = vectors.cols() - 1 - j;  // the largest inverse is the slowest mode
    modes.square_1_s2[j] = inverted.square_1_s2(solver.eigenvalues()[from]);
    weights.col(j) = solver.eigenvectors().col(from);
  }
  modes.vectors = vectors * weights;
  modes.residual = residual_of(body, modes.square_1_s2, modes.vectors);
  return modes;
}

Deforming by_krylov_vectors(const ScaledBody& body, const Inverted& inverted, const Matrix& rigid,
                            Eigen::Index wanted) {
  const Eigen::Index most =
      std::min(rigid.rows() - rigid.cols(), static_cast<Eigen::Index>(kMostVectors) * (wanted + kLanes));
  Basis basis(rigid, most);
  Matrix mapped(rigid.rows(), most);
  Matrix block = basis.add(random_block(rigid.rows()));
  for (Eigen::Index next = 2 * wanted; block.cols() > 0;) {
    const Matrix image = body.inverse(block);
    mapped.middleCols(basis.size() - block.cols(), block.cols()) = image;
    if (basis.size() >= std::min(next, most)) {
      Deforming modes = ritz(body, inverted, basis.vectors(), mapped.leftCols(basis.size()), wanted);
      if (modes.residual < kTolerance) return modes;
      next = basis.size() + std::max<Eigen::Index>(2 * kLanes, wanted / 4);
    }
    block = basis.add(image);
  }
  throw std::invalid_argument("the modes of the product could not be found: use fewer (simulation.mode_count)");
}

Deforming by_dense_solve(const BodyModel& model, const ScaledBody& body, Eigen::Index wanted) {
  const Eigen::Index n = body.root_mass().size();
  Matrix K = Matrix::Zero(n, n);
  for (int p = 0; p < model.K.particle_count; ++p) {
    for (int at = model.K.row_start[static_cast<std::size_t>(p)];
         at < model.K.row_start[static_cast<std::size_t>(p) + 1]; ++at) {
      const auto entry = static_cast<std::size_t>(at);
      for (int i = 0; i < 9; ++i) {
        K(3 * p + i / 3, 3 * model.K.column[entry] + i % 3) =
            model.K.value[9 * entry + static_cast<std::size_t>(i)];
      }
    }
  }
  const auto inverse_root = body.root_mass().cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(inverse_root * K * inverse_root);
  Deforming modes{solver.eigenvalues().segment(kRigidModes, wanted),
                  solver.eigenvectors().middleCols(kRigidModes, wanted), 0.0};
  modes.residual = residual_of(body, modes.square_1_s2, modes.vectors);
  return modes;
}

}  // namespace

ModeShapes slowest_modes(const BodyModel& body, std::size_t deforming) {
  require(!body.is_anchored() && body.statics != nullptr && body.lattice.has_value(),
          "slowest_modes: not a lattice that nothing holds");
  const ScaledBody scaled(body);
  const Eigen::Index freedoms = ScaledBody::freedoms(body),
                     all = freedoms - static_cast<Eigen::Index>(kRigidModes);
  const Eigen::Index wanted = std::min(all, static_cast<Eigen::Index>(deforming));
  ModeShapes modes;
  const Matrix rigid = scaled.rigid(modes.turn);
  const Deforming found =
      2 * wanted >= all
          ? by_dense_solve(body, scaled, wanted)
          : by_krylov_vectors(scaled, {body.statics->shift_1_s2(), body.relaxation.rest_share()}, rigid, wanted);
  modes.residual = found.residual;
  modes.square_1_s2.assign(kRigidModes, 0.0);
  modes.square_1_s2.insert(modes.square_1_s2.end(), found.square_1_s2.begin(), found.square_1_s2.end());
  modes.shape.resize(static_cast<std::size_t>(freedoms) * modes.count());
  Eigen::Map<Matrix> shape(modes.shape.data(), freedoms, static_cast<Eigen::Index>(modes.count()));
  shape << rigid, found.vectors;
  shape = scaled.root_mass().cwiseInverse().asDiagonal() * shape;
  return modes;
}

void add_stretches(const BodyModel& body, ModeShapes& modes) {
  const ScaledBody scaled(body);
  const Eigen::Index freedoms = ScaledBody::freedoms(body), count = static_cast<Eigen::Index>(modes.count());
  const Matrix carried =
      scaled.root_mass().asDiagonal() * Eigen::Map<const Matrix>(modes.shape.data(), freedoms, count);
  Matrix stretch = Matrix::Zero(freedoms, 6);
  for (std::size_t p = 0; p < body.particle_count; ++p) {
    for (Eigen::Index a = 0, column = 0; a < 3; ++a) {
      for (Eigen::Index b = a; b < 3; ++b, ++column) {
        const auto row = static_cast<Eigen::Index>(3 * p);
        const auto X = [&](Eigen::Index axis) {
          return body.position_m[p][static_cast<std::size_t>(axis)] -
                 body.center_of_mass_m[static_cast<std::size_t>(axis)];
        };
        stretch(row + a, column) += X(b) * scaled.root_mass()[row];
        stretch(row + b, column) += X(a) * scaled.root_mass()[row];
      }
    }
  }
  Matrix known(freedoms, count + stretch.cols());
  known.leftCols(count) = carried;
  Eigen::Index size = count;
  for (Eigen::Index column = 0; column < stretch.cols(); ++column) {
    Vector left = stretch.col(column).normalized();
    const auto clear = [&] { left -= known.leftCols(size) * (known.leftCols(size).transpose() * left).eval(); };
    clear();
    clear();
    if (left.norm() < kLeastLeft) continue;
    left.normalize();
    clear();
    known.col(size++) = left.normalized();
  }
  const Matrix left = known.middleCols(count, size - count);
  if (left.cols() == 0) return;
  Matrix force(freedoms, left.cols());
  for (Eigen::Index j = 0; j < left.cols(); ++j) force.col(j) = scaled.stiffness(left.col(j));
  const Matrix K = left.transpose() * force;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(0.5 * (K + K.transpose()));
  const Matrix shape = scaled.root_mass().cwiseInverse().asDiagonal() * (left * solver.eigenvectors());
  modes.shape.insert(modes.shape.end(), shape.data(), shape.data() + shape.size());
  modes.square_1_s2.insert(modes.square_1_s2.end(), solver.eigenvalues().begin(), solver.eigenvalues().end());
  modes.stretches = static_cast<std::size_t>(left.cols());
}

}  // namespace unbruised
