#include "studies/results/durable_files.hpp"

#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

ResultsError system_error(std::string_view action, const fs::path& path, int error_number) {
  return {ResultsErrorKind::io,
          joined({"cannot ", action, " ", path.string(), ": ", std::generic_category().message(error_number)}),
          {}};
}

namespace {

MaybeError sync_path(const fs::path& path, int flags, int (*sync)(int)) {
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0) return system_error("open", path, errno);
  const int outcome = sync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  if (outcome != 0) return system_error("sync", path, reason);
  return {};
}

}  // namespace

MaybeError sync_directory(const fs::path& directory) {
  return sync_path(directory, O_RDONLY | O_DIRECTORY, ::fsync);
}

MaybeError sync_file(const fs::path& path) { return sync_path(path, O_RDONLY, ::fdatasync); }

namespace {

MaybeError write_all(int descriptor, std::string_view text, const fs::path& path) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return system_error("write", path, errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace

fs::path temporary_of(const fs::path& path) {
  fs::path temporary = path;
  temporary += ".tmp";
  return temporary;
}

MaybeError publish_file(const fs::path& temporary, const fs::path& path) {
  if (::rename(temporary.c_str(), path.c_str()) != 0) return system_error("rename", temporary, errno);
  return sync_directory(path.has_parent_path() ? path.parent_path() : fs::path("."));
}

MaybeError write_text_file(const fs::path& path, std::string_view text) {
  const fs::path temporary = temporary_of(path);
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return system_error("create", temporary, errno);
  MaybeError error = write_all(descriptor, text, temporary);
  if (!error && ::fsync(descriptor) != 0) error = system_error("sync", temporary, errno);
  if (::close(descriptor) != 0 && !error) error = system_error("close", temporary, errno);
  if (!error) error = publish_file(temporary, path);
  if (error) ::unlink(temporary.c_str());  // what is unfinished is of no use, and takes room
  return error;
}

MaybeError read_in_pieces(const fs::path& path, const std::function<void(std::string_view)>& look) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return system_error("open", path, errno);
  std::vector<char> buffer(std::size_t{1} << 20);
  ssize_t length = 0;
  while ((length = ::read(descriptor, buffer.data(), buffer.size())) != 0) {
    if (length < 0 && errno == EINTR) continue;
    if (length < 0) break;
    look({buffer.data(), static_cast<std::size_t>(length)});
  }
  const int reason = errno;
  ::close(descriptor);
  if (length < 0) return system_error("read", path, reason);
  return {};
}

Expected<std::string> read_text_file(const fs::path& path) {
  std::string text;
  if (auto error = read_in_pieces(path, [&text](std::string_view piece) { text.append(piece); })) return *error;
  return text;
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string("unknown");
}

std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  return file >> id ? id : std::string("unknown");
}

}  // namespace unbruised::studies
