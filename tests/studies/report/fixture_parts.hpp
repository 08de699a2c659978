#pragma once

/// @file
/// What the fixtures of all kinds are made from: a gripper and a product that follow simple laws, and tables.

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/studies/report/report_fixtures.hpp"

namespace unbruised::studies::testing {

inline constexpr double kPi = 3.14159265358979323846;

/// A small generator with known bits (Knuth's MMIX constants): fixtures never change by themselves.
class Chance {
 public:
  double uniform() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) * 0x1p-53;
  }
  double normal() { return std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * kPi * uniform()); }

 private:
  std::uint64_t state_ = 20261125;
};

/// What the fixtures' gripper does to the fixtures' product: simple laws of the right shape.
struct Handling {
  double grip_force_N = 2.0;
  double approach_speed_m_s = 0.1;
  double lift_acceleration_m_s2 = 2.0;
  double friction = 0.6;
  double mass_kg = 0.095;
  double strength = 1.0;
};

ScenarioResult result_of(const Handling& at);

inline const ColumnInfo kGrip{"strategy.grip_force_N", "N", "drive force limit of each finger"};
inline const ColumnInfo kSpeed{"strategy.approach_speed_m_s", "m s-1", ""};
inline const ColumnInfo kLift{"strategy.lift_acceleration_m_s2", "m s-2", ""};
inline const ColumnInfo kFriction{"product.friction", "1", ""};
inline const ColumnInfo kMass{"product.mass_kg", "kg", ""};
inline const ColumnInfo kYield{"product.yield_stress_Pa", "Pa", ""};

/// Logarithmic, both ends included.
std::vector<double> from_to(double from, double to, std::size_t count);

/// Name, meta and context; the rest is the kind's.
ReportFixture begin(const std::string& name, const std::string& kind);
/// The summary needs the rows.
ReportFixture end(ReportFixture fixture);
void add_row(ReportFixture& fixture, const Handling& at, std::vector<InputValue> inputs);

/// A product of its own, and what the gripper does to it; `first` are the inputs before the product's.
struct Product {
  double friction;
  double mass_kg;
  double yield_stress_Pa;
};

Product draw(Chance& chance);
void add_product(ReportFixture& fixture, Handling at, const Product& product, std::vector<InputValue> first);
ResultTable random_table();

ResultColumn numbers(const std::string& name, const std::string& units, const std::string& long_name,
                     std::vector<double> values);
ResultColumn texts(const std::string& name, std::vector<std::string> values);

// The kinds, each in a file of its own.
ReportFixture sweep(const std::string& name, const std::vector<double>& forces, const std::vector<double>& speeds,
                    const std::vector<double>& lifts, double strength);
std::vector<ReportFixture> window_fixtures();
std::vector<ReportFixture> search_fixtures();
ReportFixture sample();
std::vector<ReportFixture> product_fixtures();
std::vector<ReportFixture> single_fixtures();
std::vector<ReportFixture> faulty_fixtures();
/// The only ones that are simulated: what is in motion.
std::vector<ReportFixture> moving_fixtures();

}  // namespace unbruised::studies::testing
