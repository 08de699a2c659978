#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table sampling_keys() {
  using S = SamplingSettings;
  constexpr auto at = &StudySettings::sampling;
  const Use use = Use::sampling;
  return {
      {.path = "sampling.design",
       .type = choice,
       .meaning =
           "How products are drawn. The first two in eight independent designs, whose spread gives the intervals.",
       .choices = {"sobol", "latin_hypercube", "random"},
       .use = Use::random,
       .study_field = study_table<at, &S::design>},
      {.path = "sampling.count",
       .type = integer,
       .meaning = "Random products.",
       .range = {2.0, false, 1'000'000.0, false},
       .use = use,
       .note = "of a robust study <= 65,536 / points asked at once",
       .study_field = study_table<at, &S::count>},
      {.path = "sampling.factor_groups",
       .type = integer,
       .meaning =
           "Random keys that change the factored matrix (stiffness, size, mass) take this many joint values, so "
           "that lanes are full; 0: every product its own.",
       .range = {0.0, false, 1'000'000.0, false},
       .use = use,
       .study_field = study_table<at, &S::factor_groups>},
      {.path = "sampling.confidence",
       .type = number,
       .meaning = "Of all intervals.",
       .range = {0.5, false, 0.9999, false},
       .use = use,
       .study_field = study_table<at, &S::confidence>},
  };
}

Table compare_keys() {
  using S = CompareTable;
  constexpr auto at = &StudySettings::compare;
  const Use use = Use::candidates;
  return {
      {.path = "compare.metric",
       .type = text,
       .meaning = "The metric that decides: less is better, of friction_margin_min more; a product that is not "
                  "held loses.",
       .use = use,
       .study_field = study_table<at, &S::metric>},
      {.path = "compare.metrics",
       .type = texts,
       .meaning = "Metrics whose differences are shown beside it.",
       .use = use,
       .study_field = study_table<at, &S::metrics>},
      {.path = "compare.tie",
       .type = number,
       .meaning = "Differences of the metric up to this, in its unit, count as ties.",
       .range = kNotNegative,
       .use = use,
       .study_field = study_table<at, &S::tie>},
  };
}

Table sensitivity_keys() {
  using S = SensitivityTable;
  constexpr auto at = &StudySettings::sensitivity;
  const Use use = Use::design;
  return {
      {.path = "sensitivity.method",
       .type = choice,
       .meaning = "Sobol' indices (parts of the variance), or Morris screening (elementary effects; fewer runs).",
       .choices = {"sobol", "morris"},
       .use = use,
       .study_field = study_table<at, &S::method>},
      {.path = "sensitivity.metrics",
       .type = texts,
       .meaning = "The metrics that are looked at.",
       .use = use,
       .required = true,
       .study_field = study_table<at, &S::metrics>},
      {.path = "sensitivity.samples",
       .type = integer,
       .meaning =
           "sobol: base samples, runs are samples x (keys + 2); morris: trajectories, runs are samples x (keys + "
           "1).",
       .range = {2.0, false, 1'000'000.0, false},
       .use = use,
       .study_field = study_table<at, &S::samples>},
      {.path = "sensitivity.levels",
       .type = integer,
       .meaning =
           "Levels of Morris' grid; keys that change the factored matrix take this many values in either method.",
       .range = {4.0, false, 64.0, false},
       .use = use,
       .note = "even",
       .study_field = study_table<at, &S::levels>},
      {.path = "sensitivity.bootstrap",
       .type = integer,
       .meaning = "Replicates of the bootstrap intervals of a random design.",
       .range = {10.0, false, 100'000.0, false},
       .use = use,
       .study_field = study_table<at, &S::bootstrap>},
      {.path = "sensitivity.confidence",
       .type = number,
       .meaning = "Of the intervals.",
       .range = {0.5, false, 0.9999, false},
       .use = use,
       .study_field = study_table<at, &S::confidence>},
  };
}

}  // namespace unbruised::studies::key_rows
