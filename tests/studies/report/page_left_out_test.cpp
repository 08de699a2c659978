// A build without the page of the report: this file's empty bundle is linked in place of the library's.
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "studies/report/report_bundle.hpp"
#include "studies/report/report_page.hpp"
#include "tests/studies/report/report_fixtures.hpp"

namespace unbruised::studies {

std::string_view report_script() { return {}; }
std::string_view report_style() { return {}; }
std::string_view report_notices() { return {}; }

namespace {

TEST(PageLeftOut, IsNoPageButASentenceThatSaysHowToGetIt) {
  const std::filesystem::path page =
      std::filesystem::temp_directory_path() / ("page_left_out_" + std::to_string(::getpid()) + ".html");
  const testing::ReportFixture fixture = testing::large_fixture(8);
  const MaybeError error = write_report(page, fixture.content, fixture.context);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->kind, ResultsErrorKind::not_built);
  EXPECT_EQ(exit_status(error->kind), 2);
  for (const char* word : {"NODE_EXTRA_CA_CERTS", "registry", "scripts/build"}) {
    EXPECT_NE(error->message.find(word), std::string::npos) << word << " in: " << error->message;
  }
  EXPECT_FALSE(std::filesystem::exists(page));
}

}  // namespace
}  // namespace unbruised::studies
