// Measured curves: what is read, and what each mistake is answered with, file and line.

#include "studies/config/measured_data.hpp"

#include "tests/studies/config/config_testing.hpp"

namespace unbruised::studies {
namespace {

using Lines = std::vector<std::string>;

struct Read {
  std::vector<SpecimenBlock> blocks;
  Lines lines;
};

Read read(const std::string& text, CurveTest test = CurveTest::press, const std::string& outcome = "") {
  CalibrateTable settings;
  settings.test = test;
  settings.outcome = outcome;
  Problems problems;
  Read out;
  out.blocks = measured_curves(text, settings, std::make_shared<const std::string>("fruit/pear.csv"), 1, problems);
  out.lines = problems.lines();
  return out;
}

TEST(MeasuredCurves, OfAFileWithoutSpecimensAreOneByItsName) {
  const Read found = read("# a pear\nclosure_m,force_N,note\n0.001,2.5,ripe\n0.002,6,ripe\n");
  EXPECT_EQ(found.lines, Lines{});
  ASSERT_EQ(found.blocks.size(), 1U);
  EXPECT_EQ(found.blocks[0].name, "pear");
  EXPECT_EQ(found.blocks[0].closure_m, (std::vector<double>{0.001, 0.002}));
  EXPECT_EQ(found.blocks[0].force_N, (std::vector<double>{2.5, 6.0}));
  EXPECT_EQ(found.blocks[0].origin.line, 3);
}

TEST(MeasuredCurves, OfSpecimensMayStandInAnyOrderAndHaveAnOutcome) {
  const Read found = read("specimen,time_s,force_N,rupture_N\na,0,5,9.5\nb,0,4,\na,1,3,9.5\nb,2,2.5,\n",
                          CurveTest::relaxation, "rupture_N");
  EXPECT_EQ(found.lines, Lines{});
  ASSERT_EQ(found.blocks.size(), 2U);
  EXPECT_EQ(found.blocks[0].time_s, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(found.blocks[0].outcome, 9.5);
  EXPECT_EQ(found.blocks[1].force_N, (std::vector<double>{4.0, 2.5}));
  EXPECT_EQ(found.blocks[1].outcome, std::nullopt);
}

TEST(MeasuredCurves, AreRefusedWithOneSentence) {
  EXPECT_EQ(read("depth,force_N\n1,2\n").lines,
            Lines{"fruit/pear.csv:1: closure_m: no such column; the file has depth and force_N"});
  EXPECT_EQ(read("closure_mm,force_N\n1,2\n").lines,
            Lines{"fruit/pear.csv:1: closure_mm: has another unit; give closure_m"});
  EXPECT_EQ(read("closure_m,force_kN\n1,2\n").lines,
            Lines{"fruit/pear.csv:1: force_kN: has another unit; give force_N"});
  EXPECT_EQ(read("closure_m,force_N\n0.001,2\n0.001,3\n").lines,
            Lines{"fruit/pear.csv:3: closure_m = 0.001: must be > the one before it, 0.001: a specimen's rows are "
                  "in this order"});
  EXPECT_EQ(read("time_s,force_N\n1,2\n0.5,3\n", CurveTest::relaxation).lines,
            Lines{"fruit/pear.csv:3: time_s = 0.5: must be > the one before it, 1.0: a specimen's rows are in "
                  "this order"});
  EXPECT_EQ(read("closure_m,force_N\n-0.001,2\n").lines,
            Lines{"fruit/pear.csv:2: closure_m = -0.001: must be >= 0: it counts from the first contact"});
  EXPECT_EQ(read("closure_m,force_N\n1.5,2\n").lines,
            Lines{"fruit/pear.csv:2: closure_m = 1.5: must be <= 0.3: are these millimetres?"});
  EXPECT_EQ(read("closure_m,force_N\n0.001,two\n").lines,
            Lines{"fruit/pear.csv:2: force_N = \"two\": must be a finite number"});
  EXPECT_EQ(read("closure_m,force_N\n0.001,2,3\n").lines,
            Lines{"fruit/pear.csv:2: force_N: a row must have as many cells as the first line has (2), not 3"});
  EXPECT_EQ(read("closure_m,force_N\n").lines, Lines{"fruit/pear.csv:1: force_N: the file has no rows"});
  EXPECT_EQ(read("# nothing\n").lines, Lines{"fruit/pear.csv:1: force_N: the file has no rows"});
  EXPECT_EQ(read("closure_m,force_N,r\n0.001,2,5\n0.002,3,6\n", CurveTest::press, "r").lines,
            Lines{"fruit/pear.csv:3: r = 6.0: must be the same in all rows of a specimen, 5.0"});
  EXPECT_EQ(read("closure_m,force_N\n0.001,2\n", CurveTest::press, "r").lines,
            Lines{"fruit/pear.csv:1: r: no such column; the file has closure_m and force_N"});
}

}  // namespace
}  // namespace unbruised::studies
