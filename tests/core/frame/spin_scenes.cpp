#include "tests/core/frame/spin_scenes.hpp"

#include "core/simulation/model_parts.hpp"

namespace unbruised::testing {

Points points_of(const Scenario& scenario) {
  const auto model = build(scenario);
  const BodyModel& body = model->parts().body;
  Points points{body.mass_kg, {}};
  const Eigen::Map<const Eigen::Vector3d> center(body.center_of_mass_m.data());
  for (const auto& place : body.position_m) {
    points.X.emplace_back(Eigen::Map<const Eigen::Vector3d>(place.data()) - center);
  }
  return points;
}

SpinRow spin_row(const Trace& trace, const Points& points, std::size_t row) {
  const std::size_t n = points.X.size();
  const double* displacement = trace.displacement_m.data() + 3 * n * row;
  const double* velocity = trace.velocity_m_s.data() + 3 * n * row;
  const double* q = signal(trace, "attitude").values.data() + 4 * row;
  const double* spin = signal(trace, "spin_rad_s").values.data() + 3 * row;
  SpinRow out{Eigen::Quaterniond(q[0], q[1], q[2], q[3]), Eigen::Map<const Eigen::Vector3d>(spin),
              Eigen::Vector3d::Zero(), Eigen::Matrix3Xd(3, n), Eigen::Vector3d::Zero()};
  double total = 0.0;
  for (std::size_t p = 0; p < n; ++p) {
    total += points.mass_kg[p];
    out.center_motion_m += points.mass_kg[p] * Eigen::Map<const Eigen::Vector3d>(displacement + 3 * p);
  }
  out.center_motion_m /= total;
  for (std::size_t p = 0; p < n; ++p) {
    const Eigen::Vector3d y =
        points.X[p] + Eigen::Map<const Eigen::Vector3d>(displacement + 3 * p) - out.center_motion_m;
    out.momentum_kg_m2_s += points.mass_kg[p] * y.cross(Eigen::Map<const Eigen::Vector3d>(velocity + 3 * p));
    out.u.col(static_cast<Eigen::Index>(p)) = out.attitude.conjugate() * y - points.X[p];
  }
  return out;
}

}  // namespace unbruised::testing
