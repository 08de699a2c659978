#pragma once

/// @file
/// Numbers below 2.2e-308 count as zero while scenarios advance.

#include <xmmintrin.h>

namespace unbruised {

/// While one lives, its thread takes and gives zero for subnormal numbers (MXCSR's DAZ and FTZ). What fades by a
/// factor in every step gets there in the end, and with such numbers an Intel processor takes a hundred times as
/// long for each operation: four fifths of a sweep by modes.
class FlushSubnormals {
 public:
  FlushSubnormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | kFlushResults | kOperandsAreZero); }
  ~FlushSubnormals() { _mm_setcsr(before_); }
  FlushSubnormals(const FlushSubnormals&) = delete;
  FlushSubnormals& operator=(const FlushSubnormals&) = delete;

 private:
  static constexpr unsigned kFlushResults = 0x8000, kOperandsAreZero = 0x0040;
  unsigned before_;
};

}  // namespace unbruised
