#include <map>
#include <optional>
#include <set>
#include <utility>

#include "studies/config/searching.hpp"

namespace unbruised::studies {
namespace {

struct BlockPlace {
  std::string list;  ///< "variable"
  std::size_t index = 0;
  std::string leaf;  ///< "key"; empty for the table itself
};

std::optional<BlockPlace> block_place(const std::string& path) {
  const std::size_t open = path.find('[');
  const std::size_t close = path.find(']');
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  BlockPlace place{path.substr(0, open), 0, {}};
  for (std::size_t i = open + 1; i < close; ++i) {
    place.index = 10 * place.index + static_cast<std::size_t>(path[i] - '0');
  }
  if (path.size() > close + 2) place.leaf = path.substr(close + 2);
  return place;
}

class BlockReader {
 public:
  explicit BlockReader(Problems& problems) : problems_(problems) {}

  void open_table(const Entry& table) {
    const auto place = block_place(table.path);
    if (!place || !place->leaf.empty()) return;
    if (place->list == "variable") {
      out_.blocks.variable.emplace_back().origin = table.origin;
    } else if (place->list == "parameter") {
      out_.blocks.parameter.emplace_back().origin = table.origin;
    } else if (place->list == "specimen") {
      out_.blocks.specimen.emplace_back().origin = table.origin;
    } else if (place->list == "random") {
      out_.blocks.random.emplace_back().origin = table.origin;
      out_.random_keys.emplace_back();
    } else if (place->list == "correlation") {
      out_.blocks.correlation.emplace_back().origin = table.origin;
    } else {
      out_.blocks.candidate.emplace_back().origin = table.origin;
      out_.candidate_entries.emplace_back();
    }
    given_[place->list].emplace_back();
  }

  void read(const Entry& entry) {
    const auto place = block_place(entry.path);
    const std::size_t count = place ? given_[place->list].size() : 0;
    if (!place || place->index >= count) {
      problems_.add(
          entry.origin, entry.path, spelled(entry.value),
          "there are " + std::to_string(count) + " [[" + (place ? place->list : "") + "]] blocks, counted from 0");
      return;
    }
    const KeyAddress address = find_key(entry.path);
    if (address.spec == nullptr) return read_foreign(entry, *place);
    std::set<std::string>& given = given_[place->list][place->index];
    if (const auto rule = check_value(*address.spec, entry.value, address.elements.size())) {
      problems_.add(entry.origin, entry.path, spelled(entry.value), *rule);
      given.insert(place->leaf);  // given, though wrong
      wrong_.emplace(place->list, place->index);
      return;
    }
    assign(*address.spec, address.spec->block_field(out_.blocks, static_cast<int>(place->index)), entry.value,
           address.elements);
    const bool taken_away = address.spec->type == KeyType::optional_number && !entry.value.is_number();
    if (taken_away) {
      given.erase(place->leaf);
    } else {
      given.insert(place->leaf);
    }
  }

  ReadBlocks finish() {
    report_missing("variable", out_.blocks.variable);
    report_missing("parameter", out_.blocks.parameter);
    report_missing("specimen", out_.blocks.specimen);
    report_missing("random", out_.blocks.random);
    report_missing("correlation", out_.blocks.correlation);
    report_missing("candidate", out_.blocks.candidate);
    for (std::size_t i = 0; i < out_.random_keys.size(); ++i) {
      out_.random_keys[i].assign(given_["random"][i].begin(), given_["random"][i].end());
      out_.random_sound.push_back(!wrong_.contains({"random", i}));
    }
    for (std::size_t i = 0; i < out_.blocks.correlation.size(); ++i) {
      out_.correlation_sound.push_back(!wrong_.contains({"correlation", i}));
    }
    return std::move(out_);
  }

 private:
  /// Beside its own keys a candidate has those of [strategy].
  void read_foreign(const Entry& entry, const BlockPlace& place) {
    const std::string strategy = "strategy." + place.leaf;
    if (place.list == "candidate" && find_key(strategy).spec != nullptr) {
      out_.candidate_entries[place.index].push_back({strategy, entry.value, entry.origin});
      return;
    }
    std::vector<std::string> known;
    for (const std::string& pattern : key_patterns()) {
      if (pattern.starts_with(place.list + "[].")) known.push_back(pattern);
      if (place.list == "candidate" && pattern.starts_with("strategy.")) {
        known.push_back("candidate[]." + pattern.substr(std::string_view("strategy.").size()));
      }
    }
    const std::string near = nearest(entry.path, known);
    problems_.add(entry.origin, entry.path, spelled(entry.value),
                  near.empty() ? "unknown key" : "unknown key; did you mean '" + near + "'?");
  }

  template <class Blocks>
  void report_missing(const std::string& list, const Blocks& blocks) {
    for (const KeySpec& spec : key_table()) {
      if (!spec.required || !spec.path.starts_with(list + "[].")) continue;
      const std::string leaf(spec.path.substr(list.size() + 3));
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (given_[list][i].contains(leaf)) continue;
        problems_.add(blocks[i].origin, list + "[" + std::to_string(i) + "]." + leaf, "missing");
        wrong_.emplace(list, i);
      }
    }
  }

  Problems& problems_;
  ReadBlocks out_;
  std::map<std::string, std::vector<std::set<std::string>>> given_;
  std::set<std::pair<std::string, std::size_t>> wrong_;
};

}  // namespace

std::vector<std::pair<std::string, Origin>> ReadBlocks::keys() const {
  std::vector<std::pair<std::string, Origin>> all;
  for (const VariableBlock& block : blocks.variable) all.emplace_back(block.key, block.origin);
  for (const VariableBlock& block : blocks.parameter) all.emplace_back(block.key, block.origin);
  for (const RandomBlock& block : blocks.random) all.emplace_back(block.key, block.origin);
  return all;
}

ReadBlocks read_blocks(const std::vector<Entry>& entries, const std::vector<Entry>& tables, Problems& problems) {
  BlockReader reader(problems);
  for (const Entry& table : tables) reader.open_table(table);
  for (const Entry& entry : entries) reader.read(entry);
  return reader.finish();
}

}  // namespace unbruised::studies
