#include "isobench/datasets/formats/dicom/read_dicom.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "isobench/datasets/formats/dicom/dicom_elements.h"
#include "isobench/datasets/formats/dicom/dicom_image.h"
#include "isobench/datasets/formats/dicom/dicom_samples.h"
#include "isobench/datasets/formats/dicom/dicom_series.h"
#include "isobench/datasets/formats/dicom/dicom_stack.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 200000;
constexpr int deepest_folder = 8;

struct FoundFiles {
  std::vector<fs::path> dicom;
  std::size_t others = 0;
};

void add_file(const fs::path& path, FoundFiles& found) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return;
  if (!is_dicom_file(path))
    ++found.others;
  else if (path.filename() != "DICOMDIR")
    found.dicom.push_back(path);
}

/// The files of a folder, and of those in it down to the depth given.
FoundFiles files_below(const fs::path& folder, int depth) {
  FoundFiles found;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry.depth() >= depth) entry.disable_recursion_pending();
    add_file(entry->path(), found);
    if (found.dicom.size() > most_files) {
      throw DataError(
          fmt::format("{}: more than {} DICOM files; give the folder of one study", folder.string(), most_files));
    }
  }
  if (error) throw DataError(folder.string() + ": cannot be read: " + error.message());
  std::sort(found.dicom.begin(), found.dicom.end());
  return found;
}

/// A path in the working folder has no folder of its own.
fs::path folder_of_file(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

FoundFiles files_of_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder / "DICOMDIR", error)) {
    FoundFiles found = files_below(folder, 0);
    if (!found.dicom.empty()) return found;
  }
  return files_below(folder, deepest_folder);
}

/// The images of files, of which `wanted` must be one unless it is empty.
class ImageList {
 public:
  ImageList(const FoundFiles& found, const fs::path& wanted) : others_(found.others) {
    for (const fs::path& file : found.dicom) {
      std::optional<DicomImage> image = read_dicom_image(file);
      if (image) {
        images.push_back(*std::move(image));
      } else if (file == wanted) {
        throw DataError(file.string() + ": a DICOM file without an image; give one of the images, or their folder");
      } else {
        ++without_image_;
      }
    }
  }

  /// A note on what was passed over; "" if nothing was.
  std::string note() const {
    std::string text;
    if (others_ > 0) text += fmt::format("{} file{} other than DICOM", others_, others_ == 1 ? "" : "s");
    if (without_image_ > 0)
      text += fmt::format("{}{} DICOM file{} without an image", text.empty() ? "" : " and ", without_image_,
                          without_image_ == 1 ? "" : "s");
    return text.empty() ? "" : text + " passed over";
  }

  std::vector<DicomImage> images;

 private:
  std::size_t others_ = 0;
  std::size_t without_image_ = 0;
};

/// The component that is read.
std::size_t component_of(const DicomImage& image, const VolumeChoice& choice, const fs::path& path) {
  const auto count = static_cast<std::size_t>(image.layout.components);
  if (image.photometric == "PALETTE COLOR") {
    throw DataError(path.string() +
                    ": its samples are places in a table of colours; convert it to grey or to RGB, or to NRRD");
  }
  const bool is_rgb = image.photometric == "RGB" || image.photometric == "YBR_RCT" || image.photometric == "YBR_ICT";
  if (count > 1 && !is_rgb) {
    throw DataError(fmt::format("{}: its colours are stored as {}; convert it to RGB, e.g. by dcmconv or gdcmimg",
                                path.string(), image.photometric.substr(0, 32)));
  }
  return place_on_axis(choice.component, count, "component", path);
}

void check_readable(const DicomSeries& series, const fs::path& path) {
  if (series.first().image_type.find("MOSAIC") != std::string::npos) {
    throw DataError(
        path.string() +
        ": its images are mosaics of slices, as Siemens writes them; convert it to NIfTI, e.g. by dcm2niix");
  }
  for (const DicomSlice& slice : series.slices) {
    if (!slice.image->problem.empty()) throw DataError(slice.image->path.string() + ": " + slice.image->problem);
  }
}

}  // namespace

bool has_dicom_files(const fs::path& folder) { return !files_of_folder(folder).dicom.empty(); }

VolumeFile read_dicom(const fs::path& path, const VolumeChoice& choice) {
  std::error_code error;
  const bool is_folder = fs::is_directory(path, error);
  const bool is_directory_file = !is_folder && path.filename() == "DICOMDIR";
  const bool is_one_file = !is_folder && !is_directory_file;
  if (is_one_file && !is_dicom_file(path))
    throw DataError(path.string() + ": not a DICOM file; give it the ending of its own format, or copy it again");
  const FoundFiles found =
      is_one_file ? files_below(folder_of_file(path), 0) : files_of_folder(is_folder ? path : folder_of_file(path));
  const fs::path wanted = is_one_file ? folder_of_file(path) / path.filename() : fs::path();
  const ImageList list(found, wanted);
  if (list.images.empty())
    throw DataError(path.string() + ": no DICOM file with an image is there; give another folder");

  const std::vector<DicomSeries> all = series_of(list.images);
  const DicomSeries& series = choose_series(all, choice.series, wanted, path);
  const DicomImage& first = series.first();
  check_readable(series, path);
  const std::size_t component = component_of(first, choice, path);
  DicomStack stack = stack_slices(series, choice, path);
  const auto note = [&](const std::string& what) { stack.notes.push_back(path.string() + ": " + what); };
  if (is_one_file && stack.slices.size() > 1 && first.frames.size() == 1)
    note(fmt::format("the {} slices of its series were read from its folder", stack.slices.size()));
  if (!is_one_file && !list.note().empty()) note(list.note());
  if (first.photometric == "MONOCHROME1")
    note("small values are bright in it (MONOCHROME1); values are as in the file");
  if (first.has_padding)
    note("it has a PixelPaddingValue for what lies outside the scan; these samples stay as they are");
  Samples samples = read_dicom_samples(stack, component);
  return {{std::move(stack.lattice), std::move(samples)}, std::move(stack.notes)};
}

}  // namespace isobench
