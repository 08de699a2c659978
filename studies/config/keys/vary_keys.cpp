#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

namespace {

/// Small enough that a fixed-size table of results for it fits on a disk.
constexpr Range kCountRange{1.0, false, 10'000'000.0, false};

}  // namespace

Table vary_keys() {
  return {
      {.path = "vary[].key",
       .type = text,
       .meaning = "The key that takes several values.",
       .required = true,
       .vary_field = vary<&VaryBlock::key>},
      {.path = "vary[].from",
       .type = optional_number,
       .meaning = "First value, in the key's unit.",
       .note = "with to and count, or values instead",
       .vary_field = vary<&VaryBlock::from>},
      {.path = "vary[].to",
       .type = optional_number,
       .meaning = "Last value, in the key's unit.",
       .note = "with from and count",
       .vary_field = vary<&VaryBlock::to>},
      {.path = "vary[].count",
       .type = integer,
       .meaning = "Number of values, both ends included.",
       .range = kCountRange,
       .note = "with from and to",
       .vary_field = vary<&VaryBlock::count>},
      {.path = "vary[].scale",
       .type = choice,
       .meaning = "Equal steps, or equal ratios.",
       .choices = {"linear", "log"},
       .note = "log needs from > 0 and to > 0",
       .vary_field = vary<&VaryBlock::scale>},
      {.path = "vary[].values",
       .type = any_array,
       .meaning = "The values themselves: numbers, strings or booleans.",
       .note = "instead of from, to, count"},
      {.path = "vary[].zip",
       .type = text,
       .meaning = "Blocks with the same word vary together, at the place of the first of them.",
       .note = "equal numbers of values",
       .vary_field = vary<&VaryBlock::zip>},
  };
}

}  // namespace unbruised::studies::key_rows
