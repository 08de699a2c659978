#pragma once

/// @file
/// Closed meshes for tests, made by rules.

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "core/scenario/product_mesh.hpp"
#include "core/scenario/scenario.hpp"

namespace unbruised::testing {

/// A sphere of radius 1: an icosahedron whose triangles are divided in four some times, 20 x 4^divisions of them.
inline TriangleMesh icosphere(int divisions) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  TriangleMesh mesh;
  const auto add = [&mesh](std::array<double, 3> place) {
    const double size = std::hypot(place[0], place[1], place[2]);
    for (double& x : place) x /= size;
    mesh.place.push_back(place);
    return static_cast<int>(mesh.place.size()) - 1;
  };
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-g, g}) add({0.0, a, b}), add({a, b, 0.0}), add({b, 0.0, a});
  }
  const auto distance = [&mesh](int i, int j) {
    double square = 0.0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double way = mesh.place[static_cast<std::size_t>(i)][d] - mesh.place[static_cast<std::size_t>(j)][d];
      square += way * way;
    }
    return std::sqrt(square);
  };
  const double edge = 2.0 / std::hypot(1.0, g);
  const auto is_edge = [&](int i, int j) { return std::abs(distance(i, j) - edge) < 1e-9; };
  for (int i = 0; i < 12; ++i) {
    for (int j = i + 1; j < 12; ++j) {
      for (int k = j + 1; k < 12; ++k) {
        if (!is_edge(i, j) || !is_edge(j, k) || !is_edge(k, i)) continue;
        const auto& a = mesh.place[static_cast<std::size_t>(i)];
        const auto& b = mesh.place[static_cast<std::size_t>(j)];
        const auto& c = mesh.place[static_cast<std::size_t>(k)];
        const double turn = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                            a[2] * (b[0] * c[1] - b[1] * c[0]);
        mesh.triangle.push_back(turn > 0.0 ? std::array{i, j, k} : std::array{i, k, j});
      }
    }
  }
  for (int round = 0; round < divisions; ++round) {
    std::map<std::pair<int, int>, int> middle;
    const auto middle_of = [&](int i, int j) {
      const auto [at, is_new] = middle.try_emplace(std::minmax(i, j), 0);
      if (is_new) {
        const auto a = mesh.place[static_cast<std::size_t>(i)], b = mesh.place[static_cast<std::size_t>(j)];
        at->second = add({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
      }
      return at->second;
    };
    std::vector<std::array<int, 3>> triangle;
    for (const auto& [a, b, c] : mesh.triangle) {
      const int ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
      for (const std::array<int, 3>& part :
           {std::array{a, ab, ca}, std::array{b, bc, ab}, std::array{c, ca, bc}, std::array{ab, bc, ca}}) {
        triangle.push_back(part);
      }
    }
    mesh.triangle = std::move(triangle);
  }
  return mesh;
}

/// From -1 to 1 along each axis: 12 triangles.
inline TriangleMesh cube_mesh() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.place.push_back({i % 2 * 2.0 - 1.0, i / 2 % 2 * 2.0 - 1.0, i / 4 * 2.0 - 1.0});
  for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                   std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    mesh.triangle.push_back({a, b, c});
    mesh.triangle.push_back({a, c, d});
  }
  return mesh;
}

/// Every place sent through a function.
template <class To>
TriangleMesh moved(TriangleMesh mesh, const To& to) {
  for (auto& place : mesh.place) place = to(place);
  return mesh;
}

/// Two lobes beside each other and a waist between them, lopsided along all axes: neither convex nor mirrored.
inline TriangleMesh lobed_mesh(int divisions) {
  return moved(icosphere(divisions), [](const std::array<double, 3>& p) {
    const double waist = 1.0 + 0.35 * (p[0] * p[0] - 1.0 / 3.0) * (1.0 + 0.3 * p[0]) + 0.1 * p[1] * p[2];
    return std::array{1.4 * waist * p[0] + 0.2 * p[2], waist * p[1], waist * p[2] * (1.0 + 0.2 * p[1])};
  });
}

inline LatticeParameters mesh_product(TriangleMesh mesh, const std::array<double, 3>& size_m,
                                      std::uint64_t hash = 1) {
  LatticeParameters product;
  product.shape = Shape::mesh;
  product.size_m = size_m;
  product.mass_kg = 0.1;
  product.mesh = std::make_shared<const ProductMesh>(std::move(mesh), MeshSource{hash, "part.stl", "mm"});
  return product;
}

}  // namespace unbruised::testing
