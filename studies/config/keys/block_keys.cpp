#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table variable_keys() {
  using B = VariableBlock;
  const Use use = Use::search;
  return {
      {.path = "variable[].key",
       .type = text,
       .meaning = "The numeric key that is searched.",
       .use = use,
       .required = true,
       .block_field = variable<&B::key>},
      {.path = "variable[].from",
       .type = optional_number,
       .meaning = "Least value, in the key's unit.",
       .use = use,
       .required = true,
       .note = "< to",
       .block_field = variable<&B::from>},
      {.path = "variable[].to",
       .type = optional_number,
       .meaning = "Largest value, in the key's unit.",
       .use = use,
       .required = true,
       .block_field = variable<&B::to>},
      {.path = "variable[].scale",
       .type = choice,
       .meaning = "Searched evenly, or evenly in the logarithm.",
       .choices = {"linear", "log"},
       .use = use,
       .note = "log needs from > 0",
       .block_field = variable<&B::scale>},
      {.path = "variable[].start",
       .type = optional_number,
       .meaning = "Where the first search starts.",
       .use = use,
       .note = "from <= start <= to; the middle unless given",
       .block_field = variable<&B::start>},
  };
}

Table random_keys() {
  using B = RandomBlock;
  const Use use = Use::random;
  return {
      {.path = "random[].key",
       .type = text,
       .meaning = "The numeric key that is drawn, or whose value is missed by a drawn error (relative, absolute).",
       .use = use,
       .required = true,
       .block_field = random<&B::key>},
      {.path = "random[].distribution",
       .type = choice,
       .meaning = "Its distribution; of an error uniform unless given.",
       .choices = {"uniform", "normal", "lognormal", "triangular", "data"},
       .use = use,
       .note = "required without relative and absolute",
       .block_field = random<&B::distribution>},
      {.path = "random[].mean",
       .type = optional_number,
       .meaning = "Mean of the key itself (also of a lognormal).",
       .use = use,
       .note = "normal, lognormal",
       .block_field = random<&B::mean>},
      {.path = "random[].standard_deviation",
       .type = optional_number,
       .meaning = "Standard deviation of the key itself.",
       .range = kNotNegative,
       .use = use,
       .note = "normal, lognormal; this or relative_deviation",
       .block_field = random<&B::standard_deviation>},
      {.path = "random[].relative_deviation",
       .type = optional_number,
       .meaning = "Standard deviation over mean.",
       .range = kNotNegative,
       .use = use,
       .note = "normal, lognormal",
       .block_field = random<&B::relative_deviation>},
      {.path = "random[].data",
       .type = series,
       .meaning = "Measured values: they give mean and standard deviation (normal, lognormal), or are drawn "
                  "themselves, each "
                  "as likely as the others (data).",
       .use = use,
       .note = "at least 3; instead of mean and deviation, or of file and column",
       .block_field = random<&B::data>},
      {.path = "random[].file",
       .type = text,
       .meaning =
           "CSV file whose `column` has the values that are drawn, relative to this file's folder or to the "
           "configs "
           "folder. Keys that name the same file are drawn row by row, so that they vary together as measured.",
       .use = use,
       .note = "data; with column",
       .block_field = random<&B::file>},
      {.path = "random[].column",
       .type = text,
       .meaning = "The column of `file`, in the key's unit.",
       .use = use,
       .note = "data; with file",
       .block_field = random<&B::column>},
      {.path = "random[].zip",
       .type = text,
       .meaning = "Blocks with the same word take the same row of their data.",
       .use = use,
       .note = "data; equal numbers of values; the name of the file unless given",
       .block_field = random<&B::zip>},
  };
}

Table random_bound_keys() {
  using B = RandomBlock;
  const Use use = Use::random;
  return {
      {.path = "random[].from",
       .type = optional_number,
       .meaning = "Least value.",
       .use = use,
       .note = "uniform, triangular; < to",
       .block_field = random<&B::from>},
      {.path = "random[].to",
       .type = optional_number,
       .meaning = "Largest value.",
       .use = use,
       .note = "uniform, triangular",
       .block_field = random<&B::to>},
      {.path = "random[].mode",
       .type = optional_number,
       .meaning = "Likeliest value.",
       .use = use,
       .note = "triangular; from <= mode <= to",
       .block_field = random<&B::mode>},
      {.path = "random[].at_least",
       .type = optional_number,
       .meaning = "Smaller values are cut off.",
       .use = use,
       .note = "< at_most",
       .block_field = random<&B::at_least>},
      {.path = "random[].at_most",
       .type = optional_number,
       .meaning = "Larger values are cut off.",
       .use = use,
       .block_field = random<&B::at_most>},
      {.path = "random[].relative",
       .type = optional_number,
       .meaning =
           "An execution error around the value that is searched, a candidate's own or written: value x (1 + "
           "error), the error within +- this; normal: half of it is the standard deviation.",
       .range = {0.0, true, 1.0, true},
       .use = use,
       .note = "keys of [strategy] and [cell]; alone, or with distribution",
       .block_field = random<&B::relative>},
      {.path = "random[].absolute",
       .type = optional_number,
       .meaning = "The same in the unit of the key: value + error.",
       .range = kPositive,
       .use = use,
       .note = "keys of [strategy] and [cell]; alone, or with distribution",
       .block_field = random<&B::absolute>},
  };
}

Table correlation_keys() {
  using B = CorrelationBlock;
  const Use use = Use::random;
  return {
      {.path = "correlation[].between",
       .type = texts,
       .meaning = "Two random keys that vary together.",
       .use = use,
       .required = true,
       .note = "two keys of [[random]] blocks",
       .block_field = correlation<&B::between>},
      {.path = "correlation[].value",
       .type = optional_number,
       .meaning = "Spearman's rank correlation of the two; keys without a block are independent.",
       .range = {-1.0, true, 1.0, true},
       .use = use,
       .required = true,
       .note = "all of them together positive definite",
       .block_field = correlation<&B::value>},
  };
}

Table candidate_keys() {
  using B = CandidateBlock;
  const Use use = Use::candidates;
  return {
      {.path = "candidate[].name",
       .type = text,
       .meaning = "What the strategy is called. Beside name and use a candidate has the keys of [strategy].",
       .use = use,
       .required = true,
       .note = "1 to 64 letters, digits, '_' or '-'; all different",
       .block_field = candidate<&B::name>},
      {.path = "candidate[].use",
       .type = text,
       .meaning =
           "A strategy file, relative to this file's folder or to the configs folder; keys given here override "
           "it.",
       .use = use,
       .block_field = candidate<&B::use>},
  };
}

}  // namespace unbruised::studies::key_rows
