#include "isobench/datasets/formats/nifti/nifti_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"

namespace isobench {

namespace {

constexpr int rgb = 128;
constexpr int rgba = 2304;

struct NiftiType {
  int code;
  SampleType type;
};

// The last three are those of SPM 99's ANALYZE files.
constexpr NiftiType nifti_types[] = {{2, SampleType::u8},     {4, SampleType::i16},   {8, SampleType::i32},
                                     {16, SampleType::f32},   {64, SampleType::f64},  {256, SampleType::i8},
                                     {512, SampleType::u16},  {768, SampleType::u32}, {1024, SampleType::i64},
                                     {1280, SampleType::u64}, {rgb, SampleType::u8},  {rgba, SampleType::u8},
                                     {130, SampleType::i8},   {132, SampleType::u16}, {136, SampleType::u32}};

/// What samples are that cannot be read; "" if the code is none of the format's.
std::string kind_of_type(int code) {
  switch (code) {
    case 1:
      return "single bits";
    case 32:
    case 1792:
    case 2048:
      return "complex numbers";
    case 1536:
      return "floating-point numbers of 128 bits";
    default:
      return "";
  }
}

/// Parts of a colour; 1 for other samples.
std::size_t parts_of_colour(const NiftiFields& fields) {
  return fields.datatype == rgb ? 3 : fields.datatype == rgba ? 4 : 1;
}

/// True if the header's intent says that samples are vectors, matrices or colours (codes of the format).
bool is_of_vectors(const NiftiFields& fields) {
  return (fields.intent >= 1004 && fields.intent <= 1007) || fields.intent == 2003 || fields.intent == 2004;
}

std::size_t part_of_colour(const NiftiFields& fields, const VolumeChoice& choice, const std::filesystem::path& path) {
  const std::size_t parts = parts_of_colour(fields);
  if (choice.component) return place_on_axis(choice.component, parts, "component", path);
  throw DataError(
      fmt::format("{}: its samples are colours; choose a part of them with --component: 0 red, 1 green, 2 blue{}",
                  path.string(), parts == 4 ? ", 3 opacity" : ""));
}

/// The results of a scale that keeps whole numbers whole, if T holds them all.
template <class T, class Source>
std::optional<Samples> whole_numbers(std::vector<Source>& values, double slope, double intercept) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  // Beyond 2^53 a double does not tell one whole number from the next.
  constexpr double exact = 9007199254740992.0;
  for (const Source value : {*least, *largest}) {
    const double result = slope * static_cast<double>(value) + intercept;
    const bool is_exact = std::abs(static_cast<double>(value)) <= exact && std::abs(result) <= exact;
    if (!is_exact || result < static_cast<double>(std::numeric_limits<T>::min()) ||
        result > static_cast<double>(std::numeric_limits<T>::max()))
      return std::nullopt;
  }
  const auto result = [&](Source value) { return static_cast<T>(slope * static_cast<double>(value) + intercept); };
  if constexpr (std::is_same_v<T, Source>) {  // no second array
    std::transform(values.begin(), values.end(), values.begin(), result);
    return std::move(values);
  } else {
    std::vector<T> results(values.size());
    std::transform(values.begin(), values.end(), results.begin(), result);
    return results;
  }
}

template <class Real, class Source>
Samples real_numbers(const std::vector<Source>& values, double slope, double intercept) {
  std::vector<Real> results;
  results.reserve(values.size());
  for (const Source value : values)
    results.push_back(static_cast<Real>(slope * static_cast<double>(value) + intercept));
  return results;
}

template <class Source>
Samples scaled_integers(std::vector<Source>& values, double slope, double intercept) {
  const bool is_whole = slope == std::floor(slope) && intercept == std::floor(intercept);
  if (is_whole && !values.empty()) {
    if (auto kept = whole_numbers<Source>(values, slope, intercept)) return *std::move(kept);
    if (auto short_ones = whole_numbers<std::int16_t>(values, slope, intercept)) return *std::move(short_ones);
    if (auto ints = whole_numbers<std::int32_t>(values, slope, intercept)) return *std::move(ints);
    if (auto longs = whole_numbers<std::int64_t>(values, slope, intercept)) return *std::move(longs);
  }
  // A float has 24 bits: neighbours stay apart by several of its steps, unless the intercept is large.
  using Real = RealOf<Source>;
  const double largest =
      std::abs(slope) * static_cast<double>(std::numeric_limits<Source>::max()) + std::abs(intercept);
  const bool fits = largest < std::numeric_limits<float>::max() && std::abs(slope) * (1 << 20) > largest;
  if (!fits) return real_numbers<double>(values, slope, intercept);
  return real_numbers<Real>(values, slope, intercept);
}

}  // namespace

SampleType nifti_sample_type(const NiftiFields& fields, const std::filesystem::path& path,
                             std::vector<std::string>& notes) {
  if (fields.kind == NiftiKind::analyze && fields.datatype == rgb) {
    throw DataError(path.string() +
                    ": its samples are colours, which ANALYZE files keep in more than one order; convert it to NIfTI");
  }
  for (const NiftiType& known : nifti_types) {
    if (known.code != fields.datatype) continue;
    if (fields.bits == 0) {
      notes.push_back(fmt::format("{}: its header states samples of 0 bits; those of its datatype {} are taken",
                                  path.string(), known.code));
      return known.type;
    }
    if (static_cast<std::size_t>(fields.bits) == 8 * bytes_of(known.type) * parts_of_colour(fields)) return known.type;
    throw DataError(
        fmt::format("{}: its samples have {} bits, which does not fit its datatype {}; copy or export it again",
                    path.string(), fields.bits, known.code));
  }
  const std::string kind = kind_of_type(fields.datatype);
  throw DataError(
      fmt::format("{}: its samples are {}, which cannot be read; convert it to a volume of integers or floats",
                  path.string(), kind.empty() ? fmt::format("of datatype {}", fields.datatype) : kind));
}

std::vector<FileAxis> nifti_axes(const NiftiFields& fields, const VolumeChoice& choice,
                                 const std::filesystem::path& path) {
  auto steps = static_cast<double>(fields.size(3));
  double components = 1.0;
  for (const std::size_t axis : {4U, 5U, 6U}) components *= static_cast<double>(std::max(fields.size(axis), 0LL));
  // Vectors belong to the fifth axis; some programs leave out the fourth one.
  if (components == 1.0 && is_of_vectors(fields)) std::swap(steps, components);
  std::vector<FileAxis> axes;
  const bool has_colours = parts_of_colour(fields) > 1;
  auto samples = static_cast<double>(parts_of_colour(fields));
  if (has_colours) axes.push_back({parts_of_colour(fields), part_of_colour(fields, choice, path)});
  for (const std::size_t axis : {0U, 1U, 2U}) {
    axes.push_back({static_cast<std::size_t>(size_in(static_cast<double>(fields.size(axis))))});
    samples *= static_cast<double>(fields.size(axis));
  }
  constexpr double most_samples = 1e15;  // a petabyte
  if (size_in(steps) == 0 || size_in(components) == 0 || !(samples * steps * components < most_samples)) {
    throw DataError(
        fmt::format("{}: {} steps and {} components cannot be; the header is damaged, copy or export it again",
                    path.string(), steps, components));
  }
  if (axes.back().size == 1 && fields.size(0) == 1 && fields.size(1) == 1 && steps * components > 1.0) {
    throw DataError(path.string() +
                    ": it holds no volume but values of a single place, as CIFTI files do; give a volume of the image");
  }
  const auto number = [](double size) { return static_cast<std::size_t>(size_in(size)); };
  axes.push_back({number(steps), place_on_axis(choice.step, number(steps), "step", path)});
  if (!has_colours) {
    axes.push_back({number(components), place_on_axis(choice.component, number(components), "component", path)});
  } else if (components > 1.0) {
    throw DataError(path.string() + ": its samples are vectors of colours; convert it to a volume of scalars");
  }
  return axes;
}

Samples nifti_scaled(Samples samples, const NiftiFields& fields, const std::filesystem::path& path,
                     std::vector<std::string>& notes) {
  // The format states that a slope of 0 means no scaling, and that colours have none.
  if (!std::isfinite(fields.slope) || fields.slope == 0.0 || parts_of_colour(fields) > 1) return samples;
  double intercept = fields.intercept;
  if (!std::isfinite(intercept)) {
    intercept = 0.0;
    notes.push_back(fmt::format("{}: the intercept of its samples is {}; 0 is taken", path.string(), fields.intercept));
  }
  if (fields.slope == 1.0 && intercept == 0.0) return samples;
  if (fields.kind == NiftiKind::analyze) {
    // Whoever is not SPM may have anything there.
    const double size = std::abs(fields.slope);
    const bool is_sane = size > 1e-20 && size < 1e20;
    notes.push_back(fmt::format(
        "{}: {} {:.9g}, which SPM's files keep in their header", path.string(),
        is_sane ? "its samples are multiplied by the factor" : "its samples are not multiplied by the factor",
        fields.slope));
    if (!is_sane) return samples;
  }
  return samples.visit([&](auto& values) -> Samples {
    using T = SampleOf<decltype(values)>;
    if constexpr (std::is_integral_v<T>) {
      return scaled_integers(values, fields.slope, intercept);
    } else {
      for (T& value : values) value = static_cast<T>(fields.slope * static_cast<double>(value) + intercept);
      return std::move(values);
    }
  });
}

}  // namespace isobench
