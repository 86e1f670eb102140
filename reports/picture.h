// A picture of a results folder: a PNG file and what it shows.
#pragma once

#include <string>
#include <vector>

namespace isobench {

struct Picture {
  std::string file;     ///< in the results folder: "pictures/….png"
  std::string preview;  ///< the same as JPEG, for the page
  std::string group;    ///< pictures that are to be looked at side by side: one dataset, one camera
  std::string title;    ///< of this one within its group: the method
  std::string caption;
};

/// The pictures that are there, and sentences on what is missing and how to get it.
struct Pictures {
  std::vector<Picture> pictures;
  std::vector<std::string> missing;
};

}  // namespace isobench
