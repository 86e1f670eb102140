#include "isobench/datasets/formats/reading/header_values.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

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
  if (!(std::abs(lattice.direction.determinant()) > least_determinant)) {
    throw DataError(path.string() + ": its three axes lie nearly in a plane; correct the header");
  }
  if (!origin.allFinite()) throw DataError(path.string() + ": its origin is not a finite point; correct its header");
  lattice.origin = origin;
  lattice.space = space;
  return lattice;
}

Eigen::Matrix3d steps_of_slice(const Eigen::Vector3d& i, const Eigen::Vector3d& j) {
  Eigen::Matrix3d steps;
  steps << i, j, i.cross(j).normalized() * std::sqrt(i.norm() * j.norm());
  return steps;
}

long long size_in(double number) {
  const bool is_size = number >= 1.0 && number <= std::numeric_limits<int>::max() && number == std::floor(number);
  return is_size ? static_cast<long long>(number) : 0;
}

std::vector<double> all_numbers_in(const std::string& text, const std::filesystem::path& path,
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
  if (!trimmed(next).empty()) {
    throw DataError(fmt::format("{}: '{}' is '{}', but numbers are expected; correct its header", path.string(), what,
                                text.substr(0, 60)));
  }
  return numbers;
}

std::vector<double> numbers_in(const std::string& text, std::size_t count, const std::filesystem::path& path,
                               const std::string& what) {
  std::vector<double> numbers = all_numbers_in(text, path, what);
  if (numbers.size() != count) {
    throw DataError(fmt::format("{}: '{}' is '{}', but {} number{} {} expected; correct its header", path.string(),
                                what, text.substr(0, 60), count, count == 1 ? "" : "s", count == 1 ? "is" : "are"));
  }
  return numbers;
}

bool is_number(const std::string& text) {
  const std::string word = trimmed(text);
  char* end = nullptr;
  std::strtod(word.c_str(), &end);
  return !word.empty() && end == word.c_str() + word.size();
}

double unit_in_mm(const std::string& unit, const std::filesystem::path& path) {
  // The micro sign (U+00B5) and the Greek letter mu (U+03BC) look alike, and files have either.
  static const std::map<std::string, double> units = {{"", 1.0},
                                                      {"?", 1.0},
                                                      {"pixel", 1.0},
                                                      {"pixels", 1.0},
                                                      {"none", 1.0},
                                                      {"mm", 1.0},
                                                      {"millimeter", 1.0},
                                                      {"millimeters", 1.0},
                                                      {"millimetre", 1.0},
                                                      {"millimetres", 1.0},
                                                      {"cm", 10.0},
                                                      {"centimeter", 10.0},
                                                      {"centimeters", 10.0},
                                                      {"centimetre", 10.0},
                                                      {"centimetres", 10.0},
                                                      {"dm", 100.0},
                                                      {"m", 1e3},
                                                      {"meter", 1e3},
                                                      {"meters", 1e3},
                                                      {"metre", 1e3},
                                                      {"metres", 1e3},
                                                      {"um", 1e-3},
                                                      {"\u00b5m", 1e-3},
                                                      {"\u03bcm", 1e-3},
                                                      {"micrometer", 1e-3},
                                                      {"micrometers", 1e-3},
                                                      {"micrometre", 1e-3},
                                                      {"micrometres", 1e-3},
                                                      {"micron", 1e-3},
                                                      {"microns", 1e-3},
                                                      {"nm", 1e-6},
                                                      {"nanometer", 1e-6},
                                                      {"nanometers", 1e-6},
                                                      {"nanometre", 1e-6},
                                                      {"nanometres", 1e-6},
                                                      {"in", 25.4},
                                                      {"inch", 25.4},
                                                      {"inches", 25.4}};
  const auto found = units.find(lower_case(trimmed(unit)));
  if (found != units.end()) return found->second;
  throw DataError(
      fmt::format("{}: its unit of length '{}' is not known; export it with mm, cm, m or um", path.string(), unit));
}

}  // namespace isobench
