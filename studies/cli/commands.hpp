#pragma once

/// @file
/// The commands behind the command line. Each prints and returns the exit status.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "studies/config/study.hpp"
#include "studies/estimate/study_cost.hpp"
#include "studies/kinds/shard_run.hpp"
#include "studies/report/report_page.hpp"
#include "studies/results/expected.hpp"

namespace unbruised::studies {

inline constexpr int kExitDone = 0;
inline constexpr int kExitInternal = 1;
inline constexpr int kExitInput = 2;
inline constexpr int kExitDiverged = 3;
inline constexpr int kExitMissing = 3;  ///< scenarios of parts that were not run

struct StudyArguments {
  std::filesystem::path study;
  std::vector<std::string> sets;  ///< "key=value"
};

/// Which rows of the trace `run --scenario` keeps.
enum class TraceRows {
  chart,  ///< about as many as a chart shows, where simulation.trace_interval_s says nothing
  all,
};

struct RunArguments {
  StudyArguments study;
  std::optional<std::filesystem::path> output;
  std::optional<int> threads;
  std::optional<std::uint64_t> scenario;
  TraceRows trace_rows = TraceRows::chart;
  std::optional<Shard> shard;  ///< only this part
  bool fresh = false;
  bool only_whole = false;  ///< end what was run in parts: nothing is run while scenarios are missing
  bool quiet = false;
  bool moving = true;                 ///< the page shows scenarios in motion
  std::string program = "unbruised";  ///< as it was called, for commands shown to the user
};

int run_command(const RunArguments& arguments);
/// What stands against running a study on this machine; it is printed. @return false then
bool may_run(const Study& study, const StudyCost& cost, int threads);
/// After "interrupted" on stderr: the command that goes on, and the exit status.
int ask_to_continue(const RunArguments& arguments);
void write_to_stderr(std::string_view text);
/// The command that continues, or with other words repeats, this run.
std::string command_of(const RunArguments& arguments);
/// `run --shard I/N`: a part of the study, into the run directory that all parts share.
int run_shard_command(const RunArguments& arguments);
struct MergeArguments {
  std::vector<std::filesystem::path> directories;  ///< not empty; the first is where all come together
  std::optional<int> threads;
  bool quiet = false;
  std::string program = "unbruised";
};
/// Brings the parts of a study together and ends it. Exit status 3 where scenarios are missing.
int merge_command(const MergeArguments& arguments);
/// Says what of a study in parts no journal has whole. @return the exit status; nothing: nothing is missing
std::optional<int> say_what_is_missing(const RunArguments& arguments, const Study& study, RunDirectory& run);
/// `run --scenario ID`: that scenario alone with its trace, its file and its page.
int run_one_command(const RunArguments& arguments);
/// How a command answers: lines for people, or one JSON document (docs/json.md).
enum class AnswerForm { lines, json };
int check_command(const StudyArguments& arguments, AnswerForm form);
int info_command(const std::filesystem::path& path, const std::string& program, AnswerForm form);
struct InstantArguments {
  std::filesystem::path path;             ///< run directory or results file
  std::optional<std::uint64_t> scenario;  ///< of a run directory
  double time_s = 0;
  std::string program = "unbruised";
};
/// `info --at TIME`: every signal of a trace at that time.
int instant_command(const InstantArguments& arguments, AnswerForm form);
struct ReportArguments {
  std::filesystem::path path;  ///< run directory or results file
  /// None: report.html beside the results, or the name of another results file with .html.
  std::optional<std::filesystem::path> output{};
  std::string program = "unbruised";
  bool moving = true;                               ///< with scenarios that are run again to be seen
  std::vector<std::uint64_t> scenarios{};           ///< that are shown beside those the study makes worth seeing
  std::optional<std::filesystem::path> audio{};     ///< a WAV file of the first of them
  std::optional<std::filesystem::path> measured{};  ///< a CSV file of forces for the ruler of a window
};
int report_command(const ReportArguments& arguments);
int verify_command(const std::filesystem::path& directory);
/// @param word a key, table, metric, outcome or word of goals; none: all of them.
int explain_command(const std::optional<std::string>& word);
int list_command();
struct ExportArguments {
  std::filesystem::path path;             ///< run directory or results file
  std::optional<std::uint64_t> scenario;  ///< its trace instead of a table
  std::string format = "csv";
  std::string table = "scenarios";
  std::vector<std::string> joint_names;         ///< of a joint_trajectory
  std::optional<std::filesystem::path> output;  ///< none: beside the results; "-": stdout
};
/// One flat table as CSV, one scenario in motion, or a strategy for a controller.
int export_command(const ExportArguments& arguments);
struct NewArguments {
  std::string name;
  std::string kind;
  std::string product;  ///< as `use` takes it
  std::string gripper;
  std::optional<std::filesystem::path> output;  ///< none: NAME.toml
};
/// Writes a commented study for a product and a gripper; refuses what is there already.
int new_command(const NewArguments& arguments);

/// One message on stderr, with the program's name before it.
void print_error(const std::string& message);
void print_note(const std::string& message);
/// What belongs to the answer of a study: one message on stderr each.
void print_warnings(const std::vector<std::string>& warnings);
/// A whole line of results on stdout.
void print_line(const std::string& line);
/// Results on stdout as they are.
void print_text(const std::string& text);
/// Prints an error of the results house; its exit status.
int report_error(const ResultsError& error);

/// Writes report.html into a run directory. @param moving with scenarios that are run again to be seen. @return
/// the page; nothing, after a note, when it fails: the results are safe without it.
std::optional<std::filesystem::path> write_report_of_run(const std::filesystem::path& directory,
                                                         const std::string& program, bool moving);

/// Reads a study, or says what is wrong with it.
StudyOrError read_of(const StudyArguments& arguments);
void print_problems_of(const StudyArguments& arguments, const ConfigError& error);
/// Reads a study; otherwise prints what is wrong with it and returns nothing.
std::optional<Study> read_or_explain(const StudyArguments& arguments);
/// `results/<study name>` unless another one is asked for.
std::filesystem::path run_directory_of(const Study& study, const std::optional<std::filesystem::path>& output);
/// The threads asked for, else those the machine gives this process.
int thread_count_of(const std::optional<int>& threads);
/// A word as a shell takes it.
std::string shell_word(const std::string& word);

}  // namespace unbruised::studies
