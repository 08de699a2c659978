// The half of Hdf5File that reads: what stands in a file may be damaged, and is believed only as far as it is
// checked.

#include <algorithm>
#include <utility>

#include <hdf5_hl.h>

#include "studies/results/hdf5_file.hpp"
#include "studies/text/joined.hpp"

namespace unbruised::studies {
namespace {

/// Of a list in an attribute; a damaged file may promise any number.
constexpr hssize_t kTextsOfAttributeMost = 65536;
// A damaged extent must not be believed into an allocation: more than any study or trace of ours.
constexpr std::uint64_t kMaxElements = std::uint64_t{1} << 34;

std::uint64_t element_count(const Hdf5Extents& extents) {
  std::uint64_t count = 1;
  for (const std::uint64_t extent : extents) {
    if (extent != 0 && count > kMaxElements / extent) return kMaxElements + 1;
    count *= extent;
  }
  return count;
}

}  // namespace

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
std::vector<T> Hdf5File::read_raw(const Hdf5Handle& set, const std::string& name, hid_t memory_type,
                                  const Hdf5Part& part) const {
  const Hdf5Extents size = extents(set, name);
  const std::uint64_t all = element_count(size);
  if (all > kMaxElements) throw Hdf5Failure(joined({name, " in ", path_.string(), " has an absurd size"}));
  const hsize_t first = std::min<std::uint64_t>(part.first, all);
  const hsize_t count = std::min<std::uint64_t>(part.count, all - first);
  std::vector<T> values(count);
  if (count == 0) return values;
  if (count == all) {
    check(H5Dread(set.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read", name);
    return values;
  }
  if (size.size() != 1) throw Hdf5Failure(joined({name, " in ", path_.string(), " has more than one dimension"}));
  const Hdf5Handle in_file = require(H5Dget_space(set.id()), H5Sclose, "size", name);
  const Hdf5Handle in_memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  check(H5Sselect_hyperslab(in_file.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr), "select in", name);
  check(H5Dread(set.id(), memory_type, in_memory.id(), in_file.id(), H5P_DEFAULT, values.data()), "read", name);
  return values;
}

std::vector<double> Hdf5File::read_doubles(const std::string& name, const Hdf5Part& part) const {
  return read_raw<double>(dataset(name), name, H5T_NATIVE_DOUBLE, part);
}

std::vector<std::int64_t> Hdf5File::read_integers(const std::string& name, const Hdf5Part& part) const {
  return read_raw<std::int64_t>(dataset(name), name, H5T_NATIVE_INT64, part);
}

std::vector<std::uint64_t> Hdf5File::read_unsigned(const std::string& name, const Hdf5Part& part) const {
  return read_raw<std::uint64_t>(dataset(name), name, H5T_NATIVE_UINT64, part);
}

std::vector<std::string> Hdf5File::read_texts(const std::string& name, const Hdf5Part& part) const {
  const Hdf5Handle set = dataset(name);
  if (!holds_text(set, name)) throw Hdf5Failure(joined({name, " in ", path_.string(), " does not hold text"}));
  const Hdf5Handle type = text_type();
  std::vector<char*> pointers = read_raw<char*>(set, name, type.id(), part);
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
