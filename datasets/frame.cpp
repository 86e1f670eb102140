#include "isobench/datasets/frame.h"

#include <fmt/format.h>

#include "isobench/foundation/error.h"

namespace isobench {

std::string to_string(Frame frame) {
  static constexpr const char* names[] = {"file", "lps", "ras", "lattice"};
  return names[static_cast<std::size_t>(frame)];
}

Lattice in_frame(Lattice lattice, Frame frame) {
  if (frame == Frame::file) return lattice;
  if (frame == Frame::lattice) {
    lattice.origin.setZero();
    lattice.direction.setIdentity();
    lattice.space.clear();
    return lattice;
  }
  const std::string space = frame == Frame::lps ? "LPS" : "RAS";
  if (lattice.space.empty()) {
    throw UsageError(fmt::format(
        "--frame {}: the volume's file does not say which way its axes point; leave it out, or give --frame lattice",
        to_string(frame)));
  }
  if (lattice.space != space) {
    // Left and right, front and back change sides: half a turn about z.
    lattice.direction.topRows<2>() *= -1.0;
    lattice.origin.head<2>() *= -1.0;
    lattice.space = space;
  }
  return lattice;
}

std::string frame_text(const Lattice& lattice, Frame frame) {
  if (frame == Frame::lattice) return "lattice (along its axes, the first node at the origin)";
  if (lattice.space == "LPS") return "LPS (x to the left, y to the back, z to the head)";
  if (lattice.space == "RAS") return "RAS (x to the right, y to the front, z to the head)";
  return "the file's, which does not say which way its axes point";
}

}  // namespace isobench
