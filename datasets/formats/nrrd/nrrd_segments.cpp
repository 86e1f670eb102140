#include "isobench/datasets/formats/nrrd/nrrd_segments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <map>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

/// The values of the pairs "Segment12_Name" and so on, by number and by what follows "_".
std::map<long, std::map<std::string, std::string>> segment_pairs(const NrrdHeader& header) {
  std::map<long, std::map<std::string, std::string>> segments;
  const std::string prefix = "Segment";
  for (const auto& [key, value] : header.pairs) {
    if (!key.starts_with(prefix)) continue;
    long number = 0;
    const auto [rest, error] = std::from_chars(key.data() + prefix.size(), key.data() + key.size(), number);
    if (error != std::errc() || rest == key.data() + key.size() || *rest != '_' || number < 0) continue;
    segments[number][std::string(rest + 1, key.data() + key.size())] = trimmed(value);
  }
  return segments;
}

std::string labelled(const NrrdSegment& segment, bool with_layer) {
  const std::string layer = with_layer ? fmt::format(" in layer {}", segment.layer) : std::string();
  return fmt::format("'{}' ({}{})", segment.name, segment.label, layer);
}

std::string list_of(const std::vector<NrrdSegment>& segments, bool with_layer) {
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t n = 0; n < std::min(segments.size(), most); ++n)
    list += (n == 0 ? "" : ", ") + labelled(segments[n], with_layer);
  return segments.size() > most ? list + fmt::format(" and {} more", segments.size() - most) : list;
}

/// The segments for which `is_meant` holds.
template <class IsMeant>
std::vector<NrrdSegment> segments_where(const std::vector<NrrdSegment>& segments, IsMeant&& is_meant) {
  std::vector<NrrdSegment> found;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(found), is_meant);
  return found;
}

/// By name, else by ID, else by label.
std::vector<NrrdSegment> segments_called(const std::vector<NrrdSegment>& segments, const std::string& choice) {
  std::vector<NrrdSegment> found = segments_where(segments, [&](const auto& one) { return one.name == choice; });
  if (found.empty()) found = segments_where(segments, [&](const auto& one) { return one.id == choice; });
  if (found.empty() && is_number(choice)) {
    const double label = std::strtod(choice.c_str(), nullptr);
    found = segments_where(segments, [&](const auto& one) { return one.label == label; });
  }
  return found;
}

/// The layer that "layer N" names.
std::optional<std::size_t> layer_in(const std::string& choice, std::size_t layers) {
  const std::string prefix = "layer ";
  if (!choice.starts_with(prefix)) return std::nullopt;
  std::size_t layer = 0;
  const char* const end = choice.data() + choice.size();
  const auto [rest, error] = std::from_chars(choice.data() + prefix.size(), end, layer);
  return error == std::errc() && rest == end && layer < layers ? std::optional(layer) : std::nullopt;
}

[[noreturn]] void throw_unknown(const NrrdHeader& header, const std::vector<NrrdSegment>& segments, std::size_t layers,
                                const std::string& choice) {
  std::vector<std::string> names;
  for (const NrrdSegment& segment : segments) {
    names.push_back(segment.name);
    names.push_back(segment.id);
  }
  for (std::size_t layer = 0; layer < std::min<std::size_t>(layers, 100); ++layer)
    names.push_back(fmt::format("layer {}", layer));
  const std::string nearest = nearest_name(choice, names);
  throw DataError(fmt::format(
      "{}: it has no segment '{}'; {}", header.path.string(), choice,
      nearest.empty() ? "its segments are " + list_of(segments, layers > 1) : "did you mean '" + nearest + "'?"));
}

SegmentChoice without_choice(NrrdHeader& header, const std::vector<NrrdSegment>& segments, std::size_t layers) {
  if (layers > 1) {
    throw DataError(fmt::format(
        "{}: its segments overlap and lie in {} layers; choose one with --segment, or all of a layer with --segment "
        "'layer 0' to 'layer {}': {}",
        header.path.string(), layers, layers - 1, list_of(segments, true)));
  }
  header.note(fmt::format("its segments are {}; --segment chooses one", list_of(segments, false)));
  return {};
}

}  // namespace

std::vector<NrrdSegment> nrrd_segments(const NrrdHeader& header, std::size_t layers) {
  const auto pairs = segment_pairs(header);
  std::vector<NrrdSegment> segments;
  for (const auto& [number, values] : pairs) {
    const auto value = [&values = values](const char* key) {
      const auto found = values.find(key);
      return found == values.end() ? std::string() : found->second;
    };
    // Before Slicer 4.11, each segment had a layer of its own, and its samples were 1.
    const bool own_layers = layers == pairs.size();
    NrrdSegment segment{value("Name"), value("ID"), 1.0, own_layers ? segments.size() : 0};
    if (!value("LabelValue").empty())
      segment.label =
          numbers_in(value("LabelValue"), 1, header.path, fmt::format("Segment{}_LabelValue", number)).front();
    if (!value("Layer").empty()) {
      const double layer = numbers_in(value("Layer"), 1, header.path, fmt::format("Segment{}_Layer", number)).front();
      if (!(layer >= 0.0 && layer < static_cast<double>(layers))) {
        throw DataError(
            fmt::format("{}: its segment '{}' lies in layer {}, but the first of its {} layers is 0; export it "
                        "again",
                        header.path.string(), segment.name, layer, layers));
      }
      segment.layer = static_cast<std::size_t>(layer);
    }
    if (segment.name.empty()) segment.name = segment.id;
    segments.push_back(std::move(segment));
  }
  return segments;
}

SegmentChoice choose_segment(NrrdHeader& header, const std::vector<NrrdSegment>& segments, std::size_t layers,
                             const std::string& choice) {
  if (choice.empty()) return without_choice(header, segments, layers);
  const std::vector<NrrdSegment> found = segments_called(segments, choice);
  if (found.size() == 1) return {found.front().layer, found.front().label};
  if (found.size() > 1) {
    std::string ids;
    for (const NrrdSegment& segment : found) ids += (ids.empty() ? "'" : ", '") + segment.id + "'";
    throw DataError(fmt::format("{}: it has {} segments '{}'; choose one by its ID: {}", header.path.string(),
                                found.size(), choice, ids));
  }
  const std::optional<std::size_t> layer = layer_in(choice, layers);
  if (!layer) throw_unknown(header, segments, layers, choice);
  return {*layer, std::nullopt};
}

Samples is_label(const Samples& samples, double label) {
  return samples.visit([&](const auto& values) -> Samples {
    std::vector<std::uint8_t> inside(values.size());
    for (std::size_t n = 0; n < values.size(); ++n) inside[n] = static_cast<double>(values[n]) == label ? 1 : 0;
    return inside;
  });
}

}  // namespace isobench
