#include "core/contact/stuck_patches.hpp"

#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "core/algebra/lane_solve.hpp"
#include "core/algebra/supernodal_cholesky.hpp"
#include "core/contact/candidate_forces.hpp"

namespace unbruised {
namespace {

/// One for each lane, so that lanes that differ in all do not drive each other out.
constexpr std::size_t kMostPatches = kLanes;
/// Each leaves less of what it takes than the layers are off.
constexpr int kMostSolves = 6;
/// Changes below that share of the largest force are left to sweeps, which make them good in one or two.
constexpr double kEnough = 1e-7;

/// With two bits, off by an eighth at most: more bits save a solve now and then, and ask for more factors.
Lane few_bits(const Lane& x) {
  const Lane much = x * Lane(0x1p50);
  return (x + much) - much;
}

std::size_t row_of(std::size_t candidate, std::size_t of) { return 2 * candidate + (of > 0 ? 1 : 0); }

}  // namespace

StuckPatches::StuckPatches(const ContactModel& model)
    : model_(model),
      few_bits_(2 * model.candidate.size()),
      x_(kForces * model.candidate.size()),
      sum_(kForces * model.candidate.size()) {}

Lane StuckPatches::solve(std::span<const int> near, const LaneArray& give, const PatchModes::Fingers& fingers,
                         const Mask& lanes, const Lane& largest_force_N, LaneArray& rows) {
  list(near, give);
  Mask left = lanes & (count_ <= Lane(kMostContacts));
  Lane solves(0.0);
  const auto take = [&](const Patch& patch) {
    const Mask here = left & fits(patch, near);
    left = left & !here;
    if (any(here) && patch.factor.size > 0) solves += solve(patch, give, fingers, here, largest_force_N, rows);
    return any(here);
  };
  for (auto patch = patch_.begin(); patch != patch_.end() && any(left);) {
    const auto next = std::next(patch);
    if (take(*patch)) patch_.splice(patch_.begin(), patch_, patch);
    patch = next;
  }
  for (int lane = 0; lane < kLanes && any(left); ++lane) {
    if (!left[lane]) continue;
    if (patch_.size() == kMostPatches) patch_.pop_back();
    patch_.push_front(make(near, lane));
    take(patch_.front());
    left.set(lane, false);
  }
  return solves;
}

/// Takes in what the lanes ask for.
void StuckPatches::list(std::span<const int> near, const LaneArray& give) {
  count_ = Lane(0.0);
  for (const int at : near) {
    const auto c = static_cast<std::size_t>(at);
    for (std::size_t of = 0; of < 2; ++of) few_bits_.put(row_of(c, of), few_bits(give.get(kForces * c + of)));
    count_ += select(few_bits_.get(row_of(c, 0)) > Lane(0.0), Lane(1.0), Lane(0.0));
  }
}

Mask StuckPatches::fits(const Patch& patch, std::span<const int> near) const {
  Mask same = count_ == Lane(static_cast<double>(patch.candidate.size()));
  for (const int at : near) {
    const auto c = static_cast<std::size_t>(at);
    for (std::size_t of = 0; of < 2; ++of) {
      same = same & (few_bits_.get(row_of(c, of)) == Lane(patch.give[row_of(c, of)]));
    }
    if (none(same)) break;
  }
  return same;
}

StuckPatches::Patch StuckPatches::make(std::span<const int> near, int lane) const {
  Patch patch;
  patch.give.assign(2 * model_.candidate.size(), 0.0);
  for (const int at : near) {
    const auto c = static_cast<std::size_t>(at);
    if (!(few_bits_.at(row_of(c, 0), lane) > 0.0)) continue;
    patch.candidate.push_back(at);
    for (std::size_t of = 0; of < 2; ++of) patch.give[row_of(c, of)] = few_bits_.at(row_of(c, of), lane);
  }
  factor(patch);
  return patch;
}

void StuckPatches::factor(Patch& patch) const {
  const std::size_t size = patch.freedoms(), m = model_.node_count();
  SymmetricMatrix matrix;
  matrix.size = static_cast<int>(size);
  matrix.column_start.push_back(0);
  for (std::size_t column = 0; column < size; ++column) {
    const auto c = static_cast<std::size_t>(patch.candidate[column / kForces]);
    const std::size_t of = column % kForces;
    const ContactCandidate& from = member(patch, column / kForces);
    for (std::size_t row = column; row < size; ++row) {
      const ContactCandidate& to = member(patch, row / kForces);
      const std::size_t block =
          static_cast<std::size_t>(to.contact_node) * m + static_cast<std::size_t>(from.contact_node);
      const double compliance = model_.compliance[9 * block + 3 * axis_of(to, row % kForces) + axis_of(from, of)];
      matrix.row.push_back(static_cast<int>(row));
      matrix.value.push_back(sign_of(to, row % kForces) * sign_of(from, of) * compliance +
                             (row == column ? patch.give[row_of(c, of)] : 0.0));
    }
    matrix.column_start.push_back(static_cast<int>(matrix.row.size()));
  }
  std::string error;
  std::optional<SupernodalFactor> factor = factor_as_it_stands(matrix, error);
  if (!factor) return;
  patch.factor = std::move(*factor);
  LaneArray x(size);
  const auto surface = [&](std::size_t i) { return member(patch, i).surface; };
  for (std::size_t i = 0; i < patch.candidate.size(); ++i) {
    if (is_pad(surface(i))) x.at(kForces * i, static_cast<int>(finger_of(surface(i)))) = 1.0;
  }
  const Mask all(true);
  solve_forward(patch.factor, x.data(), all);
  solve_backward(patch.factor, x.data(), all);
  patch.factor.round_values();
  patch.factor.keep_rounded_values_only();
  for (std::size_t pad = 0; pad < kJawFingers; ++pad) {
    for (std::size_t row = 0; row < size; ++row) patch.by_pad[pad].push_back(x.at(row, static_cast<int>(pad)));
    for (std::size_t i = 0; i < patch.candidate.size(); ++i) {
      if (is_pad(surface(i))) patch.pads_by_pad[finger_of(surface(i))][pad] += patch.by_pad[pad][kForces * i];
    }
  }
}

/// Solves, and again for what the layers' compliance is off.
Lane StuckPatches::solve(const Patch& patch, const LaneArray& give, const PatchModes::Fingers& fingers,
                         const Mask& lanes, const Lane& largest_force_N, LaneArray& rows) {
  const std::size_t contacts = patch.candidate.size();
  const auto row = [&](std::size_t i, std::size_t of) {
    return kForces * static_cast<std::size_t>(patch.candidate[i]) + of;
  };
  for (std::size_t i = 0; i < contacts; ++i) {
    for (std::size_t of = 0; of < kForces; ++of) {
      put_rounded(x_, kForces * i + of, rows.get(row(i, of)));
      sum_.put(kForces * i + of, Lane(0.0));
    }
  }
  Lane solves(0.0);
  Mask open = lanes;
  for (int round = 0; round < kMostSolves && any(open); ++round) {
    solve_once(patch, fingers, open);
    solves += select(open, Lane(1.0), Lane(0.0));
    Lane change(0.0);
    for (std::size_t i = 0; i < contacts; ++i) {
      for (std::size_t of = 0; of < kForces; ++of) {
        const std::size_t at = kForces * i + of;
        const Lane by = get_widened(x_, at);
        sum_.put(at, sum_.get(at) + select(open, by, Lane(0.0)));
        change = max(change, abs(by));
        const Lane off =
            Lane(patch.give[row_of(static_cast<std::size_t>(patch.candidate[i]), of)]) - give.get(row(i, of));
        put_rounded(x_, at, off * by);
      }
    }
    open = open & (change > Lane(kEnough) * largest_force_N);
  }
  for (std::size_t i = 0; i < contacts; ++i) {
    for (std::size_t of = 0; of < kForces; ++of) {
      rows.put(row(i, of), select(lanes, sum_.get(kForces * i + of), rows.get(row(i, of))));
    }
  }
  return solves;
}

/// x_ becomes (W + D + E G E')^-1 x_, by the rank of the fingers.
void StuckPatches::solve_once(const Patch& patch, const PatchModes::Fingers& fingers, const Mask& lanes) {
  static_assert(kJawFingers == 2);
  solve_forward(patch.factor, x_.data(), lanes);
  solve_backward(patch.factor, x_.data(), lanes);
  std::array<Lane, 2> sum = {Lane(0.0), Lane(0.0)};
  for (std::size_t i = 0; i < patch.candidate.size(); ++i) {
    const int surface = member(patch, i).surface;
    if (is_pad(surface)) sum[finger_of(surface)] += get_widened(x_, kForces * i);
  }
  std::array<std::array<Lane, 2>, 2> matrix;  // 1 + G E' (W + D)^-1 E
  std::array<Lane, 2> given;                  // G E' x
  for (std::size_t p = 0; p < 2; ++p) {
    for (std::size_t q = 0; q < 2; ++q) {
      matrix[p][q] = Lane(p == q ? 1.0 : 0.0) + fingers[p][0] * Lane(patch.pads_by_pad[0][q]) +
                     fingers[p][1] * Lane(patch.pads_by_pad[1][q]);
    }
    given[p] = fingers[p][0] * sum[0] + fingers[p][1] * sum[1];
  }
  const Lane inverse = Lane(1.0) / (matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]);
  const std::array<Lane, 2> back = {(matrix[1][1] * given[0] - matrix[0][1] * given[1]) * inverse,
                                    (matrix[0][0] * given[1] - matrix[1][0] * given[0]) * inverse};
  for (std::size_t row = 0; row < patch.freedoms(); ++row) {
    put_rounded(
        x_, row,
        get_widened(x_, row) - Lane(patch.by_pad[0][row]) * back[0] - Lane(patch.by_pad[1][row]) * back[1]);
  }
}

}  // namespace unbruised
