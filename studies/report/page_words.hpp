#pragma once

/// @file
/// What the page takes from the program's own tables, so that its words, limits and sources cannot drift from
/// them.

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace unbruised::studies {

/// { names: { "contact_yield_ratio_max": "contact yield ratio", ... }, unit_suffixes: [["_N", "N"], ...] }: names
/// of metrics, and of keys whose words are not their letters.
nlohmann::json page_words();

/// [{ metric, key }]: which keys of [limits] decide `slipped`.
nlohmann::json page_slip_limits();
/// [{ metric, key }]: which key of [limits] that decides `damaged` bounds which metric.
nlohmann::json page_damage_limits();

/// [{ key, value, source, standing }] of every number of product, gripper and limits in the resolved config.
nlohmann::json page_sources(const std::string& config_toml);

}  // namespace unbruised::studies
