#pragma once

/// What is said on a machine whose instruction set no library is compiled for.
inline constexpr const char* kTooOld =
    "this build needs a processor with AVX2 and fused multiply-add (x86-64-v3: Intel since 2013, AMD since 2015), "
    "which this one is not; build the sources on it (docs/install.md)";
