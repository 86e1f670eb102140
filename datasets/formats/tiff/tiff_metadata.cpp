#include "isobench/datasets/formats/tiff/tiff_metadata.h"

#include <expat.h>
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <sstream>
#include <vector>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

using Keys = std::map<std::string, std::string>;

/// The keys of a text of lines "key=value".
Keys keys_of_lines(const std::string& text) {
  Keys keys;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos) keys[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
  }
  return keys;
}

/// The attributes of the elements <Pixels> of OME's XML.
struct OmePixels {
  std::vector<Keys> all;
};

void begin_ome_element(void* user, const XML_Char* name, const XML_Char** attributes) {
  const std::string full = name;
  if (full.substr(full.rfind(':') + 1) != "Pixels") return;
  Keys keys;
  for (; *attributes != nullptr; attributes += 2) keys[attributes[0]] = attributes[1];
  static_cast<OmePixels*>(user)->all.push_back(std::move(keys));
}

OmePixels ome_pixels(const std::string& xml) {
  OmePixels pixels;
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                                             XML_ParserFree);
  XML_SetUserData(parser.get(), &pixels);
  XML_SetStartElementHandler(parser.get(), begin_ome_element);
  if (XML_Parse(parser.get(), xml.data(), static_cast<int>(xml.size()), 1) != XML_STATUS_OK) pixels.all.clear();
  return pixels;
}

class MetadataReader {
 public:
  MetadataReader(const TiffPage& first, std::size_t pages, const std::filesystem::path& path)
      : first_(first), pages_(pages), path_(path) {}

  TiffMetadata read() {
    const std::string& text = first_.description;
    if (text.starts_with("ImageJ=") || text.starts_with("SCIFIO="))
      read_imagej(keys_of_lines(text));
    else if (text.find("<OME") != std::string::npos || text.find(":OME") != std::string::npos)
      read_ome(ome_pixels(text));
    else
      metadata_.sizes[1] = pages_;
    if (metadata_.source.empty()) read_resolution(first_.unit, "its resolution");
    return metadata_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_.string() + ": " + what); }

  double number(const Keys& keys, const char* key, double otherwise) const {
    const auto found = keys.find(key);
    return found == keys.end() || found->second.empty() ? otherwise : numbers_in(found->second, 1, path_, key).front();
  }

  std::size_t count(const Keys& keys, const char* key, std::size_t otherwise) const {
    const double stated = number(keys, key, static_cast<double>(otherwise));
    const long long size = size_in(stated);
    if (size == 0) fail(fmt::format("'{}' in its description is {}; correct it or export it again", key, stated));
    return static_cast<std::size_t>(size);
  }

  double spacing_in(double value, double unit) const {
    return std::isfinite(value) && value > 0.0 ? value * unit : 0.0;
  }

  void read_resolution(double unit, const char* source) {
    if (unit <= 0.0) return;
    // The resolution 1 with a unit is what programs write that know of none; ImageJ alone means it.
    metadata_.spacing[0] = spacing_in(1.0 / first_.x_resolution, unit);
    metadata_.spacing[1] = spacing_in(1.0 / first_.y_resolution, unit);
    if (metadata_.spacing[0] > 0.0) metadata_.source = source;
  }

  void read_imagej(const Keys& keys) {
    const std::size_t images = count(keys, "images", pages_);
    metadata_.sizes[0] = count(keys, "channels", 1);
    metadata_.sizes[2] = count(keys, "frames", 1);
    const std::size_t others = metadata_.sizes[0] * metadata_.sizes[2];
    metadata_.sizes[1] = count(keys, "slices", std::max<std::size_t>(1, images / others));
    const auto unit = keys.find("unit");
    if (unit == keys.end()) return;
    // ImageJ writes the micro sign as an escape.
    const std::string name = unit->second == "\\u00B5m" ? "um" : unit->second;
    const double mm = unit_in_mm(name, path_);
    if (name == "pixel" || name == "pixels") return;
    read_resolution(mm, "ImageJ");
    metadata_.spacing[2] = spacing_in(std::abs(number(keys, "spacing", 0.0)), mm);
  }

  void read_ome(const OmePixels& pixels) {
    if (pixels.all.empty()) {
      metadata_.sizes[1] = pages_;
      return;
    }
    if (pixels.all.size() > 1)
      fail(fmt::format("it holds {} images by its OME description; export one of them alone", pixels.all.size()));
    const Keys& keys = pixels.all.front();
    // SizeC counts the samples of a colour, too.
    metadata_.sizes[0] = std::max<std::size_t>(1, count(keys, "SizeC", 1) / first_.layout.components);
    metadata_.sizes[1] = count(keys, "SizeZ", 1);
    metadata_.sizes[2] = count(keys, "SizeT", 1);
    const auto order = keys.find("DimensionOrder");
    if (order != keys.end()) read_order(order->second);
    const char* const axes[] = {"PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto unit = keys.find(std::string(axes[axis]) + "Unit");
      const double mm = unit_in_mm(unit == keys.end() ? "um" : unit->second, path_);
      metadata_.spacing[axis] = spacing_in(number(keys, axes[axis], 0.0), mm);
    }
    if (metadata_.spacing[0] > 0.0) metadata_.source = "OME";
  }

  void read_order(const std::string& order) {
    static const std::map<char, PageAxis> letters = {
        {'C', PageAxis::channel}, {'Z', PageAxis::slice}, {'T', PageAxis::step}};
    bool is_order = order.size() == 5 && order.starts_with("XY");
    for (std::size_t n = 2; is_order && n < 5; ++n) {
      is_order = letters.contains(order[n]) && order.find(order[n], n + 1) == std::string::npos;
      if (is_order) metadata_.order[n - 2] = letters.at(order[n]);
    }
    if (!is_order)
      fail(fmt::format("the order '{}' of its OME axes is not known; export it again", order.substr(0, 20)));
  }

  const TiffPage& first_;
  std::size_t pages_;
  const std::filesystem::path& path_;
  TiffMetadata metadata_;
};

}  // namespace

TiffMetadata tiff_metadata(const TiffPage& first, std::size_t pages, const std::filesystem::path& path) {
  return MetadataReader(first, pages, path).read();
}

}  // namespace isobench
