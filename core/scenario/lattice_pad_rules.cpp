#include <cmath>
#include <string>

#include "core/scenario/lattice_cells.hpp"
#include "core/scenario/pad_lattice.hpp"
#include "core/scenario/rule_tables.hpp"
#include "core/scenario/words.hpp"

namespace unbruised {
namespace {

constexpr double kMostCells = 1e5;
constexpr std::string_view kCell = "gripper.pad.cell_size_m";
constexpr std::string_view kKind = "gripper.pad.kind";

void refuse(std::string_view field, std::string_view value, const std::string& rule, Violations& out) {
  out.push_back({std::string(field), std::string(value), rule});
}

void cells_fit(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr) return;
  const std::optional<double>& cell_m = jaw->pad.cell_size_m;
  if (!has_lattice_pads(*jaw)) {
    if (cell_m) refuse(kCell, spelled(*cell_m), "not used: only pads of kind = \"lattice\" have cells", out);
    return;
  }
  if (!cell_m) return refuse(kCell, "", "missing; pads of kind = \"lattice\" need it", out);
  if (*cell_m > jaw->pad_thickness_m * (1.0 + 1e-12)) {
    return refuse(kCell, spelled(*cell_m),
                  "must be <= gripper.pad_thickness_m = " + spelled(jaw->pad_thickness_m) +
                      ": the pad is thinner than a cell",
                  out);
  }
  const LatticeParameters pad = pad_lattice(*jaw);
  double cells = 1.0;
  for (const double extent : pad.size_m) cells *= std::max(2.0, std::round(extent / pad.cell_size_m));
  if (!(cells <= kMostCells))
    return refuse(kCell, spelled(*cell_m), "makes more than 100,000 cells of a pad", out);
  const auto cell = lattice_cell_extent_m(pad);
  if (lattice_is_admissible(cell)) return;
  refuse(kCell, spelled(*cell_m),
         "divides a pad into cells of " + for_people(cell[0]) + " x " + for_people(cell[1]) + " x " +
             for_people(cell[2]) +
             " m, which are too far from cubes; a pad has at least two through its thickness",
         out);
}

void keeps_some_volume(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr || !has_lattice_pads(*jaw) || jaw->pad_poisson_ratio < 0.5) return;
  refuse("gripper.pad_poisson_ratio", spelled(jaw->pad_poisson_ratio),
         "must be < 0.5 of pads of kind = \"lattice\"; rubber has 0.49 or so", out);
}

void are_flat(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr || !has_lattice_pads(*jaw)) return;
  const bool has_law = !jaw->pad.law_depth_m.empty() || !jaw->pad.law_coefficients.empty();
  if (jaw->pad.shape != PadShape::flat)
    refuse(kKind, "lattice", "goes with gripper.pad.shape = \"flat\" only: other faces stand on rigid carriers",
           out);
  if (has_law)
    refuse(kKind, "lattice", "excludes a measured law of the layer: a body has the law of its material", out);
}

void stand_alone(const Scenario& s, Violations& out) {
  const auto* jaw = parallel_jaw(s);
  if (jaw == nullptr || !has_lattice_pads(*jaw)) return;
  if (s.sensor.at == SensorMount::wrist)
    refuse(kKind, "lattice", "does not go with a sensor at the wrist: its mount carries rigid fingers", out);
  if (s.cell.conveyor.speed_m_s > 0.0)
    refuse(kKind, "lattice", "does not go with a belt: a pad's face knows where the product stands at the start",
           out);
}

}  // namespace

std::vector<Rule> lattice_pad_rules() {
  return {
      {{kCell, kKind, "gripper.pad_thickness_m", "gripper.pad_size_m"},
       "<= gripper.pad_thickness_m; goes with kind = \"lattice\"",
       cells_fit,
       "\"lattice\" goes with cell_size_m"},
      {{"gripper.pad_poisson_ratio", kKind}, "< 0.5 of pads that are bodies", keeps_some_volume},
      {{kKind, "gripper.pad.shape", "gripper.pad.law_depth_m", "gripper.pad.law_coefficients"},
       "\"lattice\" has a flat face and no measured law",
       are_flat},
      {{kKind, "sensor.at", "cell.conveyor.speed_m_s"},
       "\"lattice\": no sensor at the wrist, no belt",
       stand_alone},
  };
}

}  // namespace unbruised
