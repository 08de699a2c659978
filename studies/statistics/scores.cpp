#include "studies/statistics/scores.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "studies/statistics/boost_policy.hpp"

namespace unbruised::studies {
namespace {

namespace bm = boost::math;

/// The z or t that a symmetric distribution exceeds on either side with (1 - confidence) / 2.
template <class BoostDistribution>
double two_sided(const BoostDistribution& distribution, double confidence) {
  return bm::quantile(bm::complement(distribution, 0.5 * (1.0 - confidence)));
}

}  // namespace

double normal_score(double confidence) {
  return two_sided(bm::normal_distribution<double, QuietPolicy>(0.0, 1.0), confidence);
}

double normal_quantile(double u) {
  return bm::quantile(bm::normal_distribution<double, QuietPolicy>(0.0, 1.0), u);
}

double normal_part(double z) { return bm::cdf(bm::normal_distribution<double, QuietPolicy>(0.0, 1.0), z); }

double student_score(double degrees_of_freedom, double confidence) {
  return two_sided(bm::students_t_distribution<double, QuietPolicy>(degrees_of_freedom), confidence);
}

}  // namespace unbruised::studies
