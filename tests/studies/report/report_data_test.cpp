#include "studies/report/report_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "studies/report/base64.hpp"
#include "studies/report/packed_columns.hpp"
#include "studies/report/report_trace.hpp"
#include "tests/studies/report/report_fixtures.hpp"

namespace unbruised::studies {
namespace {

using nlohmann::json;

const testing::ReportFixture& fixture(const std::string& name) {
  static const std::vector<testing::ReportFixture> all = testing::report_fixtures();
  for (const testing::ReportFixture& each : all) {
    if (each.name == name) return each;
  }
  throw std::runtime_error("no fixture " + name);
}

json page_of(const std::string& name) {
  return json::parse(report_data(fixture(name).content, fixture(name).context).json);
}

double value_at(const std::string& bytes, std::size_t at) {
  double value = 0.0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

TEST(Base64, AgreesWithTheExamplesOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfb\x00", 3)), "//sA");
}

TEST(PackedColumns, KeepShortColumnsReadableAndNumbersThatAreNotFiniteNull) {
  PackedColumns packed;
  const std::vector<double> values = {1.5, NAN, INFINITY, -INFINITY, 0.1};
  EXPECT_EQ(packed.numbers(values), json({1.5, nullptr, nullptr, nullptr, 0.1}));
  EXPECT_TRUE(packed.bytes().empty());
}

TEST(PackedColumns, WriteLongColumnsAsAlignedDoublesWithTheirBits) {
  PackedColumns packed;
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) values.push_back(std::sin(i));
  values[7] = INFINITY;
  std::vector<std::string> words(70, "a");
  words[3] = "b";
  ASSERT_EQ(packed.texts(words)["type"], "u8");  // 70 bytes: the next column is moved to a multiple of 8
  const json column = packed.numbers(values);
  EXPECT_EQ(column["type"], "f64");
  EXPECT_EQ(column["rows"], 100);
  const std::size_t at = column["at"];
  EXPECT_EQ(at, 72U);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double kept = value_at(packed.bytes(), at + 8 * i);
    EXPECT_TRUE(i == 7 ? std::isnan(kept) : kept == values[i]) << i;
  }
}

TEST(PackedColumns, WriteColumnsOfFewValuesAsIndices) {
  PackedColumns packed;
  std::vector<double> values(4000, 2.0);
  EXPECT_EQ(packed.numbers(values), json({{"constant", 2.0}, {"rows", 4000}}));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 3 == 0 ? NAN : static_cast<double>(i % 300);
  const json column = packed.numbers(values);
  EXPECT_EQ(column["type"], "u8");  // 200 numbers and "none"
  EXPECT_EQ(column["words"][0], nullptr);
  EXPECT_EQ(column["words"].size(), 201U);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i % 400);
  EXPECT_EQ(packed.numbers(values)["type"], "u16");
}

TEST(ReportData, HasEveryRowInputAndMetric) {
  const json page = page_of("kiwi_sweep");
  EXPECT_EQ(page["study"]["kind"], "sweep");
  EXPECT_EQ(page["scenarios"]["rows"], 512);
  EXPECT_EQ(page["scenarios"]["inputs"].size(), 3U);
  EXPECT_EQ(page["scenarios"]["inputs"][0]["name"], "strategy.grip_force_N");
  EXPECT_EQ(page["scenarios"]["metrics"].size(), kMetricCount);
  EXPECT_EQ(page["window"]["rows"], 32);
  EXPECT_LT(page["window"]["common"]["over"], 32);  // at the highest speed the impact alone damages
  EXPECT_TRUE(page["window"]["common"]["exists"]);
  EXPECT_FALSE(page["scenarios"]["seven_digits"]);
}

TEST(ReportData, SaysThatThereIsNoWindow) {
  const json common = page_of("no_window")["window"]["common"];
  EXPECT_FALSE(common["exists"]);
  EXPECT_EQ(common["over"], 0);
  EXPECT_EQ(common["of"], 1);
}

TEST(ReportData, NamesTheRowsThatSetTheEndsOfTheCommonWindow) {
  const json window = page_of("kiwi_window")["window"];
  const std::size_t row = window["common"]["damage_row"];
  EXPECT_EQ(row, 3U);  // the fastest approach damages first
  const json damage = window["columns"][1];
  EXPECT_EQ(damage["name"], "damage_force_N");
  EXPECT_EQ(damage["values"][row], window["common"]["damage_force_N"]);
}

TEST(ReportData, CarriesTablesWithTheirAttributesAndUnknownOnesToo) {
  const json page = page_of("unknown_table");
  ASSERT_EQ(page["tables"].size(), 2U);
  const json table = page["tables"][1];
  EXPECT_EQ(table["name"], "sorting_line");
  EXPECT_EQ(table["columns"][1]["values"], json({0.4, nullptr}));
  EXPECT_EQ(table["attributes"]["remark"], "from a later version");
}

TEST(ReportData, IsAsciiAndCannotEndItsScriptElement) {
  const ReportData data = report_data(fixture("hostile").content, fixture("hostile").context);
  for (const char letter : data.json) {
    ASSERT_TRUE(letter >= 0x20 && letter < 0x7f) << static_cast<int>(letter);
    ASSERT_TRUE(letter != '<' && letter != '>' && letter != '&');
  }
  EXPECT_EQ(json::parse(data.json)["study"]["name"], testing::hostile_texts()[0]);
}

TEST(ReportData, KeepsSevenDigitsOfMetricsWhereThereAreManyRows) {
  const testing::ReportFixture large = testing::large_fixture(22500);
  const json page = json::parse(report_data(large.content, large.context).json);
  EXPECT_TRUE(page["scenarios"]["seven_digits"]);
  EXPECT_EQ(page["scenarios"]["inputs"][0]["values"]["type"], "u8");  // 150 forces, all digits
}

TEST(ReportData, ThinsLongTracesWithoutLosingAPeak) {
  std::vector<double> values(100000, 0.0);
  values[54321] = 7.0;
  values[77777] = -3.0;
  const std::vector<double> kept = thinned_keeping_peaks(values);
  EXPECT_EQ(kept.size(), kTraceRowsMost);
  EXPECT_EQ(*std::max_element(kept.begin(), kept.end()), 7.0);
  EXPECT_EQ(*std::min_element(kept.begin(), kept.end()), -3.0);
  const json trace = page_of("long_hold")["trace"];
  EXPECT_TRUE(trace["thinned"]);
  EXPECT_EQ(trace["time_s"]["rows"], kTraceRowsMost);
}

TEST(ReportData, NamesTheCurvesOfASignalByItsDimensions) {
  const json signals = page_of("hold")["trace"]["signals"];
  EXPECT_EQ(signals[0]["curves"].size(), 6U);
  EXPECT_EQ(signals[0]["curves"][4]["name"], "finger 2, y");
  EXPECT_EQ(signals[2]["curves"][0]["name"], "");
}

TEST(ReportData, KeepsThePeaksInTheOrderInWhichTheyOccur) {
  std::vector<double> values(2 * kTraceRowsMost, 0.0);  // four rows become two
  values[0] = 5.0;
  values[3] = -5.0;
  values[5] = -1.0;
  values[6] = 1.0;
  const std::vector<double> kept = thinned_keeping_peaks(values);
  EXPECT_EQ(kept[0], 5.0);
  EXPECT_EQ(kept[1], -5.0);
  EXPECT_EQ(kept[2], -1.0);
  EXPECT_EQ(kept[3], 1.0);
}

}  // namespace
}  // namespace unbruised::studies
