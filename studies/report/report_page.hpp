#pragma once

/// @file
/// report.html: one page that needs nothing else, made for reading what a study found (docs/report.md).

#include <filesystem>
#include <string>
#include <string_view>

#include "studies/report/report_data.hpp"
#include "studies/results/expected.hpp"
#include "studies/results/rows.hpp"

namespace unbruised::studies {

/// The whole page. Nothing in it reaches the network, its policy forbids it, and no text of the study is markup.
/// @param content rows by id
std::string report_page(const ResultsContent& content, const ReportContext& context);

/// Writes the page atomically and durably. An earlier page is replaced, any other file refused (foreign). Errors:
/// io; not_built: this program has no page.
MaybeError write_report(const std::filesystem::path& path, const ResultsContent& content,
                        const ReportContext& context);

/// How every page begins: what may be replaced is recognised by it.
inline constexpr std::string_view kReportBegin = "<!doctype html>\n<!-- Unbruised report -->\n";
inline constexpr const char* kReportName = "report.html";  ///< in a run directory

/// Nothing where a page may be written: nothing is there yet, or an earlier page. Else foreign.
MaybeError refuse_foreign_page(const std::filesystem::path& path);

/// `text` as HTML shows it.
std::string html_text(std::string_view text);

}  // namespace unbruised::studies
