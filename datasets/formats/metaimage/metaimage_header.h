// The header of a MetaImage file: lines `key = value`, by https://itk.org/Wiki/MetaIO/Documentation.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_reader.h"
#include "isobench/foundation/error.h"

namespace isobench {

struct MetaImageHeader {
  std::filesystem::path path;
  std::map<std::string, std::string> fields;  ///< by key in lower case
  std::vector<std::string> list;              ///< the names that follow "ElementDataFile = LIST"
  std::vector<std::string> notes;

  bool has(const char* key) const;
  /// The value of the first of the keys that the header has; `otherwise` if it has none.
  std::string text(std::initializer_list<const char*> keys, const std::string& otherwise) const;
  /// Throws DataError unless the value is True or False, T or F, 1 or 0.
  bool flag(std::initializer_list<const char*> keys, bool otherwise) const;
  /// Throws DataError unless the value has exactly `count` numbers.
  std::vector<double> numbers(std::initializer_list<const char*> keys, std::size_t count,
                              const std::vector<double>& otherwise) const;
  /// Adds a note, made printable() because it may quote the file.
  void note(const std::string& sentence) { notes.push_back(printable(path.string() + ": " + sentence)); }
};

/// Reads the header up to the line of ElementDataFile, which is the last by definition, or to the list that follows it.
/// Throws DataError naming the file if it is not one of MetaImage, or has no such line.
MetaImageHeader read_metaimage_header(ByteReader& reader);

}  // namespace isobench
