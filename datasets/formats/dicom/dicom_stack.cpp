#include "isobench/datasets/formats/dicom/dicom_stack.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

// Of the distance between slices: what positions may differ from equal distances. Files state them with two or three
// decimals.
constexpr double most_irregular = 0.01;
// mm: as much as rounding to two decimals does
constexpr double position_rounding = 0.0051;

struct PlacedSlice {
  DicomSlice slice;
  Eigen::Vector3d position;
  double along = 0.0;  ///< mm, of the position along the normal
};

/// The slices at one place.
using SlicePlace = std::vector<PlacedSlice>;

std::string file_of(const PlacedSlice& placed) {
  std::string name = placed.slice.image->path.filename().string();
  if (placed.slice.image->frames.size() > 1) name += fmt::format(" frame {}", placed.slice.frame->number + 1);
  return name;
}

class StackBuilder {
 public:
  StackBuilder(const DicomSeries& series, const std::filesystem::path& path) : series_(series), path_(path) {}

  DicomStack build(const VolumeChoice& choice) {
    const DicomFrame& first = *series_.slices.front().frame;
    check_spacing(first);
    std::vector<SlicePlace> places = places_of(placed_slices());
    drop_copies(places);
    const std::vector<PlacedSlice> slices = choose_phase(places, choice);
    for (const PlacedSlice& placed : slices) stack_.slices.push_back(placed.slice);
    const Eigen::Vector3d step = slices.size() > 1 ? common_step(slices) : lone_step(first);
    Eigen::Matrix3d direction;
    direction << axes_, step;
    const DicomLayout& layout = series_.first().layout;
    stack_.lattice =
        make_lattice(path_, {layout.columns, layout.rows, static_cast<long long>(slices.size())},
                     {first.spacing[0], first.spacing[1], step.norm()}, direction, slices.front().position, "LPS");
    note_shear(step);
    return std::move(stack_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw DataError(path_.string() + ": " + what); }
  void note(const std::string& what) { stack_.notes.push_back(path_.string() + ": " + what); }

  void check_spacing(const DicomFrame& first) {
    if (first.spacing_source == SpacingSource::none)
      fail("its slices state no PixelSpacing; convert them to NRRD or NIfTI with the spacing, or export them again");
    if (first.spacing_source == SpacingSource::imager) {
      note("PixelSpacing is missing; ImagerPixelSpacing, which is that of the detector, was taken");
    }
  }

  std::vector<PlacedSlice> placed_slices() {
    const DicomFrame& first = *series_.slices.front().frame;
    if (first.axes)
      axes_ = *first.axes;
    else
      note("ImageOrientationPatient is missing; axial slices were assumed");
    normal_ = Eigen::Vector3d(axes_.col(0)).cross(Eigen::Vector3d(axes_.col(1))).normalized();
    const auto lacks_position = [](const DicomSlice& slice) { return !slice.frame->position; };
    const auto lacks_location = [](const DicomSlice& slice) { return !slice.frame->location; };
    const auto& all = series_.slices;
    const auto lacking = std::find_if(all.begin(), all.end(), lacks_position);
    const bool by_location = lacking != all.end() && all.size() > 1;
    if (by_location) {
      const std::string name = lacking->image->path.filename().string();
      if (std::any_of(all.begin(), all.end(), lacks_location))
        fail(fmt::format("the slice {} does not state where it lies (no ImagePositionPatient); export it again", name));
      note(fmt::format("ImagePositionPatient is missing in {}; SliceLocation was taken, and 0, 0 within slices", name));
    } else if (lacking != all.end()) {
      note("ImagePositionPatient is missing; its first sample was put at 0, 0, 0");
    }
    std::vector<PlacedSlice> placed;
    for (const DicomSlice& slice : all) {
      const Eigen::Vector3d position = by_location ? Eigen::Vector3d(*slice.frame->location * normal_)
                                                   : slice.frame->position.value_or(Eigen::Vector3d::Zero());
      placed.push_back({slice, position, normal_.dot(position)});
    }
    return placed;
  }

  static std::vector<SlicePlace> places_of(std::vector<PlacedSlice> slices) {
    std::stable_sort(slices.begin(), slices.end(),
                     [](const PlacedSlice& a, const PlacedSlice& b) { return a.along < b.along; });
    const double range = slices.back().along - slices.front().along;
    // Far below the distance of neighbours, however many slices share a place.
    const double same_place = std::min(position_rounding, 0.01 * range / static_cast<double>(slices.size()));
    std::vector<SlicePlace> places;
    for (PlacedSlice& placed : slices) {
      if (places.empty() || placed.along - places.back().front().along > same_place) places.emplace_back();
      places.back().push_back(std::move(placed));
    }
    return places;
  }

  void drop_copies(std::vector<SlicePlace>& places) {
    std::size_t dropped = 0;
    for (SlicePlace& place : places) {
      for (std::size_t n = 1; n < place.size();) {
        const auto here = place.begin() + static_cast<std::ptrdiff_t>(n);
        const bool is_copy = std::any_of(place.begin(), here, [&](const auto& other) { return copies(other, *here); });
        if (is_copy) place.erase(here);
        n += is_copy ? 0 : 1;
        dropped += is_copy ? 1 : 0;
      }
    }
    if (dropped > 0) note(fmt::format("{} copies of slices were left out", dropped));
  }

  static bool copies(const PlacedSlice& a, const PlacedSlice& b) {
    const DicomImage& first = *a.slice.image;
    const DicomImage& second = *b.slice.image;
    if (&first == &second) return false;
    if (!first.instance.empty() && first.instance == second.instance)
      return a.slice.frame->number == b.slice.frame->number;
    return a.position == b.position && first.frames.size() == 1 && second.frames.size() == 1 &&
           same_pixels(first, second);
  }

  static bool same_pixels(const DicomImage& a, const DicomImage& b) {
    if (a.pixels.length != b.pixels.length || a.transfer_syntax != b.transfer_syntax || a.is_deflated) return false;
    std::ifstream first(a.path, std::ios::binary);
    std::ifstream second(b.path, std::ios::binary);
    first.seekg(static_cast<std::streamoff>(a.pixels.offset));
    second.seekg(static_cast<std::streamoff>(b.pixels.offset));
    std::vector<char> x(std::size_t{1} << 16U);
    std::vector<char> y(x.size());
    for (std::uintmax_t left = a.pixels.length; left > 0;) {
      const auto part = static_cast<std::streamsize>(std::min<std::uintmax_t>(left, x.size()));
      if (!first.read(x.data(), part) || !second.read(y.data(), part)) return false;
      if (!std::equal(x.begin(), x.begin() + part, y.begin())) return false;
      left -= static_cast<std::uintmax_t>(part);
    }
    return true;
  }

  /// One slice of each place.
  std::vector<PlacedSlice> choose_phase(std::vector<SlicePlace>& places, const VolumeChoice& choice) {
    const std::size_t count = places.front().size();
    const auto differs = [&](const SlicePlace& place) { return place.size() != count; };
    const auto other = std::find_if(places.begin(), places.end(), differs);
    if (other != places.end()) {
      const SlicePlace& more = other->size() > count ? *other : places.front();
      fail(fmt::format(
          "{} slices lie at {:.6g} mm along their normal ({} and {}), but {} at {:.6g} mm; remove what does "
          "not belong to the volume, or copy the series again",
          more.size(), more.front().along, file_of(more[0]), file_of(more[1]), std::min(other->size(), count),
          other->size() > count ? places.front().front().along : other->front().along));
    }
    const std::size_t step = place_on_axis(choice.step, count, "step", path_);
    if (count > 1) order_phases(places);
    std::vector<PlacedSlice> chosen;
    for (SlicePlace& place : places) chosen.push_back(std::move(place[step]));
    return chosen;
  }

  /// Orders the slices of each place by the first value that differs among all of them.
  void order_phases(std::vector<SlicePlace>& places) {
    for (const char* name :
         {"TemporalPositionIndex", "TemporalPositionIdentifier", "EchoTime", "DiffusionBValue", "TriggerTime",
          "AcquisitionNumber", "AcquisitionDateTime", "AcquisitionTime", "InstanceNumber"}) {
      const auto value = [name](const PlacedSlice& placed) {
        const auto found = placed.slice.frame->phases.find(name);
        return found == placed.slice.frame->phases.end() ? std::nullopt : std::optional(found->second);
      };
      const auto tells_apart = [&](SlicePlace& place) {
        if (!std::all_of(place.begin(), place.end(), [&](const PlacedSlice& p) { return value(p).has_value(); }))
          return false;
        std::stable_sort(place.begin(), place.end(),
                         [&](const PlacedSlice& a, const PlacedSlice& b) { return *value(a) < *value(b); });
        return std::adjacent_find(place.begin(), place.end(), [&](const PlacedSlice& a, const PlacedSlice& b) {
                 return *value(a) == *value(b);
               }) == place.end();
      };
      if (!std::all_of(places.begin(), places.end(), tells_apart)) continue;
      note(fmt::format("{} slices lie at each place; they were taken for steps in the order of {}",
                       places.front().size(), name));
      return;
    }
    // Frames of one file are in the order that its writer meant.
    const auto& first = places.front();
    const bool is_one_file = first.front().slice.image == first.back().slice.image;
    if (!is_one_file) {
      fail(
          fmt::format("{} slices lie at each place ({} and {}), and nothing in them says which belong together; remove "
                      "what does not belong to the volume",
                      first.size(), file_of(first[0]), file_of(first[1])));
    }
    for (SlicePlace& place : places) {
      std::stable_sort(place.begin(), place.end(), [](const PlacedSlice& a, const PlacedSlice& b) {
        return a.slice.frame->number < b.slice.frame->number;
      });
    }
    note(fmt::format("{} slices lie at each place; they were taken for steps in the order of their frames",
                     first.size()));
  }

  /// The step that leads from each slice to the next one.
  Eigen::Vector3d common_step(const std::vector<PlacedSlice>& slices) {
    check_gaps(slices);
    const auto last = static_cast<double>(slices.size() - 1);
    const Eigen::Vector3d step = (slices.back().position - slices.front().position) / last;
    const double distance = normal_.dot(step);
    const double tolerance = std::max(most_irregular * distance, std::min(position_rounding, 0.1 * distance));
    double most = 0.0;
    for (std::size_t k = 0; k < slices.size(); ++k) {
      const Eigen::Vector3d at = slices.front().position + static_cast<double>(k) * step;
      const Eigen::Vector3d error = slices[k].position - at;
      most = std::max(most, error.norm());
      if (error.norm() <= tolerance) continue;
      const bool is_shift = std::abs(normal_.dot(error)) <= tolerance;
      fail(fmt::format(
          "its slices do not lie on a lattice: {} is {:.3g} mm from where {}; convert the series to NRRD or "
          "NIfTI with a program that resamples it",
          file_of(slices[k]), error.norm(),
          is_shift ? "an equal shift within the slices would put it"
                   : fmt::format("an equal distance of {:.6g} mm would put it", distance)));
    }
    if (most > 0.001 * distance) {
      note(fmt::format(
          "positions of slices differ by up to {:.2g} mm from equal distances of {:.6g} mm, which were taken", most,
          distance));
    }
    return step;
  }

  void check_gaps(const std::vector<PlacedSlice>& slices) const {
    std::vector<double> distances;
    for (std::size_t k = 1; k < slices.size(); ++k) distances.push_back(slices[k].along - slices[k - 1].along);
    std::vector<double> sorted = distances;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double usual = *middle;
    const auto is_wide = [&](double distance) { return distance > 1.5 * usual; };
    const auto wide = std::count_if(distances.begin(), distances.end(), is_wide);
    const bool few_are_wide = wide <= std::max<std::ptrdiff_t>(1, std::ssize(distances) / 4);
    for (std::size_t k = 1; k < slices.size(); ++k) {
      const double distance = distances[k - 1];
      const double tolerance = std::max(2.0 * most_irregular * usual, std::min(2.0 * position_rounding, 0.1 * usual));
      if (std::abs(distance - usual) <= tolerance) continue;
      const std::string where =
          fmt::format("between {} at {:.6g} mm and {} at {:.6g} mm along their normal", file_of(slices[k - 1]),
                      slices[k - 1].along, file_of(slices[k]), slices[k].along);
      const double missing = std::round(distance / usual) - 1.0;
      if (few_are_wide && missing >= 1.0 &&
          std::abs(distance - (missing + 1.0) * usual) <= tolerance * (missing + 1.0)) {
        fail(fmt::format("{:.0f} slice{} {} missing {}, where others are {:.6g} mm apart; copy the whole series again",
                         missing, missing == 1.0 ? "" : "s", missing == 1.0 ? "is" : "are", where, usual));
      }
      fail(
          fmt::format("its slices are not equally far apart: {:.6g} mm {}, but {:.6g} mm elsewhere; convert the series "
                      "to NRRD or NIfTI with a program that resamples it",
                      distance, where, usual));
    }
  }

  Eigen::Vector3d lone_step(const DicomFrame& first) {
    const std::optional<double> distance = first.distance ? first.distance : first.thickness;
    if (!distance) note("it has one slice, and its thickness is not stated; 1 mm was taken");
    return distance.value_or(1.0) * normal_;
  }

  void note_shear(const Eigen::Vector3d& step) {
    const double angle = std::atan2(step.cross(normal_).norm(), step.dot(normal_)) * 180.0 / M_PI;
    if (angle > 0.05) {
      note(fmt::format("its slices are shifted against each other by {:.3g}° (a tilted gantry); the lattice is sheared",
                       angle));
    }
  }

  const DicomSeries& series_;
  const std::filesystem::path& path_;
  DicomStack stack_;
  Eigen::Matrix<double, 3, 2> axes_ = Eigen::Matrix<double, 3, 2>::Identity();
  Eigen::Vector3d normal_ = Eigen::Vector3d::UnitZ();
};

}  // namespace

DicomStack stack_slices(const DicomSeries& series, const VolumeChoice& choice, const std::filesystem::path& path) {
  return StackBuilder(series, path).build(choice);
}

}  // namespace isobench
