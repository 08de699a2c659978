#pragma once

/// @file
/// HDF5 on a PagedFile. For use inside studies/results only.

#include "studies/results/hdf5_handle.hpp"
#include "studies/results/paged_file.hpp"

namespace unbruised::studies {

/// A property list of file access that makes a file of the earliest format in `pages`, which must outlive it. The
/// errors of the disk stand there: HDF5 itself never sees one, as it does not close what it could not write.
Hdf5Handle access_to(PagedFile& pages);

}  // namespace unbruised::studies
