#include "studies/report/page_words.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

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
  const auto names = page_words()["names"].get<std::map<std::string, std::string>>();
  for (const MetricInfo& info : kMetricTable) {
    const auto found = names.find(std::string(info.name));
    ASSERT_NE(found, names.end()) << info.name;
    const std::string& name = found->second;
    EXPECT_EQ(name.find('_'), std::string::npos) << name;
  }
}

TEST(PageWords, KnowTheUnitOfEveryKeyThatHasOne) {
  const auto suffixes = page_words()["unit_suffixes"].get<std::vector<std::pair<std::string, std::string>>>();
  for (const KeySpec& spec : key_table()) {
    const Unit* unit = unit_of(spec.path);
    if (unit == nullptr) continue;
    // The page takes the first ending that fits, as unit_of does.
    const auto found = std::find_if(suffixes.begin(), suffixes.end(),
                                    [&](const auto& each) { return spec.path.ends_with(each.first); });
    ASSERT_NE(found, suffixes.end()) << spec.path;
    EXPECT_EQ(found->second, unit->udunits) << spec.path;
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
