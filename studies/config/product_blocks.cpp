#include "studies/config/product_blocks.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace unbruised::studies {
namespace {

/// One block: its table and its keys, under the path of the list ("random").
struct Block {
  Entry table;
  std::vector<Entry> entries;

  /// The value of a key; nullptr where it is not given.
  [[nodiscard]] const Value* value(const std::string& leaf) const {
    const auto found = std::find_if(entries.rbegin(), entries.rend(),
                                    [&](const Entry& entry) { return entry.path == table.path + "." + leaf; });
    return found == entries.rend() ? nullptr : &found->value;
  }
};

std::vector<Block> blocks_of(const std::string& list, const std::vector<Entry>& tables,
                             const std::vector<Entry>& entries) {
  std::vector<Block> blocks;
  for (const Entry& table : tables) {
    const bool is_block = table.path.starts_with(list + "[") && table.path.ends_with("]");
    if (!is_block) continue;
    blocks.push_back({table, {}});
    for (const Entry& entry : entries) {
      if (entry.path.starts_with(table.path + ".")) blocks.back().entries.push_back(entry);
    }
  }
  return blocks;
}

std::string key_of(const Block& block) {
  const Value* key = block.value("key");
  return key == nullptr ? std::string() : key->text;
}

using Pair = std::set<std::string>;
Pair pair_of(const Block& block) {
  Pair pair;
  if (const Value* between = block.value("between")) {
    for (const Value& key : between->items) pair.insert(key.text);
  }
  return pair;
}

/// Behind the blocks that the list has.
void append(const std::string& list, Block block, std::size_t index, SortedText& text) {
  const std::string path = list + "[" + std::to_string(index) + "]";
  for (Entry& entry : block.entries) {
    entry.path = path + entry.path.substr(block.table.path.size());
    text.block_entries.push_back(std::move(entry));
  }
  block.table.path = path;
  text.block_tables.push_back(std::move(block.table));
}

}  // namespace

void add_blocks_of_product(const std::vector<Entry>& product, SortedText& text) {
  std::set<std::string> drawn, said;
  const std::vector<Block> own = blocks_of("random", text.block_tables, text.block_entries);
  for (const Block& block : own) drawn.insert(key_of(block));
  for (const Block& block : blocks_of("variable", text.block_tables, text.block_entries))
    said.insert(key_of(block));
  for (const auto* list : {&text.study, &text.command_line}) {
    for (const Entry& entry : *list) said.insert(entry.path);
  }
  std::size_t next = own.size();
  for (Block& block : blocks_of("random", product, product)) {
    const std::string key = key_of(block);
    if (said.contains(key) || !drawn.insert(key).second) continue;
    append("random", std::move(block), next++, text);
  }
  const std::vector<Block> own_pairs = blocks_of("correlation", text.block_tables, text.block_entries);
  next = own_pairs.size();
  for (Block& block : blocks_of("correlation", product, product)) {
    const Pair pair = pair_of(block);
    const bool is_drawn =
        std::all_of(pair.begin(), pair.end(), [&](const std::string& k) { return drawn.contains(k); });
    const bool is_said = std::any_of(own_pairs.begin(), own_pairs.end(),
                                     [&](const Block& other) { return pair_of(other) == pair; });
    if (is_drawn && !is_said) append("correlation", std::move(block), next++, text);
  }
}

}  // namespace unbruised::studies
