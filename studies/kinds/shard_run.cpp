#include "studies/kinds/shard_run.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <numeric>
#include <utility>

#include "studies/kinds/kind_table.hpp"
#include "studies/kinds/run_journal.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

std::optional<Shard> shard_of(std::string_view text) {
  const auto whole = [](std::string_view digits) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} && end == digits.data() + digits.size() ? value : 0;
  };
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const Shard shard{whole(text.substr(0, slash)), whole(text.substr(slash + 1))};
  return shard.number >= 1 && shard.number <= shard.count ? std::optional(shard) : std::nullopt;
}

std::vector<std::uint64_t> shard_ids(const ScenarioSet& set, const Shard& shard) {
  const std::vector<std::size_t> group_of = factor_groups(set);
  // Where the next scenario of each group stands among all, ordered by group and id.
  std::vector<std::size_t> place_in;
  for (const std::size_t group : group_of) {
    if (group >= place_in.size()) place_in.resize(group + 1);
    ++place_in[group];
  }
  std::exclusive_scan(place_in.begin(), place_in.end(), place_in.begin(), std::size_t{0});
  // Without overflow for any count of parts.
  const auto begin_of = [&](std::uint64_t part) {
    return set.count / shard.count * part + set.count % shard.count * part / shard.count;
  };
  const std::uint64_t begin = begin_of(shard.number - 1), end = begin_of(shard.number);
  std::vector<std::uint64_t> ids;
  for (std::uint64_t id = 0; id < set.count; ++id) {
    const std::size_t place = place_in[group_of[id]]++;
    if (place >= begin && place < end) ids.push_back(id);
  }
  return ids;
}

Expected<std::vector<std::uint64_t>> missing_ids(const Study& study, RunDirectory& run) {
  try {
    return parts_of(study.kind())->missing(study, RunJournal(run, nullptr));
  } catch (const JournalFailure& failure) {
    return failure.error;
  }
}

std::string units_of(const Study& study, std::size_t count) {
  return joined({with_thousands(count), " ", parts_of(study.kind())->unit, count == 1 ? "" : "s"});
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
  const std::vector<std::uint64_t> part = shard_ids(scenario_set(study), shard);
  RunJournal journal(run, progress);
  ShardReport report{.count = part.size()};
  try {
    const KindInput input{.study = study, .executor = executor, .journal = journal, .stop = stop};
    report.interrupted = !parts_of(study.kind())->run(input, part);
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
