#include "core/contact/pad_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace unbruised {
namespace {

/// Less of a cell than this has no duals: they would be steep.
constexpr double kLeastForDuals = 0.1;
/// Less than this of a cell under the pad carries nothing.
constexpr double kLeastCover = 1e-9;
/// Of what a piece gives: rounding, where meshes match and its share is dual to the particle's hat function.
constexpr double kRounding = 1e-14;

/// c + s y.
struct Line {
  double c = 0, s = 0;
  [[nodiscard]] double at(double y) const { return c + s * y; }
};

struct Span {
  double low, high;
};

/// The hat function of the low end of a span, within it.
Line falling(const Span& cell) {
  const double slope = -1.0 / (cell.high - cell.low);
  return {-slope * cell.high, slope};
}
Line rising(const Span& cell) {
  const double slope = 1.0 / (cell.high - cell.low);
  return {-slope * cell.low, slope};
}

/// Of the product of two lines.
double integral(const Line& a, const Line& b, const Span& over) {
  const double middle = 0.5 * (over.low + over.high);
  return (over.high - over.low) / 6.0 *
         (a.at(over.low) * b.at(over.low) + 4.0 * a.at(middle) * b.at(middle) + a.at(over.high) * b.at(over.high));
}

/// The shares of both ends of a cell over its part under the pad.
std::array<Line, 2> shares(const Span& cell, const Span& covered) {
  const std::array<Line, 2> hat = {falling(cell), rising(cell)};
  if (covered.high - covered.low < kLeastForDuals * (cell.high - cell.low)) return hat;
  const Line one{1.0, 0.0};
  const double a = integral(hat[0], hat[0], covered), b = integral(hat[0], hat[1], covered),
               d = integral(hat[1], hat[1], covered), determinant = a * d - b * b;
  const double of_low = integral(hat[0], one, covered) / determinant,
               of_high = integral(hat[1], one, covered) / determinant;
  const auto combined = [&](double p, double q) {
    return Line{p * hat[0].c + q * hat[1].c, p * hat[0].s + q * hat[1].s};
  };
  return {combined(of_low * d, -of_low * b), combined(-of_high * b, of_high * a)};
}

/// Sums up what a piece gives to the pad's particles.
class Spread {
 public:
  explicit Spread(const std::vector<double>& pad_m) : pad_m_(pad_m), sum_(pad_m.size(), 0.0) {}

  void add(const Line& share, const Span& over) {
    for (std::size_t j = 0; j + 1 < pad_m_.size(); ++j) {
      const Span cell{pad_m_[j], pad_m_[j + 1]};
      const Span both{std::max(over.low, cell.low), std::min(over.high, cell.high)};
      if (!(both.high > both.low)) continue;
      sum_[j] += integral(share, falling(cell), both);
      sum_[j + 1] += integral(share, rising(cell), both);
    }
  }

  /// @param cell_m of the product @param place_m of the piece: one that carries nothing goes to what is next to it
  [[nodiscard]] PadWeights weights(double cell_m, double place_m) const {
    double total = 0.0;
    for (const double part : sum_) total += part;
    if (total < kLeastCover * cell_m) return at(place_m);
    PadWeights result;
    const auto is_nothing = [&](double part) { return std::abs(part) <= kRounding * total; };
    while (is_nothing(sum_[result.first])) ++result.first;
    std::size_t end = sum_.size();
    while (is_nothing(sum_[end - 1])) --end;
    for (std::size_t j = result.first; j < end; ++j) result.weight.push_back(sum_[j] / total);
    return result;
  }

 private:
  [[nodiscard]] PadWeights at(double place_m) const {
    const double place = std::clamp(place_m, pad_m_.front(), pad_m_.back());
    std::size_t j = 0;
    while (j + 2 < pad_m_.size() && place > pad_m_[j + 1]) ++j;
    const double part = (place - pad_m_[j]) / (pad_m_[j + 1] - pad_m_[j]);
    return {j, {1.0 - part, part}};
  }

  const std::vector<double>& pad_m_;
  std::vector<double> sum_;
};

}  // namespace

std::vector<PadWeights> pad_weights(const std::vector<Tributary>& piece, const std::vector<double>& pad_m,
                                    double middle_m) {
  const auto under_pad = [&](const Span& span) {
    return Span{std::max(span.low, pad_m.front()), std::min(span.high, pad_m.back())};
  };
  std::vector<Spread> spread(piece.size(), Spread(pad_m));
  for (std::size_t k = 0; k < piece.size(); ++k) {
    const double place = piece[k].place_m - middle_m;
    if (piece[k].curved) {
      const double half = 0.5 * piece[k].extent_m;
      spread[k].add({1.0, 0.0}, under_pad({place - half, place + half}));
      continue;
    }
    if (k + 1 == piece.size()) continue;
    const Span cell{place, piece[k + 1].place_m - middle_m};
    const Span covered = under_pad(cell);
    if (!(covered.high > covered.low)) continue;
    const std::array<Line, 2> share = shares(cell, covered);
    spread[k].add(share[0], covered);
    spread[k + 1].add(share[1], covered);
  }
  std::vector<PadWeights> weights;
  for (std::size_t k = 0; k < piece.size(); ++k) {
    weights.push_back(spread[k].weights(piece[k].extent_m, piece[k].place_m - middle_m));
  }
  return weights;
}

}  // namespace unbruised
