// INRIMAGE-4: a text header that is padded to a multiple of 256 bytes and ends with "##}", then plain samples.
#include "isobench/datasets/formats/read_inrimage.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/datasets/formats/reading/sample_data.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

constexpr std::size_t header_block = 256;
constexpr std::size_t header_limit = 64 * header_block;

std::string read_header(ByteReader& reader) {
  std::string header(header_block, '\0');
  const std::size_t got = reader.read(header.data(), header_block);
  if (!header.starts_with("#INRIMAGE-4#{")) {
    throw DataError(reader.path().string() + ": not an INRIMAGE-4 file; give it the ending of its own format");
  }
  if (got < header_block)
    throw DataError(reader.path().string() + ": truncated in its header; copy or export it again");
  while (header.find("##}") == std::string::npos) {
    std::string block(header_block, '\0');
    if (reader.read(block.data(), header_block) < header_block || header.size() > header_limit) {
      throw DataError(reader.path().string() + ": truncated: its header does not end; copy or export it again");
    }
    header += block;
  }
  return header.substr(0, header.find("##}"));
}

std::map<std::string, std::string> fields_of(const std::string& header) {
  std::map<std::string, std::string> fields;
  for (std::size_t begin = 0; begin < header.size();) {
    const std::size_t end = std::min(header.find('\n', begin), header.size());
    const std::string line = header.substr(begin, end - begin);
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos) fields[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
    begin = end + 1;
  }
  return fields;
}

SampleType type_of(const std::map<std::string, std::string>& fields, const std::filesystem::path& path) {
  const auto text = [&](const char* key) { return fields.contains(key) ? fields.at(key) : std::string(); };
  const std::string size = text("PIXSIZE");
  const std::string bits = size.substr(0, size.find(' '));
  const std::string type = text("TYPE");
  if (type == "float" && bits == "32") return SampleType::f32;
  if (type == "float" && bits == "64") return SampleType::f64;
  if (type == "unsigned fixed" || type == "signed fixed") {
    const auto found = sample_type((type[0] == 'u' ? "u" : "i") + bits);
    if (found) return *found;
  }
  throw DataError(
      fmt::format("{}: TYPE '{}' with PIXSIZE '{}' cannot be read; readable are float of 32 or 64 bits and "
                  "signed or unsigned fixed of 8 to 64 bits",
                  path.string(), type, size));
}

ByteOrder order_of(const std::string& cpu, const std::filesystem::path& path) {
  if (cpu == "decm" || cpu == "alpha" || cpu == "pc") return ByteOrder::little;
  if (cpu == "sun" || cpu == "sgi") return ByteOrder::big;
  throw DataError(fmt::format("{}: its byte order CPU={} is not known; export it with decm, alpha, pc, sun or sgi",
                              path.string(), cpu));
}

}  // namespace

VolumeFile read_inrimage(const std::filesystem::path& path, const VolumeChoice& /*choice*/) {
  ByteReader reader(path, path.extension() == ".gz" ? Encoding::deflated : Encoding::plain);
  const auto fields = fields_of(read_header(reader));
  const auto number = [&](const char* key, double otherwise) {
    return fields.contains(key) ? numbers_in(fields.at(key), 1, path, key).front() : otherwise;
  };
  if (number("VDIM", 1.0) != 1.0) throw DataError(path.string() + ": its samples are vectors; give a scalar volume");
  std::array<long long, 3> size{};
  const char* const names[] = {"XDIM", "YDIM", "ZDIM"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double nodes = number(names[axis], 0.0);
    size[axis] = nodes >= 1.0 && nodes < 1e9 ? std::llround(nodes) : 0;
  }
  const Eigen::Vector3d spacing(number("VX", 1.0), number("VY", 1.0), number("VZ", 1.0));
  const Eigen::Vector3d origin(number("TX", 0.0), number("TY", 0.0), number("TZ", 0.0));
  Volume volume;
  volume.lattice = make_lattice(path, size, spacing, Eigen::Matrix3d::Identity(), origin, "");
  volume.samples = Samples(type_of(fields, path));
  read_samples(reader, volume.lattice.nodes(), order_of(fields.contains("CPU") ? fields.at("CPU") : "decm", path),
               volume.samples);
  return {std::move(volume), {}};
}

}  // namespace isobench
