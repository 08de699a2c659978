#include "studies/config/assemble.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "core/scenario/gripper.hpp"
#include "core/scenario/opening.hpp"
#include "studies/config/mesh_file.hpp"
#include "studies/config/usual_damping.hpp"

namespace unbruised::studies {
namespace {

/// Sets of keys of which only one set may be given.
const std::array<std::array<std::vector<std::string_view>, 2>, 2> kAlternatives = {{
    {{{"product.mass_kg"}, {"product.density_kg_m3"}}},
    {{{"product.relaxation_time_s"}, {"product.loss_ratio", "product.at_frequency_Hz"}}},
}};

bool is_none(const Entry& entry) { return entry.value.kind == Value::Kind::text && entry.value.text == "none"; }

struct Assembler {
  const AssemblyInput& input;
  Problems& problems;
  Assembly out;
  std::vector<LayeredEntry> entries = input.entries;

  bool varied(std::string_view key) const {
    return std::find(input.varied_keys.begin(), input.varied_keys.end(), key) != input.varied_keys.end();
  }

  /// The highest layer that gives any of the keys, and that entry.
  std::optional<LayeredEntry> highest(const std::vector<std::string_view>& keys) const {
    std::optional<LayeredEntry> best;
    for (const LayeredEntry& item : entries) {
      if (is_none(*item.entry)) continue;
      if (std::find(keys.begin(), keys.end(), item.entry->path) == keys.end()) continue;
      if (!best || item.layer >= best->layer) best = item;
    }
    return best;
  }

  void drop(const std::vector<std::string_view>& keys) {
    std::erase_if(entries, [&](const LayeredEntry& item) {
      return std::find(keys.begin(), keys.end(), item.entry->path) != keys.end();
    });
  }

  /// A key displaces its alternative from lower layers; in the same layer both are an error.
  void resolve_alternatives() {
    for (const auto& [first, second] : kAlternatives) {
      const auto is_varied = [&](const auto& keys) {
        return std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return varied(key); });
      };
      const auto a = highest(first);
      const auto b = highest(second);
      const int rank_a = is_varied(first) ? 3 : (a ? static_cast<int>(a->layer) : -1);
      const int rank_b = is_varied(second) ? 3 : (b ? static_cast<int>(b->layer) : -1);
      if (rank_a < 0 || rank_b < 0) continue;
      if (rank_a != rank_b) {
        drop(rank_a > rank_b ? second : first);
      } else if (b) {
        problems.add(b->entry->origin, b->entry->path, spelled(b->entry->value),
                     "excludes " + std::string(first.front()) + "; give one of them");
        drop(second);
      } else {
        problems.add(out.fallback, second.front(),
                     "excludes " + std::string(first.front()) + "; vary one of them");
      }
    }
  }

  /// A study that lists particles, springs, loads or fingers replaces the whole list of the library file.
  void resolve_lists() {
    for (const std::string_view list :
         {"product.particle[", "product.spring[", "product.load[", "gripper.finger["}) {
      const auto lists = [&](const LayeredEntry& item) {
        return item.layer == Layer::study && item.entry->path.starts_with(list);
      };
      if (std::none_of(entries.begin(), entries.end(), lists)) continue;
      std::erase_if(entries, [&](const LayeredEntry& item) {
        return item.layer == Layer::library && item.entry->path.starts_with(list);
      });
    }
  }

  std::size_t list_size(std::string_view list) const {
    int count = 0;
    for (const LayeredEntry& item : entries) {
      if (item.layer == Layer::command_line || !item.entry->path.starts_with(list)) continue;
      count = std::max(count, find_key(item.entry->path).index + 1);
    }
    return static_cast<std::size_t>(count);
  }

  /// What kind of study and scenario it is must be known before its keys can be placed.
  void prepare() {
    Scenario& scenario = out.scenario;
    for (const LayeredEntry& item : entries) {
      if (item.entry->path != "product.kind" || item.entry->value.text != "network") continue;
      scenario.product = NetworkParameters{};
    }
    const auto kind = highest({"product.kind"});
    if (kind && kind->entry->value.text != "network") scenario.product = LatticeParameters{};
    if (auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) {
      lattice->layer.resize(list_size("product.layer["));
    }
    if (auto* network = std::get_if<NetworkParameters>(&scenario.product)) {
      network->particle.resize(list_size("product.particle["));
      network->spring.resize(list_size("product.spring["));
      network->load.resize(list_size("product.load["));
      scenario.cell.support = false;
    }
    scenario.strategy.waypoint.resize(list_size("strategy.waypoint["));
    scenario.cell.surface.resize(list_size("cell.surface["));
    scenario.robot.joint.resize(list_size("robot.joint["));
    if (input.has_gripper) {
      scenario.gripper = ParallelJawParameters{};
      jaw_of(scenario).finger.resize(list_size("gripper.finger["));
    }
    give_usual_layer_damping(scenario);
    if (!input.has_gripper) return;
    if (std::holds_alternative<NetworkParameters>(scenario.product)) {
      problems.add(out.origin_of("gripper.use"), "[gripper]",
                   "a network cannot be gripped in this version; remove [gripper]");
    }
  }

  bool used(const KeySpec& spec) const {
    // A gripped network is refused as such; that its run has a length is not the mistake.
    const bool gripped_network =
        input.has_gripper && std::holds_alternative<NetworkParameters>(out.scenario.product);
    if (gripped_network && spec.use == Use::not_gripper) return true;
    // An arm whose file cannot be read is refused as such.
    const bool is_of_arm = spec.use == Use::robot || spec.use == Use::elastic_arm;
    if (is_of_arm && highest({"robot.urdf"})) return true;
    return is_used(spec, out.scenario, out.settings.kind, input.varied_keys);
  }

  std::optional<FieldRef> field_of(const KeyAddress& address) {
    const KeySpec& spec = *address.spec;
    if (spec.study_field != nullptr) return spec.study_field(out.settings);
    if (spec.field == nullptr) return std::nullopt;
    return spec.field(out.scenario, address.index);
  }

  /// Is there a table and an element of that number?
  std::optional<std::string> missing_place(const KeyAddress& address) {
    const auto count = scenario_list_size(out.scenario, address.spec->path);
    if (count && static_cast<std::size_t>(address.index) >= *count) {
      return "there are only " + std::to_string(*count) + " of them, counted from 0";
    }
    const auto field = field_of(address);
    const auto* maybe = field ? std::get_if<MaybeSpan>(&*field) : nullptr;
    if (maybe != nullptr && !address.elements.empty() && maybe->data(maybe->object) == nullptr) {
      return "is not given here; write the whole array first";
    }
    if (field && !has_element(*field, address.elements)) return "the array has no such element";
    return std::nullopt;
  }

  /// Keys that exist but have no effect here: can their field even be reached?
  bool reachable(const KeySpec& spec) const {
    const bool lattice = std::holds_alternative<LatticeParameters>(out.scenario.product);
    switch (spec.use) {
      case Use::lattice:
      case Use::with_axis:
      case Use::revolution:
      case Use::superellipsoid:
      case Use::mesh:
        return lattice || !spec.path.starts_with("product.");
      case Use::network:
      case Use::network_support:
        return !lattice || !spec.path.starts_with("product.");
      case Use::gripper:
      case Use::range:
      case Use::force_guard:
      case Use::position_hold:
        return input.has_gripper || !spec.path.starts_with("gripper.");
      default:
        return true;
    }
  }

  void apply(const LayeredEntry& item) {
    const Entry& entry = *item.entry;
    const KeyAddress address = find_key(entry.path);
    if (address.spec == nullptr) {
      problems.add(entry.origin, entry.path, spelled(entry.value), unknown_key_rule(entry.path));
      return;
    }
    const KeySpec& spec = *address.spec;
    if (!reachable(spec)) {
      problems.add(entry.origin, entry.path, spelled(entry.value), why_unused(spec.use, out.scenario));
      return;
    }
    out.given[entry.path] = entry.origin;
    if (const auto rule = check_value(spec, entry.value, address.elements.size())) {
      problems.add(entry.origin, entry.path, spelled(entry.value), *rule);
      return;
    }
    if (const auto rule = missing_place(address)) {
      problems.add(entry.origin, entry.path, spelled(entry.value), *rule);
      return;
    }
    if (const auto field = field_of(address)) assign(spec, *field, entry.value, address.elements);
  }

  void give_damping() {
    constexpr std::array<std::string_view, 3> kDampingKeys = {"product.relaxation_time_s", "product.loss_ratio",
                                                              "product.at_frequency_Hz"};
    const auto is_varied = [&](std::string_view key) { return varied(key); };
    if (std::none_of(kDampingKeys.begin(), kDampingKeys.end(), is_varied))
      give_usual_product_damping(out.scenario);
  }

  void report_unused() {
    for (const LayeredEntry& item : entries) {
      const Entry& entry = *item.entry;
      const KeyAddress address = find_key(entry.path);
      if (address.spec == nullptr || !reachable(*address.spec)) continue;
      // A product's file may bring limits that need a gripper; only what the study itself says must be used.
      if (item.layer == Layer::library && entry.path.starts_with("limits.")) continue;
      if (used(*address.spec)) continue;
      problems.add(entry.origin, entry.path, spelled(entry.value), why_unused(address.spec->use, out.scenario));
    }
    for (const std::string& key : input.varied_keys) {
      const KeyAddress address = find_key(key);
      if (address.spec == nullptr) continue;
      if (!used(*address.spec)) {
        problems.add(out.origin_of("vary " + key), key, why_unused(address.spec->use, out.scenario));
      } else if (reachable(*address.spec)) {
        if (const auto rule = missing_place(address)) problems.add(out.origin_of("vary " + key), key, *rule);
      }
    }
  }

  /// The mesh of the file that the entries name; where it could not be read, that was said.
  void attach_mesh() {
    auto* lattice = std::get_if<LatticeParameters>(&out.scenario.product);
    const auto file = highest({kMeshFileKey}), unit = highest({kMeshUnitKey});
    if (lattice == nullptr || input.meshes == nullptr || !file || !unit) return;
    const auto found = input.meshes->find({file->entry->value.text, unit->entry->value.text});
    if (found != input.meshes->end()) lattice->mesh = found->second;
  }

  /// Where no opening says how far the pads stand away, the resolved config says the usual way.
  void settle_approach_gap() {
    Scenario& scenario = out.scenario;
    const bool follows = opening_m(scenario.gripper) || varied("gripper.opening_m");
    if (!has_gripper(scenario) || follows || scenario.cell.approach_gap_m || varied("cell.approach_gap_m")) return;
    scenario.cell.approach_gap_m = kUsualApproachGap_m;
  }

  void require(const std::string& path) {
    if (!out.given.contains(path) && !varied(path)) problems.add(out.origin_of(path), path, "missing");
  }

  void report_missing() {
    const auto* network = std::get_if<NetworkParameters>(&out.scenario.product);
    const auto* lattice = std::get_if<LatticeParameters>(&out.scenario.product);
    const bool lacks_mesh = lattice != nullptr && lattice->shape == Shape::mesh && !highest({kMeshFileKey});
    if (lacks_mesh) {
      const std::string key(kMeshFileKey);
      problems.add(out.origin_of(key), key, "missing; product.shape = \"mesh\" needs it, and product.mesh_unit");
    }
    for (const KeySpec& spec : key_table()) {
      if (lacks_mesh && spec.path == "product.size_m") continue;  // the mesh would bring it
      if (!spec.required || spec.path.starts_with("vary[]") || is_of_block(spec.path)) continue;
      if (!used(spec)) continue;
      const std::size_t open = spec.path.find("[]");
      if (open == std::string_view::npos) {
        require(std::string(spec.path));
        continue;
      }
      const std::string list(spec.path.substr(0, open));
      const std::size_t count = scenario_list_size(out.scenario, spec.path).value_or(0);
      for (std::size_t i = 0; i < count; ++i) {
        const std::string path = list + "[" + std::to_string(i) + "]" + std::string(spec.path.substr(open + 2));
        // An array may come element by element, from CSV columns.
        if (spec.size > 0 && out.given.contains(path + "[0]")) {
          for (int k = 0; k < spec.size; ++k) require(path + "[" + std::to_string(k) + "]");
        } else {
          require(path);
        }
      }
    }
    if (network == nullptr && !highest({"product.mass_kg"}) && !highest({"product.density_kg_m3"}) &&
        !varied("product.mass_kg") && !varied("product.density_kg_m3")) {
      problems.add(out.origin_of("product.mass_kg"), "product.mass_kg", "missing; give mass_kg or density_kg_m3");
    }
  }
};

}  // namespace

Origin Assembly::origin_of(const std::string& key) const {
  if (const auto found = given.find(key); found != given.end()) return found->second;
  std::string table = key;
  while (true) {
    const std::size_t dot = table.rfind('.');
    if (dot == std::string::npos) return fallback;
    table.resize(dot);
    if (const auto found = tables.find(table); found != tables.end()) return found->second;
  }
}

Assembly assemble(const AssemblyInput& input, Problems& problems) {
  Assembler assembler{input, problems, {}};
  assembler.out.fallback = input.fallback;
  assembler.out.tables = input.tables;
  for (const std::string& key : input.varied_keys) {
    if (const auto found = input.tables.find("vary " + key); found != input.tables.end()) {
      assembler.out.given["vary " + key] = found->second;
    }
  }
  assembler.resolve_alternatives();
  assembler.resolve_lists();
  assembler.prepare();
  for (const LayeredEntry& item : assembler.entries) assembler.apply(item);
  assembler.attach_mesh();
  assembler.give_damping();
  assembler.settle_approach_gap();
  assembler.report_unused();
  if (input.is_complete) assembler.report_missing();
  return std::move(assembler.out);
}

}  // namespace unbruised::studies
