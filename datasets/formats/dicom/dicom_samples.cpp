#include "isobench/datasets/formats/dicom/dicom_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "isobench/datasets/formats/dicom/decoder_process.h"
#include "isobench/datasets/formats/dicom/dicom_source.h"
#include "isobench/datasets/formats/dicom/frame_header.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

[[noreturn]] void fail_in(const DicomImage& image, const std::string& what) {
  throw DataError(image.path.string() + ": " + what);
}

/// A part of encapsulated pixels.
struct PixelFragment {
  std::uintmax_t offset = 0;  // in the file
  std::uint32_t length = 0;
};

/// The fragments of the frames of a file, frame by frame.
using FrameFragments = std::vector<std::vector<PixelFragment>>;

/// The items of encapsulated pixels: a table of the offsets of frames, which may be empty, and all fragments.
struct EncapsulatedItems {
  std::vector<std::uint32_t> offsets;  ///< from the first fragment's head
  std::vector<PixelFragment> fragments;
};

EncapsulatedItems items_of(const DicomImage& image) {
  DicomSource source(image.path);
  source.skip_to(image.pixels.offset);
  EncapsulatedItems items;
  for (bool is_table = true;; is_table = false) {
    std::array<char, 8> head{};
    source.read(head.data(), head.size());
    const auto group = number_at<std::uint16_t>(head.data(), ByteOrder::little);
    const auto element = number_at<std::uint16_t>(head.data() + 2, ByteOrder::little);
    const auto length = number_at<std::uint32_t>(head.data() + 4, ByteOrder::little);
    if (group == 0xFFFE && element == 0xE0DD) return items;
    if (group != 0xFFFE || element != 0xE000)
      fail_in(image, "damaged: its pixels are not a list of fragments; copy it again");
    if (length > source.possible_bytes()) fail_in(image, "truncated in its pixels; copy or export it again");
    const std::uintmax_t next = source.position() + length;
    if (!is_table) items.fragments.push_back({source.position(), length});
    for (std::uint32_t n = 0; is_table && n < length / 4; ++n) {
      std::array<char, 4> offset{};
      source.read(offset.data(), offset.size());
      items.offsets.push_back(number_at<std::uint32_t>(offset.data(), ByteOrder::little));
    }
    source.skip_to(next);
  }
}

FrameFragments fragments_of(const DicomImage& image) {
  const EncapsulatedItems items = items_of(image);
  const std::vector<PixelFragment>& all = items.fragments;
  const std::size_t frames = image.frames.size();
  if (frames == 1) return {all};
  FrameFragments result;
  if (all.size() == frames) {
    for (const PixelFragment& fragment : all) result.push_back({fragment});
    return result;
  }
  if (items.offsets.size() != frames || all.empty())
    fail_in(image, fmt::format("damaged: {} fragments for {} frames; export it again", all.size(), frames));
  const std::uintmax_t first = all.front().offset;
  for (const PixelFragment& fragment : all) {
    const bool begins = result.size() < frames && fragment.offset - first == items.offsets[result.size()];
    if (begins) result.emplace_back();
    if (result.empty()) break;
    result.back().push_back(fragment);
  }
  if (result.size() != frames) fail_in(image, "damaged: its table of frames is wrong; export it again");
  return result;
}

/// Gives the frames of files, in any order; neighbours of one file without opening it again.
class FrameBytes {
 public:
  /// The bytes of all components of a frame, in the order that they have in the file; decoded ones in this machine's.
  const std::vector<char>& read(const DicomSlice& slice) {
    if (slice.image->pixels.is_encapsulated)
      decode(slice);
    else
      read_plain(slice);
    return bytes_;
  }

 private:
  void read_plain(const DicomSlice& slice) {
    bytes_.resize(static_cast<std::size_t>(slice.image->layout.frame_bytes()));
    const std::uintmax_t at = slice.image->pixels.offset + slice.frame->number * std::uintmax_t{bytes_.size()};
    if (plain_image_ != slice.image || at < source_->position()) {
      source_ = std::make_unique<DicomSource>(slice.image->path);
      plain_image_ = slice.image;
      // The stream that is deflated begins after the header of the file.
      if (slice.image->is_deflated) inflate_from_header();
    }
    source_->skip_to(at);
    source_->read(bytes_.data(), bytes_.size());
  }

  void inflate_from_header() {
    constexpr std::uintmax_t preamble = 132;
    source_->skip_to(preamble);
    while (source_->peek(2) == std::string("\x02\0", 2)) {
      std::array<char, 8> head{};
      source_->read(head.data(), head.size());
      const bool is_long = head[4] == 'O' || (head[4] == 'U' && head[5] != 'I' && head[5] != 'L' && head[5] != 'S');
      std::uintmax_t length = number_at<std::uint16_t>(head.data() + 6, ByteOrder::little);
      if (is_long) {
        source_->read(head.data(), 4);
        length = number_at<std::uint32_t>(head.data(), ByteOrder::little);
      }
      source_->skip(length);
    }
    source_->inflate_rest();
  }

  void decode(const DicomSlice& slice) {
    const DicomImage& image = *slice.image;
    if (fragments_image_ != slice.image) {
      fragments_ = fragments_of(image);
      source_ = std::make_unique<DicomSource>(image.path);
      fragments_image_ = slice.image;
      plain_image_ = nullptr;
    }
    std::string data;
    for (const PixelFragment& fragment : fragments_[slice.frame->number]) {
      if (fragment.offset < source_->position()) source_ = std::make_unique<DicomSource>(image.path);
      source_->skip_to(fragment.offset);
      const std::size_t done = data.size();
      data.resize(done + fragment.length);
      source_->read(data.data() + done, fragment.length);
    }
    const std::string wrong = check_frame_header(data, image);
    const std::string name = transfer_syntax_name(image.transfer_syntax);
    if (!wrong.empty()) fail_in(image, fmt::format("damaged: its {} data: {}; copy or export it again", name, wrong));
    check_amount(image, data.size());
    bytes_.resize(static_cast<std::size_t>(image.layout.frame_bytes()));
    if (!process_ || process_image_->layout != image.layout ||
        process_image_->transfer_syntax != image.transfer_syntax) {
      process_.reset();
      process_ = std::make_unique<DecoderProcess>(image);
      process_image_ = &image;
    }
    if (!process_->decode(data, bytes_))
      fail_in(image, fmt::format("damaged: its {} data cannot be decoded; copy or export it again", name));
  }

  /// Nearly empty slices compress by a factor of thousands, but no series consists of them.
  void check_amount(const DicomImage& image, std::size_t compressed) {
    constexpr std::uintmax_t always = std::uintmax_t{1} << 26U;
    constexpr std::uintmax_t most_compression = 1000;
    compressed_ += compressed;
    decoded_ += image.layout.frame_bytes();
    if (decoded_ > always && decoded_ / most_compression > compressed_) {
      fail_in(image, fmt::format("damaged: {} bytes of compressed data are too few for its {} × {} samples; copy or "
                                 "export it again",
                                 compressed, image.layout.columns, image.layout.rows));
    }
  }

  std::vector<char> bytes_;
  std::unique_ptr<DicomSource> source_;
  const DicomImage* plain_image_ = nullptr;
  const DicomImage* fragments_image_ = nullptr;
  FrameFragments fragments_;
  std::unique_ptr<DecoderProcess> process_;
  const DicomImage* process_image_ = nullptr;
  std::uintmax_t compressed_ = 0;
  std::uintmax_t decoded_ = 0;
};

SampleType stored_type(const DicomLayout& layout) {
  if (layout.is_real) return layout.allocated == 32 ? SampleType::f32 : SampleType::f64;
  switch (layout.allocated) {
    case 8:
      return layout.is_signed ? SampleType::i8 : SampleType::u8;
    case 16:
      return layout.is_signed ? SampleType::i16 : SampleType::u16;
    default:
      return layout.is_signed ? SampleType::i32 : SampleType::u32;
  }
}

/// Whether the type holds all integers from `least` to `most`.
bool holds_integers(SampleType type, double least, double most) {
  return Samples(type).visit([&](const auto& none) {
    using T = SampleOf<decltype(none)>;
    return std::is_integral_v<T> && least >= static_cast<double>(std::numeric_limits<T>::min()) &&
           most <= static_cast<double>(std::numeric_limits<T>::max());
  });
}

SampleType type_of_sums(const DicomStack& stack) {
  const DicomLayout& layout = stack.slices.front().image->layout;
  const SampleType stored = stored_type(layout);
  const auto all = [&](auto&& is_true) {
    return std::all_of(stack.slices.begin(), stack.slices.end(),
                       [&](const DicomSlice& s) { return is_true(*s.frame); });
  };
  if (all([](const DicomFrame& frame) { return frame.slope == 1.0 && frame.intercept == 0.0; })) return stored;
  const bool are_whole = all([](const DicomFrame& frame) {
    return frame.slope == 1.0 && frame.intercept == std::floor(frame.intercept) && std::abs(frame.intercept) < 1e9;
  });
  if (are_whole && !layout.is_real) {
    const auto [low, high] = std::minmax_element(
        stack.slices.begin(), stack.slices.end(),
        [](const DicomSlice& a, const DicomSlice& b) { return a.frame->intercept < b.frame->intercept; });
    const double values = std::ldexp(1.0, layout.stored);
    const double least = (layout.is_signed ? -values / 2.0 : 0.0) + low->frame->intercept;
    const double most = (layout.is_signed ? values / 2.0 : values) - 1.0 + high->frame->intercept;
    for (const SampleType type : {stored, SampleType::i16, SampleType::u16, SampleType::i32, SampleType::u32}) {
      if (holds_integers(type, least, most)) return type;
    }
  }
  return Samples(stored).visit(
      [](const auto& none) { return Samples(std::vector<RealOf<SampleOf<decltype(none)>>>()).type(); });
}

/// How the bytes of a frame become samples.
struct FrameConversion {
  DicomLayout layout;
  std::size_t component = 0;
  ByteOrder order = ByteOrder::little;
  bool is_in_swapped_words = false;
  double slope = 1.0;
  double intercept = 0.0;
};

/// The value that the stored bits of a sample hold.
template <class Stored>
Stored value_of(Stored raw, const DicomLayout& layout) {
  if constexpr (std::is_integral_v<Stored>) {
    using Bits = std::make_unsigned_t<Stored>;
    constexpr int all_bits = std::numeric_limits<Bits>::digits;
    // To the top, so that other bits fall out, and back down, with the sign.
    const auto top = static_cast<Bits>(static_cast<Bits>(raw) << (all_bits - 1 - layout.high));
    return static_cast<Stored>(static_cast<Stored>(top) >> (all_bits - layout.stored));
  } else {
    return raw;
  }
}

/// Whether type_of_sums() gives T for samples stored as Stored; spares the compiler the other pairs.
template <class Stored, class T>
constexpr bool is_possible = std::is_same_v<Stored, T> || std::is_same_v<RealOf<Stored>, T> ||
                             (std::is_integral_v<Stored> && sizeof(Stored) <= 4 && std::is_integral_v<T> &&
                              (sizeof(T) == 2 || sizeof(T) == 4));

template <class Stored, class T>
void append_frame(const std::vector<char>& bytes, const FrameConversion& conversion, std::vector<T>& samples) {
  const DicomLayout& layout = conversion.layout;
  const auto count = static_cast<std::size_t>(layout.rows) * static_cast<std::size_t>(layout.columns);
  const auto components = static_cast<std::size_t>(layout.components);
  const std::size_t stride = layout.is_planar ? 1 : components;
  const std::size_t first = layout.is_planar ? conversion.component * count : conversion.component;
  const bool is_rescaled = conversion.slope != 1.0 || conversion.intercept != 0.0;
  const std::size_t done = samples.size();
  samples.resize(done + count);
  for (std::size_t n = 0; n < count; ++n) {
    std::size_t at = (first + n * stride) * sizeof(Stored);
    if (conversion.is_in_swapped_words) at ^= 1U;
    const Stored value = value_of(number_at<Stored>(bytes.data() + at, conversion.order), layout);
    samples[done + n] = is_rescaled
                            ? static_cast<T>(conversion.slope * static_cast<double>(value) + conversion.intercept)
                            : static_cast<T>(value);
  }
}

FrameConversion conversion_of(const DicomSlice& slice, std::size_t component) {
  const DicomImage& image = *slice.image;
  FrameConversion conversion{image.layout, component, image.order, false, slice.frame->slope, slice.frame->intercept};
  // GE's own syntax has big-endian pixels after a little-endian header.
  if (image.transfer_syntax == "1.2.840.113619.5.2") conversion.order = ByteOrder::big;
  if (image.pixels.is_encapsulated) conversion.order = native_order;
  conversion.is_in_swapped_words = image.layout.allocated == 8 && conversion.order == ByteOrder::big &&
                                   image.pixels.is_in_words && image.layout.frame_bytes() % 2 == 0;
  return conversion;
}

void check_syntax(const DicomImage& image) {
  if (!image.pixels.is_encapsulated || (can_decode(image.transfer_syntax) && !image.layout.is_real)) return;
  fail_in(image, fmt::format("its samples are compressed by {}, which cannot be decoded; decompress it first, e.g. by "
                             "gdcmconv --raw or dcmdjpeg",
                             transfer_syntax_name(image.transfer_syntax)));
}

}  // namespace

Samples read_dicom_samples(const DicomStack& stack, std::size_t component) {
  for (const DicomSlice& slice : stack.slices) check_syntax(*slice.image);
  Samples samples(type_of_sums(stack));
  const DicomLayout& layout = stack.slices.front().image->layout;
  FrameBytes frames;
  samples.visit([&](auto& values) {
    // This takes only addresses, no memory yet.
    values.reserve(stack.lattice.nodes());
    Samples(stored_type(layout)).visit([&](const auto& stored) {
      using Stored = SampleOf<decltype(stored)>;
      if constexpr (is_possible<Stored, SampleOf<decltype(values)>>) {
        for (const DicomSlice& slice : stack.slices)
          append_frame<Stored>(frames.read(slice), conversion_of(slice, component), values);
      }
    });
  });
  return samples;
}

}  // namespace isobench
