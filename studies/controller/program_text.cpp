#include "studies/controller/program_text.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include "core/door/require.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

/// What comes at an end of a move comes before or after it.
bool is_within(double time_s, const ProgramMove& move) {
  constexpr double kRounding_s = 1e-6;
  return time_s > move.start_s + kRounding_s && time_s < move.end_s - kRounding_s;
}

}  // namespace

std::string fixed_digits(double value, int digits) {
  std::array<char, 400> text{};
  const auto written = std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed, digits);
  require(written.ec == std::errc(), "fixed_digits: the number is too long");
  std::string number(text.data(), written.ptr);
  const bool is_zero = number.find_first_not_of("-0.") == std::string::npos;
  return is_zero && number.front() == '-' ? number.substr(1) : number;
}

std::string comment_lines(const std::vector<std::string>& lines, std::string_view sign) {
  std::string text;
  for (std::string line : lines) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    text += joined({sign, " ", line, "\n"});
  }
  return text;
}

std::string grip_call(const GripCommand& command) {
  switch (command.kind) {
    case GripCommand::Kind::close:
      return joined(
          {"grip_close(", fixed_digits(command.speed_m_s, 6), ", ", fixed_digits(command.force_N, 6), ")"});
    case GripCommand::Kind::grip:
      return joined({"grip_force(", fixed_digits(command.force_N, 6), ", ", fixed_digits(command.ramp_s, 6), ")"});
    case GripCommand::Kind::lock:
      return "grip_lock()";
    case GripCommand::Kind::open:
      return joined({"grip_open(", fixed_digits(command.speed_m_s, 6), ")"});
  }
  return {};
}

std::vector<ProgramStep> steps_of(const HandlingProgram& program) {
  std::vector<ProgramStep> steps;
  for (const GripCommand& command : program.commands()) {
    const bool moves = std::ranges::any_of(
        program.moves(), [&](const ProgramMove& move) { return is_within(command.time_s, move); });
    if (!moves) steps.push_back({&command, {command.time_s, command.time_s}});
  }
  for (const ProgramMove& move : program.moves()) steps.push_back({nullptr, move});
  std::ranges::stable_sort(
      steps, [](const ProgramStep& a, const ProgramStep& b) { return a.move.start_s < b.move.start_s; });
  return steps;
}

std::vector<const GripCommand*> commands_within(const HandlingProgram& program, const ProgramMove& move) {
  std::vector<const GripCommand*> found;
  for (const GripCommand& command : program.commands()) {
    if (is_within(command.time_s, move)) found.push_back(&command);
  }
  return found;
}

}  // namespace unbruised::studies
