/// @file
/// How far the grip window of a ripe kiwi depends on the cell size: slow grips of a sphere between stiff plates,
/// against Hertz, and of the kiwi between the soft pads of the parallel jaw; then the window's two ends over whole
/// handling cycles. The tables of docs/validation.md.
///
///     benchmark_kiwi_mesh_study [FINEST]     cells across the waist, from 8 to FINEST (default 16)

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/scenario/opening.hpp"
#include "core/simulation/model_parts.hpp"
#include "core/simulation/simulation.hpp"

namespace unbruised::benchmarks {
namespace {

constexpr double kYield_Pa = 0.024e6;
constexpr double kRadius_m = 0.025;
constexpr double kGravity_m_s2 = 9.80665;
constexpr double kFriction = 0.6;
constexpr double kMass_kg = 0.095;
constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

/// configs/products/kiwi_ripe.toml and configs/grippers/parallel_jaw.toml.
Scenario kiwi(double cell_size_m) {
  Scenario scenario;
  LatticeParameters product;
  product.shape = Shape::ellipsoid;
  product.size_m = {2 * kRadius_m, 0.071, 2 * kRadius_m};
  product.cell_size_m = cell_size_m;
  product.mass_kg = kMass_kg;
  product.youngs_modulus_Pa = 0.288e6;
  product.poisson_ratio = 0.35;
  product.yield_stress_Pa = kYield_Pa;
  product.tangent_modulus_Pa = 0.08e6;
  product.loss_ratio = 0.2;
  product.at_frequency_Hz = 50.0;
  product.friction = kFriction;
  scenario.product = product;
  ParallelJawParameters gripper;
  gripper.pad_relaxation_time_s = 0.002;
  scenario.gripper = gripper;
  scenario.strategy.lift_acceleration_m_s2 = 2.0;
  scenario.simulation.time_step_s = 7.5e-4;
  return scenario;
}

/// A slow grip without a lift.
Scenario slow_grip(Scenario scenario) {
  scenario.cell.approach_gap_m = 5e-4;
  scenario.strategy.approach_speed_m_s = 0.02;
  scenario.strategy.contact_force_N = 0.1;
  scenario.strategy.grip_ramp_s = 0.2;
  scenario.strategy.settle_s = 1.0;
  scenario.simulation.time_step_s = 2e-3;
  scenario.simulation.duration_s = 0.35;
  scenario.simulation.trace_interval_s = 0.1;
  return scenario;
}

/// The kiwi's flesh as a sphere that floats between plates more than fifty times as stiff as itself.
Scenario sphere_between_plates(double cell_size_m) {
  Scenario scenario = slow_grip(kiwi(cell_size_m));
  std::get<LatticeParameters>(scenario.product).size_m[1] = 2 * kRadius_m;
  jaw_of(scenario).pad_modulus_Pa = 5e6;
  scenario.cell.gravity_m_s2 = {0.0, 0.0, 0.0};
  scenario.cell.support = false;
  return scenario;
}

struct Grip {
  double set_force_N = 0;  ///< of the drive
  double force_N = 0;      ///< largest of a finger
  ScenarioResult result;
  double lattice_ratio = 0;  ///< of the patch that the lattice's own contact forces span, at the end
  double final_force_N = 0;
  double approach_m = 0;  ///< of one plate, at the end
};

double last(const Trace& trace, const std::string& name, std::size_t width, std::size_t at) {
  for (const TraceSignal& signal : trace.signals) {
    if (signal.name == name) return signal.values[signal.values.size() - width + at];
  }
  return kNever;
}

/// Mean pressure of the left finger's patch over 1.07 Y, its area from the second moments of the contact forces.
void measure_lattice_patch(const Model& model, const Scenario& scenario, const Trace& trace, Grip& grip) {
  const ContactModel& contact = model.parts().contact;
  const double layer = jaw_of(scenario).pad_modulus_Pa / jaw_of(scenario).pad_thickness_m;
  const double way = last(trace, "finger_way_m", 2, 0);
  grip.final_force_N = last(trace, "finger_force_N", 6, 0);
  grip.approach_m = 0.5 * (way + last(trace, "finger_way_m", 2, 1)) - approach_gap_m(scenario);
  const double pad = contact.pole_m[0] - approach_gap_m(scenario) + way;
  const double* u = trace.displacement_m.data() + trace.displacement_m.size() - 3 * model.particle_count();
  double sum = 0, y = 0, z = 0, yy = 0, zz = 0, yz = 0;
  for (const ContactCandidate& c : contact.candidate) {
    if (c.surface != 0) continue;
    const double penetration = pad - c.surface_m - u[3 * c.node];
    for (int q = 0; q < kReliefPlaces; ++q) {
      const double depth = penetration - c.relief_m[static_cast<std::size_t>(q)];
      if (depth <= 0.0) continue;
      const double force = normal_stiffness_N_m(c, layer) / kReliefPlaces * depth;
      const auto offset = place_offset_m(c, q);
      const double at_y = c.tributary[0].place_m + offset[0] - contact.patch_form[0].middle_m[0];
      const double at_z = c.tributary[1].place_m + offset[1] - contact.patch_form[0].middle_m[1];
      sum += force;
      y += force * at_y;
      z += force * at_z;
      yy += force * at_y * at_y;
      zz += force * at_z * at_z;
      yz += force * at_y * at_z;
    }
  }
  if (sum <= 0.0) return;
  const double a = yy / sum - y * y / (sum * sum), b = zz / sum - z * z / (sum * sum);
  const double c = yz / sum - y * z / (sum * sum);
  const PatchForm& form = contact.patch_form[0];
  grip.lattice_ratio = sum / (form.area_factor * std::sqrt(a * b - c * c) * form.yield_factor * kYield_Pa);
}

/// One lane per grip force, from `low` to `high` in equal ratios.
std::vector<Grip> run_grips(const std::shared_ptr<const Model>& model, Scenario scenario, double low_N,
                            double high_N, bool with_trace) {
  const auto lanes = static_cast<std::size_t>(lane_count());
  std::vector<Grip> grips(lanes);
  std::vector<Trace> traces(lanes);
  LaneSimulation simulation(model);
  for (std::size_t i = 0; i < lanes; ++i) {
    scenario.strategy.grip_force_N =
        low_N * std::pow(high_N / low_N, static_cast<double>(i) / static_cast<double>(lanes - 1));
    grips[i].set_force_N = scenario.strategy.grip_force_N;
    simulation.load(static_cast<int>(i), scenario);
    if (with_trace) simulation.record(static_cast<int>(i), &traces[i]);
  }
  while (simulation.busy_count() > 0) {
    simulation.step();
    for (const auto& finished : simulation.finished()) {
      grips[static_cast<std::size_t>(finished.lane)].result = finished.result;
    }
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    grips[i].force_N = grips[i].result.metrics[Metric::peak_finger_force_N];
    if (with_trace) measure_lattice_patch(*model, scenario, traces[i], grips[i]);
  }
  return grips;
}

/// Force at which `value(grip)` first passes `level`, linear between neighbours; NaN: nowhere.
template <class Force, class Value>
double crossing(const std::vector<Grip>& grips, double level, Force force, Value value) {
  for (std::size_t i = 1; i < grips.size(); ++i) {
    const double before = value(grips[i - 1]), after = value(grips[i]);
    if (before <= level && after > level) {
      const double share = (level - before) / (after - before);
      return force(grips[i - 1]) + share * (force(grips[i]) - force(grips[i - 1]));
    }
  }
  return kNever;
}

double crossing(const std::vector<Grip>& grips, Metric metric, double level) {
  return crossing(
      grips, level, [](const Grip& g) { return g.force_N; },
      [metric](const Grip& g) { return g.result.metrics[metric]; });
}

/// Force at which the first cell flows: its bracket by the first 16 forces, then 16 forces inside.
double first_plastic_force_N(const std::shared_ptr<const Model>& model, const Scenario& scenario,
                             const std::vector<Grip>& grips) {
  const auto flows = [](const Grip& g) { return g.result.metrics[Metric::plastic_strain_max] > 0.0; };
  for (std::size_t i = 1; i < grips.size(); ++i) {
    if (flows(grips[i - 1]) || !flows(grips[i])) continue;
    const std::vector<Grip> fine =
        run_grips(model, scenario, 0.97 * grips[i - 1].force_N, grips[i].force_N, false);
    for (std::size_t k = 1; k < fine.size(); ++k) {
      if (flows(fine[k])) return 0.5 * (fine[k - 1].force_N + fine[k].force_N);
    }
  }
  return kNever;
}

double hertz_force_N(double approach_m, double layer_N_m3) {
  // The layer gives F / (pi a^2 k) on average besides; a few per cent here.
  const double plane = 0.288e6 / (1.0 - 0.35 * 0.35);
  double body = approach_m, force = 0;
  for (int i = 0; i < 50; ++i) {
    force = 4.0 / 3.0 * plane * std::sqrt(kRadius_m) * std::pow(body, 1.5);
    body = approach_m - force / (3.14159265358979 * kRadius_m * body * layer_N_m3);
  }
  return force;
}

/// First yield by the elastic patch alone: F = 1.07 Y A(F).
double elastic_yield_force_N(const PatchForm& form, double layer_N_m3) {
  double low = 0.01, high = 1000.0;
  for (int i = 0; i < 100; ++i) {
    const double force = 0.5 * (low + high);
    const double area = form.area.ellipse_m2(force, layer_N_m3);
    (force < form.yield_factor * kYield_Pa * area ? low : high) = force;
  }
  return low;
}

const char* place(int cells) { return cells % 2 == 0 ? "node" : "cell"; }

std::shared_ptr<const Model> build(const Scenario& scenario) {
  std::string error;
  auto model = Model::build(scenario, error);
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error.c_str());
    std::exit(1);
  }
  return model;
}

/// The rows of one body: forces at which each measure says "first mark".
void print_rows(bool sphere, int finest) {
  std::printf("%s\n", sphere ? "sphere, R = 25 mm, between plates of 5 MPa / 3 mm"
                             : "kiwi, 50 x 71 x 50 mm, between pads of 0.4 MPa / 3 mm");
  std::printf("%4s %8s %9s %9s %9s %9s %9s %9s %10s %7s\n", "n", "cell mm", "pole y,z", "ratio N", "moments N",
              "1st cell", "1 % strain", "F/Hz .5mm", "F/Hz 1 mm", "time s");
  for (int n = 8; n <= finest; ++n) {
    const auto start = std::chrono::steady_clock::now();
    const Scenario scenario =
        sphere ? sphere_between_plates(2 * kRadius_m / n) : slow_grip(kiwi(2 * kRadius_m / n));
    const auto model = build(scenario);
    const double layer = jaw_of(scenario).pad_modulus_Pa / jaw_of(scenario).pad_thickness_m;
    const std::vector<Grip> grips = run_grips(model, scenario, 0.4, 20.0, true);
    const auto final_force = [](const Grip& g) { return g.final_force_N; };
    const auto over_hertz = [&](double approach_m) {
      return crossing(grips, approach_m, final_force, [](const Grip& g) { return g.approach_m; }) /
             hertz_force_N(approach_m, layer);
    };
    const auto counts = lattice_cell_count(std::get<LatticeParameters>(scenario.product));
    std::printf("%4d %8.2f %4s,%4s %9.2f %9.2f %9.2f %9.2f ", n, 2e3 * kRadius_m / n, place(counts[1]),
                place(counts[2]), crossing(grips, Metric::contact_yield_ratio_max, 1.0),
                crossing(grips, 1.0, final_force, [](const Grip& g) { return g.lattice_ratio; }),
                first_plastic_force_N(model, scenario, grips), crossing(grips, Metric::plastic_strain_max, 0.01));
    if (sphere) {
      std::printf("%9.3f %10.3f", over_hertz(0.5e-3), over_hertz(1e-3));
    } else {
      std::printf("%9s %10s", "", "");
    }
    std::printf(" %7.1f\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    std::fflush(stdout);
  }
  const Scenario scenario = sphere ? sphere_between_plates(0.005) : kiwi(0.005);
  const auto model = build(scenario);
  const PatchForm& form = model->parts().contact.patch_form[0];
  std::printf("elastic patch: first yield at %.2f N on a rigid plate, %.2f N on this layer\n\n",
              elastic_yield_force_N(form, 1e30),
              elastic_yield_force_N(form, jaw_of(scenario).pad_modulus_Pa / jaw_of(scenario).pad_thickness_m));
}

/// The window's ends of whole handling cycles.
void print_cycles() {
  const double expected = kMass_kg * (kGravity_m_s2 + 2.0) / (2.0 * kFriction);
  std::printf("whole cycles, approach at 50 mm/s, lift at 2 m/s2: least force held; m(g + a)/(2 mu) = %.3f N\n",
              expected);
  std::printf("%8s %9s %14s\n", "cell mm", "held N", "ratio 1 at N");
  for (const int n : {8, 10, 12}) {
    const Scenario scenario = kiwi(2 * kRadius_m / n);
    const auto model = build(scenario);
    double held = kNever;
    for (const Grip& grip : run_grips(model, scenario, 0.9 * expected, 1.1 * expected, false)) {
      if (grip.result.outcome == Outcome::held && !(held <= grip.set_force_N)) held = grip.set_force_N;
    }
    const std::vector<Grip> hard = run_grips(model, scenario, 4.0, 8.0, false);
    std::printf("%8.2f %9.3f %14.3f\n", 2e3 * kRadius_m / n, held,
                crossing(
                    hard, 1.0, [](const Grip& g) { return g.set_force_N; },
                    [](const Grip& g) { return g.result.metrics[Metric::contact_yield_ratio_max]; }));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace unbruised::benchmarks

int main(int argc, char** argv) {
  using namespace unbruised::benchmarks;
  const int finest = argc > 1 ? std::atoi(argv[1]) : 16;
  print_rows(true, finest);
  print_rows(false, finest);
  print_cycles();
  return 0;
}
