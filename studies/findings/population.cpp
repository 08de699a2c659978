#include "studies/findings/population.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/config/document.hpp"
#include "studies/config/product_text.hpp"
#include "studies/statistics/distribution.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Fewer specimens have no correlations to speak of.
constexpr std::size_t kFewestCorrelated = 4;
/// Rank correlations are told to thousandths; those of few specimens may be one.
constexpr double kLargestRank = 0.999;

bool tells_all(const SpecimenFit& fit) {
  return fit.is_fitted && std::all_of(fit.unit_error.begin(), fit.unit_error.end(),
                                      [](double error) { return error < kToldError; });
}

std::vector<double> column(const std::vector<SpecimenFit>& fits, const std::vector<std::size_t>& specimens,
                           std::size_t key, std::vector<double> SpecimenFit::*values) {
  std::vector<double> out;
  for (const std::size_t i : specimens) out.push_back((fits[i].*values)[key]);
  return out;
}

FittedKey fitted_key(const SearchVariable& variable, const std::vector<double>& units,
                     const std::vector<double>& errors) {
  FittedKey key{.key = variable.key, .is_log = variable.scale == optimizer::Scale::log};
  const MeanAndSpread spread = mean_and_spread(units);
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  key.scatter = spread.standard_deviation;
  key.error = std::sqrt(squares / static_cast<double>(errors.size()));
  const double between = std::sqrt(std::max(0.0, key.scatter * key.scatter - key.error * key.error));
  if (!key.is_log) {
    key.mean = variable.from + spread.mean * (variable.to - variable.from);
    key.deviation = between * (variable.to - variable.from);
    return key;
  }
  // Of a lognormal: mean exp(m + s^2 / 2), deviation mean sqrt(exp(s^2) - 1).
  const double width = std::log(variable.to / variable.from);
  const double m = std::log(variable.from) + spread.mean * width;
  const double s = between * width;
  key.mean = std::exp(m + 0.5 * s * s);
  key.deviation = key.mean * std::sqrt(std::expm1(s * s));
  return key;
}

CorrelationMatrix rank_correlations(const std::vector<SpecimenFit>& fits,
                                    const std::vector<std::size_t>& specimens, std::size_t keys) {
  CorrelationMatrix ranks(keys);
  for (std::size_t i = 0; i < keys; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double rank = spearman(column(fits, specimens, i, &SpecimenFit::values),
                                   column(fits, specimens, j, &SpecimenFit::values));
      const double known = std::isnan(rank) ? 0.0 : std::clamp(rank, -kLargestRank, kLargestRank);
      ranks.set(i, j, std::round(1000.0 * known) / 1000.0);
    }
  }
  return least_eigenvalue(normal_correlations(ranks)) > kLeastEigenvalue ? ranks : nearest_ranks(ranks);
}

std::string random_block(const FittedKey& key, const SearchVariable& variable) {
  return joined({"\n[[random]]\nkey = ", toml_string(key.key),
                 "\ndistribution = ", key.is_log ? "\"lognormal\"" : "\"normal\"", "\nmean = ", spelled(key.mean),
                 "\nstandard_deviation = ", spelled(key.deviation), "\nat_least = ", spelled(variable.from),
                 "\nat_most = ", spelled(variable.to), "\n"});
}

std::string correlation_block(const FittedKey& a, const FittedKey& b, double rank) {
  return joined({"\n[[correlation]]\nbetween = [", toml_string(a.key), ", ", toml_string(b.key),
                 "]\nvalue = ", spelled(rank), "\n"});
}

/// What the study says of its product's sources, but for the keys that were fitted.
std::string source_lines(const Study& study, const Population& population) {
  std::string text = "\n[source]\n";
  const std::string start = "[product.source]\n";
  const std::string& resolved = study.resolved_toml();
  std::size_t at = resolved.find(start);
  at = at == std::string::npos ? resolved.size() : at + start.size();
  while (at < resolved.size() && resolved[at] != '\n') {
    const std::size_t end = std::min(resolved.find('\n', at), resolved.size());
    const std::string line = resolved.substr(at, end - at);
    const std::string leaf = line.substr(0, line.find(' '));
    const bool is_fitted = std::any_of(population.keys.begin(), population.keys.end(), [&](const FittedKey& key) {
      return key.key == "product." + leaf || key.key.starts_with("product." + leaf + "[");
    });
    if (!is_fitted) text += line + "\n";
    at = end + 1;
  }
  for (const FittedKey& key : population.keys) {
    if (!key.key.starts_with("product.") || key.key.find('[') != std::string::npos) continue;
    text += joined({key.key.substr(8), " = ",
                    toml_string(joined({"fitted by the study ", study.name(), " to the curves of ",
                                        std::to_string(population.specimens.size()), " specimens"})),
                    "\n"});
  }
  return text;
}

}  // namespace

Population population_of(const Study& study, const std::vector<SpecimenFit>& fits) {
  Population population;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (tells_all(fits[i])) population.specimens.push_back(i);
  }
  if (population.specimens.empty()) return population;
  for (std::size_t k = 0; k < study.variables().size(); ++k) {
    population.keys.push_back(fitted_key(study.variables()[k],
                                         column(fits, population.specimens, k, &SpecimenFit::unit),
                                         column(fits, population.specimens, k, &SpecimenFit::unit_error)));
  }
  if (population.specimens.size() >= kFewestCorrelated) {
    population.ranks = rank_correlations(fits, population.specimens, population.keys.size());
  }
  return population;
}

std::string population_toml(const Study& study, const Population& population) {
  if (population.keys.empty()) return {};
  std::vector<std::string> keys;
  std::vector<double> means;
  std::string beside;
  for (const FittedKey& key : population.keys) {
    keys.push_back(key.key);
    means.push_back(key.mean);
    if (key.key.starts_with("product.")) continue;
    beside += joined({"# Fitted beside the product: ", key.key, " = ", spelled(key.mean), "\n"});
  }
  const std::string specimens = std::to_string(population.specimens.size());
  std::string text =
      joined({"# Made by the study ", study.name(), " (kind = calibrate) from ", specimens,
              " specimens: means, how they differ ([[random]]), and how their properties go together.\n",
              "# [product] use = \"...\" takes it; studies that draw products take the blocks too.\n", beside,
              "name = ", toml_string(study.name()),
              "\ndescription = ", toml_string(joined({"Fitted to the curves of ", specimens, " specimens"})), "\n",
              product_lines(study.scenario_with(keys, means)), source_lines(study, population)});
  for (std::size_t k = 0; k < population.keys.size(); ++k) {
    if (population.keys[k].deviation > 0.0) text += random_block(population.keys[k], study.variables()[k]);
  }
  for (std::size_t i = 0; population.ranks && i < population.keys.size(); ++i) {
    for (std::size_t j = i + 1; j < population.keys.size(); ++j) {
      const bool differ = population.keys[i].deviation > 0.0 && population.keys[j].deviation > 0.0;
      if (!differ || population.ranks->at(i, j) == 0.0) continue;
      text += correlation_block(population.keys[i], population.keys[j], population.ranks->at(i, j));
    }
  }
  return text;
}

}  // namespace unbruised::studies
