#include "studies/config/document.hpp"

// The compiled toml++ of Debian has its asserts built in and would abort on typing slips such as `[.]`;
// only the header-only form obeys TOML_ASSERT.
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(expr) static_cast<void>(0)
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <toml++/toml.h>

#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{4} << 20;
/// Dots of one key: each opens a table inside the last, and 100,000 of them exhaust the stack. Ours have three at
/// most.
constexpr int kMaxKeyDots = 16;

/// Length of the UTF-8 sequence that starts at `at`; 0 when it is none (RFC 3629: no overlong forms, no
/// surrogates).
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first <= 0xDFU) return follows(1) ? 2 : 0;
  if (first >= 0xE0U && first <= 0xEFU) {
    const unsigned lowest = first == 0xE0U ? 0xA0U : 0x80U;
    const unsigned highest = first == 0xEDU ? 0x9FU : 0xBFU;
    return byte(1) >= lowest && byte(1) <= highest && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0U && first <= 0xF4U) {
    const unsigned lowest = first == 0xF0U ? 0x90U : 0x80U;
    const unsigned highest = first == 0xF4U ? 0x8FU : 0xBFU;
    return byte(1) >= lowest && byte(1) <= highest && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

struct Complaint {
  int line;
  std::string text;
};

/// Where in the grammar a bare character stands: in a key, before a value or in one. toml++ looks for the end of a
/// value that is no string with a function whose behaviour is undefined for most letters beyond ASCII, and takes
/// quotes in it for letters.
class Grammar {
 public:
  void take(char c) {
    switch (c) {
      case ' ':
      case '\t':
      case '\r':
        return;
      case '\n':
        if (open_.empty()) in_value_ = false;
        return;
      case ',':
        in_value_ = !open_.empty() && open_.back() == '[';
        begun_ = false;
        return;
      case '=':
        begun_ = in_value_;
        in_value_ = true;
        return;
      case '[':
      case '{':
        if (!in_value_ || begun_) return;
        open_.push_back(c);
        in_value_ = c == '[';
        return;
      case ']':
      case '}':
        if (open_.empty()) return;
        open_.pop_back();
        in_value_ = begun_ = true;
        return;
      default:
        begun_ = in_value_;
    }
  }
  /// At a quote: false inside a value that has begun.
  bool opens_string() {
    if (in_value_ && begun_) return false;
    begun_ = in_value_;
    return true;
  }

 private:
  std::string open_;       // brackets of values
  bool in_value_ = false;  // after `=`, or in an array
  bool begun_ = false;     // the value has a first character
};

/// Walks over the text once, knowing what is a string and what a comment.
std::optional<Complaint> guard(std::string_view text) {
  if (text.size() > kMaxBytes) return Complaint{1, "the file is larger than 4 MiB"};
  enum class Place { bare, comment, basic, literal, basic_block, literal_block };
  Place place = Place::bare;
  Grammar grammar;
  int line = 1;
  int dots = 0;
  const auto triple = [&](std::size_t at, char quote) {
    return at + 2 < text.size() && text[at] == quote && text[at + 1] == quote && text[at + 2] == quote;
  };
  std::size_t at = text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '\0') return Complaint{line, "a NUL byte: this is not a text file"};
    const std::size_t length = utf8_length(text, at);
    if (length == 0) return Complaint{line, "the text is not valid UTF-8"};
    if (length > 1 && place == Place::bare) {
      return Complaint{line, "the character '" + std::string(text.substr(at, length)) +
                                 "' may stand only in comments and quoted strings"};
    }
    if (place == Place::bare) {
      if (c == '.' && ++dots > kMaxKeyDots) return Complaint{line, "a key of more than 17 parts"};
      if (c == '=' || c == ',' || c == '[' || c == '{' || c == '\n') dots = 0;
    }
    std::size_t step = length;
    if (c == '\n') {
      ++line;
      if (place != Place::basic_block && place != Place::literal_block) {
        place = Place::bare;
        grammar.take(c);
      }
    } else if (place == Place::bare && c == '#') {
      place = Place::comment;
    } else if (place == Place::bare && c != '"' && c != '\'') {
      grammar.take(c);
    } else if (place == Place::bare) {
      if (grammar.opens_string()) {
        const bool block = triple(at, c);
        if (c == '"') place = block ? Place::basic_block : Place::basic;
        if (c == '\'') place = block ? Place::literal_block : Place::literal;
        if (block) step = 3;
      }
    } else if ((place == Place::basic || place == Place::basic_block) && c == '\\') {
      if (at + 1 < text.size() && text[at + 1] != '\n' && static_cast<unsigned char>(text[at + 1]) < 0x80U)
        step = 2;
      if (step == 2 && text[at + 1] == '\0') step = 1;
    } else if ((place == Place::basic && c == '"') || (place == Place::literal && c == '\'')) {
      place = Place::bare;
    } else if ((place == Place::basic_block && triple(at, '"')) ||
               (place == Place::literal_block && triple(at, '\''))) {
      step = 3;
      while (at + step < text.size() && text[at + step] == c && step < 5) ++step;
      place = Place::bare;
    }
    at += step;
  }
  return std::nullopt;
}

Value converted(const toml::node& node) {
  Value value;
  if (const auto* integer = node.as_integer()) {
    value.kind = Value::Kind::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(value.integer);
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = Value::Kind::number;
    value.number = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = Value::Kind::boolean;
    value.boolean = boolean->get();
  } else if (const auto* text = node.as_string()) {
    value.kind = Value::Kind::text;
    value.text = text->get();
  } else if (const auto* array = node.as_array()) {
    value.kind = Value::Kind::array;
    for (const toml::node& item : *array) value.items.push_back(converted(item));
  } else {
    value.text = node.is_table() ? "{...}" : "a date or time";
  }
  return value;
}

bool is_bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

bool is_table_array(const toml::node& node) {
  const auto* array = node.as_array();
  return array != nullptr && !array->empty() &&
         std::all_of(array->begin(), array->end(), [](const toml::node& item) { return item.is_table(); });
}

struct Flattener {
  Document& document;
  std::shared_ptr<const std::string> file;
  int rank;

  [[nodiscard]] Origin origin(const toml::source_region& region) const {
    return {file, rank, static_cast<int>(region.begin.line)};
  }

  void table(const toml::table& content, const std::string& path, Origin where) {
    if (!path.empty()) document.tables.push_back({path, {}, std::move(where)});
    for (const auto& [key, node] : content) {
      const std::string leaf = is_bare(key.str()) ? std::string(key.str()) : toml_string(key.str());
      const std::string child = path.empty() ? leaf : path + "." + leaf;
      if (const auto* sub = node.as_table()) {
        table(*sub, child, origin(key.source()));
      } else if (is_table_array(node)) {
        std::size_t index = 0;
        for (const toml::node& item : *node.as_array()) {
          table(*item.as_table(), child + "[" + std::to_string(index++) + "]", origin(item.source()));
        }
      } else {
        document.entries.push_back({child, converted(node), origin(key.source())});
      }
    }
  }
};

}  // namespace

std::string Origin::text() const { return file ? *file + ":" + std::to_string(line) : "--set"; }

Value number_value(double number) {
  Value value;
  value.kind = Value::Kind::number;
  value.number = number;
  return value;
}

Value text_value(std::string text) {
  Value value;
  value.kind = Value::Kind::text;
  value.text = std::move(text);
  return value;
}

std::string rounded(double value) {
  std::array<char, 32> text{};
  constexpr int kDigits = 6;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, kDigits);
  return {text.data(), end.ptr};
}

std::string toml_string(std::string_view text) {
  static constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (byte < 0x20 || byte == 0x7F) {
      out += "\\u00";
      out += kHex[byte >> 4U];
      out += kHex[byte & 15U];
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string spelled(const Value& value) {
  switch (value.kind) {
    case Value::Kind::number:
      return spelled(value.number);
    case Value::Kind::integer:
      return std::to_string(value.integer);
    case Value::Kind::boolean:
      return value.boolean ? "true" : "false";
    case Value::Kind::text:
      return toml_string(value.text);
    case Value::Kind::other:
      return value.text;
    case Value::Kind::array:
      break;
  }
  return joined({"[", comma_list(value.items, [](const Value& item) { return spelled(item); }), "]"});
}

Document parse_document(std::string_view text, const std::shared_ptr<const std::string>& file, int rank) {
  Document document;
  if (const auto complaint = guard(text)) {
    document.problems.push_back({{file, rank, complaint->line}, complaint->text});
    return document;
  }
  try {
    Flattener flattener{document, file, rank};
    flattener.table(toml::parse(text, *file), "", {});
  } catch (const toml::parse_error& error) {
    document.entries.clear();
    document.tables.clear();
    document.problems.push_back({{file, rank, static_cast<int>(error.source().begin.line)},
                                 "not valid TOML: " + std::string(error.description())});
    return document;
  }
  const auto by_line = [](const Entry& a, const Entry& b) { return a.origin.line < b.origin.line; };
  std::stable_sort(document.entries.begin(), document.entries.end(), by_line);
  std::stable_sort(document.tables.begin(), document.tables.end(), by_line);
  return document;
}

std::vector<Value> parse_literal(const std::string& literal) {
  if (literal.find_first_of("\n\r#") != std::string::npos) return {};
  const std::string text = "v = " + literal;
  if (guard(text)) return {};
  try {
    const toml::table parsed = toml::parse(text);
    const toml::node* node = parsed.get("v");
    if (parsed.size() != 1 || node == nullptr) return {};
    return {converted(*node)};
  } catch (const toml::parse_error&) {
    return {};
  }
}

}  // namespace unbruised::studies
