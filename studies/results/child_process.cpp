#include "studies/results/child_process.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace fs = std::filesystem;

namespace {

/// Processor time after which a reader is believed to hang: a gigabyte takes a few seconds.
constexpr rlim_t kChildSecondsMost = 600;

/// Ends the child's answer: without it the answer is not whole.
constexpr std::string_view kEndMark = "the answer is whole";

void limit(int resource, rlim_t most) {
  const rlimit wanted{most, most};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

[[noreturn]] void answer_and_end(int descriptor, const std::function<std::string()>& body) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, kChildSecondsMost);
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  std::string answer;
  try {
    answer = body();
  } catch (...) {
    ::_exit(1);
  }
  answer.append(kEndMark);
  for (std::string_view rest = answer; !rest.empty();) {
    const ssize_t written = ::write(descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ::_exit(1);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  ::_exit(0);
}

std::string text_until_end(int descriptor) {
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16);
  for (;;) {
    const ssize_t length = ::read(descriptor, buffer.data(), buffer.size());
    if (length < 0 && errno == EINTR) continue;
    if (length <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(length));
  }
}

int status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string how_it_ended(int status) {
  if (!WIFSIGNALED(status)) return "gave up on it";
  if (WTERMSIG(status) == SIGXCPU) return "did not come to an end with it";
  return joined({"crashed on it (", ::strsignal(WTERMSIG(status)), ")"});
}

}  // namespace

Expected<std::string> in_child_process(const fs::path& path, const std::function<std::string()>& body) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) return system_error("start a process to read", path, errno);
  const pid_t child = ::fork();
  const int reason = errno;
  if (child == 0) {
    ::close(ends[0]);  // else a child whose parent was killed would wait for a reader for ever
    answer_and_end(ends[1], body);
  }
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    return system_error("start a process to read", path, reason);
  }
  std::string text = text_until_end(ends[0]);
  ::close(ends[0]);
  const int status = status_of(child);
  if (status == 0 && text.ends_with(kEndMark)) {
    text.resize(text.size() - kEndMark.size());
    return text;
  }
  return ResultsError{ResultsErrorKind::damaged,
                      joined({path.string(), " is damaged: the process that read it with the HDF5 library ",
                              how_it_ended(status)}),
                      {}};
}

}  // namespace unbruised::studies
