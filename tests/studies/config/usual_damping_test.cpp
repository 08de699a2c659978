#include "studies/config/usual_damping.hpp"

#include <cmath>
#include <numbers>

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::small_network;
using testing::study_of;

LatticeParameters product_of(const Study& study) { return std::get<LatticeParameters>(study.scenario(0).product); }

TEST(UsualDamping, IsGivenWhereAStudySaysNothing) {
  const Study study = study_of(gripped_block("simulate") +
                               "[[cell.surface]]\ncenter_m = [0.0, 0.0, -0.5]\n[[cell.surface]]\n"
                               "center_m = [0.0, 0.0, -0.6]\nrelaxation_time_s = 0.0\n");
  EXPECT_EQ(study.scenario(0).cell.surface[0].relaxation_time_s, kUsualRelaxationTime_s);
  EXPECT_EQ(study.scenario(0).cell.surface[1].relaxation_time_s, 0.0);
  EXPECT_EQ(product_of(study).loss_ratio, kUsualLossRatio);
  EXPECT_EQ(product_of(study).at_frequency_Hz, kUsualLossFrequency_Hz);
  EXPECT_EQ(jaw_of(study.scenario(0)).pad_relaxation_time_s, kUsualRelaxationTime_s);
  EXPECT_EQ(study.scenario(0).cell.support_relaxation_time_s, kUsualRelaxationTime_s);
}

TEST(UsualDamping, OfPadsIsThatOfProducts) {
  // Rounded to two digits: off by half a unit of the second.
  EXPECT_NEAR(kUsualRelaxationTime_s, kUsualLossRatio / (2.0 * std::numbers::pi * kUsualLossFrequency_Hz), 5e-6);
}

TEST(UsualDamping, AWrittenZeroIsKept) {
  const Study study = study_of(
      gripped_block("simulate"),
      {"product.relaxation_time_s=0", "gripper.pad_relaxation_time_s=0", "cell.support_relaxation_time_s=0"});
  EXPECT_EQ(product_of(study).relaxation_time_s, 0.0);
  EXPECT_EQ(product_of(study).loss_ratio, std::nullopt);
  EXPECT_EQ(jaw_of(study.scenario(0)).pad_relaxation_time_s, 0.0);
  EXPECT_EQ(study.scenario(0).cell.support_relaxation_time_s, 0.0);
}

TEST(UsualDamping, IsNotMixedWithWhatIsWrittenOrVaried) {
  EXPECT_EQ(product_of(study_of(gripped_block("simulate"), {"product.relaxation_time_s=0.002"})).loss_ratio,
            std::nullopt);
  const Study varied =
      study_of(gripped_block("sweep") + "[[vary]]\nkey = \"product.relaxation_time_s\"\nvalues = [0.0, 0.001]\n");
  EXPECT_EQ(std::get<LatticeParameters>(varied.scenario(1).product).relaxation_time_s, 0.001);
  EXPECT_EQ(product_of(varied).loss_ratio, std::nullopt);
}

TEST(UsualDamping, StandsInTheResolvedConfig) {
  const Study study = study_of(gripped_block("simulate"));
  EXPECT_NE(study.resolved_toml().find("loss_ratio = 0.2"), std::string::npos) << study.resolved_toml();
  EXPECT_NE(study.resolved_toml().find("pad_relaxation_time_s = 0.00064"), std::string::npos);
}

TEST(UsualDamping, LeavesNetworksAsTheyAreWritten) {
  EXPECT_EQ(study_of(small_network(), {"cell.support=true"}).scenario(0).cell.support_relaxation_time_s, 0.0);
}

}  // namespace
}  // namespace unbruised::studies
