#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table calibrate_keys() {
  using S = CalibrateTable;
  constexpr auto at = &StudySettings::calibrate;
  const Use use = Use::curves;
  return {
      {.path = "calibrate.data",
       .type = texts,
       .meaning = "CSV files with the measured curves, relative to this file's folder or to the configs folder: "
                  "the columns of "
                  "the test, and optionally `specimen` (else a file is one specimen) and that of `outcome`.",
       .use = use,
       .note = "these files, or [[specimen]] blocks",
       .study_field = study_table<at, &S::data>},
      {.path = "calibrate.test",
       .type = choice,
       .meaning = "What was measured: press (force_N over closure_m), relaxation (force_N over time_s), creep "
                  "(closure_m over "
                  "time_s), slide (tangential force_N over time_s), all from the first contact on and per finger.",
       .choices = {"press", "relaxation", "creep", "slide"},
       .use = use,
       .study_field = study_table<at, &S::test>},
      {.path = "calibrate.outcome",
       .type = text,
       .meaning = "A column with one number for each specimen (rupture_force_N, say), which is predicted from the "
                  "fitted keys "
                  "by cross-validation.",
       .use = use,
       .study_field = study_table<at, &S::outcome>},
      {.path = "calibrate.tolerance",
       .type = number,
       .meaning = "A fit ends when its steps get smaller than this part of each range.",
       .range = {0.0, true, 0.1, false},
       .use = use,
       .study_field = study_table<at, &S::tolerance>},
      {.path = "calibrate.budget",
       .type = integer,
       .meaning = "Scenarios of one specimen's search, at most; derivatives and intervals come on top.",
       .range = {10.0, false, 10'000.0, false},
       .use = use,
       .study_field = study_table<at, &S::budget>},
      {.path = "calibrate.confidence",
       .type = number,
       .meaning = "Of all intervals.",
       .range = {0.5, false, 0.9999, false},
       .use = use,
       .study_field = study_table<at, &S::confidence>},
  };
}

Table parameter_keys() {
  using B = VariableBlock;
  const Use use = Use::curves;
  return {
      {.path = "parameter[].key",
       .type = text,
       .meaning = "The numeric key that is fitted.",
       .use = use,
       .required = true,
       .block_field = parameter<&B::key>},
      {.path = "parameter[].from",
       .type = optional_number,
       .meaning = "Least value, in the key's unit.",
       .use = use,
       .required = true,
       .note = "< to",
       .block_field = parameter<&B::from>},
      {.path = "parameter[].to",
       .type = optional_number,
       .meaning = "Largest value, in the key's unit.",
       .use = use,
       .required = true,
       .block_field = parameter<&B::to>},
      {.path = "parameter[].scale",
       .type = choice,
       .meaning = "Fitted evenly, or evenly in the logarithm; its interval is symmetric on that scale.",
       .choices = {"linear", "log"},
       .use = use,
       .note = "log needs from > 0",
       .block_field = parameter<&B::scale>},
      {.path = "parameter[].start",
       .type = optional_number,
       .meaning = "Where the fits start.",
       .use = use,
       .note = "from <= start <= to; the middle unless given",
       .block_field = parameter<&B::start>},
  };
}

Table specimen_keys() {
  using B = SpecimenBlock;
  const Use use = Use::curves;
  return {
      {.path = "specimen[].name",
       .type = text,
       .meaning = "A specimen whose curve is written out; what `calibrate.data` becomes in the resolved config.",
       .use = use,
       .required = true,
       .note = "all different",
       .block_field = specimen<&B::name>},
      {.path = "specimen[].closure_m",
       .type = series,
       .meaning = "By which the fingers have come closer since the first contact.",
       .use = use,
       .note = "press, creep",
       .block_field = specimen<&B::closure_m>},
      {.path = "specimen[].time_s",
       .type = series,
       .meaning = "Time since the first contact.",
       .use = use,
       .note = "relaxation, creep, slide",
       .block_field = specimen<&B::time_s>},
      {.path = "specimen[].force_N",
       .type = series,
       .meaning = "Force of a finger: normal, of a slide test tangential.",
       .use = use,
       .note = "press, relaxation, slide",
       .block_field = specimen<&B::force_N>},
      {.path = "specimen[].outcome",
       .type = optional_number,
       .meaning = "Of the specimen, what calibrate.outcome names.",
       .use = use,
       .block_field = specimen<&B::outcome>},
  };
}

}  // namespace unbruised::studies::key_rows
