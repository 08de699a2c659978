#include <algorithm>
#include <map>
#include <system_error>

#include "core/scenario/plausible.hpp"
#include "studies/config/library.hpp"
#include "studies/config/schema.hpp"
#include "studies/config/usual_damping.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

std::string type_words(const KeySpec& spec) {
  const std::string n = std::to_string(spec.size);
  switch (spec.type) {
    case KeyType::number:
      return "number";
    case KeyType::optional_number:
      return spec.required ? "number" : "number or \"none\"";
    case KeyType::integer:
      return "integer";
    case KeyType::boolean:
      return "true or false";
    case KeyType::text:
      return "string";
    case KeyType::choice:
      return choices_text(spec);
    case KeyType::numbers:
      return n + " numbers";
    case KeyType::maybe_numbers:
      return n + " numbers or \"none\"";
    case KeyType::integers:
      return n + " integers";
    case KeyType::axes:
      return "some of \"x\", \"y\", \"z\"";
    case KeyType::series:
      return "numbers";
    case KeyType::vector_series:
      return "[x, y, z] each";
    case KeyType::texts:
      return "strings";
    case KeyType::any_array:
      return "numbers, strings or booleans";
  }
  return "";
}

/// A scenario in which every key has a field.
Scenario specimen(const KeySpec& spec) {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).finger.resize(1);
  scenario.strategy.waypoint.resize(1);
  scenario.cell.surface.resize(1);
  scenario.robot.joint.resize(1);
  std::get<LatticeParameters>(scenario.product).layer.resize(1);
  if (spec.path.find("product.") == 0 && (spec.use == Use::network || spec.use == Use::network_support)) {
    NetworkParameters network;
    network.particle.resize(1);
    network.spring.resize(1);
    network.load.resize(1);
    scenario.product = network;
  }
  give_usual_layer_damping(scenario);
  give_usual_product_damping(scenario);
  return scenario;
}

std::string default_words(const KeySpec& spec) {
  if (spec.required) return "required";
  if (spec.path == "product.kind") return "\"lattice\"";
  if (!spec.default_words.empty()) return std::string(spec.default_words);
  std::string words;
  if (spec.field != nullptr) {
    Scenario scenario = specimen(spec);
    words = spelled(spec, spec.field(scenario, 0));
  } else if (spec.study_field != nullptr) {
    StudySettings settings;
    words = spelled(spec, spec.study_field(settings));
  } else if (spec.block_field != nullptr) {
    StudyBlocks blocks{{VariableBlock{}}, {VariableBlock{}},    {SpecimenBlock{}},
                       {RandomBlock{}},   {CorrelationBlock{}}, {CandidateBlock{}}};
    words = spelled(spec, spec.block_field(blocks, 0));
  } else if (spec.path == "vary[].scale") {
    words = "\"linear\"";
  }
  const bool nothing = words.empty() || (words == "[]" && spec.type != KeyType::axes);
  return nothing ? "none" : words;
}

std::string unit_words(const KeySpec& spec) {
  const Unit* unit = unit_of(spec.path);
  const bool numeric = spec.type != KeyType::text && spec.type != KeyType::choice && spec.type != KeyType::boolean;
  return unit == nullptr || !numeric ? "" : std::string(unit->display);
}

std::string rule_words(const KeySpec& spec) {
  std::string rule = spec.range.text();
  add_part(rule, "; ", spec.note);
  return rule;
}

std::string where_used(Use use) {
  switch (use) {
    case Use::always:
      return "";
    case Use::lattice:
      return "lattice products";
    case Use::network:
      return "networks";
    case Use::with_axis:
      return "cylinders and solids of revolution";
    case Use::revolution:
      return "solids of revolution";
    case Use::superellipsoid:
      return "superellipsoids";
    case Use::mesh:
      return "products whose shape is a mesh";
    case Use::gripper:
      return "studies with a gripper";
    case Use::not_gripper:
      return "studies without a gripper";
    case Use::not_window:
      return "studies with a gripper, but not window studies";
    case Use::support:
      return "cells with a support";
    case Use::lattice_support:
      return "lattice products on a support";
    case Use::network_support:
      return "networks on a support";
    case Use::tracking:
      return "palms that track";
    case Use::stop:
      return "cycles that are stopped, without an arm";
    case Use::sensor:
      return "six-axis sensors";
    case Use::range:
      return "grippers with range sensors";
    case Use::guard:
      return "approaches with a guard";
    case Use::range_guard:
      return "guards by range";
    case Use::force_guard:
      return "guards by force";
    case Use::position_hold:
      return "fingers that a lock holds";
    case Use::robot:
      return "palms that an arm carries";
    case Use::elastic_arm:
      return "arms whose joints give way";
    default:
      return listed(kinds_that_use(use), "and") + " studies";
  }
}

std::string explanation(const KeySpec& spec) {
  std::string out = std::string(spec.path) + "\n  " + std::string(spec.meaning) + "\n";
  out += "  type: " + type_words(spec);
  if (const std::string unit = unit_words(spec); !unit.empty()) out += " in " + unit;
  out += "\n  default: " + default_words(spec) + "\n";
  if (const std::string rule = rule_words(spec); !rule.empty()) out += "  rule: " + rule + "\n";
  for (const PlausibleRow& row : plausible_rows()) {
    if (row.fields.front() == spec.path && !row.is_derived()) out += "  plausible: " + row.range_text() + "\n";
  }
  if (const auto where = where_used(spec.use); !where.empty()) out += "  used by: " + where + "\n";
  return out;
}

std::string table_of(std::string_view path) { return std::string(path.substr(0, path.rfind('.'))); }

std::string markdown_cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, "\\");
  return text.empty() ? " " : text;
}

std::optional<LibraryEntry> library_entry(const std::filesystem::path& file, const std::filesystem::path& root) {
  std::string why;
  const auto text = read_text_file(file, why);
  if (!text) return std::nullopt;
  const Document document = parse_document(*text, std::make_shared<const std::string>(file.string()), 0);
  if (!document.problems.empty()) return std::nullopt;
  LibraryEntry entry;
  entry.path = file.lexically_relative(root).generic_string();
  entry.name = file.stem().string();
  const bool is_study = std::any_of(document.tables.begin(), document.tables.end(),
                                    [](const Entry& table) { return table.path == "study"; });
  if (!is_study) {
    entry.kind = entry.path.starts_with("grippers/")     ? LibraryEntry::Kind::gripper
                 : entry.path.starts_with("strategies/") ? LibraryEntry::Kind::strategy
                                                         : LibraryEntry::Kind::product;
  }
  for (const Entry& item : document.entries) {
    const std::string prefix = is_study ? "study." : "";
    if (item.path == prefix + "name") entry.name = item.value.text;
    if (item.path == prefix + "description") entry.description = item.value.text;
  }
  return entry;
}

}  // namespace

std::optional<std::string> explain_key(const std::string& key) {
  if (const KeyAddress address = find_key(key); address.spec != nullptr) return explanation(*address.spec);
  if (const KeyAddress address = find_strategy_key(key); address.spec != nullptr)
    return explanation(*address.spec);
  const std::string pattern = pattern_of(key);
  std::vector<std::string> inside;
  for (const KeySpec& spec : key_table()) {
    const std::string table = table_of(spec.path);
    const bool is_inside = spec.path == pattern || table == pattern || table == pattern + "[]" ||
                           spec.path.starts_with(pattern + ".") || spec.path.starts_with(pattern + "[].");
    if (is_inside) inside.push_back(explanation(spec));
  }
  if (inside.empty()) return std::nullopt;
  return separated(inside, "\n");
}

std::string explain_all() { return separated(key_table(), "\n", explanation); }

std::string reference_markdown() {
  std::string out;
  std::string table;
  for (const KeySpec& spec : key_table()) {
    if (const std::string own = table_of(spec.path); own != table) {
      table = own;
      const bool list = table.ends_with("[]");
      const std::string header = list ? "[[" + table.substr(0, table.size() - 2) + "]]" : "[" + table + "]";
      out += (out.empty() ? "" : "\n") + std::string("### `") + header + "`\n\n";
      out += "| key | type | unit | default | rule | meaning |\n|---|---|---|---|---|---|\n";
    }
    const auto where = where_used(spec.use);
    const std::string key(spec.path.substr(table.size() + 1));
    out += "| `" + key + "` | " + markdown_cell(type_words(spec)) + " | " + markdown_cell(unit_words(spec)) +
           " | " + markdown_cell(default_words(spec)) + " | " + markdown_cell(rule_words(spec)) + " | " +
           markdown_cell(std::string(spec.meaning) + (where.empty() ? "" : " For " + where + ".")) + " |\n";
  }
  return out;
}

std::string plausible_markdown() {
  std::string out = "| quantity | from | plausible | unit | source |\n|---|---|---|---|---|\n";
  for (const PlausibleRow& row : plausible_rows()) {
    const std::string key = "`" + std::string(row.fields.front()) + "`" + (row.is_derived() ? " and others" : "");
    out += "| " + std::string(row.quantity) + " | " + key + " | " + row.range_text() + " | " +
           markdown_cell(std::string(row.unit)) + " | " + std::string(row.source) + " |\n";
  }
  return out;
}

std::vector<std::string> differing_keys(const std::string& resolved_a, const std::string& resolved_b) {
  const auto values = [](const std::string& text) {
    std::map<std::string, std::string> map;
    for (const Entry& entry : parse_document(text, std::make_shared<const std::string>("config"), 0).entries) {
      map[entry.path] = spelled(entry.value);
    }
    return map;
  };
  const auto a = values(resolved_a);
  const auto b = values(resolved_b);
  std::vector<std::string> out;
  for (const auto& [key, value] : a) {
    const auto other = b.find(key);
    if (other == b.end() || other->second != value) out.push_back(key);
  }
  for (const auto& [key, value] : b) {
    if (!a.contains(key)) out.push_back(key);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<LibraryEntry> list_library(const std::filesystem::path& config_root) {
  std::vector<LibraryEntry> out;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator it(config_root, error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() != ".toml") continue;
    if (auto entry = library_entry(it->path(), config_root)) out.push_back(std::move(*entry));
  }
  std::sort(out.begin(), out.end(), [](const LibraryEntry& a, const LibraryEntry& b) {
    return std::pair(a.kind, a.path) < std::pair(b.kind, b.path);
  });
  return out;
}

}  // namespace unbruised::studies
