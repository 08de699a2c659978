#include "core/contact/patch_modes.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/candidate_forces.hpp"
#include "core/door/require.hpp"
#include "core/lanes/lane_packs.hpp"

namespace unbruised {
namespace {

/// A mode of which no more than this is its own is a sum of the others.
constexpr double kOwnPart = 1e-6;
/// Fewer members than so many have no modes, or no more than the net force. Where modes are as many as contacts
/// nothing is left for those to do.
constexpr double kLeastForNet = 4.0, kLeastForShapes = 9.0;
/// A contact's own force moves by at most so many times the change that is wanted, over one.
constexpr double kLeastKept = 0.25;

/// From where to where a face reaches along an axis.
struct FaceStretch {
  double low_m = HUGE_VAL, high_m = -HUGE_VAL;

  void take_in(double place_m) {
    low_m = std::min(low_m, place_m);
    high_m = std::max(high_m, place_m);
  }
  /// -1 to 1.
  [[nodiscard]] double from_middle(double place_m) const {
    return high_m > low_m ? 2.0 * (place_m - low_m) / (high_m - low_m) - 1.0 : 0.0;
  }
};

}  // namespace

PatchModes::PatchModes(const ContactModel& model) : model_(model) {
  std::array<std::array<FaceStretch, 2>, kFirstCellSurface> face;
  for (const ContactCandidate& candidate : model.candidate) {
    require(candidate.surface < kFirstCellSurface && candidate.place < 0,
            "PatchModes: the model has more than the pads of a jaw and the support");
    surface_.push_back(static_cast<std::size_t>(candidate.surface));
    for (std::size_t t = 0; t < 2; ++t) face[surface_.back()][t].take_in(candidate.tributary[t].place_m);
  }
  for (std::size_t c = 0; c < model.candidate.size(); ++c) {
    Shape shape = {1.0, 0.0, 0.0};
    for (std::size_t t = 0; t < 2; ++t) {
      shape[1 + t] = face[surface_[c]][t].from_middle(model.candidate[c].tributary[t].place_m);
    }
    shape_.push_back(shape);
  }
  const std::size_t forces = kForces * model.candidate.size();
  weight_ = stood_ = LaneArray(2 * model.candidate.size());
  moves_ = LaneArray(kModes * 3 * model.node_count());
  matrix_ = work_ = LaneArray(kModes * kModes);
  answer_ = LaneArray(kModes * forces);
  inverse_kept_ = answered_ = given_ = LaneArray(forces);
  moved_.fill(Mask(true));
  inverse_pivot_.fill(Lane(0.0));
  for (auto& each : net_) each.fill(Lane(0.0));
  clear();
}

std::size_t PatchModes::moved_row(std::size_t c, std::size_t of) const {
  const ContactCandidate& candidate = model_.candidate[c];
  return kModes * (3 * static_cast<std::size_t>(candidate.contact_node) + axis_of(candidate, of));
}

void PatchModes::list(std::span<const int> active_node, std::span<const int> near_candidate) {
  if (!std::ranges::equal(node_, active_node) || !std::ranges::equal(near_, near_candidate)) {
    stale_ = Mask(true);
    moved_.fill(Mask(true));
  }
  node_.assign(active_node.begin(), active_node.end());
  for (const int c : near_) set_member(static_cast<std::size_t>(c), Mask(false), Mask(false));
  near_.assign(near_candidate.begin(), near_candidate.end());
  first_ = kModes;
  end_ = 0;
  for (const int c : near_) {
    const std::size_t surface = surface_[static_cast<std::size_t>(c)];
    first_ = std::min(first_, kPerSurface * surface);
    end_ = std::max(end_, kPerSurface * (surface + 1));
  }
}

void PatchModes::set_member(std::size_t c, const Mask& pressed, const Mask& sticks) {
  weight_.put(weight_row(c, 0), select(pressed, Lane(1.0), Lane(0.0)));
  weight_.put(weight_row(c, 1), select(sticks, Lane(1.0), Lane(0.0)));
}

/// Finds lanes for which what was prepared does not hold any more.
void PatchModes::note_changes(const LaneArray& give, const Fingers& fingers) {
  const auto differ = [](const Lane& a, const Lane& b) { return !(a == b); };
  for (std::size_t c = 0; c < surface_.size(); ++c) {
    for (std::size_t row = 2 * c; row < 2 * c + 2; ++row) {
      const Mask other = differ(weight_.get(row), stood_.get(row));
      moved_[surface_[c]] = moved_[surface_[c]] | other;
      stale_ = stale_ | other;
    }
  }
  for (const int near : near_) {
    for (std::size_t of = 0; of < kForces; ++of) {
      const auto c = static_cast<std::size_t>(near);
      const std::size_t row = kForces * c + of;
      const Lane layer = select(weight_.get(weight_row(c, of)) > Lane(0.0), give.get(row), Lane(0.0));
      stale_ = stale_ | differ(layer, given_.get(row));
      given_.put(row, layer);
    }
  }
  for (std::size_t p = 0; p < kJawFingers; ++p) {
    for (std::size_t q = 0; q < kJawFingers; ++q) stale_ = stale_ | differ(fingers[p][q], fingers_[p][q]);
  }
  fingers_ = fingers;
}

void PatchModes::prepare(const Mask& lanes, const LaneArray& give, const Fingers& fingers) {
  note_changes(give, fingers);
  const Mask renewed = lanes & stale_;
  if (none(renewed)) return;
  for (std::size_t surface = first_ / kPerSurface; surface < end_ / kPerSurface; ++surface) {
    if (any(renewed & moved_[surface])) find_moves(surface, renewed & moved_[surface]);
    moved_[surface] = moved_[surface] & !renewed;
  }
  for (std::size_t row = 0; row < weight_.rows(); ++row) {
    stood_.put(row, select(renewed, weight_.get(row), stood_.get(row)));
  }
  find_matrix(renewed);
  find_answers(renewed);
  stale_ = stale_ & !renewed;
}

/// W Z of the present members of a surface.
void PatchModes::find_moves(std::size_t surface, const Mask& lanes) {
  const std::size_t m = model_.node_count();
  const NarrowPacks packs(lanes);
  const auto at_node = [&](std::size_t node, int first) {
    std::array<std::array<NarrowPack, kPerSurface>, 3> sum;
    for (auto& row : sum) row.fill(NarrowPack(0.0));
    for (const int near : near_) {
      const auto c = static_cast<std::size_t>(near);
      if (surface_[c] != surface) continue;
      const ContactCandidate& candidate = model_.candidate[c];
      const double* block =
          model_.compliance.data() + 9 * (node * m + static_cast<std::size_t>(candidate.contact_node));
      for (std::size_t of = 0; of < kForces; ++of) {
        const NarrowPack weight = get_pack(weight_, weight_row(c, of), first);
        for (std::size_t row = 0; row < 3; ++row) {
          const NarrowPack by =
              NarrowPack(block[3 * row + axis_of(candidate, of)] * sign_of(candidate, of)) * weight;
          for (std::size_t f = 0; f < kShapes; ++f) sum[row][kShapes * of + f] += by * NarrowPack(shape_[c][f]);
        }
      }
    }
    const PackMask renewed = narrow(lanes, first);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < kPerSurface; ++k) {
        const std::size_t at = kModes * (3 * node + row) + kPerSurface * surface + k;
        put_pack(moves_, at, select(renewed, sum[row][k], get_pack(moves_, at, first)), first);
      }
    }
  };
  for (const int node : node_) {
    packs.each([&](int first) { at_node(static_cast<std::size_t>(node), first); });
  }
}

/// Z' A Z and its factor.
void PatchModes::find_matrix(const Mask& lanes) {
  work_.fill(0.0);
  const auto add = [&](std::size_t row, std::size_t column, const Lane& value) {
    const std::size_t at = kModes * row + column;
    work_.put(at, work_.get(at) + value);
  };
  Members members;
  std::array<std::array<Lane, kShapes>, kJawFingers> net;
  for (auto& each : members) each.fill(Lane(0.0));
  for (auto& each : net) each.fill(Lane(0.0));
  for (const int near : near_) {
    const auto c = static_cast<std::size_t>(near);
    for (std::size_t of = 0; of < kForces; ++of) {
      const Lane weight = weight_.get(weight_row(c, of));
      if (none(weight > Lane(0.0))) continue;
      if (of < 2) members[surface_[c]][of] += weight;
      const std::size_t own = first_mode(c, of), moved = moved_row(c, of);
      const Lane layer = given_.get(kForces * c + of);
      const Lane sign(sign_of(model_.candidate[c], of));
      for (std::size_t f = 0; f < kShapes; ++f) {
        const Lane z = Lane(shape_[c][f]) * weight;
        if (of == 0 && surface_[c] < kJawFingers) net[surface_[c]][f] += z;
        for (std::size_t column = first_; column <= own + f; ++column) {
          add(own + f, column, sign * z * moves_.get(moved + column));
        }
        for (std::size_t g = 0; g <= f; ++g) add(own + f, own + g, layer * z * Lane(shape_[c][g]));
      }
    }
  }
  for (std::size_t p = 0; p < kJawFingers; ++p) {
    for (std::size_t q = 0; q <= p; ++q) {
      for (std::size_t f = 0; f < kShapes; ++f) {
        for (std::size_t g = 0; g < (q < p ? kShapes : f + 1); ++g) {
          add(kPerSurface * p + f, kPerSurface * q + g, net[p][f] * fingers_[p][q] * net[q][g]);
        }
      }
    }
  }
  for (std::size_t pad = 0; pad < kJawFingers; ++pad) {
    for (std::size_t f = 0; f < kShapes; ++f) net_[pad][f] = select(lanes, net[pad][f], net_[pad][f]);
  }
  factor(lanes, members);
}

/// Cholesky; modes that there are too few members for are left out.
void PatchModes::factor(const Mask& lanes, const Members& members) {
  for (std::size_t j = first_; j < end_; ++j) {
    const std::size_t of = j % kPerSurface / kShapes;
    const bool is_net = j % kShapes == 0;
    const Lane diagonal = work_.get(kModes * j + j);
    Lane pivot = diagonal;
    for (std::size_t k = first_; k < j; ++k) {
      const Lane l = work_.get(kModes * j + k);
      pivot -= l * l;
    }
    const Lane count = members[j / kPerSurface][of > 0 ? 1 : 0];
    const Mask kept =
        (pivot > Lane(kOwnPart) * diagonal) & (count >= Lane(is_net ? kLeastForNet : kLeastForShapes));
    const Lane inverse = select(kept, Lane(1.0) / sqrt(max(pivot, Lane(1e-300))), Lane(0.0));
    inverse_pivot_[j] = select(lanes, inverse, inverse_pivot_[j]);
    for (std::size_t i = j + 1; i < end_; ++i) {
      const std::size_t at = kModes * i + j;
      Lane l = work_.get(at);
      for (std::size_t k = first_; k < j; ++k) l -= work_.get(kModes * i + k) * work_.get(kModes * j + k);
      work_.put(at, l * inverse);
      matrix_.put(at, select(lanes, work_.get(at), matrix_.get(at)));
    }
  }
}

void PatchModes::solve(Amplitudes& x) const {
  for (std::size_t i = first_; i < end_; ++i) {
    Lane sum = x[i];
    for (std::size_t k = first_; k < i; ++k) sum -= matrix_.get(kModes * i + k) * x[k];
    x[i] = sum * inverse_pivot_[i];
  }
  for (std::size_t i = end_; i-- > first_;) {
    x[i] *= inverse_pivot_[i];
    for (std::size_t k = first_; k < i; ++k) x[k] -= matrix_.get(kModes * i + k) * x[i];
  }
}

/// What every force of a candidate makes the modes do, and what that leaves it.
void PatchModes::find_answers(const Mask& lanes) {
  for (const int near : near_) {
    const auto c = static_cast<std::size_t>(near);
    const std::size_t surface = surface_[c];
    for (std::size_t of = 0; of < kForces; ++of) {
      const std::size_t at = kForces * c + of, own = first_mode(c, of), moved = moved_row(c, of);
      const Lane sign(sign_of(model_.candidate[c], of)), weight = weight_.get(weight_row(c, of));
      Amplitudes by_modes, x;
      for (std::size_t m = first_; m < end_; ++m) by_modes[m] = sign * moves_.get(moved + m);
      for (std::size_t pad = 0; of == 0 && surface < kJawFingers && pad < kJawFingers; ++pad) {
        for (std::size_t f = 0; f < kShapes; ++f)
          by_modes[kPerSurface * pad + f] += fingers_[surface][pad] * net_[pad][f];
      }
      for (std::size_t m = first_; m < end_; ++m) x[m] = by_modes[m];
      const Lane layer = given_.get(at);
      for (std::size_t f = 0; f < kShapes; ++f) x[own + f] += layer * Lane(shape_[c][f]);
      solve(x);
      Lane answered(0.0), kept(1.0);
      for (std::size_t m = first_; m < end_; ++m) {
        answer_.put(kModes * at + m, select(lanes, x[m], answer_.get(kModes * at + m)));
        answered += by_modes[m] * x[m];
      }
      for (std::size_t f = 0; f < kShapes; ++f) kept -= weight * Lane(shape_[c][f]) * x[own + f];
      const Lane inverse = Lane(1.0) / max(kept, Lane(kLeastKept));
      inverse_kept_.put(at, select(lanes, inverse, inverse_kept_.get(at)));
      answered_.put(at, select(lanes, answered, answered_.get(at)));
    }
  }
}

void PatchModes::start_residual(const LaneArray& node_force) {
  for (std::size_t surface = first_ / kPerSurface; surface < end_ / kPerSurface; ++surface) {
    std::array<Lane, kPerSurface> sum;
    sum.fill(Lane(0.0));
    for (const int node : node_) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t freedom = 3 * static_cast<std::size_t>(node) + axis;
        const Lane force = node_force.get(freedom);
        const double* row = moves_.row(kModes * freedom + kPerSurface * surface);
        for (std::size_t k = 0; k < kPerSurface; ++k) sum[k] -= load(row + k * kLanes) * force;
      }
    }
    for (std::size_t k = 0; k < kPerSurface; ++k) residual_[kPerSurface * surface + k] = sum[k];
  }
}

void PatchModes::add_residual(std::size_t c, std::size_t of, const Lane& lacks_m) {
  // Of others it may be anything.
  const Lane weight = weight_.get(weight_row(c, of));
  const Lane here = select(weight > Lane(0.0), lacks_m, Lane(0.0));
  const std::size_t own = first_mode(c, of);
  for (std::size_t f = 0; f < kShapes; ++f) residual_[own + f] += here * Lane(shape_[c][f]);
}

void PatchModes::take_residual(const Mask& lanes) {
  solve(residual_);
  for (std::size_t m = first_; m < end_; ++m) amplitude_[m] = select(lanes, residual_[m], Lane(0.0));
}

}  // namespace unbruised
