// What a DICOM file says of its image: how the samples are stored, and where each frame lies in the patient.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/dicom/dicom_elements.h"

namespace isobench {

/// How samples are stored.
struct DicomLayout {
  long long rows = 0;
  long long columns = 0;
  int components = 1;
  bool is_planar = false;  ///< all of the first component come first
  int allocated = 16;      ///< bits that a sample takes
  int stored = 16;         ///< bits of them that hold its value
  int high = 15;           ///< the highest of these
  bool is_signed = false;
  bool is_real = false;  ///< floating-point numbers of `allocated` bits

  bool operator==(const DicomLayout&) const = default;
  std::uintmax_t frame_bytes() const {
    return static_cast<std::uintmax_t>(rows) * static_cast<std::uintmax_t>(columns) *
           static_cast<std::uintmax_t>(components) * static_cast<std::uintmax_t>(allocated / 8);
  }
};

/// Where the spacing within a slice comes from.
enum class SpacingSource { pixel_spacing, imager, none };

/// One slice.
struct DicomFrame {
  std::size_t number = 0;                             ///< within its file, from 0
  std::optional<Eigen::Vector3d> position;            ///< mm, of its first sample
  std::optional<Eigen::Matrix<double, 3, 2>> axes;    ///< directions along a row and along a column
  Eigen::Vector2d spacing = Eigen::Vector2d::Ones();  ///< mm, along a row and along a column
  SpacingSource spacing_source = SpacingSource::none;
  std::optional<double> location;   ///< mm along an axis that the file does not state
  std::optional<double> distance;   ///< mm between slices, as stated
  std::optional<double> thickness;  ///< mm
  double slope = 1.0;
  double intercept = 0.0;
  /// What may tell phases at the same place apart, by the names that the standard gives.
  std::map<std::string, double> phases;
};

struct DicomImage {
  std::filesystem::path path;
  std::string transfer_syntax;
  ByteOrder order = ByteOrder::little;
  bool is_deflated = false;
  DicomPixels pixels;
  DicomLayout layout;
  std::string photometric;  ///< "MONOCHROME2", "RGB" and so on
  bool has_padding = false;
  std::string instance;  ///< UID of the image
  std::string series;    ///< UID
  std::string image_type;
  std::string number;  ///< of the series
  std::string description;
  std::vector<DicomFrame> frames;
  /// Why its samples cannot be read; "" if they can be. It matters only where the image is wanted, not for a neighbour.
  std::string problem;
};

/// Reads what a file says of its image; std::nullopt if it is a DICOM file without an image. Throws DataError naming
/// the file if its header is damaged.
std::optional<DicomImage> read_dicom_image(const std::filesystem::path& path);

}  // namespace isobench
