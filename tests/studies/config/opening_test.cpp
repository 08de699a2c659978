// A gripper that opens so far: the way of the pads follows from it and from the product.

#include "core/scenario/opening.hpp"

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::errors_of;
using testing::gripped_block;
using testing::search_block;
using testing::study_of;

TEST(ConfigOpening, WithoutOneTheUsualGapIsWrittenOut) {
  const Study study = study_of(gripped_block("simulate"));
  EXPECT_EQ(study.scenario(0).cell.approach_gap_m, kUsualApproachGap_m);
  EXPECT_NE(study.resolved_toml().find("approach_gap_m = 0.005"), std::string::npos);
}

TEST(ConfigOpening, GivesTheGapAndReadsBackAsWritten) {
  const Study study = study_of(gripped_block("simulate"), {"gripper.opening_m=0.08"});
  for (const Study& s : {study, study_of(study.resolved_toml())}) {
    EXPECT_FALSE(s.scenario(0).cell.approach_gap_m.has_value());
    EXPECT_DOUBLE_EQ(approach_gap_m(s.scenario(0)), 0.015);
    EXPECT_EQ(s.resolved_toml(), study.resolved_toml());
  }
}

TEST(ConfigOpening, StaysWhileTheProductVaries) {
  const Study sweep =
      study_of(gripped_block("sweep") + "[[vary]]\nkey = \"product.size_m[0]\"\nvalues = [0.05, 0.06]\n",
               {"gripper.opening_m=0.08"});
  EXPECT_DOUBLE_EQ(approach_gap_m(sweep.scenario(0)), 0.015);
  EXPECT_DOUBLE_EQ(approach_gap_m(sweep.scenario(1)), 0.01);
}

TEST(ConfigOpening, IsToldWhereAProductThatIsDrawnMayNotFit) {
  const auto errors = errors_of(search_block("sample") +
                                    "[[random]]\nkey = \"product.size_m[0]\"\ndistribution = \"uniform\"\n"
                                    "from = 0.045\nto = 0.055\n",
                                {"gripper.opening_m=0.054"});
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("gripper.opening_m = 0.054: must be > product.size_m[0] = 0.05"), std::string::npos)
      << errors[0];
  EXPECT_NE(errors[0].find("the product is wider than the open gripper (reached at product.size_m[0] = "),
            std::string::npos)
      << errors[0];
}

TEST(ConfigOpening, RefusesAGapThatContradictsIt) {
  EXPECT_EQ(
      errors_of(gripped_block("simulate") + "opening_m = 0.08\n[cell]\napproach_gap_m = 0.02\n"),
      (std::vector<std::string>{"study.toml:12: cell.approach_gap_m = 0.02: contradicts gripper.opening_m = 0.08, "
                                "which leaves 0.015 m on either side of the product; leave one of them out"}));
}

TEST(ConfigOpening, MayItselfBeVaried) {
  const Study sweep =
      study_of(gripped_block("sweep") + "[[vary]]\nkey = \"gripper.opening_m\"\nvalues = [0.06, 0.08]\n");
  EXPECT_DOUBLE_EQ(approach_gap_m(sweep.scenario(0)), 0.005);
  EXPECT_DOUBLE_EQ(approach_gap_m(sweep.scenario(1)), 0.015);
}

}  // namespace
}  // namespace unbruised::studies
