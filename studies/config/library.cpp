#include "studies/config/library.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "studies/config/csv_rows.hpp"
#include "studies/config/measured_data.hpp"
#include "studies/config/mesh_file.hpp"
#include "studies/config/schema.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{4} << 20;
constexpr std::size_t kMaxCsvBytes = std::size_t{64} << 20;
constexpr std::size_t kMaxPathBytes = 4096;
constexpr std::size_t kMaxProfilePlaces = 10'000;

std::optional<std::string> read_bytes(const std::filesystem::path& path, std::size_t most, std::string& why) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    why = std::filesystem::exists(path, error) ? "not a file" : "no such file";
    return std::nullopt;
  }
  std::ifstream stream(path, std::ios::binary);
  std::string content;
  const auto size = std::min<std::uintmax_t>(std::filesystem::file_size(path, error), most + 1);
  if (!stream || error) {
    why = "cannot be read";
    return std::nullopt;
  }
  content.resize(static_cast<std::size_t>(size));
  stream.read(content.data(), static_cast<std::streamsize>(size));
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

/// What a CSV column writes to: a key of the list, or one element of it ("position_x_m", "between_0").
struct CsvColumn {
  const KeySpec* spec = nullptr;
  std::string key;  ///< with element, e.g. "position_m[0]"
};

CsvColumn csv_column(std::string_view list, const std::string& name) {
  const std::string table = std::string(list) + "[].";
  for (const KeySpec& spec : key_table()) {
    if (!spec.path.starts_with(table) || spec.type == KeyType::series) continue;
    const std::string key(spec.path.substr(table.size()));
    if (spec.size == 0) {
      if (name == key) return {&spec, key};
      continue;
    }
    const Unit* unit = unit_of(key);
    const std::string suffix = unit == nullptr ? "" : std::string(unit->suffix);
    const std::string stem = key.substr(0, key.size() - suffix.size());
    for (int i = 0; i < spec.size; ++i) {
      const std::string element =
          spec.type == KeyType::integers ? std::to_string(i) : std::string(1, static_cast<char>('x' + i));
      if (name == stem + "_" + element + suffix) return {&spec, key + "[" + std::to_string(i) + "]"};
    }
  }
  return {};
}

/// "yz" as ["y", "z"].
Value axes_value(const std::string& cell) {
  Value axes;
  axes.kind = Value::Kind::array;
  for (const char c : cell) axes.items.push_back(text_value(std::string(1, c)));
  return axes;
}

Value cell_value(const KeySpec& spec, const std::string& cell) {
  if (spec.type == KeyType::axes) return axes_value(cell);
  const std::optional<double> number = cell_number(cell);
  return number ? number_value(*number) : text_value(cell);
}

/// Is it a table or key of the blocks that a product's file may have?
bool is_block_of_product(std::string_view local) {
  return local.starts_with("random[") || local.starts_with("correlation[");
}

}  // namespace

std::optional<std::string> read_text_file(const std::filesystem::path& path, std::string& why) {
  return read_bytes(path, kMaxBytes, why);
}

std::optional<Library::Text> Library::open(const Entry& named, Problems& problems) {
  const std::string& name = named.value.text;
  if (name.size() > kMaxPathBytes || name.find('\0') != std::string::npos) {
    problems.add(named.origin, named.path, toml_string(name), "is not the path of a file");
    return std::nullopt;
  }
  const std::filesystem::path wanted = name;
  const std::size_t most = named.path.ends_with("_csv") || named.path == kMeshFileKey ? kMaxCsvBytes : kMaxBytes;
  std::string why = "not found: there is no folder to look in";
  std::vector<std::string> places;
  for (const auto& folder : {folder_, config_root_}) {
    if (folder.empty() && !wanted.is_absolute()) continue;
    const std::filesystem::path path = folder / wanted;
    if (auto content = read_bytes(path, most, why)) {
      const auto file = std::make_shared<const std::string>(path.lexically_normal().string());
      if (content->size() > most) {
        problems.add({file, next_rank_, 1}, named.path, "the file is too large");
        return std::nullopt;
      }
      return Text{std::move(*content), file, next_rank_++};
    }
    places.push_back(folder.lexically_normal().string());
    if (why != "no such file") break;
  }
  problems.add(named.origin, named.path, toml_string(named.value.text),
               places.empty() ? why : joined({why, " (looked in ", listed(places, "or"), ")"}));
  return std::nullopt;
}

std::vector<Entry> library_entries(const Document& document, std::string_view prefix, std::string_view table,
                                   Problems& problems) {
  const bool is_product = table == "product";
  const auto known = [&](const std::string& local) {
    if (local == "source" || local.starts_with("source.") || (is_product && local == "limits")) return true;
    if (is_product && is_block_of_product(local)) return true;
    const std::string pattern = pattern_of(std::string(table) + "." + local);
    return std::find(table_names().begin(), table_names().end(), pattern) != table_names().end();
  };
  std::vector<std::string> foreign;
  for (const Entry& entry : document.tables) {
    if (!entry.path.starts_with(prefix)) continue;
    const std::string local = entry.path.substr(prefix.size());
    const bool inside = std::any_of(foreign.begin(), foreign.end(),
                                    [&](const std::string& other) { return local.starts_with(other + "."); });
    if (known(local) || inside) continue;
    foreign.push_back(local);
    problems.add(entry.origin, local, "unknown table in a " + std::string(table) + " file");
  }
  std::vector<Entry> out;
  for (const Entry& opened : document.tables) {
    const std::string local = opened.path.starts_with(prefix) ? opened.path.substr(prefix.size()) : "";
    if (is_product && is_block_of_product(local)) out.push_back({local, {}, opened.origin});
  }
  for (const Entry& entry : document.entries) {
    if (!entry.path.starts_with(prefix)) continue;
    const std::string local = entry.path.substr(prefix.size());
    if (std::any_of(foreign.begin(), foreign.end(),
                    [&](const std::string& other) { return local.starts_with(other + "."); })) {
      continue;
    }
    const bool descriptive = local == "name" || local == "description" || local.starts_with("source.");
    if (descriptive) {
      if (entry.value.kind != Value::Kind::text) {
        problems.add(entry.origin, local, spelled(entry.value), "must be a string");
      } else if (local.starts_with("source.") && table != "strategy") {
        out.push_back({std::string(table) + "." + local, entry.value, entry.origin});
      }
    } else if (local == "use") {
      problems.add(entry.origin, local, spelled(entry.value), "a file that is used may not use another one");
    } else {
      const bool own = !is_product || !(local.starts_with("limits.") || is_block_of_product(local));
      out.push_back({own ? std::string(table) + "." + local : local, entry.value, entry.origin});
    }
  }
  return out;
}

std::vector<Entry> Library::read(std::string_view table, const Entry& use, Problems& problems) {
  const auto text = open(use, problems);
  if (!text) return {};
  const Document document = parse_document(text->content, text->file, text->rank);
  for (const Problem& problem : document.problems) problems.add(problem);
  std::vector<Entry> entries = library_entries(document, "", table, problems);
  read_profile(entries, problems);
  read_product_profile(entries, problems);
  if (table == "product") read_mesh(entries, problems);
  return entries;
}

std::vector<Entry> profile_entries(std::string_view content, const std::shared_ptr<const std::string>& file,
                                   int rank, Problems& problems) {
  constexpr std::array<std::string_view, 2> kColumns = {"place_m", "height_m"};
  std::array<Entry, 2> list;
  for (std::size_t i = 0; i < 2; ++i) {
    list[i] = {"gripper.pad.profile_" + std::string(kColumns[i]), {}, {file, rank, 1}};
    list[i].value.kind = Value::Kind::array;
  }
  bool has_header = false;
  for (CsvRows csv(content, file, rank); csv.next();) {
    const Origin& origin = csv.origin();
    const std::vector<std::string>& cells = csv.cells();
    if (!has_header) {
      has_header = cells.size() == 2 && cells[0] == kColumns[0] && cells[1] == kColumns[1];
      if (has_header) continue;
      problems.add(origin, kProfileFileKey, "the first line must be \"place_m,height_m\"");
      return {};
    }
    if (cells.size() != 2) {
      problems.add(origin, kProfileFileKey,
                   "a row must have two cells, a place and a height, not " + std::to_string(cells.size()));
      return {};
    }
    for (std::size_t i = 0; i < 2; ++i) {
      Value value = cell_value(KeySpec{}, cells[i]);
      if (value.kind == Value::Kind::text) {
        problems.add(origin, kColumns[i], spelled(value), "must be a number");
        return {};
      }
      auto& items = list[i].value.items;
      if (i == 0 && !items.empty() && !(value.number > items.back().number)) {
        problems.add(origin, kColumns[i], spelled(value),
                     "must be > the place before it, " + spelled(items.back()) +
                         ": a profile has one height at each place");
        return {};
      }
      if (items.size() == kMaxProfilePlaces) {
        problems.add(origin, kProfileFileKey, "more than 10,000 places");
        return {};
      }
      items.push_back(std::move(value));
    }
  }
  if (list[0].value.items.size() < 2) {
    problems.add({file, rank, 1}, kProfileFileKey, "the file must have two rows at least");
    return {};
  }
  return {list[0], list[1]};
}

std::vector<double> Library::read_column(const Entry& named, const std::string& column, Problems& problems) {
  const auto text = open(named, problems);
  if (!text) return {};
  return column_numbers(text->content, column, named.path, text->file, text->rank, problems);
}

std::vector<SpecimenBlock> Library::read_curves(const Entry& named, const CalibrateTable& settings,
                                                Problems& problems) {
  const auto text = open(named, problems);
  if (!text) return {};
  return measured_curves(text->content, settings, text->file, text->rank, problems);
}

std::vector<Entry> Library::read_csv(std::string_view list, const Entry& named, Problems& problems) {
  const auto text = open(named, problems);
  return text ? csv_entries(list, text->content, text->file, text->rank, problems) : std::vector<Entry>{};
}

std::vector<Entry> csv_entries(std::string_view list, std::string_view content,
                               const std::shared_ptr<const std::string>& file, int rank, Problems& problems) {
  std::vector<Entry> out;
  std::vector<CsvColumn> columns;
  int row = 0;
  for (CsvRows csv(content, file, rank); csv.next();) {
    const Origin& origin = csv.origin();
    const std::vector<std::string>& cells = csv.cells();
    if (columns.empty()) {
      for (const std::string& name : cells) {
        columns.push_back(csv_column(list, name));
        if (columns.back().spec == nullptr) {
          problems.add(origin, name, "unknown column; docs/config.md lists the columns of CSV files");
          return {};
        }
      }
      continue;
    }
    if (cells.size() != columns.size()) {
      problems.add(origin, list,
                   "a row must have as many cells as the first line has (" + std::to_string(columns.size()) +
                       "), not " + std::to_string(cells.size()));
      return {};
    }
    if (row == kMaxListRows) {
      problems.add(origin, list, "more than 1,000,000 rows");
      return {};
    }
    const std::string path = std::string(list) + "[" + std::to_string(row++) + "].";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (cells[i].empty()) continue;
      out.push_back({path + columns[i].key, cell_value(*columns[i].spec, cells[i]), origin});
    }
  }
  if (row == 0) problems.add({file, rank, 1}, list, "the file has no rows");
  return out;
}

}  // namespace unbruised::studies
