#include <algorithm>
#include <cmath>

#include "studies/config/schema.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

std::string type_rule(const KeySpec& spec) {
  const Unit* unit = unit_of(spec.path);
  const std::string in = unit == nullptr ? "" : " in " + std::string(unit->display);
  const std::string n = std::to_string(spec.size);
  switch (spec.type) {
    case KeyType::number:
      return "must be a number" + in;
    case KeyType::optional_number:
      return "must be a number" + in + (spec.required ? "" : ", or \"none\"");
    case KeyType::integer:
      return "must be an integer";
    case KeyType::boolean:
      return "must be true or false";
    case KeyType::text:
      return "must be a string";
    case KeyType::choice:
      return "must be one of " + choices_text(spec);
    case KeyType::numbers:
      return "must be an array of " + n + " numbers" + in;
    case KeyType::maybe_numbers:
      return "must be an array of " + n + " numbers" + in + ", or \"none\"";
    case KeyType::integers:
      return "must be an array of " + n + " integers";
    case KeyType::axes:
      return "must be an array of the axes \"x\", \"y\", \"z\"";
    case KeyType::series:
      return "must be an array of numbers" + in;
    case KeyType::vector_series:
      return "must be an array of [x, y, z]" + in;
    case KeyType::texts:
      return "must be an array of strings";
    case KeyType::any_array:
      return "must be a non-empty array of numbers, of strings or of booleans";
  }
  return "";
}

using Rule = std::optional<std::string>;

Rule check_number(const KeySpec& spec, const Value& value) {
  const bool whole = spec.type == KeyType::integer || spec.type == KeyType::integers;
  const bool is_whole = value.kind == Value::Kind::integer ||
                        (value.kind == Value::Kind::number && std::floor(value.number) == value.number);
  if (!value.is_number() || (whole && !is_whole)) return type_rule(spec);
  if (!std::isfinite(value.number)) return "must be finite";
  if (!spec.range.contains(value.number)) return "must be " + spec.range.text();
  return std::nullopt;
}

Rule check_items(const KeySpec& spec, const Value& value, int size) {
  if (value.kind != Value::Kind::array) return type_rule(spec);
  if (size > 0 && value.items.size() != static_cast<std::size_t>(size)) return type_rule(spec);
  for (const Value& item : value.items) {
    if (!item.is_number()) return type_rule(spec);
    if (const Rule rule = check_number(spec, item)) return "each " + *rule;
  }
  return std::nullopt;
}

Rule check_words(const KeySpec& spec, const Value& value) {
  if (spec.type == KeyType::choice) {
    const bool known = value.kind == Value::Kind::text &&
                       std::find(spec.choices.begin(), spec.choices.end(), value.text) != spec.choices.end();
    return known ? Rule{} : type_rule(spec) + word_suggestion(value.text, spec.choices);
  }
  if (value.kind != Value::Kind::array) return type_rule(spec);
  for (const Value& item : value.items) {
    if (item.text != "x" && item.text != "y" && item.text != "z") return type_rule(spec);
  }
  return std::nullopt;
}

void assign_axes(std::array<bool, 3>& fixed, const Value& value) {
  fixed = {false, false, false};
  for (const Value& item : value.items) fixed[static_cast<std::size_t>(item.text[0] - 'x')] = true;
}

std::array<double, 3> vector_of(const Value& value) {
  return {value.items[0].number, value.items[1].number, value.items[2].number};
}

/// The number inside a field, by element indices; nullptr when there is none.
double* number_slot(FieldRef field, const std::vector<int>& at) {
  if (auto* const* number = std::get_if<double*>(&field)) return at.empty() ? *number : nullptr;
  if (const auto* span = std::get_if<NumberSpan>(&field)) {
    return at.size() == 1 && at[0] < span->size ? span->data + at[0] : nullptr;
  }
  if (const auto* span = std::get_if<MaybeSpan>(&field)) {
    double* data = span->data(span->object);
    return data != nullptr && at.size() == 1 && at[0] < span->size ? data + at[0] : nullptr;
  }
  if (auto* const* series = std::get_if<std::vector<double>*>(&field)) {
    const bool inside = at.size() == 1 && static_cast<std::size_t>(at[0]) < (*series)->size();
    return inside ? &(**series)[static_cast<std::size_t>(at[0])] : nullptr;
  }
  if (auto* const* series = std::get_if<std::vector<std::array<double, 3>>*>(&field)) {
    const bool inside = at.size() == 2 && static_cast<std::size_t>(at[0]) < (*series)->size() && at[1] < 3;
    return inside ? &(**series)[static_cast<std::size_t>(at[0])][static_cast<std::size_t>(at[1])] : nullptr;
  }
  return nullptr;
}

int* integer_slot(FieldRef field, const std::vector<int>& at) {
  if (auto* const* number = std::get_if<int*>(&field)) return at.empty() ? *number : nullptr;
  if (const auto* span = std::get_if<IntegerSpan>(&field)) {
    return at.size() == 1 && at[0] < span->size ? span->data + at[0] : nullptr;
  }
  return nullptr;
}

template <typename Items, typename Spell>
std::string array_text(const Items& items, Spell spell) {
  return "[" + comma_list(items, spell) + "]";
}

std::string spelled_vector(const std::array<double, 3>& v) {
  return array_text(v, [](double x) { return spelled(x); });
}

}  // namespace

std::optional<std::string> check_value(const KeySpec& spec, const Value& value, std::size_t element_depth) {
  if (element_depth > 0) return value.is_number() ? check_number(spec, value) : Rule("must be a number");
  switch (spec.type) {
    case KeyType::optional_number:
      if (!spec.required && value.kind == Value::Kind::text && value.text == "none") return std::nullopt;
      [[fallthrough]];
    case KeyType::number:
    case KeyType::integer:
      return check_number(spec, value);
    case KeyType::boolean:
      return value.kind == Value::Kind::boolean ? Rule{} : type_rule(spec);
    case KeyType::text:
      return value.kind == Value::Kind::text ? Rule{} : type_rule(spec);
    case KeyType::choice:
    case KeyType::axes:
      return check_words(spec, value);
    case KeyType::maybe_numbers:
      if (value.kind == Value::Kind::text && value.text == "none") return std::nullopt;
      [[fallthrough]];
    case KeyType::numbers:
    case KeyType::integers:
    case KeyType::series:
      return check_items(spec, value, spec.size);
    case KeyType::vector_series:
      if (value.kind != Value::Kind::array) return type_rule(spec);
      for (const Value& item : value.items) {
        if (check_items(spec, item, 3)) return type_rule(spec);
      }
      return std::nullopt;
    case KeyType::texts: {
      const bool all = value.kind == Value::Kind::array &&
                       std::all_of(value.items.begin(), value.items.end(),
                                   [](const Value& item) { return item.kind == Value::Kind::text; });
      return all ? Rule{} : type_rule(spec);
    }
    case KeyType::any_array: {
      if (value.kind != Value::Kind::array || value.items.empty()) return type_rule(spec);
      const Value& first = value.items.front();
      const bool same = std::all_of(value.items.begin(), value.items.end(), [&](const Value& item) {
        return item.kind == first.kind || (item.is_number() && first.is_number());
      });
      const bool simple = first.kind != Value::Kind::array && first.kind != Value::Kind::other;
      return same && simple ? Rule{} : type_rule(spec);
    }
  }
  return std::nullopt;
}

void assign_number(FieldRef field, double number, const std::vector<int>& elements) {
  if (double* slot = number_slot(field, elements)) {
    *slot = number;
  } else if (int* integer = integer_slot(field, elements)) {
    *integer = static_cast<int>(number);
  } else if (auto* const* whole = std::get_if<std::uint64_t*>(&field)) {
    **whole = static_cast<std::uint64_t>(number);
  } else if (auto* const* maybe = std::get_if<std::optional<double>*>(&field)) {
    **maybe = number;
  }
}

void assign(const KeySpec& spec, FieldRef field, const Value& value, const std::vector<int>& elements) {
  if (value.is_number()) {
    if (auto* const* whole = std::get_if<std::uint64_t*>(&field);
        whole != nullptr && value.kind == Value::Kind::integer) {
      **whole = static_cast<std::uint64_t>(value.integer);
    } else {
      assign_number(field, value.number, elements);
    }
  } else if (auto* const* maybe = std::get_if<std::optional<double>*>(&field)) {
    **maybe = std::nullopt;
  } else if (auto* const* flag = std::get_if<bool*>(&field)) {
    **flag = value.boolean;
  } else if (auto* const* text = std::get_if<std::string*>(&field)) {
    **text = value.text;
  } else if (const auto* choice = std::get_if<ChoiceRef>(&field)) {
    const auto word = std::find(spec.choices.begin(), spec.choices.end(), value.text);
    choice->set(choice->object, static_cast<int>(word - spec.choices.begin()));
  } else if (auto* const* fixed = std::get_if<std::array<bool, 3>*>(&field)) {
    assign_axes(**fixed, value);
  } else if (auto* const* texts = std::get_if<std::vector<std::string>*>(&field)) {
    (*texts)->clear();
    for (const Value& item : value.items) (*texts)->push_back(item.text);
  } else if (auto* const* vectors = std::get_if<std::vector<std::array<double, 3>>*>(&field)) {
    (*vectors)->clear();
    for (const Value& item : value.items) (*vectors)->push_back(vector_of(item));
  } else {
    if (const auto* span = std::get_if<MaybeSpan>(&field)) span->give(span->object, !value.items.empty());
    if (auto* const* series = std::get_if<std::vector<double>*>(&field)) (*series)->resize(value.items.size());
    for (std::size_t i = 0; i < value.items.size(); ++i) {
      assign_number(field, value.items[i].number, {static_cast<int>(i)});
    }
  }
}

std::optional<double> number_at(FieldRef field, const std::vector<int>& elements) {
  if (const double* slot = number_slot(field, elements)) return *slot;
  if (const int* integer = integer_slot(field, elements)) return *integer;
  if (auto* const* maybe = std::get_if<std::optional<double>*>(&field)) return **maybe;
  return std::nullopt;
}

bool has_element(FieldRef field, const std::vector<int>& elements) {
  return elements.empty() || number_slot(field, elements) != nullptr || integer_slot(field, elements) != nullptr;
}

std::string spelled(const KeySpec& spec, FieldRef field) {
  struct Speller {
    const KeySpec& spec;
    std::string operator()(const double* x) const { return spelled(*x); }
    std::string operator()(const std::optional<double>* x) const { return *x ? spelled(**x) : ""; }
    std::string operator()(const int* x) const { return std::to_string(*x); }
    std::string operator()(const std::uint64_t* x) const { return std::to_string(*x); }
    std::string operator()(const bool* x) const { return *x ? "true" : "false"; }
    std::string operator()(const std::string* x) const { return x->empty() ? "" : toml_string(*x); }
    std::string operator()(const ChoiceRef& x) const {
      return toml_string(spec.choices[static_cast<std::size_t>(x.get(x.object))]);
    }
    std::string operator()(const NumberSpan& x) const {
      return array_text(std::vector<double>(x.data, x.data + x.size), [](double v) { return spelled(v); });
    }
    std::string operator()(const MaybeSpan& x) const {
      const double* data = x.data(x.object);
      return data == nullptr
                 ? ""
                 : array_text(std::vector<double>(data, data + x.size), [](double v) { return spelled(v); });
    }
    std::string operator()(const IntegerSpan& x) const {
      return array_text(std::vector<int>(x.data, x.data + x.size), [](int v) { return std::to_string(v); });
    }
    std::string operator()(const std::array<bool, 3>* x) const {
      std::vector<std::string> words;
      for (std::size_t i = 0; i < 3; ++i) {
        if ((*x)[i]) words.push_back(std::string("\"") + static_cast<char>('x' + static_cast<int>(i)) + "\"");
      }
      return "[" + comma_list(words) + "]";
    }
    std::string operator()(const std::vector<double>* x) const {
      return array_text(*x, [](double v) { return spelled(v); });
    }
    std::string operator()(const std::vector<std::array<double, 3>>* x) const {
      return array_text(*x, spelled_vector);
    }
    std::string operator()(const std::vector<std::string>* x) const {
      return array_text(*x, [](const std::string& text) { return toml_string(text); });
    }
  };
  return std::visit(Speller{spec}, field);
}

std::string choices_text(const KeySpec& spec) {
  return comma_list(spec.choices, [](std::string_view word) { return toml_string(word); });
}

std::string word_suggestion(const std::string& word, const std::vector<std::string_view>& choices) {
  constexpr std::size_t kShortest = 3;  // fewer letters are like anything
  const auto lower = [](std::string_view text) {
    std::string out(text);
    for (char& c : out) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return out;
  };
  std::string_view best;
  int best_distance = std::numeric_limits<int>::max();
  for (const std::string_view choice : choices) {
    const int distance = edit_distance(lower(word), lower(choice));
    const auto allowed = static_cast<int>(std::max<std::size_t>(1, std::min(word.size(), choice.size()) / 3));
    if (word.size() < kShortest || distance > allowed || distance >= best_distance) continue;
    best = choice;
    best_distance = distance;
  }
  return best.empty() ? "" : "; did you mean " + toml_string(best) + "?";
}

}  // namespace unbruised::studies
