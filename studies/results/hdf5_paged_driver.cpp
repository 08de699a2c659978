#include "studies/results/hdf5_paged_driver.hpp"

#include <algorithm>
#include <string_view>

namespace unbruised::studies {
namespace {

/// What HDF5 knows of an open file: its own part comes first.
struct OpenPages {
  H5FD_t own{};
  PagedFile* pages = nullptr;
  haddr_t end_of_addresses = 0;
};

struct Where {
  PagedFile* pages;
};

OpenPages& of(H5FD_t* file) { return *reinterpret_cast<OpenPages*>(file); }
const OpenPages& of(const H5FD_t* file) { return *reinterpret_cast<const OpenPages*>(file); }

H5FD_t* open(const char* /*name*/, unsigned /*flags*/, hid_t access, haddr_t /*most*/) {
  const auto* where = static_cast<const Where*>(H5Pget_driver_info(access));
  return where == nullptr ? nullptr : &(new OpenPages{.own = {}, .pages = where->pages})->own;
}

herr_t close(H5FD_t* file) {
  delete &of(file);
  return 0;
}

/// As the driver for files in memory has it, so that the bytes are laid out alike.
herr_t query(const H5FD_t* /*file*/, unsigned long* flags) {
  if (flags != nullptr) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA;
  }
  return 0;
}

haddr_t end_of_addresses(const H5FD_t* file, H5FD_mem_t /*type*/) { return of(file).end_of_addresses; }

herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t address) {
  of(file).end_of_addresses = address;
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t /*type*/) { return of(file).pages->size(); }

herr_t read(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t address, std::size_t size,
            void* buffer) {
  of(file).pages->read(address, static_cast<char*>(buffer), size);
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t address, std::size_t size,
             const void* buffer) {
  PagedFile& pages = *of(file).pages;
  pages.resize(std::max<std::uint64_t>(pages.size(), address + size));
  pages.write(address, {static_cast<const char*>(buffer), size});
  return 0;
}

herr_t truncate(H5FD_t* file, hid_t /*transfer*/, hbool_t /*closing*/) {
  of(file).pages->resize(of(file).end_of_addresses);
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
  driver.name = "unbruised_pages";
  driver.maxaddr = (haddr_t{1} << 62U) - 1;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(Where);
  driver.open = open;
  driver.close = close;
  driver.query = query;
  driver.get_eoa = end_of_addresses;
  driver.set_eoa = set_end_of_addresses;
  driver.get_eof = end_of_file;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  constexpr H5FD_mem_t kDichotomy[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kDichotomy), std::end(kDichotomy), std::begin(driver.fl_map));
  return driver;
}

hid_t driver_id() {
  static const H5FD_class_t driver = driver_class();
  static const hid_t id = H5FDregister(&driver);
  return id;
}

}  // namespace

Hdf5Handle access_to(PagedFile& pages) {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST);
  const Where where{&pages};
  H5Pset_driver(access.id(), driver_id(), &where);
  return access;
}

}  // namespace unbruised::studies
