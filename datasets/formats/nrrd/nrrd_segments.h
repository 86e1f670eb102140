// Segmentations as 3D Slicer writes them (.seg.nrrd): labels, whose names are in the header. Segments that overlap lie
// in several layers, places on an axis of the array; https://slicer.readthedocs.io, "Segmentations", "Segmentation file
// format".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/nrrd/nrrd_header.h"
#include "isobench/datasets/samples.h"

namespace isobench {

struct NrrdSegment {
  std::string name;
  std::string id;
  double label = 1.0;
  std::size_t layer = 0;
};

/// What is read of a segmentation.
struct SegmentChoice {
  std::size_t layer = 0;
  std::optional<double> label;  ///< of the one segment that is wanted; without it, all labels of the layer
};

/// The segments that the header names in its pairs; none for other volumes. `layers` is the size of the axis of layers.
std::vector<NrrdSegment> nrrd_segments(const NrrdHeader& header, std::size_t layers);

/// Finds the segment that `choice` means: by its name, its ID or its label, or "layer N" for all labels of a layer.
/// Without a choice it is the only layer; a note then names the segments. Throws DataError that names all segments if
/// there are several layers, or if no or several segments are meant.
SegmentChoice choose_segment(NrrdHeader& header, const std::vector<NrrdSegment>& segments, std::size_t layers,
                             const std::string& choice);

/// 1 where a sample is the label, 0 elsewhere.
Samples is_label(const Samples& samples, double label);

}  // namespace isobench
