// The whole way of a study's text: guard, toml++, schema, vary and search blocks, goals, rules; no folder, so no
// other file. A line of 0x1F ends the text; each line behind it is the value of a --set.

#include <string>
#include <variant>
#include <vector>

#include "core/simulation/simulation.hpp"
#include "studies/config/study.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace unbruised::studies;
using unbruised::fuzz::require;

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

/// An accepted study has scenarios the simulator accepts, and a resolved text that reads back to the same study.
void check_accepted(const Study& study) {
  const std::size_t last = study.scenario_count() - 1;
  for (const std::size_t id : {std::size_t{0}, last / 2, last}) (void)study.scenario(id);
  const StudyOrError again = read_study_text(study.resolved_toml(), "resolved.toml", {}, "", "");
  if (!again) {
    for (const std::string& line : again.error().messages) std::fprintf(stderr, "%s\n", line.c_str());
    std::fprintf(stderr, "%s\n", study.resolved_toml().c_str());
  }
  require(again.has_value(), "the resolved text of an accepted study is accepted");
  const std::string& text = again->resolved_toml();
  if (text != study.resolved_toml())
    std::fprintf(stderr, "%s\nbecomes\n%s\n", study.resolved_toml().c_str(), text.c_str());
  require(text == study.resolved_toml(), "the resolved text reads back to the same study");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input = unbruised::fuzz::text_of(data, size);
  const std::size_t split = input.find('\x1F');
  const bool has_sets = split != std::string_view::npos;
  const std::vector<std::string> sets = has_sets ? lines_of(input.substr(split + 1)) : std::vector<std::string>{};
  const StudyOrError result = read_study_text(input.substr(0, split), "study.toml", sets, "", "");
  if (result) {
    check_accepted(*result);
  } else {
    const auto& messages = result.error().messages;
    require(!messages.empty(), "a refused study says why");
    for (const std::string& line : messages) require(line.find('\0') == std::string::npos, "a message is text");
  }
  return 0;
}
