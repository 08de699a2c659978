#include "studies/results/outcome_counts.hpp"

#include <vector>

#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

std::string counts_text(const OutcomeCounts& counts) {
  std::vector<std::string> texts;
  for_each_outcome(counts, [&](Outcome outcome, std::size_t count) {
    const std::string_view word = outcome == Outcome::not_run ? "not run" : outcome_word(outcome);
    if (count > 0) texts.push_back(joined({word, " ", with_thousands(count)}));
  });
  return comma_list(texts);
}

}  // namespace unbruised::studies
