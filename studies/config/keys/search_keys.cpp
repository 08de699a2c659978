#include "optimizer/algorithm.hpp"
#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

namespace {

std::vector<std::string_view> algorithm_names() {
  std::vector<std::string_view> names;
  for (const optimizer::AlgorithmInfo& info : optimizer::algorithm_table()) names.push_back(info.name);
  return names;
}

}  // namespace

Table goal_keys() {
  using S = SearchTable;
  constexpr auto at = &StudySettings::search;
  return {
      {.path = "search.objective",
       .type = text,
       .meaning =
           "What is to be least: a metric or a weighted sum, \"cycle_time_s + 0.5 * peak_finger_force_N\"; of a "
           "robust study statistics over the products: mean(m), quantile(m, 0.95), worst(m).",
       .use = Use::one_objective,
       .note = "cycle_time_s, of a robust study mean(cycle_time_s), unless given",
       .study_field = study_table<at, &S::objective>},
      {.path = "search.objectives",
       .type = texts,
       .meaning = "The two or three objectives of a Pareto front.",
       .use = Use::several_objectives,
       .required = true,
       .study_field = study_table<at, &S::objectives>},
      {.path = "search.constraints",
       .type = texts,
       .meaning = "What has to hold: outcomes (\"held\", \"not damaged\"), metrics (\"friction_margin_min >= "
                  "0.2\"), of a "
                  "robust study \"P(held) >= 0.99\" or \"worst(permanent_set_max_m) <= 1e-4\".",
       .use = Use::search,
       .note = "\"held\", of a robust study \"P(held) >= 0.99\", is added where no outcome is named; [] is none "
               "at all",
       .study_field = study_table<at, &S::constraints>},
  };
}

Table algorithm_keys() {
  using S = SearchTable;
  constexpr auto at = &StudySettings::search;
  return {
      {.path = "search.algorithm",
       .type = choice,
       .meaning = "NLopt algorithm of each search.",
       .choices = algorithm_names(),
       .use = Use::search,
       .note = "one that takes the study's constraints",
       .study_field = study_table<at, &S::algorithm>},
      {.path = "search.local_algorithm",
       .type = text,
       .meaning = "The algorithm inside MLSL and AUGLAG.",
       .use = Use::search,
       .note = "with MLSL and AUGLAG only",
       .study_field = study_table<at, &S::local_algorithm>},
      {.path = "search.starts",
       .type = integer,
       .meaning =
           "Searches that start from different points of the box, of a pareto study: for each of its points.",
       .range = {1.0, false, 4096.0, false},
       .use = Use::search,
       .note = "robust: 4, pareto: 2 unless given",
       .study_field = study_table<at, &S::starts>},
      {.path = "search.budget",
       .type = integer,
       .meaning = "Strategies that all searches together may evaluate.",
       .range = {1.0, false, 10'000'000.0, false},
       .use = Use::search,
       .note = ">= starts; robust: 100, else 40 for each search unless given",
       .study_field = study_table<at, &S::budget>},
      {.path = "search.tolerance",
       .type = number,
       .meaning = "A search ends when its steps fall below this part of each variable's range.",
       .range = {0.0, true, 1.0, true},
       .use = Use::search,
       .study_field = study_table<at, &S::tolerance>},
      {.path = "search.initial_step",
       .type = number,
       .meaning = "First step of a search, as part of each variable's range.",
       .range = {0.0, true, 1.0, false},
       .use = Use::search,
       .study_field = study_table<at, &S::initial_step>},
      {.path = "search.method",
       .type = choice,
       .meaning = "How points of the front are found.",
       .choices = {"epsilon_constraint", "chebyshev"},
       .use = Use::several_objectives,
       .study_field = study_table<at, &S::method>},
      {.path = "search.points",
       .type = integer,
       .meaning = "Points looked for between the ends of the front.",
       .range = {1.0, false, 1000.0, false},
       .use = Use::several_objectives,
       .study_field = study_table<at, &S::points>},
  };
}

}  // namespace unbruised::studies::key_rows
