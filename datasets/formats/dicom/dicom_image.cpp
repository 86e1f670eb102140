#include "isobench/datasets/formats/dicom/dicom_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

constexpr long long most_frames = 1LL << 17;

/// The values of elements. A DataError names the file and the element.
class DicomValues {
 public:
  DicomValues(const std::filesystem::path& path, ByteOrder order) : path_(path), order_(order) {}

  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_.string() + ": " + what); }

  std::string text(const DicomItem& item, DicomTag tag) const {
    const DicomElement* element = item.find(tag);
    if (element == nullptr) return {};
    return trimmed(element->bytes.substr(0, element->bytes.find('\0')));
  }

  /// Numbers that are written as text; none if the element is missing or empty.
  std::vector<double> numbers(const DicomItem& item, DicomTag tag, const char* name) const {
    std::string plain = text(item, tag);
    std::replace(plain.begin(), plain.end(), '\\', ' ');
    std::vector<double> values = all_numbers_in(plain, path_, name);
    for (const double value : values) {
      if (!std::isfinite(value)) fail(fmt::format("damaged: '{}' is not finite; export it again", name));
    }
    return values;
  }

  std::optional<double> number(const DicomItem& item, DicomTag tag, const char* name) const {
    const std::vector<double> values = numbers(item, tag, name);
    return values.empty() ? std::nullopt : std::optional(values.front());
  }

  template <class Number>
  std::optional<Number> binary(const DicomItem& item, DicomTag tag) const {
    const DicomElement* element = item.find(tag);
    if (element == nullptr || element->bytes.size() < sizeof(Number)) return std::nullopt;
    return number_at<Number>(element->bytes.data(), order_);
  }

  int whole(const DicomItem& item, DicomTag tag, int otherwise) const {
    return binary<std::uint16_t>(item, tag).value_or(static_cast<std::uint16_t>(otherwise));
  }

 private:
  const std::filesystem::path& path_;
  ByteOrder order_;
};

/// Why samples of this layout cannot be read; "" if they can be.
std::string problem_of(const DicomLayout& layout) {
  if (layout.rows == 0 || layout.columns == 0)
    return "damaged: its header states no rows or no columns; export it again";
  if (layout.components < 1 || layout.components > 4)
    return fmt::format("damaged: its header states {} samples a pixel; export it again", layout.components);
  if (layout.allocated == 1)
    return "a segmentation of 1 bit a sample, as DICOM stores it; convert it to NRRD or NIfTI, e.g. by dcmqi";
  if (layout.allocated != 8 && layout.allocated != 16 && layout.allocated != 32 && !layout.is_real)
    return fmt::format("its samples take {} bits; convert them to 8, 16 or 32 bits, or export them again",
                       layout.allocated);
  if (layout.stored < 1 || layout.stored > layout.allocated || layout.high >= layout.allocated ||
      layout.high + 1 < layout.stored) {
    return fmt::format("damaged: bits {} to {} of {} cannot hold a sample; correct its header or export it again",
                       layout.high + 1 - layout.stored, layout.high, layout.allocated);
  }
  return "";
}

DicomLayout layout_of(const DicomItem& data, const DicomPixels& pixels, const DicomValues& values) {
  DicomLayout layout;
  layout.rows = values.whole(data, DicomTag::rows, 0);
  layout.columns = values.whole(data, DicomTag::columns, 0);
  layout.components = values.whole(data, DicomTag::samples_per_pixel, 1);
  layout.is_planar = layout.components > 1 && values.whole(data, DicomTag::planar_configuration, 0) == 1;
  layout.is_real = pixels.tag != DicomTag::pixels;
  if (layout.is_real) {
    layout.allocated = pixels.tag == DicomTag::float_pixels ? 32 : 64;
    layout.stored = layout.allocated;
    layout.high = layout.allocated - 1;
  } else {
    layout.allocated = values.whole(data, DicomTag::bits_allocated, 0);
    layout.stored = values.whole(data, DicomTag::bits_stored, layout.allocated);
    layout.high = values.whole(data, DicomTag::high_bit, layout.stored - 1);
    layout.is_signed = values.whole(data, DicomTag::pixel_representation, 0) == 1;
  }
  return layout;
}

/// Values of a frame: from the items of functional groups that hold them, or from the file itself.
class FrameReader {
 public:
  FrameReader(const DicomItem& data, const DicomValues& values) : data_(data), values_(values) {}

  /// `own` is the frame's item among those of all frames, or nullptr.
  DicomFrame read(const DicomItem* own) const {
    DicomFrame frame;
    frame.position = position(item_with(own, DicomTag::plane_position, DicomTag::image_position));
    frame.axes = axes(item_with(own, DicomTag::plane_orientation, DicomTag::image_orientation));
    read_spacing(frame, own);
    frame.location = values_.number(data_, DicomTag::slice_location, "SliceLocation");
    read_rescaling(frame, item_with(own, DicomTag::pixel_value_transformation, DicomTag::rescale_slope));
    read_phases(frame, own);
    return frame;
  }

 private:
  /// The item with the element `tag`: in the sequence `group` of the frame or of all frames, else the file's own.
  const DicomItem& item_with(const DicomItem* own, DicomTag group, DicomTag tag) const {
    for (const DicomItem* groups : {own, data_.first_item(DicomTag::shared_groups)}) {
      const DicomItem* item = groups == nullptr ? nullptr : groups->first_item(group);
      if (item != nullptr && item->find(tag) != nullptr) return *item;
    }
    // Nuclear medicine keeps them with the detector.
    const DicomItem* detector = data_.first_item(DicomTag::detector_information);
    const bool is_detectors = data_.find(tag) == nullptr && detector != nullptr && detector->find(tag) != nullptr;
    return is_detectors ? *detector : data_;
  }

  std::optional<Eigen::Vector3d> position(const DicomItem& item) const {
    const std::vector<double> at = values_.numbers(item, DicomTag::image_position, "ImagePositionPatient");
    if (at.empty()) return std::nullopt;
    if (at.size() != 3) values_.fail("damaged: its ImagePositionPatient does not have 3 numbers; export it again");
    return Eigen::Vector3d(at.data());
  }

  std::optional<Eigen::Matrix<double, 3, 2>> axes(const DicomItem& item) const {
    const std::vector<double> cosines = values_.numbers(item, DicomTag::image_orientation, "ImageOrientationPatient");
    if (cosines.empty()) return std::nullopt;
    Eigen::Matrix<double, 3, 2> axes = Eigen::Matrix<double, 3, 2>::Zero();
    if (cosines.size() == 6) axes = Eigen::Map<const Eigen::Matrix<double, 3, 2>>(cosines.data());
    // Files have as few as three decimals.
    constexpr double most_error = 0.02;
    if (!(std::abs(axes.col(0).norm() - 1.0) < most_error && std::abs(axes.col(1).norm() - 1.0) < most_error &&
          std::abs(axes.col(0).dot(axes.col(1))) < most_error)) {
      values_.fail("damaged: its ImageOrientationPatient is not two perpendicular directions; export it again");
    }
    axes.colwise().normalize();
    return axes;
  }

  void read_spacing(DicomFrame& frame, const DicomItem* own) const {
    const DicomItem& item = item_with(own, DicomTag::pixel_measures, DicomTag::pixel_spacing);
    std::vector<double> spacing = values_.numbers(item, DicomTag::pixel_spacing, "PixelSpacing");
    frame.spacing_source = SpacingSource::pixel_spacing;
    if (spacing.empty()) {
      spacing = values_.numbers(data_, DicomTag::imager_pixel_spacing, "ImagerPixelSpacing");
      frame.spacing_source = spacing.empty() ? SpacingSource::none : SpacingSource::imager;
    }
    const auto positive = [](double value) { return value > 0.0; };
    if (!spacing.empty()) {
      if (spacing.size() != 2 || !std::all_of(spacing.begin(), spacing.end(), positive))
        values_.fail("damaged: its PixelSpacing is not two numbers above 0; correct its header or export it again");
      // The file states the distance of the rows first: the spacing along a column.
      frame.spacing = {spacing[1], spacing[0]};
    }
    const auto length = [&](DicomTag tag, const char* name) -> std::optional<double> {
      const std::optional<double> value = values_.number(item_with(own, DicomTag::pixel_measures, tag), tag, name);
      if (!value || *value == 0.0) return std::nullopt;
      return std::abs(*value);  // nuclear medicine states a negative one for slices that are stored backwards
    };
    frame.distance = length(DicomTag::spacing_between_slices, "SpacingBetweenSlices");
    frame.thickness = length(DicomTag::slice_thickness, "SliceThickness");
  }

  void read_rescaling(DicomFrame& frame, const DicomItem& item) const {
    frame.slope = values_.number(item, DicomTag::rescale_slope, "RescaleSlope").value_or(1.0);
    frame.intercept = values_.number(item, DicomTag::rescale_intercept, "RescaleIntercept").value_or(0.0);
    const std::optional<double> dose = values_.number(data_, DicomTag::dose_grid_scaling, "DoseGridScaling");
    if (dose) frame.slope = *dose;
    if (frame.slope == 0.0) values_.fail("damaged: its RescaleSlope is 0; correct its header or export it again");
  }

  void read_phases(DicomFrame& frame, const DicomItem* own) const {
    const auto add = [&](const char* name, const std::optional<double>& value) {
      if (value) frame.phases[name] = *value;
    };
    const auto add_text = [&](DicomTag tag, const char* name) {
      // A time of the day, HHMMSS.FFFFFF, is a number, too; one that is not, is no help.
      const std::string text = values_.text(data_, tag);
      const bool is_number = !text.empty() && text.find_first_not_of("0123456789.+-eE") == std::string::npos;
      if (is_number) add(name, values_.number(data_, tag, name));
    };
    const DicomItem* content = own == nullptr ? nullptr : own->first_item(DicomTag::frame_content);
    if (content != nullptr) {
      const auto index = values_.binary<std::uint32_t>(*content, DicomTag::temporal_position_index);
      if (index) add("TemporalPositionIndex", *index);
    }
    add_text(DicomTag::temporal_position, "TemporalPositionIdentifier");
    add_text(DicomTag::trigger_time, "TriggerTime");
    add_text(DicomTag::echo_time, "EchoTime");
    add("DiffusionBValue", values_.binary<double>(data_, DicomTag::b_value));
    add_text(DicomTag::acquisition_number, "AcquisitionNumber");
    add_text(DicomTag::acquisition_date_time, "AcquisitionDateTime");
    add_text(DicomTag::acquisition_time, "AcquisitionTime");
    add_text(DicomTag::instance_number, "InstanceNumber");
  }

  const DicomItem& data_;
  const DicomValues& values_;
};

/// How many frames the file has; never more than its bytes can hold. Notes a problem and returns 1 if they cannot.
std::size_t count_frames(const DicomItem& data, DicomImage& image, const DicomValues& values) {
  const double stated = values.number(data, DicomTag::number_of_frames, "NumberOfFrames").value_or(1.0);
  const long long frames = size_in(stated);
  const std::uintmax_t least = image.pixels.is_encapsulated ? 8 : image.layout.frame_bytes();
  if (!image.problem.empty()) return 1;
  if (frames == 0 || frames > most_frames) {
    image.problem = fmt::format("damaged: {} frames are not a DICOM image; export it again", stated);
  } else if (image.pixels.length / least < static_cast<std::uintmax_t>(frames)) {
    image.problem = fmt::format(
        "truncated: its header states {} frame{} of {} × {} samples, but at most {} bytes of them follow; copy or "
        "export "
        "it again",
        frames, frames == 1 ? "" : "s", image.layout.columns, image.layout.rows, image.pixels.length);
  }
  return image.problem.empty() ? static_cast<std::size_t>(frames) : 1;
}

std::vector<DicomFrame> frames_of(const DicomItem& data, std::size_t count, const DicomValues& values) {
  const DicomElement* groups = data.find(DicomTag::per_frame_groups);
  if (groups != nullptr && groups->items.size() < count) {
    values.fail(fmt::format("damaged: it has {} frames, but says where {} of them lie; export it again", count,
                            groups->items.size()));
  }
  const FrameReader reader(data, values);
  if (groups == nullptr) {
    std::vector<DicomFrame> frames(count, reader.read(nullptr));
    for (std::size_t n = 0; n < count; ++n) frames[n].number = n;
    return frames;
  }
  std::vector<DicomFrame> frames;
  for (std::size_t n = 0; n < count; ++n) {
    frames.push_back(reader.read(&groups->items[n]));
    frames.back().number = n;
  }
  return frames;
}

/// Frames of a file that states only where the first one lies.
void spread_frames(std::vector<DicomFrame>& frames, const DicomItem& data, const DicomValues& values) {
  const std::vector<double> offsets = values.numbers(data, DicomTag::grid_frame_offsets, "GridFrameOffsetVector");
  const DicomFrame first = frames.front();
  const std::optional<double> distance = first.distance ? first.distance : first.thickness;
  const bool has_offsets = offsets.size() == frames.size();
  if (!has_offsets && !distance) {
    values.fail(
        "its frames state no positions, and no distance between them; convert it to NRRD or NIfTI with the distance");
  }
  const Eigen::Matrix<double, 3, 2> axes = first.axes.value_or(Eigen::Matrix<double, 3, 2>::Identity());
  const Eigen::Vector3d normal = Eigen::Vector3d(axes.col(0)).cross(Eigen::Vector3d(axes.col(1)));
  for (std::size_t n = 0; n < frames.size(); ++n) {
    // The offsets of a dose may be relative to the first frame, or coordinates.
    const double along = has_offsets ? offsets[n] - offsets.front() : static_cast<double>(n) * *distance;
    frames[n].position = first.position.value_or(Eigen::Vector3d::Zero()) + along * normal;
  }
}

}  // namespace

std::optional<DicomImage> read_dicom_image(const std::filesystem::path& path) {
  const DicomElements elements = read_dicom_elements(path);
  if (!elements.pixels) return std::nullopt;
  const DicomItem& data = elements.data;
  const DicomValues values(path, elements.order);
  DicomImage image;
  image.path = path;
  image.transfer_syntax = elements.transfer_syntax;
  image.order = elements.order;
  image.is_deflated = elements.is_deflated;
  image.pixels = *elements.pixels;
  image.layout = layout_of(data, image.pixels, values);
  image.problem = problem_of(image.layout);
  image.photometric = values.text(data, DicomTag::photometric_interpretation);
  image.has_padding = data.find(DicomTag::pixel_padding_value) != nullptr;
  image.instance = values.text(data, DicomTag::sop_instance_uid);
  image.series = values.text(data, DicomTag::series_instance_uid);
  image.image_type = values.text(data, DicomTag::image_type);
  image.number = values.text(data, DicomTag::series_number);
  image.description = values.text(data, DicomTag::series_description);
  image.frames = frames_of(data, count_frames(data, image, values), values);
  const bool states_positions = data.find(DicomTag::per_frame_groups) != nullptr && image.frames.front().position;
  if (image.frames.size() > 1 && !states_positions) spread_frames(image.frames, data, values);
  return image;
}

}  // namespace isobench
