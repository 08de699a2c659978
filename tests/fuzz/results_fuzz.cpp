// results.h5 files that HDF5 itself finds sound, with wrong tables and attributes: the input decides, object by
// object, what is left out, shortened, of another type or of another value. An empty input makes a sound file.
// Damaged bytes are another matter: they can crash libhdf5 itself, so they are read in a child process
// (SECURITY.md).

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <unistd.h>

#include "core/outcome/outcome.hpp"
#include "studies/results/hdf5_file.hpp"
#include "studies/results/results_file.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace unbruised;
using namespace unbruised::studies;
namespace fs = std::filesystem;

/// Decisions from the input; zero when it is used up.
class Decisions {
 public:
  explicit Decisions(std::string_view bytes) : rest_(bytes) {}
  unsigned next() {
    if (rest_.empty()) return 0;
    const auto value = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }

 private:
  std::string_view rest_;
};

class Forger {
 public:
  Forger(Hdf5File& file, Decisions& decide) : file_(file), decide_(decide) {}

  void integer(const std::string& object, const std::string& name, std::int32_t value) {
    switch (decide_.next() % 6) {
      case 1:
        return;
      case 2:
        return file_.set_attribute(object, name, std::string("one"));
      case 3:
        return file_.set_attribute(object, name, 0.5);
      case 4:
        return file_.set_attribute(object, name, static_cast<std::int32_t>(decide_.next()) - 128);
      case 5:
        return file_.set_attribute(object, name, std::array<std::int8_t, 3>{1, 2, 3});
      default:
        return file_.set_attribute(object, name, value);
    }
  }
  void text(const std::string& object, const std::string& name, const std::string& value) {
    switch (decide_.next() % 6) {
      case 1:
        return;
      case 2:
        return file_.set_attribute(object, name, std::int32_t{7});
      case 3:
        return file_.set_attribute(object, name, std::numeric_limits<double>::quiet_NaN());
      case 4:
        return file_.set_attribute(object, name, std::string());
      case 5:
        return file_.set_attribute(object, name, "../" + value);
      default:
        return file_.set_attribute(object, name, value);
    }
  }
  /// @param type 'd' double, 'i' integer, 'u' unsigned, 'b' byte, 't' text. False: the dataset was left out.
  bool column(const std::string& name, char type, std::uint64_t length) {
    const unsigned decision = decide_.next() % 8;
    const std::array<char, 5> types = {'d', 'i', 'u', 'b', 't'};
    if (decision == 1) return false;
    if (decision == 2) length = decide_.next() % 8;
    if (decision == 3) type = types[decide_.next() % types.size()];
    const std::int64_t value = decision == 4 ? static_cast<std::int64_t>(decide_.next()) - 128 : 1;
    Hdf5Extents extents = {length};
    if (decision == 5) extents.push_back(decide_.next() % 4);
    if (decision == 6) {
      file_.make_group(name);
      return false;
    }
    std::uint64_t count = 1;
    for (const std::uint64_t extent : extents) count *= extent;
    write(name, type, value, count, extents);
    return true;
  }
  void placed_column(const std::string& name, char type, std::uint64_t length, int position) {
    if (!column(name, type, length)) return;
    integer(name, "position", position);
    text(name, "units", "m");
    text(name, "long_name", "made up");
  }
  bool wanted() { return decide_.next() % 4 != 1; }
  void scale(const std::string& set, const std::string& scale_name, unsigned axis) {
    if (wanted() && file_.exists(set) && file_.exists(scale_name)) try {
        file_.make_scale(scale_name);
        file_.attach_scale(set, scale_name, axis);
      } catch (const Hdf5Failure&) {
        return;  // already a scale, or not that many dimensions
      }
  }

 private:
  void write(const std::string& name, char type, std::int64_t value, std::uint64_t count,
             const Hdf5Extents& extents) {
    switch (type) {
      case 't':
        return file_.write(name, std::vector<std::string>(count, std::to_string(value)));
      case 'i':
        return file_.write(name, std::vector<std::int64_t>(count, value), extents);
      case 'u':
        return file_.write(name, std::vector<std::uint64_t>(count, static_cast<std::uint64_t>(value)), extents);
      case 'b':
        return file_.write(name, std::vector<std::int8_t>(count, static_cast<std::int8_t>(value)), extents,
                           std::int8_t{-1});
      default:
        return file_.write(name, std::vector<double>(count, static_cast<double>(value)), extents);
    }
  }

  Hdf5File& file_;
  Decisions& decide_;
};

void forge_root(Forger& forge) {
  forge.integer("/", "format_version", kResultsFormatVersion);
  for (const char* name :
       {"unbruised_version", "config", "config_sha256", "study_name", "study_kind", "created_utc"}) {
    forge.text("/", name, name);
  }
  forge.integer("/", "complete", 1);
}

void forge_scenarios(Forger& forge, std::uint64_t count) {
  forge.column("/scenarios/id", 'i', count);
  forge.column("/scenarios/outcome", 'b', count);
  forge.column("/scenarios/cause", 't', count);
  forge.column("/scenarios/outcome_time_s", 'd', count);
  forge.column("/scenarios/digest", 'u', count);
  for (const Metric metric : {Metric::cycle_time_s, Metric::slip_max_m}) {
    forge.column("/scenarios/metric/" + std::string(kMetricTable[static_cast<std::size_t>(metric)].name), 'd',
                 count);
  }
  forge.placed_column("/scenarios/input/strategy.grip_force_N", 'd', count, 0);
  forge.placed_column("/scenarios/input/product.use", 't', count, 1);
  if (!forge.wanted()) return;
  for (const char* name : {"/scenarios/search", "/scenarios/generation", "/scenarios/index"}) {
    forge.column(name, 'i', count);
  }
}

void forge_window(Forger& forge, std::uint64_t count) {
  if (!forge.wanted()) return;
  forge.column("/window/exists", 'b', count);
  forge.column("/window/note", 't', count);
  for (const char* name : {"hold_force_N", "damage_force_N", "margin", "hold_bracket_low_N", "hold_bracket_high_N",
                           "damage_bracket_low_N", "damage_bracket_high_N"}) {
    forge.column("/window/" + std::string(name), 'd', count);
  }
  forge.placed_column("/window/product.use", 't', count, 0);
}

void forge_table(Forger& forge, Hdf5File& file, std::uint64_t count) {
  if (!forge.wanted()) return;
  file.make_group("/best");
  forge.column("/best/place", 'i', count);
  forge.text("/best", "row", "place");
  forge.text("/best", "objective", "cycle_time_s");
  forge.integer("/best", "budget", 640);
  forge.placed_column("/best/cycle_time_s", 'd', count, 0);
  forge.placed_column("/best/stopped_by", 't', count, 1);
}

void forge_trace(Forger& forge, std::uint64_t count) {
  if (!forge.wanted()) return;
  for (const char* name :
       {"rest_position_m", "time_s", "displacement_m", "velocity_m_s", "acceleration_m_s2", "finger_force_N"}) {
    forge.column("/trace/" + std::string(name), 'd', count);
  }
  forge.scale("/trace/finger_force_N", "/trace/time_s", 0);
  forge.column("/contact_events/time_s", 'd', count);
  for (const char* name : {"node", "surface", "kind"})
    forge.column("/contact_events/" + std::string(name), 'i', count);
}

void forge_file(const fs::path& path, std::string_view input) {
  Decisions decide(input);
  Hdf5File file = Hdf5File::create(path);
  Forger forge(file, decide);
  forge_root(forge);
  forge_scenarios(forge, 3);
  forge_window(forge, 2);
  forge_table(forge, file, 1);
  forge_trace(forge, 3);
  std::ofstream(path, std::ios::binary) << file.image();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Hdf5Silence silence;
  static const fs::path path =
      fs::temp_directory_path() / ("unbruised-fuzz-" + std::to_string(::getpid()) + ".h5");
  forge_file(path, unbruised::fuzz::text_of(data, size));
  const auto summary = read_results_summary(path);
  if (summary) {
    for (const ScenarioRow& row : summary->rows) {
      unbruised::fuzz::require(row.inputs.size() == summary->inputs.size(), "a row has all inputs");
    }
    for (const ResultTable& table : summary->tables) {
      for (const ResultColumn& column : table.columns) {
        const std::size_t rows = std::visit([](const auto& values) { return values.size(); }, column.values);
        const std::size_t first =
            std::visit([](const auto& values) { return values.size(); }, table.columns[0].values);
        unbruised::fuzz::require(rows == first, "columns of a table are equally long");
      }
    }
    (void)summary->digest();
  } else {
    unbruised::fuzz::require(!summary.error().message.empty(), "a refused file says why");
  }
  if (const auto trace = read_trace(path)) {
    const std::size_t motion = trace->time_s.size() * 3 * static_cast<std::size_t>(trace->particle_count);
    unbruised::fuzz::require(trace->displacement_m.size() == motion,
                             "the motion has a value per time and freedom");
  }
  std::error_code ignored;
  fs::remove(path, ignored);
  return 0;
}
