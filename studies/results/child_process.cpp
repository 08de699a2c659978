#include "studies/results/child_process.hpp"

#include "studies/process/child_work.hpp"
#include "studies/results/durable_files.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

Expected<std::string> in_child_process(const std::filesystem::path& path,
                                       const std::function<std::string()>& body) {
  constexpr unsigned kSecondsMost = 600;  // then it is believed to hang: a gigabyte takes a few seconds
  ChildEnd end = work_in_child(body, {.seconds_most = kSecondsMost});
  if (end.answer) return std::move(*end.answer);
  if (end.no_child != 0) return system_error("start a process to read", path, end.no_child);
  return ResultsError{
      ResultsErrorKind::damaged,
      joined({path.string(), " is damaged: the process that read it with the HDF5 library ", end.how}),
      {}};
}

}  // namespace unbruised::studies
