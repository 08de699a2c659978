#pragma once

/// @file
/// From a TOML study to scenarios. Reading collects every violation and returns either a `Study` that is known
/// to be well formed, or the lines to print. No exception leaves this header's functions for bad user input.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/contact/contact_time.hpp"
#include "core/scenario/scenario.hpp"
#include "optimizer/algorithm.hpp"
#include "optimizer/search_space.hpp"
#include "studies/config/study_kind.hpp"
#include "studies/goals/goal.hpp"
#include "studies/statistics/design.hpp"
#include "studies/statistics/distribution.hpp"
#include "studies/text/value_or.hpp"

namespace unbruised::studies {

/// A varied key with the values of its own [[vary]] block (not one per scenario).
struct InputColumn {
  std::string key;       ///< dotted path, e.g. "strategy.grip_force_N" or "product.size_m[0]"
  bool is_text = false;  ///< true: `texts` holds the values (product.use, choices, booleans), else `numbers`
  std::vector<double> numbers;
  std::vector<std::string> texts;
  std::string units;  ///< UDUNITS spelling of a numeric key; "1" without dimension; empty for text

  [[nodiscard]] std::size_t count() const { return is_text ? texts.size() : numbers.size(); }
};

/// The search range of a window study.
struct WindowSettings {
  /// > 0
  double from_N = 0.1;
  /// > from_N
  double to_N = 10.0;
  /// > 0, < 1; relative width at which the search for either end stops
  double tolerance = 0.005;
};

/// A key that a search varies.
struct SearchVariable {
  std::string key;
  std::string units;  ///< UDUNITS spelling, "1" without dimension
  /// < to; > 0 on a log scale
  double from = 0.0;
  double to = 1.0;
  optimizer::Scale scale = optimizer::Scale::linear;
  std::optional<double> start;  ///< from <= start <= to
};

/// A key that is drawn at random.
struct RandomVariable {
  std::string key;  ///< or the name of an error around one: "strategy.grip_force_N_relative_error"
  std::string units;
  Distribution distribution;
  bool changes_factor = false;  ///< another value makes another factor group
  /// Keys of data with the same word take the same row; empty: the key is drawn by its distribution.
  std::string zip = {};
  std::vector<double> rows = {};  ///< the values in the order of the rows, for keys with such a word
};

/// Two random keys that vary together.
struct RankCorrelation {
  std::size_t first = 0;  ///< places in Study::randoms()
  std::size_t second = 0;
  double value = 0.0;  ///< Spearman's coefficient, > -1, < 1
};

/// A strategy that is compared with others.
struct StrategyCandidate {
  std::string name;
  Scenario scenario;
};

enum class ParetoMethod { epsilon_constraint, chebyshev };

/// What optimize, robust and pareto search for, and how.
struct SearchSettings {
  Objective objective;                ///< optimize, robust
  std::vector<Objective> objectives;  ///< pareto: two or three
  std::vector<Constraint> constraints;
  optimizer::Algorithm algorithm = optimizer::Algorithm::cobyla;
  std::optional<optimizer::Algorithm> local;
  std::uint64_t starts = 16;   ///< > 0; of a pareto study: of each point
  std::uint64_t budget = 640;  ///< >= starts; strategies evaluated by all searches together
  double tolerance = 1e-3;
  double initial_step = 0.2;
  ParetoMethod method = ParetoMethod::epsilon_constraint;
  std::uint64_t points = 8;
};

/// Searches for the best of each objective of a pareto study alone: 8, or `starts` where that is more; as many as
/// fill a thread's lanes for two objectives.
inline constexpr std::uint64_t kAnchorStarts = 8;
/// Searches of a pareto study: anchors of each objective, ends of the front and points between.
std::uint64_t pareto_search_count(std::uint64_t objectives, std::uint64_t points, std::uint64_t starts);

/// How random products are drawn.
struct SamplingSettings {
  DesignKind design = DesignKind::sobol;
  /// >= 2
  std::uint64_t count = 200;
  /// Joint values of the keys that change the factored matrix; 0: every product its own.
  std::uint64_t factor_groups = 16;
  /// 0.5 .. 0.9999
  double confidence = 0.95;
};

struct CompareSettings {
  Metric metric = Metric::cycle_time_s;  ///< what decides
  std::vector<Metric> metrics;           ///< also shown, `metric` among them
  /// >= 0; differences up to this count as ties
  double tie = 0.0;
};

enum class SensitivityMethod { sobol, morris };

struct SensitivitySettings {
  SensitivityMethod method = SensitivityMethod::sobol;
  std::vector<Metric> metrics;
  /// sobol: base samples, morris: trajectories
  std::uint64_t samples = 256;
  /// even, >= 4; of Morris' grid, and of keys that change the factored matrix
  std::uint64_t levels = 4;
  std::uint64_t bootstrap = 500;
  double confidence = 0.95;
};

/// What was measured over what.
enum class CurveTest {
  press,       ///< force over closure
  relaxation,  ///< force over time
  creep,       ///< closure over time
  slide,       ///< tangential force over time
};

/// One specimen's measured curve.
struct MeasuredCurve {
  std::string specimen;
  std::vector<double> x;          ///< closure in m or time in s since the first contact, ascending
  std::vector<double> y;          ///< force in N or closure in m, as many
  std::optional<double> outcome;  ///< what is predicted from the fitted keys
};

struct CalibrateSettings {
  CurveTest test = CurveTest::press;
  std::vector<MeasuredCurve> curves;
  std::string outcome;  ///< name of what is predicted; empty: nothing is
  /// > 0, < 1; part of each range below which a fit's steps end it
  double tolerance = 1e-3;
  /// > 0; scenarios of one specimen's fit
  std::uint64_t budget = 200;
  /// 0.5 .. 0.9999
  double confidence = 0.95;
};

/// The contact of a study that gets the fewest time steps.
struct ContactSteps {
  double steps = std::numeric_limits<double>::infinity();  ///< infinite: the study has no contact that hits
  double contact_s = std::numeric_limits<double>::infinity();
  ContactPart part = ContactPart::finger;
  std::string where;  ///< the values of the keys that matter; may be empty
};

/// Lines to print, one per violation: `file:line: key = value: rule`, in file and line order.
struct ConfigError {
  std::vector<std::string> messages;
};

struct StudyData;  // defined inside studies/config

/// A validated study: immutable, cheap to copy, safe to use from several threads at once.
class Study {
 public:
  explicit Study(std::shared_ptr<const StudyData> data);

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] StudyKind kind() const;
  [[nodiscard]] std::uint64_t seed() const;
  [[nodiscard]] const std::string& description() const;
  /// Meaningful for kinds that search the grip force.
  [[nodiscard]] const WindowSettings& window() const;

  // Meaningful for the kinds that use them, empty or default for others.
  [[nodiscard]] const std::vector<SearchVariable>& variables() const;
  [[nodiscard]] const std::vector<RandomVariable>& randoms() const;
  /// Pairs that are not here are independent; all together can be drawn.
  [[nodiscard]] const std::vector<RankCorrelation>& correlations() const;
  [[nodiscard]] const std::vector<StrategyCandidate>& candidates() const;
  [[nodiscard]] const SearchSettings& search() const;
  [[nodiscard]] const SamplingSettings& sampling() const;
  [[nodiscard]] const CompareSettings& compare() const;
  [[nodiscard]] const SensitivitySettings& sensitivity() const;
  [[nodiscard]] const CalibrateSettings& calibrate() const;

  /// `base` with numeric keys set to values, and errors of keys added to what is there, in this order;
  /// `contact_force_N` never exceeds the grip force (lowered where it would).
  /// @param keys variables, random keys (RandomVariable::key), or other numeric keys that exist in the base.
  /// @param values as many
  [[nodiscard]] static Scenario with_values(Scenario base, std::span<const std::string> keys,
                                            std::span<const double> values);
  /// The study's base scenario (that of id 0) with numeric keys set. Thread-safe.
  [[nodiscard]] Scenario scenario_with(std::span<const std::string> keys, std::span<const double> values) const;
  /// The value of a numeric key in the base scenario; nothing where there is none.
  [[nodiscard]] std::optional<double> base_value(const std::string& key) const;

  /// Points of the Cartesian product of all [[vary]] blocks; 1 without any. At most 10,000,000.
  [[nodiscard]] std::size_t scenario_count() const;
  /// The varied keys in the order of their blocks.
  [[nodiscard]] const std::vector<InputColumn>& inputs() const;
  /// Index into `inputs()[column].numbers` or `.texts` of a scenario's value. The first block is the slowest.
  [[nodiscard]] std::size_t input_index(std::size_t scenario, std::size_t column) const;
  /// Value of a numeric column; NaN when the column is text.
  [[nodiscard]] double input_number(std::size_t scenario, std::size_t column) const;
  /// Value of a column as text; numbers in their shortest exact spelling.
  [[nodiscard]] std::string input_text(std::size_t scenario, std::size_t column) const;

  /// The fully specified run `id`, 0 <= id < scenario_count(). A fraction of a microsecond for lattices.
  [[nodiscard]] Scenario scenario(std::size_t id) const;

  /// The contact that gets the fewest time steps, between the ends of all that is varied, searched and drawn.
  [[nodiscard]] const ContactSteps& fewest_contact_steps() const;
  /// Was simulation.time_step_s chosen by the shortest contact, as nothing gave it?
  [[nodiscard]] bool is_time_step_chosen() const;

  /// Complete TOML that reads back to this study without `use`, --set or CSV files; every value explicit and
  /// exact. Deterministic: equal studies give equal text.
  [[nodiscard]] const std::string& resolved_toml() const;
  /// Things that are allowed but probably not meant; one line each.
  [[nodiscard]] const std::vector<std::string>& warnings() const;

 private:
  std::shared_ptr<const StudyData> data_;
};

using StudyOrError = ValueOr<Study, ConfigError>;

/// Reads, merges and validates a study.
/// @param sets the values of `--set`, each `key=value` with a TOML literal (strings may be bare).
/// @param config_root the installed configs folder, second place where `use` looks; may be empty.
StudyOrError read_study(const std::filesystem::path& file, const std::vector<std::string>& sets,
                        const std::filesystem::path& config_root);

/// The same from text, e.g. from the resolved config of a run directory.
/// @param display_name stands for the file in messages.
/// @param folder first place where `use` and CSV files are looked for; may be empty.
StudyOrError read_study_text(std::string_view text, const std::string& display_name,
                             const std::vector<std::string>& sets, const std::filesystem::path& folder,
                             const std::filesystem::path& config_root);

/// What a key means: unit, default, range, one sentence. Accepts indices ("product.size_m[0]") and table names
/// ("strategy": all keys of the table). Nothing when unknown.
std::optional<std::string> explain_key(const std::string& key);
/// The whole key reference, plain text.
std::string explain_all();
/// The whole key reference as the Markdown that stands in docs/config.md.
std::string reference_markdown();
/// The list of plausible values as the Markdown table that stands in docs/config.md.
std::string plausible_markdown();

/// The keys whose values differ between two resolved configs, sorted; for the refusal to continue another study.
std::vector<std::string> differing_keys(const std::string& resolved_a, const std::string& resolved_b);

/// One file of the configs folder, for `unbruised list`.
struct LibraryEntry {
  enum class Kind { product, gripper, strategy, study };
  Kind kind = Kind::study;
  std::string path;         ///< relative to the configs folder
  std::string name;         ///< [study] name, or the file's `name`; else its stem
  std::string description;  ///< one line, may be empty
};
/// All products, grippers, strategies and studies below `config_root`, sorted by kind and path. Unreadable files
/// are left out.
std::vector<LibraryEntry> list_library(const std::filesystem::path& config_root);

}  // namespace unbruised::studies
