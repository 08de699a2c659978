#pragma once

/// @file
/// The faces of pads that are bodies as the product's candidates meet them where they stand at the start: the same
/// weights take a force to the pad's particles and their motion to the candidate, so that both bodies see equal
/// and opposite forces. All along the axes of the palm.

#include <array>
#include <vector>

#include "core/contact/tributary.hpp"
#include "core/gripper/pad_body.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

struct ContactModel;

struct PadFaces {
  struct Face {
    std::vector<int> candidate;  ///< of the contact model, ascending
    std::vector<int> first;      ///< candidate -> its first weight; one more than candidates
    std::vector<int> node;       ///< of each weight: particle of the face
    std::vector<double> weight;
    std::vector<double> compliance;  ///< 3x3 blocks over the candidates, as in ContactModel [m/N]
    /// How far the face stays behind per way that its finger closes within a step, 3 per candidate.
    std::vector<double> lag;
  };
  std::array<Face, kJawFingers> face;
  std::vector<int> place;  ///< candidate of the contact model -> its number in the face of its pad; -1: no pad's
};

/// @param middle_m of the pads along y and z, in the places of the product
PadFaces pad_faces(const ContactModel& contact, const PadBody& pad, const WilsonTheta& wilson,
                   const std::array<double, 2>& middle_m);

}  // namespace unbruised
