#include "studies/config/product_profile.hpp"

#include <array>

#include "studies/config/number_table.hpp"

namespace unbruised::studies {

std::vector<Entry> product_profile_entries(std::string_view content,
                                           const std::shared_ptr<const std::string>& file, int rank,
                                           Problems& problems) {
  const std::array<std::string, 2> columns = {"height", "radius"};
  NumberTable table(content, file, rank, kProductProfileKey, problems);
  if (!table.read_header({{columns[0], columns[1]}}) || !table.has(columns[0])) {
    problems.add(table.start(), kProductProfileKey, "the first line must name the columns height and radius");
    return {};
  }
  std::vector<Entry> lists;
  for (const std::string& column : columns) {
    lists.push_back({"product.profile_" + column, {}, table.start()});
    lists.back().value.kind = Value::Kind::array;
  }
  while (table.next()) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      lists[i].value.items.push_back(number_value(table.number(columns[i])));
    }
  }
  return table.failed() ? std::vector<Entry>{} : lists;
}

}  // namespace unbruised::studies
