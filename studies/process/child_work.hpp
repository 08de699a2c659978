#pragma once

/// @file
/// Work that may crash, hang or take all memory, done in a child process.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace unbruised::studies {

struct ChildLimits {
  unsigned seconds_most = 600;  ///< of processor time
  std::size_t bytes_more = 0;   ///< of address space beyond what the parent has; 0: no limit
};

/// How the work ended.
struct ChildEnd {
  std::optional<std::string> answer;  ///< what the body returned, if it came whole
  std::string how;                    ///< without an answer: "crashed on it (Segmentation fault)"
  int no_child = 0;                   ///< errno, where there could be no child
};

/// What `body` returns, computed in a child process that prints nothing.
ChildEnd work_in_child(const std::function<std::string()>& body, const ChildLimits& limits);

}  // namespace unbruised::studies
