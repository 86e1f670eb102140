#include "isobench/datasets/formats/dicom/dicom_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>
#include <string_view>

#include "isobench/datasets/formats/dicom/dicom_source.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

constexpr std::uint32_t undefined_length = 0xFFFFFFFF;
constexpr std::uint32_t item_begins = 0xFFFEE000;
constexpr std::uint32_t item_ends = 0xFFFEE00D;
constexpr std::uint32_t sequence_ends = 0xFFFEE0DD;
constexpr std::uintmax_t longest_value = std::uintmax_t{1} << 16U;
constexpr std::size_t first_bytes = 132;  // the preamble and "DICM"
constexpr int deepest_nesting = 16;
constexpr std::uintmax_t no_end = std::numeric_limits<std::uintmax_t>::max();

bool is_sequence(DicomTag tag) {
  switch (tag) {
    case DicomTag::frame_content:
    case DicomTag::plane_position:
    case DicomTag::plane_orientation:
    case DicomTag::pixel_measures:
    case DicomTag::pixel_value_transformation:
    case DicomTag::detector_information:
    case DicomTag::shared_groups:
    case DicomTag::per_frame_groups:
      return true;
    default:
      return false;
  }
}

bool is_value(DicomTag tag) {
  static constexpr std::array tags = {DicomTag::transfer_syntax,
                                      DicomTag::image_type,
                                      DicomTag::sop_instance_uid,
                                      DicomTag::acquisition_date_time,
                                      DicomTag::acquisition_time,
                                      DicomTag::series_description,
                                      DicomTag::slice_thickness,
                                      DicomTag::echo_time,
                                      DicomTag::spacing_between_slices,
                                      DicomTag::trigger_time,
                                      DicomTag::imager_pixel_spacing,
                                      DicomTag::b_value,
                                      DicomTag::series_instance_uid,
                                      DicomTag::series_number,
                                      DicomTag::acquisition_number,
                                      DicomTag::instance_number,
                                      DicomTag::image_position,
                                      DicomTag::image_orientation,
                                      DicomTag::temporal_position,
                                      DicomTag::slice_location,
                                      DicomTag::temporal_position_index,
                                      DicomTag::samples_per_pixel,
                                      DicomTag::photometric_interpretation,
                                      DicomTag::planar_configuration,
                                      DicomTag::number_of_frames,
                                      DicomTag::rows,
                                      DicomTag::columns,
                                      DicomTag::pixel_spacing,
                                      DicomTag::bits_allocated,
                                      DicomTag::bits_stored,
                                      DicomTag::high_bit,
                                      DicomTag::pixel_representation,
                                      DicomTag::pixel_padding_value,
                                      DicomTag::rescale_intercept,
                                      DicomTag::rescale_slope,
                                      DicomTag::grid_frame_offsets,
                                      DicomTag::dose_grid_scaling};
  static_assert(std::is_sorted(tags.begin(), tags.end()));
  return std::binary_search(tags.begin(), tags.end(), tag);
}

bool is_letter_pair(std::string_view text) {
  return text.size() == 2 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'A' && text[1] <= 'Z';
}

/// Old files have no preamble: their first element is one of the first of group 8, and short.
bool begins_with_group_8(std::string_view bytes) {
  if (bytes.size() < 16 || !bytes.starts_with(std::string_view("\x08\0", 2))) return false;
  if (bytes[3] != '\0' || static_cast<unsigned char>(bytes[2]) > 0x18) return false;
  return is_letter_pair(bytes.substr(4, 2)) || number_at<std::uint32_t>(bytes.data() + 4, ByteOrder::little) <= 128;
}

/// How elements are written.
struct Coding {
  bool is_explicit = true;  ///< each element states the type of its value
  ByteOrder order = ByteOrder::little;
};

/// What precedes the value of an element.
struct ElementHead {
  std::uint32_t tag = 0;
  std::string type;  ///< two letters; none if it is not stated
  std::uint32_t length = 0;
};

class DicomParser {
 public:
  explicit DicomParser(const std::filesystem::path& path) : source_(path) {}

  DicomElements parse() {
    skip_preamble();
    while (number_at<std::uint16_t>(peeked(2).data(), ByteOrder::little) == 2) {
      read_element(result_.data, read_head({}), {}, no_end, 0);
    }
    const DicomElement* syntax = result_.data.find(DicomTag::transfer_syntax);
    if (syntax != nullptr) result_.transfer_syntax = trimmed(syntax->bytes.substr(0, syntax->bytes.find('\0')));
    read_data(result_.data, coding_of_data(), no_end, 0);
    result_.is_deflated = source_.is_deflated();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw DataError(source_.path().string() + ": " + what); }

  std::string peeked(std::size_t count) {
    std::string bytes = source_.peek(count);
    bytes.resize(count, '\0');
    return bytes;
  }

  void skip_preamble() {
    if (source_.peek(first_bytes).ends_with("DICM")) {
      source_.skip(first_bytes);
    } else if (!begins_with_group_8(source_.peek(first_bytes))) {
      fail("not a DICOM file; give it the ending of its own format");
    }
  }

  Coding coding_of_data() {
    const std::string& syntax = result_.transfer_syntax;
    Coding coding;
    if (syntax == "1.2.840.10008.1.2.1.99") source_.inflate_rest();
    if (syntax == "1.2.840.10008.1.2.2") coding.order = ByteOrder::big;
    // Some writers state one coding and write the other, so the first element decides.
    coding.is_explicit = is_letter_pair(peeked(6).substr(4));
    result_.order = coding.order;
    return coding;
  }

  template <class Number>
  Number read_number(ByteOrder order) {
    std::array<char, sizeof(Number)> bytes{};
    source_.read(bytes.data(), bytes.size());
    return number_at<Number>(bytes.data(), order);
  }

  std::uint32_t read_tag(ByteOrder order) {
    const std::uint32_t group = read_number<std::uint16_t>(order);
    return group << 16U | read_number<std::uint16_t>(order);
  }

  ElementHead read_head(const Coding& coding) {
    ElementHead head;
    head.tag = read_tag(coding.order);
    if (!coding.is_explicit || head.tag >> 16U == 0xFFFE) {
      head.length = read_number<std::uint32_t>(coding.order);
      return head;
    }
    head.type.resize(2);
    source_.read(head.type.data(), 2);
    if (!is_letter_pair(head.type)) {
      fail(fmt::format("damaged: the element ({:04X},{:04X}) in its header has no type; copy or export it again",
                       head.tag >> 16U, head.tag & 0xFFFFU));
    }
    static constexpr std::string_view with_long_lengths = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
    if (with_long_lengths.find(head.type) != std::string_view::npos) {
      source_.skip(2);
      head.length = read_number<std::uint32_t>(coding.order);
    } else {
      head.length = read_number<std::uint16_t>(coding.order);
    }
    return head;
  }

  /// Reads elements up to `end`, to the mark that ends an item, to the pixels or to the end of the file. Returns true
  /// at the pixels.
  bool read_data(DicomItem& item, const Coding& coding, std::uintmax_t end, int depth) {
    while (source_.position() < end) {
      if (depth == 0 && source_.peek(8).size() < 8) return false;
      const ElementHead head = read_head(coding);
      if (head.tag == item_ends) return false;
      if (depth == 0 && head.tag >= static_cast<std::uint32_t>(DicomTag::float_pixels) &&
          head.tag <= static_cast<std::uint32_t>(DicomTag::pixels)) {
        note_pixels(head);
        return true;
      }
      read_element(item, head, coding, end, depth);
    }
    return false;
  }

  void note_pixels(const ElementHead& head) {
    DicomPixels pixels;
    pixels.tag = static_cast<DicomTag>(head.tag);
    pixels.offset = source_.position();
    pixels.is_encapsulated = head.length == undefined_length;
    pixels.length = std::min<std::uintmax_t>(head.length, source_.possible_bytes());
    pixels.is_in_words = head.type == "OW";
    result_.pixels = pixels;
  }

  void check_length(const ElementHead& head, std::uintmax_t end) const {
    if (head.length > source_.possible_bytes()) fail("truncated in its header; copy or export it again");
    if (source_.position() + head.length > end) {
      fail(fmt::format("damaged: the element ({:04X},{:04X}) is longer than what holds it; copy or export it again",
                       head.tag >> 16U, head.tag & 0xFFFFU));
    }
  }

  void read_element(DicomItem& item, const ElementHead& head, const Coding& coding, std::uintmax_t end, int depth) {
    const auto tag = static_cast<DicomTag>(head.tag);
    const bool has_end = head.length != undefined_length;
    if (has_end) check_length(head, end);
    if (is_sequence(tag) || !has_end) {
      const std::uintmax_t sequence_end = has_end ? source_.position() + head.length : end;
      // A value of unknown type that is a sequence is written without types, whatever the rest of the file is.
      const Coding inner = head.type == "UN" ? Coding{false, ByteOrder::little} : coding;
      DicomElement sequence{tag, {}, {}};
      read_items(sequence, inner, sequence_end, has_end, depth + 1);
      if (is_sequence(tag)) item.elements.push_back(std::move(sequence));
    } else if (is_value(tag) && head.length <= longest_value) {
      item.elements.push_back({tag, std::string(head.length, '\0'), {}});
      source_.read(item.elements.back().bytes.data(), head.length);
    } else {
      source_.skip(head.length);
    }
  }

  void read_items(DicomElement& sequence, const Coding& coding, std::uintmax_t end, bool has_end, int depth) {
    if (depth > deepest_nesting) fail("damaged: its header nests too deeply; copy or export it again");
    while (!has_end || source_.position() < end) {
      const ElementHead head = read_head(coding);
      if (head.tag == sequence_ends) return;
      if (head.tag != item_begins) fail("damaged: a sequence in its header has no items; copy or export it again");
      const bool item_has_end = head.length != undefined_length;
      if (item_has_end) check_length(head, end);
      DicomItem item;
      const std::uintmax_t item_end = item_has_end ? source_.position() + head.length : end;
      read_data(item, coding, item_end, depth);
      if (is_sequence(sequence.tag)) sequence.items.push_back(std::move(item));
    }
  }

  DicomSource source_;
  DicomElements result_;
};

}  // namespace

const DicomElement* DicomItem::find(DicomTag tag) const {
  const auto found = std::find_if(elements.begin(), elements.end(), [tag](const auto& e) { return e.tag == tag; });
  return found == elements.end() ? nullptr : &*found;
}

const DicomItem* DicomItem::first_item(DicomTag tag) const {
  const DicomElement* sequence = find(tag);
  return sequence == nullptr || sequence->items.empty() ? nullptr : &sequence->items.front();
}

bool is_dicom_file(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string bytes(first_bytes, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return (bytes.size() == first_bytes && bytes.ends_with("DICM")) || begins_with_group_8(bytes);
}

DicomElements read_dicom_elements(const std::filesystem::path& path) { return DicomParser(path).parse(); }

}  // namespace isobench
