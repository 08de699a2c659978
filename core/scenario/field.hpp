#pragma once

/// @file
/// What the table of fields says of each, and the ranges that several have.

#include <string_view>
#include <type_traits>

#include "core/scenario/attitude.hpp"
#include "core/scenario/product_parameters.hpp"
#include "core/scenario/range.hpp"

namespace unbruised {

/// What a field decides.
enum class Decides {
  model,  ///< the matrices, the contact model or their bits: it enters the factor key
  run,    ///< what happens to one scenario; lanes with one factor may differ in it
};

struct Field {
  std::string_view name;
  Decides decides;
  Range range = kAnyNumber;  ///< of each of its numbers
};

inline constexpr Range kIndex{.min = 0.0, .max = 2147483647.0};
inline constexpr Range kPoissonRatio{.min = 0.0, .max = 0.5, .max_open = true};
/// Below (1 + sqrt 3) / 2 Wilson's method is not unconditionally stable; above 3 it damps what is looked for.
inline constexpr Range kTheta{.min = 1.37, .max = 3.0};
inline constexpr Range kRubberPoissonRatio{.min = 0.0, .max = 0.5};
inline constexpr Range kTilt{.min = -kHalfTurn_rad, .max = kHalfTurn_rad};
/// Of a length that is 1 within 1e-6.
inline constexpr Range kQuaternion{.min = -1.000001, .max = 1.000001};
inline constexpr Range kPronyShare{.min = 0.0, .min_open = true, .max = 1.0};
inline constexpr Range kAccuracy{.min = 0.0, .max = 1.0, .max_open = true};
inline constexpr Range kDampingRatio{.min = 0.0, .max = 1.0, .max_open = true};

inline constexpr Range kExponent{.min = kLeastExponent, .max = kLargestExponent};
inline constexpr Range kUse{.min = 0.0, .min_open = true, .max = 1.0};

inline constexpr Range kHandlings{.min = 1.0, .max = 1000.0};
inline constexpr Range kModeCount{.min = 0.0, .max = 2000.0};

inline constexpr Range kRingElements{.min = 3.0, .max = 64.0};

/// Is T, const or not, the parameter struct S?
template <class T, class S>
concept FieldsOf = std::is_same_v<std::remove_const_t<T>, S>;

}  // namespace unbruised
