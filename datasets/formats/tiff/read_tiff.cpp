#include "isobench/datasets/formats/tiff/read_tiff.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/datasets/formats/tiff/numbered_files.h"
#include "isobench/datasets/formats/tiff/tiff_file.h"
#include "isobench/datasets/formats/tiff/tiff_metadata.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

std::string text_of(const TiffLayout& layout) {
  return fmt::format("{} × {} samples of {}{}", layout.columns, layout.rows, to_string(layout.type),
                     layout.components == 1 ? "" : fmt::format(" with {} components", layout.components));
}

class TiffReader {
 public:
  TiffReader(const fs::path& path, const VolumeChoice& choice) : path_(path), choice_(choice) {}

  VolumeFile read_file(const fs::path& file) {
    TiffFile tiff(file);
    const std::vector<std::size_t> pages = full_pages(tiff);
    const TiffPage& first = tiff.pages()[pages.front()];
    const TiffMetadata metadata = tiff_metadata(first, pages.size(), file);
    const bool is_raw_behind = pages.size() == 1 && metadata.pages() > 1 && first.data_offset > 0;
    if (!is_raw_behind && metadata.pages() != pages.size()) {
      fail(fmt::format("its description states {} pages, but it has {}; export it again, as one file", metadata.pages(),
                       pages.size()));
    }
    const std::size_t component = component_of(first.layout, metadata);
    const std::size_t step = place_on_axis(choice_.step, metadata.sizes[2], "step", path_);
    set_lattice(first.layout, metadata, metadata.sizes[1]);
    note_meaning(first);
    if (pages.size() == 1 && !is_raw_behind) note_lone_slice(file);
    result_.volume.samples = Samples(first.layout.type);
    if (is_raw_behind)
      read_raw_behind(file, tiff.order(), first, metadata, component, step);
    else
      read_pages(tiff, pages, metadata, component, step);
    return std::move(result_);
  }

  VolumeFile read_stack(const std::vector<fs::path>& files) {
    std::optional<TiffPage> first;
    Samples& samples = result_.volume.samples;
    std::size_t component = 0;
    for (const fs::path& file : files) {
      TiffFile tiff(file);
      const std::vector<std::size_t> pages = full_pages(tiff);
      if (pages.size() > 1) {
        fail(fmt::format("it holds {} TIFF files, and {} has {} pages; give one such file, or files of one page",
                         files.size(), file.filename().string(), pages.size()));
      }
      const TiffPage& page = tiff.pages()[pages.front()];
      if (!first) {
        first = page;
        TiffMetadata metadata = tiff_metadata(*first, 1, file);
        if (metadata.pages() != 1) fail("its files have several slices, channels or steps each; give one of them");
        component = component_of(first->layout, metadata);
        set_lattice(first->layout, metadata, files.size());
        note_meaning(*first);
        samples = Samples(first->layout.type);
      }
      check_same(first->layout, page.layout, file.filename().string());
      tiff.check_bytes(bytes_of_page(first->layout));
      tiff.read(page, component, samples);
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_.string() + ": " + what); }
  void note(const std::string& what) { result_.notes.push_back(path_.string() + ": " + what); }

  static std::uint64_t bytes_of_page(const TiffLayout& layout) {
    return static_cast<std::uint64_t>(layout.columns) * static_cast<std::uint64_t>(layout.rows) * layout.components *
           bytes_of(layout.type);
  }

  /// The places of pages that are no thumbnails or masks.
  static std::vector<std::size_t> full_pages(const TiffFile& tiff) {
    std::vector<std::size_t> places;
    for (std::size_t n = 0; n < tiff.pages().size(); ++n) {
      if (!tiff.pages()[n].is_reduced) places.push_back(n);
    }
    if (places.empty()) places.push_back(0);
    return places;
  }

  void check_same(const TiffLayout& first, const TiffLayout& other, const std::string& what) const {
    if (first == other) return;
    fail(fmt::format("its slices differ: the first has {}, {} has {}; give slices of one size and type", text_of(first),
                     what, text_of(other)));
  }

  /// The component of each sample and the channel of pages are one choice: a file has one of them.
  std::size_t component_of(const TiffLayout& layout, const TiffMetadata& metadata) const {
    if (metadata.sizes[0] > 1 && layout.components > 1)
      fail("it has both channels and colours; export its channels alone");
    return place_on_axis(choice_.component, std::max(metadata.sizes[0], layout.components), "component", path_);
  }

  void set_lattice(const TiffLayout& layout, const TiffMetadata& metadata, std::size_t slices) {
    const auto& [x, y, z] = metadata.spacing;
    Eigen::Vector3d spacing(x, y > 0.0 ? y : x, z > 0.0 ? z : x);
    if (x <= 0.0) {
      spacing = Eigen::Vector3d::Ones();
      if (z > 0.0) spacing[2] = z;
      note("its spacing is not stated; 1 mm was taken");
    } else if (z <= 0.0) {
      note(fmt::format("the distance of its slices is not stated; {:.6g} mm was taken, the spacing within slices by {}",
                       x, metadata.source));
    }
    result_.volume.lattice = make_lattice(path_, {layout.columns, layout.rows, static_cast<long long>(slices)}, spacing,
                                          Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), "");
  }

  void note_meaning(const TiffPage& first) {
    if (first.is_palette) note("its samples are places in a table of colours; they were read as they are");
    if (first.is_white_at_zero) note("small samples are bright in it; they were read as they are");
  }

  void note_lone_slice(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    const std::size_t files = files_ending(folder, {".tif", ".tiff"}).size();
    if (files > 1)
      note(fmt::format("one slice; give its folder, which has {} TIFF files, to read them as a stack", files));
  }

  void read_pages(TiffFile& tiff, const std::vector<std::size_t>& pages, const TiffMetadata& metadata,
                  std::size_t component, std::size_t step) {
    const TiffLayout& layout = tiff.pages()[pages.front()].layout;
    for (const std::size_t place : pages)
      check_same(layout, tiff.pages()[place].layout, fmt::format("page {}", place + 1));
    tiff.check_bytes(bytes_of_page(layout) * pages.size());
    const bool has_channels = metadata.sizes[0] > 1;
    for (std::size_t slice = 0; slice < metadata.sizes[1]; ++slice) {
      const std::array<std::size_t, 3> at{has_channels ? component : 0, slice, step};
      std::size_t place = 0;
      std::size_t distance = 1;
      for (const PageAxis axis : metadata.order) {
        place += distance * at[static_cast<std::size_t>(axis)];
        distance *= metadata.sizes[static_cast<std::size_t>(axis)];
      }
      tiff.read(tiff.pages()[pages[place]], has_channels ? 0 : component, result_.volume.samples);
    }
  }

  /// ImageJ writes stacks that a TIFF file of 4 GiB cannot hold as one page, and all other pages plain behind it.
  void read_raw_behind(const fs::path& file, ByteOrder order, const TiffPage& first, const TiffMetadata& metadata,
                       std::size_t component, std::size_t step) {
    const bool has_channels = metadata.sizes[0] > 1;
    const auto rectangle = static_cast<std::size_t>(first.layout.columns) * static_cast<std::size_t>(first.layout.rows);
    std::vector<FileAxis> axes = {{first.layout.components}, {rectangle}};
    if (first.layout.components > 1) axes[0].chosen = component;
    const std::array<std::optional<std::size_t>, 3> chosen{has_channels ? std::optional(component) : std::nullopt,
                                                           std::nullopt,
                                                           metadata.sizes[2] > 1 ? std::optional(step) : std::nullopt};
    for (const PageAxis axis : metadata.order) {
      axes.push_back({metadata.sizes[static_cast<std::size_t>(axis)], chosen[static_cast<std::size_t>(axis)]});
    }
    ByteReader reader(file, Encoding::plain, first.data_offset);
    read_samples(reader, axes, order, result_.volume.samples);
  }

  const fs::path& path_;
  const VolumeChoice& choice_;
  VolumeFile result_;
};

}  // namespace

VolumeFile read_tiff(const fs::path& path, const VolumeChoice& choice) {
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  const bool is_file = !is_folder && fs::exists(path, error);
  TiffReader reader(path, choice);
  if (is_file) return reader.read_file(path);
  std::vector<fs::path> files = is_folder ? files_ending(path, {".tif", ".tiff"}) : files_matching(path);
  if (files.empty()) throw DataError(path.string() + ": no such file; check the path");
  files = in_order_of_numbers(std::move(files), path);
  return files.size() == 1 ? reader.read_file(files.front()) : reader.read_stack(files);
}

}  // namespace isobench
