#include "isobench/datasets/formats/metaimage/metaimage_header.h"

#include <fmt/format.h>

#include <algorithm>

#include "isobench/datasets/formats/reading/data_files.h"
#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

/// The keys whose values matter here. Files may have any others; one that resembles these is most likely misspelt.
const std::vector<std::string>& used_keys() {
  static const std::vector<std::string> keys = {"NDims",
                                                "DimSize",
                                                "ElementType",
                                                "ElementSpacing",
                                                "ElementSize",
                                                "ElementNumberOfChannels",
                                                "ElementByteOrderMSB",
                                                "ElementDataFile",
                                                "BinaryData",
                                                "BinaryDataByteOrderMSB",
                                                "CompressedData",
                                                "HeaderSize",
                                                "TransformMatrix",
                                                "Orientation",
                                                "Rotation",
                                                "Offset",
                                                "Position",
                                                "Origin",
                                                "DistanceUnits",
                                                "AnatomicalOrientation",
                                                "ElementToIntensityFunctionSlope",
                                                "ElementToIntensityFunctionOffset"};
  return keys;
}

/// Keys that the format has besides, some of which resemble the others.
const std::vector<std::string>& ignored_keys() {
  static const std::vector<std::string> keys = {"objecttype",
                                                "objectsubtype",
                                                "comment",
                                                "name",
                                                "id",
                                                "parentid",
                                                "color",
                                                "transformtype",
                                                "elementmin",
                                                "elementmax",
                                                "modality",
                                                "compresseddatasize",
                                                "sequenceid",
                                                "elementnbits",
                                                "imagetype",
                                                "acquisitiondate",
                                                "centerofrotation",
                                                "compressionlevel"};
  return keys;
}

void note_misspelt_keys(MetaImageHeader& header) {
  std::vector<std::string> known;
  for (const std::string& key : used_keys()) known.push_back(lower_case(key));
  for (const auto& [key, value] : header.fields) {
    const bool is_known = std::find(known.begin(), known.end(), key) != known.end();
    const bool is_ignored = std::find(ignored_keys().begin(), ignored_keys().end(), key) != ignored_keys().end();
    if (is_known || is_ignored) continue;
    const std::string nearest = nearest_name(key, known);
    if (nearest.empty()) continue;
    const auto at = static_cast<std::size_t>(std::find(known.begin(), known.end(), nearest) - known.begin());
    header.note(fmt::format("its header's key '{}' is not known and was not used; did you mean '{}'?",
                            key.substr(0, 60), used_keys()[at]));
  }
}

bool is_comment(const std::string& line) {
  const std::string text = trimmed(line);
  return text.empty() || text[0] == '#' || text.starts_with("//");
}

bool is_list(const std::string& file) {
  const std::string first = lower_case(file.substr(0, file.find_first_of(" \t")));
  return first == "list";
}

}  // namespace

bool MetaImageHeader::has(const char* key) const { return fields.contains(lower_case(key)); }

std::string MetaImageHeader::text(std::initializer_list<const char*> keys, const std::string& otherwise) const {
  for (const char* key : keys) {
    const auto found = fields.find(lower_case(key));
    if (found != fields.end()) return found->second;
  }
  return otherwise;
}

bool MetaImageHeader::flag(std::initializer_list<const char*> keys, bool otherwise) const {
  const std::string value = lower_case(text(keys, otherwise ? "true" : "false"));
  if (value == "true" || value == "t" || value == "1" || value == "yes") return true;
  if (value == "false" || value == "f" || value == "0" || value == "no") return false;
  throw DataError(fmt::format("{}: its {} '{}' is neither True nor False; correct its header", path.string(),
                              *keys.begin(), value.substr(0, 60)));
}

std::vector<double> MetaImageHeader::numbers(std::initializer_list<const char*> keys, std::size_t count,
                                             const std::vector<double>& otherwise) const {
  for (const char* key : keys) {
    if (has(key)) return numbers_in(text({key}, ""), count, path, key);
  }
  return otherwise;
}

MetaImageHeader read_metaimage_header(ByteReader& reader) {
  MetaImageHeader header;
  header.path = reader.path();
  std::string line;
  while (reader.read_line(line)) {
    const std::size_t equals = line.find('=');
    if (is_comment(line)) continue;
    if (equals == std::string::npos || line.find('\0') != std::string::npos) break;
    const std::string key = lower_case(trimmed(line.substr(0, equals)));
    const std::string value = trimmed(line.substr(equals + 1));
    const auto [field, is_new] = header.fields.emplace(key, value);
    if (!is_new && field->second != value && key != "comment") {
      header.note(fmt::format("its header has the key '{}' twice; '{}' was taken, not '{}'", key.substr(0, 60),
                              value.substr(0, 60), field->second.substr(0, 60)));
    }
    field->second = value;
    if (key != "elementdatafile") continue;
    if (is_list(value)) header.list = names_of_list(reader);
    note_misspelt_keys(header);
    return header;
  }
  if (!header.has("ObjectType") && !header.has("NDims"))
    throw DataError(header.path.string() + ": not a MetaImage file; give it the ending of its own format");
  throw DataError(header.path.string() + ": truncated: its header has no ElementDataFile; copy or export it again");
}

}  // namespace isobench
