// usage: HARNESS MUTATIONS FOLDER...
// Feeds every file of the folders to a harness, then so many seeded mutations of them: a short fuzzing in any
// build, without libFuzzer. A crash is repeated by the same call; the last name on stderr is the input's.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/figures.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return std::move(bytes).str();
}

void feed(const std::string& content) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(content.data()), content.size());
}

/// Some edits at random places: a flipped bit, a lost or doubled piece, another byte, a piece of another input.
class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& inputs) : inputs_(inputs) {}

  std::string next() {
    std::string text = inputs_[below(inputs_.size())];
    for (std::size_t edits = 1 + below(4); edits > 0; --edits) edit(text);
    return text;
  }

 private:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : static_cast<std::size_t>(dice_() % end); }

  std::string piece_of(const std::string& text) {
    const std::size_t from = below(text.size());
    return text.substr(from, 1 + below(16));
  }

  void edit(std::string& text) {
    const std::size_t at = below(text.size());
    switch (below(5)) {
      case 0:
        if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        return;
      case 1:
        text.erase(at, 1 + below(16));
        return;
      case 2:
        text.insert(at, piece_of(text));
        return;
      case 3:
        text.insert(at, 1, static_cast<char>(below(256)));
        return;
      default:
        text.insert(at, piece_of(inputs_[below(inputs_.size())]));
    }
  }

  const std::vector<std::string>& inputs_;
  std::mt19937_64 dice_{1};
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  std::vector<std::filesystem::path> files;
  for (int i = 2; i < argc; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) files.push_back(entry.path());
  }
  if (files.empty()) return 2;
  std::sort(files.begin(), files.end());
  std::vector<std::string> inputs;
  for (const auto& file : files) {
    std::fprintf(stderr, "%s\n", file.filename().c_str());
    inputs.push_back(content_of(file));
    feed(inputs.back());
  }
  Mutator mutator(inputs);
  const long mutations = std::strtol(argv[1], nullptr, 10);
  for (long i = 0; i < mutations; ++i) {
    std::fprintf(stderr, "mutation %ld\n", i);
    feed(mutator.next());
  }
  const std::string harness = std::filesystem::path(argv[0]).filename();
  unbruised::testing::tell_figure(harness, harness + ": " + std::to_string(files.size()) + " files and " +
                                               std::to_string(mutations) + " mutations of them, read as promised");
  return 0;
}
