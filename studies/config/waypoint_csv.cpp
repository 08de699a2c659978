#include "studies/config/waypoint_csv.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "studies/config/csv_rows.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Columns that go together.
struct Group {
  std::string_view leaf;  ///< of the waypoint
  std::vector<std::string> columns;
};
const std::vector<Group>& groups() {
  static const std::vector<Group> all = {{"place_m", {"x_m", "y_m", "z_m"}},
                                         {"rotation_rad", {"rx_rad", "ry_rad", "rz_rad"}},
                                         {"quaternion", {"qw", "qx", "qy", "qz"}},
                                         {"time_s", {"time_s"}},
                                         {"speed_m_s", {"speed_m_s"}},
                                         {"blend_m", {"blend_m"}},
                                         {"wait_s", {"wait_s"}}};
  return all;
}

class WaypointReader {
 public:
  WaypointReader(std::string_view content, const std::shared_ptr<const std::string>& file, int rank,
                 Problems& problems)
      : csv_(content, file, rank), start_{file, rank, 1}, problems_(problems) {}

  std::vector<Entry> read() {
    if (!csv_.next() || !read_header()) return refuse(start_, kWaypointFileKey, header_rule());
    while (csv_.next()) {
      if (!read_row()) return {};
    }
    if (rows_ == 0) return refuse(start_, kWaypointFileKey, "the file must have a row at least");
    return std::move(entries_);
  }

 private:
  std::vector<Entry> refuse(const Origin& origin, std::string_view what, const std::string& rule) {
    problems_.add(origin, what, rule);
    return {};
  }

  static std::string header_rule() {
    return "the first line must name the columns x_m, y_m, z_m, and of these what there is: rx_rad, ry_rad, "
           "rz_rad or "
           "qw, qx, qy, qz; time_s or speed_m_s; blend_m; wait_s";
  }

  bool read_header() {
    columns_ = csv_.cells();
    start_ = csv_.origin();
    std::size_t known = 0;
    for (const Group& group : groups()) {
      const auto there = static_cast<std::size_t>(
          std::count_if(group.columns.begin(), group.columns.end(), [&](const auto& name) { return has(name); }));
      if (there != 0 && there != group.columns.size()) return false;
      known += there;
    }
    const bool excludes = (has("qw") && has("rx_rad")) || (has("time_s") && has("speed_m_s"));
    return has("x_m") && known == columns_.size() && !excludes;
  }

  [[nodiscard]] bool has(const std::string& name) const {
    return std::count(columns_.begin(), columns_.end(), name) == 1;
  }

  bool read_row() {
    const Origin& origin = csv_.origin();
    if (csv_.cells().size() != columns_.size()) {
      refuse(origin, kWaypointFileKey,
             joined({"a row must have ", std::to_string(columns_.size()), " cells, not ",
                     std::to_string(csv_.cells().size())}));
      return false;
    }
    std::map<std::string, double> number;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto value = cell_number(csv_.cells()[i]);
      if (!value) {
        problems_.add(origin, columns_[i], csv_.cells()[i], "must be a number");
        return false;
      }
      number[columns_[i]] = *value;
    }
    for (const Group& group : groups()) {
      if (has(group.columns.front()) && !add(group, number)) return false;
    }
    ++rows_;
    return true;
  }

  bool add(const Group& group, const std::map<std::string, double>& number) {
    Value value;
    if (group.columns.size() > 1) {
      value.kind = Value::Kind::array;
      for (const std::string& name : group.columns) value.items.push_back(number_value(number.at(name)));
    } else {
      value = number_value(number.at(group.columns.front()));
    }
    std::string leaf(group.leaf);
    if (leaf == "time_s") {
      if (!(value.number > before_s_)) {
        problems_.add(csv_.origin(), leaf, spelled(value),
                      joined({"must be > ", spelled(before_s_),
                              rows_ == 0 ? ", when the lift ends" : ", the time of the waypoint before it"}));
        return false;
      }
      leaf = "duration_s";
      const double time_s = value.number;
      value = number_value(time_s - before_s_);
      before_s_ = time_s + (has("wait_s") ? number.at("wait_s") : 0.0);
    }
    entries_.push_back(
        {joined({"strategy.waypoint[", std::to_string(rows_), "].", leaf}), std::move(value), csv_.origin()});
    return true;
  }

  CsvRows csv_;
  Origin start_;
  Problems& problems_;
  std::vector<std::string> columns_;
  std::vector<Entry> entries_;
  std::size_t rows_ = 0;
  double before_s_ = 0.0;
};

}  // namespace

std::vector<Entry> waypoint_entries(std::string_view content, const std::shared_ptr<const std::string>& file,
                                    int rank, Problems& problems) {
  return WaypointReader(content, file, rank, problems).read();
}

}  // namespace unbruised::studies
