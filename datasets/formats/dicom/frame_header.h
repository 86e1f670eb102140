// The headers of compressed frames: what they say must be what the DICOM file says, before a decoder takes memory.
#pragma once

#include <string>
#include <string_view>

#include "isobench/datasets/formats/dicom/dicom_image.h"

namespace isobench {

/// Returns "" if the data begin as a frame of the image's layout does in its transfer syntax (RLE, JPEG, JPEG-LS or
/// JPEG 2000), otherwise what is wrong with them.
std::string check_frame_header(std::string_view data, const DicomImage& image);

}  // namespace isobench
