#include "studies/report/report_page.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <unistd.h>

#include "studies/report/report_bundle.hpp"
#include "studies/results/durable_files.hpp"
#include "tests/studies/report/report_fixtures.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

const std::vector<testing::ReportFixture>& fixtures() {
  static const std::vector<testing::ReportFixture> all = testing::report_fixtures();
  return all;
}

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// The page without the bundle, which is the same in all of them and speaks of addresses in its name spaces.
std::string markup_of(const testing::ReportFixture& fixture) {
  std::string page = report_page(fixture.content, fixture.context);
  for (const std::string_view part : {report_script(), report_style(), report_notices()}) {
    const std::size_t at = page.find(part);
    if (at != std::string::npos) page.erase(at, part.size());
  }
  return page;
}

/// `markup` without the study's data, which stands in elements no browser looks into.
std::string without_data(std::string markup) {
  for (const std::string id : {"study", "columns", "notices"}) {
    const std::size_t begin = markup.find("id=\"" + id + "\">");
    if (begin != std::string::npos) markup.erase(begin, markup.find("</script>", begin) - begin);
  }
  return markup;
}

TEST(ReportPage, HasNothingThatReachesOut) {
  for (const testing::ReportFixture& fixture : fixtures()) {
    const std::string markup = without_data(markup_of(fixture));
    EXPECT_LT(markup.size(), 20000U) << fixture.name;
    EXPECT_NE(markup.find("default-src 'none'; script-src 'sha256-"), std::string::npos);
    for (const std::string word :
         {" src=", "srcset=", "action=", "poster=", "@import", "url(", "<iframe", "<object", "<base"}) {
      // What the study says stands there with its brackets and quotes escaped.
      const bool said = fixture.name == "hostile" && word == " src=";
      EXPECT_TRUE(said || markup.find(word) == std::string::npos) << fixture.name << ": " << word;
    }
    EXPECT_EQ(count_of(markup, "href="), count_of(markup, "href=\"data:image/svg+xml,")) << fixture.name;
  }
  EXPECT_EQ(report_style().find("url("), std::string_view::npos);
  EXPECT_EQ(report_style().find("@import"), std::string_view::npos);
}

TEST(ReportPage, HasFourScriptElementsWhateverTheStudySays) {
  for (const testing::ReportFixture& fixture : fixtures()) {
    const std::string page = report_page(fixture.content, fixture.context);
    EXPECT_EQ(count_of(page, "<script"), 4U + count_of(std::string(report_script()), "<script")) << fixture.name;
    EXPECT_EQ(count_of(page, "</script"), 4U) << fixture.name;
  }
}

TEST(ReportPage, LeavesNoHostileTextAsMarkup) {
  for (const testing::ReportFixture& fixture : fixtures()) {
    if (fixture.name != "hostile") continue;
    const std::string markup = without_data(markup_of(fixture));
    for (const std::string word :
         {"<img", "<svg onload", "<!--<script", "onerror=\"", "onmouseover='", "window.hacked=1</"}) {
      EXPECT_EQ(markup.find(word), std::string::npos) << word;
    }
  }
}

TEST(ReportPage, FitsItsBudget) {
  for (const testing::ReportFixture& fixture : fixtures()) {
    if (fixture.content.rows.size() > 512) continue;
    // Half of it is what draws scenarios in motion; their frames are megabytes.
    const std::size_t most = fixture.name == "in_motion" ? 6000000U : 1800000U;
    EXPECT_LT(report_page(fixture.content, fixture.context).size(), most) << fixture.name;
  }
}

TEST(ReportPage, CarriesTheNoticesOfWhatIsInside) {
  const std::string notices(report_notices());
  for (const char* word : {"Apache License", "ECharts", "zrender", "Redistribution and use"}) {
    EXPECT_NE(notices.find(word), std::string::npos) << word;
  }
}

class ReportFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("unbruised_report_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(ReportFile, IsReplacedByANewerOneAndLeavesNoTemporary) {
  const testing::ReportFixture& fixture = fixtures().front();
  const fs::path page = folder_ / "report.html";
  for (int i = 0; i < 2; ++i) ASSERT_FALSE(write_report(page, fixture.content, fixture.context));
  EXPECT_EQ(*read_text_file(page), report_page(fixture.content, fixture.context));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ReportFile, ReplacesNothingElse) {
  const fs::path precious = folder_ / "thesis.html";
  std::ofstream(precious) << "<!doctype html>\n<p>ten years of work</p>\n";
  const auto error = write_report(precious, fixtures().front().content, fixtures().front().context);
  ASSERT_TRUE(error);
  EXPECT_EQ(error->kind, ResultsErrorKind::foreign);
  EXPECT_NE(error->message.find(precious.string()), std::string::npos);
  EXPECT_NE(read_text_file(precious)->find("ten years"), std::string::npos);
}

TEST_F(ReportFile, NamesThePlaceWhereItCannotBeWritten) {
  const auto error = write_report(folder_ / "missing" / "report.html", fixtures().front().content, {});
  ASSERT_TRUE(error);
  EXPECT_EQ(error->kind, ResultsErrorKind::io);
  EXPECT_NE(error->message.find("missing"), std::string::npos);
}

TEST(HtmlText, LeavesNoLetterWithAMeaning) {
  EXPECT_EQ(html_text("<a b='\"&'>"), "&lt;a b=&#39;&quot;&amp;&#39;&gt;");
}

}  // namespace
}  // namespace unbruised::studies
