#include "studies/cli/command_line.hpp"

#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <optional>

#include <CLI/CLI.hpp>

#include "studies/cli/command_options.hpp"
#include "studies/cli/commands.hpp"
#include "studies/cli/shelf.hpp"
#include "studies/cli/words.hpp"
#include "studies/config/locations.hpp"
#include "studies/config/schema.hpp"
#include "studies/execution/build_info.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// A usage error: what is wrong, and which help to read.
struct UsageError {
  std::string message;
  std::string command;  ///< empty: the program's own help
};

/// The known word spelt most like this one.
std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = nearest(word, known);
  return near.empty() ? std::string() : joined({"; did you mean '", near, "'?"});
}

class CommandLine {
 public:
  explicit CommandLine(std::string program) : app_("Finds how a gripper may handle a delicate product.") {
    run_.program = std::move(program);
    app_.name("unbruised");
    app_.set_version_flag("--version", build_line());
    app_.allow_extras();
    app_.require_subcommand(0, 1);  // a later word may be a folder named `run`
    app_.footer(
        "\nbegin with:\n  unbruised list\n  unbruised check configs/kiwi_first.toml\n"
        "  unbruised run configs/kiwi_first.toml\n"
        "\nexit status: 0 done; 1 internal error; 2 wrong input; 3 some scenarios diverged, or are missing; 4 run "
        "directory in use;\n"
        "5 disk failure; 6 results damaged; 129, 130, 143 interrupted (the same command continues)");
    add_run();
    add_check();
    add_merge();
    add_submit();
    add_readers();
    add_export();
    add_new();
  }

  /// Parses and calls the command.
  int operator()(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());  // what this form of CLI11's parse takes
    try {
      app_.parse(std::move(words));
    } catch (const CLI::Success& wanted) {  // --help, --version
      return app_.exit(wanted);
    } catch (const CLI::ParseError& error) {
      throw UsageError{error.what(), chosen_name()};
    }
    CLI::App* chosen = chosen_command();
    refuse_unknown_words(chosen);
    return actions_.at(chosen->get_name())();
  }

 private:
  CLI::App& command(const std::string& name, const std::string& description, std::function<int()> action) {
    CLI::App* added = app_.add_subcommand(name, description);
    added->allow_extras();
    actions_[name] = std::move(action);
    return *added;
  }

  void add_study_words(CLI::App& to) {
    to.add_option("STUDY", words_, "the study's TOML file")->type_name("FILE")->expected(0, -1);
    to.add_option("--set", sets_, "key=value: give a key another value; may repeat and take several")
        ->type_name("KEY=VALUE")
        ->expected(1, -1);
  }

  void add_run() {
    CLI::App& run = command("run", "run a study, or continue it", [this] { return call_run(); });
    add_study_words(run);
    run.add_option("--output,-o", output_, "run directory (default: results/<study name>)")->type_name("DIR");
    run.add_option("--threads,-j", threads_, "threads (default: all the machine gives)")->type_name("N");
    run.add_option("--scenario", scenario_, "only this scenario, with its trace and its page")->type_name("ID");
    run.add_option("--shard", shard_, "only part I of N, beside others in the same run directory; then `merge`")
        ->type_name("I/N");
    run.add_flag("--full-trace", full_trace_, "with --scenario: every time step, not as many as a chart shows");
    run.add_flag("--fresh", run_.fresh, "move an old run directory aside and start anew");
    run.add_flag("--quiet,-q", run_.quiet, "no progress");
    run.add_flag("--no-replay", no_replay_, "a page without scenarios in motion");
  }

  void add_check() {
    CLI::App& check = command("check", "validate a study and say what it will cost", [this] {
      take_study("check");
      return check_command(run_.study, answer_form());
    });
    add_study_words(check);
    add_json(check);
  }

  void add_merge() {
    CLI::App& merge = command("merge", "end a study whose parts were run by `run --shard`", [this] {
      if (words_.empty()) throw UsageError{"`merge` needs a run directory", "merge"};
      take_threads("merge");
      return merge_command({.directories = {words_.begin(), words_.end()},
                            .threads = run_.threads,
                            .quiet = run_.quiet,
                            .program = run_.program});
    });
    merge.add_option("DIR", words_, "run directories of one study; the first is where all come together")
        ->expected(0, -1);
    merge.add_option("--threads,-j", threads_, "threads (default: all the machine gives)")->type_name("N");
    merge.add_flag("--quiet,-q", run_.quiet, "no progress");
  }

  void add_submit() {
    CLI::App& submit = command("submit", "write the jobs of a study for a batch system", [this] {
      take_study("submit");
      submit_.study = run_.study;
      if (!output_.empty()) submit_.output = output_;
      return submit_command(submit_);
    });
    add_study_words(submit);
    submit.add_option("--output,-o", output_, "run directory (default: results/<study name>)")->type_name("DIR");
    add_options(submit, submit_);
  }

  void add_readers() {
    CLI::App& info = command("info", "what a run directory or results file holds", [this] { return call_info(); });
    info.add_option("PATH", words_, "run directory or results file")->expected(0, -1);
    info.add_option("--at", at_s_, "the signals of one scenario at this time since its start, in s")
        ->type_name("TIME");
    info.add_option("--scenario", scenario_, "with --at: which one of a run directory")->type_name("ID");
    add_json(info);
    CLI::App& verify = command("verify", "check every checksum of a run directory",
                               [this] { return verify_command(one_word("verify", "a run directory")); });
    verify.add_option("DIR", words_, "run directory")->expected(0, -1);
    add_report();
    CLI::App& explain = command("explain", "what a config key, metric, outcome or word of goals means", [this] {
      return explain_command(words_.empty() ? std::nullopt : std::optional(one_word("explain", "a word")));
    });
    explain
        .add_option("WORD", words_,
                    "key or table (strategy.grip_force_N), metric, outcome (held), word of goals (P, quantile), "
                    "metrics, outcomes, goals; without it everything")
        ->expected(0, -1);
    CLI::App& list = command("list", "the products, grippers and studies that ship; of a folder its runs", [this] {
      return words_.empty() ? list_command() : shelf_command(one_word("list", "a folder"));
    });
    list.add_option("DIR", words_, "a folder with run directories in it")->expected(0, -1);
  }

  void add_report() {
    CLI::App& report =
        command("report", "one self-contained HTML page of what a study found", [this] { return call_report(); });
    report.add_option("PATH", words_, "run directory or results file")->expected(0, -1);
    report.add_option("--output,-o", output_, "the page (default: report.html beside the results)")
        ->type_name("FILE.html");
    report.add_option("--scenario", shown_, "show this one in motion too; may repeat")->type_name("ID");
    report.add_flag("--no-replay", no_replay_, "nothing in motion: nothing is run again");
    report.add_option("--index", index_, "instead a page over all runs below this folder")->type_name("DIR");
    report.add_option("--measured", measured_, "forces at which specimens broke, beside the window")
        ->type_name("FILE.csv");
    report.add_option("--audio", audio_, "the sound of the scenario shown first, as a file too")
        ->type_name("FILE.wav");
  }

  void add_json(CLI::App& to) {
    to.add_flag("--json", json_, "one JSON document instead of lines (docs/json.md)");
  }

  [[nodiscard]] AnswerForm answer_form() const { return json_ ? AnswerForm::json : AnswerForm::lines; }

  void add_export() {
    CLI::App& out =
        command("export", "one flat table of a study as CSV, or its strategy for a controller", [this] {
          export_.path = one_word("export", "a run directory or results file");
          if (!output_.empty()) export_.output = output_;
          export_.scenario = scenario_id("export");
          return export_command(export_);
        });
    out.add_option("PATH", words_, "run directory or results file")->expected(0, -1);
    out.add_option("--scenario", scenario_,
                   "the trace of this scenario instead (run --scenario records it), or its motion or path")
        ->type_name("ID");
    add_options(out, export_);
    out.add_option("--output,-o", output_, "the file (default: TABLE.csv beside the results; -: stdout)")
        ->type_name("FILE");
  }

  void add_new() {
    CLI::App& fresh = command("new", "write a commented study for a product and a gripper", [this] {
      new_.name = one_word("new", "a name for the study");
      if (!output_.empty()) new_.output = output_;
      return new_command(new_);
    });
    fresh.add_option("NAME", words_, "the study's name")->expected(0, -1);
    add_options(fresh, new_);
    fresh.add_option("--output,-o", output_, "the study (default: NAME.toml)")->type_name("FILE.toml");
  }

  int call_info() {
    const std::string path = one_word("info", "a run directory or results file");
    if (scenario_ && !at_s_) throw UsageError{"--scenario ID goes with --at TIME", "info"};
    if (!at_s_) return info_command(path, run_.program, answer_form());
    return instant_command(
        {.path = path, .scenario = scenario_id("info"), .time_s = *at_s_, .program = run_.program}, answer_form());
  }

  int call_report() {
    const auto output = output_.empty() ? std::nullopt : std::optional<std::filesystem::path>(output_);
    if (!index_.empty()) {
      if (!words_.empty()) throw UsageError{"--index DIR takes the place of a run directory", "report"};
      return index_command(index_, output);
    }
    ReportArguments report;
    report.output = output;
    report.path = one_word("report", "a run directory or results file");
    report.program = run_.program;
    report.moving = !no_replay_;
    for (const long long id : shown_) {
      if (id < 0) throw UsageError{"--scenario: ids begin with 0", "report"};
      report.scenarios.push_back(static_cast<std::uint64_t>(id));
    }
    if (!audio_.empty()) report.audio = audio_;
    if (!measured_.empty()) report.measured = measured_;
    if (no_replay_ && (!shown_.empty() || report.audio)) {
      throw UsageError{"--scenario and --audio run scenarios again, --no-replay none", "report"};
    }
    return report_command(report);
  }

  int call_run() {
    take_study("run");
    if (!output_.empty()) run_.output = output_;
    take_threads("run");
    take_shard();
    run_.scenario = scenario_id("run");
    run_.moving = !no_replay_;
    if (full_trace_ && !run_.scenario) throw UsageError{"--full-trace goes with --scenario ID", "run"};
    if (full_trace_) run_.trace_rows = TraceRows::all;
    if (run_.shard) return run_shard_command(run_);
    return run_.scenario ? run_one_command(run_) : run_command(run_);
  }

  void take_threads(const std::string& name) {
    if (!threads_) return;
    if (*threads_ < 1 || *threads_ > kThreadsMost) {
      throw UsageError{
          joined({"--threads = ", std::to_string(*threads_), ": must be 1 to ", std::to_string(kThreadsMost)}),
          name};
    }
    run_.threads = static_cast<int>(*threads_);
  }

  void take_shard() {
    if (shard_.empty()) return;
    if (scenario_ || run_.fresh) throw UsageError{"--shard goes neither with --scenario nor with --fresh", "run"};
    run_.shard = shard_of(shard_);
    if (!run_.shard) {
      throw UsageError{joined({"--shard ", shard_, ": must be I/N, part I of N from 1/N to N/N"}), "run"};
    }
  }

  [[nodiscard]] std::optional<std::uint64_t> scenario_id(const std::string& command) const {
    if (scenario_ && *scenario_ < 0) throw UsageError{"--scenario: ids begin with 0", command};
    return scenario_ ? std::optional(static_cast<std::uint64_t>(*scenario_)) : std::nullopt;
  }

  /// Sorts the words into the study and the values of --set.
  void take_study(const std::string& name) {
    std::vector<std::string> studies;
    std::vector<std::string> sets;
    for (const std::string& word : words_) (is_set_word(word) ? sets : studies).push_back(word);
    for (const std::string& word : sets_) {
      if (!is_set_word(word) && !is_study_word(word)) {
        throw UsageError{joined({"--set ", word, ": must be key=value"}), name};
      }
      (is_set_word(word) ? sets : studies).push_back(word);
    }
    words_ = studies;
    run_.study.study = study_file(one_word(name, "a study file (STUDY.toml)"));
    run_.study.sets = sets;
  }

  std::string one_word(const std::string& name, const std::string& what) const {
    if (words_.empty()) throw UsageError{joined({"`", name, "` needs ", what}), name};
    if (words_.size() > 1)
      throw UsageError{joined({"`", name, "` takes one word, not '", words_[1], "' too"}), name};
    return words_.front();
  }

  CLI::App* chosen_command() const {
    const std::vector<CLI::App*> chosen = app_.get_subcommands();
    if (!chosen.empty()) return chosen.front();
    std::vector<std::string> names;
    for (const auto& [name, action] : actions_) names.push_back(name);
    const std::vector<std::string> words = app_.remaining();
    if (words.empty()) throw UsageError{"which command? " + app_.help(), "-"};
    throw UsageError{joined({is_option(words.front()) ? "unknown option '" : "unknown command '", words.front(),
                             "'", suggestion(words.front(), names)}),
                     {}};
  }

  std::string chosen_name() const {
    const std::vector<CLI::App*> chosen = app_.get_subcommands();
    return chosen.empty() ? std::string() : chosen.front()->get_name();
  }

  void refuse_unknown_words(const CLI::App* chosen) const {
    const std::vector<std::string> words = app_.remaining(true);
    if (words.empty()) return;
    std::vector<std::string> known;
    for (const CLI::Option* option : chosen->get_options()) {
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    }
    const auto option = std::find_if(words.begin(), words.end(), is_option);
    const std::string word = option == words.end() ? words.front() : option->substr(0, option->find('='));
    throw UsageError{
        joined({is_option(word) ? "unknown option '" : "unexpected word '", word, "'", suggestion(word, known)}),
        chosen->get_name()};
  }

  static constexpr long kThreadsMost = 4096;

  CLI::App app_;
  std::map<std::string, std::function<int()>> actions_;
  std::vector<std::string> words_;
  std::vector<std::string> sets_;
  std::string output_;
  std::optional<long> threads_;
  std::optional<long long> scenario_;
  std::vector<long long> shown_;
  std::string audio_, index_, measured_, shard_;
  bool no_replay_ = false;
  std::optional<double> at_s_;
  RunArguments run_;
  NewArguments new_;
  ExportArguments export_;
  SubmitArguments submit_;
  bool json_ = false;
  bool full_trace_ = false;
};

int report_usage_error(const UsageError& error) {
  print_error(error.message);
  if (error.command == "-") return kExitInput;
  print_note(joined({"see `unbruised ", error.command, error.command.empty() ? "" : " ", "--help`"}));
  return kExitInput;
}

/// The status of a command whose results may not have reached whoever reads them.
int after_printing(int status) {
  std::cout.flush();
  if (std::cout) return status;
  print_error("cannot write to the standard output");
  return status == kExitDone ? exit_status(ResultsErrorKind::io) : status;
}

}  // namespace

int run_program(const std::vector<std::string>& words) {
  // A file that may not grow is an error of writing with its path, not the end of the process.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const std::string program = words.empty() ? "unbruised" : words.front();
    CommandLine command_line(program);
    return after_printing(
        command_line(words.empty() ? words : std::vector<std::string>(words.begin() + 1, words.end())));
  } catch (const UsageError& error) {
    return report_usage_error(error);
  } catch (const RowsFailure& failure) {
    return report_error(failure.error);
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
  } catch (const std::exception& error) {
    print_error(joined({"internal error: ", error.what()}));
  }
  return kExitInternal;
}

}  // namespace unbruised::studies
