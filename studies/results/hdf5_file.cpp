#include "studies/results/hdf5_file.hpp"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include <hdf5_hl.h>

#include "studies/text/joined.hpp"

namespace unbruised::studies {

namespace {

/// Of a list in an attribute; a damaged file may promise any number.
constexpr hssize_t kTextsOfAttributeMost = 65536;

/// What a file in memory grows by.
constexpr std::size_t kImageGrowth = std::size_t{256} << 10;
constexpr std::uint64_t kChunkBytes = 128 * 1024;
// A damaged extent must not be believed into an allocation: more than any study or trace of ours.
constexpr std::uint64_t kMaxElements = std::uint64_t{1} << 34;

herr_t keep_first_description(unsigned, const H5E_error2_t* entry, void* target) {
  auto& text = *static_cast<std::string*>(target);
  if (text.empty() && entry->desc != nullptr) text = entry->desc;
  return 0;
}

// The innermost description on HDF5's error stack: the one that says what happened. Of the long ones about
// system calls only the system's own words.
std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first_description, &reason);
  constexpr std::string_view kSystemWords = "error message = '";
  if (const std::size_t at = reason.find(kSystemWords); at != std::string::npos) {
    reason = reason.substr(at + kSystemWords.size());
    reason.resize(std::min(reason.find('\''), reason.size()));
  }
  return reason.empty() ? std::string("HDF5 gives no reason") : reason;
}

std::uint64_t element_count(const Hdf5Extents& extents) {
  std::uint64_t count = 1;
  for (const std::uint64_t extent : extents) {
    if (extent != 0 && count > kMaxElements / extent) return kMaxElements + 1;
    count *= extent;
  }
  return count;
}

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

Hdf5Handle text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

std::string last_part(const std::string& name) { return name.substr(name.rfind('/') + 1); }

}  // namespace

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept
    : id_(std::exchange(other.id_, -1)), closer_(std::exchange(other.closer_, nullptr)) {}

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
  if (this != &other) {
    reset();
    id_ = std::exchange(other.id_, -1);
    closer_ = std::exchange(other.closer_, nullptr);
  }
  return *this;
}

herr_t Hdf5Handle::reset() {
  if (id_ < 0 || closer_ == nullptr) return 0;
  return closer_(std::exchange(id_, -1));
}

Hdf5Silence::Hdf5Silence() {
  // Everything is closed by its owner. What a full disk leaves open cannot be closed at exit either: HDF5 would
  // print "infinite loop closing library" there.
  static const herr_t no_exit_handler = H5dont_atexit();
  static_cast<void>(no_exit_handler);
  H5Eget_auto2(H5E_DEFAULT, &function_, &client_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Silence::~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, function_, client_); }

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

void Hdf5File::write_raw(const std::string& name, hid_t file_type, hid_t memory_type, const void* values,
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
  Hdf5Handle set =
      require(H5Dcreate2(file_.id(), name.c_str(), file_type, space.id(), links.id(), creation.id(), H5P_DEFAULT),
              H5Dclose, "create", name);
  if (element_count(extents) > 0) {
    check(H5Dwrite(set.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write", name);
  }
  check(set.reset(), "close", name);
}

void Hdf5File::write(const std::string& name, std::span<const double> values, const Hdf5Extents& extents) {
  const double fill = std::numeric_limits<double>::quiet_NaN();
  write_raw(name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data(), extents, &fill);
}

void Hdf5File::write(const std::string& name, std::span<const std::int8_t> values, const Hdf5Extents& extents,
                     std::int8_t fill) {
  write_raw(name, H5T_STD_I8LE, H5T_NATIVE_INT8, values.data(), extents, &fill);
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

bool Hdf5File::exists(const std::string& name) const {
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (H5Lexists(file_.id(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

namespace {

herr_t collect_name(hid_t, const char* name, const H5L_info_t*, void* target) {
  static_cast<std::vector<std::string>*>(target)->emplace_back(name);
  return 0;
}

}  // namespace

std::vector<std::string> Hdf5File::members(const std::string& group, H5I_type_t type) const {
  const Hdf5Handle owner = require(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT), H5Gclose, "open", group);
  std::vector<std::string> names;
  check(H5Literate(owner.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect_name, &names), "list", group);
  std::erase_if(names, [&](const std::string& name) {
    const Hdf5Handle object(H5Oopen(owner.id(), name.c_str(), H5P_DEFAULT), H5Oclose);
    return !object.valid() || H5Iget_type(object.id()) != type;
  });
  return names;
}

std::vector<std::string> Hdf5File::datasets(const std::string& group) const { return members(group, H5I_DATASET); }

std::vector<std::string> Hdf5File::groups(const std::string& group) const { return members(group, H5I_GROUP); }

std::vector<std::string> Hdf5File::attributes(const std::string& object) const {
  const Hdf5Handle owner = require(H5Oopen(file_.id(), object.c_str(), H5P_DEFAULT), H5Oclose, "open", object);
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  check(H5Aiterate2(owner.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), "list", object);
  return names;
}

Hdf5Handle Hdf5File::dataset(const std::string& name) const {
  return require(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, "open", name);
}

Hdf5Extents Hdf5File::extents(const std::string& name) const { return extents(dataset(name), name); }

Hdf5Extents Hdf5File::extents(const Hdf5Handle& set, const std::string& name) const {
  const Hdf5Handle space = require(H5Dget_space(set.id()), H5Sclose, "size", name);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  check(rank, "size", name);
  std::vector<hsize_t> size(static_cast<std::size_t>(rank));
  check(H5Sget_simple_extent_dims(space.id(), size.data(), nullptr), "size", name);
  return {size.begin(), size.end()};
}

bool Hdf5File::holds_text(const std::string& name) const { return holds_text(dataset(name), name); }

bool Hdf5File::holds_text(const Hdf5Handle& set, const std::string& name) const {
  const Hdf5Handle type = require(H5Dget_type(set.id()), H5Tclose, "type", name);
  return H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) > 0;
}

template <class T>
std::vector<T> Hdf5File::read_raw(const Hdf5Handle& set, const std::string& name, hid_t memory_type) const {
  const std::uint64_t count = element_count(extents(set, name));
  if (count > kMaxElements) throw Hdf5Failure(joined({name, " in ", path_.string(), " has an absurd size"}));
  std::vector<T> values(count);
  if (count == 0) return values;
  check(H5Dread(set.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read", name);
  return values;
}

std::vector<double> Hdf5File::read_doubles(const std::string& name) const {
  return read_raw<double>(dataset(name), name, H5T_NATIVE_DOUBLE);
}

std::vector<std::int64_t> Hdf5File::read_integers(const std::string& name) const {
  return read_raw<std::int64_t>(dataset(name), name, H5T_NATIVE_INT64);
}

std::vector<std::uint64_t> Hdf5File::read_unsigned(const std::string& name) const {
  return read_raw<std::uint64_t>(dataset(name), name, H5T_NATIVE_UINT64);
}

std::vector<std::string> Hdf5File::read_texts(const std::string& name) const {
  const Hdf5Handle set = dataset(name);
  if (!holds_text(set, name)) throw Hdf5Failure(joined({name, " in ", path_.string(), " does not hold text"}));
  const Hdf5Handle type = text_type();
  std::vector<char*> pointers = read_raw<char*>(set, name, type.id());
  std::vector<std::string> texts;
  for (const char* pointer : pointers) texts.emplace_back(pointer == nullptr ? "" : pointer);
  for (char* pointer : pointers) H5free_memory(pointer);
  return texts;
}

namespace {

/// What H5DSset_scale called a dimension scale; empty where that is no text of fixed length.
std::string scale_name(hid_t scale) {
  if (H5Aexists(scale, "NAME") <= 0) return {};
  const Hdf5Handle attribute(H5Aopen(scale, "NAME", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0 ||
      H5Sget_simple_extent_npoints(space.id()) != 1) {
    return {};
  }
  std::string name(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), type.id(), name.data()) < 0) return {};
  return name.substr(0, name.find('\0'));
}

}  // namespace

// Not by H5DSiterate_scales: that one takes the attribute for a list of references unseen, and crashes where it is
// none.
std::vector<std::string> Hdf5File::dimension_names(const std::string& name) const {
  std::vector<std::string> names(extents(name).size());
  const Hdf5Handle list = attribute(name, "DIMENSION_LIST");
  if (!list.valid()) return names;
  const Hdf5Handle stored(H5Aget_type(list.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(list.id()), H5Sclose);
  const bool is_list = H5Tget_class(stored.id()) == H5T_VLEN;
  const Hdf5Handle element(is_list ? H5Tget_super(stored.id()) : H5I_INVALID_HID, H5Tclose);
  if (!element.valid() || H5Tequal(element.id(), H5T_STD_REF_OBJ) <= 0 ||
      H5Sget_simple_extent_npoints(space.id()) != static_cast<hssize_t>(names.size())) {
    throw failure("understand the dimension scales of", name);
  }
  std::vector<hvl_t> scales(names.size());
  check(H5Aread(list.id(), stored.id(), scales.data()), "read the dimension scales of", name);
  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    if (scales[axis].len == 0) continue;
    const Hdf5Handle scale(H5Rdereference2(list.id(), H5P_DEFAULT, H5R_OBJECT, scales[axis].p), H5Oclose);
    if (scale.valid()) names[axis] = scale_name(scale.id());
  }
  H5Dvlen_reclaim(stored.id(), space.id(), H5P_DEFAULT, scales.data());
  return names;
}

Hdf5Handle Hdf5File::attribute(const std::string& object, const std::string& name) const {
  if (H5Aexists_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT) <= 0) return {};
  return require(H5Aopen_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                 "open an attribute of", object);
}

std::optional<std::string> Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  const Hdf5Handle handle = attribute(object, name);
  if (!handle.valid()) return std::nullopt;
  const Hdf5Handle stored(H5Aget_type(handle.id()), H5Tclose);
  if (H5Tis_variable_str(stored.id()) <= 0) return std::nullopt;
  const Hdf5Handle space(H5Aget_space(handle.id()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) return std::nullopt;
  const Hdf5Handle type = text_type();
  char* pointer = nullptr;
  check(H5Aread(handle.id(), type.id(), &pointer), "read an attribute of", object);
  std::string text = pointer == nullptr ? "" : pointer;
  H5free_memory(pointer);
  return text;
}

std::optional<std::vector<std::string>> Hdf5File::texts_attribute(const std::string& object,
                                                                  const std::string& name) const {
  const Hdf5Handle handle = attribute(object, name);
  if (!handle.valid()) return std::nullopt;
  const Hdf5Handle stored(H5Aget_type(handle.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(handle.id()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (H5Tis_variable_str(stored.id()) <= 0 || H5Sget_simple_extent_ndims(space.id()) != 1 || count < 0 ||
      count > kTextsOfAttributeMost) {
    return std::nullopt;
  }
  const Hdf5Handle type = text_type();
  std::vector<char*> pointers(static_cast<std::size_t>(count), nullptr);
  if (count > 0) check(H5Aread(handle.id(), type.id(), pointers.data()), "read an attribute of", object);
  std::vector<std::string> texts;
  for (const char* pointer : pointers) texts.emplace_back(pointer == nullptr ? "" : pointer);
  for (char* pointer : pointers) H5free_memory(pointer);
  return texts;
}

std::optional<std::int64_t> Hdf5File::integer_attribute(const std::string& object, const std::string& name) const {
  const Hdf5Handle handle = attribute(object, name);
  if (!handle.valid()) return std::nullopt;
  const Hdf5Handle stored(H5Aget_type(handle.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(handle.id()), H5Sclose);
  if (H5Tget_class(stored.id()) != H5T_INTEGER || H5Sget_simple_extent_npoints(space.id()) != 1)
    return std::nullopt;
  std::int64_t value = 0;
  check(H5Aread(handle.id(), H5T_NATIVE_INT64, &value), "read an attribute of", object);
  return value;
}

std::optional<double> Hdf5File::number_attribute(const std::string& object, const std::string& name) const {
  const Hdf5Handle handle = attribute(object, name);
  if (!handle.valid()) return std::nullopt;
  const Hdf5Handle stored(H5Aget_type(handle.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(handle.id()), H5Sclose);
  if (H5Tget_class(stored.id()) != H5T_FLOAT || H5Sget_simple_extent_npoints(space.id()) != 1) return std::nullopt;
  double value = 0.0;
  check(H5Aread(handle.id(), H5T_NATIVE_DOUBLE, &value), "read an attribute of", object);
  return value;
}

}  // namespace unbruised::studies
