#include "studies/config/searching.hpp"

#include <algorithm>
#include <string>

#include "studies/config/search_parts.hpp"

namespace unbruised::studies {
namespace {

/// Room for the products of one question (the index of a search's place has 16 bits).
constexpr std::size_t kProductsPerQuestionMost = 65536;
/// Pairs of strategies are compared, and read.
constexpr std::size_t kCandidatesMost = 20;

/// Completes a study from its blocks; the steps of `run` are its parts.
class Completion {
 public:
  explicit Completion(const SearchInput& input)
      : input_(input), data_(input.data), read_(input.read), base_(input.base), problems_(input.problems) {}

  void run() {
    refuse_foreign_blocks();
    check_counts();
    add_searched_keys(input_);
    add_correlations(input_);
    add_goals(input_);
    check_indices();
    if (fits_curves(kind())) add_curves(input_);
    data_.sampling = data_.settings.sampling;
    check_products_fit();
  }

 private:
  [[nodiscard]] StudyKind kind() const { return data_.settings.kind; }
  [[nodiscard]] std::string kind_word() const { return toml_string(study_kind_word(kind())); }

  template <class Blocks>
  void refuse_blocks(const Blocks& blocks, const std::string& list, Use use) {
    if (blocks.empty() || kind_uses(use, kind())) return;
    problems_.add(blocks.front().origin, "[[" + list + "]]", why_unused(use, data_.bases.front()));
  }

  void refuse_foreign_blocks() {
    refuse_blocks(read_.blocks.variable, "variable", Use::search);
    refuse_blocks(read_.blocks.parameter, "parameter", Use::curves);
    refuse_blocks(read_.blocks.specimen, "specimen", Use::curves);
    refuse_blocks(read_.blocks.random, "random", Use::random);
    refuse_blocks(read_.blocks.correlation, "correlation", Use::random);
    refuse_blocks(read_.blocks.candidate, "candidate", Use::candidates);
  }

  void check_counts() {
    const Origin origin = base_.origin_of("study.kind");
    const auto needs = [&](const char* what) {
      problems_.add(origin, "study.kind", kind_word(), std::string("needs ") + what);
    };
    const StudyKindRow& row = row_of(kind());
    if (row.variable == Blocks::required && read_.blocks.variable.empty()) {
      needs("[[variable]] blocks: what may be changed, and how far");
    }
    if (row.parameter == Blocks::required && read_.blocks.parameter.empty()) {
      needs("[[parameter]] blocks: what is fitted, and how far it may go");
    }
    if (row.random == Blocks::required && read_.blocks.random.empty())
      needs("[[random]] blocks: what varies from product to product");
    const std::size_t candidates = read_.blocks.candidate.size();
    if (row.candidate == Blocks::required && (candidates < 2 || candidates > kCandidatesMost)) {
      needs("two or more [[candidate]] blocks, at most 20");
    }
  }

  /// Sobol' indices split a variance that independent keys have made.
  void check_indices() {
    if (row_of(kind()).scenarios != ScenarioSource::design) return;
    if (data_.sensitivity.method != SensitivityMethod::sobol) return;
    std::string together;
    if (!data_.correlations.empty()) together = "[[correlation]]";
    for (const RandomVariable& random : data_.randoms) {
      if (!random.zip.empty()) together = "rows of " + random.zip;
    }
    if (together.empty()) return;
    problems_.add(
        base_.origin_of("sensitivity.method"), "sensitivity.method", "\"sobol\"",
        "Sobol' indices are parts of a variance only of keys that are drawn independently, and here are " +
            together +
            "; take method = \"morris\" (effects of one key at a time, whatever their joint law), draw the "
            "keys independently, or ask kind = \"sample\" for the spread under the joint law");
  }

  void check_products_fit() {
    const std::uint64_t count = data_.sampling.count;
    const auto complain = [&](const std::string& rule) {
      problems_.add(base_.origin_of("sampling.count"), "sampling.count", std::to_string(count), rule);
    };
    if (is_sampled_search(kind())) {
      const bool gradient = optimizer::info_of(data_.search.algorithm).uses_gradient ||
                            (data_.search.local && optimizer::info_of(*data_.search.local).uses_gradient);
      const std::size_t points = gradient ? 2 * data_.variables.size() + 1 : 1;
      if (count * points > kProductsPerQuestionMost) {
        complain("must be <= " + std::to_string(kProductsPerQuestionMost / points) + " for this search");
      }
    }
    if (row_of(kind()).scenarios == ScenarioSource::pairs &&
        count * std::max<std::size_t>(1, read_.blocks.candidate.size()) > kMaxScenarios) {
      complain("more than 10,000,000 scenarios");
    }
  }

  const SearchInput& input_;
  StudyData& data_;
  const ReadBlocks& read_;
  const Assembly& base_;
  Problems& problems_;
};

}  // namespace

void complete_search(StudyData& data, const ReadBlocks& read, const Assembly& base, Problems& problems) {
  const SearchInput input{data, read, base, problems};
  Completion(input).run();
}

}  // namespace unbruised::studies
