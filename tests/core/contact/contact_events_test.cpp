// The contact state register tells when within a step contacts make, break, slip and stick: against closed forms,
// and against the traces it stands beside.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/scenario/opening.hpp"
#include "core/scenario/product.hpp"
#include "tests/core/contact/contact_counts.hpp"
#include "tests/core/frame/rolling_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;
using Kind = ContactEvent::Kind;

std::vector<ContactEvent> of_kind(const Trace& trace, Kind kind, int surface = kSupport) {
  std::vector<ContactEvent> found;
  for (const ContactEvent& event : trace.events) {
    if (event.kind == kind && event.surface == surface) found.push_back(event);
  }
  return found;
}

/// One particle of 1 kg over a support with a layer of 400 N/m.
Scenario particle(double time_step_s, double duration_s) {
  Scenario scenario = oscillator(1.0, 100.0, time_step_s, 1);
  NetworkParameters& network = network_of(scenario);
  network.spring.clear();
  network.particle.erase(network.particle.begin());
  network.particle[0].position_m = {0.0, 0.0, 0.0};
  network.particle[0].fixed = {false, true, false};
  network.particle[0].contact_stiffness_N_m = 400.0;
  scenario.cell.support = true;
  scenario.cell.support_relaxation_time_s = 0.0;
  scenario.simulation.duration_s = duration_s;
  return scenario;
}

/// Flies 0.0313 m down at 1 m/s, onto the layer and off again.
Trace bounce(double time_step_s) {
  Scenario scenario = particle(time_step_s, 0.3);
  network_of(scenario).particle[0].initial_displacement_m = {0.0, 0.0, 0.0313};
  network_of(scenario).particle[0].initial_velocity_m_s = {0.2, 0.0, -1.0};
  scenario.cell.support_friction = 0.0;
  Trace trace;
  run(scenario, &trace);
  return trace;
}

TEST(ContactEvents, OfABounceComeAtTheTimesOfTheClosedForm) {
  const double make_s = 0.0313, break_s = make_s + std::acos(-1.0) / 20.0;  // half a period of 20 rad/s
  const std::array<double, 2> steps = {4e-3, 1e-3};
  std::array<double, 2> late_s{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Trace trace = bounce(steps[i]);
    const auto makes = of_kind(trace, Kind::make), breaks = of_kind(trace, Kind::break_);
    ASSERT_EQ(makes.size(), 1u);
    ASSERT_EQ(breaks.size(), 1u);
    // Before the layer nothing accelerates it: exact but for rounding, wherever within the step it falls.
    EXPECT_NEAR(makes[0].time_s, make_s, 1e-12);
    EXPECT_NEAR(makes[0].place_m[2], 0.0, 1e-3 * steps[i]);
    EXPECT_NEAR(makes[0].place_m[0], 0.2 * make_s, 1e-9);
    late_s[i] = breaks[0].time_s - break_s;
    // Off the layer it has stopped being accelerated, so that the place is that of its motion at 1 m/s.
    EXPECT_NEAR(breaks[0].place_m[2], 0.0, 0.1 * steps[i]);
    for (const double force_N : breaks[0].force_N) EXPECT_EQ(force_N, 0.0);
  }
  // The period of Wilson's method is too long by (0.0366 + ...) (omega dt)^2; here a step is 0.08 and 0.02 rad.
  EXPECT_LT(std::abs(late_s[0]), 0.2 * steps[0]);
  EXPECT_LT(std::abs(late_s[1]), std::abs(late_s[0]) / 8.0);
  std::cout << "[ measured ] break late by " << late_s[0] << " s at 4 ms, " << late_s[1] << " s at 1 ms\n";
}

/// A particle that has settled on a viscous layer is pushed by a force that rises to 8 N from 1.5 to 1.7 s and
/// falls to nothing until 1.9 s; mu = 0.3.
constexpr double kFrom_s = 1.5, kRise_s = 0.2, kRate_N_s = 40.0, kMu = 0.3;
Trace pushed(double time_step_s) {
  Scenario scenario = particle(time_step_s, 2.6);
  NetworkParameters& network = network_of(scenario);
  network.particle[0].initial_displacement_m = {0.0, 0.0, -kGravity / 400.0};
  NetworkLoad load;
  load.particle = 0;
  load.time_s = {0.0, kFrom_s, kFrom_s + kRise_s, kFrom_s + 2.0 * kRise_s};
  load.force_N = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {kRate_N_s * kRise_s, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  network.load = {load};
  scenario.cell.gravity_m_s2 = {0.0, 0.0, -kGravity};
  scenario.cell.support_friction = kMu;
  scenario.cell.support_relaxation_time_s = 0.05;
  Trace trace;
  run(scenario, &trace);
  return trace;
}

/// It sticks on a spring of a third of the layer's until that holds mu m g, then slides with a constant friction:
/// when it slips and when it has come to rest, of a mass of 1 kg.
std::array<double, 2> times_of_slip_and_stick() {
  const double omega = std::sqrt(400.0 / 3.0), friction_N = kMu * kGravity;
  double slip_s = 0.0, later_s = kRise_s;  // since the load began; the spring's force only rises
  while (later_s - slip_s > 1e-12) {
    const double middle = 0.5 * (slip_s + later_s);
    const double spring_N = kRate_N_s * (middle - std::sin(omega * middle) / omega);
    (spring_N < friction_N ? slip_s : later_s) = middle;
  }
  const double slips_at_m_s = kRate_N_s / (omega * omega) * (1.0 - std::cos(omega * slip_s));
  const double pushed_m_s = kRate_N_s * (kRise_s * kRise_s - 0.5 * slip_s * slip_s);  // by the rest of the load
  const double sliding_s = (slips_at_m_s + pushed_m_s) / friction_N;
  return {kFrom_s + slip_s, kFrom_s + slip_s + sliding_s};
}

TEST(ContactEvents, SlipAndStickComeAtTheTimesOfTheClosedForm) {
  const auto [slip_s, stick_s] = times_of_slip_and_stick();
  for (const double step_s : {4e-3, 1e-3}) {
    const Trace trace = pushed(step_s);
    std::vector<ContactEvent> slips = of_kind(trace, Kind::slip), sticks = of_kind(trace, Kind::stick);
    ASSERT_FALSE(slips.empty());
    ASSERT_FALSE(sticks.empty());
    const ContactEvent &slip = slips.front(), &stick = sticks.front();
    // The motion is of second order in omega dt = 0.05 or less; the end of a step would be off by up to 1.4 steps.
    EXPECT_NEAR(slip.time_s, slip_s, 0.02 * step_s);
    // Where it slides, the anchor follows the chord of a step, which lies 0.2 a dt^2 behind the braked motion: to
    // leave the cone the particle has to come back by that, which takes 0.63 dt.
    EXPECT_NEAR(stick.time_s, stick_s + 0.4 * step_s, 0.4 * step_s);
    EXPECT_NEAR(slip.force_N[2], kGravity, 1e-3);
    EXPECT_NEAR(slip.force_N[0], -kMu * slip.force_N[2], 1e-9) << "the cone, against the push";
    EXPECT_NEAR(stick.force_N[0], -kMu * stick.force_N[2], 0.2) << "left within the step";
    EXPECT_NEAR(slip.place_m[2], -kGravity / 400.0, 1e-5);
    std::cout << "[ measured ] step " << step_s << " s: slip " << slip.time_s - slip_s << " s late, stick "
              << stick.time_s - stick_s << " s late\n";
  }
}

/// A box whose sides face the pads and the support, that turns as it falls, that rolls.
Scenario gripped_in_frame() {
  Scenario scenario = small_box();
  scenario.simulation.contact_set = ContactSet::whole_surface;
  return scenario;
}
Scenario thrown() { return thrown_box(5e-4, 0.3); }
Scenario rolling() {
  Scenario scenario = roller(Shape::sphere, 0.2);
  scenario.simulation.duration_s = 0.2;
  scenario.simulation.time_step_s = 5e-4;
  return scenario;
}

struct Recounted {
  const char* name;
  Scenario (*scenario)();
};
class Register : public ::testing::TestWithParam<Recounted> {};

TEST_P(Register, EventsAddUpToTheCountsOfEveryRow) {
  const Scenario scenario = GetParam().scenario();
  Trace trace;
  run(scenario, &trace);
  const Recount found = recount(trace, scenario.simulation.theta, scenario.simulation.time_step_s);
  EXPECT_GT(found.events, 10u);
  EXPECT_EQ(found.closed_differs, 0u);
  EXPECT_EQ(found.sliding_differs, 0u);
  EXPECT_EQ(found.impossible, 0u);
  std::cout << "[ measured ] " << GetParam().name << ": " << found.events << " events over " << found.rows
            << " rows\n";
}

TEST_P(Register, EventsLieWithinTheirWindowAndForcesWithinTheCone) {
  const Scenario scenario = GetParam().scenario();
  Trace trace;
  run(scenario, &trace);
  const double mu = std::max(product_friction(scenario.product), scenario.cell.support_friction);
  for (const ContactEvent& event : trace.events) {
    EXPECT_GE(event.time_s, 0.0);
    EXPECT_LE(event.time_s, trace.time_s.back() + scenario.simulation.theta * scenario.simulation.time_step_s);
    const double size = std::hypot(event.force_N[0], event.force_N[1], event.force_N[2]);
    const int axis = normal_axis(event.surface);
    if (scenario.cell.surface.empty() && size > 0.0) {
      const double normal = std::abs(event.force_N[static_cast<std::size_t>(axis)]);
      EXPECT_LE(std::sqrt(std::max(0.0, size * size - normal * normal)), mu * normal * (1.0 + 1e-9) + 1e-12);
    }
    if (event.kind == Kind::make && event.time_s > 0.0) {
      EXPECT_EQ(size, 0.0);
    }
  }
}

TEST_P(Register, EventsDoNotDependOnNeighbours) {
  const Scenario scenario = GetParam().scenario();
  Scenario other = scenario;
  other.cell.gravity_m_s2[2] *= 1.1;
  Trace alone;
  run(scenario, &alone);
  const std::vector<Trace> beside = traces_of({other, scenario, other});
  ASSERT_EQ(alone.events.size(), beside[1].events.size());
  for (std::size_t i = 0; i < alone.events.size(); ++i) {
    const ContactEvent &a = alone.events[i], &b = beside[1].events[i];
    EXPECT_TRUE(same_bits(a.time_s, b.time_s) && a.contact == b.contact && a.kind == b.kind) << i;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(same_bits(a.place_m[k], b.place_m[k]) && same_bits(a.force_N[k], b.force_N[k])) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Register,
                         ::testing::Values(Recounted{"gripped", slipping_box},
                                           Recounted{"gripped_in_frame", gripped_in_frame},
                                           Recounted{"thrown", thrown}, Recounted{"rolling", rolling}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// The particles of a box's left side against the plane of the pad, from displacements and finger ways alone.
TEST(ContactEvents, OfAFlatUprightProductAreFoundAgainFromItsMotion) {
  Scenario scenario = small_box();
  jaw_of(scenario).pad_relaxation_time_s = 0.0;
  Trace trace;
  run(scenario, &trace);
  const std::vector<double> way = column(trace, "finger_way_m", 0), palm = column(trace, "palm_position_m", 0);
  const auto particles = static_cast<std::size_t>(trace.particle_count);
  double low = 0.0;
  for (std::size_t p = 0; p < particles; ++p) low = std::min(low, trace.rest_position_m[3 * p]);
  std::size_t found = 0;
  for (std::size_t p = 0; p < particles; ++p) {
    if (trace.rest_position_m[3 * p] > low + 1e-9) continue;
    std::vector<ContactEvent> events;
    for (const ContactEvent& event : of_kind(trace, Kind::make, kLeftPad)) {
      if (event.node == static_cast<int>(p)) events.push_back(event);
    }
    const auto depth = [&](std::size_t row) {
      const double particle_m = low + trace.displacement_m[3 * (row * particles + p)];
      return low - approach_gap_m(scenario) + way[row] + palm[row] - particle_m;
    };
    std::vector<double> crossed_s;
    for (std::size_t row = 1; row < trace.time_s.size(); ++row) {
      const double before = depth(row - 1), after = depth(row);
      if (before > 0.0 || !(after > 0.0)) continue;
      crossed_s.push_back(trace.time_s[row - 1] +
                          (trace.time_s[row] - trace.time_s[row - 1]) * before / (before - after));
    }
    ASSERT_EQ(events.size(), crossed_s.size()) << p;
    for (std::size_t i = 0; i < events.size(); ++i) {
      EXPECT_NEAR(events[i].time_s, crossed_s[i], scenario.simulation.time_step_s) << p;
      ++found;
    }
  }
  EXPECT_GE(found, 9u);  // nine particles on that side
}

}  // namespace
}  // namespace unbruised
