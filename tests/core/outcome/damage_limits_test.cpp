#include "core/outcome/damage_limits.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/scenario/number_fields.hpp"

namespace unbruised {
namespace {

template <class Limit>
void expect_words_of(const Limit& limit) {
  const std::string metric(info_of(limit.metric).name);
  const std::string key(limit.key);
  EXPECT_EQ(limit.rule, metric + " <= " + key);
  EXPECT_EQ(limit.cause, metric + " > " + key);
}

TEST(Limits, AreToldByTheMetricAndTheKeyTheyJoin) {
  for (const DamageLimit& limit : kDamageLimits) expect_words_of(limit);
  for (const SlipLimit& limit : kSlipLimits) expect_words_of(limit);
  for (const PlaceLimit& limit : kPlaceLimits) expect_words_of(limit);
}

TEST(Limits, StandInOneTableEach) {
  std::map<std::string, int> rows;
  for (const DamageLimit& limit : kDamageLimits) ++rows[std::string(limit.key)];
  for (const SlipLimit& limit : kSlipLimits) ++rows[std::string(limit.key)];
  for (const PlaceLimit& limit : kPlaceLimits) ++rows[std::string(limit.key)];
  for (const NumberField& field : number_fields()) {
    if (field.path.starts_with("limits.")) {
      EXPECT_EQ(rows[std::string(field.path)], 1) << field.path;
    }
  }
  for (const auto& [key, count] : rows) EXPECT_NE(find_number_field(key), nullptr) << key;
}

TEST(Limits, AreExceededOnlyBeyondTheirBoundAndWhereTheyAreJudged) {
  LimitParameters limits;
  Metrics metrics;
  for (const SlipLimit& limit : kSlipLimits) {
    limits.*(limit.limit) = 1e-3;
    EXPECT_FALSE(exceeds(metrics, limit, limits)) << limit.key;  // NaN: not measured
    metrics[limit.metric] = 1e-3;
    EXPECT_FALSE(exceeds(metrics, limit, limits)) << limit.key;
    metrics[limit.metric] = 1.1e-3;
    EXPECT_TRUE(exceeds(metrics, limit, limits)) << limit.key;
  }
  for (const DamageLimit& limit : kDamageLimits) {
    metrics[limit.metric] = 2.0;
    EXPECT_FALSE(exceeds(metrics, limit, limits)) << limit.key;
    limits.*(limit.limit) = 2.0;
    EXPECT_FALSE(exceeds(metrics, limit, limits)) << limit.key;
    metrics[limit.metric] = 2.1;
    EXPECT_TRUE(exceeds(metrics, limit, limits)) << limit.key;
  }
  limits.damage = DamageJudging::not_considered;
  for (const DamageLimit& limit : kDamageLimits) EXPECT_FALSE(exceeds(metrics, limit, limits)) << limit.key;
  for (const SlipLimit& limit : kSlipLimits) EXPECT_TRUE(exceeds(metrics, limit, limits)) << limit.key;
}

}  // namespace
}  // namespace unbruised
