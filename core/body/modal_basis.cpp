#include "core/body/modal_basis.hpp"

#include <algorithm>
#include <cmath>

#include "core/body/static_columns.hpp"
#include "core/door/eigen.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

using Matrix = Eigen::MatrixXd;
using Shapes = Eigen::Map<const Matrix>;

Shapes shapes_of(const ModeShapes& modes) {
  return {modes.shape.data(), static_cast<Eigen::Index>(modes.shape.size() / modes.count()),
          static_cast<Eigen::Index>(modes.count())};
}

/// Answers of the body without its modes to up to kLanes columns of forces: (1 - S S' M) K^-1 (1 - M S S'), less
/// what stretches answer. Statics know what of K is left at rest.
Matrix left_out(const BodyModel& body, const ModeShapes& modes, const Matrix& force_N) {
  const Shapes all = shapes_of(modes);
  const auto S = all.leftCols(static_cast<Eigen::Index>(modes.mode_count()));
  Eigen::VectorXd mass(S.rows());
  for (Eigen::Index i = 0; i < mass.size(); ++i) mass[i] = body.mass_kg[static_cast<std::size_t>(i) / 3];
  const Matrix taken = S * (S.transpose() * force_N).eval();
  const Matrix load = force_N - mass.asDiagonal() * taken;
  Matrix shape = body.relaxation.rest_share() * shifted_columns(*body.statics, load);
  const Matrix weighed = S.transpose() * (mass.asDiagonal() * shape).eval();
  shape -= S * weighed;
  for (std::size_t k = modes.mode_count(); k < modes.count(); ++k) {
    const auto stretch = all.col(static_cast<Eigen::Index>(k));
    shape -= stretch * (stretch.transpose() * force_N).eval() / modes.square_1_s2[k];
  }
  return shape;
}

/// The freedom of the body behind a row of nodes.
Eigen::Index freedom_of(const std::vector<int>& node, std::size_t row) {
  return 3 * static_cast<Eigen::Index>(node[row / 3]) + static_cast<Eigen::Index>(row % 3);
}

/// Cells with a corner among the nodes.
std::vector<std::size_t> cells_at(const Lattice& lattice, const std::vector<int>& node) {
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < lattice.cell.size(); ++cell) {
    const auto& corners = lattice.cell[cell];
    if (std::ranges::any_of(corners, [&](int corner) { return std::ranges::binary_search(node, corner); })) {
      cells.push_back(cell);
    }
  }
  return cells;
}

/// Mean strains and rotations of some cells under shapes, kStrainRows each, one column a shape.
Matrix strains_of(const BodyModel& body, const std::vector<std::size_t>& cells, const Matrix& shapes) {
  const auto& B = body.cell.front().B;
  // Of engineering shears and of the parts that are taken from each other: [u_zy, u_yz], [u_xz, u_zx], [u_yx,
  // u_xy].
  constexpr std::size_t kFirst[] = {2, 0, 1}, kSecond[] = {1, 2, 0};
  Matrix strain = Matrix::Zero(static_cast<Eigen::Index>(kStrainRows * cells.size()), shapes.cols());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t j = 0; j < 24; ++j) {
      const std::size_t axis = j % 3;
      const auto shape = shapes.row(3 * static_cast<Eigen::Index>(body.lattice->cell[cells[c]][j / 3]) +
                                    static_cast<Eigen::Index>(axis));
      const auto add = [&](std::size_t row, double factor) {
        strain.row(static_cast<Eigen::Index>(kStrainRows * c + row)) += factor * shape;
      };
      for (std::size_t i = 0; i < 6; ++i) add(i, (i < 3 ? 1.0 : 0.5) * B[24 * i + j]);
      for (std::size_t i = 0; i < 3; ++i) {
        const double half = 0.5 * B[24 * (3 + i) + j];
        if (axis == kFirst[i]) add(6 + i, half);
        if (axis == kSecond[i]) add(6 + i, -half);
      }
    }
  }
  return strain;
}

DenseMatrix packed(const Matrix& values) {
  return {static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols()),
          [&](std::size_t i, std::size_t j) {
            return values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          }};
}

Matrix unpacked(const DenseMatrix& packed) {
  Matrix values(static_cast<Eigen::Index>(packed.rows()), static_cast<Eigen::Index>(packed.columns()));
  for (std::size_t i = 0; i < packed.rows(); ++i) {
    for (std::size_t j = 0; j < packed.columns(); ++j) {
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = packed.at(i, j);
    }
  }
  return values;
}

}  // namespace

ModalBasis modal_basis(const BodyModel& body, std::size_t deforming, std::vector<int> node, ProductFrame frame) {
  ModalBasis basis;
  basis.modes = slowest_modes(body, deforming);
  if (frame == ProductFrame::floating) add_stretches(body, basis.modes);
  basis.node = std::move(node);
  const Shapes S = shapes_of(basis.modes);
  const std::size_t rows = basis.node_freedoms();
  const auto count = static_cast<Eigen::Index>(rows);
  Matrix at_nodes(count, S.cols());
  for (std::size_t i = 0; i < rows; ++i) {
    at_nodes.row(static_cast<Eigen::Index>(i)) = S.row(freedom_of(basis.node, i));
  }
  basis.at_nodes = packed(at_nodes);
  basis.from_nodes = packed(at_nodes.transpose());
  const std::vector<std::size_t> cells = cells_at(*body.lattice, basis.node);
  basis.strain_of_modes = packed(strains_of(body, cells, S));
  Matrix rest(count, count), strain(static_cast<Eigen::Index>(kStrainRows * cells.size()), count);
  for (Eigen::Index first = 0; first < count; first += kLanes) {
    const Eigen::Index width = std::min<Eigen::Index>(kLanes, count - first);
    Matrix force = Matrix::Zero(S.rows(), width);
    for (Eigen::Index j = 0; j < width; ++j) {
      force(freedom_of(basis.node, static_cast<std::size_t>(first + j)), j) = 1.0;
    }
    const Matrix shape = left_out(body, basis.modes, force);
    for (std::size_t i = 0; i < rows; ++i) {
      rest.block(static_cast<Eigen::Index>(i), first, 1, width) = shape.row(freedom_of(basis.node, i));
    }
    strain.middleCols(first, width) = strains_of(body, cells, shape);
  }
  rest = 0.5 * (rest + rest.transpose()).eval();
  basis.rest = packed(rest);
  basis.strain_of_rest = packed(strain);
  if (frame == ProductFrame::floating) basis.turning = turning_basis(body, basis.modes);
  return basis;
}

double viscous_share(const BodyModel& body, const WilsonTheta& w) {
  return body.relaxation.stiffness_theta + body.relaxation_time_s * w.a1;
}

std::vector<double> effective_square_1_s2(const ModalBasis& basis, const BodyModel& body, const WilsonTheta& w) {
  std::vector<double> effective = basis.modes.square_1_s2;
  for (double& square : effective) square = w.a0 + square * viscous_share(body, w);
  return effective;
}

std::vector<double> modal_compliance(const ModalBasis& basis, const BodyModel& body, const WilsonTheta& w) {
  const std::vector<double> effective = effective_square_1_s2(basis, body, w);
  const Eigen::Map<const Eigen::VectorXd> square(effective.data(), static_cast<Eigen::Index>(effective.size()));
  const Matrix at_nodes = unpacked(basis.at_nodes);
  const Matrix W = at_nodes * square.cwiseInverse().asDiagonal() * at_nodes.transpose() +
                   unpacked(basis.rest) / viscous_share(body, w);
  const std::size_t rows = basis.node_freedoms(), m = basis.node.size();
  std::vector<double> block(9 * m * m);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < rows; ++j) {
      block[9 * (i / 3 * m + j / 3) + 3 * (i % 3) + j % 3] =
          W(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  return block;
}

double share_left_out(const ModalBasis& basis, std::span<const int> which, std::size_t axis) {
  const auto row_of = [axis](int node) { return 3 * static_cast<std::size_t>(node) + axis; };
  double left = 0.0, kept = 0.0;
  for (const int i : which) {
    for (const int j : which) left += basis.rest.at(row_of(i), row_of(j));
  }
  for (std::size_t mode = kRigidModes; mode < basis.modes.count(); ++mode) {
    double sum = 0.0;
    for (const int i : which) sum += basis.at_nodes.at(row_of(i), mode);
    kept += sum * sum / basis.modes.square_1_s2[mode];
  }
  return left / (left + kept);
}

std::vector<std::vector<double>> rest_shapes(const ModalBasis& basis, const BodyModel& body,
                                             std::span<const std::vector<double>> force_N) {
  require(force_N.size() <= static_cast<std::size_t>(kLanes), "rest_shapes: more than lanes");
  Matrix force =
      Matrix::Zero(static_cast<Eigen::Index>(3 * body.particle_count), static_cast<Eigen::Index>(force_N.size()));
  for (std::size_t k = 0; k < force_N.size(); ++k) {
    require(force_N[k].size() == basis.node_freedoms(), "rest_shapes: forces on other particles");
    for (std::size_t i = 0; i < force_N[k].size(); ++i) {
      force(freedom_of(basis.node, i), static_cast<Eigen::Index>(k)) = force_N[k][i];
    }
  }
  const Matrix shape = left_out(body, basis.modes, force);
  std::vector<std::vector<double>> shapes;
  for (Eigen::Index k = 0; k < shape.cols(); ++k) {
    shapes.emplace_back(shape.col(k).data(), shape.col(k).data() + shape.rows());
  }
  return shapes;
}

}  // namespace unbruised
