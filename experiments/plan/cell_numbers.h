// Cells of a plan by number, as `isobench run --cells 3-7,12` and the tasks of a cluster name them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"

namespace isobench {

/// "3-7,12" as {3, 4, 5, 6, 7, 12}: ascending, no number twice, counted from 1. Throws UsageError, naming the words,
/// for anything else, for a range that runs backwards and for numbers beyond `count`, the cells that there are.
std::vector<std::size_t> parse_cell_numbers(const std::string& words, std::size_t count);

/// The same the other way round: ascending numbers in as few words as they can be said.
std::string cell_numbers_text(const std::vector<std::size_t>& numbers);

}  // namespace isobench
