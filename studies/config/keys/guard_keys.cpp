#include "studies/config/keys/key_fields.hpp"
#include "studies/config/keys/key_tables.hpp"

namespace unbruised::studies::key_rows {

using enum KeyType;

Table range_keys() {
  using R = RangeSensorParameters;
  return {
      {.path = "gripper.range.maximum_m",
       .type = optional_number,
       .meaning = "Largest range that the range sensor of each finger reads: a ray along the way that the finger "
                  "closes, from its start to the product.",
       .use = Use::gripper,
       .note = "absent: the fingers have no range sensors",
       .field = range<&R::maximum_m>},
      {.path = "gripper.range.offset_m",
       .type = numbers,
       .meaning = "From the middle of the pad's face to the ray, along y and z.",
       .size = 2,
       .use = Use::range,
       .field = range<&R::offset_m>},
      {.path = "gripper.range.depth_m",
       .type = number,
       .meaning = "How far the ray starts behind the pad's face; negative: in front of it.",
       .use = Use::range,
       .field = range<&R::depth_m>},
      {.path = "gripper.range.rate_Hz",
       .type = optional_number,
       .meaning = "Samples per second; each is held until the next.",
       .use = Use::range,
       .note = "absent: it reads at all times",
       .field = range<&R::rate_Hz>},
      {.path = "gripper.range.resolution_m",
       .type = number,
       .meaning = "Readings are multiples of it; 0: any range.",
       .use = Use::range,
       .field = range<&R::resolution_m>},
      {.path = "gripper.range.noise_m",
       .type = number,
       .meaning = "Standard deviation of a sample.",
       .use = Use::range,
       .field = range<&R::noise_m>},
      {.path = "gripper.range.noise_seed",
       .type = integer,
       .meaning = "Of the noise; scenarios with the same seed have the same noise, sample by sample.",
       .use = Use::range,
       .field = range<&R::noise_seed>},
  };
}

Table guard_keys() {
  using S = StrategyParameters;
  return {
      {.path = "strategy.guard",
       .type = choice,
       .meaning =
           "What slows the closing fingers down: nothing; a range sensor that reads less than guard_range_m; "
           "a measured finger force above guard_force_N, with which the grip then begins.",
       .choices = {"none", "range", "force"},
       .use = Use::gripper,
       .field = strategy<&S::guard>},
      {.path = "strategy.guard_range_m",
       .type = optional_number,
       .meaning = "Both fingers slow down once a range sensor reads less.",
       .use = Use::range_guard,
       .field = strategy<&S::guard_range_m>},
      {.path = "strategy.guard_force_N",
       .type = optional_number,
       .meaning = "Both fingers slow down, and the grip begins, once the measured force of a finger is larger.",
       .use = Use::force_guard,
       .field = strategy<&S::guard_force_N>},
      {.path = "strategy.guard_speed_m_s",
       .type = number,
       .meaning = "Closing speed of each finger that the guard sets; 0: they stop until the grip's force rises.",
       .use = Use::guard,
       .field = strategy<&S::guard_speed_m_s>},
  };
}

}  // namespace unbruised::studies::key_rows
