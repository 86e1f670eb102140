// NRRD, versions 1 to 5. The header is read here, because the reader of VTK 9.1 ignores the space directions and
// carries on if data are missing. The tests compare samples with VTK's.
#include "isobench/datasets/formats/nrrd/read_nrrd.h"

#include <utility>

#include "isobench/datasets/formats/nrrd/nrrd_axes.h"
#include "isobench/datasets/formats/nrrd/nrrd_data.h"
#include "isobench/datasets/formats/nrrd/nrrd_header.h"
#include "isobench/datasets/formats/nrrd/nrrd_segments.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

/// The size of the axis of components, which has the layers of a segmentation.
std::size_t layers_of(const std::vector<ArrayAxis>& axes) {
  long long layers = 1;
  for (const ArrayAxis& axis : axes) {
    if (axis.kind != AxisKind::space && axis.size > 1) layers = axis.size;
  }
  return static_cast<std::size_t>(layers);
}

/// Turns the choice of a segment into that of a place on the axis of layers.
std::optional<SegmentChoice> segment_in(NrrdHeader& header, std::vector<ArrayAxis>& axes, VolumeChoice& choice) {
  const std::size_t layers = layers_of(axes);
  const std::vector<NrrdSegment> segments = nrrd_segments(header, layers);
  if (segments.empty()) {
    if (choice.segment.empty()) return std::nullopt;
    throw DataError(header.path.string() + ": its header names no segments; leave out --segment");
  }
  if (choice.step || choice.component)
    throw DataError(header.path.string() +
                    ": it is a segmentation; choose with --segment in place of a step or component");
  for (ArrayAxis& axis : axes) {
    if (axis.kind == AxisKind::step) axis.kind = AxisKind::component;
  }
  const SegmentChoice segment = choose_segment(header, segments, layers, choice.segment);
  choice.component = segment.layer;
  return segment;
}

}  // namespace

VolumeFile read_nrrd(const std::filesystem::path& path, const VolumeChoice& choice) {
  ByteReader reader(path, Encoding::plain);
  NrrdHeader header = read_nrrd_header(reader);
  const NrrdSpace space = nrrd_space(header, nrrd_dimension(header));
  std::vector<ArrayAxis> axes = nrrd_axes(header, space);
  VolumeFile file;
  file.volume.lattice = nrrd_lattice(header, space, axes);
  VolumeChoice places_choice = choice;
  const std::optional<SegmentChoice> segment = segment_in(header, axes, places_choice);
  const std::vector<FileAxis> places = choose_places(axes, places_choice, path);
  const SampleType type = nrrd_type(header);
  const DataLayout layout = nrrd_layout(header, type);
  file.volume.samples = Samples(type);
  read_data_files(nrrd_files(header, reader.consumed(), axes), places, layout, file.volume.samples, header.notes);
  if (segment && segment->label) file.volume.samples = is_label(file.volume.samples, *segment->label);
  file.notes = std::move(header.notes);
  return file;
}

}  // namespace isobench
