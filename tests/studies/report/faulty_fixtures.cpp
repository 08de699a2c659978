#include <cmath>
#include <utility>

#include "tests/studies/report/fixture_parts.hpp"

namespace unbruised::studies::testing {
namespace {

ReportFixture incomplete() {
  ReportFixture fixture = sweep("half_a_night", from_to(0.6, 10.0, 12), from_to(0.02, 0.4, 6), {1.0, 4.0}, 1.0);
  fixture.content.meta.complete = false;
  fixture.context.wanted = fixture.content.rows.size();
  for (std::size_t i = fixture.content.rows.size() / 2; i < fixture.content.rows.size(); ++i) {
    fixture.content.rows[i].result = {};
  }
  fixture.content.rows[3].result.outcome = Outcome::diverged;
  fixture.content.rows[3].result.cause = "a number is not finite";
  fixture.content.rows[5].result.outcome = Outcome::out_of_range;
  fixture.content.rows[5].result.cause = "rotation 0.21 rad > simulation.max_rotation_rad";
  fixture.content.rows[7].result.metrics[Metric::peak_pressure_Pa] = INFINITY;
  fixture.window.reset();
  return fixture;
}

ReportFixture hostile() {
  const std::vector<std::string> evil = hostile_texts();
  ReportFixture fixture = begin("hostile", "sweep");
  fixture.content.meta.study_name = evil[0];
  fixture.content.meta.config_toml += "# " + evil[1] + "\n";
  fixture.content.meta.compiler = evil[2];
  fixture.context.replay_command = "unbruised run '" + evil[1] + "' --scenario";
  fixture.context.source = evil[2];
  fixture.content.inputs = {{"product." + evil[3], evil[4], evil[1]}, {"product.use", "", evil[0]}, kGrip};
  for (std::size_t i = 0; i < 120; ++i) {
    const double force = 0.5 + 0.05 * static_cast<double>(i);
    add_row(fixture, {.grip_force_N = force}, {static_cast<double>(i % 5), evil[i % evil.size()], force});
    fixture.content.rows.back().result.cause = evil[(i + 1) % evil.size()];
  }
  ResultTable table{.name = evil[1],
                    .row = evil[2],
                    .columns = {texts(evil[3], evil), texts("=HYPERLINK(1)", evil)},
                    .attributes = {}};
  table.attributes = {{evil[0], evil[1]}};
  ResultTable candidates{.name = "candidates",
                         .row = "candidate",
                         .columns = {texts("name", {evil[0], evil[1]}), numbers("held", "1", "", {3.0, 4.0}),
                                     numbers("probability", "1", "", {0.3, 0.4})},
                         .attributes = {}};
  fixture.content.tables = {table, candidates};
  return fixture;
}

ReportFixture unknown_table() {
  ReportFixture fixture = sample();
  fixture.name = "unknown_table";
  fixture.content.tables.push_back(
      {.name = "sorting_line",
       .row = "lane",
       .columns = {texts("belt", {"left", "right"}), numbers("speed_m_s", "m s-1", "", {0.4, NAN})},
       .attributes = {{"remark", std::string("from a later version")}}});
  return fixture;
}

/// An answer that would be good, were it not for what stands against it.
ReportFixture warned() {
  ReportFixture fixture = sweep("warned", from_to(0.6, 10.0, 12), {0.05, 0.1}, {1.0}, 1.0);
  fixture.content.meta.warnings = {
      "The shortest contact gets 9 time steps, 20 are asked for: F_damage may be wrong by 30 %.",
      "The product weighs 95 kg at a size of 50 mm: g taken for kg?"};
  return fixture;
}

/// No limit of damage, so nobody looked.
ReportFixture not_looked_at() {
  ReportFixture fixture = sweep("not_looked_at", from_to(0.6, 10.0, 12), {0.05, 0.1}, {1.0}, 1.0);
  std::string& config = fixture.content.meta.config_toml;
  config.resize(config.find("[limits]"));
  config += "[limits]\nslip_m = 0.002\n";
  return fixture;
}

}  // namespace

std::vector<ReportFixture> faulty_fixtures() {
  return {incomplete(), hostile(), unknown_table(), warned(), not_looked_at()};
}

std::vector<std::string> hostile_texts() {
  return {"</script><script>window.hacked=1</script>",
          "<img src=x onerror=\"window.hacked=1\">",
          "\"><svg onload=window.hacked=1>",
          "<!--<script>",
          "]]>&lt;b&gt;' onmouseover='window.hacked=1",
          "line\xE2\x80\xA8separator\xE2\x80\xA9"
          "and ${window.hacked=1} {a|b} %s",
          "bytes \xFF\xFE that are no UTF-8",
          "=HYPERLINK(\"http://127.0.0.1/\",\"x\")",
          "javascript:window.hacked=1"};
}

}  // namespace unbruised::studies::testing
