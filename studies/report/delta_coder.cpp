#include "studies/report/delta_coder.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace unbruised::studies {
namespace {

void put_number(std::uint64_t value, std::string& bytes) {
  constexpr std::uint64_t kLow = 0x7F;
  while (value > kLow) {
    bytes += static_cast<char>((value & kLow) | 0x80U);
    value >>= 7U;
  }
  bytes += static_cast<char>(value);
}

std::uint64_t with_sign_below(std::int64_t value) {
  return value < 0 ? 2 * static_cast<std::uint64_t>(-(value + 1)) + 1 : 2 * static_cast<std::uint64_t>(value);
}

}  // namespace

std::string delta_coded(std::span<const std::int32_t> values, std::size_t width) {
  std::string bytes;
  std::uint64_t zeros = 0;
  const auto end_zeros = [&] {
    if (zeros == 0) return;
    put_number(0, bytes);
    put_number(zeros - 1, bytes);
    zeros = 0;
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int64_t above = i < width ? 0 : values[i - width];
    const std::int64_t difference = values[i] - above;
    if (difference == 0) {
      ++zeros;
      continue;
    }
    end_zeros();
    put_number(with_sign_below(difference), bytes);
  }
  end_zeros();
  return bytes;
}

CodedTable coded(std::span<const float> values, std::size_t width, int steps) {
  double largest = 0.0;
  for (const float value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(static_cast<double>(value)));
  }
  const double step = largest > 0.0 ? largest / steps : 1.0;
  std::vector<std::int32_t> whole;
  whole.reserve(values.size());
  for (const float value : values) {
    whole.push_back(
        std::isfinite(value) ? static_cast<std::int32_t>(std::lround(static_cast<double>(value) / step)) : 0);
  }
  return {step, delta_coded(whole, width)};
}

}  // namespace unbruised::studies
