#include "studies/ranks/join_ranks.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include <dlfcn.h>

#include "studies/config/locations.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

namespace fs = std::filesystem;

constexpr const char* kModule = "libunbruised_mpi.so";
using MakeLink = MessageLink* (*)();

int number_of(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? 1 : std::max(1, std::atoi(text));
}

/// Beside the program, as it is built; below its prefix, as it is installed.
fs::path module_file() {
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / kModule;
  return fs::exists(beside, error) ? beside : program_prefix() / "lib" / "unbruised" / kModule;
}

}  // namespace

int rank_count() { return number_of("OMPI_COMM_WORLD_SIZE"); }

int ranks_on_this_machine() { return number_of("OMPI_COMM_WORLD_LOCAL_SIZE"); }

ValueOr<std::unique_ptr<MessageLink>, std::string> join_ranks() {
  const fs::path file = module_file();
  std::error_code error;
  if (!fs::exists(file, error)) {
    return joined({"started by mpirun as one of ", std::to_string(rank_count()),
                   " processes, but this build has no MPI (docs/cluster.md); run parts with --shard instead"});
  }
  // Open MPI loads modules of its own, which look for its symbols among those of everybody.
  void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  const auto make =
      module == nullptr ? nullptr : reinterpret_cast<MakeLink>(::dlsym(module, "unbruised_mpi_link"));
  if (make == nullptr) return joined({"cannot load ", file.string(), ": ", ::dlerror()});
  return std::unique_ptr<MessageLink>(make());
}

}  // namespace unbruised::studies
