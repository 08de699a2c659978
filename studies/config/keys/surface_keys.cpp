#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table surface_keys() {
  using S = CellSurfaceParameters;
  const Use use = Use::lattice;
  return {
      {.path = "cell.surface[].center_m",
       .type = numbers,
       .meaning =
           "Middle of the rectangle, or a place of the plane: from where the support's plane lies under the "
           "product's middle at the start.",
       .size = 3,
       .use = use,
       .field = surface<&S::center_m>},
      {.path = "cell.surface[].normal",
       .type = numbers,
       .meaning = "Towards the side on which it is touched; of any length.",
       .size = 3,
       .use = use,
       .field = surface<&S::normal>},
      {.path = "cell.surface[].size_m",
       .type = maybe_numbers,
       .meaning =
           "Extents of the rectangle: along the direction in it that is nearest to x (to y where the normal "
           "lies along x), and across that.",
       .size = 2,
       .use = use,
       .note = "absent: a plane without edges",
       .field = surface<&S::size_m>},
      {.path = "cell.surface[].friction",
       .type = number,
       .meaning = "Coulomb coefficient against it.",
       .use = use,
       .field = surface<&S::friction>},
      {.path = "cell.surface[].modulus_Pa",
       .type = number,
       .meaning = "Young's modulus of its compliant layer, which gives way like springs.",
       .use = use,
       .field = surface<&S::modulus_Pa>},
      {.path = "cell.surface[].thickness_m",
       .type = number,
       .meaning = "Thickness of that layer.",
       .use = use,
       .field = surface<&S::thickness_m>},
      {.path = "cell.surface[].relaxation_time_s",
       .type = number,
       .meaning = "Relaxation time of that layer; 0: it bounces for ever. The default is the support's.",
       .use = use,
       .field = surface<&S::relaxation_time_s>},
      {.path = "cell.surface[].path_time_s",
       .type = series,
       .meaning = "Times at which it passes the places of path_m; from one to the next by minimum jerk.",
       .use = use,
       .note = "absent: it does not move",
       .field = surface<&S::path_time_s>},
      {.path = "cell.surface[].path_m",
       .type = vector_series,
       .meaning = "Places that it moves through, against the first one.",
       .use = use,
       .field = surface<&S::path_m>},
  };
}

}  // namespace unbruised::studies::key_rows
