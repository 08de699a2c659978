#include "optimizer/search_space.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace unbruised::optimizer {
namespace {

SearchSpace awkward_space() {
  return SearchSpace({{"force", "N", 0.1, 0.7, Scale::linear},
                      {"speed", "m/s", 1e-4, 3.0, Scale::log},
                      {"shift", "m", -0.3, 1e-9, Scale::linear},
                      {"stiffness", "N/m", 3.3e-200, 7.7e100, Scale::log}});
}

std::string complaint_about(const Variable& variable) {
  try {
    SearchSpace({variable});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SearchSpace, MapsTheEndsOntoTheBoundsExactlyAndBack) {
  const SearchSpace space = awkward_space();
  const std::vector<double> lower = space.from_unit(std::vector<double>(4, 0.0));
  const std::vector<double> upper = space.from_unit(std::vector<double>(4, 1.0));
  for (std::size_t k = 0; k < space.size(); ++k) {
    EXPECT_EQ(lower[k], space.variables()[k].lower);
    EXPECT_EQ(upper[k], space.variables()[k].upper);
  }
  EXPECT_EQ(space.to_unit(lower), std::vector<double>(4, 0.0));
  EXPECT_EQ(space.to_unit(upper), std::vector<double>(4, 1.0));
}

TEST(SearchSpace, PutsTheMiddleOfALogScaleAtTheGeometricMean) {
  const SearchSpace space({{"x", "1", 0.01, 100.0, Scale::log}, {"y", "1", -2.0, 6.0, Scale::linear}});
  const std::vector<double> middle = space.from_unit(std::vector<double>(2, 0.5));
  EXPECT_NEAR(middle[0], 1.0, 1e-14);  // a power of 1e4: a few roundings
  EXPECT_EQ(middle[1], 2.0);
}

TEST(SearchSpace, ComesBackFromTheUnitCubeToWhereItWas) {
  const SearchSpace space = awkward_space();
  std::mt19937_64 random(20240117);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> unit(4);
    for (double& u : unit) u = part(random);
    const std::vector<double> point = space.from_unit(unit);
    const std::vector<double> back = space.to_unit(point);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_GE(point[k], space.variables()[k].lower);
      EXPECT_LE(point[k], space.variables()[k].upper);
      // A handful of roundings of numbers of order one: log and pow turn relative errors into ones of the
      // exponent.
      EXPECT_NEAR(back[k], unit[k], 16 * std::numeric_limits<double>::epsilon()) << "variable " << k;
    }
  }
}

TEST(SearchSpace, PutsWhatLiesOutsideOntoTheBorder) {
  const SearchSpace space = awkward_space();
  EXPECT_EQ(space.to_unit(std::vector<double>{-5.0, 0.0, 4.0, 1e300}), (std::vector<double>{0.0, 0.0, 1.0, 1.0}));
  EXPECT_EQ(space.from_unit(std::vector<double>{-1.0, 2.0, 1.5, -0.5}),
            (std::vector<double>{0.1, 3.0, 1e-9, 3.3e-200}));
}

TEST(SearchSpace, RefusesBrokenBoundsAndNamesTheVariable) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint_about({"a", "1", 1.0, 1.0, Scale::linear}),
            "a: lower must be < upper, and the range finite");
  EXPECT_EQ(complaint_about({"b", "1", 2.0, 1.0, Scale::linear}),
            "b: lower must be < upper, and the range finite");
  EXPECT_EQ(complaint_about({"c", "1", 0.0, infinity, Scale::linear}),
            "c: lower must be < upper, and the range finite");
  EXPECT_EQ(complaint_about({"d", "1", nan, 1.0, Scale::linear}),
            "d: lower must be < upper, and the range finite");
  EXPECT_EQ(complaint_about({"e", "1", -1e308, 1e308, Scale::linear}),
            "e: lower must be < upper, and the range finite");
  EXPECT_EQ(complaint_about({"f", "1", 0.0, 1.0, Scale::log}),
            "f: a log scale needs lower > 0, and a finite ratio");
  EXPECT_EQ(complaint_about({"g", "1", 1e-200, 1e200, Scale::log}),
            "g: a log scale needs lower > 0, and a finite ratio");
  EXPECT_EQ(complaint_about({"h", "1", 1e-3, 1.0, Scale::log}), "");
}

}  // namespace
}  // namespace unbruised::optimizer
