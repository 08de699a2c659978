#include "studies/findings/rests_on.hpp"

#include "studies/config/sources.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

ValueCounts value_counts(std::string_view resolved_toml) {
  ValueCounts counts;
  for (const ValueSource& each : value_sources(resolved_toml)) {
    switch (each.standing) {
      case Standing::assumed:
        ++counts.assumed;
        break;
      case Standing::unsourced:
        ++counts.unsourced;
        break;
      case Standing::cited:
        ++counts.cited;
        break;
    }
  }
  return counts;
}

std::string rests_on_line(const ValueCounts& counts) {
  if (counts.all() == 0) return {};
  return joined({"rests on ", with_thousands(counts.all()), counts.all() == 1 ? " value" : " values",
                 " of product, gripper and limits: ", with_thousands(counts.assumed), " assumed, ",
                 with_thousands(counts.unsourced), " without a source, ", with_thousands(counts.cited),
                 " from a source"});
}

}  // namespace unbruised::studies
