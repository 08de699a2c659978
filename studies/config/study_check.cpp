#include "studies/config/study_check.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <variant>

#include "studies/config/problems.hpp"
#include "studies/config/rules.hpp"
#include "studies/config/study_names.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

class Checking {
 public:
  explicit Checking(const StudyCheck& input) : input_(input) {}

  void check_rules() {
    check_kind();
    check_product_kinds();
    for (const StudyRule& rule : study_rules()) {
      if (is_left_to_box(rule)) continue;
      std::set<std::size_t> axes;
      for (const VaryColumn& column : input_.data.plan.columns) {
        if (column.is_use() || matches(column, rule.fields)) axes.insert(column.axis);
      }
      const Cause cause = axes.empty() ? Cause::study : Cause::varied_keys;
      for (const std::size_t id : scenarios_over(axes)) {
        Violations broken;
        rule.check(input_.data.scenario(id), input_.data.settings, broken);
        for (const Violation& violation : broken) report(violation, id, rule.fields, cause);
        if (!broken.empty()) break;
      }
    }
  }

 private:
  /// Does a rule look at keys that vary?
  enum class Cause { study, varied_keys };

  [[nodiscard]] const Assembly& assembly_of(std::size_t id) const {
    return input_.assemblies[input_.data.base_of(id)];
  }

  /// Scenario ids that differ in the given axes only, all others at their first value.
  [[nodiscard]] std::vector<std::size_t> scenarios_over(const std::set<std::size_t>& axes) const {
    std::vector<std::size_t> ids = {0};
    for (const std::size_t a : axes) {
      const VaryAxis& axis = input_.data.plan.axes[a];
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

  void report(const Violation& broken, std::size_t id, const std::vector<std::string_view>& keys, Cause cause) {
    const bool varied = cause == Cause::varied_keys;
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
      for (const VaryColumn& column : input_.data.plan.columns) {
        if (matches(column, keys)) origin = column.origin;
      }
    }
    const std::string rule = broken.rule + (varied ? " (scenario " + std::to_string(id) + ")" : "");
    if (broken.value.empty()) {
      input_.problems.add(origin, broken.field, rule);
    } else {
      input_.problems.add(origin, broken.field, broken.value, rule);
    }
  }

  static bool matches(const VaryColumn& column, const std::vector<std::string_view>& keys) {
    return std::find(keys.begin(), keys.end(), column.address.spec->path) != keys.end();
  }

  /// Does the rule look at a key that is searched or drawn and has no other value? Then the box of values is
  /// checked.
  [[nodiscard]] bool is_left_to_box(const StudyRule& rule) const {
    const auto keys = input_.read.keys();
    return std::any_of(keys.begin(), keys.end(), [&](const auto& item) {
      const std::string& key = item.first;
      const auto& given = input_.assemblies.front().given;
      if (given.contains(key) || given.contains(key.substr(0, key.rfind('[')))) return false;
      return std::find(rule.fields.begin(), rule.fields.end(), find_key(key).spec->path) != rule.fields.end();
    });
  }

  void check_product_kinds() {
    const auto is_network = [](const Scenario& base) {
      return std::holds_alternative<NetworkParameters>(base.product);
    };
    const auto networks = std::count_if(input_.data.bases.begin(), input_.data.bases.end(), is_network);
    if (networks == 0 || networks == static_cast<std::ptrdiff_t>(input_.data.bases.size())) return;
    input_.problems.add(input_.start, "product.use", "its values must all be lattices or all be networks");
  }

  void check_kind() {
    const StudySettings& settings = input_.data.settings;
    const Assembly& assembly = input_.assemblies.front();
    if (!is_name(settings.name)) {
      input_.problems.add(assembly.origin_of("study.name"), "study.name", toml_string(settings.name), kNameRule);
    }
    const Origin kind = assembly.origin_of("study.kind");
    const StudyKindRow& row = row_of(settings.kind);
    const std::string word = toml_string(row.word);
    if (row.vary == Blocks::required && input_.data.plan.columns.empty()) {
      input_.problems.add(kind, "study.kind", word, "needs [[vary]] blocks; one run is \"simulate\"");
    }
    if (judges_damage(settings.kind) && !input_.has_gripper)
      input_.problems.add(kind, "study.kind", word, "needs a [gripper]");
    if (row.vary == Blocks::refused && !input_.data.plan.columns.empty()) refuse_vary(row, kind);
  }

  void refuse_vary(const StudyKindRow& row, const Origin& kind) {
    const std::vector<std::string> may_vary =
        kinds_where([](const StudyKindRow& other) { return other.vary != Blocks::refused; });
    const std::string word = toml_string(row.word);
    if (row.variable == Blocks::refused && row.random == Blocks::refused && row.parameter == Blocks::refused) {
      input_.problems.add(kind, "study.kind", word,
                          "does one run; [[vary]] needs " + listed_quoted(may_vary, "or"));
      return;
    }
    input_.problems.add(input_.data.plan.columns.front().origin, "[[vary]]",
                        "goes with " + listed_quoted(may_vary, "and") + "; a study of kind " + word + " has " +
                            (row.variable != Blocks::refused    ? "[[variable]]"
                             : row.parameter != Blocks::refused ? "[[parameter]]"
                                                                : "[[random]]") +
                            " blocks");
  }

  const StudyCheck& input_;
};

}  // namespace

void check_study(const StudyCheck& input) { Checking(input).check_rules(); }

}  // namespace unbruised::studies
