#include "studies/ranks/scenario_bytes.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/scenario/factor_key.hpp"
#include "core/scenario/fields.hpp"
#include "studies/config/study.hpp"
#include "studies/ranks/rank_messages.hpp"
#include "studies/results/digest.hpp"
#include "tests/core/scenario/meshes.hpp"
#include "tests/places.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

const fs::path kConfigs = fs::path(UNBRUISED_SOURCE_DIR) / "configs";

/// The first scenario of every study that ships: lattices, networks, lists of all sorts.
std::vector<Scenario> shipped_scenarios() {
  std::vector<Scenario> scenarios;
  for (const auto& entry : fs::recursive_directory_iterator(kConfigs)) {
    if (entry.path().extension() != ".toml") continue;
    if (const StudyOrError read = read_study(entry.path(), {}, kConfigs)) scenarios.push_back(read->scenario(0));
  }
  return scenarios;
}

/// Counts the fields, so that a list that was left empty is seen.
struct FieldCount {
  std::size_t fields = 0;
  template <class T>
  void operator()(const Field&, const T&) {
    ++fields;
  }
};

std::size_t field_count(const Scenario& scenario) {
  FieldCount count;
  visit_parameters(scenario,
                   [&](std::string_view, int, const auto& parameters) { visit_fields(parameters, count); });
  return count.fields;
}

TEST(ScenarioBytes, GiveEveryScenarioThatShipsBackBitByBit) {
  const std::vector<Scenario> scenarios = shipped_scenarios();
  ASSERT_GT(scenarios.size(), 30U);
  std::size_t with_lists = 0;
  for (const Scenario& scenario : scenarios) {
    const std::string bytes = scenario_bytes(scenario);
    const auto back = scenario_of_bytes(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(scenario_bytes(*back), bytes);
    EXPECT_EQ(factor_key(*back), factor_key(scenario));
    EXPECT_EQ(field_count(*back), field_count(scenario));
    with_lists += !scenario.strategy.waypoint.empty() || !scenario.cell.surface.empty() ? 1 : 0;
  }
  EXPECT_GT(with_lists, 0U);
}

/// Sets every field to something else than its default, as far as its type says how.
struct Disturb {
  double next = 1.0;
  template <class T>
  void operator()(const Field&, T& value) {
    set(value);
  }
  void set(double& value) { value = next += 0.25; }
  void set(bool& value) { value = !value; }
  template <class T>
  requires std::is_integral_v<T>
  void set(T& value) { value = static_cast<T>(static_cast<int>(next) % 5 + 1); }
  template <class T>
  requires std::is_enum_v<T>
  void set(T& value) { value = static_cast<T>(1); }
  template <class T>
  void set(std::optional<T>& value) {
    set(value.emplace());
  }
  template <class T, std::size_t N>
  void set(std::array<T, N>& values) {
    for (T& value : values) set(value);
  }
  template <class T>
  void set(std::vector<T>& values) {
    values.resize(2);
    for (T& value : values) set(value);
  }
  void set(std::shared_ptr<const ProductMesh>& mesh) {
    mesh = testing::mesh_product(testing::cube_mesh(), {}, 7).mesh;
  }
};

/// Equal where all fields are.
struct Spelling {
  std::string text;
  template <class T>
  void operator()(const Field& field, const T& value) {
    text.append(field.name).append("=");
    add(value);
    text.append(";");
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { text += std::to_string(value); }
  template <class T>
  requires std::is_enum_v<T>
  void add(T value) { text += std::to_string(static_cast<int>(value)); }
  template <class T>
  void add(const std::optional<T>& value) {
    if (value) add(*value);
  }
  template <class T, std::size_t N>
  void add(const std::array<T, N>& values) {
    for (const T& value : values) add(value);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    text += std::to_string(values.size());
    for (const auto value : values) add(value);
  }
  void add(const std::shared_ptr<const ProductMesh>& mesh) {
    if (!mesh) return;
    text += std::to_string(mesh->source().hash);
    add(mesh->given().place);
    add(mesh->given().triangle);
  }
};

std::string spelling(const Scenario& scenario) {
  Spelling all;
  visit_parameters(scenario,
                   [&](std::string_view, int, const auto& parameters) { visit_fields(parameters, all); });
  return all.text;
}

TEST(ScenarioBytes, HaveEveryField) {
  Scenario scenario;
  scenario.gripper = ParallelJawParameters{};
  jaw_of(scenario).finger.resize(3);
  scenario.cell.surface.resize(2);
  scenario.strategy.waypoint.resize(4);
  Scenario network = scenario;
  network.product = NetworkParameters{};
  auto& parts = std::get<NetworkParameters>(network.product);
  parts.particle.resize(3);
  parts.spring.resize(2);
  parts.load.resize(1);
  for (Scenario* each : {&scenario, &network}) {
    Disturb disturb;
    visit_parameters(*each, [&](std::string_view, int, auto& parameters) { visit_fields(parameters, disturb); });
    const auto back = scenario_of_bytes(scenario_bytes(*each));
    ASSERT_TRUE(back);
    EXPECT_EQ(spelling(*back), spelling(*each));
  }
}

TEST(ScenarioBytes, ThatAreCutOrOfNothingAreRefused) {
  const std::string bytes = scenario_bytes(shipped_scenarios().front());
  for (const std::size_t length : {std::size_t{0}, std::size_t{3}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_FALSE(scenario_of_bytes(bytes.substr(0, length))) << length;
  }
  EXPECT_FALSE(scenario_of_bytes(bytes + "x"));
  EXPECT_FALSE(scenario_of_bytes(std::string(64, '\x7f')));
}

TEST(RankMessages, ComeBackAsTheyWere) {
  RankAnswer answer{.ticket = 7, .result = {}, .curve = {}};
  answer.result.outcome = Outcome::damaged;
  answer.result.cause = "a cause";
  answer.result.metrics[Metric::step_count] = 12.0;
  answer.curve.force_N = {1.0, 2.5};
  const RankWord back = word_of(bytes_of(answer));
  const auto& same = std::get<RankAnswer>(back);
  EXPECT_EQ(same.ticket, 7U);
  EXPECT_EQ(result_digest(same.result), result_digest(answer.result));
  EXPECT_EQ(same.result.cause, "a cause");
  EXPECT_EQ(same.curve.force_N, answer.curve.force_N);
  EXPECT_TRUE(same.curve.time_s.empty());
  EXPECT_EQ(std::get<RankHello>(word_of(bytes_of(RankHello{"build", 32}))).seats, 32U);
  EXPECT_EQ(std::get<RankOrder>(word_of(bytes_of(RankOrder{Curves::kept}))).curves, Curves::kept);
  EXPECT_TRUE(std::holds_alternative<RankEnd>(word_of(bytes_of(RankEnd{}))));
  EXPECT_ANY_THROW(word_of("\x03"));
  EXPECT_ANY_THROW(word_of("no message"));
}

}  // namespace
}  // namespace unbruised::studies
