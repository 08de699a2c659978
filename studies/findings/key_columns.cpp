#include "studies/findings/key_columns.hpp"

#include <algorithm>
#include <variant>

#include "studies/findings/key_roles.hpp"
#include "studies/findings/summary.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {

KeyPlaces key_places(const std::vector<ColumnInfo>& columns) {
  KeyPlaces places;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    (key_role(columns[i].key) == KeyRole::given ? places.given : places.others).push_back(i);
  }
  return places;
}

ResultColumn key_column(const ColumnInfo& key, const std::vector<InputValue>& values) {
  const bool numeric = std::all_of(values.begin(), values.end(),
                                   [](const InputValue& value) { return std::holds_alternative<double>(value); });
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (const InputValue& value : values) {
    const auto* number = std::get_if<double>(&value);
    if (numeric) numbers.push_back(*number);
    if (!numeric) texts.push_back(number != nullptr ? short_number(*number) : std::get<std::string>(value));
  }
  if (numeric) return {key.key, key.units, key.long_name, std::move(numbers)};
  return {key.key, key.units, key.long_name, std::move(texts)};
}

std::string leaves_text(const std::vector<ColumnInfo>& keys) {
  return comma_list(keys, [](const ColumnInfo& key) { return key_leaf(key.key); });
}

}  // namespace unbruised::studies
