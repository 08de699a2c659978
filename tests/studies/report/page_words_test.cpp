#include "studies/report/page_words.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/outcome/damage_limits.hpp"
#include "studies/config/schema.hpp"
#include "studies/report/report_data.hpp"
#include "tests/studies/report/report_fixtures.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;

TEST(PageWords, CallEveryMetricByWordsWithoutUnderscoresAndUnits) {
  const json words = page_words();
  for (const MetricInfo& info : kMetricTable) {
    const std::string name = words["names"].value(std::string(info.name), "");
    EXPECT_FALSE(name.empty()) << info.name;
    EXPECT_EQ(name.find('_'), std::string::npos) << name;
  }
}

TEST(PageWords, KnowTheUnitOfEveryKeyThatHasOne) {
  const json suffixes = page_words()["unit_suffixes"];
  for (const KeySpec& spec : key_table()) {
    const Unit* unit = unit_of(spec.path);
    if (unit == nullptr) continue;
    // The page takes the first ending that fits, as unit_of does.
    const auto found = std::find_if(suffixes.begin(), suffixes.end(), [&](const json& each) {
      return spec.path.ends_with(each[0].get<std::string>());
    });
    ASSERT_NE(found, suffixes.end()) << spec.path;
    EXPECT_EQ((*found)[1].get<std::string>(), unit->udunits) << spec.path;
  }
}

TEST(PageWords, NameTheMetricOfEveryDamageLimit) {
  const json limits = page_damage_limits();
  ASSERT_EQ(limits.size(), kDamageLimits.size());
  EXPECT_TRUE(std::any_of(limits.begin(), limits.end(), [](const json& each) {
    return each["metric"] == "contact_yield_ratio_max" && each["key"] == "contact_yield_ratio";
  }));
}

TEST(PageWords, BringTheSourceOfEveryValueToThePage) {
  const auto all = testing::report_fixtures();
  const json page = json::parse(report_data(all.front().content, all.front().context).json);
  const auto standing = [&](const std::string& key) {
    for (const json& source : page["sources"]) {
      if (source["key"] == key) return source["standing"].get<std::string>();
    }
    return std::string("not there");
  };
  EXPECT_EQ(standing("product.size_m"), "assumed");
  EXPECT_EQ(standing("product.mass_kg"), "cited");
  EXPECT_EQ(standing("product.friction"), "unsourced");
  EXPECT_EQ(standing("limits.slip_m"), "unsourced");
  EXPECT_EQ(standing("product.kind"), "not there");
}

}  // namespace
}  // namespace unbruised::studies
