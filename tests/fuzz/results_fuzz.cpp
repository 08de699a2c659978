// results.h5 files that HDF5 itself finds sound, made by our own writer and then edited: the input says which
// objects and attributes go, come back shorter, of another type, rank or value. An empty input leaves the file as
// it was written. Damaged bytes are another matter: they can crash libhdf5 itself, so they are read in a child
// process (SECURITY.md).

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>
#include <unistd.h>

#include "core/outcome/outcome.hpp"
#include "studies/results/hdf5_file.hpp"
#include "studies/results/results_file.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace unbruised;
using namespace unbruised::studies;
using unbruised::fuzz::require;
namespace fs = std::filesystem;

Trace short_trace() {
  Trace trace;
  trace.particle_count = 2;
  trace.rest_position_m.assign(6, 0.01);
  trace.time_s = {0.0, 0.001, 0.002};
  for (auto* motion : {&trace.displacement_m, &trace.velocity_m_s, &trace.acceleration_m_s2})
    motion->assign(18, 0.5);
  trace.signals = {{"finger_force_N", "N", "force", {"finger", "component"}, {2, 3}, std::vector<double>(18, 1.0)},
                   {"motor_force_N", "N", "force", {}, {}, {1.0, 2.0, 3.0}}};
  trace.events = {{0.001, 0, 1, ContactEvent::Kind::make}, {0.002, 1, 0, ContactEvent::Kind::slip}};
  return trace;
}

WindowTable short_window() {
  WindowTable window;
  window.inputs = {{"product.use", "", "product"}};
  window.rows.resize(2);
  for (WindowRow& row : window.rows) row.inputs = {std::string("kiwi.toml")};
  window.rows[0].exists = true;
  window.rows[0].hold_force_N = 1.0;
  return window;
}

ResultTable short_table() {
  return {.name = "best",
          .row = "place",
          .columns = {{"cycle_time_s", "s", "cycle time", std::vector<double>{0.8, 0.9}},
                      {"stopped_by", "", "", std::vector<std::string>{"budget", "budget"}}},
          .attributes = {{"objective", std::string("cycle_time_s")}, {"budget", 640.0}}};
}

/// What a file is of: a sweep has a window, a search places and a table, a scenario that was run alone a trace.
enum class Kind { sweep, search, scenario };

std::string written(Kind kind) {
  const Trace trace = short_trace();
  const WindowTable window = short_window();
  ResultsContent content;
  content.meta = {.unbruised_version = "0.1.0",
                  .config_toml = "[study]\n",
                  .config_sha256 = {},
                  .study_name = "fuzz",
                  .study_kind = "sweep",
                  .created_utc = "2026-01-01T00:00:00Z",
                  .instruction_set = "avx2",
                  .compiler = "GNU 12.2.0"};
  content.inputs = {{"strategy.grip_force_N", "N", "grip force"}, {"product.use", "", "product"}};
  for (std::uint64_t id = 0; id < 3; ++id) {
    ScenarioRow row;
    row.id = id;
    row.result.outcome = id == 0 ? Outcome::held : Outcome::dropped;
    row.inputs = {1.0, std::string("kiwi.toml")};
    if (kind == Kind::search) row.place = SearchPlace{0, id, 0};
    content.rows.push_back(std::move(row));
  }
  if (kind == Kind::search) content.tables = {short_table()};
  if (kind == Kind::sweep) content.window = &window;
  if (kind == Kind::scenario) content.trace = &trace;
  const auto image = results_image("fuzz.h5", content);
  require(image.has_value(), "our own writer writes");
  return *image;
}

struct Attribute {
  std::string object;
  std::string name;
};

/// A sound file and what there is to edit in it.
struct Sound {
  std::string image;
  std::vector<std::string> objects;  // datasets and groups, absolute paths
  std::vector<Attribute> attributes;
};

/// An image opened in memory for editing.
class Editor {
 public:
  explicit Editor(const std::string& image) {
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fapl_core(access.id(), std::size_t{64} << 10, false);
    H5Pset_file_image(access.id(), const_cast<char*>(image.data()), image.size());
    file_ = Hdf5Handle(H5Fopen("fuzz.h5", H5F_ACC_RDWR, access.id()), H5Fclose);
    require(file_.valid(), "a sound image opens");
  }

  [[nodiscard]] hid_t id() const { return file_.id(); }

  [[nodiscard]] std::string image() const {
    H5Fflush(file_.id(), H5F_SCOPE_GLOBAL);
    std::string bytes(static_cast<std::size_t>(H5Fget_file_image(file_.id(), nullptr, 0)), '\0');
    H5Fget_file_image(file_.id(), bytes.data(), bytes.size());
    return bytes;
  }

  void remove(const std::string& object) { H5Ldelete(id(), object.c_str(), H5P_DEFAULT); }

  /// Another dataset in the place of one, with its attributes.
  void replace(const std::string& name, hid_t type, std::vector<hsize_t> extents, int value) {
    const Hdf5Handle old(H5Oopen(id(), name.c_str(), H5P_DEFAULT), H5Oclose);
    if (!old.valid()) return;
    remove(name);
    const Hdf5Handle space(extents.empty()
                               ? H5Screate(H5S_SCALAR)
                               : H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
                           H5Sclose);
    const Hdf5Handle set(H5Dcreate2(id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Dclose);
    if (!set.valid()) return;
    fill(set.id(), value);
    hid_t target = set.id();
    H5Aiterate2(old.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, copy_attribute, &target);
  }

  void replace_by_group(const std::string& name) {
    remove(name);
    const Hdf5Handle group(H5Gcreate2(id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  }

  /// Sets all values of a dataset.
  static void fill(hid_t set, int value) {
    const Hdf5Handle space(H5Dget_space(set), H5Sclose);
    const auto count = static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space.id()), 0));
    const Hdf5Handle type(H5Dget_type(set), H5Tclose);
    if (H5Tget_class(type.id()) == H5T_STRING) {
      static const std::array<const char*, 4> texts = {"", "one", "../../x", "<script>"};
      const std::vector<const char*> values(count, texts[static_cast<std::size_t>(value) % texts.size()]);
      if (H5Tis_variable_str(type.id()) > 0) {
        H5Dwrite(set, type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      }
      return;
    }
    static const std::array<double, 8> odd = {0.0,
                                              -1.0,
                                              1e300,
                                              -1e19,
                                              std::numeric_limits<double>::quiet_NaN(),
                                              std::numeric_limits<double>::infinity(),
                                              127.0,
                                              5.0};
    const std::vector<double> values(count, value < 8 ? odd[static_cast<std::size_t>(value)] : value - 128);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }

  void set_attribute(const Attribute& attribute, hid_t type, hid_t space, const void* value) {
    remove(attribute);
    const Hdf5Handle created(H5Acreate_by_name(id(), attribute.object.c_str(), attribute.name.c_str(), type, space,
                                               H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
    if (created.valid()) H5Awrite(created.id(), type, value);
  }

  void remove(const Attribute& attribute) {
    H5Adelete_by_name(id(), attribute.object.c_str(), attribute.name.c_str(), H5P_DEFAULT);
  }

 private:
  // All but the references of dimension scales, which would point to what is gone.
  static herr_t copy_attribute(hid_t object, const char* name, const H5A_info_t*, void* target) {
    const Hdf5Handle from(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(H5Aget_type(from.id()), H5Tclose);
    const Hdf5Handle space(H5Aget_space(from.id()), H5Sclose);
    const H5T_class_t kind = H5Tget_class(type.id());
    if (kind == H5T_VLEN || kind == H5T_COMPOUND || kind == H5T_REFERENCE) return 0;
    const auto count = static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space.id()), 0));
    std::vector<char> bytes(std::max<std::size_t>(count, 1) * H5Tget_size(type.id()));
    if (H5Aread(from.id(), type.id(), bytes.data()) < 0) return 0;
    const Hdf5Handle to(
        H5Acreate2(*static_cast<hid_t*>(target), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    if (to.valid()) H5Awrite(to.id(), type.id(), bytes.data());
    if (H5Tis_variable_str(type.id()) > 0) H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, bytes.data());
    return 0;
  }

  Hdf5Handle file_;
};

herr_t note_attribute(hid_t, const char* name, const H5A_info_t*, void* target) {
  auto& [object, sound] = *static_cast<std::pair<std::string, Sound*>*>(target);
  sound->attributes.push_back({object, name});
  return 0;
}

herr_t note_object(hid_t file, const char* name, const H5O_info_t*, void* target) {
  auto& sound = *static_cast<Sound*>(target);
  std::pair<std::string, Sound*> of{std::string(name) == "." ? "/" : "/" + std::string(name), &sound};
  if (of.first != "/") sound.objects.push_back(of.first);
  const Hdf5Handle object(H5Oopen(file, name, H5P_DEFAULT), H5Oclose);
  H5Aiterate2(object.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, note_attribute, &of);
  return 0;
}

/// Two metrics are as good as all of them, and sooner read.
Sound prepared(Kind kind) {
  Editor editor(written(kind));
  for (const MetricInfo& metric : kMetricTable) {
    const std::string name(metric.name);
    if (name != "cycle_time_s" && name != "slip_max_m") editor.remove("/scenarios/metric/" + name);
  }
  Sound sound;
  H5Ovisit2(editor.id(), H5_INDEX_NAME, H5_ITER_INC, note_object, &sound, H5O_INFO_BASIC);
  sound.image = editor.image();
  return sound;
}

hid_t type_of(unsigned number) {
  static const Hdf5Handle text = [] {
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), H5T_VARIABLE);
    H5Tset_cset(type.id(), H5T_CSET_UTF8);
    return type;
  }();
  const std::array<hid_t, 8> types = {H5T_IEEE_F64LE, H5T_STD_I64LE, H5T_STD_U64LE, H5T_STD_I8LE,
                                      H5T_IEEE_F32LE, H5T_STD_I32BE, text.id(),     H5T_STD_U8LE};
  return types[number % types.size()];
}

void edit_object(Editor& editor, const std::string& object, unsigned action, unsigned value) {
  switch (action % 8) {
    case 0:
      return editor.remove(object);
    case 1:
      return editor.replace_by_group(object);
    case 2:
      return editor.replace(object, type_of(value), {value / 8 % 8}, 5);
    case 3:
      return editor.replace(object, type_of(value), {}, 5);
    case 4:
      return editor.replace(object, type_of(value), {3, value / 8 % 4}, 5);
    case 5:
      return editor.replace(object, type_of(value), {3, value / 8 % 4, 3}, 5);
    case 6:
      return editor.replace(object, type_of(value), {2 + value / 8 % 2}, static_cast<int>(value % 8));
    default:
      const Hdf5Handle set(H5Dopen2(editor.id(), object.c_str(), H5P_DEFAULT), H5Dclose);
      if (set.valid()) Editor::fill(set.id(), static_cast<int>(value));
  }
}

void edit_attribute(Editor& editor, const Attribute& attribute, unsigned action, unsigned value) {
  const Hdf5Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  switch (action % 6) {
    case 0:
      return editor.remove(attribute);
    case 1: {
      static const std::array<const char*, 5> texts = {"", "one", "../../x", "2", "<script>"};
      const char* text = texts[value % texts.size()];
      return editor.set_attribute(attribute, type_of(6), scalar.id(), &text);
    }
    case 2: {
      const double number = value % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e300;
      return editor.set_attribute(attribute, H5T_NATIVE_DOUBLE, scalar.id(), &number);
    }
    case 3: {
      const auto number = static_cast<std::int32_t>(value) - 128;
      return editor.set_attribute(attribute, H5T_NATIVE_INT32, scalar.id(), &number);
    }
    case 4: {
      const std::int64_t number =
          value % 2 == 0 ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
      return editor.set_attribute(attribute, H5T_NATIVE_INT64, scalar.id(), &number);
    }
    default: {
      const hsize_t extent = value % 4;
      const std::array<std::int8_t, 3> numbers = {1, 2, 3};
      const Hdf5Handle row(H5Screate_simple(1, &extent, nullptr), H5Sclose);
      return editor.set_attribute(attribute, H5T_NATIVE_INT8, row.id(), numbers.data());
    }
  }
}

/// Every four bytes are an edit: of what, where, how, with what.
std::string edited(Kind kind, std::string_view edits) {
  static const std::array<Sound, 3> files = {prepared(Kind::sweep), prepared(Kind::search),
                                             prepared(Kind::scenario)};
  const Sound& sound = files[static_cast<std::size_t>(kind)];
  if (edits.size() < 4) return sound.image;
  const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(edits[at])); };
  Editor editor(sound.image);
  for (std::size_t at = 0; at + 4 <= edits.size(); at += 4) {
    if (byte(at) % 2 == 0) {
      edit_object(editor, sound.objects[byte(at + 1) % sound.objects.size()], byte(at + 2), byte(at + 3));
    } else {
      edit_attribute(editor, sound.attributes[byte(at + 1) % sound.attributes.size()], byte(at + 2), byte(at + 3));
    }
  }
  return editor.image();
}

void check(const ResultsSummary& summary) {
  for (const ScenarioRow& row : summary.rows) {
    require(row.inputs.size() == summary.inputs.size(), "a row has all inputs");
  }
  require(summary.digests.size() == summary.rows.size(), "a row has a digest");
  for (const ResultTable& table : summary.tables) {
    const auto rows_of = [](const ResultColumn& column) {
      return std::visit([](const auto& values) { return values.size(); }, column.values);
    };
    for (const ResultColumn& column : table.columns) {
      require(rows_of(column) == rows_of(table.columns[0]), "columns of a table are equally long");
    }
  }
  if (summary.window) {
    for (const WindowRow& row : summary.window->rows) {
      require(row.inputs.size() == summary.window->inputs.size(), "a row of the window has all inputs");
    }
  }
  (void)summary.digest();
}

void check(const Trace& trace) {
  const std::size_t motion = trace.time_s.size() * 3 * static_cast<std::size_t>(trace.particle_count);
  require(trace.displacement_m.size() == motion, "the motion has a value per time and freedom");
  require(trace.velocity_m_s.size() == motion, "the velocity has a value per time and freedom");
}

}  // namespace

// The first byte chooses the file and what is read of it, the others edit it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Hdf5Silence silence;
  static const fs::path path =
      fs::temp_directory_path() / ("unbruised-fuzz-" + std::to_string(::getpid()) + ".h5");
  const unsigned choice = size == 0 ? 0 : data[0] % 8;
  const Kind kind = choice < 3 ? Kind::sweep : choice < 5 ? Kind::search : Kind::scenario;
  const std::string_view edits = unbruised::fuzz::text_of(data, size).substr(size == 0 ? 0 : 1);
  std::ofstream(path, std::ios::binary) << edited(kind, edits);
  if (choice < 6) {
    if (const auto summary = read_results_summary(path)) {
      check(*summary);
    } else {
      require(!summary.error().message.empty(), "a refused file says why");
    }
  } else if (const auto trace = read_trace(path)) {
    check(*trace);
  }
  std::error_code ignored;
  fs::remove(path, ignored);
  return 0;
}
