#include "studies/findings/claims.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "core/outcome/damage_limits.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// The columns of a study that can decide whether a limit acts.
std::vector<std::size_t> deciding_columns(const Study& study) {
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < study.inputs().size(); ++c) {
    const std::string& key = study.inputs()[c].key;
    const bool decides = key.starts_with("limits.") || key.starts_with("product.") || key.starts_with("gripper.");
    if (decides) columns.push_back(c);
  }
  return columns;
}

/// Combinations of deciding values that are remembered.
constexpr std::size_t kKnownMost = 65536;

/// Scenarios by claim; of few combinations of deciding values each is looked at once.
std::map<DamageClaim, std::size_t> counts_by_claim(const Study& study) {
  const std::vector<std::size_t> columns = deciding_columns(study);
  std::map<std::vector<std::size_t>, DamageClaim> known;
  std::map<DamageClaim, std::size_t> counts;
  for (std::size_t id = 0; id < study.scenario_count(); ++id) {
    std::vector<std::size_t> values;
    for (const std::size_t column : columns) values.push_back(study.input_index(id, column));
    if (const auto found = known.find(values); found != known.end()) {
      ++counts[found->second];
      continue;
    }
    const DamageClaim claim = damage_claim(study.scenario(id));
    ++counts[claim];
    if (known.size() < kKnownMost) known.emplace(std::move(values), claim);
  }
  return counts;
}

constexpr std::string_view kWhy = "so nothing here says that a product stays undamaged";

}  // namespace

std::string_view damage_word(DamageClaim claim) {
  switch (claim) {
    case DamageClaim::judged:
      return "judged";
    case DamageClaim::not_considered:
      return "not considered";
    case DamageClaim::not_looked_at:
      return "not looked at";
  }
  return "";
}

std::string_view damage_remark(DamageClaim claim) {
  switch (claim) {
    case DamageClaim::judged:
      return "";
    case DamageClaim::not_considered:
      return "damage was not considered";
    case DamageClaim::not_looked_at:
      return "damage was not looked at";
  }
  return "";
}

DamageClaim damage_claim(const Scenario& scenario) {
  if (scenario.limits.damage == DamageJudging::not_considered) return DamageClaim::not_considered;
  return active_damage_limits(scenario).empty() ? DamageClaim::not_looked_at : DamageClaim::judged;
}

StudyClaim damage_claim(const Study& study) {
  std::map<DamageClaim, std::size_t> counts = counts_by_claim(study);
  StudyClaim claim{.judged = counts[DamageClaim::judged], .count = study.scenario_count()};
  if (counts[DamageClaim::not_considered] > 0) claim.claim = DamageClaim::not_considered;
  if (counts[DamageClaim::not_looked_at] > 0) claim.claim = DamageClaim::not_looked_at;
  return claim;
}

std::string damage_sentence(const StudyClaim& claim) {
  if (claim.claim == DamageClaim::judged) return {};
  const std::string remark(damage_remark(claim.claim));
  if (claim.judged > 0) {
    return joined({remark, " in ", with_thousands(claim.count - claim.judged), " of ", with_thousands(claim.count),
                   " scenarios: there \"held\" does not mean undamaged"});
  }
  return claim.claim == DamageClaim::not_considered
             ? joined({remark, " (limits.damage = \"not considered\"), ", kWhy})
             : joined({remark, ": no limit of damage can act, ", kWhy});
}

std::string_view held_words(std::string_view damage_note) {
  return damage_note.empty() ? "held without damage" : "held";
}

void set_damage(ResultsMeta& meta, const Study& study) {
  const StudyClaim claim = damage_claim(study);
  meta.damage = damage_word(claim.claim);
  meta.damage_note = damage_sentence(claim);
}

std::string damage_sentence(const ResultsMeta& meta) {
  return meta.damage.empty() ? "this file does not say whether damage was looked at" : meta.damage_note;
}

}  // namespace unbruised::studies
