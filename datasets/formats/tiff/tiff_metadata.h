// What programs write into a TIFF file's description: the meaning of its pages and the spacing.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>

#include "isobench/datasets/formats/tiff/tiff_file.h"

namespace isobench {

/// An axis of the pages.
enum class PageAxis { channel, slice, step };

struct TiffMetadata {
  /// How many places each axis has, by PageAxis.
  std::array<std::size_t, 3> sizes{1, 1, 1};
  /// The axes, the one whose places follow each other first.
  std::array<PageAxis, 3> order{PageAxis::channel, PageAxis::slice, PageAxis::step};
  /// mm along i, j, k; 0 where it is not stated.
  std::array<double, 3> spacing{0.0, 0.0, 0.0};
  std::string source;  ///< what stated them: "ImageJ", "OME" or "its resolution"; "" for none

  std::size_t pages() const { return sizes[0] * sizes[1] * sizes[2]; }
};

/// From the description and the resolution of the first page: ImageJ's lines, OME's XML, else resolution and its unit.
/// Without counts, `pages` slices. Throws DataError naming the file where they contradict each other.
TiffMetadata tiff_metadata(const TiffPage& first, std::size_t pages, const std::filesystem::path& path);

}  // namespace isobench
