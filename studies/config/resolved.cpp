#include <functional>

#include "studies/config/execution_error.hpp"
#include "studies/config/measured_data.hpp"
#include "studies/config/mesh_file.hpp"
#include "studies/config/study_data.hpp"
#include "studies/text/hex_text.hpp"

namespace unbruised::studies {
namespace {

struct Writer {
  const StudyData& data;
  std::vector<std::string> varied_keys;
  std::string out;

  void header(const std::string& text) { out += (out.empty() ? "" : "\n") + text + "\n"; }

  void line(std::string_view path, const std::string& value) {
    if (!value.empty()) out += std::string(path.substr(path.rfind('.') + 1)) + " = " + value + "\n";
  }

  /// By which another run finds the same mesh; empty: there is none.
  static std::string of_mesh(std::string_view path, const Scenario& scenario) {
    const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
    if (lattice == nullptr || !lattice->mesh) return "";
    const MeshSource& source = lattice->mesh->source();
    if (path == kMeshFileKey) return toml_string(source.file);
    return toml_string(path == kMeshUnitKey ? source.unit : hex_text(source.hash));
  }

  /// All used keys of one table, e.g. "cell" or "product.particle[]".
  void keys(const std::string& table, Scenario& scenario, int index) {
    StudySettings settings = data.settings;
    for (const KeySpec& spec : key_table()) {
      if (spec.path.substr(0, spec.path.rfind('.')) != table) continue;
      if (!is_used(spec, scenario, settings.kind, varied_keys)) continue;
      if (spec.study_field != nullptr) line(spec.path, spelled(spec, spec.study_field(settings)));
      if (spec.field != nullptr) line(spec.path, spelled(spec, spec.field(scenario, index)));
      if (spec.use == Use::mesh) line(spec.path, of_mesh(spec.path, scenario));
      if (spec.path == "product.kind") {
        line(spec.path,
             std::holds_alternative<NetworkParameters>(scenario.product) ? "\"network\"" : "\"lattice\"");
      }
    }
  }

  /// [product.source] or [gripper.source], where there is anything to say.
  void sources(const std::string& table) {
    const std::string prefix = table + ".source.";
    bool is_first = true;
    for (const Entry& source : data.sources) {
      if (!source.path.starts_with(prefix)) continue;
      if (is_first) header("[" + table + ".source]");
      is_first = false;
      out += source.path.substr(prefix.size()) + " = " + toml_string(source.value.text) + "\n";
    }
  }

  void table(const std::string& name, Scenario& scenario) {
    header("[" + name + "]");
    keys(name, scenario, 0);
  }

  /// The tables of a list of the scenario, "product.particle[]", each under a header.
  void list_of(const std::string& path, const std::string& header_text, Scenario& scenario) {
    for (std::size_t i = 0; i < scenario_list_size(scenario, path).value_or(0); ++i) {
      header("[[" + header_text + "]]");
      keys(path, scenario, static_cast<int>(i));
    }
  }

  /// The product's table under `name` ("product" or "vary.variant"), without its header.
  void product(const std::string& name, Scenario& scenario) {
    keys("product", scenario, 0);
    for (const std::string leaf : {"layer", "particle", "spring", "load"})
      list_of("product." + leaf + "[]", name + "." + leaf, scenario);
  }

  /// What stands in tables of its own below that of a gripper, which is under `name`.
  void parts_of_gripper(const std::string& name, Scenario& scenario) {
    header("[" + name + ".pad]");
    keys("gripper.pad", scenario, 0);
    if (scenario_uses(Use::range, scenario, varied_keys)) {
      header("[" + name + ".range]");
      keys("gripper.range", scenario, 0);
    }
    list_of("gripper.finger[]", name + ".finger", scenario);
  }

  void variants(const VaryColumn& column) {
    std::size_t grippers = 1;
    for (const VaryColumn& other : data.plan.columns) {
      if (other.input.key == "gripper.use") grippers = other.input.count();
    }
    const bool is_product = column.input.key == "product.use";
    for (std::size_t j = 0; j < column.input.count(); ++j) {
      Scenario scenario = data.bases[is_product ? j * grippers : j];
      header("[[vary.variant]]");
      if (is_product) {
        product("vary.variant", scenario);
        header("[vary.variant.limits]");
        keys("limits", scenario, 0);
      } else {
        keys("gripper", scenario, 0);
        parts_of_gripper("vary.variant", scenario);
      }
    }
  }

  void block(std::size_t i) {
    VaryBlock block = data.plan.blocks[i];
    header("[[vary]]");
    for (const KeySpec& spec : key_table()) {
      if (!spec.path.starts_with("vary[].")) continue;
      if (spec.vary_field == nullptr) {
        if (!block.values.items.empty()) line(spec.path, spelled(block.values));
      } else if (spec.path == "vary[].count") {
        if (block.count > 0) line(spec.path, std::to_string(block.count));
      } else if (spec.path != "vary[].scale" || block.count > 0) {
        line(spec.path, spelled(spec, spec.vary_field(block)));
      }
    }
    if (data.plan.columns[i].is_use()) variants(data.plan.columns[i]);
  }

  /// [[variable]], [[random]] and the like.
  void search_blocks() {
    StudyBlocks blocks;
    const std::string searched = fits_curves(data.settings.kind) ? "parameter" : "variable";
    for (const SearchVariable& v : data.variables) {
      (fits_curves(data.settings.kind) ? blocks.parameter : blocks.variable)
          .push_back({.key = v.key,
                      .from = v.from,
                      .to = v.to,
                      .scale = v.scale == optimizer::Scale::log ? VaryScale::log : VaryScale::linear,
                      .start = v.start,
                      .origin = {}});
    }
    blocks.random = data.random_blocks;
    for (const RankCorrelation& c : data.correlations) {
      const auto key = [&](std::size_t i) { return key_behind(data.randoms[i].key); };
      blocks.correlation.push_back({.between = {key(c.first), key(c.second)}, .value = c.value, .origin = {}});
    }
    for (const StrategyCandidate& c : data.candidates) blocks.candidate.push_back({c.name, "", {}});
    block_list(searched, blocks, data.variables.size());
    const CurveTest test = data.calibrate.test;
    for (const MeasuredCurve& curve : data.calibrate.curves) {
      SpecimenBlock block;
      block.name = curve.specimen;
      block.outcome = curve.outcome;
      (column_over(test) == "time_s" ? block.time_s : block.closure_m) = curve.x;
      (column_measured(test) == "force_N" ? block.force_N : block.closure_m) = curve.y;
      blocks.specimen.push_back(std::move(block));
    }
    block_list("specimen", blocks, blocks.specimen.size());
    block_list("random", blocks, blocks.random.size());
    block_list("correlation", blocks, blocks.correlation.size());
    block_list("candidate", blocks, blocks.candidate.size());
  }

  void block_list(const std::string& list, StudyBlocks& blocks, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      header("[[" + list + "]]");
      for (const KeySpec& spec : key_table()) {
        if (!spec.path.starts_with(list + "[].")) continue;
        const std::string value = spelled(spec, spec.block_field(blocks, static_cast<int>(i)));
        if (value != "[]") line(spec.path, value);
      }
      if (list != "candidate") continue;
      Scenario scenario = data.candidates[i].scenario;
      keys("strategy", scenario, 0);
      list_of("strategy.waypoint[]", "candidate.waypoint", scenario);
    }
  }
};

/// The tables beside [study] that a kind looks at: its settings, in the order of the reference.
std::vector<std::string> tables_of_kind(StudyKind kind) {
  std::vector<std::string> tables;
  for (const KeySpec& spec : key_table()) {
    const std::string table(spec.path.substr(0, spec.path.rfind('.')));
    if (spec.study_field == nullptr || table == "study" || !kind_uses(spec.use, kind)) continue;
    if (tables.empty() || tables.back() != table) tables.push_back(table);
  }
  return tables;
}

}  // namespace

std::string resolved_text(const StudyData& data) {
  Writer writer{data, {}, {}};
  bool product_varies = false;
  bool gripper_varies = false;
  for (const VaryColumn& column : data.plan.columns) {
    writer.varied_keys.push_back(column.input.key);
    product_varies = product_varies || column.input.key == "product.use";
    gripper_varies = gripper_varies || column.input.key == "gripper.use";
  }
  Scenario base = data.bases.front();
  writer.table("study", base);
  for (const std::string& table : tables_of_kind(data.settings.kind)) writer.table(table, base);
  if (!product_varies) {
    writer.header("[product]");
    writer.product("product", base);
    writer.sources("product");
  }
  if (has_gripper(base) && !gripper_varies) {
    writer.table("gripper", base);
    writer.parts_of_gripper("gripper", base);
    writer.sources("gripper");
  }
  writer.table("cell", base);
  if (scenario_uses(Use::lattice_support, base, writer.varied_keys)) writer.table("cell.conveyor", base);
  writer.list_of("cell.surface[]", "cell.surface", base);
  if (scenario_uses(Use::sensor, base, writer.varied_keys)) writer.table("sensor", base);
  if (has_gripper(base)) {
    writer.table("strategy", base);
    writer.list_of("strategy.waypoint[]", "strategy.waypoint", base);
  }
  if (has_robot(base)) {
    writer.table("robot", base);
    writer.list_of("robot.joint[]", "robot.joint", base);
  }
  if (!product_varies) writer.table("limits", base);
  writer.table("simulation", base);
  for (std::size_t i = 0; i < data.plan.blocks.size(); ++i) writer.block(i);
  writer.search_blocks();
  return writer.out;
}

}  // namespace unbruised::studies
