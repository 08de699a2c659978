#include "studies/config/study.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "studies/config/assemble.hpp"
#include "studies/config/box_rules.hpp"
#include "studies/config/contact_steps.hpp"
#include "studies/config/doubts.hpp"
#include "studies/config/execution_error.hpp"
#include "studies/config/library.hpp"
#include "studies/config/problems.hpp"
#include "studies/config/rules.hpp"
#include "studies/config/searching.hpp"
#include "studies/config/sources.hpp"
#include "studies/config/study_data.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kMaxNameLength = 64;
constexpr const char* kNameRule = "must be 1 to 64 letters, digits, '_' or '-'";

bool is_name(const std::string& text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !text.empty() && text.size() <= kMaxNameLength && std::all_of(text.begin(), text.end(), allowed);
}

bool is_text_key(const KeyAddress& address) {
  if (address.spec == nullptr) return false;
  const KeyType type = address.spec->type;
  return type == KeyType::text || type == KeyType::choice;
}

void apply_column(Scenario& scenario, const VaryColumn& column, std::size_t index) {
  const KeySpec& spec = *column.address.spec;
  if (spec.field == nullptr) return;
  const FieldRef field = spec.field(scenario, column.address.index);
  if (column.input.is_text) {
    assign(spec, field, column.words[index], column.address.elements);
  } else {
    assign_number(field, column.input.numbers[index], column.address.elements);
  }
}

/// Reads one study; the steps of `run` are the steps of reading.
class Reader {
 public:
  Reader(std::shared_ptr<const std::string> file, const std::filesystem::path& folder,
         const std::filesystem::path& config_root)
      : file_(std::move(file)), library_(folder, config_root) {}

  StudyOrError run(std::string_view text, const std::vector<std::string>& sets) {
    document_ = parse_document(text, file_, 0);
    for (const Problem& problem : document_.problems) problems_.add(problem);
    if (!problems_.empty()) return error();
    for (const std::string& set : sets) add_set(set);
    sort_tables();
    sort_entries();
    if (other_kind_) return error();  // its keys are not known here
    const std::size_t known = problems_.count();
    load_lists();
    find_variants();
    data_.plan = plan_vary(vary_entries_, vary_tables_, place(1), problems_);
    blocks_ = read_blocks(block_entries_, block_tables_, problems_);
    assemble_bases(known);
    complete_search(data_, blocks_, assemblies_.front(), problems_);
    if (problems_.empty() && !is_given("simulation.time_step_s")) choose_time_step(data_);
    if (problems_.empty()) check_rules();
    if (problems_.empty()) check_box_rules(data_, blocks_, problems_);
    if (!problems_.empty()) return error();
    finish();
    return Study(std::make_shared<const StudyData>(std::move(data_)));
  }

 private:
  [[nodiscard]] ConfigError error() const { return {problems_.lines()}; }
  [[nodiscard]] Origin place(int line) const { return {file_, 0, line}; }

  void add_set(const std::string& set) {
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos || equals == 0) {
      problems_.add(Origin{}, set, "must be key=value");
      return;
    }
    const auto trimmed = [](std::string text) {
      text.erase(0, text.find_first_not_of(' '));
      return text.substr(0, text.find_last_not_of(' ') + 1);
    };
    const std::string path = trimmed(set.substr(0, equals));
    const std::string literal = trimmed(set.substr(equals + 1));
    KeyAddress address = find_key(path);
    if (address.spec == nullptr) address = find_strategy_key(path);
    std::vector<Value> parsed = parse_literal(literal);
    const bool is_text = !parsed.empty() && parsed[0].kind == Value::Kind::text;
    if ((is_text_key(address) && !is_text) || literal == "none") parsed = {text_value(literal)};
    if (parsed.empty()) {
      if (address.spec == nullptr) {
        problems_.add(Origin{}, path, literal, unknown_key_rule(path));
      } else {
        problems_.add(Origin{}, path, literal,
                      check_value(*address.spec, text_value(literal), address.elements.size()).value_or(""));
      }
      return;
    }
    sets_.push_back({path, parsed[0], {}});
  }

  /// Finds unknown tables and remembers where the known ones start.
  void sort_tables() {
    for (const Entry& table : document_.tables) {
      const std::string pattern = pattern_of(table.path);
      tables_.emplace(table.path, table.origin);
      if (table.path.starts_with("vary[")) vary_tables_.push_back(table);
      if (is_of_block(table.path)) block_tables_.push_back(table);
      if (pattern.starts_with("vary[].variant[]") || under_unknown(table.path)) continue;
      if (pattern == "product.source" || pattern == "gripper.source") continue;
      if (std::find(table_names().begin(), table_names().end(), pattern) != table_names().end()) continue;
      unknown_tables_.push_back(table.path);
      if (const KeyAddress key = find_key(table.path); key.spec != nullptr) {
        problems_.add(table.origin, table.path, check_value(*key.spec, Value{}, key.elements.size()).value_or(""));
      } else if (pattern == "product.spring[].burgers") {
        problems_.add(table.origin, table.path, "Burgers springs are not in this version");
      } else {
        problems_.add(table.origin, "[" + table.path + "]", unknown_table_rule(table.path));
      }
    }
  }

  [[nodiscard]] bool under_unknown(const std::string& path) const {
    return std::any_of(unknown_tables_.begin(), unknown_tables_.end(), [&](const std::string& table) {
      return path.starts_with(table + ".") || path.starts_with(table + "[");
    });
  }

  static bool is_descriptive(const std::string& path) {
    for (const std::string_view table : {"product.", "gripper."}) {
      if (!path.starts_with(table)) continue;
      const std::string_view local = std::string_view(path).substr(table.size());
      return local == "name" || local == "description" || local.starts_with("source.");
    }
    return false;
  }

  /// The table or list of tables of that name; empty when there is none.
  static std::string table_called(const std::string& path) {
    for (const std::string& table : table_names()) {
      if (table == path || table == path + "[]") return table;
    }
    return "";
  }

  void sort_entries() {
    for (const Entry& entry : document_.entries) {
      if (under_unknown(entry.path)) continue;
      if (entry.path.starts_with("vary[")) {
        vary_entries_.push_back(entry);
      } else if (is_of_block(entry.path)) {
        block_entries_.push_back(entry);
      } else if (is_descriptive(entry.path)) {
        if (entry.value.kind != Value::Kind::text) {
          problems_.add(entry.origin, entry.path, spelled(entry.value), "must be a string");
        } else if (is_source(entry.path)) {
          own_sources_.push_back(entry);
        }
      } else if (const std::string table = table_called(entry.path); !table.empty()) {
        problems_.add(entry.origin, entry.path, spelled(entry.value),
                      "must be a table; write " + table_header(table));
      } else {
        study_.push_back(entry);
        refuse_other_kinds(entry);
      }
    }
    for (const Entry& entry : sets_) {
      auto& list = entry.path.starts_with("vary") ? vary_entries_
                   : is_of_block(entry.path)      ? block_entries_
                                                  : command_line_;
      list.push_back(entry);
    }
    for (const Entry& entry : command_line_) refuse_other_kinds(entry);
  }

  void refuse_other_kinds(const Entry& entry) {
    if (entry.path != "study.kind") return;
    const bool is_later = entry.value.text == "calibrate";
    const auto rule = is_later ? "not in this version" : check_value(*find_key(entry.path).spec, entry.value, 0);
    if (!rule) return;
    problems_.add(entry.origin, entry.path, spelled(entry.value), *rule);
    other_kind_ = true;
  }

  /// The entry that has the last word about a key.
  [[nodiscard]] const Entry* last(std::string_view path) const {
    const Entry* found = nullptr;
    for (const auto* list : {&study_, &command_line_}) {
      for (const Entry& entry : *list) {
        if (entry.path == path) found = &entry;
      }
    }
    return found != nullptr && found->value.kind == Value::Kind::text ? found : nullptr;
  }

  void load_lists() {
    for (const std::string list : {"product.particle", "product.spring"}) {
      const Entry* csv = last(list + "s_csv");
      if (csv == nullptr) continue;
      const auto written = [&](const Entry& entry) { return entry.path.starts_with(list + "["); };
      if (std::any_of(study_.begin(), study_.end(), written)) {
        problems_.add(csv->origin, csv->path, spelled(csv->value), "excludes [[" + list + "]]; give one of them");
      }
      const Entry named = *csv;
      for (Entry& entry : library_.read_csv(list, named, problems_)) study_.push_back(std::move(entry));
    }
  }

  /// Which values of product.use and gripper.use are there? The vary plan is read later, so peek.
  void find_variants() {
    const Entry* gripper = last("gripper.use");
    const bool varied = std::any_of(vary_entries_.begin(), vary_entries_.end(),
                                    [](const Entry& entry) { return entry.value.text == "gripper.use"; });
    has_gripper_ = gripper != nullptr || varied || tables_.contains("gripper");
  }

  /// The library entries of each value of "product.use" or "gripper.use"; one list when it is not varied.
  std::vector<std::vector<Entry>> library_lists(const std::string& table) {
    for (const VaryColumn& column : data_.plan.columns) {
      if (column.input.key != table + ".use") continue;
      if (!column.variants.empty()) return column.variants;
      std::vector<std::vector<Entry>> lists;
      for (const std::string& text : column.input.texts) {
        lists.push_back(library_.read(table, {table + ".use", text_value(text), column.origin}, problems_));
      }
      return lists;
    }
    const Entry* use = last(table + ".use");
    return {use == nullptr ? std::vector<Entry>{} : library_.read(table, *use, problems_)};
  }

  /// @param known problems found before any other file or any [[vary]] block was read
  void assemble_bases(std::size_t known) {
    const auto products = library_lists("product");
    const auto grippers = library_lists("gripper");
    AssemblyInput input;
    input.fallback = place(1);
    input.tables = tables_;
    input.has_gripper = has_gripper_;
    input.is_complete = problems_.count() == known;
    for (const VaryColumn& column : data_.plan.columns) {
      if (!column.is_use()) input.varied_keys.push_back(column.input.key);
      input.tables["vary " + column.input.key] = column.origin;
    }
    for (const auto& [key, origin] : blocks_.keys()) {
      input.varied_keys.push_back(key);
      input.tables["vary " + key] = origin;
    }
    for (const auto& product : products) {
      for (const auto& gripper : grippers) {
        input.entries = layers(product, gripper, {});
        assemblies_.push_back(assemble(input, problems_));
      }
    }
    assemble_candidates(input, products.front(), grippers.front());
    take_sources(products, grippers);
    data_.settings = assemblies_.front().settings;
    for (Assembly& assembly : assemblies_) {
      if (data_.settings.kind == StudyKind::window) {
        assembly.scenario.strategy.grip_force_N = data_.settings.window.from_N;
      }
      follow_grip_force(assembly, least_grip_force(assembly.scenario));
      data_.bases.push_back(assembly.scenario);
    }
  }

  /// The least grip force of the study's scenarios on this base.
  [[nodiscard]] double least_grip_force(const Scenario& base) const {
    double least_N = base.strategy.grip_force_N;
    for (const VaryColumn& column : data_.plan.columns) {
      if (column.input.key != "strategy.grip_force_N" || column.input.numbers.empty()) continue;
      least_N = *std::min_element(column.input.numbers.begin(), column.input.numbers.end());
    }
    return least_N;
  }

  /// A contact force that nobody wrote is never above the grip force. Where that is searched or drawn, each
  /// scenario sees to it (`Study::with_values`).
  void follow_grip_force(Assembly& assembly, double least_N) const {
    constexpr const char* kContact = "strategy.contact_force_N";
    const auto searched = blocks_.keys();
    const bool is_searched = std::any_of(searched.begin(), searched.end(), [](const auto& item) {
      return item.first == "strategy.grip_force_N" || item.first == kContact;
    });
    if (assembly.given.contains(kContact) || is_searched || !(least_N > 0.0)) return;
    double& contact_force_N = assembly.scenario.strategy.contact_force_N;
    contact_force_N = std::min(contact_force_N, least_N);
  }

  /// Of a product or gripper that is varied no source is taken: there are several.
  void take_sources(const std::vector<std::vector<Entry>>& products,
                    const std::vector<std::vector<Entry>>& grippers) {
    std::vector<Entry> library;
    for (const auto* lists : {&products, &grippers}) {
      if (lists->size() == 1) library.insert(library.end(), lists->front().begin(), lists->front().end());
    }
    data_.sources = sources_in_use(library, own_sources_, study_, command_line_);
  }

  /// Everything that is said about one scenario, in layer order; `own` overrides what the study says.
  std::vector<LayeredEntry> layers(const std::vector<Entry>& product, const std::vector<Entry>& gripper,
                                   const std::vector<Entry>& own) const {
    std::vector<LayeredEntry> all;
    for (const auto* list : {&product, &gripper}) {
      for (const Entry& entry : *list) {
        if (!is_source(entry.path)) all.push_back({Layer::library, &entry});
      }
    }
    for (const Entry& entry : study_) all.push_back({Layer::study, &entry});
    for (const Entry& entry : own) all.push_back({Layer::study, &entry});
    for (const Entry& entry : command_line_) all.push_back({Layer::command_line, &entry});
    return all;
  }

  /// compare: the study's scenario with the strategy of each candidate.
  void assemble_candidates(AssemblyInput& input, const std::vector<Entry>& product,
                           const std::vector<Entry>& gripper) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < blocks_.blocks.candidate.size(); ++i) {
      const CandidateBlock& block = blocks_.blocks.candidate[i];
      const std::string path = "candidate[" + std::to_string(i) + "].";
      if (!block.name.empty() && !is_name(block.name)) {
        problems_.add(block.origin, path + "name", toml_string(block.name), kNameRule);
      } else if (!block.name.empty() && !names.insert(block.name).second) {
        problems_.add(block.origin, path + "name", toml_string(block.name), "is the name of two candidates");
      }
      std::vector<Entry> own;
      if (!block.use.empty()) {
        own = library_.read("strategy", {path + "use", text_value(block.use), block.origin}, problems_);
      }
      own.insert(own.end(), blocks_.candidate_entries[i].begin(), blocks_.candidate_entries[i].end());
      input.entries = layers(product, gripper, own);
      Assembly assembly = assemble(input, problems_);
      follow_grip_force(assembly, assembly.scenario.strategy.grip_force_N);
      data_.candidates.push_back({block.name, assembly.scenario});
    }
  }

  [[nodiscard]] const Assembly& assembly_of(std::size_t id) const { return assemblies_[data_.base_of(id)]; }

  /// Scenario ids that differ in the given axes only, all others at their first value.
  [[nodiscard]] std::vector<std::size_t> scenarios_over(const std::set<std::size_t>& axes) const {
    std::vector<std::size_t> ids = {0};
    for (const std::size_t a : axes) {
      const VaryAxis& axis = data_.plan.axes[a];
      std::vector<std::size_t> more;
      more.reserve(ids.size() * axis.count);
      for (std::size_t i = 0; i < axis.count; ++i) {
        for (const std::size_t id : ids) more.push_back(id + i * axis.stride);
      }
      ids = std::move(more);
    }
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  void report(const Violation& broken, std::size_t id, const std::vector<std::string_view>& keys, bool varied) {
    const Assembly& assembly = assembly_of(id);
    Origin origin = assembly.origin_of(broken.field);
    // The blamed key may be a default; then point at the key of the rule that was written.
    for (const std::string_view key : keys) {
      if (assembly.given.contains(broken.field)) break;
      if (const auto found = assembly.given.find(std::string(key)); found != assembly.given.end()) {
        origin = found->second;
      }
    }
    if (varied) {
      for (const VaryColumn& column : data_.plan.columns) {
        if (matches(column, keys)) origin = column.origin;
      }
    }
    const std::string rule = broken.rule + (varied ? " (scenario " + std::to_string(id) + ")" : "");
    if (broken.value.empty()) {
      problems_.add(origin, broken.field, rule);
    } else {
      problems_.add(origin, broken.field, broken.value, rule);
    }
  }

  static bool matches(const VaryColumn& column, const std::vector<std::string_view>& keys) {
    return std::find(keys.begin(), keys.end(), column.address.spec->path) != keys.end();
  }

  void check_rules() {
    check_study();
    check_product_kinds();
    for (const StudyRule& rule : study_rules()) {
      if (is_left_to_box(rule)) continue;
      std::set<std::size_t> axes;
      for (const VaryColumn& column : data_.plan.columns) {
        if (column.is_use() || matches(column, rule.fields)) axes.insert(column.axis);
      }
      for (const std::size_t id : scenarios_over(axes)) {
        Violations broken;
        rule.check(data_.scenario(id), data_.settings, broken);
        for (const Violation& violation : broken) report(violation, id, rule.fields, !axes.empty());
        if (!broken.empty()) break;
      }
    }
  }

  /// Does the rule look at a key that is searched or drawn and has no other value? Then the box of values is
  /// checked.
  [[nodiscard]] bool is_left_to_box(const StudyRule& rule) const {
    const auto keys = blocks_.keys();
    return std::any_of(keys.begin(), keys.end(), [&](const auto& item) {
      const std::string& key = item.first;
      const auto& given = assemblies_.front().given;
      if (given.contains(key) || given.contains(key.substr(0, key.rfind('[')))) return false;
      return std::find(rule.fields.begin(), rule.fields.end(), find_key(key).spec->path) != rule.fields.end();
    });
  }

  void check_product_kinds() {
    const auto is_network = [](const Scenario& base) {
      return std::holds_alternative<NetworkParameters>(base.product);
    };
    const auto networks = std::count_if(data_.bases.begin(), data_.bases.end(), is_network);
    if (networks == 0 || networks == static_cast<std::ptrdiff_t>(data_.bases.size())) return;
    problems_.add(place(1), "product.use", "its values must all be lattices or all be networks");
  }

  void check_study() {
    const StudySettings& settings = data_.settings;
    const Assembly& assembly = assemblies_.front();
    if (!is_name(settings.name)) {
      problems_.add(assembly.origin_of("study.name"), "study.name", toml_string(settings.name), kNameRule);
    }
    const Origin kind = assembly.origin_of("study.kind");
    const std::string word = toml_string(study_kind_word(settings.kind));
    if (settings.kind == StudyKind::simulate && !data_.plan.columns.empty()) {
      problems_.add(kind, "study.kind", word, "does one run; [[vary]] needs \"sweep\" or \"window\"");
    }
    if (settings.kind == StudyKind::sweep && data_.plan.columns.empty()) {
      problems_.add(kind, "study.kind", word, "needs [[vary]] blocks; one run is \"simulate\"");
    }
    if (judges_damage(settings.kind) && !has_gripper_)
      problems_.add(kind, "study.kind", word, "needs a [gripper]");
    if ((is_search(settings.kind) || is_random(settings.kind)) && !data_.plan.columns.empty()) {
      problems_.add(data_.plan.columns.front().origin, "[[vary]]",
                    "goes with \"sweep\" and \"window\"; a study of kind " + word + " has " +
                        (is_search(settings.kind) ? "[[variable]]" : "[[random]]") + " blocks");
    }
  }

  /// Does the study say anything about the key: a value, several, a range or a distribution?
  [[nodiscard]] bool is_given(const std::string& key) const {
    const auto keys = blocks_.keys();
    return assemblies_.front().given.contains(key) ||
           std::any_of(data_.plan.columns.begin(), data_.plan.columns.end(),
                       [&](const VaryColumn& column) { return column.input.key == key; }) ||
           std::any_of(keys.begin(), keys.end(), [&](const auto& item) { return item.first == key; });
  }

  void finish() {
    for (const VaryColumn& column : data_.plan.columns) data_.inputs.push_back(column.input);
    data_.random_blocks = blocks_.blocks.random;
    data_.fewest_contact_steps = fewest_contact_steps(data_);
    data_.resolved = resolved_text(data_);
    data_.warnings = doubts(data_);
  }

  std::shared_ptr<const std::string> file_;
  Library library_;
  Problems problems_;
  Document document_;
  std::vector<Entry> study_, command_line_, own_sources_, sets_, vary_entries_, vary_tables_, block_entries_,
      block_tables_;
  ReadBlocks blocks_;
  std::vector<std::string> unknown_tables_;
  std::unordered_map<std::string, Origin> tables_;
  std::vector<Assembly> assemblies_;
  bool has_gripper_ = false;
  bool other_kind_ = false;
  StudyData data_;
};

}  // namespace

Scenario StudyData::scenario(std::size_t id) const {
  Scenario scenario = bases[base_of(id)];
  for (std::size_t c = 0; c < plan.columns.size(); ++c) {
    apply_column(scenario, plan.columns[c], plan.index(id, c));
  }
  return scenario;
}

std::size_t StudyData::base_of(std::size_t scenario) const {
  std::size_t product = 0, gripper = 0, grippers = 1;
  for (std::size_t c = 0; c < plan.columns.size(); ++c) {
    const std::string& key = plan.columns[c].input.key;
    if (key == "product.use") product = plan.index(scenario, c);
    if (key != "gripper.use") continue;
    gripper = plan.index(scenario, c);
    grippers = plan.columns[c].input.count();
  }
  return product * grippers + gripper;
}

std::string_view study_kind_word(StudyKind kind) {
  switch (kind) {
    case StudyKind::simulate:
      return "simulate";
    case StudyKind::sweep:
      return "sweep";
    case StudyKind::window:
      return "window";
    case StudyKind::sample:
      return "sample";
    case StudyKind::optimize:
      return "optimize";
    case StudyKind::robust:
      return "robust";
    case StudyKind::pareto:
      return "pareto";
    case StudyKind::compare:
      return "compare";
    case StudyKind::sensitivity:
      return "sensitivity";
  }
  return "";
}

bool is_search(StudyKind kind) {
  return kind == StudyKind::optimize || kind == StudyKind::robust || kind == StudyKind::pareto;
}

bool is_random(StudyKind kind) {
  return kind == StudyKind::sample || kind == StudyKind::robust || kind == StudyKind::compare ||
         kind == StudyKind::sensitivity;
}

bool judges_damage(StudyKind kind) {
  return kind == StudyKind::window || kind == StudyKind::compare || is_search(kind);
}

std::uint64_t pareto_search_count(std::uint64_t objectives, std::uint64_t points, std::uint64_t starts) {
  return objectives * std::max(kAnchorStarts, starts) + (objectives + points) * starts;
}

Study::Study(std::shared_ptr<const StudyData> data) : data_(std::move(data)) {}
const std::string& Study::name() const { return data_->settings.name; }
StudyKind Study::kind() const { return data_->settings.kind; }
std::uint64_t Study::seed() const { return data_->settings.seed; }
const std::string& Study::description() const { return data_->settings.description; }
const WindowSettings& Study::window() const { return data_->settings.window; }
std::size_t Study::scenario_count() const { return data_->plan.scenario_count; }
const std::vector<InputColumn>& Study::inputs() const { return data_->inputs; }
const std::string& Study::resolved_toml() const { return data_->resolved; }
const ContactSteps& Study::fewest_contact_steps() const { return data_->fewest_contact_steps; }
bool Study::is_time_step_chosen() const { return data_->is_time_step_chosen; }
const std::vector<std::string>& Study::warnings() const { return data_->warnings; }
Scenario Study::scenario(std::size_t id) const { return data_->scenario(id); }

const std::vector<SearchVariable>& Study::variables() const { return data_->variables; }
const std::vector<RandomVariable>& Study::randoms() const { return data_->randoms; }
const std::vector<StrategyCandidate>& Study::candidates() const { return data_->candidates; }
const SearchSettings& Study::search() const { return data_->search; }
const SamplingSettings& Study::sampling() const { return data_->sampling; }
const CompareSettings& Study::compare() const { return data_->compare; }
const SensitivitySettings& Study::sensitivity() const { return data_->sensitivity; }

Scenario Study::with_values(Scenario base, std::span<const std::string> keys, std::span<const double> values) {
  for (std::size_t k = 0; k < keys.size(); ++k) apply_named(base, keys[k], values[k]);
  StrategyParameters& strategy = base.strategy;
  strategy.contact_force_N = std::min(strategy.contact_force_N, strategy.grip_force_N);
  return base;
}

Scenario Study::scenario_with(std::span<const std::string> keys, std::span<const double> values) const {
  return with_values(data_->bases.front(), keys, values);
}

std::optional<double> Study::base_value(const std::string& key) const {
  const KeyAddress address = find_key(key);
  Scenario base = data_->bases.front();
  if (address.spec == nullptr || !has_field(*address.spec, base, address.index)) return std::nullopt;
  return number_at(address.spec->field(base, address.index), address.elements);
}

std::size_t Study::input_index(std::size_t scenario, std::size_t column) const {
  return data_->plan.index(scenario, column);
}

double Study::input_number(std::size_t scenario, std::size_t column) const {
  const InputColumn& input = data_->inputs[column];
  return input.is_text ? std::numeric_limits<double>::quiet_NaN() : input.numbers[input_index(scenario, column)];
}

std::string Study::input_text(std::size_t scenario, std::size_t column) const {
  const InputColumn& input = data_->inputs[column];
  const std::size_t index = input_index(scenario, column);
  return input.is_text ? input.texts[index] : spelled(input.numbers[index]);
}

StudyOrError read_study_text(std::string_view text, const std::string& display_name,
                             const std::vector<std::string>& sets, const std::filesystem::path& folder,
                             const std::filesystem::path& config_root) {
  return Reader(std::make_shared<const std::string>(display_name), folder, config_root).run(text, sets);
}

StudyOrError read_study(const std::filesystem::path& file, const std::vector<std::string>& sets,
                        const std::filesystem::path& config_root) {
  std::string why;
  const auto text = read_text_file(file, why);
  if (!text) return ConfigError{{file.string() + ": " + why}};
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  return read_study_text(*text, file.string(), sets, folder, config_root);
}

}  // namespace unbruised::studies
