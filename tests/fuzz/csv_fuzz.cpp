// Lists of particles and springs from CSV. The first byte chooses the list.

#include <memory>
#include <string>

#include "studies/config/library.hpp"
#include "studies/config/schema.hpp"
#include "tests/fuzz/fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace unbruised::studies;
  using unbruised::fuzz::require;
  if (size == 0) return 0;
  const std::string_view list = (data[0] & 1U) != 0 ? "product.spring" : "product.particle";
  static const auto file = std::make_shared<const std::string>("list.csv");
  Problems problems;
  const auto entries = csv_entries(list, unbruised::fuzz::text_of(data + 1, size - 1), file, 1, problems);
  for (const Entry& entry : entries) {
    const KeyAddress address = find_key(entry.path);
    require(address.spec != nullptr, "a cell lands at a known key");
    require(entry.path.starts_with(list), "a cell stays in its list");
    (void)check_value(*address.spec, entry.value, address.elements.size());
  }
  require(!entries.empty() || !problems.empty() || problems.lines().empty(), "a list without rows is a problem");
  return 0;
}
