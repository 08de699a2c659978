#include "core/material/material.hpp"

#include <algorithm>
#include <cmath>

#include "core/material/cell_plasticity.hpp"
#include "core/material/spring_plasticity.hpp"

namespace unbruised {
namespace {

/// Adds nothing to K and C.
class ElasticMaterial final : public Material {
 public:
  ElasticMaterial(std::size_t particle_count, std::optional<MeasuredElsewhere> measured)
      : particle_count_(particle_count), measured_(measured) {}

  void load(int lane, const Scenario&) override { clear_account(lane); }
  [[nodiscard]] const LaneArray* load_theta() const override { return nullptr; }
  void begin_step(const LaneArray&) override {}
  Mask update(const LaneArray&, const Mask& active) override {
    if (measured_) {
      largest_strain_ = select(active, measured_->largest_strain, largest_strain_);
      largest_cell_rotation_ = select(active, measured_->largest_cell_rotation, largest_cell_rotation_);
    }
    return Mask(false);
  }
  void end_step(const LaneArray&, const WilsonTheta&, const Mask&) override {}
  [[nodiscard]] double self_energy(int, const LaneArray&) const override { return 0.0; }
  [[nodiscard]] std::vector<double> plastic_load_N(int) const override {
    return std::vector<double>(3 * particle_count_, 0.0);
  }
  /// Of a solid that is watched: nothing flows within.
  [[nodiscard]] std::optional<double> volume_above_m3(int, double) const override {
    return measured_ ? std::optional(0.0) : std::nullopt;
  }

 private:
  std::size_t particle_count_;
  std::optional<MeasuredElsewhere> measured_;
};

}  // namespace

std::unique_ptr<Material> make_material(const BodyModel& body, const WilsonTheta& wilson, ProductFrame frame) {
  if (body.lattice) return std::make_unique<CellPlasticity>(body, wilson, frame);
  if (can_yield(body.springs) || can_relax(body.springs)) {
    return std::make_unique<SpringPlasticity>(body, wilson);
  }
  return make_elastic_material(body.particle_count);
}

std::unique_ptr<Material> make_elastic_material(std::size_t particle_count,
                                                std::optional<MeasuredElsewhere> measured) {
  return std::make_unique<ElasticMaterial>(particle_count, measured);
}

}  // namespace unbruised
