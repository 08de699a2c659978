#include "studies/config/mesh_file.hpp"

#include <algorithm>
#include <array>

#include <xxhash.h>

#include "core/scenario/mesh_fault.hpp"
#include "studies/config/mesh_reader.hpp"
#include "studies/text/hex_text.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

struct LengthUnit {
  std::string_view word;
  double m;
};
constexpr std::array<LengthUnit, 4> kUnits = {{{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"in", 0.0254}}};

/// The longest extents of what is handled with a gripper; beyond them it is the unit that is wrong.
constexpr double kShortest_m = 1e-3, kLongest_m = 1.0;

const LengthUnit* unit_named(std::string_view word) {
  const auto found = std::ranges::find(kUnits, word, &LengthUnit::word);
  return found == kUnits.end() ? nullptr : &*found;
}

using Extents = std::array<double, 3>;

std::string spelled_extents(const Extents& extents, std::string_view unit) {
  return joined(
      {short_number(extents[0]), " x ", short_number(extents[1]), " x ", short_number(extents[2]), " ", unit});
}

bool is_products(double longest_m) { return longest_m >= kShortest_m && longest_m <= kLongest_m; }

/// Which units would make a product of it: "\"mm\" makes it 74 x 72 x 90 mm".
std::string what_units_make(const Extents& extents) {
  const double longest = *std::ranges::max_element(extents);
  std::vector<std::string> likely;
  for (const LengthUnit& unit : kUnits) {
    if (is_products(longest * unit.m)) likely.push_back(joined({"\"", unit.word, "\""}));
  }
  if (likely.empty()) return "no unit makes a product of it: stretch it with size_m, or scale the file";
  return joined({listed(likely, "or"), likely.size() == 1 ? " makes" : " make", " a product of it"});
}

/// @return null: a problem was said
const LengthUnit* sound_unit(const MeshText& text, const Extents& extents, Problems& problems) {
  if (text.unit == nullptr) {
    problems.add(text.file.origin, std::string(kMeshUnitKey),
                 joined({"missing: say in which unit the file's ", spelled_extents(extents, "units"), " are; ",
                         what_units_make(extents)}));
    return nullptr;
  }
  const LengthUnit* unit = unit_named(text.unit->value.text);
  if (unit == nullptr) {
    problems.add(text.unit->origin, text.unit->path, spelled(text.unit->value),
                 "must be \"mm\", \"cm\", \"m\" or \"in\"");
    return nullptr;
  }
  if (is_products(*std::ranges::max_element(extents) * unit->m)) return unit;
  problems.add(text.unit->origin, text.unit->path, spelled(text.unit->value),
               joined({"makes the mesh ", spelled_extents(extents, unit->word),
                       " large, and a product is 1 mm to 1 m long; ", what_units_make(extents)}));
  return nullptr;
}

}  // namespace

std::shared_ptr<const ProductMesh> mesh_of_text(const MeshText& text, Problems& problems) {
  const auto refuse = [&](const Entry& entry, const std::string& rule) {
    problems.add(entry.origin, entry.path, spelled(entry.value), rule);
    return nullptr;
  };
  const std::uint64_t hash = XXH3_64bits(text.content.data(), text.content.size());
  if (text.hash != nullptr && text.hash->value.text != hex_text(hash)) {
    return refuse(*text.hash, joined({"is not the hash of ", text.file.value.text, ", which is ", hex_text(hash),
                                      ": the file has changed, or another one is meant"}));
  }
  const auto read = read_triangles(text.content, text.ending);
  if (!read) return refuse(text.file, read.error());
  TriangleMesh mesh = welded(*read);
  if (const auto fault = mesh_fault(mesh)) return refuse(text.file, *fault);
  const Bounds box = bounds_of(mesh.place);
  const LengthUnit* unit =
      sound_unit(text, {box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]}, problems);
  if (unit == nullptr) return nullptr;
  return std::make_shared<const ProductMesh>(
      std::move(mesh), MeshSource{.hash = hash, .file = text.found_again, .unit = std::string(unit->word)});
}

Entry mesh_size_entry(const ProductMesh& mesh, const Origin& origin) {
  Entry entry{"product.size_m", {}, origin};
  entry.value.kind = Value::Kind::array;
  for (const double extent : mesh.extents()) {
    entry.value.items.push_back(number_value(extent * unit_named(mesh.source().unit)->m));
  }
  return entry;
}

}  // namespace unbruised::studies
