// Random keys that vary together: [[correlation]] blocks and data of files, as they are read.

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "studies/config/library.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::study_of;

const std::string kFriction = "product.friction";
const std::string kModulus = "product.youngs_modulus_Pa";

/// A folder with a file of data.
class JointKeys : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("unbruised_joint_keys_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& text) const { std::ofstream(folder_ / "fruit.csv") << text; }

  [[nodiscard]] StudyOrError read(const std::string& text) const {
    return read_study_text(text, "study.toml", {}, folder_, testing::config_root());
  }

  /// The lines of what is wrong, without the folder.
  [[nodiscard]] std::vector<std::string> said_of(const std::string& text) const {
    const StudyOrError result = read(text);
    std::vector<std::string> lines = result ? std::vector<std::string>{} : result.error().messages;
    for (std::string& line : lines) {
      const std::string folder = folder_.string() + "/";
      if (const std::size_t at = line.find(folder); at != std::string::npos) line.erase(at, folder.size());
    }
    return lines;
  }

  static std::string drawn(const std::string& key, const std::string& column) {
    return "[[random]]\nkey = \"" + key + "\"\ndistribution = \"data\"\nfile = \"fruit.csv\"\ncolumn = \"" +
           column + "\"\n";
  }

  std::filesystem::path folder_;
};

TEST_F(JointKeys, OfOneFileShareItsRows) {
  write("# measured\nE_Pa,mu\n1e6,0.5\n2e6,0.4\n3e6,0.6\n");
  const StudyOrError result = read(gripped_block("sample") + drawn(kModulus, "E_Pa") + drawn(kFriction, "mu"));
  ASSERT_TRUE(result) << result.error().messages[0];
  const std::vector<RandomVariable>& randoms = result->randoms();
  ASSERT_EQ(randoms.size(), 2U);
  EXPECT_EQ(randoms[0].rows, (std::vector<double>{1e6, 2e6, 3e6}));
  EXPECT_EQ(randoms[1].rows, (std::vector<double>{0.5, 0.4, 0.6}));
  EXPECT_EQ(randoms[1].distribution.values, (std::vector<double>{0.4, 0.5, 0.6}));
  EXPECT_EQ(randoms[0].zip, "fruit.csv");
  EXPECT_EQ(randoms[1].zip, "fruit.csv");
}

TEST_F(JointKeys, AreWholeInTheResolvedTextWithoutTheFile) {
  write("E_Pa,mu\n1e6,0.5\n2e6,0.4\n3e6,0.6\n");
  const std::string text =
      gripped_block("sample") + drawn(kModulus, "E_Pa") + drawn(kFriction, "mu") +
      "[[random]]\nkey = \"product.mass_kg\"\ndistribution = \"uniform\"\nfrom = 0.1\nto = 0.2\n"
      "[[random]]\nkey = \"strategy.grip_force_N\"\nrelative = 0.1\n"
      "[[correlation]]\nbetween = [\"product.mass_kg\", \"strategy.grip_force_N\"]\nvalue = -0.3\n";
  const StudyOrError first = read(text);
  ASSERT_TRUE(first) << first.error().messages[0];
  const StudyOrError second = read_study_text(first->resolved_toml(), "resolved", {}, "", "");
  ASSERT_TRUE(second) << second.error().messages[0];
  EXPECT_EQ(second->resolved_toml(), first->resolved_toml());
  EXPECT_EQ(second->randoms()[0].rows, first->randoms()[0].rows);
  EXPECT_EQ(second->randoms()[0].zip, first->randoms()[0].zip);
  ASSERT_EQ(second->correlations().size(), 1U);
  EXPECT_EQ(second->correlations()[0].first, 2U);
  EXPECT_EQ(second->correlations()[0].second, 3U);
  EXPECT_EQ(second->correlations()[0].value, -0.3);
}

TEST_F(JointKeys, OfBadFilesAreRefusedWithFileAndLine) {
  using Lines = std::vector<std::string>;
  const std::string text = gripped_block("sample") + drawn(kModulus, "E_Pa") + drawn(kFriction, "mu");
  EXPECT_EQ(said_of(text).size(), 2U);  // no such file, for each
  write("E_MPa,mu\n1,0.5\n2,0.4\n3,0.6\n");
  EXPECT_EQ(said_of(text), Lines{"fruit.csv:1: E_Pa: no such column; the file has E_MPa and mu"});
  write("E_Pa,mu\n1e6,0.5\n2e6,soft\n3e6,0.6\n");
  EXPECT_EQ(said_of(text), Lines{"fruit.csv:3: mu = \"soft\": must be a finite number"});
  write("E_Pa,mu\n1e6,0.5\n2e6,\n3e6,0.6\n");
  EXPECT_EQ(said_of(text), Lines{"fruit.csv:3: mu = \"\": must be a finite number"});
  write("E_Pa,mu\n1e6,0.5\n2e6,0.4,1\n3e6,0.6\n");
  const std::string cells =
      "fruit.csv:3: random[0].file: a row must have as many cells as the first line has (2), not 3";
  EXPECT_EQ(said_of(text).front(), cells);
  write("E_Pa,mu\n1e6,0.5\n2e6,0.4\n");
  EXPECT_EQ(said_of(text).front(), "fruit.csv:1: random[0].file: the file must have three rows at least, not 2");
  write("E_Pa,mu\n1e6,0.5\n-2e6,0.4\n3e6,0.6\n");
  EXPECT_EQ(
      said_of(text),
      Lines{"study.toml:10: random[0].key = \"product.youngs_modulus_Pa\": its data has values outside '> 0' "
            "(-2e+06)"});
}

TEST_F(JointKeys, AreCheckedRowByRowAgainstRulesBetweenThem) {
  // The tangent modulus of each row is below its modulus of elasticity, though not below the other's.
  write("E_Pa,tangent_Pa\n1e6,5e5\n2e5,1e5\n3e6,2e6\n");
  const std::string text = gripped_block("sample") + drawn(kModulus, "E_Pa") +
                           drawn("product.tangent_modulus_Pa", "tangent_Pa") +
                           "[product]\nyield_stress_Pa = 1e4\n";
  const std::string whole = [&] {  // one [product] table
    std::string joined = gripped_block("sample");
    joined.insert(joined.find("[gripper]"), "yield_stress_Pa = 1e4\n");
    return joined + text.substr(gripped_block("sample").size(),
                                text.find("[product]\nyield") - gripped_block("sample").size());
  }();
  EXPECT_EQ(said_of(whole), std::vector<std::string>{});
  write("E_Pa,tangent_Pa\n1e6,5e5\n2e5,3e5\n3e6,2e6\n");
  EXPECT_EQ(said_of(whole).size(), 1U);
}

TEST_F(JointKeys, AreAllowedInMorrisStudiesWithAWarning) {
  const std::string block =
      "[[random]]\nkey = \"product.mass_kg\"\ndistribution = \"uniform\"\nfrom = 0.1\nto = 0.2\n"
      "[[correlation]]\nbetween = [\"product.mass_kg\", \"product.friction\"]\nvalue = 0.3\n";
  const Study study = study_of(testing::search_block("sensitivity") + block, {"sensitivity.method=morris"});
  ASSERT_FALSE(study.warnings().empty());
  EXPECT_EQ(study.warnings()[0].substr(0, 41), "Morris' method moves one key at a time: w");
}

/// A product's file with blocks of its own.
class ProductsThatDiffer : public JointKeys {
 protected:
  void SetUp() override {
    JointKeys::SetUp();
    std::ofstream(folder_ / "fruit.toml") << R"(shape = "box"
size_m = [0.05, 0.06, 0.07]
mass_kg = 0.1
youngs_modulus_Pa = 1e6
[[random]]
key = "product.youngs_modulus_Pa"
distribution = "lognormal"
mean = 1e6
relative_deviation = 0.2
[[random]]
key = "product.friction"
distribution = "uniform"
from = 0.4
to = 0.6
[[correlation]]
between = ["product.youngs_modulus_Pa", "product.friction"]
value = 0.5
)";
  }

  [[nodiscard]] Study study(const std::string& kind, const std::string& product, const std::string& blocks) const {
    StudyOrError result = read("[study]\nname = \"test\"\nkind = \"" + kind +
                               "\"\n[product]\nuse = \"fruit.toml\"\n" + product + "[gripper]\n" + blocks);
    if (!result) throw std::runtime_error(result.error().messages.front());
    return *std::move(result);
  }
};

TEST_F(ProductsThatDiffer, AreDrawnByKindsThatDraw) {
  const Study sample = study("sample", "", "");
  ASSERT_EQ(sample.randoms().size(), 2U);
  EXPECT_EQ(sample.randoms()[0].key, kModulus);
  EXPECT_EQ(sample.correlations().size(), 1U);
  EXPECT_TRUE(study("simulate", "", "").randoms().empty());
}

TEST_F(ProductsThatDiffer, LeaveTheStudyTheLastWord) {
  const Study own = study("sample", "",
                          "[[random]]\nkey = \"product.friction\"\ndistribution = \"uniform\"\n"
                          "from = 0.1\nto = 0.2\n");
  ASSERT_EQ(own.randoms().size(), 2U);
  EXPECT_EQ(own.randoms()[0].distribution.to, 0.2);  // the study's blocks come first
  EXPECT_EQ(own.randoms()[1].key, kModulus);
  EXPECT_EQ(own.correlations().size(), 1U);
  const Study fixed = study("sample", "friction = 0.3\n", "");
  ASSERT_EQ(fixed.randoms().size(), 1U);
  EXPECT_TRUE(fixed.correlations().empty());
  EXPECT_EQ(std::get<LatticeParameters>(fixed.scenario(0).product).friction, 0.3);
  const Study other = study("sample", "",
                            "[[correlation]]\nbetween = [\"product.friction\", "
                            "\"product.youngs_modulus_Pa\"]\nvalue = -0.25\n");
  ASSERT_EQ(other.correlations().size(), 1U);
  EXPECT_EQ(other.correlations()[0].value, -0.25);
}

}  // namespace
}  // namespace unbruised::studies
