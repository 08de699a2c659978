#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr std::size_t kMostLayers = 8;

/// Calls back with each layer and its path, "product.layer[0].".
template <class Take>
void each_layer(const Scenario& s, const Take& take) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  for (std::size_t i = 0; p != nullptr && i < p->layer.size(); ++i) {
    take(p->layer[i], "product.layer[" + std::to_string(i) + "].", i);
  }
}

void few_layers(const Scenario& s, Violations& out) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  if (p == nullptr || p->layer.size() <= kMostLayers) return;
  out.push_back({"product.layer[0].from_depth_m", std::to_string(p->layer.size()) + " layers",
                 "must be " + std::to_string(kMostLayers) + " layers at most"});
}

void layers_lie_within(const Scenario& s, Violations& out) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  if (p == nullptr) return;
  const double middle_m = 0.5 * *std::ranges::min_element(p->size_m);
  double before_m = 0.0;
  each_layer(s, [&](const ProductLayer& layer, const std::string& path, std::size_t) {
    if (!layer.from_depth_m) return;
    const double from_m = *layer.from_depth_m;
    if (before_m > 0.0 && !(from_m > before_m)) {
      out.push_back({path + "from_depth_m", spelled(from_m),
                     "must be > " + spelled(before_m) + ", where the layer before it begins: layers go inwards"});
    } else if (!(from_m < middle_m)) {
      out.push_back({path + "from_depth_m", spelled(from_m),
                     "must be < half the smallest extent of product.size_m = " + spelled(middle_m) +
                         ": nothing lies deeper"});
    }
    before_m = from_m;
  });
}

void layers_are_somewhere(const Scenario& s, Violations& out) {
  each_layer(s, [&](const ProductLayer& layer, const std::string& path, std::size_t) {
    if (layer.from_depth_m && layer.size_m) {
      out.push_back({path + "size_m", spelled(layer.size_m->front()) + ", ...",
                     "not together with from_depth_m: a layer is there by depth or by place"});
    } else if (!layer.from_depth_m && !layer.size_m) {
      out.push_back({path + "from_depth_m", "", "missing; or size_m, the extents of an ellipsoid"});
    }
  });
}

void centers_are_of_regions(const Scenario& s, Violations& out) {
  each_layer(s, [&](const ProductLayer& layer, const std::string& path, std::size_t) {
    if (!layer.center_m || layer.size_m) return;
    out.push_back({path + "center_m", spelled(layer.center_m->front()) + ", ...", "not used without size_m"});
  });
}

void regions_lie_within(const Scenario& s, Violations& out) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  each_layer(s, [&](const ProductLayer& layer, const std::string& path, std::size_t) {
    if (!layer.size_m) return;
    const std::array<double, 3> center_m = layer.center_m.value_or(std::array<double, 3>{});
    for (std::size_t d = 0; d < 3; ++d) {
      const double room_m = p->size_m[d] - 2.0 * std::abs(center_m[d]);
      if ((*layer.size_m)[d] <= room_m) continue;
      const std::string at = "[" + std::to_string(d) + "]";
      out.push_back({path + "size_m" + at, spelled((*layer.size_m)[d]),
                     "must be <= product.size_m" + at +
                         " less twice the way from its middle to center_m = " + spelled(room_m)});
      return;
    }
  });
}

void layers_yield_completely(const Scenario& s, Violations& out) {
  each_layer(s, [&](const ProductLayer& layer, const std::string& path, std::size_t) {
    add_unpaired(out, path, "tangent_modulus_Pa", layer.tangent_modulus_Pa, "yield_stress_Pa",
                 layer.yield_stress_Pa);
  });
}

void layers_harden_less(const Scenario& s, Violations& out) {
  each_layer(s, [&](const ProductLayer& layer, const std::string& path, std::size_t) {
    if (!layer.tangent_modulus_Pa || *layer.tangent_modulus_Pa < layer.youngs_modulus_Pa) return;
    add_bound(out, path + "tangent_modulus_Pa", *layer.tangent_modulus_Pa, path + "youngs_modulus_Pa",
              layer.youngs_modulus_Pa, Strictness::below);
  });
}

void skin_complete(const Scenario& s, Violations& out) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  if (p == nullptr) return;
  add_unpaired(out, "product.", "skin_modulus_Pa", p->skin_modulus_Pa, "skin_thickness_m", p->skin_thickness_m);
}

void skin_has_a_ratio(const Scenario& s, Violations& out) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  if (p == nullptr || p->skin_thickness_m || !p->skin_poisson_ratio) return;
  out.push_back(
      {"product.skin_poisson_ratio", spelled(*p->skin_poisson_ratio), "not used without skin_thickness_m"});
}

void skin_is_thin(const Scenario& s, Violations& out) {
  const auto* p = std::get_if<LatticeParameters>(&s.product);
  if (p == nullptr || !p->skin_thickness_m || *p->skin_thickness_m < p->cell_size_m) return;
  out.push_back({"product.skin_thickness_m", spelled(*p->skin_thickness_m),
                 "must be < product.cell_size_m = " + spelled(p->cell_size_m) +
                     ": what is thicker is the product's own material, over a [[product.layer]]"});
}

}  // namespace

std::vector<Rule> layer_rules() {
  return {
      {{"product.layer[].from_depth_m"}, "of 8 layers at most", few_layers},
      {{"product.layer[].from_depth_m", "product.size_m"},
       "deeper than the layer before, within the product",
       layers_lie_within},
      {{"product.layer[].size_m", "product.layer[].from_depth_m"},
       "in place of from_depth_m",
       layers_are_somewhere,
       "in place of size_m"},
      {{"product.layer[].center_m", "product.layer[].size_m"}, "goes with size_m", centers_are_of_regions},
      {{"product.layer[].size_m", "product.size_m", "product.layer[].center_m"},
       "within the product",
       regions_lie_within},
      {{"product.layer[].tangent_modulus_Pa", "product.layer[].yield_stress_Pa"},
       "goes with yield_stress_Pa",
       layers_yield_completely,
       "goes with tangent_modulus_Pa"},
      {{"product.layer[].tangent_modulus_Pa", "product.layer[].youngs_modulus_Pa"},
       "< youngs_modulus_Pa",
       layers_harden_less},
      {{"product.skin_modulus_Pa", "product.skin_thickness_m"},
       "goes with skin_thickness_m",
       skin_complete,
       "goes with skin_modulus_Pa"},
      {{"product.skin_poisson_ratio", "product.skin_thickness_m"}, "goes with skin_thickness_m", skin_has_a_ratio},
      {{"product.skin_thickness_m", "product.cell_size_m"}, "< cell_size_m", skin_is_thin},
  };
}

}  // namespace unbruised
