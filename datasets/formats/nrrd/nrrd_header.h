// The header of an NRRD file: its fields and its key:=value pairs, by http://teem.sourceforge.net/nrrd/format.html.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "isobench/datasets/formats/reading/byte_reader.h"
#include "isobench/foundation/error.h"

namespace isobench {

struct NrrdHeader {
  std::filesystem::path path;
  std::map<std::string, std::string> fields;  ///< by the format's name in lower case without blanks: "spacedirections"
  std::map<std::string, std::string> pairs;   ///< key:=value, as written
  std::vector<std::string> list;              ///< the names that follow "data file: LIST"
  std::vector<std::string> notes;

  bool has(const std::string& key) const { return fields.contains(key); }
  std::string text(const std::string& key) const { return has(key) ? fields.at(key) : std::string(); }
  /// Throws DataError unless the field has exactly `count` numbers.
  std::vector<double> numbers(const std::string& key, std::size_t count) const;
  double number(const std::string& key, double otherwise) const;
  /// The words of a field, for example of `kinds`, or its texts in quotation marks, for example of `units`; none if the
  /// field is missing. Throws DataError unless there are exactly `count`.
  std::vector<std::string> words(const std::string& key, std::size_t count) const;
  /// Adds a note, made printable() because it may quote the file.
  void note(const std::string& sentence) { notes.push_back(printable(path.string() + ": " + sentence)); }
};

/// Reads the header up to the empty line that ends it, or to the list of data files and its end. Throws DataError
/// naming the file if it is not one of NRRD, if a line is not of the header's form, or if a field that every header has
/// is missing or a field stands there twice.
NrrdHeader read_nrrd_header(ByteReader& reader);

}  // namespace isobench
