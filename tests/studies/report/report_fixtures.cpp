#include "tests/studies/report/report_fixtures.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include "tests/studies/report/fixture_parts.hpp"

namespace unbruised::studies::testing {

std::vector<ReportFixture> report_fixtures() {
  std::vector<ReportFixture> all;
  for (auto* kind :
       {window_fixtures, search_fixtures, product_fixtures, single_fixtures, faulty_fixtures, moving_fixtures}) {
    std::vector<ReportFixture> some = kind();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  for (ReportFixture& fixture : all) fixture = end(std::move(fixture));
  return all;
}

ReportFixture large_fixture(std::size_t rows) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(rows)));
  return end(sweep("large", from_to(0.6, 10.0, side), from_to(0.02, 0.6, rows / side), {2.0}, 1.0));
}

}  // namespace unbruised::studies::testing
