#include "studies/findings/trace_curves.hpp"

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

}  // namespace
}  // namespace unbruised::studies
