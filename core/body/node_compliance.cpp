#include "core/body/node_compliance.hpp"

#include <algorithm>

#include "core/algebra/lane_solve.hpp"
#include "core/door/require.hpp"

namespace unbruised {
namespace {

/// A product with all columns may take as many multiplications as so many times the entries of the factor. A solve
/// for contact forces, which goes through nine tenths of them twice, is replaced by a product with those columns
/// that forces act on: a third to a half of what may be touched of a curved product, all of a flat one.
constexpr double kMostEntries = 2.5;

bool are_columns_worth_it(const SupernodalFactor& factor, std::size_t columns) {
  return !factor.single_value.empty() && static_cast<double>(columns) * static_cast<double>(factor.size) <=
                                             kMostEntries * static_cast<double>(factor.single_value.size());
}

}  // namespace

NodeCompliance node_compliance(const SupernodalFactor& factor, const std::vector<int>& slot,
                               const std::vector<int>& node) {
  const std::size_t m = node.size();
  require(m == 0 || 3 * static_cast<std::size_t>(node.back()) + 2 < slot.size(),
          "node_compliance: the body is not factored");
  NodeCompliance result;
  std::vector<int> positions;
  for (int particle : node) {
    for (int axis = 0; axis < 3; ++axis) {
      const int at = slot[3 * static_cast<std::size_t>(particle) + axis];
      if (at >= 0) positions.push_back(at);
    }
  }
  result.reach = Reach(factor).of(positions);
  result.block.assign(9 * m * m, 0.0);
  LaneArray x(static_cast<std::size_t>(factor.size));
  const std::size_t columns = 3 * m;
  const bool wants_columns = are_columns_worth_it(factor, columns);
  if (wants_columns) result.columns = SingleMatrix(x.rows(), columns);
  for (std::size_t first = 0; first < columns; first += kLanes) {
    x.fill(0.0);
    const std::size_t count = std::min<std::size_t>(kLanes, columns - first);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t column = first + k;
      const int at = slot[3 * static_cast<std::size_t>(node[column / 3]) + column % 3];
      if (at >= 0) x.at(static_cast<std::size_t>(at), static_cast<int>(k)) = 1.0;
    }
    solve_forward(factor, result.reach, x.data());
    if (wants_columns) {
      solve_backward(factor, x.data());
      result.columns.put_columns(first, count, x);
    } else {
      solve_backward(factor, result.reach, x.data());
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t column = first + k;
      for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const int at = slot[3 * static_cast<std::size_t>(node[i]) + axis];
          const double value = at >= 0 ? x.at(static_cast<std::size_t>(at), static_cast<int>(k)) : 0.0;
          result.block[9 * (i * m + column / 3) + 3 * axis + column % 3] = value;
        }
      }
    }
  }
  return result;
}

}  // namespace unbruised
