#include "studies/process/child_work.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Ends the child's answer: without it the answer is not whole.
constexpr std::string_view kEndMark = "the answer is whole";

/// @param after most, before the process is killed without a signal that says why
void limit(int resource, rlim_t most, rlim_t after = 0) {
  const rlimit wanted{most, most + after};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &wanted);
}

/// Address space of this process; 0 where it is not known, or where a sanitizer takes all there is.
std::size_t own_bytes() {
#ifdef UNBRUISED_SANITIZER
  return 0;
#else
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
#endif
}

[[noreturn]] void answer_and_end(int descriptor, const std::function<std::string()>& body,
                                 const ChildLimits& limits) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds_most, 1);
  const std::size_t bytes = own_bytes();
  if (bytes > 0 && limits.bytes_more > 0) limit(RLIMIT_AS, bytes + limits.bytes_more);
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

ChildEnd work_in_child(const std::function<std::string()>& body, const ChildLimits& limits) {
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) return {.answer = {}, .how = {}, .no_child = errno};
  const pid_t child = ::fork();
  const int reason = errno;
  if (child == 0) {
    ::close(ends[0]);  // else a child whose parent was killed would wait for a reader for ever
    answer_and_end(ends[1], body, limits);
  }
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    return {.answer = {}, .how = {}, .no_child = reason};
  }
  std::string text = text_until_end(ends[0]);
  ::close(ends[0]);
  const int status = status_of(child);
  if (status != 0 || !text.ends_with(kEndMark)) return {.answer = {}, .how = how_it_ended(status)};
  text.resize(text.size() - kEndMark.size());
  return {.answer = std::move(text), .how = {}};
}

}  // namespace unbruised::studies
