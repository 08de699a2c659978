#include "studies/config/vary.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "studies/config/library.hpp"

namespace unbruised::studies {
namespace {

/// A block with the entries of its variants.
struct RawBlock {
  VaryBlock block;
  Document variants;  ///< paths "variant[j]. ..."
  std::vector<std::string> given;
  bool refused = false;  ///< a value was refused at its own line

  [[nodiscard]] bool has(std::string_view key) const {
    return std::find(given.begin(), given.end(), key) != given.end();
  }
};

std::string block_prefix(std::size_t i) { return "vary[" + std::to_string(i) + "]."; }

void read_block_entry(RawBlock& raw, const Entry& entry, std::size_t prefix, Problems& problems) {
  const std::string local = entry.path.substr(prefix);
  if (local.starts_with("variant[")) {
    raw.variants.entries.push_back({local, entry.value, entry.origin});
    return;
  }
  const KeyAddress address = find_key(entry.path);
  if (address.spec == nullptr) {
    problems.add(entry.origin, entry.path, spelled(entry.value), unknown_key_rule(entry.path));
    return;
  }
  raw.given.push_back(local);
  if (const auto rule = check_value(*address.spec, entry.value, address.elements.size())) {
    problems.add(entry.origin, entry.path, spelled(entry.value), *rule);
    raw.refused = true;
    return;
  }
  if (address.spec->vary_field != nullptr) {
    assign(*address.spec, address.spec->vary_field(raw.block), entry.value, {});
  } else {
    raw.block.values = entry.value;
  }
}

std::vector<double> spread(const VaryBlock& block) {
  const auto n = static_cast<std::size_t>(block.count);
  std::vector<double> out(n, *block.from);
  for (std::size_t i = 1; i < n; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n - 1);
    out[i] = block.scale == VaryScale::log ? *block.from * std::pow(*block.to / *block.from, s)
                                           : *block.from + s * (*block.to - *block.from);
  }
  if (n > 1) out[n - 1] = *block.to;
  return out;
}

struct Planner {
  Problems& problems;
  VaryPlan plan;
  std::uint64_t value_count = 0;  ///< of all blocks together

  /// Is the block complete and not contradictory?
  bool well_formed(const RawBlock& raw, std::size_t i) {
    const std::string name = "vary[" + std::to_string(i) + "]";
    const Origin& origin = raw.block.origin;
    const auto complain = [&](const std::string& key, std::string_view rule) {
      problems.add(origin, name + key, rule);
      return false;
    };
    if (!raw.has("key")) return complain(".key", "missing");
    const bool range = raw.has("from") || raw.has("to") || raw.has("count") || raw.has("scale");
    if (raw.has("values") && range) return complain(".values", "excludes from, to, count and scale");
    if (!raw.has("values") && !(raw.has("from") && raw.has("to") && raw.has("count"))) {
      return complain("", "needs from, to and count, or values");
    }
    if (raw.refused) return false;
    if (raw.has("values")) return true;
    if (raw.block.scale == VaryScale::log && (*raw.block.from <= 0.0 || *raw.block.to <= 0.0)) {
      return complain(".scale", "\"log\" needs from > 0 and to > 0");
    }
    return true;
  }

  /// Can the key take several values?
  bool variable(const KeyAddress& address, const VaryBlock& block) {
    const std::string key = toml_string(block.key);
    const auto complain = [&](const std::string& rule) {
      problems.add(block.origin, "vary.key", key, rule);
      return false;
    };
    if (address.spec == nullptr) return complain(unknown_key_rule(block.key));
    const KeySpec& spec = *address.spec;
    if (spec.path == "product.use" || spec.path == "gripper.use") return true;
    if (spec.field == nullptr) return complain("this key cannot be varied");
    const bool array = is_number_array(spec.type) || spec.type == KeyType::integers;
    if (array && address.elements.empty()) return complain("vary one element: \"" + block.key + "[0]\"");
    if (spec.type == KeyType::axes) return complain("this key cannot be varied");
    return true;
  }

  bool fill_values(VaryColumn& column, const VaryBlock& block) {
    const KeySpec& spec = *column.address.spec;
    const bool is_text =
        spec.type == KeyType::text || spec.type == KeyType::choice || spec.type == KeyType::boolean;
    column.input.is_text = is_text;
    const std::vector<Value>& values = block.values.items;
    const auto is_sound = [&](const Value& value) {
      auto rule = check_value(spec, value, column.address.elements.size());
      if (!rule && !is_text && !value.is_number()) rule = "must be a number";
      if (rule) problems.add(block.origin, block.key, spelled(value), *rule);
      return !rule;
    };
    if (!std::all_of(values.begin(), values.end(), is_sound)) return false;
    if (values.empty()) {  // a range may have ten million numbers: no Value for each of them
      column.input.numbers = spread(block);
      const auto is_sound_number = [&](double number) { return is_sound(number_value(number)); };
      if (!std::all_of(column.input.numbers.begin(), column.input.numbers.end(), is_sound_number)) return false;
    }
    if (!is_text) {
      for (const Value& value : values) column.input.numbers.push_back(value.number);
      const Unit* unit = unit_of(block.key);
      column.input.units = unit == nullptr ? "1" : std::string(unit->udunits);
      return true;
    }
    for (const Value& value : values) {
      column.input.texts.push_back(value.kind == Value::Kind::text ? value.text : spelled(value));
    }
    column.words = values;
    return true;
  }

  bool fill_variants(VaryColumn& column, const RawBlock& raw) {
    if (raw.variants.entries.empty()) return true;
    if (!column.is_use()) {
      problems.add(raw.block.origin, "vary.variant", "goes with the keys product.use and gripper.use only");
      return false;
    }
    const std::string table = column.input.key.substr(0, column.input.key.find('.'));
    for (std::size_t j = 0; j < column.input.count(); ++j) {
      const std::string prefix = "variant[" + std::to_string(j) + "].";
      column.variants.push_back(library_entries(raw.variants, prefix, table, problems));
    }
    const bool any_empty = std::any_of(column.variants.begin(), column.variants.end(),
                                       [](const auto& entries) { return entries.empty(); });
    const std::string next = "variant[" + std::to_string(column.input.count()) + "].";
    const bool too_many = std::any_of(raw.variants.entries.begin(), raw.variants.entries.end(),
                                      [&](const Entry& entry) { return entry.path.starts_with(next); });
    if (any_empty || too_many) {
      problems.add(raw.block.origin, "vary.variant", "must be as many as values");
      return false;
    }
    return true;
  }

  void place(VaryColumn& column, const VaryBlock& block) {
    const std::size_t count = column.input.count();
    const auto same = std::find_if(plan.axes.begin(), plan.axes.end(), [&](const VaryAxis& axis) {
      return !block.zip.empty() && axis.zip == block.zip;
    });
    column.axis = static_cast<std::size_t>(same - plan.axes.begin());
    if (same == plan.axes.end()) {
      plan.axes.push_back({count, 1, block.zip});
    } else if (same->count != count) {
      problems.add(block.origin, "vary.zip", toml_string(block.zip),
                   "blocks that are zipped need equal numbers of values, here " + std::to_string(count) + " and " +
                       std::to_string(same->count));
    }
  }

  void add(const RawBlock& raw, std::size_t i) {
    if (!well_formed(raw, i)) return;
    VaryColumn column;
    column.input.key = raw.block.key;
    column.address = find_key(raw.block.key);
    column.origin = raw.block.origin;
    if (!variable(column.address, raw.block)) return;
    value_count += raw.has("values") ? raw.block.values.items.size() : raw.block.count;
    if (value_count > kMaxScenarios) {
      problems.add(raw.block.origin, "vary", "more than 10,000,000 values in all blocks");
      return;
    }
    if (!fill_values(column, raw.block) || !fill_variants(column, raw)) return;
    const bool twice = std::any_of(plan.columns.begin(), plan.columns.end(),
                                   [&](const VaryColumn& other) { return other.input.key == column.input.key; });
    if (twice) {
      problems.add(raw.block.origin, "vary.key", toml_string(raw.block.key), "is varied twice");
      return;
    }
    place(column, raw.block);
    plan.columns.push_back(std::move(column));
    plan.blocks.push_back(raw.block);
  }

  void count(const Origin& origin) {
    for (auto axis = plan.axes.rbegin(); axis != plan.axes.rend(); ++axis) {
      axis->stride = plan.scenario_count;
      if (axis->count > kMaxScenarios / plan.scenario_count) {
        problems.add(origin, "vary", "more than 10,000,000 scenarios");
        plan.scenario_count = 1;
        return;
      }
      plan.scenario_count *= axis->count;
    }
  }
};

}  // namespace

VaryPlan plan_vary(const std::vector<Entry>& entries, const std::vector<Entry>& tables, const Origin& fallback,
                   Problems& problems) {
  std::vector<RawBlock> raws;
  for (const Entry& table : tables) {
    const std::string pattern = pattern_of(table.path);
    if (pattern == "vary[]") {
      raws.emplace_back();
      raws.back().block.origin = table.origin;
    }
  }
  // Tables come in line order; so do blocks, and block i is the i-th of them.
  for (std::size_t i = 0; i < raws.size(); ++i) {
    for (const Entry& table : tables) {
      if (table.path.starts_with(block_prefix(i) + "variant[")) {
        raws[i].variants.tables.push_back({table.path.substr(block_prefix(i).size()), {}, table.origin});
      }
    }
  }
  for (const Entry& entry : entries) {
    if (!entry.path.starts_with("vary")) continue;
    const std::size_t close = entry.path.find("].");
    std::size_t i = raws.size();
    if (entry.path.starts_with("vary[") && close != std::string::npos) {
      i = static_cast<std::size_t>(find_key(entry.path.substr(0, close + 2) + "key").index);
    }
    if (i >= raws.size()) {
      problems.add(entry.origin, entry.path, spelled(entry.value),
                   "there are " + std::to_string(raws.size()) + " [[vary]] blocks, counted from 0");
      continue;
    }
    read_block_entry(raws[i], entry, block_prefix(i).size(), problems);
  }
  Planner planner{problems, {}, 0};
  for (std::size_t i = 0; i < raws.size(); ++i) planner.add(raws[i], i);
  planner.count(raws.empty() ? fallback : raws.front().block.origin);
  return std::move(planner.plan);
}

}  // namespace unbruised::studies
