#include "studies/report/page_words.hpp"

#include <string_view>

#include <nlohmann/json.hpp>

#include "core/outcome/damage_limits.hpp"
#include "studies/config/sources.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;

json json_of(const Value& value) {
  if (value.kind != Value::Kind::array) return value.number;
  json list = json::array();
  for (const Value& item : value.items) list.push_back(item.number);
  return list;
}

/// { metric, key } of a limit of core; the key without its table.
template <class Limits>
json limits_json(const Limits& limits) {
  constexpr std::string_view kTable = "limits.";
  json all = json::array();
  for (const auto& limit : limits) {
    all.push_back({{"metric", info_of(limit.metric).name}, {"key", limit.key.substr(kTable.size())}});
  }
  return all;
}

}  // namespace

json page_words() {
  json names = json::object();
  for (const MetricInfo& info : kMetricTable) names[std::string(info.name)] = info.words;
  for (const auto& [key, words] : odd_key_words()) names[std::string(key)] = words;
  json suffixes = json::array();
  for (const Unit& unit : all_units()) suffixes.push_back({joined({unit.after, unit.suffix}), unit.udunits});
  return {{"names", std::move(names)}, {"unit_suffixes", std::move(suffixes)}};
}

json page_slip_limits() { return limits_json(kSlipLimits); }

json page_damage_limits() { return limits_json(kDamageLimits); }

json page_sources(const std::string& config_toml) {
  json sources = json::array();
  const ConfigSources known = config_sources(config_toml);
  for (const ValueSource& each : known.values) {
    sources.push_back({{"key", each.key},
                       {"value", json_of(each.value)},
                       {"source", each.source},
                       {"standing", standing_word(each.standing)}});
  }
  return sources;
}

}  // namespace unbruised::studies
