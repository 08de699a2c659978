// Measured fingertips against a stiff block: the law that was measured comes back.

#include "core/scenario/pad_law.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contact/layered_face.hpp"
#include "tests/core/contact/shaped_pad_scenes.hpp"

namespace unbruised {
namespace {

using namespace testing;

/// A block that gives a ten thousandth of what the tips do.
Scenario stiff_block() {
  Scenario s = pressed_product(Shape::box, {0.03, 0.03, 0.03}, 0.0075, 1e6);
  lattice_of(s).youngs_modulus_Pa = 5e9;
  jaw_of(s).pad_size_m = {0.016, 0.020};
  jaw_of(s).pad_thickness_m = 8e-3;
  jaw_of(s).drive_viscous_N_s_m = 20.0;
  jaw_of(s).pad_relaxation_time_s = 2e-3;
  lattice_of(s).density_kg_m3 = 8000.0;
  s.simulation.time_step_s = 5e-4;  // 20 in a period of the finger on 20 kN/m
  s.simulation.duration_s = 0.9;
  return s;
}

constexpr double kTip1[] = {2401.3, 4.2755e6}, kTip2[] = {4440.5, 1.5621e6};

TEST(MeasuredTips, PressAStiffBlockAsTheyWereMeasured) {
  for (const auto& tip : {kTip1, kTip2}) {
    for (const double depth : {0.3e-3, 1e-3, 3e-3}) {
      Scenario s = stiff_block();
      pad_of(s).law_coefficients = {tip[0], tip[1]};
      s.strategy.grip_force_N = tip[0] * depth + tip[1] * depth * depth;
      const AtRest rest = press(s);
      std::cout << "[ measured ] " << s.strategy.grip_force_N << " N: " << rest.approach_m * 1e3 << " mm, law "
                << depth * 1e3 << " mm, energy " << rest.energy_error << "\n";
      EXPECT_NEAR(rest.approach_m, depth, 2e-3 * depth);
      EXPECT_NEAR(rest.energy_error, 0.0, 0.01);
    }
  }
}

TEST(MeasuredTips, PointsPressAsThePolynomialThatTheySample) {
  Scenario s = stiff_block();
  for (int i = 0; i <= 12; ++i) {
    const double d = i * 0.25e-3;
    pad_of(s).law_depth_m.push_back(d);
    pad_of(s).law_force_N.push_back(kTip1[0] * d + kTip1[1] * d * d);
  }
  s.strategy.grip_force_N = pad_of(s).law_force_N[8];
  const AtRest rest = press(s);
  EXPECT_NEAR(rest.approach_m, 2e-3, 2e-3 * 2e-3);
  EXPECT_NEAR(rest.energy_error, 0.0, 0.01);
}

TEST(MeasuredTips, ALawThatIsALineIsTheLayerOfItsModulus) {
  Scenario s = pressed_product(Shape::sphere, {0.05, 0.05, 0.05}, 0.006, 1e6);
  jaw_of(s).drive_viscous_N_s_m = 5.0;
  s.strategy.approach_speed_m_s = 0.05;
  s.strategy.grip_force_N = 0.5;
  s.simulation.duration_s = 0.8;
  const AtRest springs = press(s);
  pad_of(s).law_coefficients = {1e6 * 0.04 * 0.04};
  const AtRest law = press(s);
  EXPECT_NEAR(law.approach_m, springs.approach_m, 1e-6 * springs.approach_m);
}

TEST(MeasuredTips, UnderAFruitTheLayerIsTheSecantOfItsPressure) {
  Scenario s = pressed_product(Shape::box, {0.03, 0.03, 0.03}, 0.0075, 1e6);
  jaw_of(s).pad_size_m = {0.016, 0.020};
  pad_of(s).law_coefficients = {kTip1[0], kTip1[1]};
  const double area = 0.016 * 0.020, d = 1.5e-3, F = kTip1[0] * d + kTip1[1] * d * d;
  EXPECT_NEAR(layer_at_pad(s).stiffness_N_m3(F), F / area / d, 1e-6 * F / area / d) << "the whole pad is pressed";
}

}  // namespace
}  // namespace unbruised
