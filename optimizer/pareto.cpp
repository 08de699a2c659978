#include "optimizer/pareto.hpp"

#include <algorithm>
#include <limits>
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

double volume(std::vector<Objectives> points, const Objectives& reference) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a[2] < b[2]; });
  double sum = 0.0;
  std::vector<std::pair<double, double>> below;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double z = points[i][2];
    if (z >= reference[2]) break;
    below.emplace_back(points[i][0], points[i][1]);
    const double next = i + 1 < points.size() ? std::min(points[i + 1][2], reference[2]) : reference[2];
    if (next > z) sum += (next - z) * area(below, reference[0], reference[1]);
  }
  return sum;
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
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    bool stays = true;
    for (std::size_t j = 0; stays && j < points.size(); ++j) {
      stays = !dominates(points[j], points[i]) && !(j < i && points[j] == points[i]);
    }
    if (stays) front.push_back(i);
  }
  return front;
}

double hypervolume(const std::vector<Objectives>& points, const Objectives& reference) {
  if (reference.size() == 3) return volume(points, reference);
  std::vector<std::pair<double, double>> pairs;
  for (const Objectives& point : points) pairs.emplace_back(point[0], point[1]);
  return area(std::move(pairs), reference[0], reference[1]);
}

std::size_t knee(const std::vector<Objectives>& front) {
  const std::size_t n = front.front().size();
  Objectives low(n, std::numeric_limits<double>::infinity());
  Objectives high(n, -std::numeric_limits<double>::infinity());
  for (const Objectives& point : front) {
    for (std::size_t k = 0; k < n; ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  // In scaled objectives the ends lie on the axes at 1: their line or plane is sum x_k = 1, up to the ends' own other
  // objectives, and the distance from it falls with the sum.
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < front.size(); ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      const double range = high[k] - low[k];
      if (range > 0.0) sum += (front[i][k] - low[k]) / range;
    }
    if (sum < least) {
      least = sum;
      best = i;
    }
  }
  return best;
}

}  // namespace unbruised::optimizer
