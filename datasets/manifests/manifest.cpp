#include "isobench/datasets/manifests/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/datasets/manifests/dataset_names.h"
#include "isobench/datasets/manifests/manifest_generated.h"
#include "isobench/datasets/manifests/manifest_steps.h"
#include "isobench/datasets/manifests/manifest_values.h"
#include "isobench/datasets/phantoms/phantoms.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/names.h"
#include "isobench/foundation/sha256.h"
#include "isobench/foundation/toml.h"

namespace isobench {

namespace {

/// Raised whenever a preparation step or a phantom gives other results, so that no earlier result is reused.
constexpr int preparation_revision = 3;

std::string string_or(const TomlValue& table, const char* key, const std::string& otherwise = "") {
  const auto value = table.find(key);
  return value ? value->as_string() : otherwise;
}

/// A relative path. It must not lead out of its folder, must not look like an option to the programs that unpack
/// packages, and must not be longer than a file system allows.
std::filesystem::path parse_relative(const TomlValue& value) {
  const std::string text = value.as_string();
  std::filesystem::path path(text);
  const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
  if (path.empty() || path.is_absolute() || climbs) {
    throw UsageError(value.place(), fmt::format("'{}' is not a relative path without '..'; give one", text));
  }
  const bool long_part =
      std::any_of(path.begin(), path.end(), [](const auto& part) { return part.string().size() > 200; });
  if (text.front() == '-' || long_part || text.size() > 1000 || printable(text) != text) {
    throw UsageError(value.place(), fmt::format("'{}' cannot be the path of a file: it begins with '-', is too long or "
                                                "has unprintable characters; rename it",
                                                text));
  }
  return path;
}

/// A package's name as Debian's policy (5.6.1) defines it. It is given to apt-get, so it must not look like an option.
ManifestPackage parse_package(const TomlValue& value, const std::optional<TomlValue>& archive) {
  ManifestPackage package{value.as_string(), archive ? parse_relative(*archive).string() : ""};
  const bool letters = package.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789+-.") == std::string::npos;
  if (package.name.size() < 2 || !letters || package.name.find_first_of("+-.") == 0) {
    throw UsageError(value.place(), fmt::format("'{}' is not the name of a Debian package; correct it", package.name));
  }
  return package;
}

bool is_sha256(const std::string& sum) {
  return sum.size() == 64 && sum.find_first_not_of("0123456789abcdef") == std::string::npos;
}

ManifestFile parse_file(const TomlValue& table, const std::string& address,
                        const std::optional<ManifestPackage>& package) {
  table.allow_keys({"name", "sha256", "member"}, "a file");
  ManifestFile file;
  file.name = parse_relative(table.require("name")).string();
  if (!address.empty()) file.address = address + file.name;
  if (package) file.member = parse_relative(table.require("member")).string();
  if (const auto sum = table.find("sha256")) {
    file.sha256 = sum->as_string();
    if (!is_sha256(file.sha256))
      throw UsageError(sum->place(), "a SHA-256 of 64 lower-case hexadecimal digits is expected");
  }
  if (file.sha256.empty() && (!file.address.empty() || package)) {
    throw UsageError(table.place(), fmt::format("'{}' is to be fetched but has no sha256; state it", file.name));
  }
  return file;
}

VolumeChoice parse_part(const TomlValue& table) {
  VolumeChoice part;
  if (const auto step = table.find("step")) part.step = static_cast<std::size_t>(parse_count(*step, 0));
  if (const auto component = table.find("component"))
    part.component = static_cast<std::size_t>(parse_count(*component, 0));
  const auto text = [&](const char* key) {
    const auto found = table.find(key);
    return found ? found->as_string() : std::string();
  };
  part.array = text("array");
  part.segment = text("segment");
  part.series = text("series");
  return part;
}

std::string describe(const VolumeChoice& part) {
  std::string text;
  if (part.step) text += fmt::format("step {}\n", *part.step);
  if (part.component) text += fmt::format("component {}\n", *part.component);
  if (!part.array.empty()) text += fmt::format("array {}\n", part.array);
  if (!part.segment.empty()) text += fmt::format("segment {}\n", part.segment);
  if (!part.series.empty()) text += fmt::format("series {}\n", part.series);
  return text;
}

RawLayout parse_raw(const TomlValue& table) {
  table.allow_keys({"size", "spacing", "type", "byte_order"}, "[data.raw]");
  RawLayout raw;
  const TomlValue size = table.require("size");
  const std::vector<TomlValue> counts = size.as_array();
  if (counts.size() != 3) throw UsageError(size.place(), "three numbers of nodes are expected");
  for (std::size_t axis = 0; axis < 3; ++axis) raw.size[axis] = parse_count(counts[axis], 1);
  raw.spacing = parse_triple(table.require("spacing"));
  const TomlValue type = table.require("type");
  const std::vector<std::string> types = {"u8", "i8", "u16", "i16", "u32", "i32", "i64", "u64", "f32", "f64"};
  if (std::find(types.begin(), types.end(), type.as_string()) == types.end()) {
    throw UsageError(type.place(),
                     fmt::format("unknown sample type '{}'{}", type.as_string(), suggestion(type.as_string(), types)));
  }
  raw.type = sample_type(type.as_string()).value_or(SampleType::u8);
  const std::string order = string_or(table, "byte_order", "little");
  if (order != "little" && order != "big") {
    throw UsageError(table.require("byte_order").place(),
                     fmt::format("byte_order is 'little' or 'big', not '{}'", order));
  }
  raw.order = order == "big" ? ByteOrder::big : ByteOrder::little;
  return raw;
}

void parse_data(const TomlValue& table, Manifest& manifest) {
  table.allow_keys(
      {"folder", "address", "package", "archive", "files", "raw", "step", "component", "array", "segment", "series"},
      "[data]");
  manifest.part = parse_part(table);
  if (const auto folder = table.find("folder"))
    manifest.folder = parse_relative(*folder);
  else if (manifest.beside.empty() && manifest.folder.empty())
    manifest.folder = manifest.name;
  if (const auto package = table.find("package")) {
    manifest.package = parse_package(*package, table.find("archive"));
  }
  for (const TomlValue& file : table.require("files").as_array()) {
    manifest.files.push_back(parse_file(file, string_or(table, "address"), manifest.package));
  }
  if (manifest.files.empty()) throw UsageError(table.place(), "at least one file is expected");
  if (const auto raw = table.find("raw")) manifest.raw = parse_raw(*raw);
}

ManifestPhantom parse_phantom(const TomlValue& table) {
  const TomlValue name = table.require("name");
  std::vector<std::string> names;
  for (const Phantom& known : phantoms()) names.push_back(known.name);
  if (std::find(names.begin(), names.end(), name.as_string()) == names.end()) {
    throw UsageError(name.place(),
                     fmt::format("unknown phantom '{}'{}", name.as_string(), suggestion(name.as_string(), names)));
  }
  ManifestPhantom chosen;
  chosen.name = name.as_string();
  std::vector<std::string> keys = {"name", "nodes"};
  for (const PhantomParameter& parameter : phantom(chosen.name).parameters) {
    keys.push_back(parameter.name);
    const auto value = table.find(parameter.name);
    if (!value) continue;
    chosen.parameters[parameter.name] = value->as_number();
    if (!(value->as_number() >= parameter.min && value->as_number() <= parameter.max)) {
      throw UsageError(value->place(),
                       fmt::format("{} must be {} to {} mm", parameter.name, parameter.min, parameter.max));
    }
  }
  table.allow_keys(keys, "[phantom]");
  // 2048³ samples take 32 GiB; a larger number is most likely a mistake.
  chosen.nodes = parse_count(table.require("nodes"), 16, 2048);
  return chosen;
}

double parse_min_component(const TomlValue& value) {
  const double least = value.as_number();
  if (!(least >= 0.0 && std::isfinite(least)))
    throw UsageError(value.place(), fmt::format("min-component is {}; give a volume of at least 0 mm³", least));
  return least;
}

void name_manifest(const std::filesystem::path& path, const std::string& name, Manifest& manifest) {
  manifest.name = name;
  if (!name.ends_with(".toml")) return;
  manifest.name = path.stem().string();
  if (!is_plain_name(manifest.name)) {
    throw UsageError(Place{path.string()},
                     "the manifest's name becomes part of the names of folders; rename it to at most 100 printable "
                     "characters, the first neither '.' nor '-'");
  }
  manifest.beside = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// The manifest of one data set: `root` itself, or that of the member of a family.
TomlValue choose_member(const TomlValue& root, std::optional<int> member, Manifest& manifest) {
  const std::optional<Family> family = parse_family(root, manifest.name);
  manifest.title = root.require("title").as_string();
  if (!family) return root;
  if (!member) {
    throw UsageError(root.place(), fmt::format("this is a family of data sets; give the name of one, {}, and put the "
                                               "manifest into the folder that ISOBENCH_CATALOGUE names",
                                               members_text(*family, manifest.name)));
  }
  manifest.family = family->name;
  manifest.member = member;
  manifest.title += fmt::format(" {}: {}", member_number(*family, *member), member_text(*family, *member));
  if (manifest.beside.empty()) manifest.folder = manifest.name;  // members share their files
  manifest.name += "-" + member_number(*family, *member);
  return member_manifest(root, *family, *member);
}

void refuse_keys(const TomlValue& root, const char* what, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (const auto value = root.find(key))
      throw UsageError(value->place(), fmt::format("{} has no '{}'; remove the key", what, key));
  }
}

/// The path of the manifest of this name: in the catalogue, or beside a user's own manifest.
std::filesystem::path path_of_lender(const TomlValue& of, const Manifest& manifest) {
  const std::string name = parse_relative(of).string();
  if (!manifest.beside.empty()) {
    std::filesystem::path path = manifest.beside / (name + ".toml");
    if (std::filesystem::is_regular_file(path)) return path;
    throw UsageError(of.place(),
                     fmt::format("there is no manifest '{}'; name one that lies beside this one", path.string()));
  }
  const auto paths = manifest_paths();
  const auto found = paths.find(name);
  if (found != paths.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& entry : paths) names.push_back(entry.first);
  throw UsageError(of.place(), fmt::format("unknown manifest '{}'{}", name, suggestion(name, names)));
}

/// The manifest whose files this one takes: the one that `of` in [data] names.
std::optional<TomlValue> find_lender(const TomlValue& root, Manifest& manifest) {
  const auto data = root.find("data");
  const auto of = data ? data->find("of") : std::nullopt;
  if (!of) return std::nullopt;
  data->allow_keys({"of"}, "a [data] with the files of another manifest");
  const std::filesystem::path lender = path_of_lender(*of, manifest);
  if (manifest.beside.empty()) manifest.folder = of->as_string();
  return TomlValue::parse_file(lender);
}

/// Reads what a manifest has exactly one of. `lender` is the manifest that has the files, this one or another.
void parse_origin(const TomlValue& root, const TomlValue& lender, Manifest& manifest) {
  const auto data = root.find("data");
  const auto phantom = root.find("phantom");
  const auto generated = root.find("generated");
  if (data.has_value() + phantom.has_value() + generated.has_value() != 1)
    throw UsageError(root.place(), "a manifest needs exactly one of [data], [phantom] and [generated]");
  if (phantom) {
    refuse_keys(root, "a phantom", {"isovalue", "inside", "exact-isovalue", "prepare", "family"});
    manifest.phantom = parse_phantom(*phantom);
  } else if (generated) {
    refuse_keys(root, "a generated volume", {"isovalue", "prepare"});
    manifest.generated = parse_generated(*generated);
    manifest.generated->seed += static_cast<std::uint64_t>(manifest.member.value_or(0));
  } else {
    manifest.isovalue = root.require("isovalue").as_number();
    if (const auto steps = root.find("prepare"))
      manifest.steps = parse_steps(*steps, {manifest.isovalue, manifest.inside});
    parse_data(lender.require("data"), manifest);
  }
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& path, const std::string& name, std::optional<int> member) {
  Manifest manifest;
  name_manifest(path, name, manifest);
  const TomlValue file = TomlValue::parse_file(path);
  file.allow_keys({"title", "licence", "source", "acknowledgement", "isovalue", "inside", "kernel", "exact-isovalue",
                   "min-component", "prepare", "data", "phantom", "generated", "family"},
                  "a dataset's manifest");
  const TomlValue root = choose_member(file, member, manifest);
  const TomlValue lender = find_lender(root, manifest).value_or(root);
  manifest.licence = string_or(root, "licence", string_or(lender, "licence"));
  manifest.source = string_or(root, "source", string_or(lender, "source"));
  manifest.acknowledgement = string_or(root, "acknowledgement", string_or(lender, "acknowledgement"));
  manifest.kernel = parse_choice(root, "kernel", {Kernel::bspline, Kernel::interpolating_bspline, Kernel::catmull_rom});
  manifest.inside = parse_choice(root, "inside", {Inside::above, Inside::below});
  if (const auto exactly = root.find("exact-isovalue")) manifest.choices.exact_isovalue = exactly->as_bool();
  if (const auto least = root.find("min-component")) manifest.choices.min_component = parse_min_component(*least);
  parse_origin(root, lender, manifest);
  return manifest;
}

std::optional<Family> read_family(const std::filesystem::path& path) {
  return parse_family(TomlValue::parse_file(path), path.stem().string());
}

std::string manifest_checksum(const Manifest& manifest, const std::vector<std::string>& file_sums) {
  std::string text = fmt::format("isobench dataset, preparation revision {}\nkernel {}\n", preparation_revision,
                                 to_string(manifest.kernel));
  if (manifest.choices.min_component > 0.0) text += fmt::format("min-component {}\n", manifest.choices.min_component);
  if (manifest.phantom) {
    text += fmt::format("phantom {} {}\n", manifest.phantom->name, manifest.phantom->nodes);
    const Phantom shape = phantom(manifest.phantom->name, manifest.phantom->parameters);
    for (const PhantomParameter& parameter : shape.parameters) {
      text += fmt::format("{} {}\n", parameter.name, parameter.value);
    }
    return sha256_of_text(text);
  }
  if (manifest.generated) {
    text += fmt::format("generated {}\ninside {}\n", describe(*manifest.generated), to_string(manifest.inside));
    return sha256_of_text(text);
  }
  for (const std::string& sum : file_sums) text += fmt::format("file {}\n", sum);
  text += describe(manifest.part);
  if (manifest.raw) {
    const RawLayout& raw = *manifest.raw;
    text += fmt::format("raw {} {} {}, {} {} {}, type {}, order {}\n", raw.size[0], raw.size[1], raw.size[2],
                        raw.spacing[0], raw.spacing[1], raw.spacing[2], static_cast<int>(raw.type),
                        static_cast<int>(raw.order));
  } else {
    text += fmt::format("read {}\n", std::filesystem::path(manifest.files.front().name).filename().string());
  }
  for (const PrepareStep& step : manifest.steps) text += fmt::format("step {}\n", describe(step));
  text += fmt::format("isovalue {}\ninside {}\n", manifest.isovalue, to_string(manifest.inside));
  return sha256_of_text(text);
}

}  // namespace isobench
