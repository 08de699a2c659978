#include "studies/report/report_page.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <system_error>

#include "studies/report/base64.hpp"
#include "studies/report/report_bundle.hpp"
#include "studies/results/checksum.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

constexpr std::string_view kIcon =
    "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 32 32'%3E%3Cpath fill='none' "
    "stroke='%231b9e77' stroke-width='3.5' stroke-linecap='round' d='M5 7v18M27 7v18'/%3E%3Ccircle cx='16' "
    "cy='16' "
    "r='7' fill='%231b9e77'/%3E%3C/svg%3E";

/// Only the one script of the page runs, and nothing is loaded or sent.
std::string policy(std::string_view script) {
  const std::array<std::uint8_t, 32> hash = sha256(script);
  const std::string digest = base64({reinterpret_cast<const char*>(hash.data()), hash.size()});
  return joined({"default-src 'none'; script-src 'sha256-", digest,
                 "'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"});
}

std::string head(const ResultsContent& content, std::string_view script) {
  return joined(
      {"<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" content=\"", policy(script),
       "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
       "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"Unbruised ",
       html_text(content.meta.unbruised_version), "\">\n<title>", html_text(content.meta.study_name),
       " - Unbruised</title>\n<link rel=\"icon\" href=\"", kIcon, "\">\n<style>\n", report_style(), "</style>\n"});
}

/// What a reader without JavaScript gets: the lines `info` prints.
std::string without_script(const ResultsContent& content, const ReportContext& context) {
  std::string text = joined({"<noscript><h1>", html_text(content.meta.study_name), "</h1><pre>"});
  for (const std::string& line : context.summary) text += joined({html_text(line), "\n"});
  return text + "</pre><p>The charts and the table of this page need JavaScript.</p></noscript>\n";
}

bool may_be_replaced(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return true;
  std::ifstream in(path, std::ios::binary);
  std::string begin(kReportBegin.size(), '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin == kReportBegin;
}

}  // namespace

MaybeError refuse_foreign_page(const std::filesystem::path& path) {
  if (may_be_replaced(path)) return std::nullopt;
  return ResultsError{
      ResultsErrorKind::foreign,
      joined({path.string(), " is there and is no report of this program; name another file with -o"}),
      {}};
}

std::string html_text(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += letter;
    }
  }
  return escaped;
}

std::string report_page(const ResultsContent& content, const ReportContext& context) {
  const ReportData data = report_data(content, context);
  const std::string script = joined({"\n", report_script()});
  return joined({kReportBegin, "<html lang=\"en\">\n<head>\n", head(content, script), "</head>\n<body>\n",
                 without_script(content, context), "<div id=\"page\"></div>\n",
                 "<script type=\"application/json\" id=\"study\">", data.json, "</script>\n",
                 "<script type=\"application/octet-stream+base64\" id=\"columns\">", base64(data.columns),
                 "</script>\n<script type=\"text/plain\" id=\"notices\">", report_notices(), "</script>\n<script>",
                 script, "</script>\n</body>\n</html>\n"});
}

MaybeError write_report(const std::filesystem::path& path, const ResultsContent& content,
                        const ReportContext& context) {
  if (report_script().empty()) {
    return ResultsError{
        ResultsErrorKind::not_built,
        "this program was built without the page of the report, because node, npm or npm's registry "
        "was out of reach; install node 18, behind a proxy set NODE_EXTRA_CA_CERTS or `npm config set "
        "registry URL`, then run scripts/build",
        {}};
  }
  if (auto error = refuse_foreign_page(path)) return error;
  return write_text_file(path, report_page(content, context));
}

}  // namespace unbruised::studies
