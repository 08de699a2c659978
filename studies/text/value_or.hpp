#pragma once

/// @file
/// What comes back from whatever can fail through no fault of the program: a value, or what stood against it. By
/// whom the mistake was made says the type of the error: the user (`ConfigError`, or a sentence), files
/// (`ResultsError`). Mistakes of the program itself throw.

#include <utility>
#include <variant>

namespace unbruised::studies {

template <class T, class Error>
class ValueOr {
 public:
  ValueOr(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit on purpose
  ValueOr(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit on purpose
  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }
  /// Throws where there is none: whoever asks has to look first.
  [[nodiscard]] T& value() & { return std::get<0>(content_); }
  [[nodiscard]] const T& value() const& { return std::get<0>(content_); }
  [[nodiscard]] T value() && { return std::get<0>(std::move(content_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  [[nodiscard]] const Error& error() const { return std::get<1>(content_); }

 private:
  std::variant<T, Error> content_;
};

}  // namespace unbruised::studies
