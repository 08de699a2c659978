#pragma once

/// @file
/// Files that a study refers to: product and gripper files (`use`) and CSV tables of networks.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "studies/config/assemble.hpp"
#include "studies/config/document.hpp"
#include "studies/config/problems.hpp"

namespace unbruised::studies {

/// Particles, springs or loads of a network.
constexpr int kMaxListRows = 1'000'000;

struct CalibrateTable;
struct SpecimenBlock;

/// Opens the files of one study; each gets its rank for the order of messages.
class Library {
 public:
  Library(std::filesystem::path folder, std::filesystem::path config_root)
      : folder_(std::move(folder)), config_root_(std::move(config_root)) {}

  /// Entries of a product or gripper file under their study paths ("product.shape", "limits.slip_m"); of the
  /// blocks of a product ("random[0].key") with an empty entry for each table.
  /// @param table "product" or "gripper"
  /// @param use the entry that names the file
  std::vector<Entry> read(std::string_view table, const Entry& use, Problems& problems);

  /// Entries of a CSV file of particles or springs.
  /// @param list "product.particle" or "product.spring"
  std::vector<Entry> read_csv(std::string_view list, const Entry& named, Problems& problems);

  /// The numbers of one column of a CSV file, kFewestDataRows to kMaxDataRows of them; none where there is a
  /// problem.
  std::vector<double> read_column(const Entry& named, const std::string& column, Problems& problems);

  /// The curves of a CSV file, one block for each specimen.
  std::vector<SpecimenBlock> read_curves(const Entry& named, const CalibrateTable& settings, Problems& problems);

  /// Does a key name a file, or a part of one, that unfolds into other keys?
  static bool names_file(std::string_view key);
  /// Appends the places and heights of the last profile that entries name a file of.
  void read_profile(std::vector<Entry>& entries, Problems& problems);

  /// Appends the profile of a solid of revolution that entries name a file of.
  void read_product_profile(std::vector<Entry>& entries, Problems& problems);

  /// Reads the mesh that entries name a file of; its size comes before them, where they say none.
  void read_mesh(std::vector<Entry>& entries, Problems& problems);
  /// The meshes that were read, by `mesh_key`.
  [[nodiscard]] const Meshes& meshes() const { return meshes_; }

  /// Appends the joints and the flange of the URDF file that entries name.
  void read_arm(std::vector<Entry>& entries, Problems& problems);

  /// Appends the waypoints of the CSV file that entries name.
  void read_waypoints(std::vector<Entry>& entries, Problems& problems);

  /// Appends what a recorded demonstration says and the entries do not: lift, waypoints, place, grip force.
  void read_demonstration(std::vector<Entry>& entries, Problems& problems);

 private:
  struct Text {
    std::string content;
    std::shared_ptr<const std::string> file;
    int rank;
  };
  std::optional<Text> open(const Entry& named, Problems& problems);

  std::filesystem::path folder_;
  std::filesystem::path config_root_;
  int next_rank_ = 1;
  Meshes meshes_;
};

/// Puts the entries of a product's or gripper's table under their study paths ("product.source.mass_kg" too),
/// leaves out what only describes (name, description), and reports tables that do not belong there.
/// @param prefix of the entries' paths to be taken away, e.g. "vary[0].variant[1]."; empty for a whole file
std::vector<Entry> library_entries(const Document& document, std::string_view prefix, std::string_view table,
                                   Problems& problems);

/// Entries of a CSV text of particles or springs, at most kMaxListRows of them.
/// @param list "product.particle" or "product.spring"
/// @param file, rank of the text, for messages
std::vector<Entry> csv_entries(std::string_view list, std::string_view content,
                               const std::shared_ptr<const std::string>& file, int rank, Problems& problems);

/// The key that names the CSV file of a pad's profile.
inline constexpr std::string_view kProfileFileKey = "gripper.pad.profile_file";

/// Entries of such a text: the lists of its columns place_m and height_m.
std::vector<Entry> profile_entries(std::string_view content, const std::shared_ptr<const std::string>& file,
                                   int rank, Problems& problems);

/// Reads a file of at most 4 MiB (one byte more is returned for a larger one). Returns nothing and sets `why` when
/// it cannot be read.
std::optional<std::string> read_text_file(const std::filesystem::path& path, std::string& why);

}  // namespace unbruised::studies
