#include "isobench/datasets/formats/dicom/dicom_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

// Scanners round directions and spacings, and not always in the same way.
constexpr double same_direction = 1e-3;
constexpr double same_spacing = 1e-3;  // relative

bool same_series(const DicomSlice& a, const DicomSlice& b) {
  const DicomFrame& f = *a.frame;
  const DicomFrame& g = *b.frame;
  if (a.image->series != b.image->series || a.image->layout != b.image->layout) return false;
  if (a.image->image_type != b.image->image_type || f.axes.has_value() != g.axes.has_value()) return false;
  if (f.axes && !((*f.axes - *g.axes).cwiseAbs().maxCoeff() <= same_direction)) return false;
  return f.spacing_source == g.spacing_source &&
         ((f.spacing - g.spacing).array().abs() <= same_spacing * f.spacing.array()).all();
}

double number_of(const DicomSeries& series) { return std::strtod(series.first().number.c_str(), nullptr); }

std::string description_of(const DicomSeries& series, std::size_t place, bool with_uid) {
  const DicomImage& image = series.first();
  std::string text = fmt::format("#{}", place + 1);
  if (!image.number.empty()) text += fmt::format(" number {}", image.number.substr(0, 8));
  if (!image.description.empty()) text += fmt::format(" '{}'", image.description.substr(0, 24));
  if (with_uid && !image.series.empty()) text += fmt::format(" UID {}", image.series.substr(0, 64));
  const std::size_t count = series.slices.size();
  return text +
         fmt::format(" ({} slice{} of {} × {})", count, count == 1 ? "" : "s", image.layout.columns, image.layout.rows);
}

std::string list_of(const std::vector<DicomSeries>& all, const std::vector<std::size_t>& places) {
  // A message has room for about 1000 bytes; a UID takes up to 64.
  constexpr std::size_t most_with_uid = 6;
  constexpr std::size_t most = 12;
  std::string list;
  for (std::size_t n = 0; n < std::min(places.size(), most); ++n) {
    list += (n == 0 ? "" : ", ") + description_of(all[places[n]], places[n], places.size() <= most_with_uid);
  }
  if (places.size() > most) list += fmt::format(" and {} more", places.size() - most);
  return list;
}

bool is_meant(const DicomSeries& series, std::size_t place, const std::string& choice, int way) {
  const DicomImage& image = series.first();
  switch (way) {
    case 0:
      return choice == fmt::format("#{}", place + 1);
    case 1:
      return choice == image.number;
    case 2:
      return choice == image.series;
    default:
      return lower_case(image.description).starts_with(lower_case(choice));
  }
}

constexpr int ways_to_choose = 4;

}  // namespace

std::vector<DicomSeries> series_of(const std::vector<DicomImage>& images) {
  std::vector<DicomSeries> all;
  for (const DicomImage& image : images) {
    for (const DicomFrame& frame : image.frames) {
      const DicomSlice slice{&image, &frame};
      // Neighbours mostly belong together, so the latest series is tried first.
      const auto found = std::find_if(all.rbegin(), all.rend(), [&](const DicomSeries& series) {
        return same_series(series.slices.front(), slice);
      });
      if (found == all.rend())
        all.push_back({{slice}});
      else
        found->slices.push_back(slice);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const DicomSeries& a, const DicomSeries& b) {
    return std::pair(number_of(a), a.first().series) < std::pair(number_of(b), b.first().series);
  });
  return all;
}

const DicomSeries& choose_series(const std::vector<DicomSeries>& all, const std::string& choice,
                                 const std::filesystem::path& wanted, const std::filesystem::path& path) {
  std::vector<std::size_t> places(all.size());
  std::iota(places.begin(), places.end(), 0U);
  const auto holds_wanted = [&](std::size_t place) {
    return std::any_of(all[place].slices.begin(), all[place].slices.end(),
                       [&](const DicomSlice& slice) { return slice.image->path == wanted; });
  };
  std::vector<std::size_t> meant;
  if (!choice.empty()) {
    for (int way = 0; way < ways_to_choose && meant.empty(); ++way) {
      std::copy_if(places.begin(), places.end(), std::back_inserter(meant),
                   [&](std::size_t place) { return is_meant(all[place], place, choice, way); });
    }
    if (meant.empty()) {
      throw DataError(fmt::format("{}: there is no series '{}'; choose with --series #N, a number or a UID among: {}",
                                  path.string(), choice.substr(0, 64), list_of(all, places)));
    }
  } else if (wanted.empty()) {
    meant = places;
  } else {
    std::copy_if(places.begin(), places.end(), std::back_inserter(meant), holds_wanted);
  }
  if (meant.size() == 1) return all[meant.front()];
  throw DataError(
      fmt::format("{}: {} series of images can be meant; choose one with --series #N, a number or a UID: {}",
                  path.string(), meant.size(), list_of(all, meant)));
}

}  // namespace isobench
