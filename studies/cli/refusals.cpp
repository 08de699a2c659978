#include "studies/cli/refusals.hpp"

#include "studies/cli/commands.hpp"
#include "studies/kinds/kind_table.hpp"
#include "studies/ranks/join_ranks.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

bool refuse_ranks(const std::string& what) {
  if (rank_count() == 1) return false;
  print_error(joined({what, " is for one process, without mpirun"}));
  return true;
}

std::optional<std::string> has_no_parts(const Study& study) {
  if (parts_of(study.kind()) != nullptr) return std::nullopt;
  return joined({study.name(), ": study.kind = \"", study_kind_word(study.kind()),
                 "\": asks for one scenario after the answer of another and has no parts; run it as a whole, on "
                 "several machines with mpirun"});
}

}  // namespace unbruised::studies
