#pragma once

/// @file
/// Reads what C++ sources include, and the sources without their comments.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace unbruised {

/// One `#include` of one file.
struct IncludeLine {
  std::string file;    ///< including file, relative to the repository, e.g. "core/motion/profile.cpp"
  int line = 0;        ///< 1-based
  std::string target;  ///< what stands between the quotes or brackets
  bool quoted = false;
};

/// One file of C++.
struct SourceFile {
  std::string path;  ///< relative to the repository
  std::string code;  ///< without comments and without the contents of string and character literals
  std::vector<IncludeLine> includes;
};

/// `text` with comments and literals blanked out, line breaks kept. Raw strings are known.
std::string without_comments_and_literals(std::string_view text);

/// The include lines of `text`; commented ones do not count.
std::vector<IncludeLine> include_lines(std::string_view text, const std::string& file);

/// Every .hpp and .cpp below the named houses of `repository`, sorted by path.
std::vector<SourceFile> read_sources(const std::filesystem::path& repository,
                                     const std::vector<std::string>& houses);

}  // namespace unbruised
