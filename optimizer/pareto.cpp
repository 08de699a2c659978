#include "optimizer/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace unbruised::optimizer {
namespace {

/// Area below the reference that is dominated by (x, y) points.
double area(std::vector<std::pair<double, double>> points, double reference_x, double reference_y) {
  std::sort(points.begin(), points.end());
  double sum = 0.0;
  double y = reference_y;
  for (const auto& [px, py] : points) {
    if (px >= reference_x || py >= y) continue;
    sum += (reference_x - px) * (y - py);
    y = py;
  }
  return sum;
}

/// Slices between the heights of the points, each with the area that all lower points dominate.
double volume(std::vector<Objectives> points, const Objectives& reference) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a[2] < b[2]; });
  double sum = 0.0;
  std::vector<std::pair<double, double>> lower;
  for (std::size_t i = 0; i < points.size(); ++i) {
    lower.emplace_back(points[i][0], points[i][1]);
    const double next = i + 1 < points.size() ? points[i + 1][2] : reference[2];
    if (next > points[i][2]) sum += (next - points[i][2]) * area(lower, reference[0], reference[1]);
  }
  return sum;
}

bool has_nan(const Objectives& point) {
  return std::any_of(point.begin(), point.end(), [](double value) { return std::isnan(value); });
}

bool is_below(const Objectives& point, const Objectives& reference) {
  for (std::size_t k = 0; k < reference.size(); ++k) {
    if (!(point[k] < reference[k])) return false;
  }
  return true;
}

double dot(const Objectives& a, const Objectives& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// Every objective from 0 at its least to 1 at its largest; one that does not differ is 0.
std::vector<Objectives> scaled_to_one(std::vector<Objectives> front) {
  for (std::size_t k = 0; k < front.front().size(); ++k) {
    double low = front.front()[k];
    double high = low;
    for (const Objectives& point : front) {
      low = std::min(low, point[k]);
      high = std::max(high, point[k]);
    }
    for (Objectives& point : front) point[k] = high > low ? (point[k] - low) / (high - low) : 0.0;
  }
  return front;
}

/// The point that is best in objective k; of several, the one with the least sum.
const Objectives& end_of(const std::vector<Objectives>& front, std::size_t k) {
  const auto rank = [k](const Objectives& point) {
    return std::pair(point[k], std::accumulate(point.begin(), point.end(), 0.0));
  };
  return *std::min_element(front.begin(), front.end(),
                           [&](const Objectives& a, const Objectives& b) { return rank(a) < rank(b); });
}

/// The normal of the line or plane through the ends, pointing away from the ideal point. Where the ends do not
/// span one that faces the ideal point: that of the line or plane through (1, 0, ...), (0, 1, ...), ...
Objectives normal_of_ends(const std::vector<Objectives>& front) {
  const std::size_t n = front.front().size();
  const Objectives diagonal(n, 1.0);
  if (n != 3) return diagonal;  // of two objectives, the ends are (0, 1) and (1, 0)
  const Objectives& a = end_of(front, 0);
  const Objectives& b = end_of(front, 1);
  const Objectives& c = end_of(front, 2);
  Objectives normal(3);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3;
    const std::size_t j = (k + 2) % 3;
    normal[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
  }
  if (dot(normal, diagonal) < 0.0) {
    for (double& component : normal) component = -component;
  }
  const bool faces_ideal = std::all_of(normal.begin(), normal.end(), [](double x) { return x > 0.0; });
  return faces_ideal ? normal : diagonal;
}

}  // namespace

bool dominates(const Objectives& a, const Objectives& b) {
  bool better = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    better = better || a[k] < b[k];
  }
  return better;
}

std::vector<std::size_t> nondominated(const std::vector<Objectives>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!has_nan(points[i])) order.push_back(i);
  }
  // What dominates a point, and what equals it but comes first, stands before it in this order.
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    const bool stays = std::none_of(front.begin(), front.end(), [&](std::size_t j) {
      return points[j] == points[i] || dominates(points[j], points[i]);
    });
    if (stays) front.push_back(i);
  }
  std::sort(front.begin(), front.end());
  return front;
}

double hypervolume(const std::vector<Objectives>& points, const Objectives& reference) {
  std::vector<Objectives> inside;
  for (const Objectives& point : points) {
    if (is_below(point, reference)) inside.push_back(point);
  }
  if (reference.size() == 3) return volume(std::move(inside), reference);
  std::vector<std::pair<double, double>> pairs;
  for (const Objectives& point : inside) pairs.emplace_back(point[0], point[1]);
  return area(std::move(pairs), reference[0], reference[1]);
}

std::size_t knee(const std::vector<Objectives>& front) {
  const std::vector<Objectives> scaled = scaled_to_one(front);
  const Objectives normal = normal_of_ends(scaled);
  // The distance below the plane is largest where n . x is least; the length of n does not matter.
  std::size_t best = 0;
  for (std::size_t i = 1; i < scaled.size(); ++i) {
    if (dot(normal, scaled[i]) < dot(normal, scaled[best])) best = i;
  }
  return best;
}

}  // namespace unbruised::optimizer
