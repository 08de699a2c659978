#pragma once

/// @file
/// The box that is searched: variables with names, units and bounds, and their map onto the unit cube.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace unbruised::optimizer {

enum class Scale { linear, log };

/// One decision variable.
struct Variable {
  std::string name;
  std::string units;
  /// < upper, with a finite range; > 0 on a log scale, with a finite ratio
  double lower = 0.0;
  double upper = 1.0;
  Scale scale = Scale::linear;
};

/// A box of variables. The algorithms work on the unit cube: 0 is `lower`, 1 is `upper`, evenly in x or in log x.
class SearchSpace {
 public:
  SearchSpace() = default;
  /// Throws std::invalid_argument with the variable and the rule when one is broken.
  explicit SearchSpace(std::vector<Variable> variables);

  [[nodiscard]] std::size_t size() const { return variables_.size(); }
  [[nodiscard]] const std::vector<Variable>& variables() const { return variables_; }
  /// A point of the unit cube in the variables' own units; ends map onto the bounds exactly.
  [[nodiscard]] std::vector<double> from_unit(std::span<const double> unit) const;
  /// The inverse; values outside the box end on its border.
  [[nodiscard]] std::vector<double> to_unit(std::span<const double> point) const;

 private:
  std::vector<Variable> variables_;
};

}  // namespace unbruised::optimizer
