#pragma once

/// @file
/// A tree of boxes over triangles: those near a place, on a line or in a box are found without a look at the
/// others. Built by halving along the longest extent; alike for alike meshes.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/scenario/triangle_mesh.hpp"

namespace unbruised {

class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& mesh);

  /// Calls visit(triangle) for the triangles of every leaf whose box, as those of all nodes above it, is wanted.
  template <class Wanted, class Visit>
  void visit(const Wanted& wanted, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<int, kDepth> open{};
    for (int count = 1; count > 0;) {
      const Node& node = nodes_[static_cast<std::size_t>(open[static_cast<std::size_t>(--count)])];
      if (!wanted(node.box)) continue;
      if (node.count == 0) {
        open[static_cast<std::size_t>(count++)] = node.first + 1;
        open[static_cast<std::size_t>(count++)] = node.first;
        continue;
      }
      for (int i = 0; i < node.count; ++i) visit(order_[static_cast<std::size_t>(node.first + i)]);
    }
  }

  /// The same from near to far: cost(box) is no more than that of any triangle in it, and boxes that cost as much
  /// as best() are left out.
  template <class Cost, class Best, class Visit>
  void visit_from_least(const Cost& cost, const Best& best, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<int, kDepth> open{};
    std::array<double, kDepth> costs{};
    std::size_t count = 1;
    costs[0] = cost(nodes_[0].box);
    while (count > 0) {
      --count;
      if (costs[count] >= best()) continue;
      const Node& node = nodes_[static_cast<std::size_t>(open[count])];
      for (int i = 0; i < node.count; ++i) visit(order_[static_cast<std::size_t>(node.first + i)]);
      if (node.count > 0) continue;
      std::array<double, 2> of_child{};
      for (std::size_t c = 0; c < 2; ++c) of_child[c] = cost(nodes_[static_cast<std::size_t>(node.first) + c].box);
      const std::size_t near = of_child[1] < of_child[0] ? 1 : 0;
      for (const std::size_t c : {1 - near, near}) {
        open[count] = node.first + static_cast<int>(c);
        costs[count++] = of_child[c];
      }
    }
  }

 private:
  /// Halving ends long before: 2^31 triangles are 31 levels, of which each leaves one node open.
  static constexpr std::size_t kDepth = 64;

  struct Node {
    Bounds box;
    int first = 0;  ///< of its triangles in the order, or the first of its two children
    int count = 0;  ///< 0: it has children
  };

  void build(const TriangleMesh& mesh, std::size_t node, int first, int count);

  std::vector<Node> nodes_;
  std::vector<int> order_;
};

}  // namespace unbruised
