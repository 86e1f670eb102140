// For tests: headers of MRC and CCP4 maps.
#pragma once

#include <string>

#include "isobench/datasets/formats/testing/oblique_files.h"

namespace isobench {

/// A header of 1024 bytes for the samples of oblique_files.h. The cell has the spacing of that volume in Å, and its
/// axes are perpendicular: this format cannot turn a volume.
class MrcFileHeader {
 public:
  explicit MrcFileHeader(int mode = 2, bool swapped = false) : bytes_(1024, '\0'), swapped_(swapped) {
    const int sizes[] = {nx, ny, nz, mode};
    for (std::size_t n = 0; n < 4; ++n) put(4 * n, sizes[n]);
    for (int n = 0; n < 3; ++n) {
      const std::size_t at = 4 * static_cast<std::size_t>(n);
      put(28 + at, 10 * (n + 1));  // the cell is larger than what the file has of it
      put(40 + at, static_cast<float>(10 * (n + 1) * spacing[n]));
      put(52 + at, 90.0F);
      put(64 + at, n + 1);
    }
    put(88, 1);
    put(108, 20140);
    bytes_.replace(208, 4, "MAP ");
    bytes_.replace(212, 4, swapped ? std::string("\x11\x11\0\0", 4) : std::string("\x44\x44\0\0", 4));
  }
  template <class Value>
  MrcFileHeader& put(std::size_t at, Value value) {
    bytes_.replace(at, sizeof value, bytes_of_value(value, swapped_));
    return *this;
  }
  template <class Value>
  MrcFileHeader& put_three(std::size_t at, Value first, Value second, Value third) {
    return put(at, first).put(at + 4, second).put(at + 8, third);
  }
  /// Without the number and the mark of the standard of 2014.
  MrcFileHeader& make_old() {
    bytes_.replace(208, 8, 8, '\0');
    return put(108, 0);
  }
  MrcFileHeader& mark_as_imod(int flags) { return put(152, 1146047817).put(156, flags); }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  bool swapped_;
};

}  // namespace isobench
