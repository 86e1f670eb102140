#include "isobench/datasets/formats/read_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>
#include <utility>

#include "isobench/datasets/formats/dicom/dicom_elements.h"
#include "isobench/datasets/formats/dicom/read_dicom.h"
#include "isobench/datasets/formats/folder_contents.h"
#include "isobench/datasets/formats/metaimage/read_metaimage.h"
#include "isobench/datasets/formats/mgh/read_mgh.h"
#include "isobench/datasets/formats/mrc/read_mrc.h"
#include "isobench/datasets/formats/nifti/read_nifti.h"
#include "isobench/datasets/formats/nrrd/read_nrrd.h"
#include "isobench/datasets/formats/read_inrimage.h"
#include "isobench/datasets/formats/tiff/numbered_files.h"
#include "isobench/datasets/formats/tiff/read_tiff.h"
#include "isobench/datasets/formats/vtk/read_vti.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

using Reader = VolumeFile (*)(const std::filesystem::path&, const VolumeChoice&);

struct Format {
  const char* ending;
  const char* name;
  Reader reader;
  KnownChoices known;
};

constexpr KnownChoices time_steps{.step = true};
constexpr KnownChoices time_and_components{.step = true, .component = true};
constexpr KnownChoices segments_too{.step = true, .component = true, .segment = true};
constexpr KnownChoices named_arrays{.component = true, .array = true};

constexpr KnownChoices series_too{.step = true, .component = true, .series = true};

constexpr Format formats[] = {{".nrrd", "NRRD", read_nrrd, segments_too},
                              {".nhdr", "NRRD", read_nrrd, segments_too},
                              {".mhd", "MetaImage", read_metaimage, time_and_components},
                              {".mha", "MetaImage", read_metaimage, time_and_components},
                              {".nii", "NIfTI", read_nifti, time_and_components},
                              {".nii.gz", "NIfTI", read_nifti, time_and_components},
                              {".hdr", "NIfTI", read_nifti, time_and_components},
                              {".hdr.gz", "NIfTI", read_nifti, time_and_components},
                              {".img", "NIfTI", read_nifti, time_and_components},
                              {".img.gz", "NIfTI", read_nifti, time_and_components},
                              {".mgh", "MGH", read_mgh, time_steps},
                              {".mgz", "MGH", read_mgh, time_steps},
                              {".mgh.gz", "MGH", read_mgh, time_steps},
                              {".mrc", "MRC", read_mrc, time_steps},
                              {".map", "MRC", read_mrc, time_steps},
                              {".ccp4", "MRC", read_mrc, time_steps},
                              {".rec", "MRC", read_mrc, time_steps},
                              {".st", "MRC", read_mrc, time_steps},
                              {".mrc.gz", "MRC", read_mrc, time_steps},
                              {".map.gz", "MRC", read_mrc, time_steps},
                              {".ccp4.gz", "MRC", read_mrc, time_steps},
                              {".vti", "VTI", read_vti, named_arrays},
                              {".inr", "INRIMAGE", read_inrimage, {}},
                              {".inr.gz", "INRIMAGE", read_inrimage, {}},
                              {".tif", "TIFF", read_tiff, time_and_components},
                              {".tiff", "TIFF", read_tiff, time_and_components},
                              {".dcm", "DICOM", read_dicom, series_too},
                              {".ima", "DICOM", read_dicom, series_too}};

const Format& format_named(const std::string& ending) {
  return *std::find_if(std::begin(formats), std::end(formats),
                       [&](const Format& format) { return format.ending == ending; });
}

/// By the ending; DICOM files often have none, or one that is a number.
const Format& format_of_file(const std::filesystem::path& path) {
  const std::string name = lower_case(path.filename().string());
  std::string known;
  for (const Format& format : formats) {
    if (name.ends_with(format.ending)) return format;
    known += std::string(known.empty() ? "" : ", ") + format.ending;
  }
  if (is_dicom_file(path)) return format_named(".dcm");
  if (is_flat_image(path)) {
    throw DataError(path.string() + ": stacks of PNG, JPEG or BMP images are not read; convert them to TIFF or NRRD");
  }
  throw DataError(fmt::format("{}: no volume format has this ending; known are {}, and DICOM files with any ending",
                              path.string(), known));
}

const Format& format_of_folder(const std::filesystem::path& path) {
  if (has_dicom_files(path)) return format_named(".dcm");
  if (!files_ending(path, {".tif", ".tiff"}).empty()) return format_named(".tif");
  throw DataError(fmt::format("{}: {}; give a volume file, or a folder of DICOM or TIFF files", path.string(),
                              text_of_contents(path)));
}

/// Checks that the path leads to something.
const Format& format_of(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return format_of_folder(path);
  const Format& format = format_of_file(path);
  if (!std::filesystem::exists(path, error)) {
    if (format.reader == read_tiff && is_file_pattern(path)) return format;
    throw DataError(path.string() + ": no such file; check the path");
  }
  if (!std::filesystem::is_regular_file(path, error))
    throw DataError(path.string() + ": not a file; give the path of a volume file");
  if (std::filesystem::file_size(path, error) == 0) throw DataError(path.string() + ": empty; copy or export it again");
  return format;
}

void check_choice(const VolumeChoice& choice, const Format& format, const std::filesystem::path& path) {
  const auto check = [&](bool is_made, bool is_known, const char* what) {
    if (!is_made || is_known) return;
    throw DataError(fmt::format("{}: no {} can be chosen in a file of the format {}; leave out --{}", path.string(),
                                what, format.name, what));
  };
  check(choice.step.has_value(), format.known.step, "step");
  check(choice.component.has_value(), format.known.component, "component");
  check(!choice.array.empty(), format.known.array, "array");
  check(!choice.segment.empty(), format.known.segment, "segment");
  check(!choice.series.empty(), format.known.series, "series");
}

}  // namespace

std::string volume_formats_text() {
  std::string text;
  std::string name;
  for (const Format& format : formats) {
    if (format.name != name) text += fmt::format("{}{} (", text.empty() ? "" : "), ", format.name);
    text += fmt::format("{}{}", format.name == name ? ", " : "", format.ending);
    name = format.name;
  }
  return text + ")";
}

VolumeFile read_volume(const std::filesystem::path& path, const VolumeChoice& choice) {
  const Format& format = format_of(path);
  check_choice(choice, format, path);
  try {
    return format.reader(path, choice);
  } catch (const std::bad_alloc&) {
    throw DataError(path.string() + ": its volume does not fit into memory; crop or subsample it first");
  }
}

}  // namespace isobench
