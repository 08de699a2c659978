#include "studies/results/hdf5_handle.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace unbruised::studies {
namespace {

herr_t keep_first_description(unsigned, const H5E_error2_t* entry, void* target) {
  auto& text = *static_cast<std::string*>(target);
  if (text.empty() && entry->desc != nullptr) text = entry->desc;
  return 0;
}

}  // namespace

// Of the long descriptions about system calls only the system's own words.
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

Hdf5Handle text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

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

}  // namespace unbruised::studies
