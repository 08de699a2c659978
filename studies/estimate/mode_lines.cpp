#include "studies/estimate/mode_lines.hpp"

#include "core/scenario/body_modes.hpp"
#include "core/simulation/simulation.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

std::vector<std::string> mode_lines(const Study& study) {
  const Scenario scenario = study.scenario(0);
  if (mode_count(scenario) == 0) return {};
  std::string error;
  const auto model = Model::build(scenario, error);
  if (!model || !model->modes()) return {joined({"modes: ", error})};
  const ModeSummary& modes = *model->modes();
  return {joined({"modes: ", with_thousands(modes.deforming), ", up to ", three_digits(modes.fastest_Hz),
                  " Hz; of the product's give at the poles they leave ",
                  three_digits(100.0 * modes.left_out_share), " % to answer at once"})};
}

}  // namespace unbruised::studies
