// What a study says that is probably not meant: for its own values, and for the ends of what it varies or draws.

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::gripped_block;
using testing::search_block;
using testing::study_of;

using Sentences = std::vector<std::string>;

TEST(Doubts, AreNoneForAUsualStudy) {
  for (const char* kind : {"simulate", "sample", "optimize", "robust", "pareto", "compare", "sensitivity"}) {
    const bool single = std::string(kind) == "simulate";
    EXPECT_EQ(study_of(single ? gripped_block(kind) : search_block(kind)).warnings(), Sentences{}) << kind;
  }
}

TEST(Doubts, NameTheKeyTheValueWhatItMeansAndTheLikelySlip) {
  EXPECT_EQ(
      study_of(gripped_block("simulate"), {"product.mass_kg=95"}).warnings(),
      Sentences{
          "product.mass_kg = 95.0 gives a density of 452,400 kg/m3 (plausible: 100 to 3000): grams taken for "
          "kilograms (0.095)?"});
}

TEST(Doubts, LookAtBothEndsOfWhatVaries) {
  const Study study =
      study_of(gripped_block("sweep") + "[[vary]]\nkey = \"product.friction\"\nvalues = [0.5, 60.0, 0.6]\n");
  EXPECT_EQ(
      study.warnings(),
      Sentences{
          "product.friction = 60.0 means a friction coefficient of 60 (plausible: 0.05 to 2): per cent taken "
          "for a fraction (0.6)?"});
}

TEST(Doubts, SayAtWhichEndAValueFollows) {
  const Study study =
      study_of(gripped_block("sweep") + "[[vary]]\nkey = \"product.size_m[1]\"\nvalues = [0.012, 0.06]\n");
  EXPECT_EQ(
      study.warnings(),
      Sentences{
          "product.cell_size_m = 0.005 gives a cell count across the product of 2 (plausible: 3 to 80): fewer "
          "do not show where it is pressed, more take hours (at product.size_m[1] = 0.012)"});
}

TEST(Doubts, LookAtTheEndsOfWhatIsSearchedAndDrawn) {
  const Study searched = study_of(search_block("optimize") +
                                  "[[variable]]\nkey = \"strategy.settle_s\"\nfrom = 0.01\n"
                                  "to = 50.0\n");
  EXPECT_EQ(
      searched.warnings(),
      Sentences{"strategy.settle_s = 50.0 means a rest before the lift of 50 s (plausible: 0 to 10): milliseconds "
                "taken for seconds (0.05)?"});
  const Study drawn =
      study_of(search_block("sample") +
                   "[[random]]\nkey = \"product.mass_kg\"\ndistribution = \"uniform\"\nfrom = 40.0\nto = 80.0\n",
               {});
  ASSERT_EQ(drawn.warnings().size(), 1U);
  EXPECT_NE(drawn.warnings()[0].find("grams taken for kilograms"), std::string::npos);
}

TEST(Doubts, NameTheEndsOfAWindowAsTheyWereWritten) {
  const Study study =
      study_of(gripped_block("window") + "max_force_N = 4000.0\n[window]\nfrom_N = 1.0\nto_N = 3500.0\n");
  EXPECT_EQ(
      study.warnings(),
      Sentences{"window.to_N = 3500.0 gives a grip force over the least that can hold of 2964 (plausible: 0.02 to "
                "500): millinewtons taken for newtons (3.5)?"});
}

TEST(Doubts, LookAtEveryCandidateAndEveryProductFile) {
  const Study compared = study_of(search_block("compare") + "hold_s = 500.0\n");
  ASSERT_EQ(compared.warnings().size(), 1U);
  EXPECT_EQ(compared.warnings()[0].find("strategy.hold_s = 500.0 means"), 0U);
}

TEST(Doubts, AreSilentAboutNetworksWhoseScaleCanBeAny) {
  EXPECT_EQ(study_of(testing::small_network(), {"simulation.time_step_s=0.28", "product.particle[1].mass_kg=1e6"})
                .warnings(),
            Sentences{});
}

}  // namespace
}  // namespace unbruised::studies
