#include "studies/results/hdf5_file.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <hdf5_hl.h>

#include "studies/results/hdf5_paged_driver.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace {

/// In a column of codes: not run.
constexpr std::int8_t kNoCode = -1;
/// What a file in memory grows by.
constexpr std::size_t kImageGrowth = std::size_t{256} << 10;
constexpr std::uint64_t kChunkBytes = 128 * 1024;

// Whole rows of the trailing dimensions, as many as fit in about kChunkBytes, at least one.
std::vector<hsize_t> chunk_extents(const Hdf5Extents& extents, std::size_t element_bytes) {
  std::vector<hsize_t> chunk(extents.begin(), extents.end());
  for (hsize_t& extent : chunk) extent = std::max<hsize_t>(extent, 1);
  hsize_t row_bytes = element_bytes;
  for (std::size_t axis = 1; axis < chunk.size(); ++axis) row_bytes *= chunk[axis];
  chunk.front() = std::clamp<hsize_t>(kChunkBytes / row_bytes, 1, chunk.front());
  return chunk;
}

/// zlib's middle way; higher ones take longer for some per cent.
constexpr unsigned kDeflateLevel = 4;

std::string last_part(const std::string& name) { return name.substr(name.rfind('/') + 1); }

}  // namespace

Hdf5File::Hdf5File(std::filesystem::path path, Hdf5Handle file) : path_(std::move(path)), file_(std::move(file)) {}

Hdf5Failure Hdf5File::failure(const std::string& action, const std::string& object) const {
  return Hdf5Failure(joined({"cannot ", action, " ", object, " in ", path_.string(), ": ", hdf5_reason()}));
}

Hdf5Handle Hdf5File::require(hid_t id, Hdf5Handle::Closer closer, const char* action,
                             const std::string& object) const {
  if (id < 0) throw failure(action, object);
  return Hdf5Handle(id, closer);
}

void Hdf5File::check(herr_t status, const char* action, const std::string& object) const {
  if (status < 0) throw failure(action, object);
}

Hdf5File Hdf5File::create(const std::filesystem::path& path) {
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST);
  const bool has_backing_store = false;
  H5Pset_fapl_core(access.id(), kImageGrowth, has_backing_store);
  Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
  if (!file.valid()) throw Hdf5Failure(joined({"cannot create ", path.string(), ": ", hdf5_reason()}));
  return {path, std::move(file)};
}

Hdf5File Hdf5File::create_in(PagedFile& pages, const std::filesystem::path& path) {
  const Hdf5Handle access = access_to(pages);
  Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
  if (!file.valid()) throw Hdf5Failure(joined({"cannot create ", path.string(), ": ", hdf5_reason()}));
  return {path, std::move(file)};
}

void Hdf5File::close() {
  check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "flush", "/");
  check(file_.reset(), "close", "/");
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid()) throw Hdf5Failure(joined({"cannot open ", path.string(), ": ", hdf5_reason()}));
  return {path, std::move(file)};
}

std::string Hdf5File::image() const {
  check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "flush", "/");
  const ssize_t size = H5Fget_file_image(file_.id(), nullptr, 0);
  if (size < 0) throw failure("measure", "/");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_.id(), bytes.data(), bytes.size()) != size) throw failure("take the bytes of", "/");
  return bytes;
}

void Hdf5File::make_group(const std::string& name) {
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  require(H5Gcreate2(file_.id(), name.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose, "create", name);
}

Hdf5Handle Hdf5File::make_dataset(const std::string& name, hid_t file_type, hid_t memory_type,
                                  const Hdf5Extents& extents, const void* fill) {
  const std::vector<hsize_t> size(extents.begin(), extents.end());
  // HDF5 has no chunk for a dimension that can never hold anything, so an empty one may grow.
  std::vector<hsize_t> limit = size;
  for (hsize_t& extent : limit) extent = extent == 0 ? H5S_UNLIMITED : extent;
  const int rank = static_cast<int>(size.size());
  const Hdf5Handle space = require(H5Screate_simple(rank, size.data(), limit.data()), H5Sclose, "size", name);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const auto chunk = chunk_extents(extents, H5Tget_size(file_type));
  check(H5Pset_chunk(creation.id(), rank, chunk.data()), "chunk", name);
  // A trace is long and smooth; columns of scenarios are short beside it and read more often.
  if (name.starts_with("/trace/") && H5Tis_variable_str(file_type) <= 0) {
    check(H5Pset_shuffle(creation.id()), "shuffle", name);
    check(H5Pset_deflate(creation.id(), kDeflateLevel), "compress", name);
  }
  // HDF5 has no filters for variable-length data; the hash beside the file covers the texts.
  if (H5Tis_variable_str(file_type) <= 0) check(H5Pset_fletcher32(creation.id()), "add a checksum to", name);
  H5Pset_obj_track_times(creation.id(), false);
  if (fill != nullptr) check(H5Pset_fill_value(creation.id(), memory_type, fill), "set the fill value of", name);
  const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links.id(), 1);
  return require(
      H5Dcreate2(file_.id(), name.c_str(), file_type, space.id(), links.id(), creation.id(), H5P_DEFAULT),
      H5Dclose, "create", name);
}

void Hdf5File::write_raw(const std::string& name, hid_t file_type, hid_t memory_type, const void* values,
                         const Hdf5Extents& extents, const void* fill) {
  Hdf5Handle set = make_dataset(name, file_type, memory_type, extents, fill);
  if (std::find(extents.begin(), extents.end(), 0U) == extents.end()) {
    check(H5Dwrite(set.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write", name);
  }
  check(set.reset(), "close", name);
}

Hdf5Column Hdf5File::make_column(const std::string& name, Hdf5Kind kind, std::uint64_t count) {
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  const std::int8_t no_code = kNoCode;
  Hdf5Column column;
  column.name_ = joined({name, " in ", path_.string()});
  const auto make = [&](hid_t file_type, hid_t memory_type, const void* fill) {
    column.set_ = make_dataset(name, file_type, memory_type, {count}, fill);
    column.memory_type_ = Hdf5Handle(H5Tcopy(memory_type), H5Tclose);
  };
  switch (kind) {
    case Hdf5Kind::number:
      make(H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &no_number);
      break;
    case Hdf5Kind::code:
      make(H5T_STD_I8LE, H5T_NATIVE_INT8, &no_code);
      break;
    case Hdf5Kind::integer:
      make(H5T_STD_I64LE, H5T_NATIVE_INT64, nullptr);
      break;
    case Hdf5Kind::digest:
      make(H5T_STD_U64LE, H5T_NATIVE_UINT64, nullptr);
      break;
    case Hdf5Kind::text: {
      const Hdf5Handle type = text_type();
      make(type.id(), type.id(), nullptr);
    }
  }
  return column;
}

void Hdf5Column::put(std::uint64_t first, std::uint64_t count, const void* values) {
  if (count == 0) return;
  const hsize_t start = first, length = count;
  const Hdf5Handle in_file(H5Dget_space(set_.id()), H5Sclose);
  const Hdf5Handle in_memory(H5Screate_simple(1, &length, nullptr), H5Sclose);
  if (H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, &start, nullptr, &length, nullptr) < 0 ||
      H5Dwrite(set_.id(), memory_type_.id(), in_memory.id(), in_file.id(), H5P_DEFAULT, values) < 0) {
    throw Hdf5Failure(joined({"cannot write ", name_, ": ", hdf5_reason()}));
  }
}

void Hdf5Column::write(std::uint64_t first, std::span<const std::string> texts) {
  std::vector<const char*> pointers;
  pointers.reserve(texts.size());
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  put(first, pointers.size(), pointers.data());
}

void Hdf5Column::close() {
  if (set_.reset() < 0) throw Hdf5Failure(joined({"cannot close ", name_, ": ", hdf5_reason()}));
}

void Hdf5File::write(const std::string& name, std::span<const double> values, const Hdf5Extents& extents) {
  const double fill = std::numeric_limits<double>::quiet_NaN();
  write_raw(name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data(), extents, &fill);
}

void Hdf5File::write(const std::string& name, std::span<const std::int8_t> values, const Hdf5Extents& extents,
                     std::int8_t fill) {
  write_raw(name, H5T_STD_I8LE, H5T_NATIVE_INT8, values.data(), extents, &fill);
}

void Hdf5File::write(const std::string& name, std::span<const std::uint8_t> values, const Hdf5Extents& extents) {
  write_raw(name, H5T_STD_U8LE, H5T_NATIVE_UINT8, values.data(), extents, nullptr);
}

void Hdf5File::write(const std::string& name, std::span<const std::int32_t> values, const Hdf5Extents& extents) {
  write_raw(name, H5T_STD_I32LE, H5T_NATIVE_INT32, values.data(), extents, nullptr);
}

void Hdf5File::write(const std::string& name, std::span<const std::int64_t> values, const Hdf5Extents& extents) {
  write_raw(name, H5T_STD_I64LE, H5T_NATIVE_INT64, values.data(), extents, nullptr);
}

void Hdf5File::write(const std::string& name, std::span<const std::uint64_t> values, const Hdf5Extents& extents) {
  write_raw(name, H5T_STD_U64LE, H5T_NATIVE_UINT64, values.data(), extents, nullptr);
}

void Hdf5File::write(const std::string& name, const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  const Hdf5Handle type = text_type();
  write_raw(name, type.id(), type.id(), pointers.data(), {texts.size()}, nullptr);
}

void Hdf5File::make_scale(const std::string& name) {
  check(H5DSset_scale(dataset(name).id(), last_part(name).c_str()), "make a dimension scale of", name);
}

void Hdf5File::attach_scale(const std::string& name, const std::string& scale, unsigned axis) {
  check(H5DSattach_scale(dataset(name).id(), dataset(scale).id(), axis), "attach a dimension scale to", name);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, hid_t file_type,
                               hid_t memory_type, const void* values, std::optional<std::uint64_t> length) {
  const Hdf5Handle owner = require(H5Oopen(file_.id(), object.c_str(), H5P_DEFAULT), H5Oclose, "open", object);
  const hsize_t extent = length.value_or(1);
  const Hdf5Handle space(length ? H5Screate_simple(1, &extent, nullptr) : H5Screate(H5S_SCALAR), H5Sclose);
  Hdf5Handle attribute_handle =
      require(H5Acreate2(owner.id(), name.c_str(), file_type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
              "add an attribute to", object);
  // An empty list has no buffer, and HDF5 refuses to write from none.
  if (extent > 0) check(H5Awrite(attribute_handle.id(), memory_type, values), "write an attribute of", object);
  check(attribute_handle.reset(), "close an attribute of", object);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Hdf5Handle type = text_type();
  const char* pointer = text.c_str();
  write_attribute(object, name, type.id(), type.id(), &pointer, std::nullopt);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, std::int32_t value) {
  write_attribute(object, name, H5T_STD_I32LE, H5T_NATIVE_INT32, &value, std::nullopt);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             std::span<const std::int64_t> values) {
  write_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, values.data(), values.size());
}
void Hdf5File::set_fixed_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Hdf5Handle type = require(H5Tcopy(H5T_C_S1), H5Tclose, "copy a type for", object);
  check(H5Tset_size(type.id(), text.size()), "size a text of", object);
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "pad a text of", object);
  write_attribute(object, name, type.id(), type.id(), text.data(), std::nullopt);
}
void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  write_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value, std::nullopt);
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             std::span<const std::int8_t> values) {
  write_attribute(object, name, H5T_STD_I8LE, H5T_NATIVE_INT8, values.data(), values.size());
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name,
                             const std::vector<std::string>& texts) {
  const Hdf5Handle type = text_type();
  std::vector<const char*> pointers;
  pointers.reserve(texts.size() + 1);  // HDF5 takes no null pointer, not even for an empty list
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  const char* const none = "";  // HDF5 wants an address even for an empty list
  write_attribute(object, name, type.id(), type.id(), texts.empty() ? &none : pointers.data(), pointers.size());
}

}  // namespace unbruised::studies
