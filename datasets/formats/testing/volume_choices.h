// For tests: choices of one kind.
#pragma once

#include <string>

#include "isobench/datasets/formats/reading/volume_file.h"

namespace isobench {

inline VolumeChoice choose_step(std::size_t step) {
  VolumeChoice choice;
  choice.step = step;
  return choice;
}

inline VolumeChoice choose_component(std::size_t component) {
  VolumeChoice choice;
  choice.component = component;
  return choice;
}

inline VolumeChoice choose_series_named(const std::string& series) {
  VolumeChoice choice;
  choice.series = series;
  return choice;
}

}  // namespace isobench
