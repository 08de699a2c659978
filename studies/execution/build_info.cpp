#include "studies/execution/build_info.hpp"

#include "studies/text/joined.hpp"

namespace unbruised::studies {

std::string program_version() { return UNBRUISED_VERSION; }

std::string compiler_text() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GNU " __VERSION__;
#endif
}

std::string instruction_set() {
#if defined(__AVX512F__)
  return "avx512f";
#elif defined(__AVX2__) && defined(__FMA__)
  return "avx2+fma";
#elif defined(__AVX2__)
  return "avx2";
#elif defined(__AVX__)
  return "avx";
#elif defined(__x86_64__)
  return "sse2";
#elif defined(__ARM_NEON)
  return "neon";
#else
  return "scalar";
#endif
}

std::string build_line() {
  return joined({"unbruised ", program_version(), ", ", compiler_text(), ", ", instruction_set()});
}

}  // namespace unbruised::studies
