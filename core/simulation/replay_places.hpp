#pragma once

/// @file
/// Where the vertices of a replay's surface are in the product: in which cell, and near which contacts.

#include <array>
#include <span>
#include <vector>

#include "core/body/body_model.hpp"
#include "core/contact/contact_model.hpp"
#include "core/outcome/replay.hpp"

namespace unbruised {

/// Interpolates what the particles have at the vertices: linearly in the cell that holds a vertex, and beyond the
/// cells as on their nearest face, which is how contact places go with their particles.
class VertexWeights {
 public:
  VertexWeights() = default;
  /// @param place_m of the vertices, in the places of the lattice
  VertexWeights(const Lattice& lattice, std::span<const std::array<double, 3>> place_m);
  /// Each vertex is a particle.
  explicit VertexWeights(std::size_t particles);

  [[nodiscard]] double at(std::size_t vertex, std::span<const double> values, std::size_t width,
                          std::size_t component) const;
  [[nodiscard]] std::size_t vertex_count() const { return corner_.size(); }

 private:
  std::vector<std::array<int, 8>> corner_;
  std::vector<std::array<double, 8>> weight_;
};

/// Which contact candidates lie around each vertex, and how much each counts.
class VertexContacts {
 public:
  VertexContacts() = default;
  /// @param place_m of the vertices, in the places of the lattice
  VertexContacts(const ContactModel& contact, const BodyModel& body,
                 std::span<const std::array<double, 3>> place_m);

  /// Mean of a number of the candidates of one surface around a vertex; 0 where there are none.
  [[nodiscard]] double mean(std::size_t vertex, int surface, std::span<const double> of_candidate) const;

 private:
  struct Near {
    int candidate, surface;
    double weight;
  };
  std::vector<std::vector<Near>> near_;
};

/// Of a candidate on the true surface, at rest [m].
std::array<double, 3> rest_place_m(const ContactModel& contact, const BodyModel& body, std::size_t candidate);

}  // namespace unbruised
