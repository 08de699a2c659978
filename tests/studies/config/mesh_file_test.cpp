// Meshes of files: each kind is read alike, and what is no mesh of a product is refused in one sentence.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/scenario/product.hpp"
#include "core/scenario/true_shape.hpp"
#include "studies/config/mesh_reader.hpp"
#include "studies/config/study.hpp"
#include "tests/core/scenario/meshes.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;
using namespace unbruised::testing;

/// Metres of the unit that the files are in: a ball of 50 units.
TriangleMesh ball() {
  return moved(icosphere(3), [](const std::array<double, 3>& p) {
    return std::array{25 * p[0], 25 * p[1], 25 * p[2]};
  });
}

std::string ascii_stl(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << "solid part\n";
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    out << "facet normal 0 0 0\n outer loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      out << "  vertex " << mesh.corner(t, k)[0] << " " << mesh.corner(t, k)[1] << " " << mesh.corner(t, k)[2]
          << "\n";
    }
    out << " endloop\nendfacet\n";
  }
  out << "endsolid part\n";
  return out.str();
}

std::string binary_stl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto put = [&bytes](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(static_cast<std::uint32_t>(mesh.triangle.size()));
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    for (int i = 0; i < 3; ++i) put(0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double x : mesh.corner(t, k)) put(static_cast<float>(x));
    }
    put(std::uint16_t{0});
  }
  return bytes;
}

std::string obj(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << "mtllib ../../../etc/passwd\n";  // names another file, which is not opened
  for (const auto& p : mesh.place) out << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
  for (const auto& t : mesh.triangle) out << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  return out.str();
}

std::string ply(const TriangleMesh& mesh) {
  std::ostringstream out;
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.place.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangle.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& p : mesh.place) out << p[0] << " " << p[1] << " " << p[2] << "\n";
  for (const auto& t : mesh.triangle) out << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  return out.str();
}

class MeshFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }
  [[nodiscard]] StudyOrError read(const std::string& product) const {
    write("study.toml",
          "[study]\nname = \"part\"\nkind = \"simulate\"\n\n[product]\nshape = \"mesh\"\nmass_kg = 0.06\n"
          "youngs_modulus_Pa = 1e6\ncell_size_m = 0.01\n" +
              product + "\n[simulation]\nduration_s = 0.01\n");
    return read_study(folder_ / "study.toml", {}, folder_ / "configs");
  }
  /// The one line that refuses it, without its place.
  [[nodiscard]] std::string refusal(const std::string& product) const {
    const auto study = read(product);
    if (study) return "";
    const auto& lines = study.error().messages;
    EXPECT_EQ(lines.size(), 1U);
    for (const std::string& line : lines) {
      EXPECT_TRUE(line.find("study.toml:") != std::string::npos) << line;
      if (const auto at = line.find("product."); at != std::string::npos) return line.substr(at);
    }
    return lines.empty() ? "no line" : lines.front();
  }
  [[nodiscard]] std::string refusal_of(const std::string& name, const std::string& content) const {
    write(name, content);
    return refusal("mesh_file = \"" + name + "\"\nmesh_unit = \"mm\"");
  }

  fs::path folder_ = fs::temp_directory_path() / ("unbruised_mesh_" + std::to_string(::getpid()) + "_" +
                                                  ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(MeshFile, OfEveryKindGivesTheSameProduct) {
  write("a.stl", ascii_stl(ball()));
  write("b.stl", binary_stl(ball()));
  write("c.obj", obj(ball()));
  write("d.ply", ply(ball()));
  write("E.STL", binary_stl(ball()));
  for (const char* name : {"a.stl", "b.stl", "c.obj", "d.ply", "E.STL"}) {
    const auto study = read(std::string("mesh_file = \"") + name + "\"\nmesh_unit = \"mm\"");
    ASSERT_TRUE(study) << name << ": " << study.error().messages.front();
    const auto product = std::get<LatticeParameters>(study->scenario(0).product);
    for (const double size : product.size_m) EXPECT_NEAR(size, 0.05, 1e-5) << name;
    EXPECT_NEAR(TrueShape(product).volume_m3() / (4.0 / 3.0 * std::numbers::pi * std::pow(0.025, 3)), 1.0, 1e-3);
  }
}

TEST_F(MeshFile, GoesIntoTheResolvedConfigByNameUnitAndHash) {
  write("ball.stl", binary_stl(ball()));
  const auto study = read("mesh_file = \"ball.stl\"\nmesh_unit = \"mm\"");
  ASSERT_TRUE(study) << study.error().messages.front();
  const std::string& resolved = study->resolved_toml();
  EXPECT_NE(resolved.find("mesh_hash = \""), std::string::npos);
  // From anywhere, without the folder it was in.
  fs::create_directories(folder_ / "elsewhere");
  write("elsewhere/config.toml", resolved);
  const auto again = read_study(folder_ / "elsewhere" / "config.toml", {}, folder_ / "configs");
  ASSERT_TRUE(again) << again.error().messages.front();
  EXPECT_EQ(again->resolved_toml(), resolved);
  // The file changes in one bit that moves nothing: it is another file all the same.
  std::string changed = binary_stl(ball());
  changed[3] = 'x';
  write("ball.stl", changed);
  const auto refused = read_study(folder_ / "elsewhere" / "config.toml", {}, folder_ / "configs");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().messages.front().find("product.mesh_hash"), std::string::npos)
      << refused.error().messages.front();
  EXPECT_NE(refused.error().messages.front().find("the file has changed"), std::string::npos);
  const auto other = read("mesh_file = \"ball.stl\"\nmesh_unit = \"mm\"");
  ASSERT_TRUE(other);
  EXPECT_NE(other->resolved_toml(), resolved);  // by which a run that is resumed is refused
}

TEST_F(MeshFile, IsStretchedToASizeThatIsGiven) {
  write("ball.ply", ply(ball()));
  const auto study = read("mesh_file = \"ball.ply\"\nmesh_unit = \"mm\"\nsize_m = [0.04, 0.05, 0.06]");
  ASSERT_TRUE(study) << study.error().messages.front();
  const auto product = std::get<LatticeParameters>(study->scenario(0).product);
  EXPECT_EQ(product.size_m, (std::array{0.04, 0.05, 0.06}));
  EXPECT_NEAR(TrueShape(product).reach_m({0.0, 0.0, 1.0}), 0.03, 1e-12);
}

TEST_F(MeshFile, AsksForTheUnit) {
  write("ball.stl", binary_stl(ball()));
  EXPECT_EQ(
      refusal("mesh_file = \"ball.stl\""),
      "product.mesh_unit: missing: say in which unit the file's 50 x 50 x 50 units are; \"mm\" or \"cm\" make a "
      "product of it");
  EXPECT_EQ(
      refusal("mesh_file = \"ball.stl\"\nmesh_unit = \"m\""),
      "product.mesh_unit = \"m\": makes the mesh 50 x 50 x 50 m large, and a product is 1 mm to 1 m long; \"mm\" "
      "or \"cm\" make a product of it");
  EXPECT_EQ(refusal("mesh_file = \"ball.stl\"\nmesh_unit = \"furlong\""),
            "product.mesh_unit = \"furlong\": must be \"mm\", \"cm\", \"m\" or \"in\"");
  EXPECT_EQ(
      refusal("mesh_file = \"ball.stl\"\nmesh_unit = \"mm\"\nmesh_hash = \"0123456789abcdef\"").substr(0, 64),
      "product.mesh_hash = \"0123456789abcdef\": is not the hash of ball.");
}

TEST_F(MeshFile, ThatIsNoMeshIsRefusedInOneSentence) {
  const auto starts = [](const std::string& line, const std::string& start) {
    EXPECT_EQ(line.substr(0, start.size()), start);
  };
  starts(refusal_of("empty.stl", ""), "product.mesh_file = \"empty.stl\": is empty");
  starts(refusal_of("part.step", "ISO-10303-21;"),
         "product.mesh_file = \"part.step\": is no mesh that is read: its name must end in .stl, .obj or .ply");
  starts(refusal_of("text.stl", "a letter to a friend\n"),
         "product.mesh_file = \"text.stl\": cannot be read as a mesh");
  starts(refusal_of("text.ply", "a letter to a friend\n"),
         "product.mesh_file = \"text.ply\": cannot be read as a mesh");
  starts(refusal_of("text.obj", "a letter to a friend\n"), "product.mesh_file = \"text.obj\": ");
  const std::string whole = binary_stl(ball());
  starts(refusal_of("cut.stl", whole.substr(0, whole.size() / 2)), "product.mesh_file = \"cut.stl\": ");
  const std::string text = ply(ball());
  starts(refusal_of("cut.ply", text.substr(0, text.size() / 2)), "product.mesh_file = \"cut.ply\": ");
  starts(refusal_of("lie.ply",
                    "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty double x\n"
                    "property double y\nproperty double z\nend_header\n"),
         "product.mesh_file = \"lie.ply\": ");
  starts(refusal_of("nan.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
         "product.mesh_file = \"nan.obj\": ");
  starts(refusal("mesh_file = \"nobody.stl\"\nmesh_unit = \"mm\""),
         "product.mesh_file = \"nobody.stl\": no such file");
}

TEST_F(MeshFile, WithAFaultSaysWhereItIs) {
  TriangleMesh open = ball();
  open.triangle.pop_back();
  write("open.stl", binary_stl(open));
  EXPECT_NE(refusal("mesh_file = \"open.stl\"\nmesh_unit = \"mm\"").find("has a hole at ("), std::string::npos);
  TriangleMesh inside_out = ball();
  for (auto& t : inside_out.triangle) std::swap(t[0], t[1]);
  write("in.ply", ply(inside_out));
  EXPECT_NE(refusal("mesh_file = \"in.ply\"\nmesh_unit = \"mm\"").find("is inside out"), std::string::npos);
}

TEST_F(MeshFile, IsAskedForByTheShapeAndByItAlone) {
  write("ball.stl", binary_stl(ball()));
  EXPECT_EQ(refusal(""), "product.mesh_file: missing; product.shape = \"mesh\" needs it, and product.mesh_unit");
  const auto study = read("mesh_file = \"ball.stl\"\nmesh_unit = \"mm\"");
  ASSERT_TRUE(study);
  write("box.toml",
        "[study]\nname = \"part\"\nkind = \"simulate\"\n\n[product]\nshape = \"box\"\nmass_kg = 0.06\n"
        "youngs_modulus_Pa = 1e6\nsize_m = [0.05, 0.05, 0.05]\nmesh_file = \"ball.stl\"\nmesh_unit = "
        "\"mm\"\n\n[simulation]\nduration_s = 0.01\n");
  const auto box = read_study(folder_ / "box.toml", {}, folder_ / "configs");
  ASSERT_FALSE(box);
  EXPECT_NE(box.error().messages.front().find("only a product with shape = \"mesh\" has it"), std::string::npos);
  // A unit from the command line, the file in the product's file.
  write("part.toml",
        "shape = \"mesh\"\nmass_kg = 0.06\nyoungs_modulus_Pa = 1e6\nmesh_file = \"ball.stl\"\nmesh_unit = "
        "\"mm\"\n");
  write("use.toml",
        "[study]\nname = \"part\"\nkind = \"simulate\"\n\n[product]\nuse = \"part.toml\"\n\n"
        "[simulation]\nduration_s = 0.01\n");
  EXPECT_TRUE(read_study(folder_ / "use.toml", {}, folder_ / "configs"));
  const auto set = read_study(folder_ / "use.toml", {"product.mesh_unit=cm"}, folder_ / "configs");
  ASSERT_FALSE(set);
  EXPECT_NE(set.error().messages.front().find("belongs beside product.mesh_file"), std::string::npos);
}

// What the reader does with bytes that were changed at random ends in a mesh or in a sentence, never here.
TEST_F(MeshFile, SurvivesChangedBytes) {
  const TriangleMesh small = icosphere(1);
  std::uint32_t state = 12345;
  const auto next = [&state] { return state = state * 1664525U + 1013904223U; };
  for (const auto& [ending, whole] : {std::pair{"stl", binary_stl(small)}, std::pair{"stl", ascii_stl(small)},
                                      std::pair{"obj", obj(small)}, std::pair{"ply", ply(small)}}) {
    for (int round = 0; round < 6; ++round) {
      std::string bytes = whole;
      for (int i = 0; i < 6; ++i) bytes[next() % bytes.size()] = static_cast<char>(next() >> 24);
      if (round % 3 == 0) bytes.resize(next() % bytes.size());
      const auto read = read_triangles(bytes, ending);
      EXPECT_TRUE(read || !read.error().empty());
    }
  }
}

}  // namespace
}  // namespace unbruised::studies
