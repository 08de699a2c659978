// The arrows of docs/architecture.md, read from the include lines.

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/include_lines.hpp"
#include "tests/places.hpp"

namespace unbruised {
namespace {

const std::vector<std::string> kHouses = {"core",       "optimizer", "studies", "python",
                                          "benchmarks", "examples",  "tests"};

/// Whom each house may include.
const std::map<std::string, std::vector<std::string>> kArrows = {
    {"core", {"core"}},
    {"optimizer", {"optimizer"}},
    {"studies", {"studies", "core", "optimizer"}},
    {"python", {"python", "studies", "core", "optimizer"}},
    {"examples", {"core"}},
    {"benchmarks", {"benchmarks", "studies", "core", "optimizer"}},
    {"tests", {"tests", "benchmarks", "studies", "core", "optimizer"}},
};

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> all = read_sources(UNBRUISED_SOURCE_DIR, kHouses);
  return all;
}

/// The floors of studies, from the ground up: a folder sees itself and what stands below it.
const std::vector<std::string> kStudiesFloors = {"text",    "process",   "statistics", "goals",  "config",
                                                 "results", "scenarios", "execution",  "ranks",  "findings",
                                                 "kinds",   "estimate",  "controller", "report", "cli"};

/// Whom each folder of core may include, besides itself.
const std::map<std::string, std::vector<std::string>> kCoreArrows = {
    {"door", {}},
    {"scenario", {"door"}},
    {"lanes", {}},
    {"chance", {}},
    {"integration", {}},
    {"surface", {"door", "scenario", "lanes"}},
    {"algebra", {"door", "lanes"}},
    {"motion", {"door", "scenario"}},
    {"robot", {"door", "scenario", "motion"}},
    {"frame", {"door", "lanes", "integration"}},
    {"body", {"door", "scenario", "lanes", "chance", "algebra", "integration", "frame"}},
    {"material", {"door", "scenario", "lanes", "integration", "body"}},
    {"gripper", {"door", "scenario", "lanes", "algebra", "integration", "surface", "body"}},
    {"contact", {"door", "scenario", "lanes", "algebra", "integration", "frame", "body", "surface", "gripper"}},
    {"sensor", {"door", "scenario", "lanes", "chance", "frame", "body", "surface", "gripper"}},
    {"outcome", {"scenario", "motion", "surface", "contact"}},
    {"simulation",
     {"door", "scenario", "lanes", "algebra", "integration", "frame", "motion", "robot", "body", "material",
      "surface", "gripper", "sensor", "contact", "outcome"}},
};

std::string house_of(const std::string& path) { return path.substr(0, path.find('/')); }

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Calls `check` for every include line of the repository.
void for_every_include(const std::function<void(const IncludeLine&)>& check) {
  for (const SourceFile& source : sources()) {
    for (const IncludeLine& include : source.includes) check(include);
  }
}

std::string place(const IncludeLine& include) {
  return include.file + ":" + std::to_string(include.line) + ": " + include.target;
}

/// Fails where a header that matches `header` is included from a file outside `folders`. Tests may look anywhere.
void expect_included_only_below(const std::string& header, const std::vector<std::string>& folders) {
  const std::regex pattern(header);
  for_every_include([&](const IncludeLine& include) {
    if (house_of(include.file) == "tests" || !std::regex_search(include.target, pattern)) return;
    const bool allowed = std::any_of(folders.begin(), folders.end(),
                                     [&](const std::string& folder) { return include.file.starts_with(folder); });
    EXPECT_TRUE(allowed) << place(include) << " belongs behind the doors of " << folders.front();
  });
}

TEST(IncludeLines, AreReadWithTheirLineAndKindAndNotFromCommentsOrLiterals) {
  const std::string text =
      "#pragma once\n"
      "// #include \"core/no.hpp\"\n"
      "/* #include <no>\n#include <no> */\n"
      "#include <vector>  // why\n"
      "  #  include \"core/a.hpp\"\n"
      "const char* s = R\"x(\n#include <no>\n)x\";\n"
      "int n = 1'000; char c = '\"'; // \"\n"
      "#include <map>\n";
  const std::vector<IncludeLine> includes = include_lines(text, "f.hpp");
  ASSERT_EQ(includes.size(), 3U);
  EXPECT_EQ(includes[0].target, "vector");
  EXPECT_EQ(includes[0].line, 5);
  EXPECT_FALSE(includes[0].quoted);
  EXPECT_EQ(includes[1].target, "core/a.hpp");
  EXPECT_EQ(includes[1].line, 6);
  EXPECT_TRUE(includes[1].quoted);
  EXPECT_EQ(includes[2].line, 11);
}

TEST(IncludeLines, LeaveCodeWithoutTheWordsOfCommentsAndLiterals) {
  const std::string code =
      without_comments_and_literals("f(\"printf \\\" x\"); /* printf */ g(); // printf\nh();\n");
  EXPECT_EQ(code.find("printf"), std::string::npos);
  EXPECT_NE(code.find("g();"), std::string::npos);
  EXPECT_NE(code.find("\nh();"), std::string::npos);
}

TEST(Architecture, TheSourcesAreFound) {
  EXPECT_TRUE(std::any_of(sources().begin(), sources().end(),
                          [](const SourceFile& s) { return s.path == "core/scenario/scenario.hpp"; }));
}

TEST(Architecture, QuotedIncludesStartWithAHouse) {
  for_every_include([](const IncludeLine& include) {
    // Generated headers stand under generated/<house>/ and so look like any other.
    EXPECT_EQ(include.quoted, contains(kHouses, house_of(include.target))) << place(include);
  });
}

TEST(Architecture, ArrowsPointOneWay) {
  for_every_include([](const IncludeLine& include) {
    if (!include.quoted) return;
    const std::string from = house_of(include.file);
    EXPECT_TRUE(contains(kArrows.at(from), house_of(include.target)))
        << place(include) << ": " << from << " may not see " << house_of(include.target);
  });
}

TEST(Architecture, FoldersOfStudiesSeeOnlyTheFloorsBelow) {
  const std::string house = "studies/";
  const auto floor_of = [&](const std::string& path) {
    const std::string folder = path.substr(house.size(), path.find('/', house.size()) - house.size());
    return std::find(kStudiesFloors.begin(), kStudiesFloors.end(), folder) - kStudiesFloors.begin();
  };
  const auto floors = static_cast<std::ptrdiff_t>(kStudiesFloors.size());
  for_every_include([&](const IncludeLine& include) {
    if (!include.file.starts_with(house) || !include.target.starts_with(house)) return;
    EXPECT_LT(floor_of(include.file), floors) << include.file << ": a folder without a floor";
    EXPECT_LE(floor_of(include.target), floor_of(include.file)) << place(include) << ": a floor above";
  });
}

std::string folder_of(const std::string& path) {
  const std::size_t start = path.find('/') + 1;
  return path.substr(start, path.find('/', start) - start);
}

/// Is an include line of core allowed by the table?
bool is_allowed_in_core(const IncludeLine& include) {
  const std::string from = folder_of(include.file), to = folder_of(include.target);
  const auto arrows = kCoreArrows.find(from);
  return arrows != kCoreArrows.end() && (from == to || contains(arrows->second, to));
}

/// What the include lines of one file of core see against the table, one sentence each.
std::vector<std::string> forbidden_in_core(const std::vector<IncludeLine>& includes) {
  std::vector<std::string> found;
  for (const IncludeLine& include : includes) {
    if (!include.file.starts_with("core/") || !include.target.starts_with("core/")) continue;
    if (!is_allowed_in_core(include))
      found.push_back(place(include) + ": no arrow from " + folder_of(include.file));
  }
  return found;
}

TEST(Architecture, FoldersOfCoreSeeOnlyWhomTheTableAllows) {
  for (const SourceFile& source : sources()) {
    EXPECT_EQ(forbidden_in_core(source.includes), std::vector<std::string>{}) << source.path;
  }
}

TEST(Architecture, TheTableOfCoreHasNoCircle) {
  // Taking away folders that see none of the rest has to end with nothing left.
  std::map<std::string, std::vector<std::string>> rest = kCoreArrows;
  for (bool progress = true; progress;) {
    progress = false;
    for (auto it = rest.begin(); it != rest.end(); ++it) {
      const bool free = std::none_of(it->second.begin(), it->second.end(),
                                     [&](const std::string& seen) { return rest.contains(seen); });
      if (!free) continue;
      rest.erase(it);
      progress = true;
      break;
    }
  }
  EXPECT_TRUE(rest.empty()) << rest.begin()->first << " is part of a circle";
}

TEST(Architecture, APlantedArrowAgainstTheTableIsSeen) {
  const std::string text =
      "#include \"core/scenario/true_shape.hpp\"\n"
      "// #include \"core/simulation/simulation.hpp\"\n"
      "#include \"core/contact/contact_model.hpp\"\n";
  const std::vector<std::string> forbidden = forbidden_in_core(include_lines(text, "core/body/lattice.hpp"));
  ASSERT_EQ(forbidden.size(), 1U);
  EXPECT_EQ(forbidden.front(), "core/body/lattice.hpp:3: core/contact/contact_model.hpp: no arrow from body");
  EXPECT_TRUE(forbidden_in_core(include_lines(text, "core/simulation/model.cpp")).empty());
  EXPECT_EQ(forbidden_in_core(include_lines(text, "core/unknown/file.hpp")).size(), 2U)
      << "a folder without a row";
}

/// A kind is a row: code asks for a property of the row, not for a kind by name. A default of a struct is no
/// question.
TEST(Architecture, StudyKindsAreNamedInTheirTablesOnly) {
  const std::regex named(R"(StudyKind::\w+)");
  const std::regex is_default(R"(StudyKind kind = StudyKind::\w+;)");
  for (const SourceFile& source : sources()) {
    const bool is_table =
        source.path == "studies/config/study_kind.cpp" || source.path == "studies/kinds/kind_table.cpp";
    if (is_table || house_of(source.path) != "studies") continue;
    const std::string code = std::regex_replace(source.code, is_default, "");
    EXPECT_FALSE(std::regex_search(code, named)) << source.path << " names a study kind";
  }
}

/// Above the folders that know the kinds of product, code asks what it wants to know, not what the product is:
/// where the answer needs the kind, there is an overload for each, and a kind without one does not compile.
TEST(Architecture, OnlyScenarioAndBodyAskWhatAProductIs) {
  const std::regex asked(R"(\b(get_if|get|holds_alternative)<(Lattice|Network)Parameters>|\blattice \?)");
  for (const SourceFile& source : sources()) {
    const std::string folder = folder_of(source.path);
    if (house_of(source.path) != "core" || folder == "scenario" || folder == "body") continue;
    EXPECT_FALSE(std::regex_search(source.code, asked)) << source.path << " asks what the product is";
  }
}

/// Whoever asks what moves the pads asks the gripper of the lane, whatever its kind.
TEST(Architecture, OnlyTheFolderOfGrippersKnowsTheLanesOfAKind) {
  const std::regex named(R"(\bFingerLanes\b)");
  for (const SourceFile& source : sources()) {
    if (house_of(source.path) != "core" || folder_of(source.path) == "gripper") continue;
    EXPECT_FALSE(std::regex_search(source.code, named)) << source.path << " names a kind's lanes";
  }
}

/// Where it is told to leave vector code alone; tests too, since a linker may take their copy of a template.
TEST(Architecture, EigenIsIncludedByItsDoor) {
  for_every_include([](const IncludeLine& include) {
    const bool is_eigen = include.target.starts_with("Eigen/");
    EXPECT_TRUE(!is_eigen || include.file == "core/door/eigen.hpp") << place(include);
  });
}

TEST(Architecture, CholmodStaysInAlgebra) {
  expect_included_only_below("(cholmod|SuiteSparse|^(amd|camd|colamd|ccolamd|umfpack|klu)\\b)", {"core/algebra/"});
}

TEST(Architecture, NloptIsIncludedByOneFileOfTheOptimizer) {
  expect_included_only_below("\\bnlopt\\b", {"optimizer/"});
  std::vector<std::string> files;
  for_every_include([&](const IncludeLine& include) {
    const bool nlopt = !include.quoted && include.target.starts_with("nlopt");
    if (nlopt && house_of(include.file) == "optimizer" && !contains(files, include.file))
      files.push_back(include.file);
  });
  EXPECT_LE(files.size(), 1U) << testing::PrintToString(files);
}

TEST(Architecture, Hdf5StaysInResults) {
  expect_included_only_below("^(hdf5|H5[A-Za-z]*public|hdf5_hl|H5Cpp)", {"studies/results/"});
}

TEST(Architecture, OpenSslStaysInChecksum) {
  expect_included_only_below("^openssl/", {"studies/results/checksum"});
}

TEST(Architecture, UrdfdomAndKdlStayBehindTheirDoors) {
  expect_included_only_below("^(urdf_parser|urdf_model|urdf_exception|console_bridge|kdl)/",
                             {"studies/config/urdf_arm"});
  expect_included_only_below("^assimp/", {"studies/config/mesh_reader"});
}

TEST(Architecture, TomlStaysInConfig) {
  expect_included_only_below("^toml(\\+\\+|\\.hpp|plusplus)", {"studies/config/"});
}

TEST(Architecture, JsonStaysInReportAndCli) {
  expect_included_only_below("^nlohmann/", {"studies/report/", "studies/cli/"});
}

TEST(Architecture, Random123StaysInChance) { expect_included_only_below("^Random123/", {"core/chance/"}); }

TEST(Architecture, BoostAndRandom123StayInSources) {
  expect_included_only_below("^boost/", {"studies/statistics/"});
  // Nor do they come in by another way: no public header of the folder passes them on.
  for_every_include([](const IncludeLine& include) {
    if (include.target != "studies/statistics/boost_policy.hpp") return;
    EXPECT_TRUE(include.file.starts_with("studies/statistics/") && include.file.ends_with(".cpp"))
        << place(include);
  });
  const std::regex library("^(boost|Random123)/");
  for_every_include([&](const IncludeLine& include) {
    const bool is_policy = include.file == "studies/statistics/boost_policy.hpp";
    if (house_of(include.file) == "tests" || is_policy || !std::regex_search(include.target, library)) return;
    EXPECT_TRUE(include.file.ends_with(".cpp")) << place(include) << ": not in a header";
  });
}

TEST(Architecture, TheCommandLineLibraryStaysInCli) { expect_included_only_below("^CLI/", {"studies/cli/"}); }

TEST(Architecture, PythonAndMpiStayBehindTheirDoors) {
  expect_included_only_below("^(pybind11/|Python\\.h)", {"python/"});
  expect_included_only_below("^mpi\\.h", {"studies/ranks/mpi_link.cpp"});
}

TEST(Architecture, CoreAndOptimizerKnowNoThreadsLibrary) {
  expect_included_only_below("^(tbb|oneapi/tbb)/", {"studies/", "benchmarks/"});
}

TEST(Architecture, CoreHasNoFilesThreadsClockOrChance) {
  const std::vector<std::string> banned = {
      "iostream", "fstream", "ostream", "istream",      "print",      "syncstream", "thread",
      "mutex",    "future",  "atomic",  "shared_mutex", "stop_token", "semaphore",  "condition_variable",
      "chrono",   "ctime",   "time.h",  "random",       "filesystem", "sys/time.h", "unistd.h"};
  for_every_include([&](const IncludeLine& include) {
    if (house_of(include.file) != "core" || include.quoted) return;
    // The one clock of core: part times for benchmarks, which no result depends on.
    if (include.file == "core/lanes/part_timer.hpp" && include.target == "chrono") return;
    // METIS has one random state per process; models are built by several threads.
    if (include.file == "core/algebra/sparse_cholesky.cpp" && include.target == "mutex") return;
    EXPECT_FALSE(contains(banned, include.target)) << place(include) << ": core has no use for it";
  });
}

TEST(Architecture, CorePrintsNothingAndOpensNoFile) {
  const std::regex printing(
      R"(\b(printf|fprintf|puts|putchar|fputs|perror|fopen|fwrite)\s*\(|\bstd::(cout|cerr|clog)\b)");
  for (const SourceFile& source : sources()) {
    if (house_of(source.path) != "core") continue;
    std::smatch match;
    EXPECT_FALSE(std::regex_search(source.code, match, printing)) << source.path << ": " << match.str();
  }
}

TEST(Architecture, HeadersAreGuardedByPragmaOnce) {
  for (const SourceFile& source : sources()) {
    const bool header = source.path.ends_with(".hpp");
    EXPECT_TRUE(!header || source.code.find("#pragma once") != std::string::npos) << source.path;
  }
}

}  // namespace
}  // namespace unbruised
