#include "core/algebra/lane_solve.hpp"

#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "core/algebra/lane_matrix.hpp"
#include "core/algebra/shifted_entries.hpp"
#include "core/algebra/supernodal_cholesky.hpp"
#include "core/body/lattice.hpp"
#include "core/body/lattice_stiffness.hpp"
#include "core/body/static_solver.hpp"
#include "core/lanes/single_lanes.hpp"

namespace unbruised {
namespace {

/// K + shift M of a lattice body, and its factor.
struct Body {
  BlockMatrix K;
  SymmetricMatrix matrix;
  std::unique_ptr<SparseCholesky> cholesky;
  SupernodalFactor factor;
};

Body body(Shape shape, int cells, double shift) {
  LatticeParameters p;
  p.shape = shape;
  p.size_m = {0.05, 0.05, 0.05};
  p.cell_size_m = 0.05 / cells;
  p.density_kg_m3 = 1000.0;
  p.youngs_modulus_Pa = 3e5;
  p.poisson_ratio = 0.4;
  const Lattice lattice = build_lattice(p);
  Body result;
  result.K =
      assemble_stiffness(lattice, cell_stiffness(p.youngs_modulus_Pa, p.poisson_ratio, lattice.cell_extent_m));
  std::vector<int> freedom(3 * lattice.position_m.size());
  std::iota(freedom.begin(), freedom.end(), 0);
  result.matrix = symmetric_from_entries(static_cast<int>(freedom.size()),
                                         shifted_entries(result.K, lattice.mass_kg, shift, freedom));
  std::string error;
  result.cholesky = SparseCholesky::factor(result.matrix, error);
  EXPECT_NE(result.cholesky, nullptr) << error;
  auto factor = factor_supernodes(result.matrix, error);
  EXPECT_TRUE(factor) << error;
  if (factor) result.factor = std::move(*factor);
  return result;
}

LaneArray random_lanes(std::size_t rows, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  LaneArray x(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    for (int lane = 0; lane < kLanes; ++lane) x.at(i, lane) = normal(random);
  }
  return x;
}

class LaneSolve : public ::testing::TestWithParam<std::tuple<Shape, int, double>> {
 protected:
  Body made = body(std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam()));
  std::size_t size = static_cast<std::size_t>(made.factor.size);
};

TEST_P(LaneSolve, EqualsTheSparseCholeskySolveInEveryLane) {
  const LaneArray b = random_lanes(size, 7);
  LaneArray x(size);
  for (std::size_t k = 0; k < size; ++k) x.put(k, b.get(static_cast<std::size_t>(made.factor.permutation[k])));
  solve_forward(made.factor, x.data());
  solve_backward(made.factor, x.data());
  for (int lane = 0; lane < kLanes; ++lane) {
    std::vector<double> right(size);
    for (std::size_t i = 0; i < size; ++i) right[i] = b.at(i, lane);
    const std::vector<double> expected = made.cholesky->solve(right);
    double scale = 0.0, worst = 0.0;
    for (double value : expected) scale = std::max(scale, std::abs(value));
    for (std::size_t k = 0; k < size; ++k) {
      worst = std::max(worst,
                       std::abs(x.at(k, lane) - expected[static_cast<std::size_t>(made.factor.permutation[k])]));
    }
    // Two backward stable solves differ by a small multiple of the condition number (up to 1e4 here) times 1e-16.
    EXPECT_LT(worst / scale, 1e-11) << "lane " << lane;
  }
}

TEST_P(LaneSolve, GivesEqualLanesEqualBits) {
  LaneArray x = random_lanes(size, 8);
  for (std::size_t i = 0; i < size; ++i) x.put(i, Lane(x.at(i, 0)));
  solve_forward(made.factor, x.data());
  solve_backward(made.factor, x.data());
  for (std::size_t i = 0; i < size; ++i) {
    for (int lane = 1; lane < kLanes; ++lane)
      ASSERT_EQ(x.at(i, lane), x.at(i, 0)) << "row " << i << " lane " << lane;
  }
}

TEST_P(LaneSolve, OnAReachEqualsTheFullSolveThere) {
  const std::vector<int> positions = {0, 1, 2, static_cast<int>(size) / 2, static_cast<int>(size) - 1};
  const std::vector<int> nodes = Reach(made.factor).of(positions);
  ASSERT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
  const std::set<int> touched(positions.begin(), positions.end());
  LaneArray full(size);
  const LaneArray b = random_lanes(size, 9);
  for (std::size_t k = 0; k < size; ++k) {
    if (touched.contains(static_cast<int>(k))) full.put(k, b.get(k));
  }
  LaneArray part = full;
  solve_forward(made.factor, full.data());
  solve_forward(made.factor, nodes, part.data());
  for (std::size_t k = 0; k < size; ++k) {
    for (int lane = 0; lane < kLanes; ++lane)
      ASSERT_EQ(part.at(k, lane), full.at(k, lane)) << "forward, row " << k;
  }
  solve_backward(made.factor, full.data());
  solve_backward(made.factor, nodes, part.data());
  std::set<int> covered;
  for (int s : nodes) {
    const Supernode& node = made.factor.supernode[static_cast<std::size_t>(s)];
    for (int c = node.first_column; c < node.first_column + node.column_count; ++c) {
      covered.insert(c);
      for (int lane = 0; lane < kLanes; ++lane) {
        ASSERT_EQ(part.at(static_cast<std::size_t>(c), lane), full.at(static_cast<std::size_t>(c), lane))
            << "backward, row " << c;
      }
    }
  }
  for (const int position : positions) EXPECT_TRUE(covered.contains(position)) << position;
}

SingleArray rounded(const LaneArray& x) {
  SingleArray single(x.rows());
  for (std::size_t i = 0; i < x.rows(); ++i) {
    for (int lane = 0; lane < kLanes; ++lane) single.row(i)[lane] = static_cast<float>(x.at(i, lane));
  }
  return single;
}

TEST_P(LaneSolve, InSinglePrecisionIsOffByItsRoundOff) {
  made.factor.round_values();
  LaneArray x = random_lanes(size, 10);
  SingleArray single = rounded(x);
  solve_forward(made.factor, x.data());
  solve_backward(made.factor, x.data());
  solve_forward(made.factor, single.data());
  solve_backward(made.factor, single.data());
  for (int lane = 0; lane < kLanes; ++lane) {
    double scale = 0.0, worst = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
      scale = std::max(scale, std::abs(x.at(i, lane)));
      worst = std::max(worst, std::abs(x.at(i, lane) - static_cast<double>(single.row(i)[lane])));
    }
    // As above: the condition number, up to 1e4 here, times 6e-8, which it comes nowhere near.
    EXPECT_LT(worst / scale, 6e-4) << "lane " << lane;
    EXPECT_GT(worst, 0.0) << "lane " << lane;
  }
}

TEST_P(LaneSolve, InSinglePrecisionALaneHasItsBitsWhateverIsBesideIt) {
  made.factor.round_values();
  const LaneArray b = random_lanes(size, 11);
  SingleArray all = rounded(b);
  solve_forward(made.factor, all.data());
  solve_backward(made.factor, all.data());
  for (const std::vector<int>& asked : {std::vector{0}, {7}, {8, 15}, {3, 12}}) {
    Mask busy(false);
    for (const int lane : asked) busy.set(lane, true);
    SingleArray some = rounded(b);
    solve_forward(made.factor, some.data(), busy);
    solve_backward(made.factor, some.data(), busy);
    for (std::size_t i = 0; i < size; ++i) {
      for (const int lane : asked)
        ASSERT_EQ(some.row(i)[lane], all.row(i)[lane]) << "row " << i << " lane " << lane;
    }
  }
}

TEST_P(LaneSolve, InSinglePrecisionOnAReachEqualsTheFullSolveThere) {
  made.factor.round_values();
  const std::vector<int> positions = {0, 1, static_cast<int>(size) / 3};
  const std::vector<int> nodes = Reach(made.factor).of(positions);
  LaneArray b(size);
  const LaneArray values = random_lanes(size, 12);
  for (const int position : positions) {
    b.put(static_cast<std::size_t>(position), values.get(static_cast<std::size_t>(position)));
  }
  SingleArray full = rounded(b), part = rounded(b);
  solve_forward(made.factor, full.data());
  solve_backward(made.factor, full.data());
  solve_forward(made.factor, nodes, part.data());
  solve_backward(made.factor, nodes, part.data());
  for (const int s : nodes) {
    const Supernode& node = made.factor.supernode[static_cast<std::size_t>(s)];
    for (int c = node.first_column; c < node.first_column + node.column_count; ++c) {
      const auto at = static_cast<std::size_t>(c);
      for (int lane = 0; lane < kLanes; ++lane) ASSERT_EQ(part.row(at)[lane], full.row(at)[lane]) << "row " << c;
    }
  }
}

TEST_P(LaneSolve, SupernodesHoldEveryEntryOfTheFactorOnce) {
  const CholeskyFactor L = made.cholesky->extract();
  EXPECT_EQ(made.factor.permutation, L.permutation);
  EXPECT_EQ(made.factor.entry_count, L.value.size());
  const double largest = *std::ranges::max_element(L.value);
  int next_column = 0;
  std::size_t nonzero = 0;
  for (const Supernode& s : made.factor.supernode) {
    EXPECT_EQ(s.first_column, next_column);
    next_column += s.column_count;
    // Unpack a supernode as a dense block [rows, columns]; diagonals are stored as reciprocals.
    const int height = s.column_count + s.row_count;
    std::vector<std::vector<double>> block(static_cast<std::size_t>(height),
                                           std::vector<double>(static_cast<std::size_t>(s.column_count), 0.0));
    // Panels of the diagonal block are as wide as their own last row.
    const auto unpack = [&](std::size_t offset, int first_row, int rows, bool triangle) {
      const double* from = made.factor.value.data() + offset;
      for (int first = 0; first < rows; first += kPanelRows) {
        const int panel = std::min(kPanelRows, rows - first);
        const int width = triangle ? first + panel : s.column_count;
        for (int c = 0; c < width; ++c) {
          for (int r = 0; r < panel; ++r) {
            block[static_cast<std::size_t>(first_row + first + r)][static_cast<std::size_t>(c)] =
                from[c * panel + r];
          }
        }
        from += static_cast<std::ptrdiff_t>(panel) * width;
      }
    };
    unpack(s.value_offset, 0, s.column_count, true);
    unpack(s.below_offset, s.column_count, s.row_count, false);
    for (int c = 0; c < s.column_count; ++c) {
      const auto column = static_cast<std::size_t>(s.first_column + c);
      std::map<int, double> expected;
      for (int p = L.column_start[column]; p < L.column_start[column + 1]; ++p) {
        expected[L.row[static_cast<std::size_t>(p)]] = L.value[static_cast<std::size_t>(p)];
      }
      for (int r = c; r < height; ++r) {
        const int row = r < s.column_count
                            ? s.first_column + r
                            : made.factor.row[s.row_offset + static_cast<std::size_t>(r - s.column_count)];
        double value = block[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
        if (r == c) value = 1.0 / value;
        const double wanted = expected.contains(row) ? expected[row] : 0.0;
        ASSERT_NEAR(value, wanted, 1e-13 * largest) << "L(" << row << ", " << column << ")";
        nonzero += expected.erase(row);
      }
      ASSERT_TRUE(expected.empty()) << "column " << column << " misses " << expected.size() << " entries";
    }
  }
  EXPECT_EQ(next_column, made.factor.size);
  EXPECT_EQ(nonzero, L.value.size());
}

INSTANTIATE_TEST_SUITE_P(Bodies, LaneSolve,
                         ::testing::Values(std::tuple(Shape::box, 2, 1e3), std::tuple(Shape::box, 5, 1e5),
                                           std::tuple(Shape::sphere, 6, 1e4),
                                           std::tuple(Shape::cylinder, 4, 1e6)));

TEST(LaneMatrix, ProductsEqualTheScalarOnesInEveryLane) {
  const Body made = body(Shape::sphere, 4, 1.0);
  const std::size_t rows = 3 * static_cast<std::size_t>(made.K.particle_count);
  const LaneArray x1 = random_lanes(rows, 3), x2 = random_lanes(rows, 4);
  LaneArray y(rows), y1(rows), y2(rows);
  multiply(made.K, x1, y);
  multiply_two(made.K, x1, x2, y1, y2);
  LaneArray y3(rows);
  Lane form(0.0);
  multiply_and_form(made.K, x1, x2, y3, form);
  for (int lane = 0; lane < kLanes; ++lane) {
    for (const auto& [x, product] :
         {std::pair(&x1, &y1), std::pair(&x2, &y2), std::pair(&x1, &y), std::pair(&x1, &y3)}) {
      std::vector<double> one(rows), expected(rows);
      for (std::size_t i = 0; i < rows; ++i) one[i] = x->at(i, lane);
      multiply(made.K, std::span<const double>(one), std::span<double>(expected));
      double scale = 0.0;
      for (double value : expected) scale = std::max(scale, std::abs(value));
      // Up to 81 products per row, fused here and rounded there.
      for (std::size_t i = 0; i < rows; ++i) ASSERT_NEAR(product->at(i, lane), expected[i], 1e-14 * scale);
    }
    double sum = 0.0, size = 0.0;
    for (std::size_t i = 0; i < rows; ++i) {
      sum += x2.at(i, lane) * y2.at(i, lane);
      size += std::abs(x2.at(i, lane) * y2.at(i, lane));
    }
    ASSERT_NEAR(form[lane], sum, 1e-14 * size);
  }
}

TEST(LaneMatrix, BlocksOfRowsAreSummedOverTheListedColumns) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  constexpr std::size_t kColumns = 6, kRows = 7;
  std::vector<double> blocks(9 * kColumns * kRows);
  for (double& value : blocks) value = normal(random);
  const LaneArray x = random_lanes(3 * kColumns, 6);
  const std::vector<int> columns = {0, 2, 5};
  using Sum = std::array<Lane, 3>;
  const Sum start = {Lane(1.0), Lane(2.0), Lane(3.0)};
  std::vector<const double*> rows;
  for (std::size_t r = 0; r < kRows; ++r) rows.push_back(blocks.data() + 9 * kColumns * r);
  std::vector<Sum> alone(kRows, start);
  for (std::size_t r = 0; r < kRows; ++r) {
    add_blocks({&rows[r], 1}, columns, x, BusyPacks(Mask(true)), {&alone[r], 1});
    for (int lane = 0; lane < kLanes; ++lane) {
      for (std::size_t i = 0; i < 3; ++i) {
        double expected = 1.0 + static_cast<double>(i);
        for (int j : columns) {
          for (std::size_t k = 0; k < 3; ++k) {
            const auto at = static_cast<std::size_t>(j);
            expected += rows[r][9 * at + 3 * i + k] * x.at(3 * at + k, lane);
          }
        }
        EXPECT_NEAR(alone[r][i][lane], expected, 1e-13);
      }
    }
  }
  // Beside others, a row has the same bits; lanes that are asked for by themselves, or beside some, as well.
  for (const std::vector<int>& asked : {std::vector{3}, {0, 6}, {5, 9}, {1, 15}}) {
    Mask busy(false);
    for (const int lane : asked) busy.set(lane, true);
    for (std::size_t count = 1; count <= kRows; ++count) {
      std::vector<Sum> some(count, start);
      add_blocks({rows.data(), count}, columns, x, BusyPacks(busy), some);
      for (std::size_t r = 0; r < count; ++r) {
        for (const int lane : asked) {
          for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(some[r][i][lane], alone[r][i][lane]) << count << " " << lane;
        }
      }
    }
  }
}

}  // namespace
}  // namespace unbruised
