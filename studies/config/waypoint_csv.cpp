#include "studies/config/waypoint_csv.hpp"

#include "studies/config/number_table.hpp"
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
      : table_(content, file, rank, kWaypointFileKey, problems), problems_(problems) {}

  std::vector<Entry> read() {
    std::vector<std::vector<std::string>> columns;
    for (const Group& group : groups()) columns.push_back(group.columns);
    const bool good = table_.read_header(columns) && table_.has("x_m") &&
                      !(table_.has("qw") && table_.has("rx_rad")) &&
                      !(table_.has("time_s") && table_.has("speed_m_s"));
    if (!good) return refuse(header_rule());
    while (table_.next()) {
      for (const Group& group : groups()) {
        if (table_.has(group.columns.front()) && !add(group)) return {};
      }
      ++rows_;
    }
    if (table_.failed()) return {};
    if (rows_ == 0) return refuse("the file must have a row at least");
    return std::move(entries_);
  }

 private:
  std::vector<Entry> refuse(const std::string& rule) {
    problems_.add(table_.start(), kWaypointFileKey, rule);
    return {};
  }

  static std::string header_rule() {
    return "the first line must name the columns x_m, y_m, z_m, and of these what there is: rx_rad, ry_rad, "
           "rz_rad or "
           "qw, qx, qy, qz; time_s or speed_m_s; blend_m; wait_s";
  }

  bool add(const Group& group) {
    Value value;
    if (group.columns.size() > 1) {
      value.kind = Value::Kind::array;
      for (const std::string& name : group.columns) value.items.push_back(number_value(table_.number(name)));
    } else {
      value = number_value(table_.number(group.columns.front()));
    }
    std::string leaf(group.leaf);
    if (leaf == "time_s") {
      if (!(value.number > before_s_)) {
        problems_.add(table_.origin(), leaf, spelled(value),
                      joined({"must be > ", spelled(before_s_),
                              rows_ == 0 ? ", when the lift ends" : ", the time of the waypoint before it"}));
        return false;
      }
      leaf = "duration_s";
      const double time_s = value.number;
      value = number_value(time_s - before_s_);
      before_s_ = time_s + table_.number("wait_s");
    }
    entries_.push_back(
        {joined({"strategy.waypoint[", std::to_string(rows_), "].", leaf}), std::move(value), table_.origin()});
    return true;
  }

  NumberTable table_;
  Problems& problems_;
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
