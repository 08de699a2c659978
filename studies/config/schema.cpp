#include "studies/config/schema.hpp"

#include <algorithm>
#include <array>
#include <variant>

namespace unbruised::studies {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

const std::vector<std::string>& key_patterns() {
  static const std::vector<std::string> patterns = [] {
    std::vector<std::string> all;
    for (const KeySpec& spec : key_table()) all.emplace_back(spec.path);
    return all;
  }();
  return patterns;
}

const std::vector<std::string>& table_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const std::string& path : key_patterns()) {
      const std::string table = path.substr(0, path.rfind('.'));
      if (std::find(all.begin(), all.end(), table) == all.end()) all.push_back(table);
    }
    return all;
  }();
  return names;
}

KeyAddress find_key(std::string_view path) {
  static const std::unordered_map<std::string_view, const KeySpec*> index = [] {
    std::unordered_map<std::string_view, const KeySpec*> map;
    for (const KeySpec& spec : key_table()) map.emplace(spec.path, &spec);
    return map;
  }();
  std::string pattern = pattern_of(path);
  std::vector<int> numbers;
  for (std::size_t i = path.find('['); i != std::string_view::npos; i = path.find('[', i + 1)) {
    std::size_t end = i + 1;
    int number = 0;
    while (end < path.size() && is_digit(path[end]) && number < 100'000'000) {
      number = 10 * number + (path[end++] - '0');
    }
    if (end == i + 1 || end >= path.size() || path[end] != ']') return {};
    numbers.push_back(number);
  }
  std::vector<int> elements;
  auto found = index.find(pattern);
  while (found == index.end() && pattern.ends_with("[]") && !numbers.empty()) {
    pattern.resize(pattern.size() - 2);
    elements.push_back(numbers.back());
    numbers.pop_back();
    found = index.find(pattern);
  }
  std::reverse(elements.begin(), elements.end());
  if (found == index.end()) return {};
  const KeyType type = found->second->type;
  const bool has_items = is_number_array(type) || type == KeyType::integers;
  const std::size_t depth = type == KeyType::vector_series ? 2 : (has_items ? 1 : 0);
  if (!elements.empty() && elements.size() != depth) return {};
  return {found->second, numbers.empty() ? 0 : numbers[0], std::move(elements)};
}

KeyAddress find_strategy_key(std::string_view path) {
  if (!path.starts_with("candidate[")) return {};
  return find_key("strategy." + std::string(path.substr(path.find('.') + 1)));
}

bool is_number_array(KeyType type) {
  return type == KeyType::numbers || type == KeyType::maybe_numbers || type == KeyType::series ||
         type == KeyType::vector_series;
}

std::optional<std::size_t> scenario_list_size(const Scenario& scenario, std::string_view path) {
  if (path.starts_with("strategy.waypoint[")) return scenario.strategy.waypoint.size();
  if (path.starts_with("cell.surface[")) return scenario.cell.surface.size();
  if (path.starts_with("robot.joint[")) return scenario.robot.joint.size();
  if (path.starts_with("gripper.finger[")) {
    const ParallelJawParameters* jaw = parallel_jaw(scenario);
    return jaw == nullptr ? 0 : jaw->finger.size();
  }
  if (path.starts_with("product.layer[")) {
    const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
    return lattice == nullptr ? 0 : lattice->layer.size();
  }
  const auto* network = std::get_if<NetworkParameters>(&scenario.product);
  if (network == nullptr) return std::nullopt;
  if (path.starts_with("product.particle[")) return network->particle.size();
  if (path.starts_with("product.spring[")) return network->spring.size();
  if (path.starts_with("product.load[")) return network->load.size();
  return std::nullopt;
}

bool has_field(const KeySpec& spec, const Scenario& scenario, int index) {
  if (spec.field == nullptr) return false;
  if (spec.path.starts_with("gripper.") && !has_gripper(scenario)) return false;
  if (const auto size = scenario_list_size(scenario, spec.path)) return static_cast<std::size_t>(index) < *size;
  if (!spec.path.starts_with("product.") || spec.path == "product.friction") return true;
  const bool is_lattice = std::holds_alternative<LatticeParameters>(scenario.product);
  return is_lattice && spec.path.find("[]") == std::string_view::npos;
}

bool is_of_block(std::string_view path) {
  constexpr std::array<std::string_view, 6> kLists = {"variable[", "parameter[",   "specimen[",
                                                      "random[",   "correlation[", "candidate["};
  return std::any_of(kLists.begin(), kLists.end(), [&](std::string_view list) { return path.starts_with(list); });
}

}  // namespace unbruised::studies
