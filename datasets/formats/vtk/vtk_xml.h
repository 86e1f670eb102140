// VTK's XML files (VTI and VTP; version 0.1 to 2.x of the format): text, base64 or appended raw data, plain or
// compressed with zlib, LZ4 or LZMA. The reader of VTK 9.1 does not check a file: it takes as much memory as a header
// states, and writes outside its arrays if extents or blocks do not agree.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "isobench/datasets/formats/reading/byte_order.h"
#include "isobench/datasets/samples.h"

namespace isobench {

struct VtkElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<VtkElement> children;
  std::string text;

  /// `otherwise` if there is no such attribute.
  std::string attribute(const std::string& key, const std::string& otherwise = "") const;
  /// The first child of this name; nullptr if there is none.
  const VtkElement* child(const std::string& child_name) const;
};

class VtkXmlFile {
 public:
  /// Reads the whole file. Throws DataError if it is not a VTK XML file of this type, e.g. "ImageData".
  VtkXmlFile(std::filesystem::path path, const std::string& type);

  /// The element that the file's type names.
  const VtkElement& data() const { return *data_; }
  /// An attribute that counts, e.g. NumberOfPoints; 0 if it is missing. Throws DataError unless it is a whole number
  /// from 0 to 2^40.
  std::size_t count(const VtkElement& element, const std::string& attribute) const;
  /// True if a DataArray holds numbers.
  static bool is_numeric(const VtkElement& array);
  /// The numbers of a DataArray in their own type. Throws DataError if the array does not hold exactly `count` of them.
  /// It compares `count` with what the file can hold before it takes memory.
  Samples samples(const VtkElement& array, std::size_t count) const;
  /// The same as double.
  std::vector<double> numbers(const VtkElement& array, std::size_t count) const;
  /// Throws DataError "path: message".
  [[noreturn]] void fail(const std::string& message) const;

 private:
  void find_appended(std::string_view& xml);
  std::string bytes_of_array(const VtkElement& array, std::size_t bytes) const;
  SampleType type_of_array(const VtkElement& array) const;
  Samples text_samples(const VtkElement& array, std::size_t count, SampleType type) const;
  ByteOrder order() const;

  std::filesystem::path path_;
  std::string bytes_;
  VtkElement root_;
  const VtkElement* data_ = nullptr;
  std::string_view appended_;  // begins at the byte after "_"
  bool appended_base64_ = false;
};

}  // namespace isobench
