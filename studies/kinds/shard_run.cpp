#include "studies/kinds/shard_run.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "core/scenario/factor_key.hpp"
#include "studies/execution/batch_runner.hpp"
#include "studies/kinds/run_journal.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

std::vector<std::uint64_t> shard_ids(const ScenarioSet& set, const Shard& shard) {
  std::map<std::string, std::uint64_t> group_of_key;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ordered;  // group, id
  ordered.reserve(set.count);
  for (std::uint64_t id = 0; id < set.count; ++id) {
    const auto found = group_of_key.try_emplace(factor_key(set.scenario(id)), group_of_key.size()).first;
    ordered.emplace_back(found->second, id);
  }
  std::ranges::sort(ordered);
  // Without overflow for any count of parts.
  const auto begin_of = [&](std::uint64_t part) {
    return set.count / shard.count * part + set.count % shard.count * part / shard.count;
  };
  std::vector<std::uint64_t> ids;
  for (std::uint64_t at = begin_of(shard.number - 1); at < begin_of(shard.number); ++at) {
    ids.push_back(ordered[at].second);
  }
  std::ranges::sort(ids);
  return ids;
}

std::vector<std::uint64_t> missing_ids(const Study& study, const RunDirectory& run) {
  std::vector<std::uint64_t> missing;
  const std::uint64_t count = scenario_set(study).count;
  for (std::uint64_t id = 0; id < count; ++id) {
    if (!run.is_done(id)) missing.push_back(id);
  }
  return missing;
}

std::string id_ranges(const std::vector<std::uint64_t>& ids) {
  constexpr std::size_t kShown = 12;
  std::vector<std::string> ranges;
  for (std::size_t first = 0; first < ids.size();) {
    std::size_t last = first;
    while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1) ++last;
    ranges.push_back(first == last ? std::to_string(ids[first])
                                   : joined({std::to_string(ids[first]), " to ", std::to_string(ids[last])}));
    first = last + 1;
  }
  if (ranges.size() <= kShown) return comma_list(ranges);
  const std::size_t left_out = ranges.size() - kShown;
  ranges.resize(kShown);
  return joined({comma_list(ranges), " and ", with_thousands(left_out), " more ranges"});
}

Expected<ShardReport> run_shard(const Study& study, RunDirectory& run, const Executor& executor,
                                const Shard& shard, const std::atomic<bool>* stop, Progress* progress) {
  const auto start = std::chrono::steady_clock::now();
  const ScenarioSet set = scenario_set(study);
  const std::vector<std::uint64_t> part = shard_ids(set, shard);
  RunJournal journal(run, progress);
  Batch batch{.ids = {}, .scenario = set.scenario, .stop = stop};
  for (const std::uint64_t id : part) {
    if (!journal.is_done(id)) batch.ids.push_back(id);
  }
  journal.expect(part.size(), part.size() - batch.ids.size());
  ShardReport report{.count = part.size()};
  try {
    report.interrupted = run_batch(executor, batch, [&](std::uint64_t id, const ScenarioResult& result) {
                           journal.record({.id = id, .result = result, .inputs = set.inputs(id)});
                         }).stopped;
  } catch (const JournalFailure& failure) {
    return failure.error;
  }
  if (auto error = run.commit()) return *error;
  report.run_now = journal.recorded_now();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.log(joined({"part ", std::to_string(shard.number), " of ", std::to_string(shard.count),
                  report.interrupted ? " interrupted" : " finished", " after ", duration_text(report.seconds),
                  ": ", std::to_string(report.run_now), " scenarios run"}));
  return report;
}

}  // namespace unbruised::studies
