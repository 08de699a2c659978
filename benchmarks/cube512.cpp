/// @file
/// The whole pipeline on the fixed scene cube512: what comes out for five time steps, what each part of a step
/// costs, what instruments add to it, how many scenarios a core finishes per second, and what further
/// threads add.

#include <algorithm>
#include <barrier>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "benchmarks/cube512_scene.hpp"
#include "benchmarks/part_times.hpp"
#include "benchmarks/stopwatch.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr double kTimeSteps_s[] = {0.5e-3, 1e-3, 2e-3, 5e-3, 10e-3};
constexpr double kUsualTimeStep_s = 1e-3;
constexpr int kRepetitions = 3;
/// Between two laps of a part timer there is nothing but the call of `step` itself.
constexpr double kLargestTimerGap = 0.03;

/// One batch of lanes from loading to the last result.
struct BatchRun {
  double load_s = 0, step_s = 0;
  LaneSimulation::PartTimes part;
  std::vector<ScenarioResult> result;  ///< by lane

  [[nodiscard]] double total_s() const { return load_s + step_s; }
  [[nodiscard]] double parts_s() const { return benchmarks::total_s(part); }
};

BatchRun run_batch(const std::shared_ptr<const Model>& model, const std::vector<Scenario>& scene) {
  BatchRun run;
  run.result.resize(scene.size());
  LaneSimulation simulation(model);
  simulation.enable_timing();
  run.load_s = seconds_of([&] {
    for (int lane = 0; lane < lane_count(); ++lane) simulation.load(lane, scene[static_cast<std::size_t>(lane)]);
  });
  run.step_s = seconds_of([&] {
    while (simulation.busy_count() > 0) {
      simulation.step();
      for (const auto& [lane, result] : simulation.finished()) run.result[static_cast<std::size_t>(lane)] = result;
    }
  });
  run.part = simulation.part_times();
  return run;
}

/// The quickest of some runs: other processes only ever make one longer.
BatchRun best_batch(const std::shared_ptr<const Model>& model, const std::vector<Scenario>& scene) {
  BatchRun best = run_batch(model, scene);
  for (int i = 1; i < kRepetitions; ++i) {
    BatchRun next = run_batch(model, scene);
    if (next.total_s() < best.total_s()) best = std::move(next);
  }
  return best;
}

/// The fixed scene in every lane.
std::vector<Scenario> equal_lanes(double time_step_s) {
  return std::vector<Scenario>(static_cast<std::size_t>(lane_count()), cube512_scene(time_step_s));
}

/// Grip forces from 4 N to 6 N, as in a sweep: a step then takes the sweeps of its slowest lane.
std::vector<Scenario> spread_lanes(double time_step_s) {
  std::vector<Scenario> scene;
  for (int lane = 0; lane < lane_count(); ++lane) {
    const double part = static_cast<double>(lane) / (lane_count() - 1);
    scene.push_back(cube512_scene(time_step_s, (0.8 + 0.4 * part) * kCube512GripForce_N));
  }
  return scene;
}

bool same_bits(const ScenarioResult& a, const ScenarioResult& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return a.outcome == b.outcome &&
         std::equal(a.metrics.values().begin(), a.metrics.values().end(), b.metrics.values().begin(), same);
}

/// One row of the tables.
struct Row {
  double time_step_s;
  enum class Lanes { equal, spread } lanes;
  double build_s;
  std::shared_ptr<const Model> model;
  BatchRun run;

  [[nodiscard]] const char* grip() const { return lanes == Lanes::equal ? "5 N" : "4..6 N"; }
  [[nodiscard]] const ScenarioResult& first() const { return run.result.front(); }
  [[nodiscard]] double sweeps_per_step() const {
    double sweeps = 0.0;
    for (const ScenarioResult& r : run.result) sweeps += r.metrics[Metric::contact_iterations];
    return sweeps / static_cast<double>(run.part.lane_steps);
  }
};

std::shared_ptr<const Model> build_model(double time_step_s) {
  std::string error;
  auto model = Model::build(cube512_scene(time_step_s), error);
  if (!model) std::fprintf(stderr, "cube512 cannot be built: %s\n", error.c_str());
  return model;
}

std::vector<Row> measure_rows() {
  std::vector<Row> rows;
  for (const double dt : kTimeSteps_s) {
    std::shared_ptr<const Model> model;
    const double build_s = seconds_of([&] { model = build_model(dt); });
    if (!model) return {};
    rows.push_back({dt, Row::Lanes::equal, build_s, model, best_batch(model, equal_lanes(dt))});
    if (dt == kUsualTimeStep_s)
      rows.push_back({dt, Row::Lanes::spread, build_s, model, best_batch(model, spread_lanes(dt))});
  }
  return rows;
}

void print_scene(const Row& row) {
  std::printf(
      "cube512: 5 cm cube, 8 x 8 x 8 particles, E 100 kPa, 0.125 kg; gripped with 5 N, lifted 10 cm, held to 1 "
      "s.\n"
      "%zu particles, %zu freedoms, %zu candidate contacts, %zu entries in L; batches of %d lanes.\n",
      row.model->particle_count(), row.model->freedom_count(), row.model->contact_candidate_count(),
      row.model->factor_entry_count(), lane_count());
}

void print_outcomes(const std::vector<Row>& rows) {
  std::printf("\nWhat comes out (one lane of 5 N; expected: 1.0 mm, slip and drift 0)\n");
  std::printf("%7s %9s %13s %9s %11s %12s %13s %13s\n", "dt ms", "outcome", "compressed mm", "slip um",
              "peak force N", "drift um/s", "energy error", "impulse error");
  for (const Row& row : rows) {
    if (row.lanes != Row::Lanes::equal) continue;
    const Metrics& m = row.first().metrics;
    std::printf("%7.1f %9s %13.4f %9.4f %11.4f %12.6f %13.2e %13.2e\n", 1e3 * row.time_step_s,
                std::string(outcome_word(row.first().outcome)).c_str(), 1e3 * m[Metric::compression_max_m],
                1e6 * m[Metric::slip_max_m], m[Metric::peak_finger_force_N], 1e6 * m[Metric::hold_drift_m_s],
                m[Metric::energy_balance_error], m[Metric::impulse_balance_error]);
  }
}

void print_costs(const std::vector<Row>& rows) {
  std::printf("\nWhat it costs on one core (best of %d; microseconds per lane and step)\n", kRepetitions);
  std::printf("%7s %7s %8s %8s %8s %8s %8s %8s %11s %11s %12s %9s %8s\n", "dt ms", "lanes", "total", "rhs",
              "solve", "contact", "plastic", "update", "parts/total", "sweeps/step", "scenarios/s", "build ms",
              "load ms");
  for (const Row& row : rows) {
    const BatchRun& run = row.run;
    const double us = 1e6 / static_cast<double>(run.part.lane_steps);
    std::printf("%7.1f %7s %8.2f %8.2f %8.2f %8.2f %8.2f %8.2f %11.4f %11.2f %12.2f %9.1f %8.2f\n",
                1e3 * row.time_step_s, row.grip(), us * run.step_s, us * run.part.right_hand_side_s,
                us * run.part.solve_s, us * run.part.contact_s, us * run.part.plasticity_s, us * run.part.update_s,
                run.parts_s() / run.step_s, row.sweeps_per_step(), lane_count() / run.total_s(), 1e3 * row.build_s,
                1e3 * run.load_s);
  }
}

/// cube512 with fingers that a wrist sensor can carry, without and with instruments.
std::vector<std::pair<const char*, Scenario>> instrument_scenes() {
  Scenario plain = cube512_scene(kUsualTimeStep_s);
  jaw_of(plain).coupling = FingerCoupling::centric;
  Scenario wrist = plain;
  wrist.sensor.at = SensorMount::wrist;
  wrist.sensor.position_m = {0.0, 0.0, 0.1};
  wrist.sensor.mass_kg = 1.0;
  wrist.sensor.rate_Hz = 500.0;
  wrist.sensor.bandwidth_Hz = 100.0;
  wrist.sensor.noise_N = 0.01;
  Scenario ranges = wrist;
  jaw_of(ranges).range.maximum_m = 0.1;
  jaw_of(ranges).range.rate_Hz = 500.0;
  return {{"none", plain}, {"wrist sensor", wrist}, {"and two ranges", ranges}};
}

/// Microseconds per lane and step of each scene, by turns: the machine's moods meet all of them.
void compare_instruments(const std::shared_ptr<const Model>& model) {
  constexpr int kTurns = 8;
  const auto scenes = instrument_scenes();
  std::vector<double> sum_us(scenes.size()), least_us(scenes.size(), HUGE_VAL);
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const std::vector<Scenario> lanes(static_cast<std::size_t>(lane_count()), scenes[i].second);
      const BatchRun run = run_batch(model, lanes);
      const double us = 1e6 * run.step_s / static_cast<double>(run.part.lane_steps);
      sum_us[i] += us / kTurns;
      least_us[i] = std::min(least_us[i], us);
    }
  }
  std::printf(
      "\nWhat instruments add (dt %.1f ms, centric fingers; %d runs by turns, microseconds per lane and step)\n",
      1e3 * kUsualTimeStep_s, kTurns);
  std::printf("%16s %8s %8s %8s %8s\n", "instruments", "mean", "ratio", "least", "ratio");
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::printf("%16s %8.2f %8.3f %8.2f %8.3f\n", scenes[i].first, sum_us[i], sum_us[i] / sum_us[0], least_us[i],
                least_us[i] / least_us[0]);
  }
}

/// cube512 between pads of 2 cm silicone as layers and as bodies, whose cells match those of the cube or do not.
std::vector<std::pair<const char*, Scenario>> pad_scenes() {
  Scenario layers = cube512_scene(kUsualTimeStep_s);
  ParallelJawParameters& jaw = jaw_of(layers);
  jaw.pad_thickness_m = 0.02;
  Scenario bodies = layers;
  jaw_of(bodies).pad.kind = PadKind::lattice;
  jaw_of(bodies).pad_poisson_ratio = 0.45;
  jaw_of(bodies).pad_relaxation_time_s = 2e-3;
  jaw_of(bodies).pad.cell_size_m = 0.007;
  Scenario other = bodies;
  jaw_of(other).pad.cell_size_m = 0.0062;
  return {{"layers", layers}, {"7 x 7 x 3 cells", bodies}, {"8 x 8 x 3 cells", other}};
}

/// Microseconds per lane and step with each kind of pads, by turns. @return false where a cube is not held
bool compare_pads() {
  constexpr int kTurns = 4;
  const auto scenes = pad_scenes();
  std::printf("\nWhat pads that are bodies add (dt %.1f ms; %d runs by turns, microseconds per lane and step)\n",
              1e3 * kUsualTimeStep_s, kTurns);
  std::printf("%16s %8s %8s %8s %8s %8s %8s %8s %11s\n", "pads", "least", "ratio", "rhs", "solve", "contact",
              "update", "mean", "sweeps/step");
  std::vector<std::shared_ptr<const Model>> model;
  std::vector<BatchRun> best(scenes.size());
  std::vector<double> mean_us(scenes.size());
  for (const auto& [name, scene] : scenes) {
    std::string error;
    model.push_back(Model::build(scene, error));
    if (!model.back()) return false;
  }
  bool held = true;
  for (int turn = 0; turn < kTurns; ++turn) {
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      BatchRun run =
          run_batch(model[i], std::vector<Scenario>(static_cast<std::size_t>(lane_count()), scenes[i].second));
      mean_us[i] += 1e6 * run.step_s / static_cast<double>(run.part.lane_steps) / kTurns;
      held = held && run.result.front().outcome == Outcome::held;
      if (turn == 0 || run.step_s < best[i].step_s) best[i] = std::move(run);
    }
  }
  const double least_us = 1e6 * best[0].step_s / static_cast<double>(best[0].part.lane_steps);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const BatchRun& run = best[i];
    const double us = 1e6 / static_cast<double>(run.part.lane_steps);
    double sweeps = 0.0;
    for (const ScenarioResult& r : run.result) sweeps += r.metrics[Metric::contact_iterations];
    std::printf("%16s %8.2f %8.3f %8.2f %8.2f %8.2f %8.2f %8.2f %11.2f\n", scenes[i].first, us * run.step_s,
                us * run.step_s / least_us, us * run.part.right_hand_side_s, us * run.part.solve_s,
                us * run.part.contact_s, us * run.part.update_s, mean_us[i],
                sweeps / static_cast<double>(run.part.lane_steps));
  }
  return held;
}

/// `thread_count` threads with a batch each on one model.
struct ThreadedRun {
  double wall_s = 0;
  double processor_s = 0;  ///< of all threads; below thread_count x wall_s they waited for a core
  std::vector<BatchRun> batch;
};

ThreadedRun run_threads(const std::shared_ptr<const Model>& model, const std::vector<Scenario>& scene,
                        int thread_count) {
  ThreadedRun run;
  run.batch.resize(static_cast<std::size_t>(thread_count));
  std::barrier ready(thread_count + 1);
  std::vector<std::jthread> threads;
  for (BatchRun& batch : run.batch) {
    threads.emplace_back([&] {
      ready.arrive_and_wait();
      batch = run_batch(model, scene);
    });
  }
  ready.arrive_and_wait();
  const double start_s = benchmarks::processor_s();
  run.wall_s = seconds_of([&] { threads.clear(); });  // joins
  run.processor_s = benchmarks::processor_s() - start_s;
  return run;
}

/// @return false when a thread changed a bit.
bool compare_threads(const Row& row) {
  std::printf("\nThreads (a batch each on one shared model, dt %.1f ms, best of %d)\n", 1e3 * row.time_step_s,
              kRepetitions);
  std::printf("%7s %12s %9s %11s %10s   (this machine runs %u at a time)\n", "threads", "scenarios/s", "speed-up",
              "cores given", "same bits", std::thread::hardware_concurrency());
  const std::vector<Scenario> scene = equal_lanes(row.time_step_s);
  double one_thread = 0.0;
  bool all_same = true;
  // One, two, four ... and all that the machine runs at a time.
  const int most = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  for (int count = 1; count <= most; count = count < most ? std::min(2 * count, most) : most + 1) {
    double best_s = HUGE_VAL, cores = 0.0;
    bool same = true;
    for (int i = 0; i < kRepetitions; ++i) {
      const ThreadedRun run = run_threads(row.model, scene, count);
      if (run.wall_s < best_s) {
        best_s = run.wall_s;
        cores = run.processor_s / run.wall_s;
      }
      for (const BatchRun& batch : run.batch) {
        for (const ScenarioResult& r : batch.result) same = same && same_bits(r, row.first());
      }
    }
    const double scenarios_per_s = lane_count() * count / best_s;
    if (count == 1) one_thread = scenarios_per_s;
    std::printf("%7d %12.2f %9.2f %11.2f %10s\n", count, scenarios_per_s, scenarios_per_s / one_thread, cores,
                same ? "yes" : "NO");
    all_same = all_same && same;
  }
  return all_same;
}

/// Says on stderr what makes these numbers worthless. @return true when nothing does.
bool is_sound(const Row& row) {
  bool sound = true;
  const auto expect = [&](bool holds, const char* what) {
    if (!holds) std::fprintf(stderr, "dt %g s, lanes %s: %s\n", row.time_step_s, row.grip(), what);
    sound = sound && holds;
  };
  expect(std::abs(row.run.parts_s() / row.run.step_s - 1.0) < kLargestTimerGap,
         "the parts do not add up to the whole step");
  for (const ScenarioResult& r : row.run.result) {
    expect(r.outcome == Outcome::held, "a lane did not hold the cube");
    expect(std::isfinite(r.metrics[Metric::hold_drift_m_s]), "a lane has no drift");
  }
  return sound;
}

int run() {
  if (const auto violations = validate(cube512_scene(kUsualTimeStep_s)); !violations.empty()) {
    for (const Violation& v : violations) std::fprintf(stderr, "%s: %s\n", v.field.c_str(), v.rule.c_str());
    return EXIT_FAILURE;
  }
  const std::vector<Row> rows = measure_rows();
  if (rows.empty()) return EXIT_FAILURE;
  print_scene(rows.front());
  print_outcomes(rows);
  print_costs(rows);
  std::fflush(stdout);
  const auto usual =
      std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.time_step_s == kUsualTimeStep_s; });
  compare_instruments(usual->model);
  bool sound = compare_pads();
  if (!sound) std::fprintf(stderr, "a cube between pads that are bodies was not held\n");
  sound = compare_threads(*usual) && sound;
  for (const Row& row : rows) sound = is_sound(row) && sound;
  return sound ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace unbruised::benchmarks

/// With the word "pads" only what pads that are bodies add.
int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "pads") {
    return unbruised::benchmarks::compare_pads() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  return unbruised::benchmarks::run();
}
