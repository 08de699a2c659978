#include <algorithm>
#include <set>
#include <string>

#include "studies/config/measured_data.hpp"
#include "studies/config/search_parts.hpp"

namespace unbruised::studies {
namespace {

/// The settings and curves of a calibration, from its table and blocks.
class Calibration {
 public:
  explicit Calibration(const SearchInput& input)
      : data_(input.data), read_(input.read), base_(input.base), problems_(input.problems) {}

  void add() {
    const CalibrateTable& table = data_.settings.calibrate;
    CalibrateSettings& settings = data_.calibrate;
    settings.test = table.test;
    settings.outcome = table.outcome;
    settings.tolerance = table.tolerance;
    settings.budget = table.budget;
    settings.confidence = table.confidence;
    if (read_.blocks.specimen.empty() && problems_.empty()) {
      problems_.add(base_.origin_of("calibrate.data"), "calibrate.data",
                    "missing; name the files with the measured curves");
    }
    for (std::size_t i = 0; i < read_.blocks.specimen.size(); ++i) add_specimen(read_.blocks.specimen[i]);
    check_device();
  }

 private:
  void add_specimen(const SpecimenBlock& block) {
    const CurveTest test = data_.calibrate.test;
    const std::string over(column_over(test)), measured(column_measured(test));
    const std::vector<double>& x = over == "time_s" ? block.time_s : block.closure_m;
    const std::vector<double>& y = measured == "force_N" ? block.force_N : block.closure_m;
    const auto complain = [&](const std::string& what, const std::string& rule) {
      problems_.add(block.origin, what, "of specimen " + toml_string(block.name) + " " + rule);
    };
    if (!names_.insert(block.name).second) return complain("specimen", "is there twice");
    if (x.size() != y.size()) return complain(over, "and " + measured + " must be as many");
    // One point more than keys tells how far the measurements scatter; of two points nothing is a curve.
    const std::size_t fewest = std::max<std::size_t>(3, read_.blocks.parameter.size() + 1);
    if (x.size() < fewest) {
      return complain(measured, "has " + std::to_string(x.size()) + " points; " + std::to_string(fewest) +
                                    " at least are needed, more than there are keys");
    }
    const bool rises = std::is_sorted(x.begin(), x.end(), [](double a, double b) { return a <= b; });
    if (!rises || x.front() < 0.0) return complain(over, "must rise from 0 on");
    if (std::all_of(y.begin(), y.end(), [&](double value) { return value == y.front(); })) {
      return complain(measured, "is the same at all points: nothing can be fitted to it");
    }
    data_.calibrate.curves.push_back({block.name, x, y, block.outcome});
  }

  /// What presses: fingers, or a load on a network.
  void check_device() {
    const Scenario& base = data_.bases.front();
    const auto* network = std::get_if<NetworkParameters>(&base.product);
    if (has_gripper(base) || (network != nullptr && !network->load.empty())) return;
    problems_.add(base_.origin_of("study.kind"), "study.kind", "\"calibrate\"",
                  "needs a [gripper], or a network with a [[product.load]]: something that presses");
  }

  StudyData& data_;
  const ReadBlocks& read_;
  const Assembly& base_;
  Problems& problems_;
  std::set<std::string> names_;
};

}  // namespace

void add_curves(const SearchInput& input) { Calibration(input).add(); }

}  // namespace unbruised::studies
