#include "core/scenario/factor_key.hpp"

#include <array>
#include <cstring>
#include <optional>

#include "core/scenario/body_modes.hpp"
#include "core/scenario/contact_set.hpp"
#include "core/scenario/fields.hpp"
#include "core/scenario/gripper.hpp"
#include "core/scenario/pad_face.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/product_frame.hpp"
#include "core/scenario/product_mesh.hpp"

namespace unbruised {
namespace {

/// Appends values as bytes; equal bytes mean equal keys.
class KeyWriter {
 public:
  template <class T>
  void operator()(const Field& field, const T& value) {
    if (field.decides == Decides::model) add(value);
  }
  void add(double value) {
    value += 0.0;  // -0 and 0 are the same
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    key_.append(bytes, sizeof value);
  }
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T value) { add(static_cast<double>(value)); }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value ? 1.0 : 0.0);
    add(value.value_or(T{}));
  }
  template <class T, std::size_t N>
  void add(const std::optional<std::array<T, N>>& values) {
    add(values ? 1.0 : 0.0);
    add(values.value_or(std::array<T, N>{}));
  }
  template <class T, std::size_t N>
  void add(const std::array<T, N>& values) {
    for (const T& value : values) add(value);
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add(value);
  }
  void add(const std::shared_ptr<const ProductMesh>& mesh) {
    const std::uint64_t hash = mesh ? mesh->source().hash : 0;
    add(static_cast<std::uint32_t>(hash >> 32));
    add(static_cast<std::uint32_t>(hash));
  }
  [[nodiscard]] std::string take() { return std::move(key_); }

 private:
  std::string key_;
};

/// Pads that are bodies have a factor of their own, and the compliance of their faces where the product stands
/// before them.
void add_pads(const Scenario& scenario, KeyWriter& key) {
  if (!has_lattice_pads(scenario)) return;
  const ParallelJawParameters& jaw = *parallel_jaw(scenario);
  key.add(jaw.pad_size_m);
  key.add(jaw.pad_thickness_m);
  key.add(jaw.pad_modulus_Pa);
  key.add(jaw.pad_poisson_ratio);
  key.add(jaw.pad_relaxation_time_s);
  key.add(jaw.pad.cell_size_m);
  key.add(jaw.pad.density_kg_m3);
  key.add(scenario.cell.grip_height_m);
  key.add(scenario.cell.grip_offset_m);
}

}  // namespace

std::string factor_key(const Scenario& scenario) {
  KeyWriter key;
  key.add(scenario.product.index());
  if (const auto* network = std::get_if<NetworkParameters>(&scenario.product)) {
    key.add(network->particle.size());
    key.add(network->spring.size());
  }
  if (const auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) key.add(lattice->layer.size());
  visit_parameters(scenario,
                   [&](std::string_view, int, const auto& parameters) { visit_fields(parameters, key); });
  key.add(product_frame(scenario));
  key.add(mode_count(scenario));
  const ContactSet set = contact_set(scenario);
  key.add(set);
  key.add(stands_on_its_bottom(scenario));
  // Every surface that the cell lists has candidates of its own, and so has the pad of every finger.
  if (set != ContactSet::pads_and_support) key.add(scenario.cell.surface.size());
  key.add(lists_fingers(scenario) ? finger_count(scenario) : 0);
  // Faces of shaped pads are met at places, flat ones by hat functions.
  if (has_shaped_pads(scenario)) key.add(1.0);
  add_pads(scenario, key);
  return key.take();
}

}  // namespace unbruised
