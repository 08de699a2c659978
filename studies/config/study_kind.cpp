#include "studies/config/study_kind.hpp"

#include <array>
#include <cstddef>

namespace unbruised::studies {
namespace {

using enum Blocks;

constexpr std::array kKinds = {
    StudyKindRow{.kind = StudyKind::simulate,
                 .word = "simulate",
                 .asks = "one pick with its trace",
                 .scenarios = ScenarioSource::grid},
    StudyKindRow{.kind = StudyKind::sweep,
                 .word = "sweep",
                 .asks = "every combination of the [[vary]] values",
                 .scenarios = ScenarioSource::grid,
                 .vary = required},
    StudyKindRow{.kind = StudyKind::window,
                 .word = "window",
                 .asks = "the least force that holds and the greatest that leaves no mark",
                 .scenarios = ScenarioSource::forces,
                 .vary = optional,
                 .damage = DamageAnswer::undamaged},
    StudyKindRow{.kind = StudyKind::sample,
                 .word = "sample",
                 .asks = "one strategy on products that differ",
                 .scenarios = ScenarioSource::products,
                 .random = required},
    StudyKindRow{.kind = StudyKind::optimize,
                 .word = "optimize",
                 .asks = "the best strategy, subject to the constraints",
                 .scenarios = ScenarioSource::questions,
                 .variable = required,
                 .objectives = Objectives::one,
                 .damage = DamageAnswer::undamaged},
    StudyKindRow{.kind = StudyKind::robust,
                 .word = "robust",
                 .asks = "the best strategy for products that differ",
                 .scenarios = ScenarioSource::questions,
                 .variable = optional,
                 .random = required,
                 .objectives = Objectives::one,
                 .damage = DamageAnswer::undamaged},
    StudyKindRow{.kind = StudyKind::pareto,
                 .word = "pareto",
                 .asks = "what one objective costs in the other",
                 .scenarios = ScenarioSource::questions,
                 .variable = required,
                 .objectives = Objectives::several,
                 .damage = DamageAnswer::undamaged},
    StudyKindRow{.kind = StudyKind::compare,
                 .word = "compare",
                 .asks = "which of the candidates is better on the same products",
                 .scenarios = ScenarioSource::pairs,
                 .random = required,
                 .candidate = required,
                 .damage = DamageAnswer::undamaged},
    StudyKindRow{.kind = StudyKind::sensitivity,
                 .word = "sensitivity",
                 .asks = "which of the [[random]] keys decides",
                 .scenarios = ScenarioSource::design,
                 .random = required},
    StudyKindRow{.kind = StudyKind::calibrate,
                 .word = "calibrate",
                 .asks = "which values of keys give the measured curves",
                 .scenarios = ScenarioSource::curves,
                 .parameter = required},
};

/// Does every row stand where its kind's number says?
constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (static_cast<std::size_t>(kKinds[i].kind) != i) return false;
  }
  return true;
}
static_assert(is_in_order());

}  // namespace

std::span<const StudyKindRow> study_kind_table() { return kKinds; }

std::optional<StudyKind> study_kind_named(std::string_view word) {
  for (const StudyKindRow& row : kKinds) {
    if (row.word == word) return row.kind;
  }
  return std::nullopt;
}

const StudyKindRow& row_of(StudyKind kind) { return kKinds.at(static_cast<std::size_t>(kind)); }

}  // namespace unbruised::studies
