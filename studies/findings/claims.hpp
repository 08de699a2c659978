#pragma once

/// @file
/// What an answer may claim about damage: the one place that knows whether anything looked at it, and the words
/// for it. "Undamaged" means something only where some limit of damage could have been exceeded.

#include <cstddef>
#include <string>
#include <string_view>

#include "core/scenario/scenario.hpp"
#include "studies/config/study.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

enum class DamageClaim {
  judged,          ///< a limit of damage can act
  not_considered,  ///< limits.damage = "not considered": left out on purpose
  not_looked_at,   ///< no limit of damage can act, and nobody said that this is meant
};

/// "judged", "not considered", "not looked at": the attribute `damage` of results.h5 and the field of the page.
std::string_view damage_word(DamageClaim claim);
/// "damage was not considered", "damage was not looked at"; empty for `judged`.
std::string_view damage_remark(DamageClaim claim);

DamageClaim damage_claim(const Scenario& scenario);

/// The claim of a study: of the scenario of which least may be said, never an average.
struct StudyClaim {
  DamageClaim claim = DamageClaim::judged;
  std::size_t judged = 0;  ///< scenarios in which damage is judged
  std::size_t count = 0;   ///< scenarios known beforehand
};
StudyClaim damage_claim(const Study& study);

/// One sentence for the reader of the answer; empty where damage is judged in every scenario.
std::string damage_sentence(const StudyClaim& claim);

/// What `held` may be called: "held without damage", or "held" where some scenario's damage is not judged.
/// @param damage_note the sentence above
std::string_view held_words(std::string_view damage_note);

/// Writes the claim of a study where every reader of its results finds it.
void set_damage(ResultsMeta& meta, const Study& study);
/// The sentence that results carry; of a file that carries none, that it says nothing about damage.
std::string damage_sentence(const ResultsMeta& meta);

}  // namespace unbruised::studies
