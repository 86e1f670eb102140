// VTK's XML files (VTI and VTP; version 0.1 to 2.x of the format): text, base64 or appended raw data, plain or
// compressed with zlib, LZ4 or LZMA. Read here because VTK 9.1's own reader believes what a file says of itself: it
// allocates what a header promises and writes outside its arrays where extents or blocks do not agree.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace isobench {

struct VtkElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<VtkElement> children;
  std::string text;

  /// "" where there is none.
  std::string attribute(const std::string& key, const std::string& otherwise = "") const;
  /// The first child of this name; nullptr where there is none.
  const VtkElement* child(const std::string& child_name) const;
};

class VtkXmlFile {
 public:
  /// Throws DataError for what is no VTK XML file of this type, e.g. "ImageData".
  VtkXmlFile(std::filesystem::path path, const std::string& type);

  /// The element of the file's type.
  const VtkElement& data() const { return *data_; }
  /// A number of things, e.g. NumberOfPoints; 0 where the attribute is missing. Throws DataError unless it is a whole
  /// number from 0 to 2^40.
  std::size_t count(const VtkElement& element, const std::string& attribute) const;
  /// Whether a DataArray is of numbers at all.
  static bool is_numeric(const VtkElement& array);
  /// The numbers of a DataArray, as float or double. Throws DataError if it does not hold exactly `count` of them; what
  /// it can hold is checked before anything is allocated.
  template <class Number>
  std::vector<Number> numbers(const VtkElement& array, std::size_t count) const;
  /// DataError: "path: message".
  [[noreturn]] void fail(const std::string& message) const;

 private:
  void find_appended(std::string_view& xml);
  std::string bytes_of_array(const VtkElement& array, std::size_t bytes) const;

  std::filesystem::path path_;
  std::string bytes_;
  VtkElement root_;
  const VtkElement* data_ = nullptr;
  std::string_view appended_;  // from the byte after "_"
  bool appended_base64_ = false;
};

}  // namespace isobench
