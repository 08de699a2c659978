#include "studies/estimate/memory_need.hpp"

#include <algorithm>
#include <variant>

#include "core/body/lattice.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/estimate/cost_estimate.hpp"
#include "studies/execution/machine.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Scenarios that are looked at for the largest product, evenly over the study.
constexpr std::size_t kScenariosSeen = 10000;
/// Rows as they stand in memory, beside their inputs: metrics, cause, the node of a map.
constexpr double kRowBytes = 8.0 * kMetricCount + 200.0;
/// Of a study that asks for one scenario after the answer of another: what is recorded, and what is found in it.
constexpr double kRowCopies = 3.0;
/// Of scenarios that are known beforehand rows stay in the journals, and a process knows where: when they are put
/// into order twice, with digests and what its kind looks at.
constexpr double kIndexedRowBytes = 80.0;
/// A model below this part of the machine's memory needs no second look.
constexpr double kSmallPart = 0.02;

/// Particles of a lattice by its volume: near enough to tell megabytes from gigabytes.
double particles_by_volume(const Scenario& scenario) {
  const auto* lattice = std::get_if<LatticeParameters>(&scenario.product);
  if (lattice == nullptr)
    return static_cast<double>(std::get<NetworkParameters>(scenario.product).particle.size());
  const double cell_m = lattice->cell_size_m;
  return true_volume_m3(*lattice) / (cell_m * cell_m * cell_m);
}

double bytes_by_volume(double particles) {
  ModelSize size;
  size.particle_count = static_cast<std::size_t>(std::min(particles, 1e15));
  size.freedom_count = 3 * size.particle_count;
  return estimated_model_bytes(size);
}

}  // namespace

double estimated_rows_bytes(StudyKind kind, double row_count, std::size_t input_count) {
  if (has_fixed_scenarios(kind)) {
    return row_count * (kIndexedRowBytes + static_cast<double>(input_count * sizeof(double)));
  }
  return row_count * kRowCopies * (kRowBytes + static_cast<double>(input_count * sizeof(InputValue)));
}

double estimated_run_bytes(std::vector<ModelSize> groups, int threads) {
  const auto at_a_time = std::min(groups.size(), static_cast<std::size_t>(threads));
  std::partial_sort(
      groups.begin(), groups.begin() + static_cast<std::ptrdiff_t>(at_a_time), groups.end(),
      [](const ModelSize& a, const ModelSize& b) { return estimated_model_bytes(a) > estimated_model_bytes(b); });
  double models = 0.0;
  double lane = 0.0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (i < at_a_time) models += estimated_model_bytes(groups[i]);
    lane = std::max(lane, estimated_lane_bytes(groups[i]));
  }
  return models + static_cast<double>(threads) * lane_count() * lane;
}

std::optional<std::string> too_much_memory(const std::string& study_name, double needed_bytes) {
  const double there = machine_memory_bytes();
  if (needed_bytes <= there) return std::nullopt;
  return joined({study_name, " needs about ", bytes_text(needed_bytes), " of memory, and this machine gives ",
                 bytes_text(there), ": larger cells (product.cell_size_m), fewer scenarios or fewer --threads"});
}

std::optional<std::string> too_many_may_touch(const std::string& study_name, const ModelSize& largest) {
  if (largest.compliance_bytes() <= kMostComplianceBytes) return std::nullopt;
  return joined({"in ", study_name, " ", with_thousands(largest.contact_node_count),
                 " particles may touch, whose compliance would take ", bytes_text(largest.compliance_bytes()),
                 " of ", bytes_text(kMostComplianceBytes),
                 " at most: larger cells (product.cell_size_m), or fewer places (simulation.contact_set)"});
}

std::optional<std::string> too_much_memory(const Study& study, int threads) {
  const ScenarioSet set = runner_of(study.kind()).scenarios->known(study);
  const std::size_t stride = std::max<std::size_t>(1, set.count / kScenariosSeen);
  double most = 0.0;
  std::size_t at = 0;
  for (std::size_t id = 0; id < set.count; id += stride) {
    const double particles = particles_by_volume(set.scenario(id));
    if (particles > most) at = id;
    most = std::max(most, particles);
  }
  const double rows = estimated_rows_bytes(study.kind(), static_cast<double>(set.count), set.columns.size());
  const std::size_t models = std::min(static_cast<std::size_t>(threads), set.count);
  if (auto refusal = too_much_memory(study.name(), rows + bytes_by_volume(most))) return refusal;
  if (static_cast<double>(models) * bytes_by_volume(most) < kSmallPart * machine_memory_bytes())
    return std::nullopt;
  return too_much_memory(
      study.name(),
      rows + estimated_run_bytes(std::vector(models, model_size(set.scenario(at))), static_cast<int>(models)));
}

}  // namespace unbruised::studies
