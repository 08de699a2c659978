#include "studies/config/execution_error.hpp"

#include <string_view>

namespace unbruised::studies {
namespace {

constexpr std::string_view kRelative = "_relative_error";
constexpr std::string_view kAbsolute = "_error";

std::string without(const std::string& name, std::string_view ending) {
  return name.substr(0, name.size() - ending.size());
}

/// What such a name says; nothing where it is no name of an error.
std::optional<KeyError> error_named(const std::string& name) {
  if (name.ends_with(kRelative)) return KeyError{without(name, kRelative), ErrorKind::relative};
  if (name.ends_with(kAbsolute)) return KeyError{without(name, kAbsolute), ErrorKind::absolute};
  return std::nullopt;
}

}  // namespace

std::string error_name(const KeyError& error) {
  return error.key + std::string(error.kind == ErrorKind::relative ? kRelative : kAbsolute);
}

std::string key_behind(const std::string& name) {
  const auto error = error_named(name);
  return error ? error->key : name;
}

void apply_named(Scenario& scenario, const std::string& name, double value) {
  const auto error = error_named(name);
  const KeyAddress address = find_key(error ? error->key : name);
  const FieldRef field = address.spec->field(scenario, address.index);
  if (error) {
    const double aim = number_at(field, address.elements).value_or(0.0);
    value = error->kind == ErrorKind::relative ? aim * (1.0 + value) : aim + value;
  }
  assign_number(field, value, address.elements);
}

std::optional<ErrorKind> error_kind(const RandomBlock& block) {
  if (block.relative) return ErrorKind::relative;
  if (block.absolute) return ErrorKind::absolute;
  return std::nullopt;
}

Distribution error_distribution(const RandomBlock& block) {
  const double most = block.relative.value_or(block.absolute.value_or(0.0));
  Distribution error{.kind = block.distribution};
  if (block.distribution == DistributionKind::normal) {
    error.mean = 0.0;
    error.standard_deviation = 0.5 * most;
    error.at_least = -most;
    error.at_most = most;
  } else {
    error.from = -most;
    error.mode = 0.0;
    error.to = most;
  }
  return error;
}

}  // namespace unbruised::studies
