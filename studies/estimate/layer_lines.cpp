#include "studies/estimate/layer_lines.hpp"

#include <array>
#include <variant>

#include "core/body/layers.hpp"
#include "studies/estimate/some_scenarios.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Cutting more products into cells would take longer than everything else that is checked.
constexpr std::size_t kMostProducts = 8;

/// The layered products of some scenarios.
std::vector<LatticeParameters> layered_products(const Study& study) {
  std::vector<LatticeParameters> products;
  look_at_some(study, kMostProducts, [&](const Scenario& scenario) {
    const auto* product = std::get_if<LatticeParameters>(&scenario.product);
    if (product != nullptr && !product->layer.empty()) products.push_back(*product);
  });
  return products;
}

std::string place_text(const ProductLayer& layer) {
  if (layer.from_depth_m) return joined({" from ", short_number(1e3 * *layer.from_depth_m), " mm deep"});
  std::string extents;
  for (const double extent_m : layer.size_m.value_or(std::array<double, 3>{})) {
    extents += joined({extents.empty() ? " in an ellipsoid of " : " x ", short_number(1e3 * extent_m)});
  }
  return extents + " mm";
}

}  // namespace

std::vector<std::string> layer_lines(const Study& study) {
  const std::vector<LatticeParameters> products = layered_products(study);
  if (products.empty()) return {};
  const LatticeParameters& first = products.front();
  const std::vector<std::size_t> cells = cells_of_materials(first);
  std::string line = joined({"materials: ", with_thousands(cells[0]), " cells of its own"});
  for (std::size_t i = 0; i < first.layer.size(); ++i) {
    line += joined({", ", with_thousands(cells[i + 1]), place_text(first.layer[i])});
  }
  return {line};
}

std::vector<std::string> layer_warnings(const Study& study) {
  for (const LatticeParameters& product : layered_products(study)) {
    const std::vector<std::size_t> cells = cells_of_materials(product);
    for (std::size_t i = 0; i <= product.layer.size(); ++i) {
      if (cells[i] > 0) continue;
      const std::string what = i == 0 ? std::string("above product.layer[0]")
                                      : joined({"of product.layer[", std::to_string(i - 1), "]"});
      return {joined({"no cell has its middle in the part ", what,
                      ", which is as if it were not there; use a smaller product.cell_size_m, or a skin "
                      "(product.skin_thickness_m) where it lies outside"})};
    }
  }
  return {};
}

}  // namespace unbruised::studies
