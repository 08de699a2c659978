// From triangles to a closed mesh: what is joined, and what is refused in which sentence.

#include "core/scenario/mesh_fault.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/core/scenario/meshes.hpp"

namespace unbruised {
namespace {

using namespace testing;

std::string fault_of(const TriangleMesh& mesh) { return mesh_fault(mesh).value_or(""); }

/// With every corner of every triangle written again, as STL files do.
TriangleMesh torn(const TriangleMesh& mesh) {
  TriangleMesh torn;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const int first = static_cast<int>(torn.place.size());
    for (std::size_t k = 0; k < 3; ++k) torn.place.push_back(mesh.corner(t, k));
    torn.triangle.push_back({first, first + 1, first + 2});
  }
  return torn;
}

TriangleMesh both(TriangleMesh one, const TriangleMesh& other) {
  const int first = static_cast<int>(one.place.size());
  one.place.insert(one.place.end(), other.place.begin(), other.place.end());
  for (const auto& [a, b, c] : other.triangle) one.triangle.push_back({first + a, first + b, first + c});
  return one;
}

TEST(MeshFault, IsNoneForClosedMeshes) {
  for (const TriangleMesh& mesh : {icosphere(0), icosphere(3), cube_mesh(), lobed_mesh(3)}) {
    EXPECT_EQ(fault_of(mesh), "");
  }
}

TEST(Welded, JoinsWhatStlTearsApartAndLeavesOutWhatIsNoTriangle) {
  const TriangleMesh mesh = icosphere(2);
  EXPECT_NE(fault_of(torn(mesh)), "");
  TriangleMesh loose = torn(mesh);
  for (std::size_t p = 0; p < loose.place.size(); ++p) {
    loose.place[p][p % 3] += (p % 2 == 0 ? 1.0 : -1.0) * 2e-7;  // a tenth of what is the same, of an extent of 2
  }
  loose.triangle.push_back({0, 0, 1});
  loose.place.push_back({7.0, 7.0, 7.0});  // belongs to nothing
  const TriangleMesh joined = welded(loose);
  EXPECT_EQ(joined.place.size(), mesh.place.size());
  EXPECT_EQ(joined.triangle.size(), mesh.triangle.size());
  EXPECT_EQ(fault_of(joined), "");
}

TEST(MeshFault, SaysWhereAHoleIs) {
  TriangleMesh mesh = cube_mesh();
  mesh.triangle.pop_back();  // corners 1, 7, 5
  EXPECT_EQ(fault_of(mesh),
            "has a hole at (1, 0, 1): 3 edges belong to one triangle only; close it in the program that made "
            "it");
}

TEST(MeshFault, SaysWhereFacesAreInverted) {
  TriangleMesh mesh = cube_mesh();
  std::swap(mesh.triangle[0][1], mesh.triangle[0][2]);
  EXPECT_NE(fault_of(mesh).find("has faces that look inward beside faces that look outward, at ("),
            std::string::npos)
      << fault_of(mesh);
  TriangleMesh inside_out = icosphere(2);
  for (auto& triangle : inside_out.triangle) std::swap(triangle[1], triangle[2]);
  EXPECT_EQ(fault_of(inside_out),
            "is inside out: all its faces look inward; turn them over in the program that made it");
}

TEST(MeshFault, SaysWhereItPassesThroughItself) {
  // The spike of one place goes out through the other side.
  TriangleMesh mesh = icosphere(2);
  for (double& x : mesh.place[0]) x *= -1.6;
  EXPECT_NE(fault_of(mesh).find("passes through itself near ("), std::string::npos) << fault_of(mesh);
  // As deep as a thousandth of the body, too.
  TriangleMesh dent = icosphere(3);
  const auto farthest = std::ranges::max_element(dent.place, {}, [](const auto& p) { return p[2]; });
  (*farthest)[2] = -1.001;
  EXPECT_NE(fault_of(dent).find("passes through itself"), std::string::npos) << fault_of(dent);
}

TEST(MeshFault, RefusesSeveralBodiesAndHollows) {
  const auto away = [](const std::array<double, 3>& p) { return std::array{p[0] + 5.0, p[1], p[2]}; };
  EXPECT_NE(
      fault_of(both(icosphere(1), moved(icosphere(1), away))).find("has 2 surfaces that do not hang together"),
      std::string::npos);
  const auto half = [](const std::array<double, 3>& p) { return std::array{-0.5 * p[0], 0.5 * p[1], 0.5 * p[2]}; };
  EXPECT_NE(fault_of(both(icosphere(1), moved(icosphere(1), half))).find("without hollows"), std::string::npos);
}

TEST(MeshFault, RefusesWhatIsNoBody) {
  EXPECT_EQ(fault_of({}), "has no triangles");
  TriangleMesh flat = moved(cube_mesh(), [](const std::array<double, 3>& p) {
    return std::array{p[0], p[1], 0.0};
  });
  EXPECT_EQ(fault_of(flat), "encloses no volume");
  TriangleMesh fin = cube_mesh();
  fin.place.push_back({0.0, 0.0, 3.0});
  fin.triangle.push_back({4, 5, 8});
  EXPECT_NE(fault_of(fin).find("more than two triangles meet at the edge near (0, -1, 1)"), std::string::npos)
      << fault_of(fin);
  TriangleMesh many;
  many.place = cube_mesh().place;
  many.triangle.assign(kMostTriangles + 1, {0, 1, 2});
  EXPECT_NE(fault_of(many).find("has 200001 triangles, more than 200000"), std::string::npos);
}

// Whatever is done to a mesh, it is refused in a sentence, or is a body that can be asked.
TEST(MeshFault, IsASentenceOrTheMeshIsABody) {
  std::mt19937 random(17);
  int sound = 0;
  for (int round = 0; round < 24; ++round) {
    TriangleMesh mesh = round % 2 == 0 ? icosphere(1) : cube_mesh();
    const auto any = [&](std::size_t count) { return random() % count; };
    for (std::size_t changes = 1 + any(3); changes > 0; --changes) {
      auto& triangle = mesh.triangle[any(mesh.triangle.size())];
      auto& place = mesh.place[any(mesh.place.size())];
      switch (any(5)) {
        case 0:
          std::swap(triangle[0], triangle[2]);
          break;
        case 1:
          triangle[any(3)] = static_cast<int>(any(mesh.place.size()));
          break;
        case 2:
          place = mesh.place[any(mesh.place.size())];
          break;
        case 3:
          for (double& x : place) x *= 0.8;
          break;
        default:
          place[any(3)] *= -1.3;
          break;
      }
    }
    const TriangleMesh joined = welded(mesh);
    const auto fault = mesh_fault(joined);
    if (fault) {
      EXPECT_GT(fault->size(), 10U);
      continue;
    }
    ++sound;
    const ProductMesh body(joined, {});
    EXPECT_GT(body.volume(), 0.0);
    for (std::size_t side = 0; side < 6; ++side) {
      EXPECT_GT(body.section(side / 2), 0.0);
      for (const double curvature : body.pole(side).curvature) EXPECT_GE(curvature, 0.0);
    }
  }
  EXPECT_GT(sound, 3);
}

}  // namespace
}  // namespace unbruised
