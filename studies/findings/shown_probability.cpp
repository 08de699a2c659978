#include "studies/findings/shown_probability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/findings/table_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// More products than this are no advice.
constexpr double kProductsMost = 1e6;

/// Least number of independent products, the part `estimate` of them successes, whose Wilson interval lies above
/// `wanted`: its ends are the p with |estimate - p| = z sqrt(p (1 - p) / n).
double independent_products(double wanted, double estimate, double confidence) {
  const double low_of_one = wilson_interval(1.0, 1.0, confidence).low;  // 1 / (1 + z^2)
  const double z2 = (1.0 - low_of_one) / low_of_one;
  const double least = z2 * wanted * (1.0 - wanted) / ((estimate - wanted) * (estimate - wanted));
  return std::floor(least) + 1.0;
}

std::string settings_text(const NeededSample& needed, FactorGroups groups) {
  return joined({"sampling.count = ", with_thousands(needed.products),
                 groups == FactorGroups::shared
                     ? joined({" with sampling.factor_groups = ", with_thousands(needed.factor_groups)})
                     : std::string()});
}

std::string rule_text(const JudgedEvent& judged) {
  return joined({"P(", judged.text, ") >= ", short_number(*judged.wanted)});
}

/// Why the study's products cannot show it, however they turn out; empty: they can.
std::string doubt_about(const JudgedEvent& judged, const Study& study) {
  const SamplingSettings& sampling = study.sampling();
  const double wanted = *judged.wanted;
  const std::string rule = rule_text(judged);
  if (wanted >= 1.0) {
    return joined({rule,
                   " can be shown by no number of products: an interval never begins at 100 %; write e.g. "
                   "0.99"});
  }
  const std::size_t needed = trials_to_show(wanted, sampling.confidence);
  const auto count = static_cast<double>(sampling.count);
  const std::string each =
      factor_groups_of(study) == FactorGroups::shared ? " with sampling.factor_groups = 0" : "";
  if (sampling.count < needed) {
    const double low = wilson_interval(count, count, sampling.confidence).low;
    return joined({rule, " cannot be shown by ", with_thousands(sampling.count),
                   " products: even if it holds for all of them the ", percent(sampling.confidence),
                   " interval begins at ", percent(low), "; sampling.count = ", with_thousands(needed), each,
                   " could show it"});
  }
  return {};
}

/// Why they may not, depending on how alike they turn out; empty: nothing stands against it.
std::string note_about(const JudgedEvent& judged, const Study& study) {
  const SamplingSettings& sampling = study.sampling();
  if (!doubt_about(judged, study).empty() || factor_groups_of(study) == FactorGroups::own) return {};
  if (sampling.factor_groups >= trials_to_show(*judged.wanted, sampling.confidence)) return {};
  return joined(
      {rule_text(judged), " may stay unshown: the products share ", with_thousands(sampling.factor_groups),
       " factor groups, and where those of a group behave alike they count as that many products, not as ",
       with_thousands(sampling.count), "; sampling.factor_groups = 0 makes each its own"});
}

}  // namespace

Shown shown(double wanted, const Proportion& found) {
  if (!(found.estimate >= wanted)) return Shown::broken;
  return found.interval.low >= wanted ? Shown::shown : Shown::met_by_the_estimate;
}

std::optional<NeededSample> needed_sample(double wanted, const Proportion& found, const SamplingSettings& sampling,
                                          FactorGroups factor_groups) {
  if (shown(wanted, found) != Shown::met_by_the_estimate || found.estimate <= wanted) return std::nullopt;
  const double independent = independent_products(wanted, found.estimate, sampling.confidence);
  if (factor_groups == FactorGroups::own) {
    const double own = independent * static_cast<double>(found.count) / found.effective_size;
    if (own > kProductsMost) return std::nullopt;
    return NeededSample{static_cast<std::size_t>(std::ceil(own)), 0};
  }
  // Groups of the same size, more of them: then products stay as alike as they were found to be.
  const double more = independent / found.effective_size;
  const double products = std::ceil(more * static_cast<double>(sampling.count));
  if (products > kProductsMost) return std::nullopt;
  const double groups = std::ceil(more * static_cast<double>(sampling.factor_groups));
  return NeededSample{static_cast<std::size_t>(products), static_cast<std::size_t>(std::min(groups, products))};
}

FactorGroups factor_groups_of(const Study& study) {
  const bool changes_factor = std::any_of(study.randoms().begin(), study.randoms().end(),
                                          [](const RandomVariable& random) { return random.changes_factor; });
  const SamplingSettings& sampling = study.sampling();
  const bool is_shared = changes_factor && sampling.factor_groups > 0 && sampling.factor_groups < sampling.count;
  return is_shared ? FactorGroups::shared : FactorGroups::own;
}

std::string shown_text(double wanted, const Proportion& found, const Study& study) {
  switch (shown(wanted, found)) {
    case Shown::broken:
      return {};
    case Shown::shown:
      return "shown by the interval";
    case Shown::met_by_the_estimate:
      break;
  }
  const FactorGroups groups = factor_groups_of(study);
  const std::string met =
      joined({"met by the estimate only, not shown: the interval begins at ", percent(found.interval.low)});
  if (const auto needed = needed_sample(wanted, found, study.sampling(), groups)) {
    return joined({met, "; ", settings_text(*needed, groups), " would show it if products stay as they are"});
  }
  return joined(
      {met, "; the estimate lies too near to ", percent(wanted), " for any number of products to show it"});
}

namespace {

std::vector<std::string> said_of_probabilities(const Study& study,
                                               std::string (*said)(const JudgedEvent&, const Study&)) {
  std::vector<std::string> sentences;
  if (!is_sampled_search(study.kind())) return sentences;
  const StrategyJudge judge(study);
  for (const JudgedEvent& judged : judge.events()) {
    if (!judged.wanted) continue;
    if (std::string sentence = said(judged, study); !sentence.empty()) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace

std::vector<std::string> probability_doubts(const Study& study) {
  return said_of_probabilities(study, doubt_about);
}

std::vector<std::string> probability_notes(const Study& study) { return said_of_probabilities(study, note_about); }

}  // namespace unbruised::studies
