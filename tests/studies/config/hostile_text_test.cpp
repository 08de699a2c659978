// Texts that no study is made of: slips that abort toml++ where its asserts are on, undefined behaviour it has on
// text outside ASCII, and sizes, depths and counts beyond any study. Each is answered, in every build.

#include <algorithm>
#include <memory>

#include "studies/config/document.hpp"
#include "studies/config/library.hpp"
#include "studies/config/problems.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using testing::errors_of;
using testing::gripped_block;
using testing::small_network;

/// One message, at `line`, that contains `words`.
void expect_refused(const std::string& text, int line, const std::string& words) {
  const auto errors = errors_of(text);
  ASSERT_FALSE(errors.empty()) << text.substr(0, 200);
  EXPECT_EQ(errors.front().substr(0, 12 + std::to_string(line).size()), "study.toml:" + std::to_string(line) + ":")
      << errors.front();
  EXPECT_NE(errors.front().find(words), std::string::npos) << errors.front();
}

TEST(HostileText, SlipsThatAbortTheParserWhereItsAssertsAreOnAreAnswered) {
  for (const std::string slip : {"[.]",
                                 "[ = 1",
                                 "[{a}]",
                                 "[ {pr",
                                 "[a.]",
                                 "[.a]",
                                 "[[.]]",
                                 "[[",
                                 "[]",
                                 "a..b = 1",
                                 ".a = 1",
                                 "= 1",
                                 "a = [",
                                 "a = {",
                                 "a = \"",
                                 "a = \"\"\"",
                                 "a = '''",
                                 "a = 0x",
                                 "a = 1__0",
                                 "a = 1e",
                                 "a = 2020-13-01",
                                 "[[a]",
                                 "[a",
                                 "a.b",
                                 "[a]]",
                                 "a = [1, , 2]",
                                 "a = {b = 1,}",
                                 "a = \"\\q\"",
                                 "a = \"\\uD800\"",
                                 "a = +",
                                 "\x01 = 1",
                                 "a = 1 b = 2",
                                 "[\"a]"}) {
    expect_refused("# a study\n" + slip + "\n", 2, "not valid TOML");
    expect_refused("# a study\n" + slip, 2, "not valid TOML");
  }
}

TEST(HostileText, CharactersOutsideAsciiAreRefusedWhereTheParserIsUndefinedOnThem) {
  // Every range that RFC 3629 allows, and the blanks and letters that toml++ 3.3.0 looks up in its tables.
  for (const std::string letter :
       {"\xC2\x80", "\xC2\xA0", "\xDF\xBF", "\xE0\xA0\x80", "\xE1\x9A\x80", "\xE2\x80\x80", "\xE2\x80\xA8",
        "\xE2\x80\xAF", "\xE3\x80\x80", "\xED\x9F\xBF", "\xEE\x80\x80", "\xEF\xBB\xBF", "\xEF\xBF\xBD",
        "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    for (const std::string& place : {letter + " = 1", "a" + letter + " = 1", "[" + letter + "]", "a = " + letter,
                                     "a = 1" + letter, "a = [1," + letter + "]", "a." + letter + " = 1"}) {
      expect_refused("# a study\n" + place + "\n", 2, "may stand only in comments and quoted strings");
    }
    const std::string spoken = gripped_block("simulate") + "[strategy]  # " + letter + "\nspeed_m_s = 1.0\n";
    EXPECT_EQ(errors_of(spoken), std::vector<std::string>{}) << letter;
    const std::string quoted = "[study]\ndescription = \"" + letter + "\"\n" + gripped_block("simulate").substr(8);
    EXPECT_EQ(errors_of(quoted), std::vector<std::string>{}) << letter;
  }
}

TEST(HostileText, AQuoteInsideAValueOpensNoString) {
  // The first of these was found by fuzzing: toml++ looks for the end of `0.a'Þ`, and `Þ` is no string's to it.
  for (const std::string value :
       {"0.a'Þ (1(", "1\"Þ\"", "1='Þ'", "1['Þ']", "1{'Þ'}", "'x''Þ'", "[1'Þ']", "[1['Þ']]", "{b = 1'Þ'}",
        "{b = 1{'Þ'}}", "[[1], 1'Þ']", "[1] 'Þ'", "1979-05-27 0'Þ'", "{b = [1], c = 1'Þ'}"}) {
    expect_refused("# a study\na = " + value + "\n", 2, "may stand only in comments and quoted strings");
  }
  for (const std::string line :
       {"a='Þ'", "a = \"Þ\"", "a = ['Þ', \"Þ\"]", "a = [['Þ'], ['Þ']]", "a = [\n'Þ', # Þ\n'Þ'\n]",
        "a = {b='Þ', c = [1, 'Þ'], d = 'Þ'}", "a = [{b = 1, c = 'Þ'}, {b = 'Þ'}]", "'Þ' = 1", "a.'Þ' = 1", "['Þ']",
        "[['Þ']]", "a = \"\"\"\nÞ\"\"\"", "a = '''\nÞ'''", "a = 1\n'Þ' = 2", "a = [1]\n'Þ' = 2",
        "a = {'Þ' = 1}"}) {
    for (const std::string& error : errors_of(line + "\n")) {
      EXPECT_EQ(error.find("may stand only"), std::string::npos) << error;
      EXPECT_EQ(error.find("not valid TOML"), std::string::npos) << error;
    }
  }
}

TEST(HostileText, BytesThatAreNotUtf8AreRefusedEverywhere) {
  for (const std::string bytes :
       {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80", "\xE2\x80",
        "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFE", "\xFF", "\xFF\xFE"}) {
    for (const std::string& place : {"# " + bytes, "a = \"" + bytes + "\"", "a = '''\n" + bytes + "'''", bytes}) {
      const auto errors = errors_of(place + "\n");
      ASSERT_EQ(errors.size(), 1U) << place;
      EXPECT_NE(errors.front().find("the text is not valid UTF-8"), std::string::npos) << errors.front();
    }
  }
  expect_refused(std::string("a = 1\n\0", 7), 2, "a NUL byte");
}

TEST(HostileText, NestingIsLimited) {
  const auto nested = [](std::size_t depth) {
    return gripped_block("simulate") + "[strategy]\nspeed_m_s = " + std::string(depth, '[') +
           std::string(depth, ']') + "\n";
  };
  expect_refused(nested(100), 11, "must be a number in m/s");
  for (const std::size_t depth : {300U, 100'000U}) expect_refused(nested(depth), 11, "not valid TOML");
  std::string tables = "a = ";
  for (int i = 0; i < 300; ++i) tables += "{a = ";
  expect_refused("# a study\n" + tables, 2, "not valid TOML");
}

TEST(HostileText, DottedKeysCannotExhaustTheStack) {
  expect_refused("a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q.r = 1\n", 1, "a key of more than 17 parts");
  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  EXPECT_FALSE(errors_of(key + " = 1\n").empty());
  EXPECT_FALSE(errors_of("[" + key + "]\nx = 1\n").empty());
}

TEST(HostileText, CountsAreLimited) {
  const auto vary = [](const std::string& key, const std::string& count) {
    return "[[vary]]\nkey = \"" + key + "\"\nfrom = 1.0\nto = 2.0\ncount = " + count + "\n";
  };
  const std::string sweep = gripped_block("sweep");
  for (const std::string count : {"10000001", "9223372036854775807", "1e300", "-1", "0"}) {
    expect_refused(sweep + vary("strategy.grip_force_N", count), 14, "must be >= 1, <= 1e7");
  }
  expect_refused(sweep + vary("strategy.grip_force_N", "10000") + vary("strategy.hold_s", "1001"), 10,
                 "more than 10,000,000 scenarios");
  std::string many = sweep;
  for (const char* key : {"strategy.grip_force_N", "strategy.hold_s"})
    many += vary(key, "6000000") + "zip = \"a\"\n";
  expect_refused(many, 16, "more than 10,000,000 values in all blocks");
  for (const std::string set :
       {"variable[18446744073709551616].key=\"a\"", "vary[4294967296].key=\"a\"",
        "product.particle[99999999999999999999].mass_kg=1", "product.size_m[4294967296]=1"}) {
    EXPECT_FALSE(errors_of(gripped_block("simulate"), {set}).empty()) << set;
  }
}

TEST(HostileText, NumbersBeyondAnIntegerAreRefused) {
  for (const std::string value :
       {"[0, 3000000000]", "[0, 1e300]", "[-1, 1]", "[0, 0.5]", "[0, nan]", "[0, inf]"}) {
    std::string text = small_network();
    const std::string was = "between = [0, 1]";
    text.replace(text.find(was), was.size(), "between = " + value);
    EXPECT_FALSE(errors_of(text).empty()) << value;
  }
  for (const std::string value : {"nan", "inf", "-inf", "+nan", "1e400"}) {
    for (const std::string key :
         {"product.mass_kg", "strategy.speed_m_s", "cell.gravity_m_s2[2]", "simulation.theta", "limits.slip_m"}) {
      EXPECT_FALSE(errors_of(gripped_block("simulate"), {key + "=" + value}).empty()) << key << " = " << value;
    }
  }
}

TEST(HostileText, PathsAreLimited) {
  for (const std::string& path : {std::string(5000, 'a'), std::string("products/kiwi_ripe.toml\\u0000x")}) {
    const auto errors =
        errors_of("[study]\nname = \"t\"\nkind = \"simulate\"\n[product]\nuse = \"" + path + "\"\n");
    ASSERT_FALSE(errors.empty());
    EXPECT_NE(errors.front().find("is not the path of a file"), std::string::npos) << errors.front();
  }
  const auto errors = errors_of("[study]\nname = \"t\"\nkind = \"simulate\"\n[product]\nuse = \"/dev/zero\"\n");
  ASSERT_FALSE(errors.empty());
  EXPECT_NE(errors.front().find("not a file"), std::string::npos) << errors.front();
}

TEST(HostileText, NoMessageCarriesAControlCharacterOrAVeryLongKey) {
  const std::string escape = "\\u001B]0;owned\\u0007";
  for (const std::string& line :
       {"\"" + escape + "\" = 1", "[\"" + escape + "\"]\na = 1", "[study]\nname = \"" + escape + "\"",
        "[[vary]]\nkey = \"" + escape + "\"\nvalues = [1]", "[product]\nuse = \"" + escape + "\"",
        std::string(100'000, 'k') + " = 1"}) {
    for (const std::string& message : errors_of(line + "\n")) {
      EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20;
      })) << message;
      EXPECT_LT(message.size(), 1000U) << line.substr(0, 80);
    }
  }
}

TEST(HostileText, AListFromCsvIsAnsweredLineByLine) {
  const auto first_problem = [](const std::string& csv) {
    Problems problems;
    (void)csv_entries("product.particle", csv, std::make_shared<const std::string>("list.csv"), 1, problems);
    const auto lines = problems.lines();
    return lines.empty() ? std::string() : lines.front();
  };
  EXPECT_EQ(first_problem(""), "list.csv:1: product.particle: the file has no rows");
  EXPECT_EQ(first_problem("mass_kg\n"), "list.csv:1: product.particle: the file has no rows");
  EXPECT_EQ(first_problem("mass_kg,\x1B[2J\n"),
            "list.csv:1: ?[2J: unknown column; docs/config.md lists the columns of CSV files");
  EXPECT_EQ(first_problem("mass_kg\n1,2\n"),
            "list.csv:2: product.particle: a row must have as many cells as the first line has (1), not 2");
  std::string long_list = "mass_kg\n";
  for (int i = 0; i <= kMaxListRows; ++i) long_list += "1\n";
  EXPECT_EQ(first_problem(long_list), "list.csv:1000002: product.particle: more than 1,000,000 rows");
}

}  // namespace
}  // namespace unbruised::studies
