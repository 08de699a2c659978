# What every target of ours is compiled with, and nobody else's: they link it privately. Third-party headers come in as system headers, so the
# warnings speak of our code only.
add_library(unbruised_options INTERFACE)
target_include_directories(unbruised_options INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_compile_options(unbruised_options INTERFACE
  -march=${UNBRUISED_ARCH}
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
  -Woverloaded-virtual -Wcast-align -Wnull-dereference -Wimplicit-fallthrough
  -Werror
  # GCC 12 sees uninitialised values inside its own AVX-512 headers (PR 105593).
  -Wno-uninitialized $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
  # ... and overlaps in "literal" + std::string (PR 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  -fno-math-errno -fno-trapping-math -fopenmp-simd
  # In a * b + c * d the compiler may fuse either product, and does not choose alike in the two halves of a lane value:
  # a scenario's bits would depend on its lane. Kernels of the plain form c += a * b switch it on again.
  -ffp-contract=off)
# 512-bit vectors where the machine has them: the lane kernels are written for them.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-mprefer-vector-width=512 UNBRUISED_HAS_VECTOR_WIDTH_FLAG)
if(UNBRUISED_HAS_VECTOR_WIDTH_FLAG)
  target_compile_options(unbruised_options INTERFACE -mprefer-vector-width=512)
endif()
# GCC 12 does not see that Eigen's loops of 8 numbers skip vectors of 6 (reads past their end, in Eigen's headers).
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_FLAGS -march=${UNBRUISED_ARCH})
check_cxx_source_compiles("#ifndef __AVX512F__\n#error\n#endif\nint main() {}" UNBRUISED_HAS_AVX512)
unset(CMAKE_REQUIRED_FLAGS)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND UNBRUISED_HAS_AVX512)
  target_compile_options(unbruised_options INTERFACE -Wno-array-bounds -Wno-stringop-overread)
endif()
# clang makes nothing of masked assignments in the AVX-512 form of libstdc++ 12's <experimental/simd>.
check_cxx_compiler_flag(-mno-avx512f UNBRUISED_HAS_AVX512_FLAG)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND UNBRUISED_HAS_AVX512_FLAG)
  target_compile_options(unbruised_options INTERFACE -mno-avx512f)
endif()
if(UNBRUISED_SANITIZER)
  # -O2: the physics is too slow with less. The warnings that count are GCC's.
  target_compile_options(unbruised_options INTERFACE -fsanitize=${UNBRUISED_SANITIZER} -fno-sanitize-recover=all
    -fno-omit-frame-pointer -O2 -Wno-error)
  target_compile_definitions(unbruised_options INTERFACE UNBRUISED_SANITIZER)
  target_link_options(unbruised_options INTERFACE -fsanitize=${UNBRUISED_SANITIZER})
endif()
if(UNBRUISED_FUZZ)
  target_compile_options(unbruised_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(UNBRUISED_COVERAGE)
  # Counters are not atomic: threads may lose counts, but a line that ran has one. Atomic ones take ten times as long.
  target_compile_options(unbruised_options INTERFACE --coverage)
  target_link_options(unbruised_options INTERFACE --coverage)
endif()
# Asserts cost little beside the kernels; the presets decide with NDEBUG.
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g")

# The libraries are part of the program and of Python's module alike. Hidden, their functions are called and inlined as in a
# program: the same bits, as fast.
function(unbruised_goes_into_modules target)
  if(NOT UNBRUISED_PYTHON_MODULE AND NOT UNBRUISED_PORTABLE)
    return()
  endif()
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
endfunction()
