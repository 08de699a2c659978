#pragma once

/// @file
/// How many standard deviations an interval of a confidence reaches to either side.

namespace unbruised::studies {

/// z of the normal distribution, e.g. 1.96 at 0.95. @param confidence in (0, 1)
double normal_score(double confidence);
/// t of Student's distribution. @param degrees_of_freedom > 0 @param confidence in (0, 1)
double student_score(double degrees_of_freedom, double confidence);

}  // namespace unbruised::studies
