#include "core/scenario/profile_curve.hpp"

#include <algorithm>
#include <cmath>

#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr std::size_t kFewestPoints = 4, kMostPoints = 1000;
/// A place of q, the square of a radius, counts as widest within this share: a thousandth of the radius.
constexpr double kAsWide = 1.0 - 2e-3;

/// The points of q = r^2; a flat end is a point beside the axis.
struct Points {
  std::vector<double> height, q;
};

Points points_of(const std::vector<double>& heights, const std::vector<double>& radii) {
  Points points;
  const std::size_t count = heights.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_middle_of_flat_end =
        (i == 0 && heights[1] == heights[0]) || (i + 1 == count && heights[i - 1] == heights[i]);
    if (is_middle_of_flat_end) continue;
    points.height.push_back(heights[i]);
    points.q.push_back(radii[i] * radii[i]);
  }
  return points;
}

/// Some of the points in a row, and at which end the curve has to run along the axis.
struct Section {
  Points points;
  bool level_low = false, level_high = false;
};

/// Second derivatives at the points of a section: at a free end not-a-knot, so that a parabola stays one.
std::vector<double> second_derivatives(const Section& section) {
  const auto& [height, q] = section.points;
  const std::size_t n = height.size();
  const bool low = section.level_low, high = section.level_high;
  std::vector<double> M(n, 0.0), h, slope;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h.push_back(height[i + 1] - height[i]);
    slope.push_back((q[i + 1] - q[i]) / h[i]);
  }
  const bool is_parabola = n == 2 ? low != high : n == 3 && !low && !high;
  if (n == 2 && !low && !high) return M;
  if (is_parabola) {
    M.assign(n, n == 3 ? 2.0 * (slope[1] - slope[0]) / (h[0] + h[1]) : (low ? 2.0 : -2.0) * slope[0] / h[0]);
    return M;
  }
  // A tridiagonal system, free ends eliminated.
  const std::size_t first = low ? 0 : 1, last = high ? n - 1 : n - 2;
  std::vector<double> below(n, 0.0), diagonal(n, 0.0), above(n, 0.0), right(n, 0.0);
  for (std::size_t i = first; i <= last; ++i) {
    const double before = i > 0 ? h[i - 1] : 0.0, after = i + 1 < n ? h[i] : 0.0;
    below[i] = before;
    diagonal[i] = 2.0 * (before + after);
    above[i] = after;
    right[i] = 6.0 * ((i + 1 < n ? slope[i] : 0.0) - (i > 0 ? slope[i - 1] : 0.0));
  }
  if (!low) {
    diagonal[1] += h[0] * (h[0] + h[1]) / h[1];
    above[1] -= h[0] * h[0] / h[1];
  }
  if (!high) {
    diagonal[last] += h[last] * (h[last] + h[last - 1]) / h[last - 1];
    below[last] -= h[last] * h[last] / h[last - 1];
  }
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double factor = below[i] / diagonal[i - 1];
    diagonal[i] -= factor * above[i - 1];
    right[i] -= factor * right[i - 1];
  }
  M[last] = right[last] / diagonal[last];
  for (std::size_t i = last; i-- > first;) M[i] = (right[i] - above[i] * M[i + 1]) / diagonal[i];
  if (!low) M[0] = ((h[0] + h[1]) * M[1] - h[0] * M[2]) / h[1];
  if (!high) M[n - 1] = ((h[n - 2] + h[n - 3]) * M[n - 2] - h[n - 2] * M[n - 3]) / h[n - 3];
  return M;
}

void append_spline(const Section& section, std::vector<ProfileCurve::Piece>& pieces) {
  const auto& [height, q] = section.points;
  const std::vector<double> M = second_derivatives(section);
  for (std::size_t i = 0; i + 1 < height.size(); ++i) {
    const double h = height[i + 1] - height[i];
    const double slope = (q[i + 1] - q[i]) / h - h * (2.0 * M[i] + M[i + 1]) / 6.0;
    pieces.push_back({height[i], h, {{q[i], slope, 0.5 * M[i], (M[i + 1] - M[i]) / (6.0 * h)}}});
  }
}

/// Walls, three points or more in a row with one radius, and smooth curves between them.
std::vector<ProfileCurve::Piece> spline(const Points& p) {
  std::vector<ProfileCurve::Piece> pieces;
  Section section;
  const std::size_t n = p.height.size();
  const auto add = [&](std::size_t i) {
    section.points.height.push_back(p.height[i]);
    section.points.q.push_back(p.q[i]);
  };
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i;
    while (end + 1 < n && p.q[end + 1] == p.q[i]) ++end;
    add(i);
    if (end < i + 2) {
      ++i;
      continue;
    }
    section.level_high = true;
    append_spline(section, pieces);
    pieces.push_back({p.height[i], p.height[end] - p.height[i], {{p.q[i], 0.0, 0.0, 0.0}}});
    section = {.points = {}, .level_low = true, .level_high = false};
    add(end);
    i = end + 1;
  }
  append_spline(section, pieces);
  return pieces;
}

/// Where the cubic's slope is zero between two places, ascending.
std::vector<double> turning_places(const Cubic& cubic, double low, double high) {
  const double a = 3.0 * cubic.c[3], b = cubic.c[2], c = cubic.c[1];  // a x^2 + 2 b x + c
  std::vector<double> places;
  const double square = b * b - a * c;
  if (square >= 0.0) {
    const double sum = -(b + std::copysign(std::sqrt(square), b));
    if (a != 0.0) places.push_back(sum / a);
    if (sum != 0.0) places.push_back(c / sum);
  }
  std::erase_if(places, [&](double x) { return !(x > low && x < high); });
  std::sort(places.begin(), places.end());
  return places;
}

/// Largest of q over all pieces, and where.
std::pair<double, double> largest_of(const std::vector<ProfileCurve::Piece>& pieces) {
  std::pair<double, double> largest{0.0, 0.0};
  for (const auto& piece : pieces) {
    std::vector<double> ways = turning_places(piece.q, 0.0, piece.length);
    ways.push_back(0.0);
    ways.push_back(piece.length);
    for (const double way : ways) {
      if (piece.q.at(way) > largest.second) largest = {piece.start + way, piece.q.at(way)};
    }
  }
  return largest;
}

/// A height at which the curve is on the axis or beyond it, between its ends.
std::optional<double> crossing_of(const Points& points) {
  const std::vector<ProfileCurve::Piece> pieces = spline(points);
  const auto &first = pieces.front(), &last = pieces.back();
  if (points.q.front() == 0.0 && !(first.q.slope(0.0) > 0.0)) return points.height.front();
  if (points.q.back() == 0.0 && !(last.q.slope(last.length) < 0.0)) return points.height.back();
  for (const auto& piece : pieces) {
    for (const double way : turning_places(piece.q, 0.0, piece.length)) {
      if (!(piece.q.at(way) > 0.0)) return piece.start + way;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> first_not_positive(const Cubic& cubic, double from, double to) {
  if (!(cubic.at(from) > 0.0)) return from;
  std::vector<double> stops = turning_places(cubic, std::min(from, to), std::max(from, to));
  if (to < from) std::reverse(stops.begin(), stops.end());
  stops.push_back(to);
  for (double before = from; const double stop : stops) {
    if (!(cubic.at(stop) > 0.0)) {
      double positive = before, not_positive = stop;
      for (double middle = 0.5 * (positive + not_positive); middle != positive && middle != not_positive;
           middle = 0.5 * (positive + not_positive)) {
        (cubic.at(middle) > 0.0 ? positive : not_positive) = middle;
      }
      return not_positive;
    }
    before = stop;
  }
  return std::nullopt;
}

std::optional<ProfileFault> profile_fault(const std::vector<double>& heights, const std::vector<double>& radii) {
  const std::size_t count = heights.size();
  if (radii.size() != count) {
    return ProfileFault{false, std::to_string(radii.size()) + " radii",
                        "must be as many as profile_height = " + std::to_string(count)};
  }
  if (count < kFewestPoints || count > kMostPoints) {
    return ProfileFault{true, std::to_string(count) + " points", "must be 4 to 1000 points, from end to end"};
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (radii[i] < 0.0) {
      return ProfileFault{false, spelled(radii[i]), "must be >= 0: it is the distance from the axis"};
    }
    const bool is_end = i == 0 || i + 1 == count;
    if (is_end && radii[i] != 0.0) {
      return ProfileFault{false, spelled(radii[i]),
                          std::string("must ") + (i == 0 ? "begin" : "end") +
                              " at 0, on the axis: the profile is open there; a flat end has the axis and its rim "
                              "at one height"};
    }
    if (!is_end && !(radii[i] > 0.0)) {
      return ProfileFault{
          false, spelled(radii[i]),
          "must be > 0 between the ends: the profile touches its axis at the height " + for_people(heights[i])};
    }
    const bool flat_allowed = i == 1 || i + 1 == count;
    if (i > 0 && !(heights[i] > heights[i - 1]) && !(flat_allowed && heights[i] == heights[i - 1])) {
      return ProfileFault{true, spelled(heights[i]),
                          "must be > the height before it, " + spelled(heights[i - 1]) +
                              ": the points go from end to end along the axis"};
    }
  }
  const Points points = points_of(heights, radii);
  if (points.height.size() < 2) return ProfileFault{true, spelled(heights[0]), "must rise: the profile is flat"};
  if (const auto crossing = crossing_of(points)) {
    return ProfileFault{false, "",
                        "make a smooth curve that crosses its axis at the height " + for_people(*crossing) +
                            ": give more points around it, or round the end off"};
  }
  return std::nullopt;
}

ProfileCurve::ProfileCurve(const std::vector<double>& heights, const std::vector<double>& radii, double length,
                           double widest)
    : piece_(spline(points_of(heights, radii))) {
  const double middle = 0.5 * (low() + high()), along = length / (high() - low());
  const auto [place, largest] = largest_of(piece_);
  const double across = widest * widest / largest;
  for (Piece& piece : piece_) {
    piece.start = (piece.start - middle) * along;
    piece.length *= along;
    double stretched = across;
    for (double& c : piece.q.c) {
      c *= stretched;
      stretched /= along;
    }
  }
  const double as_wide = kAsWide * widest * widest, peak = (place - middle) * along;
  // Down and up from the widest place, where the curve leaves that stretch.
  double first = peak, last = peak;
  const double step = (high() - low()) / 4096.0;
  while (first > low() && q(first - step) >= as_wide) first = std::max(low(), first - step);
  while (last < high() && q(last + step) >= as_wide) last = std::min(high(), last + step);
  widest_m_ = last - first > 0.5 * widest ? 0.5 * (first + last) : peak;
}

const ProfileCurve::Piece& ProfileCurve::piece_at(double height) const {
  const auto after = std::upper_bound(piece_.begin() + 1, piece_.end(), height,
                                      [](double h, const Piece& piece) { return h < piece.start; });
  return *(after - 1);
}

double ProfileCurve::q(double height) const {
  height = std::clamp(height, low(), high());
  const Piece& piece = piece_at(height);
  return std::max(0.0, piece.q.at(height - piece.start));
}

double ProfileCurve::slope(double height) const {
  height = std::clamp(height, low(), high());
  const Piece& piece = piece_at(height);
  return piece.q.slope(height - piece.start);
}

std::optional<double> ProfileCurve::first_as_wide(double squared_radius) const {
  for (const Piece& piece : piece_) {
    Cubic missing{{squared_radius - piece.q.c[0], -piece.q.c[1], -piece.q.c[2], -piece.q.c[3]}};
    if (const auto way = first_not_positive(missing, 0.0, piece.length)) return piece.start + *way;
  }
  return std::nullopt;
}

std::optional<double> ProfileCurve::last_as_wide(double squared_radius) const {
  for (auto piece = piece_.rbegin(); piece != piece_.rend(); ++piece) {
    Cubic missing{{squared_radius - piece->q.c[0], -piece->q.c[1], -piece->q.c[2], -piece->q.c[3]}};
    if (const auto way = first_not_positive(missing, piece->length, 0.0)) return piece->start + *way;
  }
  return std::nullopt;
}

}  // namespace unbruised
