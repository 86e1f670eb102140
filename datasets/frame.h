// The frame of coordinates: which way the world's axes point.
#pragma once

#include <string>

#include "isobench/datasets/volume.h"

namespace isobench {

enum class Frame {
  file,     ///< the world of the volume's file, whichever way its axes point
  lps,      ///< x to the patient's left, y to the back (posterior), z to the head (superior): DICOM, ITK, Slicer
  ras,      ///< x to the right, y to the front (anterior), z to the head: NIfTI, FreeSurfer
  lattice,  ///< along the lattice, with node (0, 0, 0) at the origin
};

std::string to_string(Frame frame);  ///< "file", "lps", "ras", "lattice"

/// The same lattice in coordinates of that frame. Throws UsageError for LPS and RAS if the file does not say which way
/// its world's axes point.
Lattice in_frame(Lattice lattice, Frame frame);

/// For a summary: "LPS (x to the left, y to the back, z to the head)".
std::string frame_text(const Lattice& lattice, Frame frame);

}  // namespace isobench
