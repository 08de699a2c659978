#pragma once

/// @file
/// The profile of a solid of revolution: its squared radius over the height, a cubic spline through the given
/// points (twice continuously differentiable, not-a-knot). So written, a sphere and an ellipsoid are met exactly,
/// and a round end needs no infinite slope: q = r^2 leaves the axis with twice the radius of curvature. Three
/// points or more in a row with one radius are a straight wall, at whose ends the curve is once continuously
/// differentiable.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace unbruised {

/// c0 + c1 x + c2 x^2 + c3 x^3
struct Cubic {
  std::array<double, 4> c{};
  [[nodiscard]] double at(double x) const { return c[0] + x * (c[1] + x * (c[2] + x * c[3])); }
  [[nodiscard]] double slope(double x) const { return c[1] + x * (2.0 * c[2] + x * 3.0 * c[3]); }
};

/// The first x on the way from one place to another, up or down, at which the cubic is not positive.
std::optional<double> first_not_positive(const Cubic& cubic, double from, double to);

/// What is wrong with a list of heights and radii.
struct ProfileFault {
  bool of_heights = false;  ///< else of the radii
  std::string value;
  std::string rule;
};
/// None: nothing is.
std::optional<ProfileFault> profile_fault(const std::vector<double>& heights, const std::vector<double>& radii);

class ProfileCurve {
 public:
  /// A stretch between two of the points.
  struct Piece {
    double start = 0, length = 0;
    Cubic q;  ///< of the way from the start
  };

  /// Stretched so that it reaches from -length / 2 to length / 2 and is `widest` from the axis.
  /// @param heights, radii without fault
  ProfileCurve(const std::vector<double>& heights, const std::vector<double>& radii, double length, double widest);

  [[nodiscard]] double low() const { return piece_.front().start; }
  [[nodiscard]] double high() const { return piece_.back().start + piece_.back().length; }
  /// Squared radius and its slope; outside the ends those of the ends.
  [[nodiscard]] double q(double height) const;
  [[nodiscard]] double slope(double height) const;
  [[nodiscard]] const std::vector<Piece>& pieces() const { return piece_; }
  /// Middle of the stretch that is within a thousandth as wide as the widest place.
  [[nodiscard]] double widest_m() const { return widest_m_; }
  /// The lowest and the highest place that is as wide; none: no place is.
  [[nodiscard]] std::optional<double> first_as_wide(double squared_radius) const;
  [[nodiscard]] std::optional<double> last_as_wide(double squared_radius) const;

 private:
  [[nodiscard]] const Piece& piece_at(double height) const;

  std::vector<Piece> piece_;
  double widest_m_ = 0;
};

}  // namespace unbruised
