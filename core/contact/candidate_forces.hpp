#pragma once

/// @file
/// The three forces of a candidate, N, T1, T2, on the freedoms of its node: `of` counts them from 0.

#include <cstddef>

#include "core/contact/contact_model.hpp"
#include "core/surface/surfaces.hpp"

namespace unbruised {

/// Along which axis one of them acts.
inline std::size_t axis_of(const ContactCandidate& candidate, std::size_t of) {
  return static_cast<std::size_t>(of == 0 ? normal_axis(candidate.surface)
                                          : tangent_axes(candidate.surface)[of - 1]);
}
/// And which way.
inline double sign_of(const ContactCandidate& candidate, std::size_t of) {
  return of == 0 ? normal_sign(candidate.surface) : 1.0;
}

}  // namespace unbruised
