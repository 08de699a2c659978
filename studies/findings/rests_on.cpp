#include "studies/findings/rests_on.hpp"

#include "studies/config/sources.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

ValueCounts value_counts(std::string_view resolved_toml) {
  ValueCounts counts;
  const ConfigSources sources = config_sources(resolved_toml);
  for (const ValueSource& each : sources.values) {
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
  counts.files = comma_list(sources.varied_files);
  return counts;
}

std::string rests_on_line(const ValueCounts& counts) {
  const std::string files =
      counts.files.empty() ? std::string() : joined({"the files of ", counts.files, " with their sources"});
  if (counts.all() == 0) return files.empty() ? files : joined({"rests on ", files});
  return joined({"rests on ", with_thousands(counts.all()), counts.all() == 1 ? " value" : " values",
                 " of product, gripper and limits: ", with_thousands(counts.assumed), " assumed, ",
                 with_thousands(counts.unsourced), " without a source, ", with_thousands(counts.cited),
                 " from a source", files.empty() ? "" : "; and on ", files});
}

}  // namespace unbruised::studies
