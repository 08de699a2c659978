#include "studies/config/demonstration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/scenario/attitude.hpp"
#include "core/scenario/palm_stops.hpp"
#include "core/scenario/vectors.hpp"
#include "studies/config/number_table.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

using Vector = std::array<double, 3>;

/// Of the palm, from where the gripper closed.
struct Sample {
  double time_s = 0.0;
  Vector place{};
  Attitude attitude;
  double force_N = 0.0;
  bool closed = false;
};

constexpr double kLeastLift_m = 0.005;
/// Peak acceleration of a motion of minimum jerk over D in T is this D / T^2.
constexpr double kMinimumJerk = 10.0 / std::numbers::sqrt3;

class Reader {
 public:
  Reader(const DemonstrationText& text, Problems& problems)
      : table_(text.content, text.file, text.rank, kDemonstrationKey, problems), problems_(problems) {}

  /// Those from closing to opening; empty: a problem was said.
  std::vector<Sample> read() {
    if (!read_header()) {
      return refuse(
          "the first line must name the columns time_s, x_m, y_m, z_m, closed, and of these what there is: "
          "rx_rad, ry_rad, rz_rad or qw, qx, qy, qz; grip_force_N");
    }
    std::vector<Sample> all;
    while (table_.next()) {
      const auto sample = read_row();
      if (!sample) return {};
      if (!all.empty() && !(sample->time_s > all.back().time_s)) {
        problems_.add(table_.origin(), "time_s", spelled(sample->time_s),
                      joined({"must be > ", spelled(all.back().time_s), ", the time before it"}));
        return {};
      }
      all.push_back(*sample);
    }
    if (table_.failed()) return {};
    return held_part(all);
  }

  [[nodiscard]] bool has_rotation() const { return table_.has("rx_rad") || table_.has("qw"); }
  [[nodiscard]] const Origin& file() const { return table_.start(); }

 private:
  std::vector<Sample> refuse(const std::string& rule) {
    problems_.add(table_.start(), kDemonstrationKey, rule);
    return {};
  }

  bool read_header() {
    return table_.read_header({{"time_s", "x_m", "y_m", "z_m", "closed"},
                               {"rx_rad", "ry_rad", "rz_rad"},
                               {"qw", "qx", "qy", "qz"},
                               {"grip_force_N"}}) &&
           table_.has("time_s") && !(table_.has("qw") && table_.has("rx_rad"));
  }

  std::optional<Sample> read_row() {
    const Origin& origin = table_.origin();
    const auto n = [&](const char* column) { return table_.number(column); };
    if (n("closed") != 0.0 && n("closed") != 1.0) {
      problems_.add(origin, "closed", spelled(n("closed")), "must be 0, open, or 1, closed");
      return std::nullopt;
    }
    Sample sample{n("time_s"), {n("x_m"), n("y_m"), n("z_m")}, {}, n("grip_force_N"), n("closed") == 1.0};
    if (table_.has("rx_rad")) sample.attitude = attitude_of({n("rx_rad"), n("ry_rad"), n("rz_rad")});
    if (table_.has("qw")) {
      const double size = std::hypot(std::hypot(n("qw"), n("qx")), std::hypot(n("qy"), n("qz")));
      constexpr double kUnitRoom = 1e-3;  // of what was recorded with four digits
      if (!(std::abs(size - 1.0) <= kUnitRoom)) {
        problems_.add(origin, "qw", spelled(n("qw")),
                      joined({"is of a quaternion of length ", spelled(size), "; a rotation has the length 1"}));
        return std::nullopt;
      }
      sample.attitude = {n("qw") / size, {n("qx") / size, n("qy") / size, n("qz") / size}};
    }
    return sample;
  }

  /// Seen from where the gripper closed, x along the grip axis.
  std::vector<Sample> held_part(const std::vector<Sample>& all) {
    const auto is_closed = [](const Sample& sample) { return sample.closed; };
    const auto closes = std::find_if(all.begin(), all.end(), is_closed);
    if (closes == all.end()) return refuse("the gripper never closes: `closed` is never 1");
    const auto opens = std::find_if_not(closes, all.end(), is_closed);
    if (opens == all.end()) return refuse("the gripper does not open again: after its last 1 `closed` has no 0");
    const Vector axis = turned(closes->attitude, {1.0, 0.0, 0.0});
    const Attitude level = attitude_of({0.0, 0.0, -std::atan2(axis[1], axis[0])});
    std::vector<Sample> held;
    for (auto each = closes; each <= opens; ++each) {
      Sample sample = *each;
      sample.place = turned(level, between(closes->place, each->place));
      sample.attitude = level * each->attitude * inverse(closes->attitude) * inverse(level);
      held.push_back(sample);
    }
    return held;
  }

  NumberTable table_;
  Problems& problems_;
};

/// Straight ways that stay near samples.
class Simplifier {
 public:
  Simplifier(const std::vector<Sample>& samples, double most_m, double most_rad)
      : samples_(samples), most_m_(most_m), most_rad_(most_rad) {}

  /// Places between which the ways are straight, both ends too.
  [[nodiscard]] std::vector<std::size_t> corners(std::size_t from, std::size_t to) const {
    std::vector<std::size_t> found = {from};
    split(from, to, found);
    return found;
  }

 private:
  void split(std::size_t from, std::size_t to, std::vector<std::size_t>& found) const {
    double worst = 1.0;
    std::size_t at = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = deviation(from, to, i);
      if (off > worst) {
        worst = off;
        at = i;
      }
    }
    if (at != 0) {
      split(from, at, found);
      split(at, to, found);
    } else {
      found.push_back(to);
    }
  }

  /// Of a sample from the way between two others, over what is allowed.
  [[nodiscard]] double deviation(std::size_t from, std::size_t to, std::size_t i) const {
    const Sample &a = samples_[from], &b = samples_[to], &c = samples_[i];
    const Vector way = between(a.place, b.place), gone = between(a.place, c.place);
    const double square = dot(way, way);
    const double by_time = (c.time_s - a.time_s) / (b.time_s - a.time_s);
    const double share = square > most_m_ * most_m_ ? std::clamp(dot(gone, way) / square, 0.0, 1.0) : by_time;
    const Vector off = {gone[0] - share * way[0], gone[1] - share * way[1], gone[2] - share * way[2]};
    const Vector turn = rotation_to(b.attitude * inverse(a.attitude));
    const Attitude there = attitude_of({share * turn[0], share * turn[1], share * turn[2]}) * a.attitude;
    return std::max(length(off) / most_m_, angle_between_rad(there, c.attitude) / most_rad_);
  }

  const std::vector<Sample>& samples_;
  double most_m_, most_rad_;
};

class Teacher {
 public:
  Teacher(const DemonstrationText& text, std::vector<Sample> samples, bool turns, const Origin& origin,
          Problems& problems)
      : text_(text), samples_(std::move(samples)), turns_(turns), origin_(origin), problems_(problems) {}

  std::vector<Entry> entries() {
    const std::size_t up = top_of_lift(), down = top_of_lowering();
    const Sample& end = samples_.back();
    if (samples_[up].place[2] < kLeastLift_m) {
      return refuse(joined({"goes sideways before it has risen by ", spelled(kLeastLift_m),
                            " m: the lift is straight up, within half of strategy.demonstration_tolerance_m"}));
    }
    const double end_m = std::abs(end.place[2]) <= 0.5 * text_.tolerance_m ? 0.0 : end.place[2];
    if (down > up && !(samples_[down].place[2] > end_m))
      return refuse("does not come down onto its place from above");
    add("cell.lift_height_m", number_value(samples_[up].place[2]));
    add("cell.transfer_m", array_of({end.place[0], end.place[1]}));
    if (angle_between_rad(end.attitude, {}) <= text_.tolerance_rad)
      add("cell.place_height_m", number_value(end_m));
    if (down > up && !add_waypoints(up, down)) return {};
    add_times(up, down);
    double most_N = 0.0;
    for (const Sample& sample : samples_) most_N = std::max(most_N, sample.force_N);
    if (most_N > 0.0) add("strategy.grip_force_N", number_value(most_N));
    return std::move(entries_);
  }

 private:
  std::vector<Entry> refuse(const std::string& rule) {
    problems_.add(origin_, kDemonstrationKey, rule);
    return {};
  }
  void add(const std::string& path, Value value) { entries_.push_back({path, std::move(value), origin_}); }
  static Value array_of(const std::vector<double>& numbers) {
    Value value;
    value.kind = Value::Kind::array;
    for (const double number : numbers) value.items.push_back(number_value(number));
    return value;
  }

  /// Is it straight above another, turned as that is?
  [[nodiscard]] bool is_above(const Sample& sample, const Sample& other) const {
    const Vector off = between(other.place, sample.place);
    return std::hypot(off[0], off[1]) <= 0.5 * text_.tolerance_m &&
           angle_between_rad(sample.attitude, other.attitude) <= 0.5 * text_.tolerance_rad;
  }

  [[nodiscard]] std::size_t top_of_lift() const {
    std::size_t top = 0;
    for (std::size_t i = 0; i < samples_.size() && is_above(samples_[i], samples_.front()); ++i) {
      if (samples_[i].place[2] > samples_[top].place[2]) top = i;
    }
    return top;
  }
  [[nodiscard]] std::size_t top_of_lowering() const {
    std::size_t top = samples_.size() - 1;
    for (std::size_t i = samples_.size(); i-- > 0 && is_above(samples_[i], samples_.back());) {
      if (samples_[i].place[2] > samples_[top].place[2]) top = i;
    }
    return top;
  }

  bool add_waypoints(std::size_t up, std::size_t down) {
    const auto corners_of = [&](double tolerance_m, double tolerance_rad) {
      return Simplifier(samples_, 0.5 * tolerance_m, 0.5 * tolerance_rad).corners(up, down);
    };
    const std::vector<std::size_t> corners = corners_of(text_.tolerance_m, text_.tolerance_rad);
    if (corners.size() - 1 > kWaypointsMost) {
      refuse(joined({"needs ", std::to_string(corners.size() - 1), " waypoints to stay within ",
                     spelled(text_.tolerance_m), " m and ", spelled(text_.tolerance_rad), " rad of it, and ",
                     std::to_string(kWaypointsMost),
                     " are followed: give strategy.demonstration_tolerance_m or _rad more room"}));
      return false;
    }
    for (std::size_t w = 1; w < corners.size(); ++w) {
      const Sample &sample = samples_[corners[w]], &before = samples_[corners[w - 1]];
      const std::string path = joined({"strategy.waypoint[", std::to_string(w - 1), "]."});
      const bool last = w + 1 == corners.size();
      const Vector& end = samples_.back().place;
      // The last stands straight above the place, so that nothing is left for the transfer.
      const Vector place = last ? Vector{end[0], end[1], sample.place[2]} : sample.place;
      add(path + "place_m", array_of({place[0], place[1], place[2]}));
      if (turns_) {
        const Vector rotation = rotation_to(sample.attitude);
        add(path + "rotation_rad", array_of({rotation[0], rotation[1], rotation[2]}));
      }
      if (!last) add(path + "blend_m", number_value(0.5 * text_.tolerance_m));
      if (text_.as_shown) add(path + "duration_s", number_value(sample.time_s - before.time_s));
    }
    return true;
  }

  /// Those of lift and lowering, and the rest before opening.
  void add_times(std::size_t up, std::size_t down) {
    if (!text_.as_shown) return;
    const auto is_at = [&](const Sample& sample, const Sample& other) {
      return length(between(sample.place, other.place)) <= 0.5 * text_.tolerance_m;
    };
    std::size_t leaves = 0, arrives = samples_.size() - 1;
    while (leaves < up && is_at(samples_[leaves + 1], samples_.front())) ++leaves;
    while (arrives > down && is_at(samples_[arrives - 1], samples_.back())) --arrives;
    add_acceleration("strategy.lift_acceleration_m_s2", leaves, up);
    add_acceleration("strategy.lower_acceleration_m_s2", down, arrives);
    add("strategy.place_settle_s", number_value(samples_.back().time_s - samples_[arrives].time_s));
  }
  void add_acceleration(const std::string& path, std::size_t from, std::size_t to) {
    const double way_m = std::abs(samples_[to].place[2] - samples_[from].place[2]);
    const double time_s = samples_[to].time_s - samples_[from].time_s;
    if (way_m > 0.0 && time_s > 0.0) add(path, number_value(kMinimumJerk * way_m / (time_s * time_s)));
  }

  const DemonstrationText& text_;
  std::vector<Sample> samples_;
  bool turns_;
  Origin origin_;
  Problems& problems_;
  std::vector<Entry> entries_;
};

}  // namespace

std::vector<Entry> demonstration_entries(const DemonstrationText& text, Problems& problems) {
  Reader reader(text, problems);
  std::vector<Sample> samples = reader.read();
  if (samples.empty()) return {};
  return Teacher(text, std::move(samples), reader.has_rotation(), reader.file(), problems).entries();
}

}  // namespace unbruised::studies
