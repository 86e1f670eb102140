// The elements of a DICOM file, up to its pixels (DICOM PS3.5, sections 7 and 10; PS3.10, section 7).
//
// This is our own code and not GDCM's, because Debian compiles GDCM with its assertions: a damaged header ends the
// whole program there (its two libraries for headers have about 4,900 of them).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_order.h"

namespace isobench {

/// The elements that are kept of a file: group in the upper 16 bits, element in the lower ones.
enum class DicomTag : std::uint32_t {
  transfer_syntax = 0x00020010,
  image_type = 0x00080008,
  sop_instance_uid = 0x00080018,
  acquisition_date_time = 0x0008002A,
  acquisition_time = 0x00080032,
  series_description = 0x0008103E,
  slice_thickness = 0x00180050,
  echo_time = 0x00180081,
  spacing_between_slices = 0x00180088,
  trigger_time = 0x00181060,
  imager_pixel_spacing = 0x00181164,
  b_value = 0x00189087,
  series_instance_uid = 0x0020000E,
  series_number = 0x00200011,
  acquisition_number = 0x00200012,
  instance_number = 0x00200013,
  image_position = 0x00200032,
  image_orientation = 0x00200037,
  temporal_position = 0x00200100,
  slice_location = 0x00201041,
  frame_content = 0x00209111,
  plane_position = 0x00209113,
  plane_orientation = 0x00209116,
  temporal_position_index = 0x00209128,
  samples_per_pixel = 0x00280002,
  photometric_interpretation = 0x00280004,
  planar_configuration = 0x00280006,
  number_of_frames = 0x00280008,
  rows = 0x00280010,
  columns = 0x00280011,
  pixel_spacing = 0x00280030,
  bits_allocated = 0x00280100,
  bits_stored = 0x00280101,
  high_bit = 0x00280102,
  pixel_representation = 0x00280103,
  pixel_padding_value = 0x00280120,
  rescale_intercept = 0x00281052,
  rescale_slope = 0x00281053,
  pixel_measures = 0x00289110,
  pixel_value_transformation = 0x00289145,
  detector_information = 0x00540022,
  grid_frame_offsets = 0x3004000C,
  dose_grid_scaling = 0x3004000E,
  shared_groups = 0x52009229,
  per_frame_groups = 0x52009230,
  float_pixels = 0x7FE00008,
  double_pixels = 0x7FE00009,
  pixels = 0x7FE00010,
};

struct DicomElement;

/// A list of elements: of a file, or of an item of a sequence.
struct DicomItem {
  std::vector<DicomElement> elements;

  /// nullptr if there is none.
  const DicomElement* find(DicomTag tag) const;
  /// The first item of the sequence `tag`; nullptr if there is none.
  const DicomItem* first_item(DicomTag tag) const;
};

struct DicomElement {
  DicomTag tag = DicomTag::pixels;
  std::string bytes;             ///< as in the file
  std::vector<DicomItem> items;  ///< of a sequence
};

/// Where the pixels are.
struct DicomPixels {
  DicomTag tag = DicomTag::pixels;  ///< pixels, float_pixels or double_pixels
  std::uintmax_t offset = 0;        ///< of the first byte of the value, as DicomSource counts
  std::uintmax_t length = 0;        ///< bytes; of encapsulated pixels all that follows in the file
  bool is_encapsulated = false;
  bool is_in_words = false;  ///< samples of one byte are stored as words of two
};

struct DicomElements {
  DicomItem data;
  std::string transfer_syntax;
  ByteOrder order = ByteOrder::little;  ///< of the numbers among the elements, and of the pixels
  bool is_deflated = false;
  std::optional<DicomPixels> pixels;
};

/// Whether the file begins as a DICOM file does: with "DICM" after 128 bytes, or, as old ones do, with the elements of
/// group 8. Folders and files that cannot be read do not.
bool is_dicom_file(const std::filesystem::path& path);

/// Reads the elements named by DicomTag, and none of more than 64 KiB. Throws DataError naming the file if it is not a
/// DICOM file, if it is truncated before its pixels, or if elements do not fit into what holds them. Takes memory in
/// proportion to the bytes that it has read.
DicomElements read_dicom_elements(const std::filesystem::path& path);

}  // namespace isobench
