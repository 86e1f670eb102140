// Decoding of compressed frames by GDCM, in a process of its own.
//
// Debian compiles GDCM with its assertions, and its decoders were not written for hostile data: damaged data can end
// the process that decodes them, or worse. So a copy of this process decodes, and this one only gets bytes from it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "isobench/datasets/formats/dicom/dicom_image.h"
#include "isobench/foundation/processes/descriptor.h"

namespace isobench {

/// Whether GDCM decodes this transfer syntax, which must be one with encapsulated pixels.
bool can_decode(const std::string& transfer_syntax);

/// What a transfer syntax is called, e.g. "JPEG 2000", or its UID.
std::string transfer_syntax_name(const std::string& transfer_syntax);

class DecoderProcess {
 public:
  /// Starts the process. Throws DataError naming the image's file if the system does not let it.
  explicit DecoderProcess(const DicomImage& image);
  /// Ends it.
  ~DecoderProcess();
  DecoderProcess(const DecoderProcess&) = delete;
  DecoderProcess& operator=(const DecoderProcess&) = delete;

  /// Decodes one frame into image.layout.frame_bytes() bytes, in this machine's order. False if the data are damaged;
  /// the process has ended then. Precondition: the data state the frame's size (check_frame_header()).
  bool decode(std::string_view data, std::span<char> samples);

 private:
  Descriptor socket_;
  int pid_ = -1;
};

}  // namespace isobench
