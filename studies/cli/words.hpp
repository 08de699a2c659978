#pragma once

/// @file
/// Which words of a command line are studies, and which say what a key is.

#include <filesystem>
#include <string>
#include <system_error>

namespace unbruised::studies {

inline bool is_option(const std::string& word) { return word.size() > 1 && word.front() == '-'; }

inline bool is_file(const std::string& word) {
  std::error_code error;
  return std::filesystem::exists(word, error);
}

/// A word that says what a key is, where it stands free or after --set. A study may have such a name, if it
/// exists.
inline bool is_set_word(const std::string& word) { return word.find('=') != std::string::npos && !is_file(word); }

/// --set takes all words that follow it; a study may be among them.
inline bool is_study_word(const std::string& word) { return word.ends_with(".toml") || is_file(word); }

}  // namespace unbruised::studies
