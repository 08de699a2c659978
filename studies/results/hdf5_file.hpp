#pragma once

/// @file
/// A thin owner of HDF5 objects: every call checked, every error names file and object, nothing printed.
/// For use inside studies/results only; its doors catch `Hdf5Failure`.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studies/results/hdf5_handle.hpp"

namespace unbruised::studies {

using Hdf5Extents = std::vector<std::uint64_t>;

class PagedFile;

/// What the values of a column are.
enum class Hdf5Kind { number, code, integer, digest, text };

/// A dataset of one dimension that is being filled.
class Hdf5Column {
 public:
  /// Values from place `first` on, of the type of its kind: double, int8, int64, uint64, text. Whole chunks serve
  /// best. Throws Hdf5Failure.
  void write(std::uint64_t first, std::span<const double> values) { put(first, values.size(), values.data()); }
  void write(std::uint64_t first, std::span<const std::int8_t> values) {
    put(first, values.size(), values.data());
  }
  void write(std::uint64_t first, std::span<const std::int64_t> values) {
    put(first, values.size(), values.data());
  }
  void write(std::uint64_t first, std::span<const std::uint64_t> values) {
    put(first, values.size(), values.data());
  }
  void write(std::uint64_t first, std::span<const std::string> texts);
  /// Throws Hdf5Failure: what was written may not be there.
  void close();

 private:
  friend class Hdf5File;
  void put(std::uint64_t first, std::uint64_t count, const void* values);
  std::string name_;
  Hdf5Handle set_;
  Hdf5Handle memory_type_;
};

/// Some values of a dataset of one dimension; by default all.
struct Hdf5Part {
  std::uint64_t first = 0;
  std::uint64_t count = ~std::uint64_t{0};
};

/// One HDF5 file. Object names are absolute paths; groups on the way are made as needed. Every dataset is
/// chunked; numbers are little endian with fletcher32, texts variable-length UTF-8 (without: HDF5 cannot).
class Hdf5File {
 public:
  /// A new file of the earliest format, in memory alone: HDF5 writes much of a file whenever it likes, also while
  /// objects are closed, where an error of the disk is easily missed.
  /// @param path for messages
  static Hdf5File create(const std::filesystem::path& path);
  /// The same in pages that must outlive it: of a large file most are on the disk.
  static Hdf5File create_in(PagedFile& pages, const std::filesystem::path& path);
  /// An existing file, read-only.
  static Hdf5File open(const std::filesystem::path& path);
  /// The bytes of a file made by `create`, as they belong on the disk.
  [[nodiscard]] std::string image() const;

  /// Closes a file made by `create_in`: nothing of it is in HDF5's own memory any more.
  void close();

  void make_group(const std::string& name);
  /// A one-dimensional dataset whose values come part by part.
  Hdf5Column make_column(const std::string& name, Hdf5Kind kind, std::uint64_t count);
  void write(const std::string& name, std::span<const double> values, const Hdf5Extents& extents);
  void write(const std::string& name, std::span<const std::int8_t> values, const Hdf5Extents& extents,
             std::int8_t fill);
  void write(const std::string& name, std::span<const std::uint8_t> values, const Hdf5Extents& extents);
  void write(const std::string& name, std::span<const std::int32_t> values, const Hdf5Extents& extents);
  void write(const std::string& name, std::span<const std::int64_t> values, const Hdf5Extents& extents);
  void write(const std::string& name, std::span<const std::uint64_t> values, const Hdf5Extents& extents);
  void write(const std::string& name, const std::vector<std::string>& texts);

  /// Turns a one-dimensional dataset into the scale of a dimension called as the last part of its name.
  void make_scale(const std::string& name);
  /// Attaches a scale to dimension `axis` of a dataset.
  void attach_scale(const std::string& dataset, const std::string& scale, unsigned axis);

  void set_attribute(const std::string& object, const std::string& name, const std::string& text);
  void set_attribute(const std::string& object, const std::string& name, std::int32_t value);
  void set_attribute(const std::string& object, const std::string& name, std::span<const std::int8_t> values);
  void set_attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
  void set_attribute(const std::string& object, const std::string& name, double value);
  /// A text of fixed length, as files for VTK have it.
  void set_fixed_attribute(const std::string& object, const std::string& name, const std::string& text);
  void set_attribute(const std::string& object, const std::string& name, const std::vector<std::string>& texts);

  [[nodiscard]] bool exists(const std::string& name) const;
  /// Names of the datasets directly below a group, alphabetical.
  [[nodiscard]] std::vector<std::string> datasets(const std::string& group) const;
  /// Names of the groups directly below a group, alphabetical.
  [[nodiscard]] std::vector<std::string> groups(const std::string& group) const;
  /// Names of the attributes of an object, alphabetical.
  [[nodiscard]] std::vector<std::string> attributes(const std::string& object) const;
  [[nodiscard]] Hdf5Extents extents(const std::string& name) const;
  [[nodiscard]] bool holds_text(const std::string& name) const;
  [[nodiscard]] std::vector<double> read_doubles(const std::string& name, const Hdf5Part& part = {}) const;
  [[nodiscard]] std::vector<std::int64_t> read_integers(const std::string& name, const Hdf5Part& part = {}) const;
  [[nodiscard]] std::vector<std::uint64_t> read_unsigned(const std::string& name, const Hdf5Part& part = {}) const;
  [[nodiscard]] std::vector<std::string> read_texts(const std::string& name, const Hdf5Part& part = {}) const;
  /// The names of the dimension scales of a dataset, last parts only; empty where there is none.
  [[nodiscard]] std::vector<std::string> dimension_names(const std::string& name) const;
  [[nodiscard]] std::optional<std::string> text_attribute(const std::string& object,
                                                          const std::string& name) const;
  /// A list of texts, of one dimension.
  [[nodiscard]] std::optional<std::vector<std::string>> texts_attribute(const std::string& object,
                                                                        const std::string& name) const;
  [[nodiscard]] std::optional<std::int64_t> integer_attribute(const std::string& object,
                                                              const std::string& name) const;
  [[nodiscard]] std::optional<double> number_attribute(const std::string& object, const std::string& name) const;

 private:
  [[nodiscard]] std::vector<std::string> members(const std::string& group, H5I_type_t type) const;
  Hdf5File(std::filesystem::path path, Hdf5Handle file);
  [[nodiscard]] Hdf5Failure failure(const std::string& action, const std::string& object) const;
  Hdf5Handle require(hid_t id, Hdf5Handle::Closer closer, const char* action, const std::string& object) const;
  void check(herr_t status, const char* action, const std::string& object) const;
  Hdf5Handle make_dataset(const std::string& name, hid_t file_type, hid_t memory_type, const Hdf5Extents& extents,
                          const void* fill);
  void write_raw(const std::string& name, hid_t file_type, hid_t memory_type, const void* values,
                 const Hdf5Extents& extents, const void* fill);
  void write_attribute(const std::string& object, const std::string& name, hid_t file_type, hid_t memory_type,
                       const void* values, std::optional<std::uint64_t> length);
  [[nodiscard]] Hdf5Handle dataset(const std::string& name) const;
  [[nodiscard]] Hdf5Handle attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] Hdf5Extents extents(const Hdf5Handle& set, const std::string& name) const;
  [[nodiscard]] bool holds_text(const Hdf5Handle& set, const std::string& name) const;
  template <class T>
  [[nodiscard]] std::vector<T> read_raw(const Hdf5Handle& set, const std::string& name, hid_t memory_type,
                                        const Hdf5Part& part) const;

  std::filesystem::path path_;
  Hdf5Handle file_;
};

}  // namespace unbruised::studies
