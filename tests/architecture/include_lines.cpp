#include "tests/architecture/include_lines.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>

namespace unbruised {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Length of what starts at `at` and ends with `end`, both included; to the end of the text where it never ends.
std::size_t length_until(std::string_view text, std::size_t at, std::string_view end, std::size_t skip) {
  const std::size_t found = text.find(end, at + skip);
  return (found == std::string_view::npos ? text.size() : found + end.size()) - at;
}

/// Length of the quoted literal at `at`, with its escapes.
std::size_t literal_length(std::string_view text, std::size_t at) {
  const char quote = text[at];
  std::size_t i = at + 1;
  while (i < text.size() && text[i] != quote && text[i] != '\n') i += text[i] == '\\' ? 2 : 1;
  return std::min(i + 1, text.size()) - at;
}

bool continues_a_word(std::string_view text, std::size_t at) {
  return at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
}

/// Length of the comment or literal that starts at `at`; 0: none does.
std::size_t blank_length(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size()) - at;
  if (rest.starts_with("/*")) return length_until(text, at, "*/", 2);
  if (rest.starts_with("R\"") && !continues_a_word(text, at)) {
    const std::string_view delimiter = rest.substr(2, rest.find('(') - 2);
    return length_until(text, at, ")" + std::string(delimiter) + "\"", 2 + delimiter.size());
  }
  if (rest[0] == '"') return literal_length(text, at);
  // 1'000 separates digits; 'a' is a character.
  if (rest[0] == '\'' && !continues_a_word(text, at)) return literal_length(text, at);
  return 0;
}

/// Is the quote at `at` the opening one of an include line?
bool opens_an_include(std::string_view text, std::size_t at) {
  const std::size_t start = text.rfind('\n', at) + 1;  // npos + 1 is 0
  std::string head(text.substr(start, at - start));
  std::erase_if(head, [](char c) { return c == ' ' || c == '\t'; });
  return head == "#include";
}

}  // namespace

std::string without_comments_and_literals(std::string_view text) {
  std::string code(text);
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = blank_length(text, at);
    if (length == 0) {
      ++at;
      continue;
    }
    if (!(text[at] == '"' && opens_an_include(text, at))) {
      std::replace_if(
          code.begin() + static_cast<std::ptrdiff_t>(at), code.begin() + static_cast<std::ptrdiff_t>(at + length),
          [](char c) { return c != '\n'; }, ' ');
    }
    at += length;
  }
  return code;
}

std::vector<IncludeLine> include_lines(std::string_view text, const std::string& file) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*([<"])([^">]+)[">].*$)");
  std::vector<IncludeLine> includes;
  std::istringstream in(without_comments_and_literals(text));
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::smatch match;
    if (std::regex_match(line, match, kInclude)) includes.push_back({file, number, match[2], match[1] == "\""});
  }
  return includes;
}

std::vector<SourceFile> read_sources(const fs::path& repository, const std::vector<std::string>& houses) {
  std::vector<SourceFile> sources;
  for (const std::string& house : houses) {
    if (!fs::is_directory(repository / house)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(repository / house)) {
      const fs::path extension = entry.path().extension();
      if (!entry.is_regular_file() || (extension != ".hpp" && extension != ".cpp")) continue;
      const std::string text = read_file(entry.path());
      const std::string path = fs::relative(entry.path(), repository).generic_string();
      sources.push_back({path, without_comments_and_literals(text), include_lines(text, path)});
    }
  }
  std::sort(sources.begin(), sources.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return sources;
}

}  // namespace unbruised
