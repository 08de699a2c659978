#include "studies/report/shelf_page.hpp"

#include "studies/report/report_bundle.hpp"
#include "studies/report/report_page.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"
#include "studies/text/number_text.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

/// A path as an address relative to the page.
std::string address_of(const fs::path& path) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string address = "./";  // no name is taken for a scheme
  for (const char letter : path.generic_string()) {
    if (kPlain.find(letter) != std::string_view::npos) {
      address += letter;
      continue;
    }
    const auto byte = static_cast<unsigned char>(letter);
    address += '%';
    address += kDigits[byte >> 4U];
    address += kDigits[byte & 15U];
  }
  return address;
}

std::string cell(std::string_view text) { return joined({"<td>", html_text(text), "</td>"}); }

std::string row_of(const ShelfRun& run, const fs::path& folder) {
  const fs::path report = fs::path(run.directory / kReportName).lexically_relative(folder);
  const std::string name = html_text(run.study.empty() ? run.directory.filename().string() : run.study);
  const std::string linked =
      run.has_report ? joined({"<a href=\"", html_text(address_of(report)), "\">", name, "</a>"}) : name;
  const std::string tone = run.state == "complete" ? "met" : run.state == "damaged" ? "broken" : "decides";
  return joined({"<tr><th scope=\"row\">", linked, "<small>", html_text(run.directory.string()), "</small></th>",
                 cell(run.kind), cell(run.answer), cell(run.created_utc), "<td class=\"state ", tone, "\">",
                 html_text(run.state), "</td></tr>\n"});
}

}  // namespace

std::string shelf_page(const std::vector<ShelfRun>& runs, const fs::path& folder) {
  std::string rows;
  for (const ShelfRun& run : runs) rows += row_of(run, folder);
  const std::string count =
      joined({with_thousands(runs.size()), runs.size() == 1 ? " run in " : " runs in ", folder.string()});
  return joined(
      {kReportBegin, "<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n",
       "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; ",
       "base-uri 'none'; form-action 'none'\">\n",
       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n",
       "<meta name=\"color-scheme\" content=\"light dark\">\n<title>", html_text(count),
       " - Unbruised</title>\n<style>\n", report_style(), "</style>\n</head>\n<body>\n<main>\n",
       "<section class=\"shelf\"><h1 class=\"medium\">Runs</h1>\n<p class=\"sentence\">", html_text(count),
       ".</p>\n",
       "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Runs\"><table class=\"plain\">\n",
       "<thead><tr><th scope=\"col\">study</th><th scope=\"col\">kind</th><th scope=\"col\">answer</th>",
       "<th scope=\"col\">written</th><th scope=\"col\">state</th></tr></thead>\n<tbody>\n", rows,
       "</tbody></table></div></section>\n</main>\n</body>\n</html>\n"});
}

MaybeError write_shelf_page(const fs::path& path, const std::vector<ShelfRun>& runs, const fs::path& folder) {
  if (auto error = refuse_foreign_page(path)) return error;
  return write_text_file(path, shelf_page(runs, folder));
}

}  // namespace unbruised::studies
