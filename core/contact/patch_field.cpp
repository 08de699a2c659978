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
  std::array<double, kParts> volume, dent, area, depth;
};

/// For Poisson ratios of 0, 0.1 ... 0.5, at 0.3, 0.35 ... 1 of the peak; `patch_damage_test` computes it again.
constexpr std::array<FieldRow, kRatios> kTable = {{
    {{1.3787, 1.0729, 0.8536, 0.6962, 0.5661, 0.4602, 0.3736, 0.2973, 0.2310, 0.1737, 0.1227, 0.0796, 0.0436,
      0.0157, 0.0000},
     {1.0646, 0.9445, 0.8443, 0.7608, 0.6837, 0.6152, 0.5571, 0.5044, 0.4479, 0.3920, 0.3362, 0.2735, 0.1986,
      0.1056, 0.0000},
     {2.5005, 2.1435, 1.8754, 1.6669, 1.4990, 1.3575, 1.2177, 0.7040, 0.6213, 0.5330, 0.4388, 0.3381, 0.2315,
      0.1186, 0.0000},
     {1.1170, 1.0083, 0.9181, 0.8410, 0.7736, 0.7134, 0.6585, 0.6078, 0.5601, 0.5144, 0.4697, 0.4247, 0.3774,
      0.3233, 0.2157}},
    {{1.4536, 1.1310, 0.9054, 0.7324, 0.5927, 0.4813, 0.3936, 0.3129, 0.2439, 0.1835, 0.1302, 0.0843, 0.0466,
      0.0163, 0.0000},
     {1.0457, 0.9279, 0.8307, 0.7467, 0.6721, 0.6085, 0.5503, 0.4933, 0.4383, 0.3840, 0.3263, 0.2620, 0.1893,
      0.0958, 0.0000},
     {2.1471, 1.8403, 1.6098, 1.4284, 1.2708, 0.9074, 0.8204, 0.7371, 0.6514, 0.5607, 0.4630, 0.3581, 0.2459,
      0.1264, 0.0000},
     {1.1449, 1.0343, 0.9426, 0.8644, 0.7959, 0.7348, 0.6793, 0.6280, 0.5798, 0.5336, 0.4885, 0.4432, 0.3957,
      0.3415, 0.2336}},
    {{1.5545, 1.2119, 0.9621, 0.7790, 0.6337, 0.5170, 0.4178, 0.3329, 0.2606, 0.1957, 0.1404, 0.0906, 0.0496,
      0.0178, 0.0000},
     {1.0421, 0.9251, 0.8264, 0.7457, 0.6724, 0.6066, 0.5474, 0.4880, 0.4334, 0.3767, 0.3196, 0.2541, 0.1799,
      0.0900, 0.0000},
     {1.8020, 1.5443, 1.3496, 1.1965, 1.0715, 0.9657, 0.8718, 0.7832, 0.6937, 0.5990, 0.4970, 0.3861, 0.2662,
      0.1376, 0.0000},
     {1.1735, 1.0610, 0.9678, 0.8883, 0.8188, 0.7568, 0.7005, 0.6486, 0.5998, 0.5532, 0.5077, 0.4620, 0.4143,
      0.3599, 0.2528}},
    {{1.6961, 1.3194, 1.0496, 0.8460, 0.6882, 0.5609, 0.4536, 0.3619, 0.2835, 0.2147, 0.1531, 0.1009, 0.0551,
      0.0200, 0.0000},
     {1.0595, 0.9408, 0.8410, 0.7565, 0.6823, 0.6150, 0.5512, 0.4906, 0.4354, 0.3757, 0.3148, 0.2502, 0.1744,
      0.0869, 0.0000},
     {1.9568, 1.6749, 1.4618, 1.2942, 1.1577, 1.0424, 0.9409, 0.8463, 0.7520, 0.6528, 0.5446, 0.4260, 0.2958,
      0.1537, 0.0000},
     {1.2030, 1.0885, 0.9937, 0.9128, 0.8423, 0.7794, 0.7223, 0.6696, 0.6203, 0.5731, 0.5272, 0.4812, 0.4331,
      0.3785, 0.2708}},
    {{1.8775, 1.4626, 1.1610, 0.9372, 0.7647, 0.6228, 0.5068, 0.4068, 0.3183, 0.2432, 0.1739, 0.1152, 0.0636,
      0.0227, 0.0000},
     {1.0986, 0.9753, 0.8722, 0.7815, 0.7046, 0.6340, 0.5692, 0.5036, 0.4422, 0.3837, 0.3168, 0.2522, 0.1749,
      0.0854, 0.0000},
     {2.1506, 1.8393, 1.6043, 1.4197, 1.2695, 1.1432, 1.0330, 0.9320, 0.8329, 0.7289, 0.6141, 0.4850, 0.3400,
      0.1782, 0.0000},
     {1.2335, 1.1169, 1.0204, 0.9382, 0.8664, 0.8025, 0.7446, 0.6913, 0.6413, 0.5936, 0.5471, 0.5007, 0.4523,
      0.3974, 0.2902}},
    {{2.1455, 1.6573, 1.3140, 1.0575, 0.8643, 0.7079, 0.5791, 0.4684, 0.3709, 0.2864, 0.2076, 0.1370, 0.0777,
      0.0281, 0.0000},
     {1.1713, 1.0351, 0.9219, 0.8242, 0.7404, 0.6666, 0.5957, 0.5286, 0.4631, 0.3995, 0.3326, 0.2583, 0.1807,
      0.0887, 0.0000},
     {2.3972, 2.0499, 1.7879, 1.5825, 1.4159, 1.2767, 1.1566, 1.0485, 0.9454, 0.8383, 0.7182, 0.5777, 0.4124,
      0.2199, 0.0000},
     {1.2651, 1.1462, 1.0480, 0.9643, 0.8914, 0.8265, 0.7677, 0.7135, 0.6628, 0.6146, 0.5676, 0.5207, 0.4719,
      0.4166, 0.3095}},
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
    area_[i] = mixed(kTable[row.at].area, kTable[row.at + 1].area);
    depth_[i] = mixed(kTable[row.at].depth, kTable[row.at + 1].depth);
  }
}

double PatchField::volume_above(double part) const {
  const double root = between(root_volume_, steps_to(part));
  return root * std::sqrt(root);
}

double PatchField::dent_above(double part) const { return between(dent_, steps_to(part)); }
double PatchField::area_above(double part) const { return between(area_, steps_to(part)); }
double PatchField::depth_above(double part) const { return between(depth_, steps_to(part)); }

}  // namespace unbruised
