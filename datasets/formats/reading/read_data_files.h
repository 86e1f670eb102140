// Reading the samples of a volume from the file or the files that its header names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/data_files.h"
#include "isobench/datasets/formats/reading/read_samples.h"

namespace isobench {

/// How the samples lie in each of the files.
struct DataLayout {
  ByteOrder order = ByteOrder::little;
  Encoding encoding = Encoding::plain;
  bool is_text = false;          ///< numbers as text
  std::uintmax_t lines = 0;      ///< to skip in the file as it is on disk
  std::uintmax_t packed = 0;     ///< bytes to skip after them, of the file as it is on disk
  std::uintmax_t unpacked = 0;   ///< bytes to skip after them, of what the encoding gives
  bool is_at_end = false;        ///< the samples are the last of the unpacked bytes, but for `after`
  std::uintmax_t after = 0;      ///< bytes that follow the samples if `is_at_end`
  bool begin_is_stated = false;  ///< the header says where the samples begin
  std::string at_begin;          ///< what the header would say if they were the first bytes, e.g. "byte skip: 0"
  std::string at_end;            ///< or the last
};

/// The files and how the array is divided among them.
struct VolumeData {
  std::filesystem::path header;
  bool is_attached = false;  ///< the samples are in the header's file
  std::vector<DataFile> files;
  std::size_t axes_in_each = 1;  ///< see FileParts
};

/// Appends the samples at the chosen places, and adds a note if a file has bytes that are not samples. Files of steps
/// that are not chosen are not read. Throws DataError as read_samples() does, and if a file of its own has more bytes
/// than samples and the header does not say where they begin. Precondition: check_parts().
void read_data_files(const VolumeData& data, std::span<const FileAxis> axes, const DataLayout& layout, Samples& samples,
                     std::vector<std::string>& notes);

}  // namespace isobench
