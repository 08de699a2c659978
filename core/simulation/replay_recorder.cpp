#include "core/simulation/replay_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/body/rigid_motion.hpp"
#include "core/body/shape_mesh.hpp"
#include "core/scenario/attitude.hpp"
#include "core/scenario/vectors.hpp"
#include "core/simulation/replay_surfaces.hpp"

namespace unbruised {
namespace {

using Vector = std::array<double, 3>;

/// Of a time that is a whole number of intervals.
constexpr double kRounding = 1e-9;

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

void append(std::span<const double> values, std::vector<double>& to) {
  to.insert(to.end(), values.begin(), values.end());
}

std::array<double, 4> numbers_of(const Attitude& q) { return {q.w, q.axis[0], q.axis[1], q.axis[2]}; }

/// Mean over the cells around each particle.
std::vector<double> at_particles(const Lattice& lattice, std::span<const double> of_cell) {
  std::vector<double> sum(lattice.position_m.size()), count(lattice.position_m.size());
  for (std::size_t cell = 0; cell < lattice.cell.size(); ++cell) {
    for (const int corner : lattice.cell[cell]) {
      sum[static_cast<std::size_t>(corner)] += of_cell[cell];
      count[static_cast<std::size_t>(corner)] += 1.0;
    }
  }
  for (std::size_t p = 0; p < sum.size(); ++p) sum[p] /= std::max(count[p], 1.0);
  return sum;
}

/// Equivalent stress of one cell. @param u displacements, [3n] @param plastic strain of the cell, or empty
double von_mises_Pa(const BodyModel& body, std::size_t cell, std::span<const double> u,
                    std::span<const double> plastic) {
  const CellStiffness& matrices = body.cell[body.material_of(cell)];
  std::array<double, 6> strain{}, stress{};
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 24; ++j) {
      const auto particle = static_cast<std::size_t>(body.lattice->cell[cell][j / 3]);
      strain[i] += matrices.B[24 * i + j] * u[3 * particle + j % 3];
    }
    if (!plastic.empty()) strain[i] -= (i < 3 ? 1.0 : 2.0) * plastic[6 * cell + i];
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) stress[i] += matrices.D[6 * i + j] * strain[j];
  }
  const double xy = stress[0] - stress[1], yz = stress[1] - stress[2], zx = stress[2] - stress[0];
  const double shear = stress[3] * stress[3] + stress[4] * stress[4] + stress[5] * stress[5];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
}

}  // namespace

void ReplayRecorder::start(const LaneStep& loaded) {
  const BodyModel& body = loaded.view.model.body;
  replay_ = Replay{};
  std::vector<Vector> place_m;
  if (std::optional<ShapeMesh> mesh = shape_mesh(loaded.scenario.product)) {
    place_m = std::move(mesh->place_m);
    for (Vector& place : place_m) place = place + body.center_m();
    replay_.triangle = std::move(mesh->triangle);
    weights_ = VertexWeights(*body.lattice, place_m);
  } else {
    place_m = body.position_m;
    for (const SpringGeometry& spring : body.springs) replay_.line.push_back({spring.a, spring.b});
    weights_ = VertexWeights(place_m.size());
  }
  contacts_ = VertexContacts(loaded.view.model.contact, body, place_m);
  for (const Vector& place : place_m) replay_.vertex_m.push_back(place - body.center_of_mass_m);
  replay_.grip_m =
      body.center_m() + Vector{0.0, loaded.scenario.cell.grip_offset_m, loaded.scenario.cell.grip_height_m};
  replay_.surface = replay_surfaces(loaded.scenario);
  worst_strain_.fill(0.0);
  spread_strain_.fill(0.0);
  patch_strain_.assign(place_m.size(), 0.0F);
  record(loaded);
  frames_ = 1;
}

bool ReplayRecorder::observe(const LaneStep& step) {
  for (std::size_t s = 0; s < kSurfaceCount; ++s) {
    worst_strain_[s] = std::max(worst_strain_[s], step.seen.patch[s].plastic_strain);
  }
  const double passed = (step.before_s + step.time_s) / interval_s_ * (1.0 + kRounding);
  if (passed < static_cast<double>(frames_)) return true;
  record(step);
  frames_ = static_cast<std::int64_t>(passed) + 1;
  return true;
}

void ReplayRecorder::end(const LaneStep& last) {
  if (replay_.time_s.back() < last.before_s + last.time_s) record(last);
  record_permanent_set(last);
}

void ReplayRecorder::record(const LaneStep& step) {
  replay_.time_s.push_back(step.before_s + step.time_s);
  record_pose(step);
  record_carriers(step);
  record_forces(step);
  record_deformation(step);
  record_strain(step);
  record_pressure(step);
}

Vector ReplayRecorder::center_m(const LaneStep& step) const {
  const BodyModel& body = step.view.model.body;
  Vector center = body.center_of_mass_m;
  for (std::size_t i = 0; i < 3; ++i) center[i] += step.view.body.mass_u()[i][step.lane] / body.total_mass_kg;
  return center;
}

/// The attitude of a product that turns, of another one the small turn that fits it best.
void ReplayRecorder::record_pose(const LaneStep& step) {
  const BodyModel& body = step.view.model.body;
  const std::vector<double> moved_m = step.view.body.state(step.lane).displacement_m;
  Attitude attitude;
  if (const FrameLanes* frame = step.view.body.frame()) {
    const std::array<double, 4> q = frame->attitude().of_lane(step.lane);
    attitude = Attitude{q[0], {q[1], q[2], q[3]}};
  } else if (body.is_solid) {
    attitude = attitude_of(best_fit_rigid_motion(body.position_m, moved_m).rotation);
  }
  const Vector center = center_m(step);
  append(center, replay_.product_m);
  append(numbers_of(attitude), replay_.attitude);
  deformation_m_.resize(moved_m.size());
  shift_m_.resize(body.particle_count);
  for (std::size_t p = 0; p < body.particle_count; ++p) {
    shift_m_[p] = {moved_m[3 * p], moved_m[3 * p + 1], moved_m[3 * p + 2]};
    const Vector rest = body.position_m[p] - body.center_of_mass_m;
    const Vector there = turned(inverse(attitude), body.position_m[p] + shift_m_[p] - center) - rest;
    std::copy(there.begin(), there.end(), deformation_m_.begin() + static_cast<std::ptrdiff_t>(3 * p));
  }
}

void ReplayRecorder::record_carriers(const LaneStep& step) {
  const CarrierMotion& carriers = step.view.carriers;
  const int lane = step.lane;
  for (std::size_t i = 0; i < 3; ++i) {
    replay_.palm_m.push_back(carriers.palm[i].place_m[lane]);
    replay_.support_m.push_back(carriers.cell[i].place_m[lane]);
  }
  append(numbers_of(attitude_of(of_lane(carriers.palm_rotation_rad, lane))), replay_.palm_attitude);
  std::size_t listed = 0;
  for (const ReplaySurface& surface : replay_.surface) {
    if (surface.kind == ReplaySurface::Kind::pad) {
      replay_.finger_way_m.push_back(step.view.gripper.way(surface.finger)[lane]);
    } else if (surface.kind == ReplaySurface::Kind::listed) {
      Vector moved{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double way_m = carriers.listed[listed][axis].place_m[lane];
        for (std::size_t i = 0; i < 3; ++i) moved[i] += way_m * surface.axes[axis][i];
      }
      append(moved, replay_.listed_m);
      ++listed;
    }
  }
}

void ReplayRecorder::record_forces(const LaneStep& step) {
  const ContactModel& contact = step.view.model.contact;
  const BodyModel& body = step.view.model.body;
  const TraceRow row = step.view.trace_row(step.lane, step.scenario, step.time_s);
  std::array<std::array<double, 4>, kSurfaceCount> moment{};
  for (std::size_t c = 0; c < contact.candidate.size(); ++c) {
    const double pressed_N = step.view.contact.normal_N(c, step.lane);
    if (!(pressed_N > 0.0)) continue;
    const auto particle = static_cast<std::size_t>(contact.candidate[c].node);
    const Vector at = rest_place_m(contact, body, c) + shift_m_[particle];
    auto& sum = moment[static_cast<std::size_t>(contact.candidate[c].surface)];
    for (std::size_t i = 0; i < 3; ++i) sum[i] += pressed_N * at[i];
    sum[3] += pressed_N;
  }
  for (std::size_t s = 0; s < contact.surface.size(); ++s) {
    append(row.surface_force_N[s], replay_.force_N);
    const auto& sum = moment[static_cast<std::size_t>(contact.surface[s])];
    for (std::size_t i = 0; i < 3; ++i) replay_.force_place_m.push_back(sum[3] > 0.0 ? sum[i] / sum[3] : 0.0);
  }
  std::array<double, 6> wrench{};
  const Vector arm_m = center_m(step) - replay_.grip_m - row.palm_m;
  for (std::size_t f = 0; f < contact.finger_count(); ++f) {
    const Vector& force_N = row.surface_force_N[f];
    const Vector torque_N_m = row.surface_torque_N_m[f] + cross(arm_m, force_N);
    for (std::size_t i = 0; i < 3; ++i) {
      wrench[i] -= force_N[i];
      wrench[3 + i] -= torque_N_m[i];
    }
  }
  append(wrench, replay_.wrist_wrench);
}

void ReplayRecorder::record_deformation(const LaneStep& /*step*/) {
  for (std::size_t v = 0; v < weights_.vertex_count(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) {
      replay_.deformation_m.push_back(static_cast<float>(weights_.at(v, deformation_m_, 3, i)));
    }
  }
}

void ReplayRecorder::record_strain(const LaneStep& step) {
  const BodyModel& body = step.view.model.body;
  const std::size_t vertices = replay_.vertex_m.size();
  if (!body.lattice) {
    replay_.von_mises_Pa.insert(replay_.von_mises_Pa.end(), vertices, 0.0F);
    return;
  }
  const std::vector<double> plastic = step.view.material.cell_strain(step.lane);
  std::vector<double> stress(body.lattice->cell.size());
  for (std::size_t cell = 0; cell < stress.size(); ++cell) {
    stress[cell] = von_mises_Pa(body, cell, deformation_m_, plastic);
  }
  const std::vector<double> of_particle = at_particles(*body.lattice, stress);
  for (std::size_t v = 0; v < vertices; ++v) {
    replay_.von_mises_Pa.push_back(static_cast<float>(weights_.at(v, of_particle, 1, 0)));
  }
}

/// The pressure, and the plastic strain: below a patch it is spread as the pressure that made it.
void ReplayRecorder::record_pressure(const LaneStep& step) {
  const ContactModel& contact = step.view.model.contact;
  const BodyModel& body = step.view.model.body;
  std::vector<double> pressure(contact.candidate.size());
  for (std::size_t c = 0; c < pressure.size(); ++c) {
    const double area_m2 = contact.candidate[c].area_m2;
    pressure[c] = area_m2 > 0.0 ? step.view.contact.normal_N(c, step.lane) / area_m2 : 0.0;
  }
  const std::size_t vertices = replay_.vertex_m.size();
  std::vector<double> largest(vertices);
  for (const int surface : contact.surface) {
    std::vector<double> here(vertices);
    for (std::size_t v = 0; v < vertices; ++v) here[v] = contacts_.mean(v, surface, pressure);
    const double most = vertices == 0 ? 0.0 : *std::max_element(here.begin(), here.end());
    const auto s = static_cast<std::size_t>(surface);
    const double worst = worst_strain_[s] > spread_strain_[s] ? worst_strain_[s] : 0.0;
    if (most > 0.0) spread_strain_[s] = worst_strain_[s];
    for (std::size_t v = 0; v < vertices; ++v) {
      largest[v] = std::max(largest[v], here[v]);
      if (worst > 0.0 && most > 0.0) {
        patch_strain_[v] = std::max(patch_strain_[v], static_cast<float>(worst * here[v] / most));
      }
    }
  }
  const std::vector<double> accumulated = step.view.material.accumulated_cell_strain(step.lane);
  const std::vector<double> of_particle =
      accumulated.empty() ? std::vector<double>(body.particle_count) : at_particles(*body.lattice, accumulated);
  for (std::size_t v = 0; v < vertices; ++v) {
    replay_.pressure_Pa.push_back(static_cast<float>(largest[v]));
    replay_.plastic_strain.push_back(
        std::max(patch_strain_[v], static_cast<float>(weights_.at(v, of_particle, 1, 0))));
  }
}

void ReplayRecorder::record_permanent_set(const LaneStep& last) {
  const BodyModel& body = last.view.model.body;
  replay_.permanent_m.assign(3 * replay_.vertex_m.size(), 0.0);
  if (!(last.view.material.largest_plastic_strain()[last.lane] > 0.0) || !body.statics) return;
  std::vector<double> shape = body.statics->free_shape(last.view.material.plastic_load_N(last.lane));
  if (!body.is_anchored()) remove_rigid_motion(body.position_m, shape);
  for (std::size_t v = 0; v < weights_.vertex_count(); ++v) {
    for (std::size_t i = 0; i < 3; ++i) replay_.permanent_m[3 * v + i] = weights_.at(v, shape, 3, i);
  }
}

}  // namespace unbruised
