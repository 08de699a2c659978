#include "studies/results/paged_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "studies/results/durable_files.hpp"

namespace unbruised::studies {

PagedFile::PagedFile(std::filesystem::path path, std::size_t pages_in_memory)
    : path_(std::move(path)), temporary_(temporary_of(path_)), pages_in_memory_(pages_in_memory) {}

PagedFile::~PagedFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (!is_published_) ::unlink(temporary_.c_str());  // what is unfinished is of no use, and takes room
}

void PagedFile::fail(std::string_view action) {
  if (!failure_) failure_ = system_error(action, temporary_, errno);
}

void PagedFile::create() {
  if (descriptor_ >= 0 || failure_) return;
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor_ < 0) fail("create");
}

/// Writes a page as far as the file goes.
void PagedFile::put(std::uint64_t number, Page& page) {
  if (!page.is_dirty || failure_) return;
  create();
  if (failure_) return;
  const std::uint64_t begin = number * kPageBytes;
  std::string_view rest(page.bytes);
  if (bytes_ > begin) rest = rest.substr(0, bytes_ - begin);
  std::uint64_t at = begin;
  while (!rest.empty()) {
    const ssize_t written = ::pwrite(descriptor_, rest.data(), rest.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return fail("write");
    rest.remove_prefix(static_cast<std::size_t>(written));
    at += static_cast<std::uint64_t>(written);
  }
  page.is_dirty = false;
  on_disk_ = std::max(on_disk_, number + 1);
}

void PagedFile::make_room() {
  if (failure_ || pages_.size() < pages_in_memory_) return;
  const std::uint64_t oldest = by_age_.back();
  put(oldest, pages_.at(oldest));
  if (failure_) return;
  by_age_.pop_back();
  pages_.erase(oldest);
}

PagedFile::Page& PagedFile::page(std::uint64_t number) {
  if (const auto found = pages_.find(number); found != pages_.end()) {
    by_age_.splice(by_age_.begin(), by_age_, found->second.age);
    return found->second;
  }
  make_room();
  by_age_.push_front(number);
  Page& page = pages_[number];
  page.age = by_age_.begin();
  page.bytes.resize(kPageBytes);
  if (number >= on_disk_) return page;
  for (std::size_t have = 0; have < kPageBytes;) {
    const ssize_t length = ::pread(descriptor_, page.bytes.data() + have, kPageBytes - have,
                                   static_cast<off_t>(number * kPageBytes + have));
    if (length < 0 && errno == EINTR) continue;
    if (length < 0) fail("read");
    if (length <= 0) break;
    have += static_cast<std::size_t>(length);
  }
  return page;
}

void PagedFile::write(std::uint64_t at, std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t offset = at % kPageBytes;
    const std::size_t count = std::min(bytes.size(), kPageBytes - offset);
    Page& into = page(at / kPageBytes);
    std::memcpy(into.bytes.data() + offset, bytes.data(), count);
    into.is_dirty = true;
    bytes.remove_prefix(count);
    at += count;
  }
}

void PagedFile::read(std::uint64_t at, char* bytes, std::size_t count) {
  while (count > 0) {
    const std::size_t offset = at % kPageBytes;
    const std::size_t part = std::min(count, kPageBytes - offset);
    std::memcpy(bytes, page(at / kPageBytes).bytes.data() + offset, part);
    bytes += part;
    at += part;
    count -= part;
  }
}

void PagedFile::each_page(const std::function<void(std::string_view bytes)>& look) {
  for (std::uint64_t number = 0; number * kPageBytes < bytes_; ++number) {
    look(std::string_view(page(number).bytes).substr(0, bytes_ - number * kPageBytes));
  }
}

MaybeError PagedFile::finish() {
  std::vector<std::uint64_t> numbers;
  for (const auto& [number, page] : pages_) {
    if (number * kPageBytes < bytes_) numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  create();
  for (const std::uint64_t number : numbers) put(number, pages_.at(number));
  if (!failure_ && ::ftruncate(descriptor_, static_cast<off_t>(bytes_)) != 0) fail("truncate");
  if (!failure_ && ::fsync(descriptor_) != 0) fail("sync");
  return failure_;
}

MaybeError PagedFile::publish() {
  if (failure_) return failure_;
  if (auto error = publish_file(temporary_, path_)) return error;
  is_published_ = true;
  return {};
}

}  // namespace unbruised::studies
