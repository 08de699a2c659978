#include "core/contact/patch_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/contact/linear_table.hpp"

namespace unbruised {
namespace {

constexpr std::size_t kRatios = 6;
constexpr double kRatioStep = 0.1;  ///< between the rows, which begin at a Poisson ratio of 0
constexpr std::size_t kParts = PatchField::kParts;

struct FieldRow {
  std::array<double, kParts> volume, dent;
};

/// For Poisson ratios of 0, 0.1 ... 0.5, at 0.3, 0.35 ... 1 of the peak; `patch_damage_test` computes it again.
constexpr std::array<FieldRow, kRatios> kTable = {{
    {{1.3787, 1.0729, 0.8536, 0.6962, 0.5661, 0.4602, 0.3736, 0.2973, 0.2310, 0.1737, 0.1227, 0.0796, 0.0436,
      0.0157, 0.0000},
     {1.0646, 0.9445, 0.8443, 0.7608, 0.6837, 0.6152, 0.5571, 0.5044, 0.4479, 0.3920, 0.3362, 0.2735, 0.1986,
      0.1056, 0.0000}},
    {{1.4536, 1.1310, 0.9054, 0.7324, 0.5927, 0.4813, 0.3936, 0.3129, 0.2439, 0.1835, 0.1302, 0.0843, 0.0466,
      0.0163, 0.0000},
     {1.0457, 0.9279, 0.8307, 0.7467, 0.6721, 0.6085, 0.5503, 0.4933, 0.4383, 0.3840, 0.3263, 0.2620, 0.1893,
      0.0958, 0.0000}},
    {{1.5545, 1.2119, 0.9621, 0.7790, 0.6337, 0.5170, 0.4178, 0.3329, 0.2606, 0.1957, 0.1404, 0.0906, 0.0496,
      0.0178, 0.0000},
     {1.0421, 0.9251, 0.8264, 0.7457, 0.6724, 0.6066, 0.5474, 0.4880, 0.4334, 0.3767, 0.3196, 0.2541, 0.1799,
      0.0900, 0.0000}},
    {{1.6961, 1.3194, 1.0496, 0.8460, 0.6882, 0.5609, 0.4536, 0.3619, 0.2835, 0.2147, 0.1531, 0.1009, 0.0551,
      0.0200, 0.0000},
     {1.0595, 0.9408, 0.8410, 0.7565, 0.6823, 0.6150, 0.5512, 0.4906, 0.4354, 0.3757, 0.3148, 0.2502, 0.1744,
      0.0869, 0.0000}},
    {{1.8775, 1.4626, 1.1610, 0.9372, 0.7647, 0.6228, 0.5068, 0.4068, 0.3183, 0.2432, 0.1739, 0.1152, 0.0636,
      0.0227, 0.0000},
     {1.0986, 0.9753, 0.8722, 0.7815, 0.7046, 0.6340, 0.5692, 0.5036, 0.4422, 0.3837, 0.3168, 0.2522, 0.1749,
      0.0854, 0.0000}},
    {{2.1455, 1.6573, 1.3140, 1.0575, 0.8643, 0.7079, 0.5791, 0.4684, 0.3709, 0.2864, 0.2076, 0.1370, 0.0777,
      0.0281, 0.0000},
     {1.1713, 1.0351, 0.9219, 0.8242, 0.7404, 0.6666, 0.5957, 0.5286, 0.4631, 0.3995, 0.3326, 0.2583, 0.1807,
      0.0887, 0.0000}},
}};

/// A table at x steps from its first entry, constant beyond its ends.
double between(const std::array<double, kParts>& table, double x) {
  return BetweenEntries(std::clamp(x, 0.0, static_cast<double>(kParts - 1)), 1.0, kParts).in(table);
}

double steps_to(double part) { return (part - PatchField::kLeastPart) / PatchField::kPartStep; }

}  // namespace

PatchField::PatchField(double poisson_ratio) {
  const BetweenEntries row(poisson_ratio, kRatioStep, kRatios);
  for (std::size_t i = 0; i < kParts; ++i) {
    const auto mixed = [&](const auto& low, const auto& high) { return row.of(low[i], high[i]); };
    root_volume_[i] = std::pow(mixed(kTable[row.at].volume, kTable[row.at + 1].volume), 2.0 / 3.0);
    dent_[i] = mixed(kTable[row.at].dent, kTable[row.at + 1].dent);
  }
}

double PatchField::volume_above(double part) const {
  const double root = between(root_volume_, steps_to(part));
  return root * std::sqrt(root);
}

double PatchField::dent_above(double part) const { return between(dent_, steps_to(part)); }

}  // namespace unbruised
