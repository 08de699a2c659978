#pragma once

/// @file
/// Scores of the normal and of Student's distribution: how many standard deviations an interval of a confidence
/// reaches to either side.

namespace unbruised::studies {

/// z of the normal distribution, e.g. 1.96 at 0.95. @param confidence in (0, 1)
double normal_score(double confidence);
/// z below which the part `u` of the normal distribution lies; 0 < u < 1.
double normal_quantile(double u);
/// The part of the normal distribution below z.
double normal_part(double z);
/// t of Student's distribution. @param degrees_of_freedom > 0 @param confidence in (0, 1)
double student_score(double degrees_of_freedom, double confidence);

}  // namespace unbruised::studies
