// The step of a solid, solved as a correction in single precision, beside the same one solved in double precision.

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/algebra/lane_dense.hpp"
#include "core/algebra/lane_solve.hpp"
#include "core/body/body_lanes.hpp"
#include "core/body/node_compliance.hpp"
#include "tests/core/scenario/scenarios.hpp"

namespace unbruised {
namespace {

constexpr int kSteps = 60;
constexpr int kLane = 3;

/// A body with two particles that forces act on.
struct Pushed {
  BodyModel model;
  std::vector<int> particle;
  NodeCompliance compliance;

  [[nodiscard]] Touchable touchable() const {
    return {particle, compliance.reach, compliance.block, &compliance.columns};
  }
  [[nodiscard]] BodyState at_rest() const {
    const std::vector<double> nothing(3 * model.particle_count);
    return {nothing, nothing, nothing, {}};
  }
};

const WilsonTheta kWilson{1e-3, 1.4};

/// How the body's answer to contact forces is found.
enum class Answer { by_product, by_solve };

Pushed pushed_block(Answer answer) {
  std::string error;
  Pushed block{
      .model = *build_body(testing::usual_grip().product, kWilson, error), .particle = {}, .compliance = {}};
  block.model.factor.round_values();
  // Two of one line along x: equal and opposite forces along it turn nothing.
  const auto& place = block.model.position_m;
  int last = 0;
  for (std::size_t p = 0; p < place.size(); ++p) {
    if (std::abs(place[p][1] - place[0][1]) + std::abs(place[p][2] - place[0][2]) < 1e-9)
      last = static_cast<int>(p);
  }
  block.particle = {0, last};
  block.compliance = node_compliance(block.model.factor, block.model.slot, block.particle);
  EXPECT_FALSE(block.compliance.columns.empty());
  if (answer == Answer::by_solve) block.compliance.columns = {};
  return block;
}

class Correction : public ::testing::TestWithParam<Answer> {};
INSTANTIATE_TEST_SUITE_P(OfBothKinds, Correction, ::testing::Values(Answer::by_product, Answer::by_solve),
                         [](const auto& which) {
                           return which.param == Answer::by_product ? "ByProduct" : "BySolve";
                         });

/// One step under forces on the two, opposite along x. @param base what it would come to without them
void step(BodyLanes& lanes, const Pushed& block, double force_N, LaneArray& base) {
  LaneArray force(6);
  force.put(0, Lane(force_N));
  force.put(3, Lane(-force_N));
  lanes.begin_step(Mask(true));
  lanes.start_solve(nullptr);
  lanes.solve_without_contact(block.touchable(), base);
  const std::vector<int> both = {0, 1};
  lanes.add_contact(block.particle, force_N != 0.0 ? std::span<const int>(both) : std::span<const int>(), force);
  lanes.finish_solve(Mask(true));
  lanes.advance(Mask(true));
}

/// Pressed in 20 ms, held, and let go at once.
double force_at(int k) { return k < 20 ? 0.02 * k : k < 40 ? 0.4 : 0.0; }

TEST_P(Correction, SaysUnderWhichForcesItLooks) {
  const Pushed block = pushed_block(GetParam());
  BodyLanes lanes(block.model, kWilson, ProductFrame::upright, block.touchable());
  lanes.load(kLane, block.at_rest(), {0.0, 0.0, -9.81});
  LaneArray without(6), under(6);
  for (int k = 0; k < 5; ++k) step(lanes, block, force_at(k), without);
  lanes.begin_step(Mask(true));
  lanes.start_solve(nullptr);
  const HeldForces held = lanes.solve_under_held(block.touchable(), under);
  lanes.solve_without_contact(block.touchable(), without);
  ASSERT_NE(held.force_N, nullptr);
  EXPECT_EQ(std::vector<int>(held.on.begin(), held.on.end()), (std::vector<int>{0, 1}));
  EXPECT_EQ(held.force_N->at(0, kLane), force_at(4));
  EXPECT_EQ(held.force_N->at(3, kLane), -force_at(4));
  for (std::size_t row = 0; row < 6; ++row) {
    double by_held = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
      by_held +=
          block.compliance.block[9 * (2 * (row / 3) + k / 3) + 3 * (row % 3) + k % 3] * held.force_N->at(k, kLane);
    }
    EXPECT_NEAR(under.at(row, kLane) - without.at(row, kLane), by_held, 1e-12 * std::abs(under.at(0, kLane)));
  }
}

TEST_P(Correction, FollowsTheSolutionInDoublePrecision) {
  const Pushed block = pushed_block(GetParam());
  BodyModel in_double = block.model;
  in_double.factor.single_value.clear();
  BodyLanes corrected(block.model, kWilson, ProductFrame::upright, block.touchable()),
      exact(in_double, kWilson, ProductFrame::upright, block.touchable());
  for (BodyLanes* lanes : {&corrected, &exact}) lanes->load(kLane, block.at_rest(), {0.0, 0.0, -9.81});
  LaneArray base(6), exact_base(6);
  for (int k = 0; k < kSteps; ++k) {
    step(corrected, block, force_at(k), base);
    step(exact, block, force_at(k), exact_base);
    double largest = 0.0, worst = 0.0, worst_base = 0.0;
    for (std::size_t i = 0; i < corrected.u().rows(); ++i) {
      largest = std::max(largest, std::abs(exact.u().at(i, kLane)));
      worst = std::max(worst, std::abs(corrected.u().at(i, kLane) - exact.u().at(i, kLane)));
    }
    for (std::size_t i = 0; i < 6; ++i) {
      worst_base = std::max(worst_base, std::abs(base.at(i, kLane) - exact_base.at(i, kLane)));
    }
    // Single precision knows 6e-8 of what a step changes; what steps add up to here is ten times as much.
    EXPECT_LT(worst, 1e-6 * largest) << "step " << k;
    EXPECT_LT(worst_base, 1e-6 * largest) << "step " << k;
  }
}

TEST_P(Correction, BalancesMomentumInDoublePrecision) {
  const Pushed block = pushed_block(GetParam());
  BodyLanes lanes(block.model, kWilson, ProductFrame::upright, block.touchable());
  lanes.load(kLane, block.at_rest(), {0.0, 0.0, -9.81});
  LaneArray base(6);
  for (int k = 0; k < kSteps; ++k) step(lanes, block, force_at(k), base);
  // Equal and opposite forces, and gravity from the first step on.
  const double weight_N = 9.81 * block.model.total_mass_kg;
  const std::array<Lane, 3>& inertia = lanes.mass_a();
  for (std::size_t axis = 0; axis < 2; ++axis) EXPECT_NEAR(inertia[axis][kLane], 0.0, 1e-11 * weight_N);
  EXPECT_NEAR(inertia[2][kLane], -weight_N, 1e-11 * weight_N);
}

TEST_P(Correction, OfWhatRestsUnderItsForcesIsNothing) {
  const Pushed block = pushed_block(GetParam());
  BodyLanes lanes(block.model, kWilson, ProductFrame::upright, block.touchable());
  // At rest under equal and opposite forces, as the static solver finds it.
  std::vector<double> force(3 * block.model.particle_count);
  force[0] = 0.4;
  force[3 * static_cast<std::size_t>(block.particle[1])] = -0.4;
  BodyState state = block.at_rest();
  state.displacement_m = block.model.statics->free_shape(force);
  lanes.load(kLane, state, {});
  LaneArray base(6);
  for (int k = 0; k < kSteps; ++k) step(lanes, block, 0.4, base);
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    largest = std::max(largest, std::abs(state.displacement_m[i]));
    worst = std::max(worst, std::abs(lanes.u().at(i, kLane) - state.displacement_m[i]));
  }
  // The forces come in one step, of which single precision makes an error once; after that nothing changes.
  EXPECT_LT(worst, 1e-6 * largest);
  // Solved for, forces and what they balance go the same way and cancel. By a product they leave of that first
  // step, of which 6e-8 is not known, a turn as a whole, at a rate that stays what it is.
  const double drift_m = GetParam() == Answer::by_product ? 1e-10 * largest : 0.0;
  const auto moved_m = [&] {
    const double before = lanes.u().at(0, kLane);
    step(lanes, block, 0.4, base);
    return lanes.u().at(0, kLane) - before;
  };
  const double once_m = moved_m();
  EXPECT_NEAR(once_m, 0.0, drift_m + 1e-13 * largest);
  for (int k = 0; k < kSteps; ++k) step(lanes, block, 0.4, base);
  EXPECT_NEAR(moved_m(), once_m, 1e-13 * largest);
}

TEST(Corrections, AreOfLargeFreeSolids) {
  std::string error;
  Scenario scenario = testing::usual_grip();
  LatticeParameters& product = testing::lattice_in(scenario);
  product.shape = Shape::box;
  product.size_m = {0.05, 0.05, 0.05};
  for (const auto& [cells, rounds] : {std::pair(5, false), std::pair(6, true)}) {  // 648 and 1,029 freedoms
    product.cell_size_m = 0.05 / cells;
    const auto body = build_body(scenario.product, kWilson, error);
    ASSERT_TRUE(body) << error;
    EXPECT_EQ(!body->factor.single_value.empty(), rounds) << cells;
    const auto held = build_held_body(product, kWilson, error);
    ASSERT_TRUE(held) << error;
    EXPECT_TRUE(held->factor.single_value.empty()) << cells;
  }
}

TEST_P(Correction, KnowsWhatAnArrivingLaneIsHeldBy) {
  const Pushed block = pushed_block(GetParam());
  BodyLanes first(block.model, kWilson, ProductFrame::upright, block.touchable()),
      second(block.model, kWilson, ProductFrame::upright, block.touchable());
  for (BodyLanes* lanes : {&first, &second}) lanes->load(kLane, block.at_rest(), {0.0, 0.0, -9.81});
  LaneArray base(6);
  for (int k = 0; k < 30; ++k) step(first, block, force_at(k), base);
  LaneContent content;
  LaneArchive out = LaneArchive::out_of(kLane, content);
  first.archive(out);
  LaneArchive into = LaneArchive::into(kLane, content);
  second.archive(into);
  for (int k = 30; k < kSteps; ++k) {
    for (BodyLanes* lanes : {&first, &second}) step(*lanes, block, force_at(k), base);
    for (std::size_t i = 0; i < first.u().rows(); ++i) {
      ASSERT_EQ(second.u().at(i, kLane), first.u().at(i, kLane)) << "step " << k << ", row " << i;
    }
  }
}

TEST(NodeCompliance, ColumnsAreTheAnswerOfAllOfTheBody) {
  const Pushed block = pushed_block(Answer::by_product);
  const SingleMatrix& columns = block.compliance.columns;
  const std::size_t size = columns.rows(), m = block.particle.size();
  ASSERT_EQ(columns.columns(), 3 * m);
  double largest = 0.0;
  LaneArray unit(size);
  for (std::size_t k = 0; k < 3 * m; ++k) {
    const std::size_t freedom = 3 * static_cast<std::size_t>(block.particle[k / 3]) + k % 3;
    unit.at(static_cast<std::size_t>(block.model.slot[freedom]), static_cast<int>(k)) = 1.0;
  }
  solve_forward(block.model.factor, unit.data());
  solve_backward(block.model.factor, unit.data());
  for (std::size_t i = 0; i < size; ++i) largest = std::max(largest, std::abs(unit.at(i, 0)));
  for (std::size_t k = 0; k < 3 * m; ++k) {
    for (std::size_t i = 0; i < size; ++i) {
      // Rounded once.
      ASSERT_NEAR(columns.at(i, k), unit.at(i, static_cast<int>(k)), 1e-7 * largest) << i << ", " << k;
    }
  }
  // The same times forces that differ from lane to lane, two rows of them left out, added to what is there.
  SingleArray force(3 * m), y(size);
  const std::vector<int> listed = {0, 2, 3, 5};
  for (std::size_t k = 0; k < 3 * m; ++k) {
    for (int lane = 0; lane < kLanes; ++lane)
      force.row(k)[lane] = static_cast<float>(1 + lane) / static_cast<float>(k + 3);
  }
  for (std::size_t i = 0; i < size; ++i) std::fill_n(y.row(i), kLanes, static_cast<float>(largest));
  add_product(columns, listed, force, Mask(true), y);
  for (std::size_t i = 0; i < size; ++i) {
    for (int lane = 0; lane < kLanes; ++lane) {
      double sum = largest;
      for (const int k : listed)
        sum += columns.at(i, static_cast<std::size_t>(k)) *
               static_cast<double>(force.row(static_cast<std::size_t>(k))[lane]);
      ASSERT_NEAR(static_cast<double>(y.row(i)[lane]), sum, 1e-5 * largest) << i << ", lane " << lane;
    }
  }
}

}  // namespace
}  // namespace unbruised
