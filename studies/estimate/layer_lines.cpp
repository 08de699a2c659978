#include "studies/estimate/layer_lines.hpp"

#include <array>
#include <variant>

#include "core/body/layers.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// Looked at more scenarios this would take longer than everything else that is checked.
constexpr std::size_t kLookedAt = 8;

/// The first layered products of those scenarios that are looked at.
std::vector<LatticeParameters> layered_products(const Study& study, std::size_t most) {
  std::vector<LatticeParameters> products;
  const std::size_t stride = 1 + (study.scenario_count() - 1) / kLookedAt;
  for (std::size_t id = 0; id < study.scenario_count() && products.size() < most; id += stride) {
    const Scenario scenario = study.scenario(id);
    const auto* product = std::get_if<LatticeParameters>(&scenario.product);
    if (product != nullptr && !product->layer.empty()) products.push_back(*product);
  }
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
  std::vector<std::string> lines;
  for (const LatticeParameters& product : layered_products(study, 1)) {
    const std::vector<std::size_t> cells = cells_of_materials(product);
    std::string line = joined({"materials: ", with_thousands(cells[0]), " cells of its own"});
    for (std::size_t i = 0; i < product.layer.size(); ++i) {
      line += joined({", ", with_thousands(cells[i + 1]), place_text(product.layer[i])});
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> layer_warnings(const Study& study) {
  for (const LatticeParameters& product : layered_products(study, kLookedAt)) {
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
