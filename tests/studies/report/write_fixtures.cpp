// usage: report_fixtures FOLDER [ROWS]: writes a page for every fixture, and one with ROWS scenarios.

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "studies/report/report_page.hpp"
#include "tests/studies/report/report_fixtures.hpp"

namespace {

bool write(const std::filesystem::path& folder, const unbruised::studies::testing::ReportFixture& fixture) {
  const auto error =
      unbruised::studies::write_report(folder / (fixture.name + ".html"), fixture.content, fixture.context);
  if (error) std::fprintf(stderr, "%s\n", error->message.c_str());
  return !error;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace unbruised::studies::testing;
  if (argc < 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  bool good = true;
  for (const ReportFixture& fixture : report_fixtures()) good = write(folder, fixture) && good;
  if (argc > 2) good = write(folder, large_fixture(std::strtoul(argv[2], nullptr, 10))) && good;
  return good ? 0 : 1;
}
