#include "studies/statistics/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "studies/statistics/least_squares.hpp"

namespace unbruised::studies {
namespace {

using Numbers = std::vector<double>;
using Rows = std::vector<Numbers>;

double dot(const Numbers& a, const Numbers& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

/// What regression on the other parameters leaves of numbers, and by which step of them.
struct Rest {
  Numbers rest;
  Numbers step;  ///< of the others
};

Rest rest_of(const Rows& others, const Numbers& numbers) {
  Rest out{numbers, {}};
  if (others.front().empty()) return out;
  out.step = linear_fit(others, numbers).step;
  for (std::size_t p = 0; p < numbers.size(); ++p) out.rest[p] += dot(others[p], out.step);
  return out;
}

/// The root of a d^2 + 2 b d + c on a side, or the least point where there is none.
double root(double a, double b, double c, Side side) {
  const double sign = side == Side::low ? -1.0 : 1.0;
  const double way = std::sqrt(std::max(0.0, b * b - a * c));
  const double d = (sign * way - b) / a;
  return std::isfinite(d) ? std::clamp(d, -1.0, 1.0) : sign;
}

}  // namespace

ProfileStep profile_step(const Rows& J, std::span<const double> r, std::size_t of, double squares, Side side) {
  Rows others;
  Numbers own;
  for (const Numbers& row : J) {
    own.push_back(row[of]);
    others.push_back(row);
    others.back().erase(others.back().begin() + static_cast<std::ptrdiff_t>(of));
  }
  const Rest of_r = rest_of(others, {r.begin(), r.end()});
  const Rest of_own = rest_of(others, own);
  ProfileStep out;
  out.squares = dot(of_r.rest, of_r.rest);
  const double d = root(dot(of_own.rest, of_own.rest), dot(of_r.rest, of_own.rest), out.squares - squares, side);
  out.step.assign(of_r.step.size() + 1, d);
  for (std::size_t k = 0; k < of_r.step.size(); ++k) {
    out.step[k < of ? k : k + 1] = of_r.step[k] + d * of_own.step[k];
  }
  return out;
}

}  // namespace unbruised::studies
