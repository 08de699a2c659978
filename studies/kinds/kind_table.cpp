#include "studies/kinds/kind_table.hpp"

#include <array>

#include "studies/kinds/calibrate_kind.hpp"
#include "studies/kinds/scenario_families.hpp"
#include "studies/kinds/search_kinds.hpp"
#include "studies/kinds/set_kinds.hpp"
#include "studies/kinds/window_kind.hpp"

namespace unbruised::studies {
namespace {

constexpr std::array kKinds = {
    KindRow{StudyKind::simulate, run_simulate, &kFixedScenarios, simulate_template},
    KindRow{StudyKind::sweep, run_sweep, &kFixedScenarios, sweep_template},
    KindRow{StudyKind::window, run_window, &kAskedForces, window_template},
    KindRow{StudyKind::sample, run_sample, &kFixedScenarios, sample_template},
    KindRow{StudyKind::optimize, run_search, &kAskedQuestions, optimize_template},
    KindRow{StudyKind::robust, run_search, &kAskedQuestions, robust_template},
    KindRow{StudyKind::pareto, run_search, &kAskedQuestions, pareto_template},
    KindRow{StudyKind::compare, run_compare, &kFixedScenarios, compare_template},
    KindRow{StudyKind::sensitivity, run_sensitivity, &kFixedScenarios, sensitivity_template},
    KindRow{StudyKind::calibrate, run_calibrate, &kAskedCurves, calibrate_template},
};

}  // namespace

std::span<const KindRow> kind_table() { return kKinds; }

const KindRow& runner_of(StudyKind kind) { return kKinds.at(static_cast<std::size_t>(kind)); }

bool has_fixed_scenarios(StudyKind kind) { return runner_of(kind).scenarios->count == ScenarioCount::exact; }

RowPlaces row_places(StudyKind kind) { return runner_of(kind).scenarios->places; }

const StudyParts* parts_of(StudyKind kind) { return runner_of(kind).scenarios->parts; }

std::vector<ColumnInfo> input_columns(const Study& study) {
  return runner_of(study.kind()).scenarios->columns(study);
}

std::optional<Scenario> scenario_of_row(const Study& study, const ScenarioRow& row) {
  return runner_of(study.kind()).scenarios->scenario_of_row(study, row);
}

}  // namespace unbruised::studies
