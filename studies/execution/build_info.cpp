#include "studies/execution/build_info.hpp"

#include "core/algebra/sparse_cholesky.hpp"
#include "studies/text/joined.hpp"

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif

namespace unbruised::studies {
namespace {

/// The library of exp, pow and sin. glibc picks their code by the CPU it runs on: with fused multiply-add or
/// without.
std::string libm_text() {
#if defined(__GLIBC__)
  std::string text = joined({"glibc ", gnu_get_libc_version()});
#if defined(__x86_64__)
  if (__builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2")) text += " with fma";
#endif
  return text;
#else
  return "another libm";
#endif
}

}  // namespace

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

std::string compiler_and_libraries() {
  return joined({compiler_text(), " ", UNBRUISED_NUMERIC_FLAGS, ", ", libm_text(), ", ", cholesky_library()});
}

std::string numeric_build() { return joined({compiler_and_libraries(), ", ", instruction_set()}); }

std::string build_line() { return joined({"unbruised ", program_version(), ", ", numeric_build()}); }

}  // namespace unbruised::studies
