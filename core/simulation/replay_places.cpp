#include "core/simulation/replay_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scenario/vectors.hpp"

namespace unbruised {
namespace {

using Place = std::array<double, 3>;

/// Where a place is in a box of one cell: 0 to 1 along each axis, and how far it is from it.
struct InCell {
  Place part;
  double distance_m;
};

InCell in_cell(const Lattice& lattice, std::size_t cell, const Place& place_m) {
  const Place& low = lattice.position_m[static_cast<std::size_t>(lattice.cell[cell][0])];
  InCell found{{}, 0.0};
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = (place_m[i] - low[i]) / lattice.cell_extent_m[i];
    found.part[i] = std::clamp(part, 0.0, 1.0);
    const double off_m = (part - found.part[i]) * lattice.cell_extent_m[i];
    square += off_m * off_m;
  }
  found.distance_m = std::sqrt(square);
  return found;
}

}  // namespace

VertexWeights::VertexWeights(const Lattice& lattice, std::span<const Place> place_m) {
  for (const Place& place : place_m) {
    std::size_t nearest = 0;
    InCell best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t cell = 0; cell < lattice.cell.size() && best.distance_m > 0.0; ++cell) {
      const InCell here = in_cell(lattice, cell, place);
      if (here.distance_m >= best.distance_m) continue;
      best = here;
      nearest = cell;
    }
    std::array<double, 8> weight{};
    for (std::size_t corner = 0; corner < 8; ++corner) {
      weight[corner] = 1.0;
      for (std::size_t i = 0; i < 3; ++i) {
        weight[corner] *= ((corner >> i) & 1U) != 0 ? best.part[i] : 1.0 - best.part[i];
      }
    }
    corner_.push_back(lattice.cell[nearest]);
    weight_.push_back(weight);
  }
}

VertexWeights::VertexWeights(std::size_t particles) {
  for (std::size_t p = 0; p < particles; ++p) {
    std::array<int, 8> corner{};
    corner.fill(static_cast<int>(p));
    corner_.push_back(corner);
    weight_.push_back({1.0});
  }
}

double VertexWeights::at(std::size_t vertex, std::span<const double> values, std::size_t width,
                         std::size_t component) const {
  double sum = 0.0;
  for (std::size_t c = 0; c < 8; ++c) {
    sum += weight_[vertex][c] * values[width * static_cast<std::size_t>(corner_[vertex][c]) + component];
  }
  return sum;
}

VertexContacts::VertexContacts(const ContactModel& contact, const BodyModel& body,
                               std::span<const Place> place_m) {
  near_.resize(place_m.size());
  if (!body.lattice) return;
  const Place& extent_m = body.lattice->cell_extent_m;
  const double radius_m = 1.2 * std::max({extent_m[0], extent_m[1], extent_m[2]});
  for (std::size_t c = 0; c < contact.candidate.size(); ++c) {
    if (!(contact.candidate[c].area_m2 > 0.0)) continue;
    const Place at = rest_place_m(contact, body, c);
    for (std::size_t v = 0; v < place_m.size(); ++v) {
      const Place off = {place_m[v][0] - at[0], place_m[v][1] - at[1], place_m[v][2] - at[2]};
      const double weight = 1.0 - length(off) / radius_m;
      if (weight > 0.0) near_[v].push_back({static_cast<int>(c), contact.candidate[c].surface, weight});
    }
  }
}

double VertexContacts::mean(std::size_t vertex, int surface, std::span<const double> of_candidate) const {
  double sum = 0.0, weights = 0.0;
  for (const Near& near : near_[vertex]) {
    if (near.surface != surface) continue;
    sum += near.weight * of_candidate[static_cast<std::size_t>(near.candidate)];
    weights += near.weight;
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

std::array<double, 3> rest_place_m(const ContactModel& contact, const BodyModel& body, std::size_t c) {
  const ContactCandidate& candidate = contact.candidate[c];
  Place place = body.position_m[static_cast<std::size_t>(candidate.node)];
  if (candidate.place >= 0) {
    const Place& arm_m = contact.place[static_cast<std::size_t>(candidate.place)].arm_m;
    for (std::size_t i = 0; i < 3; ++i) place[i] += arm_m[i];
    return place;
  }
  if (!body.lattice) return place;
  place[static_cast<std::size_t>(normal_axis(candidate.surface))] = candidate.surface_m;
  return place;
}

}  // namespace unbruised
