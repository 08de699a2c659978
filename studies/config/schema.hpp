#pragma once

/// @file
/// The one table of every config key. Reading, `--set`, [[vary]], the resolved config, suggestions, `explain` and
/// docs/config.md all come from it. Defaults are not written here: they are read from default-constructed structs.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "core/scenario/range.hpp"
#include "core/scenario/scenario.hpp"
#include "studies/config/document.hpp"
#include "studies/config/study.hpp"
#include "studies/text/key_names.hpp"

namespace unbruised::studies {

/// [search] as written; goals are parsed from it (searching.hpp).
struct SearchTable {
  std::string objective;
  std::vector<std::string> objectives;
  std::vector<std::string> constraints;
  optimizer::Algorithm algorithm = optimizer::Algorithm::cobyla;
  std::string local_algorithm;
  std::uint64_t starts = 16;
  std::uint64_t budget = 640;
  double tolerance = 1e-3;
  double initial_step = 0.2;
  ParetoMethod method = ParetoMethod::epsilon_constraint;
  std::uint64_t points = 8;
};

/// [compare] as written.
struct CompareTable {
  std::string metric = "cycle_time_s";
  std::vector<std::string> metrics;
  double tie = 0.0;
};

/// [sensitivity] as written.
struct SensitivityTable {
  SensitivityMethod method = SensitivityMethod::sobol;
  std::vector<std::string> metrics;
  std::uint64_t samples = 256;
  std::uint64_t levels = 4;
  std::uint64_t bootstrap = 500;
  double confidence = 0.95;
};

/// [calibrate] as written; the curves of its files become [[specimen]] blocks.
struct CalibrateTable {
  std::vector<std::string> data;
  CurveTest test = CurveTest::press;
  std::string outcome;
  double tolerance = 1e-3;
  std::uint64_t budget = 200;
  double confidence = 0.95;
};

/// What a study says about itself, beside its scenarios.
struct StudySettings {
  std::string name;
  StudyKind kind = StudyKind::simulate;
  std::uint64_t seed = 1;
  std::string description;
  WindowSettings window;
  SearchTable search;
  SamplingSettings sampling;
  CompareTable compare;
  SensitivityTable sensitivity;
  CalibrateTable calibrate;
};

enum class VaryScale { linear, log };

/// One [[vary]] block as written.
struct VaryBlock {
  std::string key;
  std::optional<double> from;
  std::optional<double> to;
  std::uint64_t count = 0;  ///< 0: not given
  VaryScale scale = VaryScale::linear;
  std::string zip;
  Value values;  ///< an array when given
  Origin origin;
};

/// One [[variable]] or [[parameter]] block as written.
struct VariableBlock {
  std::string key;
  std::optional<double> from;
  std::optional<double> to;
  VaryScale scale = VaryScale::linear;
  std::optional<double> start;
  Origin origin;
};

/// One [[random]] block as written.
struct RandomBlock {
  std::string key;
  DistributionKind distribution = DistributionKind::uniform;
  std::optional<double> mean;
  std::optional<double> standard_deviation;
  std::optional<double> relative_deviation;
  std::vector<double> data;
  std::optional<double> from;
  std::optional<double> to;
  std::optional<double> mode;
  std::optional<double> at_least;
  std::optional<double> at_most;
  std::optional<double> relative;  ///< largest error around the value the key has, in parts of it
  std::optional<double> absolute;  ///< the same in the key's unit
  std::string file;                ///< CSV with the values of `column`; these stand in `data` once it is read
  std::string column;
  std::string zip;  ///< keys of data with the same word take the same row
  Origin origin;
};

/// One [[correlation]] block as written.
struct CorrelationBlock {
  std::vector<std::string> between;
  std::optional<double> value;
  Origin origin;
};

/// One [[specimen]] block as written.
struct SpecimenBlock {
  std::string name;
  std::vector<double> closure_m;
  std::vector<double> time_s;
  std::vector<double> force_N;
  std::optional<double> outcome;
  Origin origin;
};

/// One [[candidate]] block as written, without the keys of its strategy.
struct CandidateBlock {
  std::string name;
  std::string use;
  Origin origin;
};

/// The arrays of tables that steer a search or a sample.
struct StudyBlocks {
  std::vector<VariableBlock> variable;
  std::vector<VariableBlock> parameter;
  std::vector<SpecimenBlock> specimen;
  std::vector<RandomBlock> random;
  std::vector<CorrelationBlock> correlation;
  std::vector<CandidateBlock> candidate;
};

/// An enumeration seen through its words.
struct ChoiceRef {
  void* object;
  int (*get)(const void*);
  void (*set)(void*, int);
};
struct NumberSpan {
  double* data;
  int size;
};
struct IntegerSpan {
  int* data;
  int size;
};
/// An array of numbers that may be absent.
struct MaybeSpan {
  void* object;
  int size;
  double* (*data)(void*);  ///< nullptr where it is absent
  void (*give)(void*, bool is_there);
};

/// The field a key writes to.
using FieldRef =
    std::variant<double*, std::optional<double>*, int*, std::uint64_t*, bool*, std::string*, ChoiceRef, NumberSpan,
                 IntegerSpan, MaybeSpan, std::array<bool, 3>*, std::vector<double>*,
                 std::vector<std::array<double, 3>>*, std::vector<std::string>*>;

enum class KeyType {
  number,
  optional_number,
  integer,
  boolean,
  text,
  choice,
  numbers,        ///< array of a fixed number of numbers
  maybe_numbers,  ///< the same, or "none"
  integers,       ///< array of a fixed number of integers
  axes,           ///< any of "x", "y", "z"
  series,         ///< array of numbers
  vector_series,  ///< array of [x, y, z]
  texts,          ///< array of strings
  any_array,      ///< [[vary]] values
};

/// Where a key has an effect. Elsewhere it is refused as unused.
enum class Use {
  always,
  lattice,
  network,
  with_axis,  ///< cylinders and solids of revolution
  revolution,
  superellipsoid,
  mesh,
  gripper,
  not_gripper,
  not_window,
  support,
  lattice_support,
  network_support,
  tracking,  ///< palms that go with a belt
  stop,      ///< cycles that are stopped
  sensor,    ///< scenarios with a six-axis sensor
  range,     ///< grippers with range sensors
  guard,     ///< approaches with a guard
  range_guard,
  force_guard,
  position_hold,  ///< fingers that a lock holds
  robot,          ///< palms that an arm carries
  elastic_arm,    ///< arms whose joints give way
  window,
  search,  ///< kinds with [[variable]] blocks
  one_objective,
  several_objectives,
  sampling,  ///< kinds that draw products
  random,    ///< those and kinds with a design over random keys
  candidates,
  design,
  curves,  ///< kinds that fit measured curves
};

/// A row of the key table.
struct KeySpec {
  std::string_view path;  ///< dotted; [] stands for an index
  KeyType type = KeyType::number;
  std::string_view meaning;  ///< one sentence
  Range range = {};          ///< of a scenario's number: core's, filled in by key_table()
  int size = 0;              ///< elements of `numbers` and `integers`
  std::vector<std::string_view> choices = {};
  Use use = Use::always;
  bool required = false;
  std::string note = {};  ///< what an absent key means; the rules of core about the key follow by themselves
  /// What stands where the key is not given, for those whose default depends on other keys; empty: the field's
  /// value.
  std::string_view default_words = {};
  /// One of these two, or neither for keys that steer the reading itself (use, kind, CSV files).
  FieldRef (*field)(Scenario&, int index) = nullptr;
  FieldRef (*study_field)(StudySettings&) = nullptr;
  FieldRef (*vary_field)(VaryBlock&) = nullptr;
  FieldRef (*block_field)(StudyBlocks&, int index) = nullptr;
};

/// All keys, in the order of the reference.
const std::vector<KeySpec>& key_table();
/// The tables and arrays of tables that hold them ("strategy", "product.particle[]").
const std::vector<std::string>& table_names();

/// A dotted path taken apart.
struct KeyAddress {
  const KeySpec* spec = nullptr;  ///< none: unknown key
  int index = 0;                  ///< of the array of tables
  std::vector<int> elements;      ///< of the key's own array
};
/// Looks up "product.particle[2].position_m[0]".
KeyAddress find_key(std::string_view path);
/// The same for keys of a candidate's strategy: "candidate[0].grip_force_N" is "strategy.grip_force_N".
KeyAddress find_strategy_key(std::string_view path);
/// Is it an array of numbers, whose elements are numbers of their own?
bool is_number_array(KeyType type);
/// Length of the list of a scenario that a path with [] or an index leads into ("strategy.waypoint[].wait_s");
/// none: it leads into none.
std::optional<std::size_t> scenario_list_size(const Scenario& scenario, std::string_view path);
/// Does the scenario have the field of this key, at this index of its array of tables?
bool has_field(const KeySpec& spec, const Scenario& scenario, int index);
/// Is it a table or key of a list of blocks of the study ([[variable]], [[random]] and the like, but [[vary]])?
bool is_of_block(std::string_view path);

/// Does a study of this kind look at the keys of this use? True for uses that depend on the scenario alone.
bool kind_uses(Use use, StudyKind kind);
/// The words of those that do.
std::vector<std::string> kinds_that_use(Use use);
/// Does this scenario? True for uses that depend on the kind alone. @param varied_keys take several values
bool scenario_uses(Use use, const Scenario& scenario, const std::vector<std::string>& varied_keys);
/// Do both?
inline bool is_used(const KeySpec& spec, const Scenario& scenario, StudyKind kind,
                    const std::vector<std::string>& varied_keys) {
  return kind_uses(spec.use, kind) && scenario_uses(spec.use, scenario, varied_keys);
}
/// Why the keys of a use are not looked at.
std::string why_unused(Use use, const Scenario& scenario);

/// Type and range of a value for a key or for an element of it. Returns the broken rule, or nothing.
std::optional<std::string> check_value(const KeySpec& spec, const Value& value, std::size_t element_depth);
/// Writes a checked value into a field.
void assign(const KeySpec& spec, FieldRef field, const Value& value, const std::vector<int>& elements);
/// Writes a number into a numeric field or one element of it.
void assign_number(FieldRef field, double number, const std::vector<int>& elements);
/// The number an address holds now; nothing when the field is text, absent, or the element does not exist.
std::optional<double> number_at(FieldRef field, const std::vector<int>& elements);
/// Does the element exist?
bool has_element(FieldRef field, const std::vector<int>& elements);
/// A field as TOML; empty for an optional without value and for an empty text.
std::string spelled(const KeySpec& spec, FieldRef field);

/// The words of a choice: "\"held\", \"dropped\"".
std::string choices_text(const KeySpec& spec);
/// "; did you mean "COBYLA"?" for the word of a choice that is spelt most like `word`, whatever its case; else
/// empty.
std::string word_suggestion(const std::string& word, const std::vector<std::string_view>& choices);
/// Every pattern of the key table.
const std::vector<std::string>& key_patterns();

}  // namespace unbruised::studies
