// Fuzz targets for the readers of volumes. Each writes the bytes to a file and reads it.
#include <algorithm>
#include <cmath>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/foundation/testing/fuzz_target.h"
#include "isobench/foundation/testing/test_files.h"

namespace isobench {

namespace {

/// By how much files can be compressed.
constexpr std::size_t most_deflation = 1032;
constexpr std::size_t most_bzip2 = std::size_t{1} << 20U;

/// What must hold for every volume that was read. In particular, it has no more samples than the file can hold:
/// `compression` times its bytes, and `free` samples whatever its size is.
void check_volume(const Volume& volume, std::size_t file_bytes, std::size_t compression = most_deflation,
                  std::size_t free = 0) {
  const Lattice& lattice = volume.lattice;
  require(*std::min_element(lattice.size.begin(), lattice.size.end()) >= 1, "a volume has nodes");
  require(volume.samples.size() == lattice.nodes(), "a volume has one sample a node");
  require(volume.samples.size() <= free + compression * file_bytes,
          "a file has no more samples than bytes, but for compression");
  require((lattice.spacing.array() > 0.0).all() && lattice.spacing.allFinite(), "spacings are positive");
  require(lattice.origin.allFinite() && lattice.direction.allFinite(), "a volume has a place in space");
}

/// Reads a file of so many bytes with each of several choices; files with vectors, series or segments need one. Returns
/// whether one was accepted.
bool read_with_choices(const std::filesystem::path& path, std::string_view bytes) {
  std::vector<VolumeChoice> choices(5);
  choices[1].step = 1;
  choices[2].component = 1;
  choices[3].step = 0;
  choices[3].component = 0;
  choices[4].array = "a";
  if (path.extension() == ".nrrd") {
    for (const char* segment : {"layer 1", "Segment_1", "2"}) choices.emplace_back().segment = segment;
  }
  const bool has_bzip2 = bytes.find("bz") != std::string_view::npos;
  bool accepted = false;
  for (const VolumeChoice& choice : choices) {
    accepted = accepts([&] {
                 const VolumeFile file = read_volume(path, choice);
                 check_volume(file.volume, bytes.size(), has_bzip2 ? most_bzip2 : most_deflation);
                 for (const std::string& note : file.notes)
                   require(note.starts_with(path.parent_path().string()), "a note names the file");
                 return true;
               }) ||
               accepted;
  }
  return accepted;
}

bool read(const std::string& name, std::string_view bytes) { return read_with_choices(fuzz_file(name, bytes), bytes); }

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// Writes the data files that headers in the corpus name.
void write_data_files() {
  static const bool once = [] {
    fuzz_file("data.raw", std::string(64, '\x07'));
    std::string numbers = "a line\n; ";
    for (int n = 0; n < 64; ++n) numbers += std::to_string(n) + " ";
    fuzz_file("data.txt", numbers);
    for (int n = 0; n < 8; ++n) fuzz_file("s" + std::to_string(n), std::string(16, '\x05'));
    // Ten bytes of a header, then 64 samples.
    fuzz_file("data.gz", deflated("0123456789" + std::string(64, '\x03'), true));
    return true;
  }();
  static_cast<void>(once);
}

}  // namespace

bool fuzz_nrrd(std::string_view bytes) {
  write_data_files();
  return read("volume.nrrd", bytes);
}

bool fuzz_metaimage(std::string_view bytes) {
  write_data_files();
  return read("volume.mha", bytes);
}

bool fuzz_inrimage(std::string_view bytes) { return read(is_gzip(bytes) ? "volume.inr.gz" : "volume.inr", bytes); }

/// A header without the mark of a single file is written to a file of its own, and the rest to the other one of a pair.
bool fuzz_nifti(std::string_view bytes) {
  constexpr std::size_t sizes[] = {348, 540};
  const bool second_version = bytes.size() > 6 && bytes[6] == '2';
  const std::size_t size = std::min(sizes[second_version ? 1 : 0], bytes.size());
  const bool is_pair = size > 345 && bytes[second_version ? 5 : 345] != '+' && !is_gzip(bytes);
  std::filesystem::path path;
  if (is_pair) {
    fuzz_file("volume.img", bytes.substr(size));
    path = fuzz_file("volume.hdr", bytes.substr(0, size));
  } else {
    path = fuzz_file(is_gzip(bytes) ? "volume.nii.gz" : "volume.nii", bytes);
  }
  return read_with_choices(path, bytes);
}

bool fuzz_mgh(std::string_view bytes) { return read("volume.mgz", bytes); }

bool fuzz_mrc(std::string_view bytes) { return read("volume.mrc", bytes); }

bool fuzz_vti(std::string_view bytes) { return read("volume.vti", bytes); }

/// The bytes are the only DICOM file of a folder. A nearly empty frame may be large.
bool fuzz_dicom(std::string_view bytes) {
  return accepts([&] {
    constexpr std::size_t largest_frame = std::size_t{1} << 26U;
    check_volume(read_volume(fuzz_file("volume.dcm", bytes)).volume, bytes.size(), 1032, largest_frame);
    return true;
  });
}

bool fuzz_tiff(std::string_view bytes) {
  return accepts([&] {
    constexpr std::size_t most_compression = std::size_t{1} << 16U;
    check_volume(read_volume(fuzz_file("volume.tif", bytes)).volume, bytes.size(), most_compression, most_compression);
    return true;
  });
}

/// The input begins with the layout: two bytes for each of the three sizes, and one each for the type, the byte order
/// and the number of files.
bool fuzz_raw(std::string_view bytes) {
  constexpr std::size_t header = 9;
  if (bytes.size() < header) return false;
  const auto at = [&](std::size_t n) { return static_cast<int>(static_cast<unsigned char>(bytes[n])); };
  RawLayout layout;
  // The second byte sets the upper bits, so that small, very large and negative sizes are all within reach.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    layout.size[axis] = at(2 * axis) | static_cast<int>(static_cast<unsigned>(at(2 * axis + 1)) << 24U);
  }
  layout.type = static_cast<SampleType>(at(6) % 10);
  layout.order = at(7) % 2 == 0 ? ByteOrder::little : ByteOrder::big;
  const int count = at(8) % 4;
  const std::string_view data = bytes.substr(header);
  std::vector<std::filesystem::path> files;
  for (int n = 0; n < count; ++n) {
    const std::size_t each = data.size() / static_cast<std::size_t>(count);
    const std::size_t begin = each * static_cast<std::size_t>(n);
    files.push_back(fuzz_file("slice" + std::to_string(n), data.substr(begin, n + 1 < count ? each : data.npos)));
  }
  return accepts([&] {
    check_volume(read_raw(files, layout), bytes.size());
    return true;
  });
}

}  // namespace isobench
