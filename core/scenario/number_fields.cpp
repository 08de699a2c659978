#include "core/scenario/number_fields.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/scenario/fields.hpp"

namespace unbruised {
namespace {

/// Is T a number, an optional one, or a list of numbers?
template <class T>
inline constexpr bool kIsNumber =
    std::is_same_v<T, double> || std::is_same_v<T, int> || std::is_same_v<T, std::optional<double>>;
template <class T, std::size_t N>
inline constexpr bool kIsNumber<std::array<T, N>> = kIsNumber<T>;
template <class T>
inline constexpr bool kIsNumber<std::vector<T>> = kIsNumber<T>;
template <class T, std::size_t N>
inline constexpr bool kIsNumber<std::optional<std::array<T, N>>> = kIsNumber<T>;

template <class T>
inline constexpr bool kIsOptionalList = false;
template <class T, std::size_t N>
inline constexpr bool kIsOptionalList<std::optional<std::array<T, N>>> = true;

template <typename T>
void visit_numbers(T& member, NumberPlace place, const NumberVisit& visit) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int> || std::is_same_v<T, std::optional<double>>) {
    visit(place, NumberSlot(&member));
  } else if constexpr (kIsOptionalList<T>) {
    if (member) visit_numbers(*member, place, visit);
  } else {
    for (std::size_t i = 0; i < member.size(); ++i) {
      NumberPlace at = place;
      (place.element < 0 ? at.element : at.component) = static_cast<int>(i);
      visit_numbers(member[i], at, visit);
    }
  }
}

template <class Variant, std::size_t... kind>
std::vector<Variant> one_of_each(std::index_sequence<kind...> /*kinds*/) {
  return {Variant(std::in_place_index<kind>)...};
}

/// Each kind of product or gripper, by default.
template <class Variant>
std::vector<Variant> one_of_each() {
  return one_of_each<Variant>(std::make_index_sequence<std::variant_size_v<Variant>>());
}

/// Scenarios that together have every struct of parameters.
std::vector<Scenario> specimens() {
  std::vector<Scenario> all;
  for (ProductParameters product : one_of_each<ProductParameters>()) {
    if (auto* lattice = std::get_if<LatticeParameters>(&product)) lattice->layer.resize(1);
    if (auto* network = std::get_if<NetworkParameters>(&product)) {
      network->particle.resize(1);
      network->spring.resize(1);
      network->load.resize(1);
    }
    for (const GripperParameters& gripper : one_of_each<GripperParameters>()) {
      Scenario& scenario = all.emplace_back();
      scenario.product = product;
      scenario.gripper = gripper;
      scenario.strategy.waypoint.resize(1);
      scenario.cell.surface.resize(1);
      scenario.robot.joint.resize(1);
      if (ParallelJawParameters* jaw = parallel_jaw(scenario)) jaw->finger.resize(1);
    }
  }
  return all;
}

std::optional<double> value_of(NumberSlot slot) {
  if (auto* const* number = std::get_if<double*>(&slot)) return **number;
  if (auto* const* integer = std::get_if<int*>(&slot)) return **integer;
  return *std::get<std::optional<double>*>(slot);
}

}  // namespace

void NumberField::each(Scenario& scenario, const NumberVisit& visit) const {
  visit_parameters(scenario, [&](std::string_view in, int index, auto& parameters) {
    if (in != std::string_view(path).substr(0, prefix_size)) return;
    visit_fields(parameters, [&](const Field& field, auto& member) {
      if constexpr (kIsNumber<std::remove_cvref_t<decltype(member)>>) {
        if (field.name == std::string_view(path).substr(prefix_size))
          visit_numbers(member, {.index = index}, visit);
      }
    });
  });
}

const std::vector<NumberField>& number_fields() {
  static const std::vector<NumberField> table = [] {
    std::vector<NumberField> product, gripper, rest;
    const auto add = [&](std::string_view prefix, int, auto& parameters) {
      visit_fields(parameters, [&](const Field& field, auto& member) {
        if constexpr (kIsNumber<std::remove_cvref_t<decltype(member)>>) {
          std::vector<NumberField>& part = prefix.starts_with("product.")   ? product
                                           : prefix.starts_with("gripper.") ? gripper
                                                                            : rest;
          NumberField number{std::string(prefix) + std::string(field.name), prefix.size(), field.range};
          const auto known = [&](const NumberField& other) { return other.path == number.path; };
          if (std::none_of(part.begin(), part.end(), known)) part.push_back(std::move(number));
        }
      });
    };
    for (Scenario scenario : specimens()) visit_parameters(scenario, add);
    for (const auto* part : {&gripper, &rest}) product.insert(product.end(), part->begin(), part->end());
    return product;
  }();
  return table;
}

const NumberField* find_number_field(std::string_view path) {
  const std::vector<NumberField>& all = number_fields();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const NumberField& field) { return field.path == path; });
  return found == all.end() ? nullptr : &*found;
}

std::string path_of(std::string_view pattern, const NumberPlace& place) {
  std::string path(pattern);
  const auto brackets = [](int number) { return "[" + std::to_string(number) + "]"; };
  if (const std::size_t at = path.find("[]"); at != std::string::npos && place.index >= 0) {
    path.replace(at, 2, brackets(place.index));
  }
  if (place.element >= 0) path += brackets(place.element);
  if (place.component >= 0) path += brackets(place.component);
  return path;
}

void for_each_number(const NumberField& field, const Scenario& scenario,
                     const std::function<void(const NumberPlace&, double)>& visit) {
  // The table hands out places to write to; here they are only read.
  field.each(const_cast<Scenario&>(scenario), [&](const NumberPlace& place, NumberSlot slot) {
    if (const auto value = value_of(slot)) visit(place, *value);
  });
}

std::optional<double> number_of(const NumberField& field, const Scenario& scenario) {
  std::optional<double> first;
  for_each_number(field, scenario, [&](const NumberPlace& /*place*/, double value) {
    if (!first) first = value;
  });
  return first;
}

}  // namespace unbruised
