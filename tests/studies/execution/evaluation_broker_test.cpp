/// @file
/// The broker alone, over an executor that is a formula: what it remembers, what it writes down before it answers,
/// and that a slow journal keeps nobody waiting who has something else to do.

#include "studies/execution/evaluation_broker.hpp"

#include <algorithm>
#include <atomic>
#include <latch>
#include <mutex>
#include <set>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/studies/execution/fake_executor.hpp"

namespace unbruised::studies {
namespace {

using testing::FakeExecutor;
using testing::force_formula;

BrokerQuestion question(const SearchPlace& place, double force_N) {
  BrokerQuestion asked{.place = place, .scenario = {}, .inputs = {force_N}};
  asked.scenario.strategy.grip_force_N = force_N;
  return asked;
}

/// The rows that were written down.
class Journal {
 public:
  void write(const ScenarioRow& row) {
    const std::lock_guard lock(mutex_);
    EXPECT_TRUE(ids_.insert(row.id).second) << "row " << row.id << " is written twice";
    rows_.push_back(row);
  }
  [[nodiscard]] bool holds(const SearchPlace& place) {
    const std::lock_guard lock(mutex_);
    return ids_.contains(journal_id(place));
  }
  [[nodiscard]] const std::vector<ScenarioRow>& rows() const { return rows_; }

 private:
  std::mutex mutex_;
  std::set<std::uint64_t> ids_;
  std::vector<ScenarioRow> rows_;
};

const std::vector<ScenarioRow> kNothing;

TEST(EvaluationBroker, AnswersInTheOrderOfTheQuestionsWhateverTheExecutorDoesFirst) {
  const FakeExecutor executor(force_formula);
  Journal journal;
  EvaluationBroker broker(executor, kNothing, [&](const ScenarioRow& row) { journal.write(row); }, {});
  broker.run({[&] {
    std::vector<BrokerQuestion> questions;
    for (std::uint64_t i = 0; i < 50; ++i) questions.push_back(question({0, 0, i}, 1.0 + static_cast<double>(i)));
    const auto answers = broker.ask(questions);
    ASSERT_TRUE(answers);
    for (std::size_t i = 0; i < answers->size(); ++i) {
      EXPECT_EQ((*answers)[i].metrics[Metric::peak_finger_force_N], 1.0 + static_cast<double>(i));
    }
  }});
  EXPECT_EQ(executor.runs, 50);
  EXPECT_EQ(journal.rows().size(), 50U);
}

TEST(EvaluationBroker, RunsAQuestionOnceHoweverOftenItIsAskedAndWritesEveryOneDown) {
  const FakeExecutor executor(force_formula);
  Journal journal;
  EvaluationBroker broker(executor, kNothing, [&](const ScenarioRow& row) { journal.write(row); }, {});
  std::vector<std::function<void()>> searches;
  for (std::uint64_t search = 0; search < 8; ++search) {
    searches.emplace_back([&broker, search] {
      for (std::uint64_t generation = 0; generation < 3; ++generation) {
        EXPECT_TRUE(broker.ask({question({search, generation, 0}, 2.0)}));
      }
    });
  }
  broker.run(searches);
  EXPECT_EQ(executor.runs, 1);
  EXPECT_EQ(journal.rows().size(), 24U);
  EXPECT_EQ(broker.counts().questions, 24U);
  EXPECT_EQ(broker.counts().from_memory, 23U);
}

TEST(EvaluationBroker, HandsAnAnswerOutOnlyWhenItsRowIsWrittenDown) {
  const FakeExecutor executor(force_formula);
  Journal journal;
  EvaluationBroker broker(executor, kNothing, [&](const ScenarioRow& row) { journal.write(row); }, {});
  std::vector<std::function<void()>> searches;
  for (std::uint64_t search = 0; search < 8; ++search) {
    searches.emplace_back([&, search] {
      for (std::uint64_t generation = 0; generation < 50; ++generation) {
        const SearchPlace place{search, generation, 0};
        // Some were asked before by another search: their copies are rows of their own.
        ASSERT_TRUE(broker.ask({question(place, static_cast<double>(generation % 20))}));
        EXPECT_TRUE(journal.holds(place));
      }
    });
  }
  broker.run(searches);
}

/// While the first row is being written, another search asks, its scenario is run, and counts can be taken. With
/// the writing under the broker's mutex nothing of this would happen before the row is on the disk, and this test
/// would never end.
TEST(EvaluationBroker, GoesOnWhileASlowJournalWrites) {
  std::latch writing(1);
  std::latch other_ran(1);
  const FakeExecutor executor([&](const Scenario& scenario) {
    if (scenario.strategy.grip_force_N == 2.0) other_ran.count_down();
    return force_formula(scenario);
  });
  std::atomic<bool> is_first = true;
  EvaluationBroker broker(executor, kNothing,
                          [&](const ScenarioRow&) {
                            if (!is_first.exchange(false)) return;
                            writing.count_down();
                            other_ran.wait();
                          },
                          {});
  broker.run({[&] {
                EXPECT_TRUE(broker.ask({question({0, 0, 0}, 1.0)}));
              },
              [&] {
                writing.wait();
                EXPECT_EQ(broker.counts().simulated, 1U);
                EXPECT_TRUE(broker.ask({question({1, 0, 0}, 2.0)}));
              }});
}

TEST(EvaluationBroker, AnswersFromTheJournalOfAnInterruptedRunWithoutWritingAgain) {
  const FakeExecutor executor(force_formula);
  ScenarioRow recorded{.id = journal_id({0, 0, 0}), .result = {}, .inputs = {3.0}};
  recorded.result.outcome = Outcome::slipped;
  const std::vector<ScenarioRow> rows = {recorded};
  Journal journal;
  EvaluationBroker broker(executor, rows, [&](const ScenarioRow& row) { journal.write(row); }, {});
  broker.run({[&] {
    const auto known = broker.ask({question({0, 0, 0}, 3.0)});
    EXPECT_EQ(known.value().front().outcome, Outcome::slipped);
    // At another place: a row of its own, from memory.
    EXPECT_EQ(broker.ask({question({0, 1, 0}, 3.0)}).value().front().outcome, Outcome::slipped);
  }});
  EXPECT_EQ(executor.runs, 0);
  ASSERT_EQ(journal.rows().size(), 1U);
  EXPECT_EQ(journal.rows().front().id, journal_id({0, 1, 0}));
}

TEST(EvaluationBroker, RefusesARecordOfOtherInputs) {
  const FakeExecutor executor(force_formula);
  const std::vector<ScenarioRow> rows = {{.id = journal_id({0, 0, 0}), .result = {}, .inputs = {3.0}}};
  EvaluationBroker broker(executor, rows, [](const ScenarioRow&) {}, {});
  EXPECT_THROW(broker.run({[&] {
    (void)broker.ask({question({0, 0, 0}, 4.0)});
  }}),
               EvaluationBroker::ForeignRecord);
}

TEST(EvaluationBroker, EndsAllSearchesWhenTheJournalFails) {
  const FakeExecutor executor(force_formula);
  EvaluationBroker broker(executor, kNothing,
                          [](const ScenarioRow& row) {
                            if (search_place(row.id).generation == 3) throw std::runtime_error("disk full");
                          },
                          {});
  std::atomic<int> told_so = 0;
  std::vector<std::function<void()>> searches;
  for (std::uint64_t search = 0; search < 4; ++search) {
    searches.emplace_back([&, search] {
      for (std::uint64_t generation = 0; generation < 100; ++generation) {
        if (broker.ask({question({search, generation, 0}, static_cast<double>(100 * search + generation))}))
          continue;
        ++told_so;
        return;
      }
    });
  }
  EXPECT_THROW(broker.run(searches), std::runtime_error);
  EXPECT_EQ(told_so, 4);
}

TEST(EvaluationBroker, TellsSearchesThatTheStudyIsBeingStopped) {
  std::atomic<bool> stop = false;
  const FakeExecutor executor([&stop](const Scenario& scenario) {
    stop = scenario.strategy.grip_force_N == 5.0;
    return force_formula(scenario);
  });
  Journal journal;
  EvaluationBroker broker(executor, kNothing, [&](const ScenarioRow& row) { journal.write(row); },
                          {.stop = &stop});
  std::uint64_t answered = 0;
  broker.run({[&] {
    while (broker.ask({question({0, answered, 0}, static_cast<double>(answered))})) ++answered;
  }});
  // What was run when the stop came is written down, whether its search still heard of it or not.
  EXPECT_GE(journal.rows().size(), 6U);
  EXPECT_GE(answered, 5U);
  EXPECT_LE(answered, 6U);
}

TEST(EvaluationBroker, RemembersFromOneStageToTheNext) {
  const FakeExecutor executor(force_formula);
  EvaluationBroker broker(executor, kNothing, [](const ScenarioRow&) {}, {.concurrent_searches = 1});
  for (std::uint64_t stage = 0; stage < 3; ++stage) {
    broker.run({[&] { EXPECT_TRUE(broker.ask({question({stage, 0, 0}, 1.0)})); }});
  }
  broker.run({});
  EXPECT_EQ(executor.runs, 1);
}

}  // namespace
}  // namespace unbruised::studies
