#include "studies/ranks/scenario_bytes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/scenario/fields.hpp"
#include "core/scenario/product_mesh.hpp"
#include "studies/results/bytes.hpp"

namespace unbruised::studies {
namespace {

/// No list of a scenario is longer (config/library.hpp).
constexpr std::uint64_t kLongestList = 1'000'000;

template <class T>
concept Word = std::is_enum_v<T>;

/// The same mesh for all scenarios that come here with its hash: to make it ready takes longer than to read it.
std::shared_ptr<const ProductMesh> one_for_all(TriangleMesh mesh, const MeshSource& source) {
  static std::mutex mutex;
  static std::map<std::uint64_t, std::weak_ptr<const ProductMesh>> known;
  const std::lock_guard lock(mutex);
  std::weak_ptr<const ProductMesh>& kept = known[source.hash];
  auto shared = kept.lock();
  if (!shared) {
    shared = std::make_shared<const ProductMesh>(std::move(mesh), source);
    kept = shared;
  }
  return shared;
}

class FieldWriter {
 public:
  template <class T>
  void operator()(const Field&, const T& value) {
    put(value);
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void put(T value) { out_.put(value); }
  template <Word T>
  void put(T value) {
    out_.put(static_cast<std::int64_t>(value));
  }
  template <class T>
  void put(const std::optional<T>& value) {
    out_.put(static_cast<std::uint8_t>(value.has_value()));
    if (value) put(*value);
  }
  template <class T, std::size_t N>
  void put(const std::array<T, N>& values) {
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put_size(values.size());
    for (const T& value : values) put(value);
  }
  void put(const std::shared_ptr<const ProductMesh>& mesh) {
    put(static_cast<std::uint8_t>(mesh != nullptr));
    if (!mesh) return;
    put(mesh->source().hash);
    put(mesh->given().place);
    put(mesh->given().triangle);
  }
  void put_size(std::size_t size) { out_.put(static_cast<std::uint64_t>(size)); }
  [[nodiscard]] const std::string& text() const { return out_.text(); }

 private:
  ByteWriter out_;
};

class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : in_(bytes) {}
  template <class T>
  void operator()(const Field&, T& value) {
    get(value);
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void get(T& value) { value = in_.get<T>(); }
  template <Word T>
  void get(T& value) {
    value = static_cast<T>(in_.get<std::int64_t>());
  }
  template <class T>
  void get(std::optional<T>& value) {
    value.reset();
    if (in_.get<std::uint8_t>() != 0) get(value.emplace());
  }
  template <class T, std::size_t N>
  void get(std::array<T, N>& values) {
    for (T& value : values) get(value);
  }
  template <class T>
  void get(std::vector<T>& values) {
    get_size(values);
    for (T& value : values) get(value);
  }
  void get(std::shared_ptr<const ProductMesh>& mesh) {
    mesh.reset();
    if (in_.get<std::uint8_t>() == 0) return;
    MeshSource source;
    TriangleMesh given;
    get(source.hash);
    get(given.place);
    get(given.triangle);
    const auto has = [&](int corner) {
      return corner >= 0 && static_cast<std::size_t>(corner) < given.place.size();
    };
    bool sound = in_.ok() && !given.triangle.empty() && given.triangle.size() <= kMostTriangles;
    for (const auto& triangle : given.triangle) sound = sound && std::ranges::all_of(triangle, has);
    sizes_sound_ = sizes_sound_ && sound;
    if (sizes_sound_) mesh = one_for_all(std::move(given), source);
  }
  template <class T>
  void get_size(std::vector<T>& values) {
    const auto size = in_.get<std::uint64_t>();
    values.assign(size <= kLongestList ? size : 0, T{});
    sizes_sound_ = sizes_sound_ && size <= kLongestList;
  }
  std::uint64_t get_index() { return in_.get<std::uint64_t>(); }
  [[nodiscard]] bool at_end() const { return sizes_sound_ && in_.at_end(); }

 private:
  ByteReader in_;
  bool sizes_sound_ = true;
};

/// Calls visit(list) for each list of structs, whose lengths have to be known before their fields are read.
template <class S, class Visit>
void visit_lists(S& scenario, Visit&& visit) {
  if (auto* lattice = std::get_if<LatticeParameters>(&scenario.product)) visit(lattice->layer);
  if (auto* network = std::get_if<NetworkParameters>(&scenario.product)) {
    visit(network->particle);
    visit(network->spring);
    visit(network->load);
  }
  if (auto* jaw = std::get_if<ParallelJawParameters>(&scenario.gripper)) visit(jaw->finger);
  visit(scenario.cell.surface);
  visit(scenario.strategy.waypoint);
  visit(scenario.robot.joint);
}

/// The alternative of a number; false where there is none.
template <class Variant, std::size_t I = 0>
bool choose(Variant& variant, std::uint64_t index) {
  if constexpr (I < std::variant_size_v<Variant>) {
    if (index != I) return choose<Variant, I + 1>(variant, index);
    variant.template emplace<I>();
    return true;
  } else {
    return false;
  }
}

}  // namespace

std::string scenario_bytes(const Scenario& scenario) {
  FieldWriter writer;
  writer.put_size(scenario.product.index());
  writer.put_size(scenario.gripper.index());
  visit_lists(scenario, [&](const auto& list) { writer.put_size(list.size()); });
  visit_parameters(scenario,
                   [&](std::string_view, int, const auto& parameters) { visit_fields(parameters, writer); });
  return writer.text();
}

std::optional<Scenario> scenario_of_bytes(std::string_view bytes) {
  Scenario scenario;
  FieldReader reader(bytes);
  if (!choose(scenario.product, reader.get_index()) || !choose(scenario.gripper, reader.get_index())) {
    return std::nullopt;
  }
  visit_lists(scenario, [&](auto& list) { reader.get_size(list); });
  visit_parameters(scenario, [&](std::string_view, int, auto& parameters) { visit_fields(parameters, reader); });
  return reader.at_end() ? std::optional(std::move(scenario)) : std::nullopt;
}

}  // namespace unbruised::studies
