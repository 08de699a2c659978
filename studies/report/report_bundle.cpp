#include "studies/report/report_bundle.hpp"

#include <cstddef>

// A few hundred kB that no compiler has to read: the assembler copies the files into the read-only data.
#define UNBRUISED_EMBED(symbol, file)                                                               \
  __asm__(".section .rodata\n.balign 16\n" #symbol ":\n.incbin \"" UNBRUISED_REPORT_BUNDLE "/" file \
          "\"\n" #symbol "_end:\n.byte 0\n.previous\n");                                            \
  extern "C" {                                                                                      \
  extern const char symbol[] __attribute__((visibility("hidden")));                                 \
  extern const char symbol##_end[] __attribute__((visibility("hidden")));                           \
  }

UNBRUISED_EMBED(unbruised_report_js, "report.js")
UNBRUISED_EMBED(unbruised_report_css, "report.css")
UNBRUISED_EMBED(unbruised_report_notices, "notices.txt")

namespace unbruised::studies {
namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

std::string_view report_script() { return between(unbruised_report_js, unbruised_report_js_end); }
std::string_view report_style() { return between(unbruised_report_css, unbruised_report_css_end); }
std::string_view report_notices() { return between(unbruised_report_notices, unbruised_report_notices_end); }

}  // namespace unbruised::studies
