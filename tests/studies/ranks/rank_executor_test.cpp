#include "studies/ranks/rank_executor.hpp"

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "studies/execution/batch_runner.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/ranks/rank_service.hpp"
#include "studies/results/digest.hpp"
#include "tests/studies/execution/fake_simulator.hpp"
#include "tests/studies/ranks/memory_link.hpp"

namespace unbruised::studies {
namespace {

using testing::batch_of;
using testing::fake_result;
using testing::FakeSimulator;
using testing::MemoryLink;
using testing::MemoryPost;
using testing::scenario_of;

/// So many ranks, each a thread; the first is this one.
class Ranks {
 public:
  Ranks(int count, int threads) : post_(count) {
    for (int rank = 0; rank < count; ++rank) {
      links_.push_back(std::make_unique<MemoryLink>(post_, rank));
      simulators_.push_back(std::make_unique<FakeSimulator>());
    }
    for (std::size_t rank = 1; rank < links_.size(); ++rank) {
      others_.emplace_back(
          [this, rank, threads] { serve_first_rank(*links_[rank], *simulators_[rank], threads); });
    }
    first_ = std::make_unique<FirstRank>(*links_[0]);
    executor_ = std::make_unique<RankExecutor>(*first_, *simulators_[0], threads, [](std::size_t) {});
  }
  ~Ranks() { end(); }
  const Executor& executor() { return *executor_; }
  /// The models that each rank has built.
  std::vector<int> end() {
    executor_.reset();
    first_.reset();
    // Of one that was stopped nobody else ends them here.
    for (int rank = 1; rank < post_.size(); ++rank) post_.put(rank, {0, bytes_of(RankEnd{})});
    others_.clear();
    std::vector<int> built;
    for (const auto& simulator : simulators_) built.push_back(simulator->record.models_built);
    return built;
  }
  [[nodiscard]] bool all_left() const {
    return std::ranges::all_of(links_, [](const auto& link) { return link->left; });
  }

 private:
  MemoryPost post_;
  std::vector<std::unique_ptr<MemoryLink>> links_;
  std::vector<std::unique_ptr<FakeSimulator>> simulators_;
  std::unique_ptr<FirstRank> first_;
  std::unique_ptr<RankExecutor> executor_;
  std::vector<std::jthread> others_;
};

TEST(RankExecutor, GivesEachIdItsOwnResultWhateverTheRanksAndGroups) {
  for (const int count : {1, 2, 5}) {
    for (const std::uint64_t groups : {1U, 7U}) {
      Ranks ranks(count, 2);
      for (int order = 0; order < 2; ++order) {
        std::map<std::uint64_t, ScenarioResult> results;
        const BatchReport done = run_batch(ranks.executor(), batch_of(300, groups),
                                           [&](std::uint64_t id, const ScenarioResult& result) {
                                             EXPECT_TRUE(results.emplace(id, result).second) << id;
                                           });
        EXPECT_FALSE(done.stopped);
        EXPECT_EQ(done.group_count, groups);
        ASSERT_EQ(results.size(), 300U);
        for (const auto& [id, result] : results) {
          ASSERT_EQ(result_digest(result), result_digest(fake_result(scenario_of(id, groups)))) << id;
        }
      }
      ranks.end();
      EXPECT_TRUE(ranks.all_left());
    }
  }
}

TEST(RankExecutor, SharesGroupsOutSoThatFewModelsAreBuiltTwice) {
  Ranks ranks(2, 1);
  run_batch(ranks.executor(), batch_of(400, 8), [](std::uint64_t, const ScenarioResult&) {});
  const std::vector<int> built = ranks.end();
  EXPECT_GT(built[0], 0);
  EXPECT_GT(built[1], 0);
  EXPECT_LE(built[0] + built[1], 8 + 3) << "more than the last groups were built twice";
}

TEST(RankExecutor, StopsAndIsThenLeftToWhatStoppedIt) {
  Ranks ranks(3, 1);
  std::atomic<bool> stop = false;
  Batch batch = batch_of(100000, 3);
  batch.stop = &stop;
  std::atomic<std::size_t> came = 0;
  const BatchReport done = run_batch(ranks.executor(), batch, [&](std::uint64_t, const ScenarioResult&) {
    if (++came == 50) stop = true;
  });
  EXPECT_TRUE(done.stopped);
  EXPECT_LT(done.delivered, 100000U);
  // An order after it is none any more.
  EXPECT_TRUE(run_batch(ranks.executor(), batch, [](std::uint64_t, const ScenarioResult&) {}).stopped);
}

TEST(RankExecutor, HandsOnWhatTheSinkThrowsAndCarriesOutTheNextOrder) {
  Ranks ranks(2, 1);
  EXPECT_THROW(run_batch(ranks.executor(), batch_of(500, 2),
                         [](std::uint64_t id, const ScenarioResult&) {
                           if (id == 100) throw std::runtime_error("disk full");
                         }),
               std::runtime_error);
  std::size_t came = 0;
  const BatchReport done =
      run_batch(ranks.executor(), batch_of(100, 2), [&](std::uint64_t, const ScenarioResult&) { ++came; });
  EXPECT_FALSE(done.stopped);
  EXPECT_EQ(came, 100U);
  ranks.end();
  EXPECT_TRUE(ranks.all_left());
}

TEST(RankExecutor, RefusesRanksOfAnotherBuild) {
  MemoryPost post(2);
  MemoryLink first_link(post, 0), other(post, 1);
  other.send(0, bytes_of(RankHello{.build = "another build", .seats = 4}));
  const FakeSimulator simulator;
  FirstRank first(first_link);
  const RankExecutor executor(first, simulator, 1, [](std::size_t) {});
  ASSERT_TRUE(executor.refusal());
  EXPECT_NE(executor.refusal()->find("rank 1 runs another build (another build)"), std::string::npos)
      << *executor.refusal();
}

}  // namespace
}  // namespace unbruised::studies
