// Lists of particles and springs as spreadsheets write them.

#include <map>

#include "studies/config/library.hpp"
#include "studies/config/product_profile.hpp"
#include "studies/config/waypoint_csv.hpp"
#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

std::vector<Entry> particles(const std::string& text) {
  Problems problems;
  auto entries =
      csv_entries("product.particle", text, std::make_shared<const std::string>("list.csv"), 1, problems);
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  return entries;
}

TEST(Csv, MayBeginWithAByteOrderMark) {
  const std::string rows = "position_x_m,mass_kg\n0.5,0.1\n";
  const auto marked = particles("\xEF\xBB\xBF" + rows);
  const auto plain = particles(rows);
  ASSERT_EQ(marked.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_EQ(marked[i].path, plain[i].path);
    EXPECT_EQ(marked[i].value.number, plain[i].value.number);
  }
}

TEST(Csv, MayWriteAPlusBeforeANumber) {
  const auto entries = particles("position_x_m,mass_kg\n+0,+1.5e-1\n");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_TRUE(entries[0].value.is_number());
  EXPECT_EQ(entries[0].value.number, 0.0);
  EXPECT_EQ(entries[1].value.number, 0.15);
}

TEST(Csv, DoesNotTakeTwoSignsForANumber) {
  for (const std::string cell : {"+-1", "++1", "+"}) {
    EXPECT_FALSE(particles("mass_kg\n" + cell + "\n")[0].value.is_number()) << cell;
  }
}

std::vector<std::string> said_of_profile(const std::string& text) {
  Problems problems;
  profile_entries(text, std::make_shared<const std::string>("tip.csv"), 1, problems);
  return problems.lines();
}

TEST(ProfileCsv, IsTwoListsOfNumbers) {
  Problems problems;
  const auto entries = profile_entries("# a tip\nplace_m,height_m\n-0.01,0\n0,1e-3\n\n0.01,0.0\n",
                                       std::make_shared<const std::string>("tip.csv"), 1, problems);
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].path, "gripper.pad.profile_place_m");
  ASSERT_EQ(entries[1].value.items.size(), 3U);
  EXPECT_EQ(entries[1].value.items[1].number, 1e-3);
}

TEST(ProfileCsv, IsRefusedWithFileAndLine) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(said_of_profile("place,height\n0,0\n"),
            Lines{"tip.csv:1: gripper.pad.profile_file: the first line must be \"place_m,height_m\""});
  EXPECT_EQ(said_of_profile("place_m,height_m\n0,0\n0.01\n"),
            Lines{"tip.csv:3: gripper.pad.profile_file: a row must have two cells, a place and a height, not 1"});
  EXPECT_EQ(said_of_profile("place_m,height_m\n0,0\n0.01,1 mm\n"),
            Lines{"tip.csv:3: height_m = \"1 mm\": must be a number"});
  EXPECT_EQ(
      said_of_profile("place_m,height_m\n0.01,0\n0.0,0\n"),
      Lines{"tip.csv:3: place_m = 0.0: must be > the place before it, 0.01: a profile has one height at each "
            "place"});
  EXPECT_EQ(said_of_profile("place_m,height_m\n0.01,0\n"),
            Lines{"tip.csv:1: gripper.pad.profile_file: the file must have two rows at least"});
}

std::vector<std::string> said_of_product(const std::string& text) {
  Problems problems;
  product_profile_entries(text, std::make_shared<const std::string>("pear.csv"), 1, problems);
  return problems.lines();
}

TEST(ProductProfileCsv, IsTwoListsOfNumbers) {
  Problems problems;
  const auto entries = product_profile_entries("# a pear\nradius,height\n0,0\n1.5,1e-3\n0,2\n",
                                               std::make_shared<const std::string>("pear.csv"), 1, problems);
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].path, "product.profile_height");
  EXPECT_EQ(entries[0].value.items[1].number, 1e-3);
  EXPECT_EQ(entries[1].path, "product.profile_radius");
  EXPECT_EQ(entries[1].value.items[1].number, 1.5);
}

TEST(ProductProfileCsv, IsRefusedWithFileAndLine) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(said_of_product("z,r\n0,0\n"),
            Lines{"pear.csv:1: product.profile_file: the first line must name the columns height and radius"});
  EXPECT_EQ(said_of_product("height,radius\n0\n"),
            Lines{"pear.csv:2: product.profile_file: a row must have 2 cells, not 1"});
  EXPECT_EQ(said_of_product("height,radius\n0,0\n1,wide\n"), Lines{"pear.csv:3: radius = wide: must be a number"});
}

std::vector<std::string> said_of_waypoints(const std::string& text) {
  Problems problems;
  waypoint_entries(text, std::make_shared<const std::string>("way.csv"), 1, problems);
  return problems.lines();
}

TEST(WaypointCsv, IsATableForEachRow) {
  Problems problems;
  const auto entries = waypoint_entries(
      "# "
      "recorded\nx_m,y_m,z_m,qw,qx,qy,qz,time_s,blend_m,wait_s\n0,0.1,0.2,1,0,0,0,0.5,0,0.25\n0,0.3,0.2,0,1,0,0,1."
      "75,0,0\n",
      std::make_shared<const std::string>("way.csv"), 1, problems);
  EXPECT_EQ(problems.lines(), std::vector<std::string>{});
  std::map<std::string, Value> read;
  for (const Entry& entry : entries) read[entry.path] = entry.value;
  ASSERT_EQ(read.size(), 10U);
  EXPECT_EQ(read.at("strategy.waypoint[1].place_m").items[1].number, 0.3);
  EXPECT_EQ(read.at("strategy.waypoint[1].quaternion").items[1].number, 1.0);
  EXPECT_EQ(read.at("strategy.waypoint[0].duration_s").number, 0.5);
  EXPECT_EQ(read.at("strategy.waypoint[1].duration_s").number, 1.0) << "after the rest";
  EXPECT_EQ(read.at("strategy.waypoint[0].wait_s").number, 0.25);
}

TEST(WaypointCsv, IsRefusedWithFileAndLine) {
  using Lines = std::vector<std::string>;
  const std::string columns =
      "way.csv:1: strategy.waypoint_file: the first line must name the columns x_m, y_m, z_m, and of these what "
      "there "
      "is: rx_rad, ry_rad, rz_rad or qw, qx, qy, qz; time_s or speed_m_s; blend_m; wait_s";
  for (const char* wrong : {"", "x_m,y_m\n0,0\n", "x_m,y_m,z_m,qw\n0,0,0,1\n", "x_m,y_m,z_m,pace\n0,0,0,1\n",
                            "x_m,y_m,z_m,time_s,speed_m_s\n0,0,0,1,1\n"}) {
    EXPECT_EQ(said_of_waypoints(wrong), Lines{columns}) << wrong;
  }
  EXPECT_EQ(said_of_waypoints("x_m,y_m,z_m\n"),
            Lines{"way.csv:1: strategy.waypoint_file: the file must have a row at least"});
  EXPECT_EQ(said_of_waypoints("x_m,y_m,z_m\n0,0\n"),
            Lines{"way.csv:2: strategy.waypoint_file: a row must have 3 cells, not 2"});
  EXPECT_EQ(said_of_waypoints("x_m,y_m,z_m\n0,up,0\n"), Lines{"way.csv:2: y_m = up: must be a number"});
  EXPECT_EQ(said_of_waypoints("x_m,y_m,z_m,time_s\n0,0,0.1,1\n0,0.1,0.1,0.5\n"),
            Lines{"way.csv:3: time_s = 0.5: must be > 1.0, the time of the waypoint before it"});
  EXPECT_EQ(said_of_waypoints("x_m,y_m,z_m,time_s\n0,0,0.1,0\n"),
            Lines{"way.csv:2: time_s = 0.0: must be > 0.0, when the lift ends"});
}

}  // namespace
}  // namespace unbruised::studies
