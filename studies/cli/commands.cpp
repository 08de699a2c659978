#include "studies/cli/commands.hpp"

#include <iostream>

#include "studies/config/locations.hpp"
#include "studies/execution/machine.hpp"
#include "studies/ranks/join_ranks.hpp"
#include "studies/results/run_directory.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

void print_error(const std::string& message) { std::cerr << joined({"unbruised: error: ", message, "\n"}); }

void print_note(const std::string& message) { std::cerr << joined({"unbruised: ", message, "\n"}); }

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) print_note(joined({"warning: ", warning}));
}

void print_line(const std::string& line) { std::cout << joined({line, "\n"}); }

void print_text(const std::string& text) { std::cout << text; }

int report_error(const ResultsError& error) {
  print_error(error.message);
  return exit_status(error.kind);
}

StudyOrError read_of(const StudyArguments& arguments) {
  return read_study(arguments.study, arguments.sets, config_root_for(arguments.study));
}

void print_problems_of(const StudyArguments& arguments, const ConfigError& error) {
  for (const std::string& message : error.messages) std::cerr << joined({message, "\n"});
  const std::size_t count = error.messages.size();
  print_error(joined({arguments.study.string(), ": ", std::to_string(count), count == 1 ? " problem" : " problems",
                      ", nothing was run"}));
}

std::optional<Study> read_or_explain(const StudyArguments& arguments) {
  StudyOrError read = read_of(arguments);
  if (read) return *std::move(read);
  print_problems_of(arguments, read.error());
  return std::nullopt;
}

std::filesystem::path run_directory_of(const Study& study, const std::optional<std::filesystem::path>& output) {
  return output ? *output : std::filesystem::path("results") / study.name();
}

int thread_count_of(const std::optional<int>& threads) {
  return threads ? *threads : usable_cores_of_each(ranks_on_this_machine());
}

std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      quoted += "'\\''";
    } else {
      quoted += letter;
    }
  }
  return quoted + "'";
}

int verify_command(const std::filesystem::path& directory) {
  const Expected<VerifyReport> report = verify_run_directory(directory);
  if (!report) return report_error(report.error());
  for (const std::string& note : report->notes) print_line(note);
  for (const std::string& damage : report->damage) print_error(joined({"damage: ", damage}));
  print_line(joined({"journal rows: ", std::to_string(report->journal_rows),
                     ", results rows: ", std::to_string(report->results_rows)}));
  if (!report->digest.empty()) print_line(joined({"digest ", report->digest}));
  print_line(report->damage.empty() ? "verified: no damage found" : "damaged");
  return report->damage.empty() ? kExitDone : exit_status(ResultsErrorKind::damaged);
}

int list_command() {
  const std::filesystem::path root = config_root_for({});
  const std::vector<LibraryEntry> entries = list_library(root);
  if (entries.empty()) {
    print_error(joined({"no products, grippers or studies below ", root.string()}));
    return kExitInput;
  }
  print_line(joined({"in ", root.string(), ":"}));
  std::size_t width = 0;
  for (const LibraryEntry& entry : entries) width = std::max(width, entry.path.size());
  std::optional<LibraryEntry::Kind> kind;
  for (const LibraryEntry& entry : entries) {
    if (kind != entry.kind) {
      kind = entry.kind;
      print_line(entry.kind == LibraryEntry::Kind::product    ? "\nproducts"
                 : entry.kind == LibraryEntry::Kind::gripper  ? "\ngrippers"
                 : entry.kind == LibraryEntry::Kind::strategy ? "\nstrategies"
                                                              : "\nstudies");
    }
    const std::string padding(width - entry.path.size() + 2, ' ');
    print_line(joined({"  ", entry.path, entry.description.empty() ? "" : padding, entry.description}));
  }
  return kExitDone;
}

}  // namespace unbruised::studies
