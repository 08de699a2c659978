#pragma once

/// @file
/// Owners of HDF5 identifiers, its silence, and its reasons. For use inside studies/results only.

#include <stdexcept>
#include <string>

#include <hdf5.h>

namespace unbruised::studies {

/// Thrown inside studies/results when an HDF5 call fails; `what()` is a whole sentence.
class Hdf5Failure : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Owns one HDF5 identifier and closes it with the function of its kind.
class Hdf5Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept;
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  ~Hdf5Handle() { reset(); }
  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  /// Closes it; a negative status where that failed, which for what was written means that it may not be there.
  herr_t reset();

 private:
  hid_t id_ = -1;
  Closer closer_ = nullptr;
};

/// Keeps HDF5 from printing its error stack while it lives.
class Hdf5Silence {
 public:
  Hdf5Silence();
  ~Hdf5Silence();
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* client_ = nullptr;
};

/// The innermost description on HDF5's error stack: the one that says what happened.
std::string hdf5_reason();
/// Variable-length UTF-8.
Hdf5Handle text_type();

}  // namespace unbruised::studies
