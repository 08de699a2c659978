#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table skin_keys() {
  using L = LatticeParameters;
  const Use use = Use::lattice;
  return {
      {.path = "product.skin_thickness_m",
       .type = optional_number,
       .meaning = "Thickness of a skin thinner than a cell: a membrane on the true surface, which resists being "
                  "stretched along it and nothing else. What is thicker than a cell is the product's own "
                  "material, over a "
                  "[[product.layer]].",
       .use = use,
       .note = "absent: no skin",
       .field = lattice<&L::skin_thickness_m>},
      {.path = "product.skin_modulus_Pa",
       .type = optional_number,
       .meaning = "Young's modulus of the skin.",
       .use = use,
       .note = "required with skin_thickness_m",
       .field = lattice<&L::skin_modulus_Pa>},
      {.path = "product.skin_poisson_ratio",
       .type = optional_number,
       .meaning = "Poisson's ratio of the skin.",
       .use = use,
       .note = "that of the product",
       .field = lattice<&L::skin_poisson_ratio>},
  };
}

Table layer_keys() {
  using P = ProductLayer;
  const Use use = Use::lattice;
  return {
      {.path = "product.layer[].from_depth_m",
       .type = optional_number,
       .meaning =
           "Depth below the true surface from which the product is of another material, down to the next layer or "
           "to the middle: flesh under a rind, a core. A cell belongs to the last layer that has its middle; "
           "where "
           "there is none the product is what its own keys say, and so is what touches.",
       .use = use,
       .field = layer<&P::from_depth_m>},
      {.path = "product.layer[].size_m",
       .type = maybe_numbers,
       .meaning = "In place of a depth: extents of an ellipsoid along the axes of product.size_m in which the "
                  "product is of another material, a stone or a place that is bruised already.",
       .size = 3,
       .use = use,
       .field = layer<&P::size_m>},
      {.path = "product.layer[].center_m",
       .type = maybe_numbers,
       .meaning = "Middle of that ellipsoid, from the middle of the product's extents.",
       .size = 3,
       .use = use,
       .note = "the product's middle",
       .field = layer<&P::center_m>},
      {.path = "product.layer[].youngs_modulus_Pa",
       .type = number,
       .meaning = "Young's modulus there. All moduli of a product fade alike.",
       .use = use,
       .required = true,
       .field = layer<&P::youngs_modulus_Pa>},
      {.path = "product.layer[].poisson_ratio",
       .type = optional_number,
       .meaning = "Poisson's ratio there.",
       .use = use,
       .note = "that of the product",
       .field = layer<&P::poisson_ratio>},
      {.path = "product.layer[].yield_stress_Pa",
       .type = optional_number,
       .meaning = "Yield stress there; without it the layer stays elastic.",
       .use = use,
       .field = layer<&P::yield_stress_Pa>},
      {.path = "product.layer[].tangent_modulus_Pa",
       .type = optional_number,
       .meaning = "Slope of the stress-strain curve after yield there.",
       .use = use,
       .field = layer<&P::tangent_modulus_Pa>},
  };
}

}  // namespace unbruised::studies::key_rows
