#include <cmath>
#include <utility>

#include "core/scenario/plausible_parts.hpp"

namespace unbruised {
namespace plausible {

PlausibleRow plain(std::string_view path, std::string_view quantity, std::string_view unit, double low,
                   double high, Slips slips, std::string_view source) {
  const NumberField* field = find_number_field(path);
  return {quantity,
          unit,
          low,
          high,
          {path},
          std::move(slips),
          "",
          source,
          [=](const Scenario& s, const MeasureVisit& visit) {
            for_each_number(*field, s, [&](const NumberPlace& place, double value) {
              visit({path_of(path, place), value, std::abs(value)});
            });
          }};
}

}  // namespace plausible

const std::vector<PlausibleRow>& plausible_rows() {
  static const std::vector<PlausibleRow> table = [] {
    using namespace plausible;
    Rows all;
    for (const Rows& part : {product_rows(), gripper_rows(), cell_rows(), sensor_rows(), strategy_rows(),
                             limit_rows(), robot_rows()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return table;
}

}  // namespace unbruised
