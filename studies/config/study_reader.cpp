#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "core/outcome/damage_limits.hpp"
#include "core/scenario/product.hpp"
#include "studies/config/assemble.hpp"
#include "studies/config/box_rules.hpp"
#include "studies/config/contact_steps.hpp"
#include "studies/config/doubts.hpp"
#include "studies/config/execution_error.hpp"
#include "studies/config/library.hpp"
#include "studies/config/problems.hpp"
#include "studies/config/product_blocks.hpp"
#include "studies/config/searching.hpp"
#include "studies/config/sorted_text.hpp"
#include "studies/config/sources.hpp"
#include "studies/config/study.hpp"
#include "studies/config/study_check.hpp"
#include "studies/config/study_data.hpp"
#include "studies/config/study_names.hpp"
#include "studies/config/study_part.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {
namespace {

enum class StudyPart { whole, scenario };

/// Is the path one of a scenario's, or what a study is called?
bool is_of_scenario(std::string_view path) {
  constexpr std::array<std::string_view, 7> kTables = {"product",  "gripper", "cell",      "sensor",
                                                       "strategy", "limits",  "simulation"};
  if (path == "study" || path == "study.kind" || path == "study.name" || path == "study.description") return true;
  return std::ranges::find(kTables, path.substr(0, path.find_first_of(".["))) != kTables.end();
}

void keep_scenario(Document& document) {
  const auto is_other = [](const Entry& entry) { return !is_of_scenario(entry.path); };
  std::erase_if(document.entries, is_other);
  std::erase_if(document.tables, is_other);
  for (Entry& entry : document.entries) {
    if (entry.path == "study.kind") entry.value = text_value("simulate");
  }
}

/// Reads one study; the steps of `run` are the steps of reading.
class Reader {
 public:
  Reader(std::shared_ptr<const std::string> file, const std::filesystem::path& folder,
         const std::filesystem::path& config_root)
      : file_(std::move(file)), library_(folder, config_root) {}

  StudyOrError run(std::string_view text, const std::vector<std::string>& sets, StudyPart part) {
    Document document = parse_document(text, file_, 0);
    if (part == StudyPart::scenario) keep_scenario(document);
    for (const Problem& problem : document.problems) problems_.add(problem);
    if (!problems_.empty()) return error();
    text_ = sort_text(document, sets, problems_);
    if (text_.is_other_kind) return error();  // its keys are not known here
    const std::size_t known = problems_.count();
    load_lists();
    find_variants();
    data_.plan = plan_vary(text_.vary_entries, text_.vary_tables, place(1), problems_);
    products_ = library_lists("product");
    grippers_ = library_lists("gripper");
    if (draws_products() && products_.size() == 1) add_blocks_of_product(products_.front(), text_);
    blocks_ = read_blocks(text_.block_entries, text_.block_tables, problems_);
    load_data();
    assemble_bases(known);
    if (fits_curves(data_.settings.kind)) load_curves();
    complete_search(data_, blocks_, assemblies_.front(), problems_);
    const bool chooses_step = problems_.empty() && !is_given(kTimeStepKey);
    if (chooses_step) set_time_step(data_, kLeastChosenStep_s);
    check_all_rules();
    if (chooses_step && problems_.empty()) {
      choose_time_step(data_);  // of scenarios that keep their rules; the step has some of its own
      check_all_rules();
    }
    if (!problems_.empty()) return error();
    finish();
    return Study(std::make_shared<const StudyData>(std::move(data_)));
  }

 private:
  [[nodiscard]] ConfigError error() const { return {problems_.lines()}; }
  [[nodiscard]] Origin place(int line) const { return {file_, 0, line}; }

  void load_lists() {
    for (const Entry& entry : text_.command_line) {  // files that --set names are read as if the study did
      if (Library::names_file(entry.path)) text_.study.push_back(entry);
    }
    library_.read_profile(text_.study, problems_);
    library_.read_product_profile(text_.study, problems_);
    library_.read_mesh(text_.study, problems_);
    library_.read_arm(text_.study, problems_);
    library_.read_waypoints(text_.study, problems_);
    library_.read_demonstration(text_.study, problems_);
    for (const std::string list : {"product.particle", "product.spring"}) {
      const Entry* csv = text_.last(list + "s_csv");
      if (csv == nullptr) continue;
      const auto written = [&](const Entry& entry) { return entry.path.starts_with(list + "["); };
      if (std::any_of(text_.study.begin(), text_.study.end(), written)) {
        problems_.add(csv->origin, csv->path, spelled(csv->value), "excludes [[" + list + "]]; give one of them");
      }
      const Entry named = *csv;
      for (Entry& entry : library_.read_csv(list, named, problems_)) text_.study.push_back(std::move(entry));
    }
  }

  /// The curves of files become [[specimen]] blocks.
  void load_curves() {
    CalibrateTable& settings = data_.settings.calibrate;
    const Origin origin = assemblies_.front().origin_of("calibrate.data");
    if (!settings.data.empty() && !blocks_.blocks.specimen.empty()) {
      problems_.add(origin, "calibrate.data", "excludes [[specimen]] blocks; give one of them");
      return;
    }
    for (const std::string& file : settings.data) {
      const Entry named{"calibrate.data", text_value(file), origin};
      for (SpecimenBlock& block : library_.read_curves(named, settings, problems_)) {
        blocks_.blocks.specimen.push_back(std::move(block));
      }
    }
    settings.data.clear();
  }

  [[nodiscard]] bool draws_products() const {
    const Entry* kind = text_.last("study.kind");
    const auto known = kind == nullptr ? std::nullopt : study_kind_named(kind->value.text);
    return known && is_random(*known);
  }

  /// The values of [[random]] blocks that name a file.
  void load_data() {
    for (std::size_t i = 0; i < blocks_.blocks.random.size(); ++i) {
      RandomBlock& block = blocks_.blocks.random[i];
      const bool is_named = !block.file.empty() && !block.column.empty();
      if (!is_named || block.distribution != DistributionKind::data || !block.data.empty()) continue;
      const Entry named{"random[" + std::to_string(i) + "].file", text_value(block.file), block.origin};
      block.data = library_.read_column(named, block.column, problems_);
    }
  }

  /// Which values of product.use and gripper.use are there? The vary plan is read later, so peek.
  void find_variants() {
    const Entry* gripper = text_.last("gripper.use");
    const bool varied = std::any_of(text_.vary_entries.begin(), text_.vary_entries.end(),
                                    [](const Entry& entry) { return entry.value.text == "gripper.use"; });
    has_gripper_ = gripper != nullptr || varied || text_.tables.contains("gripper");
  }

  /// The library entries of each value of "product.use" or "gripper.use"; one list when it is not varied.
  std::vector<std::vector<Entry>> library_lists(const std::string& table) {
    for (const VaryColumn& column : data_.plan.columns) {
      if (column.input.key != table + ".use") continue;
      if (!column.variants.empty()) {
        std::vector<std::vector<Entry>> lists = column.variants;
        for (std::vector<Entry>& list : lists) {
          if (table == "product") library_.read_mesh(list, problems_);
        }
        return lists;
      }
      std::vector<std::vector<Entry>> lists;
      for (const std::string& text : column.input.texts) {
        lists.push_back(library_.read(table, {table + ".use", text_value(text), column.origin}, problems_));
      }
      return lists;
    }
    const Entry* use = text_.last(table + ".use");
    return {use == nullptr ? std::vector<Entry>{} : library_.read(table, *use, problems_)};
  }

  /// @param known problems found before any other file or any [[vary]] block was read
  void assemble_bases(std::size_t known) {
    AssemblyInput input;
    input.fallback = place(1);
    input.tables = text_.tables;
    input.has_gripper = has_gripper_;
    input.meshes = &library_.meshes();
    input.is_complete = problems_.count() == known;
    for (const VaryColumn& column : data_.plan.columns) {
      if (!column.is_use()) input.varied_keys.push_back(column.input.key);
      input.tables["vary " + column.input.key] = column.origin;
    }
    for (const auto& [key, origin] : blocks_.keys()) {
      input.varied_keys.push_back(key);
      input.tables["vary " + key] = origin;
    }
    for (const auto& product : products_) {
      for (const auto& gripper : grippers_) {
        input.entries = layers(product, gripper, {});
        assemblies_.push_back(assemble(input, problems_));
      }
    }
    assemble_candidates(input, products_.front(), grippers_.front());
    take_sources();
    data_.settings = assemblies_.front().settings;
    for (Assembly& assembly : assemblies_) {
      if (searches_force(data_.settings.kind)) {
        assembly.scenario.strategy.grip_force_N = data_.settings.window.from_N;
      }
      follow_grip_force(assembly, least_grip_force(assembly.scenario));
      judge_first_yield(assembly);
      data_.bases.push_back(assembly.scenario);
    }
  }

  /// The least grip force of the study's scenarios on this base.
  [[nodiscard]] double least_grip_force(const Scenario& base) const {
    double least_N = base.strategy.grip_force_N;
    for (const VaryColumn& column : data_.plan.columns) {
      if (column.input.key != kGripForceKey || column.input.numbers.empty()) continue;
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
      return item.first == kGripForceKey || item.first == kContact;
    });
    if (assembly.given.contains(kContact) || is_searched || !(least_N > 0.0)) return;
    double& contact_force_N = assembly.scenario.strategy.contact_force_N;
    contact_force_N = std::min(contact_force_N, least_N);
  }

  /// Where a yield stress is known, no contact may reach first yield, unless the study says what it may.
  static void judge_first_yield(Assembly& assembly) {
    LimitParameters& limits = assembly.scenario.limits;
    if (limits.contact_yield_ratio || limits.damage == DamageJudging::not_considered) return;
    if (yield_stress_Pa(assembly.scenario.product)) limits.contact_yield_ratio = kUsualContactYieldRatio;
  }

  /// Of a product or gripper that is varied no source is taken: there are several.
  void take_sources() {
    std::vector<Entry> library;
    for (const auto* lists : {&products_, &grippers_}) {
      if (lists->size() == 1) library.insert(library.end(), lists->front().begin(), lists->front().end());
    }
    data_.sources = sources_in_use(library, text_.own_sources, text_.study, text_.command_line);
  }

  /// Everything that is said about one scenario, in layer order; `own` overrides what the study says.
  std::vector<LayeredEntry> layers(const std::vector<Entry>& product, const std::vector<Entry>& gripper,
                                   const std::vector<Entry>& own) const {
    std::vector<LayeredEntry> all;
    for (const auto* list : {&product, &gripper}) {
      for (const Entry& entry : *list) {
        if (!is_source(entry.path) && !is_of_block(entry.path)) all.push_back({Layer::library, &entry});
      }
    }
    // Waypoints are one path: whoever has his own has none of the study's.
    const auto is_waypoint = [](const Entry& entry) { return entry.path.starts_with("strategy.waypoint["); };
    const bool own_path = std::any_of(own.begin(), own.end(), is_waypoint);
    for (const Entry& entry : text_.study) {
      if (!own_path || !is_waypoint(entry)) all.push_back({Layer::study, &entry});
    }
    for (const Entry& entry : own) all.push_back({Layer::study, &entry});
    for (const Entry& entry : text_.command_line) all.push_back({Layer::command_line, &entry});
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
      judge_first_yield(assembly);
      data_.candidates.push_back({block.name, assembly.scenario});
    }
  }

  void check_all_rules() {
    if (problems_.empty()) check_rules();
    if (problems_.empty()) check_box_rules(data_, blocks_, problems_);
  }

  void check_rules() {
    check_study({.data = data_,
                 .assemblies = assemblies_,
                 .read = blocks_,
                 .start = place(1),
                 .has_gripper = has_gripper_,
                 .problems = problems_});
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
    for (RandomBlock& block : data_.random_blocks) {
      if (block.zip.empty()) block.zip = std::exchange(block.file, {});
      block.file.clear();
      block.column.clear();
    }
    data_.fewest_contact_steps = fewest_contact_steps(data_);
    data_.resolved = resolved_text(data_);
    data_.warnings = doubts(data_);
  }

  std::shared_ptr<const std::string> file_;
  Library library_;
  Problems problems_;
  SortedText text_;
  std::vector<std::vector<Entry>> products_;  ///< entries of the product's file, a list for each that is varied
  std::vector<std::vector<Entry>> grippers_;
  ReadBlocks blocks_;
  std::vector<Assembly> assemblies_;
  bool has_gripper_ = false;
  StudyData data_;
};

using std::filesystem::path;

StudyOrError read_text(std::string_view text, const std::string& name, const std::vector<std::string>& sets,
                       const path& folder, const path& config_root, StudyPart part) {
  return Reader(std::make_shared<const std::string>(name), folder, config_root).run(text, sets, part);
}

StudyOrError read_file(const path& file, const std::vector<std::string>& sets, const path& config_root,
                       StudyPart part) {
  std::string why;
  const auto text = read_text_file(file, why);
  if (!text) return ConfigError{{file.string() + ": " + why}};
  const path folder = file.has_parent_path() ? file.parent_path() : path(".");
  return read_text(*text, file.string(), sets, folder, config_root, part);
}

}  // namespace

StudyOrError read_study_text(std::string_view text, const std::string& display_name,
                             const std::vector<std::string>& sets, const path& folder, const path& config_root) {
  return read_text(text, display_name, sets, folder, config_root, StudyPart::whole);
}

StudyOrError read_study(const path& file, const std::vector<std::string>& sets, const path& config_root) {
  return read_file(file, sets, config_root, StudyPart::whole);
}

StudyOrError read_single_scenario_text(std::string_view text, const std::string& display_name,
                                       const std::vector<std::string>& sets, const path& folder,
                                       const path& config_root) {
  return read_text(text, display_name, sets, folder, config_root, StudyPart::scenario);
}

StudyOrError read_single_scenario(const path& file, const std::vector<std::string>& sets,
                                  const path& config_root) {
  return read_file(file, sets, config_root, StudyPart::scenario);
}

}  // namespace unbruised::studies
