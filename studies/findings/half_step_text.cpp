#include "studies/findings/half_step_text.hpp"

#include <cmath>

#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

std::vector<EndMove> half_step_moves(const WindowRow& row) {
  std::vector<EndMove> moves;
  const auto add = [&](const char* name, double as_found_N, double half_step_N) {
    if (!std::isnan(half_step_N)) moves.push_back({name, as_found_N, half_step_N, half_step_N / as_found_N - 1.0});
  };
  add("F_hold", row.hold_bracket_high_N, row.hold_force_half_step_N);
  add("F_damage", row.damage_bracket_low_N, row.damage_force_half_step_N);
  return moves;
}

std::string move_text(const EndMove& move) {
  if (move.relative == 0.0) return joined({move.name, " stays at ", short_number(move.as_found_N), " N"});
  if (std::isinf(move.half_step_N)) return joined({"no force that was tried holds"});
  if (move.half_step_N <= 0.0) return joined({"every force that was tried damages"});
  return joined({move.name, move.relative < 0.0 ? " falls" : " rises", " from ", short_number(move.as_found_N),
                 " to ", short_number(move.half_step_N), " N (", signed_percent(move.relative), ")"});
}

}  // namespace unbruised::studies
