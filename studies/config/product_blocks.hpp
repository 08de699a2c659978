#pragma once

/// @file
/// What a product's file says of how products differ: [[random]] and [[correlation]] blocks of its own.

#include <vector>

#include "studies/config/sorted_text.hpp"

namespace unbruised::studies {

/// Puts the blocks of a product's file behind those of the study. The study has the last word: a key that it
/// draws, searches or gives a value itself is not drawn by the file, and a pair of its own [[correlation]] blocks
/// is not taken from there; a correlation needs two keys that are drawn.
/// @param product entries of the file, with an empty one for each table of a block (library_entries)
void add_blocks_of_product(const std::vector<Entry>& product, SortedText& text);

}  // namespace unbruised::studies
