// What stands in a folder of runs, and what one of them sounds like.
#include <string>

#include <gtest/gtest.h>

#include "tests/studies/cli/program.hpp"

namespace unbruised::studies {
namespace {

class Shelf : public testing::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("study.toml",
          testing::coarse_block("one") + "[[vary]]\nkey = \"strategy.grip_force_N\"\nvalues = [0.5, 4.0]\n");
    ASSERT_EQ(call("run -q study.toml -j 1 --no-replay").status, 0);
    ASSERT_EQ(call("run -q study.toml -j 1 --no-replay --output 'results/a <b>&c'").status, 0);
    std::filesystem::create_directories(folder_ / "results/empty");
    write("results/notes.txt", "no run");
  }
};

TEST_F(Shelf, ListsTheRunsOfAFolderWithTheirAnswer) {
  const Answer list = call("list results");
  ASSERT_EQ(list.status, 0) << list.err;
  EXPECT_NE(list.out.find("results/one: one, sweep, complete, 20"), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("\n  results/one/report.html\n"), std::string::npos) << list.out;
  EXPECT_EQ(list.out.find("empty"), std::string::npos) << list.out;
  const std::string answer = line_after(call("info results/one").out, "set-point: ");
  EXPECT_NE(list.out.find("\n  set-point: " + answer + "\n"), std::string::npos) << list.out;
  const Answer none = call("list results/empty");
  EXPECT_EQ(none.out, "no runs below results/empty\n");
  EXPECT_EQ(call("list nowhere").status, 2);
}

TEST_F(Shelf, IndexIsAPageOfLinksThatNoNameCanBreak) {
  const Answer index = call("report --index results");
  ASSERT_EQ(index.status, 0) << index.err;
  EXPECT_EQ(index.out, "index: results/index.html (2 runs)\n");
  const std::string page = text_of("results/index.html");
  EXPECT_NE(page.find("<a href=\"./one/report.html\">one</a>"), std::string::npos) << page;
  EXPECT_NE(page.find("<a href=\"./a%20%3Cb%3E%26c/report.html\">one</a>"), std::string::npos) << page;
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  // Again, over its own page; never over another's.
  EXPECT_EQ(call("report --index results").status, 0);
  write("results/index.html", "mine");
  EXPECT_NE(call("report --index results").status, 0);
  EXPECT_EQ(text_of("results/index.html"), "mine");
}

TEST_F(Shelf, AScenarioIsHeardInAFile) {
  const Answer heard = call("report results/one --audio one.wav");
  ASSERT_EQ(heard.status, 0) << heard.err;
  EXPECT_NE(heard.out.find("audio: one.wav (scenario "), std::string::npos) << heard.out;
  const std::string wave = text_of("one.wav");
  EXPECT_TRUE(wave.starts_with("RIFF"));
  EXPECT_GT(wave.size(), 44100U) << "half a second and more of 16 bits";
}

TEST_F(Shelf, MeasuredForcesStandBesideAWindowAndAWrongOneIsNamed) {
  write("measured.csv", "specimen,rupture_force_N\na,6.51\nb,1.92\nc,3.63\n");
  const Answer page = call("report results/one --no-replay --measured measured.csv");
  ASSERT_EQ(page.status, 0) << page.err;
  EXPECT_NE(text_of("results/one/report.html")
                .find(R"("measured":{"file":"measured.csv","rupture_N":[6.51,1.92,3.63]})"),
            std::string::npos);
  write("wrong.csv", "specimen,rupture_force_N\na,strong\nb,1.92\nc,\n");
  const Answer wrong = call("report results/one --no-replay --measured wrong.csv");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("wrong.csv:2"), std::string::npos) << wrong.err;
  EXPECT_NE(call("report results/one --no-replay --measured nowhere.csv").status, 0);
}

}  // namespace
}  // namespace unbruised::studies
