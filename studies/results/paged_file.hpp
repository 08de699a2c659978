#pragma once

/// @file
/// A file that is being made: in memory as far as it is small, what is too much of it on the disk already. Every
/// write is ours, so that no error of the disk is missed (HDF5 writes while it closes objects).

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <string>
#include <string_view>
#include <unordered_map>

#include "studies/results/expected.hpp"

namespace unbruised::studies {

/// Beside `path` while it is made, as `<path>.tmp`; there when it is published. What an ended process left of the
/// temporary file is overwritten, and so is gone with the next try.
class PagedFile {
 public:
  static constexpr std::size_t kPageBytes = std::size_t{1} << 20;
  static constexpr std::size_t kPagesInMemory = 64;

  /// @param pages_in_memory > 0
  explicit PagedFile(std::filesystem::path path, std::size_t pages_in_memory = kPagesInMemory);
  /// Removes the temporary file unless it was published.
  ~PagedFile();
  PagedFile(const PagedFile&) = delete;
  PagedFile& operator=(const PagedFile&) = delete;

  void write(std::uint64_t at, std::string_view bytes);
  /// Behind the end.
  void append(std::string_view bytes) {
    bytes_ += bytes.size();
    write(bytes_ - bytes.size(), bytes);
  }
  /// What was not written is zero.
  void read(std::uint64_t at, char* bytes, std::size_t count);
  /// How long it is in the end.
  void resize(std::uint64_t bytes) { bytes_ = bytes; }
  [[nodiscard]] std::uint64_t size() const { return bytes_; }
  /// The first error of the disk: from then on nothing is written any more, and everything stays in memory.
  [[nodiscard]] const MaybeError& failure() const { return failure_; }
  /// Shows the whole of it, page by page.
  void each_page(const std::function<void(std::string_view bytes)>& look);
  /// Writes what is left, synced; then, under its own name, durably. Errors: io, those from before too.
  MaybeError finish();
  MaybeError publish();

 private:
  struct Page {
    std::string bytes;
    bool is_dirty = false;
    std::list<std::uint64_t>::iterator age;
  };
  Page& page(std::uint64_t number);
  void make_room();
  void create();
  void put(std::uint64_t number, Page& page);
  void fail(std::string_view action);

  std::filesystem::path path_, temporary_;
  std::size_t pages_in_memory_;
  int descriptor_ = -1;
  bool is_published_ = false;
  std::uint64_t bytes_ = 0;
  std::uint64_t on_disk_ = 0;  ///< pages from here on were never on the disk
  std::unordered_map<std::uint64_t, Page> pages_;
  std::list<std::uint64_t> by_age_;  ///< used last, first
  MaybeError failure_;
};

}  // namespace unbruised::studies
