#include "core/scenario/triangle_tree.hpp"

#include <limits>
#include <numeric>

namespace unbruised {
namespace {

constexpr int kLeaf = 4;

void widen(Bounds& box, const std::array<double, 3>& place) {
  for (std::size_t d = 0; d < 3; ++d) {
    box.low[d] = std::min(box.low[d], place[d]);
    box.high[d] = std::max(box.high[d], place[d]);
  }
}

Bounds nothing() {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  return {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
}

}  // namespace

Bounds bounds_of(const std::vector<std::array<double, 3>>& places) {
  Bounds box = nothing();
  for (const auto& place : places) widen(box, place);
  return box;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : order_(mesh.triangle.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (order_.empty()) return;
  nodes_.emplace_back();
  build(mesh, 0, 0, static_cast<int>(order_.size()));
}

void TriangleTree::build(const TriangleMesh& mesh, std::size_t node, int first, int count) {
  const auto middle_of = [&mesh](int t, std::size_t d) {
    const auto i = static_cast<std::size_t>(t);
    return mesh.corner(i, 0)[d] + mesh.corner(i, 1)[d] + mesh.corner(i, 2)[d];
  };
  Bounds box = nothing(), middles = nothing();
  for (int i = first; i < first + count; ++i) {
    const int t = order_[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < 3; ++k) widen(box, mesh.corner(static_cast<std::size_t>(t), k));
    widen(middles, {middle_of(t, 0), middle_of(t, 1), middle_of(t, 2)});
  }
  nodes_[node].box = box;
  if (count <= kLeaf) {
    nodes_[node].first = first;
    nodes_[node].count = count;
    return;
  }
  std::size_t axis = 0;
  for (std::size_t d = 1; d < 3; ++d) {
    if (middles.high[d] - middles.low[d] > middles.high[axis] - middles.low[axis]) axis = d;
  }
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](int a, int b) {
    const double at_a = middle_of(a, axis), at_b = middle_of(b, axis);
    return at_a != at_b ? at_a < at_b : a < b;  // ties by number: the halves do not depend on the library
  });
  const auto child = static_cast<int>(nodes_.size());
  nodes_[node].first = child;
  nodes_.resize(nodes_.size() + 2);
  build(mesh, static_cast<std::size_t>(child), first, count / 2);
  build(mesh, static_cast<std::size_t>(child) + 1, first + count / 2, count - count / 2);
}

}  // namespace unbruised
