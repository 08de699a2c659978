#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/places.hpp"

namespace unbruised::testing {

/// Says what a test found, and leaves it for `scripts/test --all`, which prints all figures at its end.
/// @param name of the file under build/PRESET/figures; one test writes it
inline void tell_figure(const std::string& name, const std::string& sentence) {
  std::printf("%s\n", sentence.c_str());
  const std::filesystem::path folder = std::filesystem::path(UNBRUISED_BINARY_DIR) / "figures";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / (name + ".txt")) << sentence << '\n';
}

}  // namespace unbruised::testing
