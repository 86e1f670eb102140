// Lists of cell numbers, "3-7,12", as `isobench run --cells` takes them and the tasks of a cluster name them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "isobench/foundation/error.h"

namespace isobench {

/// "3-7,12" gives {3, 4, 5, 6, 7, 12}: ascending, no number twice. Cells count from 1 to `count`. Throws UsageError for
/// other words, a range that runs backwards and a number that no cell has.
std::vector<std::size_t> parse_cell_numbers(const std::string& words, std::size_t count);

/// The inverse: the shortest list of these ascending numbers.
std::string cell_numbers_text(const std::vector<std::size_t>& numbers);

}  // namespace isobench
