// The pieces of a face: what lies within a stretch adds up to it, in force and in moment.

#include "core/contact/tributary.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace unbruised {
namespace {

/// The particles of a face of 40 mm in cells of this many, from 0 to 40 mm.
std::vector<Tributary> face(int cells) {
  std::vector<Tributary> pieces;
  for (int i = 0; i <= cells; ++i) pieces.push_back({0.04 * i / cells, 0.04 / cells, false, {i, cells - i}});
  return pieces;
}

/// Round-off of sums of some ten lengths of centimetres.
constexpr double kSum = 1e-15;

TEST(Tributary, PiecesUnderAStretchAddUpToItInForceAndMoment) {
  const double starts[] = {-0.01, 0.0, 0.0031, 0.0175, 0.039}, ends[] = {0.0032, 0.02, 0.0333, 0.04, 0.07};
  for (const int cells : {1, 2, 5, 16}) {
    for (const double from : starts) {
      for (const double to : ends) {
        if (to <= from) continue;
        double force = 0.0, moment = 0.0, by_pieces = 0.0;
        for (const Tributary& piece : face(cells)) {
          const CoveredPiece covered = piece.covered_by({Lane(from), Lane(to)}, Lane(0.0));
          const double weight = covered.share[0] * full_weight_m(piece);
          EXPECT_NEAR(weight, piece.weight_m({Lane(from), Lane(to)}, Lane(0.0))[0], kSum);
          force += weight;
          moment += weight * piece.place_m;
          by_pieces += weight * (piece.place_m + covered.mean_m[0]);
        }
        const double low = std::max(from, 0.0), high = std::min(to, 0.04);
        EXPECT_NEAR(force, high - low, kSum) << cells << ": " << from << " to " << to;
        // Hat functions carry a line: acting at the particles, the moment is the same.
        EXPECT_NEAR(moment, 0.5 * (high * high - low * low), kSum);
        EXPECT_NEAR(by_pieces, 0.5 * (high * high - low * low), kSum);
      }
    }
  }
}

TEST(Tributary, SecondMomentsAreThoseOfTheStretch) {
  for (const int cells : {1, 3, 8}) {
    double second = 0.0;
    for (const Tributary& piece : face(cells)) {
      const CoveredPiece covered = piece.covered_by({Lane(0.007), Lane(0.031)}, Lane(0.0));
      const double y = piece.place_m;
      second += covered.share[0] * full_weight_m(piece) *
                (y * y + 2.0 * y * covered.mean_m[0] + covered.mean_square_m2[0]);
    }
    EXPECT_NEAR(second, (std::pow(0.031, 3) - std::pow(0.007, 3)) / 3.0, kSum) << cells;
  }
}

TEST(Tributary, AFullyCoveredPieceIsCoveredToTheLastBit) {
  for (const bool curved : {false, true}) {
    const Tributary piece{0.0123, 0.0077, curved, {1, curved ? 2 : 0}};
    const CoveredPiece covered = piece.covered_by({Lane(-1.0), Lane(1.0)}, Lane(0.0037));
    EXPECT_EQ(covered.share[0], 1.0);
    for (const Lane& place : covered.place) EXPECT_EQ(place[0], 1.0);
  }
}

TEST(Tributary, ACurvedPieceIsOneCellWideAndCutPlaceByPlace) {
  const Tributary piece{0.0, 0.004, true, {2, 2}};
  // Its places are 1 mm wide from -2 to 2 mm; the particle has moved by 1 mm.
  const CoveredPiece covered = piece.covered_by({Lane(0.0005), Lane(0.1)}, Lane(0.001));
  const double expected[] = {0.0, 0.5, 1.0, 1.0};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(covered.place[k][0], expected[k], 1e-12);
  EXPECT_NEAR(covered.share[0], 2.5 / 4.0, 1e-12);
}

TEST(Tributary, ThePiecesBesideAnEdgeAreSofterWithoutAJump) {
  const std::vector<Tributary> pieces = face(4);  // at 0, 10, 20, 30, 40 mm
  const auto covered = [&](std::size_t i, double to) {
    return pieces[i].covered_by({Lane(-1.0), Lane(to)}, Lane(0.0));
  };
  EXPECT_EQ(covered(1, 0.025).softness[0], 0.0) << "a cell and a half within";
  EXPECT_GT(covered(2, 0.021).softness[0], 0.0) << "a tenth of a cell within";
  EXPECT_GT(covered(3, 0.025).softness[0], covered(3, 0.029).softness[0]) << "the farther beyond, the softer";
  // A pad slides over a particle without a jump.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const double edge : {0.02, 0.025, 0.03, 0.04}) {
      const CoveredPiece before = covered(i, edge - 1e-9), after = covered(i, edge + 1e-9);
      EXPECT_NEAR(before.share[0], after.share[0], 1e-6) << i;
      EXPECT_NEAR(before.softness[0] * before.share[0], after.softness[0] * after.share[0], 1e-5) << i;
    }
  }
}

TEST(Tributary, ThereIsNoSoftnessWhereFaceAndSurfaceEndTogether) {
  for (const Tributary& piece : face(4)) {
    EXPECT_EQ(piece.covered_by({Lane(0.0), Lane(0.04)}, Lane(0.0)).softness[0], 0.0);
    EXPECT_EQ(piece.covered_by({Lane(-0.003), Lane(0.07)}, Lane(0.0)).softness[0], 0.0);
  }
}

TEST(Tributary, WindowsAddUpToWhatIsCovered) {
  for (const int cells : {1, 2, 4, 9}) {
    const Stretch covered{Lane(0.0033), Lane(0.0337)}, lower{Lane(0.0033), Lane(0.0201)},
        upper{Lane(0.0201), Lane(0.0337)};
    for (const Stretch& window : {lower, upper}) {
      double sum = 0.0;
      for (const Tributary& piece : face(cells)) {
        const Lane lower_part = piece.weight_m(lower, Lane(0.0));
        const Lane upper_part = piece.weight_m(upper, Lane(0.0));
        EXPECT_NEAR((lower_part + upper_part)[0], piece.weight_m(covered, Lane(0.0))[0], kSum) << cells;
        sum += piece.weight_m(window, Lane(0.0))[0];
      }
      EXPECT_NEAR(sum, (window.high - window.low)[0], kSum) << cells;
    }
  }
}

TEST(Tributary, WhatIsNotCoveredHasNoMiddle) {
  // A force of 0 at an infinite place is no number, and would reach a lane only when a neighbour looks at the
  // particle.
  for (const double to : {-0.5, 0.0, 1e-13}) {
    const CoveredPiece covered = face(4)[1].covered_by({Lane(-1.0), Lane(to)}, Lane(0.0));
    EXPECT_EQ(covered.share[0], 0.0);
    EXPECT_EQ(covered.mean_m[0], 0.0);
    EXPECT_EQ(covered.mean_square_m2[0], 0.0);
  }
}

TEST(Tributary, NothingIsCoveredBeyondTheRimOfTheFace) {
  const Tributary rim{0.04, 0.01, false, {2, 0}};
  EXPECT_EQ(rim.covered_by({Lane(0.04), Lane(0.05)}, Lane(0.0)).share[0], 0.0);
  EXPECT_EQ(rim.covered_by({Lane(0.0401), Lane(0.05)}, Lane(0.0)).share[0], 0.0);
  EXPECT_GT(rim.covered_by({Lane(0.0399), Lane(0.05)}, Lane(0.0)).share[0], 0.0);
}

}  // namespace
}  // namespace unbruised
