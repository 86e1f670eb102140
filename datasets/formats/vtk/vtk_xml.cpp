#include "isobench/datasets/formats/vtk/vtk_xml.h"

#include <expat.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>

#include "isobench/datasets/formats/reading/byte_reader.h"
#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/datasets/formats/vtk/vtk_blocks.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::size_t deepest = 32;  // real files have 6 levels

/// Builds the elements in the order in which expat finds them.
struct Builder {
  XML_Parser parser;
  VtkElement root;  // holds the document's element
  std::vector<VtkElement*> open{&root};

  static void start(void* data, const char* name, const char** attributes) {
    auto& self = *static_cast<Builder*>(data);
    if (self.open.size() > deepest) {
      XML_StopParser(self.parser, XML_FALSE);
      return;
    }
    // A parent gets no further child while one is open, so the pointers in `open` stay valid.
    VtkElement& element = self.open.back()->children.emplace_back();
    element.name = name;
    for (const char** a = attributes; a[0] != nullptr; a += 2) element.attributes[a[0]] = a[1];
    self.open.push_back(&element);
  }
  static void end(void* data, const char*) { static_cast<Builder*>(data)->open.pop_back(); }
  static void text(void* data, const char* characters, int length) {
    static_cast<Builder*>(data)->open.back()->text.append(characters, static_cast<std::size_t>(length));
  }
  // VTK's files declare no document type. One that does may define entities that expand without end.
  static void doctype(void* data, const char*, const char*, const char*, int) {
    XML_StopParser(static_cast<Builder*>(data)->parser, XML_FALSE);
  }
};

/// std::nullopt if it is not well-formed XML.
std::optional<VtkElement> parse_xml(std::string_view xml, std::string_view tail) {
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                                             XML_ParserFree);
  if (!parser) throw std::bad_alloc();
  Builder builder{parser.get(), {}};
  XML_SetUserData(parser.get(), &builder);
  XML_SetElementHandler(parser.get(), Builder::start, Builder::end);
  XML_SetCharacterDataHandler(parser.get(), Builder::text);
  XML_SetStartDoctypeDeclHandler(parser.get(), Builder::doctype);
  constexpr std::size_t piece = std::size_t{1} << 20U;  // expat counts in int
  while (!xml.empty()) {
    const std::string_view part = xml.substr(0, piece);
    xml.remove_prefix(part.size());
    const bool last = xml.empty() && tail.empty();
    if (XML_Parse(parser.get(), part.data(), static_cast<int>(part.size()), last ? 1 : 0) != XML_STATUS_OK) return {};
  }
  if (!tail.empty() && XML_Parse(parser.get(), tail.data(), static_cast<int>(tail.size()), 1) != XML_STATUS_OK)
    return {};
  if (builder.root.children.empty()) return {};
  return std::move(builder.root.children.front());
}

std::string whole_file(const std::filesystem::path& path) {
  ByteReader reader(path, Encoding::plain);
  std::string bytes(reader.possible_bytes(), '\0');
  bytes.resize(reader.read(bytes.data(), bytes.size()));
  return bytes;
}

std::optional<SampleType> type_of(const VtkElement& array) {
  static const std::map<std::string, SampleType> types = {{"Int8", SampleType::i8},     {"UInt8", SampleType::u8},
                                                          {"Int16", SampleType::i16},   {"UInt16", SampleType::u16},
                                                          {"Int32", SampleType::i32},   {"UInt32", SampleType::u32},
                                                          {"Int64", SampleType::i64},   {"UInt64", SampleType::u64},
                                                          {"Float32", SampleType::f32}, {"Float64", SampleType::f64}};
  const auto found = types.find(array.attribute("type"));
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::string VtkElement::attribute(const std::string& key, const std::string& otherwise) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? otherwise : found->second;
}

const VtkElement* VtkElement::child(const std::string& child_name) const {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const VtkElement& element) { return element.name == child_name; });
  return found == children.end() ? nullptr : &*found;
}

void VtkXmlFile::fail(const std::string& message) const { throw DataError(path_.string() + ": " + message); }

/// Takes raw appended data off the end of the text, because they are not XML.
void VtkXmlFile::find_appended(std::string_view& xml) {
  const std::size_t tag = xml.find("<AppendedData");
  if (tag == xml.npos) return;
  const std::size_t end = xml.find('>', tag);
  const std::size_t mark = end == xml.npos ? end : xml.find_first_not_of(blanks, end + 1);
  if (mark == xml.npos || xml[mark] != '_')
    fail("truncated or damaged: its appended data do not begin with '_'; copy or export it again");
  appended_ = xml.substr(mark + 1);
  xml = xml.substr(0, end + 1);
}

VtkXmlFile::VtkXmlFile(std::filesystem::path path, const std::string& type)
    : path_(std::move(path)), bytes_(whole_file(path_)) {
  std::string_view xml = bytes_;
  if (xml.substr(0, 4096).find("<VTKFile") == xml.npos) {
    fail("not a VTK XML file; give it the ending of its own format");
  }
  find_appended(xml);
  std::optional<VtkElement> root = parse_xml(xml, appended_.data() != nullptr ? "</AppendedData></VTKFile>" : "");
  if (!root) fail("truncated or damaged: it is not well-formed XML; copy or export it again");
  root_ = std::move(*root);
  data_ = root_.child(type);
  if (root_.name != "VTKFile" || data_ == nullptr) {
    fail(fmt::format("it holds '{}', but {} is expected; give a file of that kind", root_.attribute("type"), type));
  }
  const VtkElement* appended = root_.child("AppendedData");
  appended_base64_ = appended != nullptr && appended->attribute("encoding") == "base64";
}

std::size_t VtkXmlFile::count(const VtkElement& element, const std::string& attribute) const {
  const std::string text = element.attribute(attribute, "0");
  std::size_t value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || value > std::size_t{1} << 40U) {
    fail(fmt::format("its {} '{}' is not a whole number from 0 to 2^40; copy or export it again", attribute, text));
  }
  return value;
}

bool VtkXmlFile::is_numeric(const VtkElement& array) { return type_of(array).has_value(); }

std::string VtkXmlFile::bytes_of_array(const VtkElement& array, std::size_t bytes) const {
  VtkBlocks blocks;
  std::string inline_text;
  if (array.attribute("format") == "appended") {
    const std::size_t offset = count(array, "offset");
    if (offset >= appended_.size()) fail("truncated: an array begins beyond the file's end; copy or export it again");
    blocks.source = appended_.substr(offset);
    blocks.base64 = appended_base64_;
  } else {
    inline_text = array.text;
    std::erase_if(inline_text, [](char c) { return blanks.find(c) != blanks.npos; });
    blocks.source = inline_text;
    blocks.base64 = true;
  }
  blocks.wide_header = root_.attribute("header_type", "UInt32") == "UInt64";
  blocks.order = order();
  const std::string compressor = root_.attribute("compressor");
  if (compressor == "vtkZLibDataCompressor")
    blocks.compressor = VtkCompressor::zlib;
  else if (compressor == "vtkLZ4DataCompressor")
    blocks.compressor = VtkCompressor::lz4;
  else if (compressor == "vtkLZMADataCompressor")
    blocks.compressor = VtkCompressor::lzma;
  else if (!compressor.empty())
    fail(fmt::format("its compressor '{}' is not known; export it with zlib", compressor));
  std::optional<std::string> data = decoded(blocks, bytes);
  if (!data) {
    fail(
        fmt::format("truncated or damaged: its array '{}' does not hold the {} bytes that it should; copy or export "
                    "it again",
                    array.attribute("Name"), bytes));
  }
  return std::move(*data);
}

SampleType VtkXmlFile::type_of_array(const VtkElement& array) const {
  const std::optional<SampleType> type = type_of(array);
  if (!type) fail(fmt::format("its array '{}' does not hold numbers; export it again", array.attribute("Name")));
  return *type;
}

ByteOrder VtkXmlFile::order() const {
  return root_.attribute("byte_order") == "BigEndian" ? ByteOrder::big : ByteOrder::little;
}

Samples VtkXmlFile::text_samples(const VtkElement& array, std::size_t count, SampleType type) const {
  std::optional<Samples> samples = samples_of_text(array.text, count, type);
  if (!samples) {
    fail(
        fmt::format("truncated or damaged: its array '{}' does not hold {} numbers of type {}; copy or export it again",
                    array.attribute("Name"), count, to_string(type)));
  }
  return std::move(*samples);
}

Samples VtkXmlFile::samples(const VtkElement& array, std::size_t count) const {
  const SampleType type = type_of_array(array);
  if (count == 0) return Samples(type);
  if (array.attribute("format", "ascii") == "ascii") return text_samples(array, count, type);
  return samples_of_bytes(bytes_of_array(array, count * bytes_of(type)).data(), count, type, order());
}

std::vector<double> VtkXmlFile::numbers(const VtkElement& array, std::size_t count) const {
  const SampleType type = type_of_array(array);
  if (count == 0) return {};
  if (array.attribute("format", "ascii") == "ascii") return text_samples(array, count, SampleType::f64).as<double>();
  const std::string bytes = bytes_of_array(array, count * bytes_of(type));
  std::vector<double> numbers(count);
  convert_samples(bytes.data(), count, type, order(), numbers.data());
  return numbers;
}

}  // namespace isobench
