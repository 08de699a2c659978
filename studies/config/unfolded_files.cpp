#include <algorithm>
#include <iterator>
#include <optional>

#include "studies/config/demonstration.hpp"
#include "studies/config/library.hpp"
#include "studies/config/mesh_file.hpp"
#include "studies/config/product_profile.hpp"
#include "studies/config/urdf_arm.hpp"
#include "studies/config/waypoint_csv.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// The last of that path; nullptr: there is none.
const Entry* last_of(const std::vector<Entry>& entries, std::string_view path) {
  const auto found =
      std::find_if(entries.rbegin(), entries.rend(), [&](const Entry& entry) { return entry.path == path; });
  return found == entries.rend() ? nullptr : &*found;
}

/// The last that names a file under a key.
std::optional<Entry> file_named(const std::vector<Entry>& entries, std::string_view key) {
  const Entry* named = last_of(entries, key);
  return named != nullptr && named->value.kind == Value::Kind::text ? std::optional(*named) : std::nullopt;
}

/// Says that a list stands beside the file that is given in its place.
bool excludes_list(const Entry& named, const std::string& list, const std::vector<Entry>& entries,
                   Problems& problems) {
  const auto lists = [&](const Entry& entry) { return entry.path.starts_with(list + "["); };
  if (std::ranges::none_of(entries, lists)) return false;
  problems.add(named.origin, named.path, spelled(named.value),
               joined({"excludes [[", list, "]]; give one of them"}));
  return true;
}

void append(std::vector<Entry> more, std::vector<Entry>& entries) {
  std::ranges::move(more, std::back_inserter(entries));
}

/// By which a file is found from any folder.
std::string absolute_name(const std::string& file) {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::canonical(file, error);
  return error ? file : path.string();
}

/// Those whose keys are not said yet.
void append_unsaid(std::vector<Entry> more, std::vector<Entry>& entries) {
  for (Entry& entry : more) {
    if (last_of(entries, entry.path) == nullptr) entries.push_back(std::move(entry));
  }
}

}  // namespace

bool Library::names_file(std::string_view key) {
  return key == kProfileFileKey || key == kProductProfileKey || key.starts_with(kMeshKeys) ||
         key == kWaypointFileKey || key == "robot.urdf" || key == "robot.tip_link" ||
         key.starts_with(kDemonstrationKey);
}

void Library::read_profile(std::vector<Entry>& entries, Problems& problems) {
  const auto named = file_named(entries, kProfileFileKey);
  const auto text = named ? open(*named, problems) : std::nullopt;
  if (text) append(profile_entries(text->content, text->file, text->rank, problems), entries);
}

void Library::read_product_profile(std::vector<Entry>& entries, Problems& problems) {
  const auto named = file_named(entries, kProductProfileKey);
  if (!named) return;
  if (last_of(entries, "product.profile_height") != nullptr) {
    problems.add(named->origin, named->path, spelled(named->value),
                 "excludes product.profile_height; give one of them");
    return;
  }
  const auto text = open(*named, problems);
  if (text) append(product_profile_entries(text->content, text->file, text->rank, problems), entries);
}

void Library::read_mesh(std::vector<Entry>& entries, Problems& problems) {
  const auto named = file_named(entries, kMeshFileKey);
  if (!named) {
    for (const Entry& entry : entries) {
      if (!entry.path.starts_with(kMeshKeys)) continue;
      problems.add(entry.origin, entry.path, spelled(entry.value),
                   "belongs beside product.mesh_file, in the same file; give both");
    }
    return;
  }
  const auto text = open(*named, problems);
  if (!text) return;
  const std::string ending = std::filesystem::path(named->value.text).extension().string();
  const MeshText mesh_text{.content = text->content,
                           .file = *named,
                           .unit = last_of(entries, kMeshUnitKey),
                           .hash = last_of(entries, kMeshHashKey),
                           .ending = ending.empty() ? ending : ending.substr(1),
                           .found_again = absolute_name(*text->file)};
  const auto mesh = mesh_of_text(mesh_text, problems);
  if (!mesh) return;
  meshes_[{named->value.text, mesh->source().unit}] = mesh;
  if (last_of(entries, "product.size_m") != nullptr) return;
  entries.insert(entries.begin(), mesh_size_entry(*mesh, named->origin));
}

void Library::read_waypoints(std::vector<Entry>& entries, Problems& problems) {
  const auto named = file_named(entries, kWaypointFileKey);
  if (!named || excludes_list(*named, "strategy.waypoint", entries, problems)) return;
  const auto text = open(*named, problems);
  if (text) append(waypoint_entries(text->content, text->file, text->rank, problems), entries);
}

void Library::read_arm(std::vector<Entry>& entries, Problems& problems) {
  const Entry* tip = last_of(entries, "robot.tip_link");
  if (last_of(entries, "robot.urdf") == nullptr && tip != nullptr) {
    problems.add(tip->origin, tip->path, spelled(tip->value),
                 "not used: there is no robot.urdf whose link it could be");
  }
  const auto named = file_named(entries, "robot.urdf");
  if (!named || excludes_list(*named, "robot.joint", entries, problems)) return;
  const std::string tip_link = tip == nullptr ? "" : tip->value.text;
  const auto text = open(*named, problems);
  if (text) append_unsaid(urdf_entries({text->content, tip_link, text->file, text->rank}, problems), entries);
}

namespace {

/// How a demonstration is taken. @return false: a problem was said
bool read_settings(const std::vector<Entry>& entries, DemonstrationText& text, Problems& problems) {
  const std::string key(kDemonstrationKey);
  bool good = true;
  for (const auto& [leaf, number] :
       {std::pair{"_tolerance_m", &text.tolerance_m}, std::pair{"_tolerance_rad", &text.tolerance_rad}}) {
    const Entry* given = last_of(entries, key + leaf);
    if (given == nullptr || !given->value.is_number()) continue;  // else the check of the key's type says so
    *number = given->value.number;
    if (*number > 0.0) continue;
    problems.add(given->origin, given->path, spelled(given->value), "must be > 0");
    good = false;
  }
  const Entry* timing = last_of(entries, key + "_timing");
  text.as_shown = timing == nullptr || timing->value.text != "free";
  return good;
}

}  // namespace

void Library::read_demonstration(std::vector<Entry>& entries, Problems& problems) {
  const Entry* given = last_of(entries, kDemonstrationKey);
  if (given == nullptr || given->value.kind != Value::Kind::text) {
    for (const Entry& entry : entries) {
      if (given != nullptr || !entry.path.starts_with(kDemonstrationKey)) continue;
      problems.add(entry.origin, entry.path, spelled(entry.value), "not used: there is no strategy.demonstration");
    }
    return;
  }
  const Entry named = *given;
  for (const Entry& entry : entries) {
    const bool excluded = entry.path.starts_with("strategy.waypoint") || entry.path == "strategy.tilt_rad";
    if (!excluded) continue;
    problems.add(named.origin, named.path, spelled(named.value),
                 joined({"excludes ", entry.path, ": the demonstration says where the palm goes"}));
    return;
  }
  DemonstrationText settings;
  if (!read_settings(entries, settings, problems)) return;
  const auto text = open(named, problems);
  if (!text) return;
  settings.content = text->content;
  settings.file = text->file;
  settings.rank = text->rank;
  append_unsaid(demonstration_entries(settings, problems), entries);
}

}  // namespace unbruised::studies
