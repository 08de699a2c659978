#pragma once

/// @file
/// What of one lane goes along with its scenario when that moves to a lane of another batch. Every class that
/// keeps something per lane from step to step lists it once, in `archive`, for both directions; what a scenario
/// alone decides is not listed, `load` puts it there.

#include <any>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/lanes/lane.hpp"

namespace unbruised {

/// The content of a lane, in the order in which it was listed.
struct LaneContent {
  std::vector<double> number;
  std::vector<std::any> object;
};

class LaneArchive {
 public:
  /// Takes out of a lane what is listed.
  static LaneArchive out_of(int lane, LaneContent& content) { return {lane, content, false}; }
  /// Puts it into a lane, listed in the same order.
  static LaneArchive into(int lane, LaneContent& content) { return {lane, content, true}; }

  /// Into the lane?
  [[nodiscard]] bool arrives() const { return arrives_; }
  [[nodiscard]] int lane() const { return lane_; }

  void operator()(double& value) {
    if (arrives_) {
      value = content_.number[number_++];
    } else {
      content_.number.push_back(value);
    }
  }
  void operator()(Lane& value) {
    double of_lane = value[lane_];
    (*this)(of_lane);
    if (arrives_) value.set(lane_, of_lane);
  }
  void operator()(Mask& mask) {
    double of_lane = mask[lane_] ? 1.0 : 0.0;
    (*this)(of_lane);
    if (arrives_) mask.set(lane_, of_lane > 0.0);
  }
  void operator()(LaneArray& rows) {
    for (std::size_t i = 0; i < rows.rows(); ++i) (*this)(rows.at(i, lane_));
  }
  void operator()(MaskArray& rows) {
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      Mask mask = rows.get(i);
      (*this)(mask);
      if (arrives_) rows.put(i, mask);
    }
  }
  template <class T, std::size_t N>
  void operator()(std::array<T, N>& values) {
    for (T& value : values) (*this)(value);
  }
  /// A structure of lanes and nothing else.
  template <class Lanes>
  void members(Lanes& values) {
    static_assert(std::is_trivially_copyable_v<Lanes> && sizeof(Lanes) % sizeof(Lane) == 0);
    std::array<Lane, sizeof(Lanes) / sizeof(Lane)> each;
    static_assert(sizeof(each) == sizeof(Lanes));
    __builtin_memcpy(static_cast<void*>(&each), &values, sizeof(values));
    (*this)(each);
    if (arrives_) __builtin_memcpy(static_cast<void*>(&values), &each, sizeof(values));
  }
  /// What belongs to one lane as a whole.
  template <class T>
  void object(T& value) {
    if (arrives_) {
      value = std::any_cast<T&&>(std::move(content_.object[object_++]));
    } else {
      content_.object.emplace_back(std::move(value));
    }
  }
  template <class First, class Second, class... More>
  void operator()(First& first, Second& second, More&... more) {
    (*this)(first);
    (*this)(second, more...);
  }

 private:
  LaneArchive(int lane, LaneContent& content, bool arrives) : lane_(lane), content_(content), arrives_(arrives) {}

  int lane_;
  LaneContent& content_;
  bool arrives_;
  std::size_t number_ = 0, object_ = 0;
};

}  // namespace unbruised
