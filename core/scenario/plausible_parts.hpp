#pragma once

/// @file
/// What the rows of plausible ranges are made of, and the rows of each part of a scenario.

#include <string_view>
#include <vector>

#include "core/scenario/number_fields.hpp"
#include "core/scenario/plausible.hpp"

namespace unbruised::plausible {

using Slips = std::vector<UnitSlip>;
using Rows = std::vector<PlausibleRow>;

inline const Slips kLength = {{1e3, "millimetres taken for metres"}, {1e2, "centimetres taken for metres"}};
inline const Slips kMass = {{1e3, "grams taken for kilograms"}};
inline const Slips kStress = {{1e-6, "MPa taken for Pa"}, {1e-3, "kPa taken for Pa"}, {1e-9, "GPa taken for Pa"}};
inline const Slips kForce = {{1e3, "millinewtons taken for newtons"}, {102.0, "grams of force taken for newtons"}};
inline const Slips kSpeed = {{1e3, "mm/s taken for m/s"}, {60.0, "m/min taken for m/s"}};
inline const Slips kAcceleration = {{1e3, "mm/s2 taken for m/s2"},
                                    {1.0 / 9.80665, "multiples of g taken for m/s2"}};
inline const Slips kTime = {{1e3, "milliseconds taken for seconds"}};
inline const Slips kFraction = {{1e2, "per cent taken for a fraction"}};
inline const Slips kAngle = {{57.29577951308232, "degrees taken for radians"}};
inline const Slips kEnergy = {{1e3, "millijoules taken for joules"}};
inline const Slips kVolume = {{1e9, "mm3 taken for m3"}, {1e6, "cm3 taken for m3"}};

/// A row about the numbers of one field, by their size.
PlausibleRow plain(std::string_view path, std::string_view quantity, std::string_view unit, double low,
                   double high, Slips slips, std::string_view source);

/// The product, which has to be a lattice.
inline const LatticeParameters& lattice_of(const Scenario& s) { return std::get<LatticeParameters>(s.product); }

Rows product_rows();
Rows gripper_rows();
Rows cell_rows();
Rows sensor_rows();
Rows strategy_rows();
Rows limit_rows();
Rows robot_rows();

}  // namespace unbruised::plausible
