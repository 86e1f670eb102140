// Where CGAL stops at one of its own checks, as an error that a user can act on.
#pragma once

#include <CGAL/exceptions.h>
#include <fmt/format.h>

#include <filesystem>
#include <string_view>

#include "isobench/foundation/error.h"

namespace isobench {

/// work(). Throws Error where CGAL does not go on, as it may on surfaces that touch themselves.
template <class Work>
auto with_cgal(std::string_view method, Work work) {
  try {
    return work();
  } catch (const CGAL::Failure_exception& failure) {
    throw Error(fmt::format(
        "{}: CGAL stopped at one of its own checks ({}, line {}); the surface may touch itself or nearly so: try a "
        "slightly different isovalue, another edge length, or --smooth 1",
        method, std::filesystem::path(failure.filename()).filename().string(), failure.line_number()));
  }
}

}  // namespace isobench
