// What to do with a surface that is not as meshes can show it, or that has more than they should.
#pragma once

namespace isobench {

/// See settle_surface.h.
struct SurfaceChoices {
  bool exact_isovalue = false;  ///< refuse an isovalue that is no regular value of F, instead of moving it
  double min_component = 0.0;   ///< mm³: islands and cavities that enclose less are left out
};

}  // namespace isobench
