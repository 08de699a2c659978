#include "studies/kinds/run_journal.hpp"

#include <string>

#include "studies/text/joined.hpp"

namespace unbruised::studies {

void RunJournal::record(const ScenarioRow& row) {
  if (auto error = run_.append(row)) throw JournalFailure{*error};
  ++recorded_now_;
  if (progress_ != nullptr) progress_->count(row.result.outcome, row.result.metrics[Metric::step_count]);
  if (row.result.outcome == Outcome::diverged) {
    run_.log(joined({"scenario ", std::to_string(row.id), " diverged: ", row.result.cause}));
  }
}

void RunJournal::expect(std::size_t count, std::size_t already_done) {
  if (progress_ != nullptr) progress_->expect(count, already_done);
}

void RunJournal::total_may_grow() {
  if (progress_ != nullptr) progress_->total_may_grow();
}

JournalFailure RunJournal::foreign_record(std::uint64_t id) const {
  return JournalFailure(
      {ResultsErrorKind::damaged,
       joined({"evaluation ", std::to_string(id), " in the journal of ", run_.directory().string(),
               " is another one than this search asks for: it was written by another build or "
               "is damaged. Use --fresh to move it aside and start anew"}),
       {}});
}

}  // namespace unbruised::studies
