#include "studies/findings/trace_curves.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/surface/surfaces.hpp"

namespace unbruised::studies {
namespace {

TEST(TraceCurves, CallSurfacesAsTheListOfSurfacesDoes) {
  const TraceSignal signal{"contact_count", "1", "closed contacts", {"surface"}, {kSurfaceCount}, {}};
  for (int surface = 0; surface < kSurfaceCount; ++surface) {
    EXPECT_EQ(curve_name(signal, static_cast<std::size_t>(surface)), surface_name(surface));
  }
}

TEST(TraceCurves, CountWhatHasNoNameAndSayAxes) {
  const TraceSignal signal{"finger_force_N", "N", "on the product", {"finger", "component"}, {2, 3}, {}};
  EXPECT_EQ(curve_name(signal, 0), "finger 1, x");
  EXPECT_EQ(curve_name(signal, 5), "finger 2, z");
  EXPECT_EQ(curve_name({"absorbed_energy_J", "J", "plastic work", {}, {}, {}}, 0), "");
}

TEST(TraceCurves, SayCausesAndSourcesInTheWordsOfTheirSignal) {
  const TraceSignal signal{"work_J",   "J", "work done: 0 gravity, 1 moving surfaces, 2 drives",
                           {"source"}, {4}, {}};
  EXPECT_EQ(curve_name(signal, 0), "gravity");
  EXPECT_EQ(curve_name(signal, 1), "moving surfaces");
  EXPECT_EQ(curve_name(signal, 2), "drives");
  EXPECT_EQ(curve_name(signal, 3), "source 4");
}

TEST(TraceCurves, AreTheColumnsOfATableButForIncompleteSignals) {
  Trace trace;
  trace.time_s = {0.0, 0.1};
  trace.signals = {{"way_m", "m", "closing way", {"finger"}, {2}, {1.0, 2.0, 3.0, 4.0}},
                   {"torn", "m", "a value is missing", {"finger"}, {2}, {1.0, 2.0, 3.0}}};
  const ResultTable table = trace_as_table(trace);
  ASSERT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.columns[2].name, "way_m [finger 2]");
  EXPECT_EQ(std::get<std::vector<double>>(table.columns[2].values), (std::vector<double>{2.0, 4.0}));
}

/// Two rows of a way, a count and a rotation by 0 and by a right angle about z, as -q.
Trace two_rows() {
  Trace trace;
  trace.time_s = {1.0, 2.0};
  const double half = std::sqrt(0.5);
  trace.signals = {
      {"way_m", "m", "closing way", {"finger"}, {2}, {1.0, 2.0, 3.0, 6.0}},
      {"contact_count", "1", "closed contacts", {}, {}, {4.0, 9.0}},
      {"attitude", "1", "rotation", {"quaternion"}, {4}, {1.0, 0.0, 0.0, 0.0, -half, 0.0, 0.0, -half}}};
  return trace;
}

TEST(TraceAt, IsAStraightLineForWaysTheRowBeforeForCountsAndStaysARotation) {
  const auto instant = trace_at(two_rows(), 1.5);
  ASSERT_TRUE(instant);
  EXPECT_EQ(instant->before_s, 1.0);
  EXPECT_EQ(instant->after_s, 2.0);
  EXPECT_EQ(instant->signals[0].values, (std::vector<double>{2.0, 4.0}));
  EXPECT_EQ(instant->signals[1].values, (std::vector<double>{4.0}));
  // Half of a right angle; -q is the same rotation as q.
  EXPECT_NEAR(instant->signals[2].values[0], std::cos(std::acos(-1.0) / 8.0), 1e-15);
  EXPECT_NEAR(instant->signals[2].values[3], std::sin(std::acos(-1.0) / 8.0), 1e-15);
}

TEST(TraceAt, IsARowAtItsTimeAndNothingOutside) {
  const auto last = trace_at(two_rows(), 2.0 + 1e-12);  // as near as rounding
  ASSERT_TRUE(last);
  EXPECT_EQ(last->before_s, 2.0);
  EXPECT_EQ(last->signals[1].values, (std::vector<double>{9.0}));
  for (const double outside : {0.999, 2.001, std::nan("")}) EXPECT_FALSE(trace_at(two_rows(), outside)) << outside;
  EXPECT_FALSE(trace_at(Trace{}, 0.0));
}

}  // namespace
}  // namespace unbruised::studies
