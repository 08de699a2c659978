#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

namespace {

std::vector<std::string_view> kind_words() {
  std::vector<std::string_view> words;
  for (const StudyKindRow& row : study_kind_table()) words.push_back(row.word);
  return words;
}

/// What each kind asks.
std::string_view kind_meaning() {
  static const std::string meaning = [] {
    std::string text = "What is asked:";
    for (const StudyKindRow& row : study_kind_table()) {
      text += std::string(&row == study_kind_table().data() ? " " : "; ") + std::string(row.word) + ": " +
              std::string(row.asks);
    }
    return text + ".";
  }();
  return meaning;
}

}  // namespace

Table study_keys() {
  return {
      {.path = "study.name",
       .type = text,
       .meaning = "Name of the study and of its run directory.",
       .required = true,
       .note = "1 to 64 letters, digits, '_' or '-'",
       .study_field = study<&StudySettings::name>},
      {.path = "study.kind",
       .type = choice,
       .meaning = kind_meaning(),
       .choices = kind_words(),
       .required = true,
       .study_field = study<&StudySettings::kind>},
      {.path = "study.seed",
       .type = integer,
       .meaning = "Seed of everything random.",
       .range = kNotNegative,
       .study_field = study<&StudySettings::seed>},
      {.path = "study.description",
       .type = text,
       .meaning = "One line for reports and lists.",
       .study_field = study<&StudySettings::description>},
      {.path = "window.from_N",
       .type = number,
       .meaning = "Smallest grip force that is tried.",
       .range = kPositive,
       .use = Use::window,
       .required = true,
       .note = "< window.to_N",
       .study_field = window<&WindowSettings::from_N>},
      {.path = "window.to_N",
       .type = number,
       .meaning = "Largest grip force that is tried.",
       .range = kPositive,
       .use = Use::window,
       .required = true,
       .note = "<= gripper.max_force_N",
       .study_field = window<&WindowSettings::to_N>},
      {.path = "window.tolerance",
       .type = number,
       .meaning = "Relative width at which the search for either end of the window stops.",
       .range = {0.0, true, 1.0, true},
       .use = Use::window,
       .study_field = window<&WindowSettings::tolerance>},
  };
}

}  // namespace unbruised::studies::key_rows
