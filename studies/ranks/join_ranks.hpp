#pragma once

/// @file
/// Was this process started beside others by mpirun, and how it talks to them. The library of MPI is loaded only
/// then, with a module of this program (mpi_link.cpp) that stands beside it or in lib/unbruised of its prefix.

#include <memory>
#include <string>

#include "studies/ranks/message_link.hpp"
#include "studies/text/value_or.hpp"

namespace unbruised::studies {

/// Processes that mpirun has started together; 1 without it.
int rank_count();
/// Of them, those on this machine.
int ranks_on_this_machine();

/// Joins them, once in a process; or a sentence that says why not.
ValueOr<std::unique_ptr<MessageLink>, std::string> join_ranks();

}  // namespace unbruised::studies
