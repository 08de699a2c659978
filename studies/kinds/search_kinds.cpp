#include "studies/kinds/search_kinds.hpp"

#include "studies/execution/evaluation_broker.hpp"
#include "studies/findings/check_warnings.hpp"
#include "studies/findings/found_tables.hpp"
#include "studies/findings/strategy_judge.hpp"
#include "studies/kinds/search_study.hpp"
#include "studies/kinds/study_answer.hpp"

namespace unbruised::studies {

KindAnswer run_search(const KindInput& input) {
  const Study& study = input.study;
  input.journal.total_may_grow();
  const std::vector<ScenarioRow> recorded = input.journal.rows().held();
  input.journal.expect(evaluations_at_most(study), recorded.size());
  const StrategyJudge judge(study);
  EvaluationBroker broker(input.executor, recorded, [&](const ScenarioRow& row) { input.journal.record(row); },
                          {.stop = input.stop, .concurrent_searches = input.concurrent_searches});
  SearchFindings found;
  try {
    found = run_searches(judge, broker);
  } catch (const EvaluationBroker::ForeignRecord& foreign) {
    throw input.journal.foreign_record(journal_id(foreign.place));
  }
  std::vector<ScenarioRow> rows = input.journal.rows().held();
  number_placed_rows(rows);
  KindAnswer answer;
  answer.interrupted = found.interrupted;
  answer.lane_use = found.searching;
  answer.search_seconds = found.search_seconds;
  answer.from_memory = broker.counts().from_memory;
  answer.found = search_tables(judge, found, rows);
  if (!found.interrupted) answer.strategy = search_strategy(study, found);
  answer.warnings = check_warnings(answer.found);
  return answer;
}

}  // namespace unbruised::studies
