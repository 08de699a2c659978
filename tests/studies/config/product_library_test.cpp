// The products that ship: each is read, is as heavy as such things are, and names the source of its values.

#include <algorithm>
#include <filesystem>

#include "core/scenario/lattice_cells.hpp"
#include "studies/config/sources.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> products() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(testing::config_root() + "/products"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Gripped between pads; whether that harms it is not asked.
StudyOrError gripped(const fs::path& file) {
  const std::string study =
      "[study]\nname = \"t\"\nkind = \"window\"\n[window]\nfrom_N = 0.2\nto_N = 5.0\n[product]\nuse = "
      "\"products/" +
      file.filename().string() +
      "\"\n[gripper]\nuse = \"grippers/parallel_jaw.toml\"\n[limits]\ndamage = \"not considered\"\n";
  return read_study_text(study, "t.toml", {}, ".", testing::config_root());
}

TEST(ProductLibrary, HasAtLeastTwentyFourProducts) { EXPECT_GE(products().size(), 24U); }

TEST(ProductLibrary, IsReadAndAsHeavyAsSuchThingsAre) {
  for (const fs::path& file : products()) {
    const StudyOrError study = gripped(file);
    ASSERT_TRUE(study) << file << ": " << study.error().messages.front();
    const Scenario scenario = study->scenario(0);
    const auto& product = std::get<LatticeParameters>(scenario.product);
    const double density = product.mass_kg ? *product.mass_kg / true_volume_m3(product) : *product.density_kg_m3;
    EXPECT_GT(density, 250.0) << file << ": less than bread";
    EXPECT_LT(density, 1300.0) << file;
    EXPECT_LT(product.cell_size_m, 0.35 * *std::min_element(product.size_m.begin(), product.size_m.end())) << file;
    // Whatever is yielded to is less than the modulus, and what follows is softer.
    if (!product.yield_stress_Pa) continue;
    EXPECT_LT(*product.yield_stress_Pa, product.youngs_modulus_Pa) << file;
    EXPECT_LT(*product.tangent_modulus_Pa, product.youngs_modulus_Pa) << file;
  }
}

TEST(ProductLibrary, SaysWhereEachValueComesFrom) {
  for (const fs::path& file : products()) {
    const StudyOrError study = gripped(file);
    ASSERT_TRUE(study) << file;
    for (const ValueSource& value : config_sources(study->resolved_toml()).values) {
      if (!value.key.starts_with("product.")) continue;
      EXPECT_NE(value.standing, Standing::unsourced) << file << ": " << value.key;
      if (!value.source.starts_with("from memory")) continue;
      EXPECT_EQ(value.standing, Standing::assumed) << file << ": " << value.key;
    }
  }
}

}  // namespace
}  // namespace unbruised::studies
