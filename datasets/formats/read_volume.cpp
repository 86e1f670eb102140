#include "isobench/datasets/formats/read_volume.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "isobench/datasets/formats/readers.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

using Reader = Volume (*)(const std::filesystem::path&);

struct Format {
  const char* ending;
  Reader reader;
};

constexpr Format formats[] = {{".nrrd", read_nrrd},     {".nhdr", read_nrrd},    {".mhd", read_metaimage},
                              {".mha", read_metaimage}, {".nii", read_nifti},    {".nii.gz", read_nifti},
                              {".vti", read_vti},       {".inr", read_inrimage}, {".inr.gz", read_inrimage}};

Reader reader_for(const std::filesystem::path& path) {
  const std::string name = lower_case(path.filename().string());
  std::string known;
  for (const Format& format : formats) {
    if (name.ends_with(format.ending)) return format.reader;
    known += std::string(known.empty() ? "" : ", ") + format.ending;
  }
  throw DataError(fmt::format("{}: no volume format has this ending; known are {}", path.string(), known));
}

}  // namespace

Volume read_volume(const std::filesystem::path& path) {
  const Reader reader = reader_for(path);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw DataError(path.string() + ": no such file; check the path");
  if (!std::filesystem::is_regular_file(path, error))
    throw DataError(path.string() + ": not a file; give the path of a volume file");
  if (std::filesystem::file_size(path, error) == 0) throw DataError(path.string() + ": empty; copy or export it again");
  Volume volume;
  try {
    volume = reader(path);
  } catch (const std::bad_alloc&) {
    throw DataError(path.string() + ": its volume does not fit into memory; crop or subsample it first");
  }
  try {
    check_finite(volume);
  } catch (const DataError& not_finite) {
    throw DataError(fmt::format("{}: {}", path.string(), not_finite.what()));
  }
  return volume;
}

Lattice make_lattice(const std::filesystem::path& path, const std::array<long long, 3>& size,
                     const Eigen::Vector3d& spacing, const Eigen::Matrix3d& direction, const Eigen::Vector3d& origin,
                     const std::string& space) {
  Lattice lattice;
  long long nodes = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    // 2^40 samples take at least 1 TiB: a header that states more is damaged.
    if (size[a] < 1 || size[a] > std::numeric_limits<int>::max() || nodes > (1LL << 40) / size[a]) {
      throw DataError(fmt::format(
          "{}: its size {} × {} × {} is not that of a 3-D volume; the header is damaged, copy or export it again",
          path.string(), size[0], size[1], size[2]));
    }
    nodes *= size[a];
    lattice.size[a] = static_cast<int>(size[a]);
    const double length = direction.col(axis).norm();
    if (!(std::isfinite(length) && length > 0.0 && std::isfinite(spacing[axis]) && spacing[axis] > 0.0)) {
      throw DataError(
          fmt::format("{}: axis {}: its spacing and the length of its direction must be > 0; correct the header",
                      path.string(), axis));
    }
    lattice.spacing[axis] = spacing[axis];
    lattice.direction.col(axis) = direction.col(axis) / length;
  }
  // The rest of the program measures lengths along perpendicular axes. 1e-3 (0.06°) allows for rounding in headers.
  const Eigen::Matrix3d product = lattice.direction.transpose() * lattice.direction;
  if (!((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-3)) {
    throw DataError(path.string() + ": its axes are not perpendicular; resample it to a rectangular lattice first");
  }
  if (!origin.allFinite()) throw DataError(path.string() + ": its origin is not a finite point; correct its header");
  lattice.origin = origin;
  lattice.space = space;
  return lattice;
}

std::vector<double> numbers_in(const std::string& text, std::size_t count, const std::filesystem::path& path,
                               const std::string& what) {
  std::string plain = text;
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::vector<double> numbers;
  const char* next = plain.c_str();
  for (char* end = nullptr;; next = end) {
    const double number = std::strtod(next, &end);
    if (end == next) break;
    numbers.push_back(number);
  }
  if (numbers.size() != count || !trimmed(next).empty()) {
    throw DataError(fmt::format("{}: '{}' is '{}', but {} number{} {} expected; correct its header", path.string(),
                                what, text.substr(0, 60), count, count == 1 ? "" : "s", count == 1 ? "is" : "are"));
  }
  return numbers;
}

double unit_in_mm(const std::string& unit, const std::filesystem::path& path) {
  if (unit.empty() || unit == "mm" || unit == "MM" || unit == "?") return 1.0;
  if (unit == "cm") return 10.0;
  if (unit == "m") return 1000.0;
  if (unit == "um" || unit == "µm" || unit == "microns") return 1e-3;
  throw DataError(
      fmt::format("{}: its unit of length '{}' is not known; export it with mm, cm, m or um", path.string(), unit));
}

}  // namespace isobench
