#include <system_error>

#include "studies/cli/commands.hpp"
#include "studies/config/locations.hpp"
#include "studies/config/schema.hpp"
#include "studies/kinds/study_template.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

std::optional<StudyKind> kind_of(const std::string& word) {
  std::vector<std::string> known;
  for (const StudyKindRow& row : study_kind_table()) {
    if (row.word == word) return row.kind;
    known.emplace_back(row.word);
  }
  const std::string near = nearest(word, known);
  print_error(joined({"--kind ", word, ": must be one of ", listed(known, "or"),
                      near.empty() ? "" : joined({"; did you mean '", near, "'?"})}));
  return std::nullopt;
}

/// Reads a text as the file that it is about to become; nothing after the problems are printed.
std::optional<Study> read_as(const fs::path& file, const std::string& text) {
  StudyOrError read = read_study_text(
      text, file.string(), {}, file.parent_path().empty() ? "." : file.parent_path(), config_root_for(file));
  if (read) return *std::move(read);
  for (const std::string& message : read.error().messages) print_error(message);
  return std::nullopt;
}

}  // namespace

int new_command(const NewArguments& arguments) {
  const std::optional<StudyKind> kind = kind_of(arguments.kind);
  if (!kind) return kExitInput;
  const fs::path file = arguments.output ? *arguments.output : fs::path(arguments.name + ".toml");
  std::error_code unknown;
  if (fs::exists(fs::symlink_status(file, unknown))) {
    print_error(joined({file.string(), " is there already, and is left as it is; name another file with -o"}));
    return kExitInput;
  }
  const TemplateRequest request{
      .name = arguments.name, .kind = *kind, .product = arguments.product, .gripper = arguments.gripper};
  const std::optional<Study> bare = read_as(file, bare_study(request));
  if (!bare) return kExitInput;
  const Scenario scenario = bare->scenario(0);
  if (!std::holds_alternative<LatticeParameters>(scenario.product)) {
    print_error(joined({arguments.product, " is a network of springs; `new` writes studies of solid products"}));
    return kExitInput;
  }
  const std::string text = study_template(request, template_numbers(scenario));
  if (!read_as(file, text)) return kExitInput;
  if (const auto error = write_text_file(file, text)) return report_error(*error);
  print_line(joined({"study: ", file.string()}));
  print_line(joined({"look at it, then: unbruised check ", shell_word(file.string()), " and unbruised run ",
                     shell_word(file.string())}));
  return kExitDone;
}

}  // namespace unbruised::studies
