#include "studies/estimate/arm_lines.hpp"

#include <algorithm>

#include "core/robot/arm_timing.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kArmScenariosMost = 100;

/// What the scenarios that were looked at ask of the arm.
struct Asked {
  ArmBreach most;  ///< the first limit that is broken, or the one of which most is used
  std::size_t scenario = 0, stuck = 0, slowed = 0;
  double most_slowed_s = 0.0;

  void add(std::size_t id, const Scenario& asking) {
    const TimedScenario timed = timed_for_arm(asking);
    if (timed.slowed_s > 0.0) ++slowed;
    most_slowed_s = std::max(most_slowed_s, timed.slowed_s);
    const bool breaks = timed.ride.breach.has_value();
    const ArmBreach now = breaks ? *timed.ride.breach : timed.ride.binding();
    const bool is_first = id == 0 || (breaks && stuck == 0);
    if (is_first || (!breaks && stuck == 0 && now.use > most.use)) {
      most = now;
      scenario = id;
    }
    if (breaks) ++stuck;
  }
};

std::string limit_line(const Asked& asked, bool is_one) {
  const std::string where = is_one ? "" : joined({", scenario ", std::to_string(asked.scenario)});
  const std::string when = joined({" (", three_digits(asked.most.time_s), " s after the start", where, ")"});
  if (asked.stuck > 0) return joined({"arm: ", words_of(asked.most), when});
  return joined({"arm: no limit is broken; ", words_of(asked.most), when, ", more than of any other limit"});
}

}  // namespace

std::vector<std::string> arm_lines(const Study& study) {
  if (!has_robot(study.scenario(0))) return {};
  const std::size_t all = study.scenario_count(), looked = std::min(all, kArmScenariosMost);
  Asked asked;
  for (std::size_t i = 0; i < looked; ++i) asked.add(i * all / looked, study.scenario(i * all / looked));
  std::vector<std::string> lines = {limit_line(asked, all == 1)};
  const std::string of =
      joined({" of ", std::to_string(looked), looked < all ? " scenarios looked at" : " scenarios"});
  if (asked.slowed > 0) {
    lines.push_back(joined({"arm: slows down ", std::to_string(asked.slowed), of, ", by up to ",
                            three_digits(asked.most_slowed_s), " s from lift to lowering"}));
  }
  if (all > 1) lines.push_back(joined({"arm: cannot follow ", std::to_string(asked.stuck), of}));
  return lines;
}

}  // namespace unbruised::studies
