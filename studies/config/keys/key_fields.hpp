#pragma once

/// @file
/// From a member to the field that a key writes: what the rows of the key tables are made of.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "studies/config/schema.hpp"

namespace unbruised::studies::key_rows {

template <typename T>
FieldRef field_ref(T& member) {
  if constexpr (std::is_enum_v<T>) {
    return ChoiceRef{&member, [](const void* object) { return static_cast<int>(*static_cast<const T*>(object)); },
                     [](void* object, int word) { *static_cast<T*>(object) = static_cast<T>(word); }};
  } else {
    return &member;
  }
}
template <std::size_t n>
FieldRef field_ref(std::array<double, n>& member) {
  return NumberSpan{member.data(), static_cast<int>(n)};
}
template <std::size_t n>
FieldRef field_ref(std::optional<std::array<double, n>>& member) {
  using Maybe = std::optional<std::array<double, n>>;
  return MaybeSpan{&member, static_cast<int>(n),
                   [](void* object) {
                     Maybe& maybe = *static_cast<Maybe*>(object);
                     return maybe ? maybe->data() : nullptr;
                   },
                   [](void* object, bool is_there) {
                     Maybe& maybe = *static_cast<Maybe*>(object);
                     maybe.reset();
                     if (is_there) maybe.emplace();
                   }};
}
template <std::size_t n>
FieldRef field_ref(std::array<int, n>& member) {
  return IntegerSpan{member.data(), static_cast<int>(n)};
}
inline FieldRef field_ref(std::array<bool, 3>& member) { return &member; }

template <auto member>
FieldRef lattice(Scenario& scenario, int /*index*/) {
  return field_ref(std::get<LatticeParameters>(scenario.product).*member);
}
template <auto member>
FieldRef layer(Scenario& scenario, int index) {
  return field_ref(std::get<LatticeParameters>(scenario.product).layer.at(static_cast<std::size_t>(index)).*
                   member);
}
template <auto member>
FieldRef particle(Scenario& scenario, int index) {
  return field_ref(std::get<NetworkParameters>(scenario.product).particle.at(static_cast<std::size_t>(index)).*
                   member);
}
template <auto member>
FieldRef spring(Scenario& scenario, int index) {
  return field_ref(std::get<NetworkParameters>(scenario.product).spring.at(static_cast<std::size_t>(index)).*
                   member);
}
template <auto member>
FieldRef load(Scenario& scenario, int index) {
  return field_ref(std::get<NetworkParameters>(scenario.product).load.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef parallel_jaw(Scenario& scenario, int /*index*/) {
  return field_ref(jaw_of(scenario).*member);
}
template <auto member>
FieldRef range(Scenario& scenario, int /*index*/) {
  return field_ref(jaw_of(scenario).range.*member);
}
template <auto member>
FieldRef pad(Scenario& scenario, int /*index*/) {
  return field_ref(jaw_of(scenario).pad.*member);
}
template <auto member>
FieldRef finger(Scenario& scenario, int index) {
  return field_ref(jaw_of(scenario).finger.at(static_cast<std::size_t>(index)).*member);
}
/// Its words are the kinds behind NoGripper, in the order of the variant.
inline FieldRef gripper_kind(Scenario& scenario, int /*index*/) {
  return ChoiceRef{&scenario.gripper,
                   [](const void* gripper) {
                     return static_cast<int>(static_cast<const GripperParameters*>(gripper)->index()) - 1;
                   },
                   [](void*, int) {}};  // the only kind is there already
}
template <auto member>
FieldRef cell(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.cell.*member);
}
template <auto member>
FieldRef surface(Scenario& scenario, int index) {
  return field_ref(scenario.cell.surface.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef sensor(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.sensor.*member);
}
template <auto member>
FieldRef robot(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.robot.*member);
}
template <auto member>
FieldRef arm_joint(Scenario& scenario, int index) {
  return field_ref(scenario.robot.joint.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef conveyor(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.cell.conveyor.*member);
}
template <auto member>
FieldRef strategy(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.strategy.*member);
}
template <auto member>
FieldRef waypoint(Scenario& scenario, int index) {
  return field_ref(scenario.strategy.waypoint.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef limits(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.limits.*member);
}
template <auto member>
FieldRef simulation(Scenario& scenario, int /*index*/) {
  return field_ref(scenario.simulation.*member);
}
inline FieldRef product_friction(Scenario& scenario, int /*index*/) {
  return std::visit([](auto& product) -> FieldRef { return &product.friction; }, scenario.product);
}
template <auto member>
FieldRef study(StudySettings& settings) {
  return field_ref(settings.*member);
}
template <auto member>
FieldRef window(StudySettings& settings) {
  return field_ref(settings.window.*member);
}
template <auto table, auto member>
FieldRef study_table(StudySettings& settings) {
  return field_ref(settings.*table.*member);
}
template <auto member>
FieldRef vary(VaryBlock& block) {
  return field_ref(block.*member);
}
template <auto member>
FieldRef variable(StudyBlocks& blocks, int index) {
  return field_ref(blocks.variable.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef parameter(StudyBlocks& blocks, int index) {
  return field_ref(blocks.parameter.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef specimen(StudyBlocks& blocks, int index) {
  return field_ref(blocks.specimen.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef random(StudyBlocks& blocks, int index) {
  return field_ref(blocks.random.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef correlation(StudyBlocks& blocks, int index) {
  return field_ref(blocks.correlation.at(static_cast<std::size_t>(index)).*member);
}
template <auto member>
FieldRef candidate(StudyBlocks& blocks, int index) {
  return field_ref(blocks.candidate.at(static_cast<std::size_t>(index)).*member);
}

}  // namespace unbruised::studies::key_rows
