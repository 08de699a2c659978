#include <algorithm>

#include "studies/config/demonstration.hpp"
#include "studies/config/library.hpp"
#include "studies/config/urdf_arm.hpp"
#include "studies/config/waypoint_csv.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

bool Library::names_file(std::string_view key) {
  return key == kProfileFileKey || key == kWaypointFileKey || key == "robot.urdf" || key == "robot.tip_link" ||
         key.starts_with(kDemonstrationKey);
}

void Library::read_profile(std::vector<Entry>& entries, Problems& problems) {
  const auto named = std::find_if(entries.rbegin(), entries.rend(),
                                  [](const Entry& entry) { return entry.path == kProfileFileKey; });
  if (named == entries.rend() || named->value.kind != Value::Kind::text) return;
  const auto text = open(Entry(*named), problems);
  if (!text) return;
  for (Entry& entry : profile_entries(text->content, text->file, text->rank, problems)) {
    entries.push_back(std::move(entry));
  }
}

void Library::read_waypoints(std::vector<Entry>& entries, Problems& problems) {
  const auto named = std::find_if(entries.rbegin(), entries.rend(),
                                  [](const Entry& entry) { return entry.path == kWaypointFileKey; });
  if (named == entries.rend() || named->value.kind != Value::Kind::text) return;
  const auto lists = [](const Entry& entry) { return entry.path.starts_with("strategy.waypoint["); };
  if (std::any_of(entries.begin(), entries.end(), lists)) {
    problems.add(named->origin, named->path, spelled(named->value),
                 "excludes [[strategy.waypoint]]; give one of them");
    return;
  }
  const auto text = open(Entry(*named), problems);
  if (!text) return;
  for (Entry& entry : waypoint_entries(text->content, text->file, text->rank, problems)) {
    entries.push_back(std::move(entry));
  }
}

void Library::read_arm(std::vector<Entry>& entries, Problems& problems) {
  const auto last = [&](std::string_view path) {
    return std::find_if(entries.rbegin(), entries.rend(), [&](const Entry& entry) { return entry.path == path; });
  };
  const auto named = last("robot.urdf"), tip = last("robot.tip_link");
  if (named == entries.rend() && tip != entries.rend()) {
    problems.add(tip->origin, tip->path, spelled(tip->value),
                 "not used: there is no robot.urdf whose link it could be");
  }
  if (named == entries.rend() || named->value.kind != Value::Kind::text) return;
  const auto lists = [](const Entry& entry) { return entry.path.starts_with("robot.joint["); };
  if (std::any_of(entries.begin(), entries.end(), lists)) {
    problems.add(named->origin, named->path, spelled(named->value), "excludes [[robot.joint]]; give one of them");
    return;
  }
  const std::string tip_link = tip == entries.rend() ? "" : tip->value.text;
  const auto text = open(Entry(*named), problems);
  if (!text) return;
  for (Entry& entry : urdf_entries({text->content, tip_link, text->file, text->rank}, problems)) {
    if (last(entry.path) == entries.rend()) entries.push_back(std::move(entry));
  }
}

namespace {

/// The last of that path; nullptr: there is none.
const Entry* last_of(const std::vector<Entry>& entries, std::string_view path) {
  const auto found =
      std::find_if(entries.rbegin(), entries.rend(), [&](const Entry& entry) { return entry.path == path; });
  return found == entries.rend() ? nullptr : &*found;
}

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
  for (Entry& entry : demonstration_entries(settings, problems)) {
    if (last_of(entries, entry.path) == nullptr) entries.push_back(std::move(entry));
  }
}

}  // namespace unbruised::studies
