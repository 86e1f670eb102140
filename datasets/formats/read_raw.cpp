#include <fmt/format.h>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/formats/reading/header_values.h"
#include "isobench/datasets/formats/reading/read_samples.h"
#include "isobench/foundation/error.h"

namespace isobench {

Volume read_raw(const std::vector<std::filesystem::path>& files, const RawLayout& layout) {
  if (files.empty()) throw DataError("no raw files are given; name at least one");
  Volume volume;
  volume.lattice = make_lattice(files.front(), {layout.size[0], layout.size[1], layout.size[2]}, layout.spacing,
                                Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), "");
  if (files.size() > static_cast<std::size_t>(layout.size[2])) {
    throw DataError(fmt::format("{}: {} raw files are more than the {} slices; give one file, or one for each slice",
                                files.front().string(), files.size(), layout.size[2]));
  }
  const std::size_t nodes = volume.lattice.nodes();
  if (nodes % files.size() != 0) {
    throw DataError(fmt::format("{}: {} samples cannot be divided evenly among {} raw files; check the declared size",
                                files.front().string(), nodes, files.size()));
  }
  const std::size_t each = nodes / files.size();
  for (const std::filesystem::path& file : files) {
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (error) throw DataError(file.string() + ": cannot be read; check the path");
    if (bytes != each * bytes_of(layout.type)) {
      throw DataError(
          fmt::format("{}: it has {} bytes, but the declared size and type make {}; correct them or copy it again",
                      file.string(), bytes, each * bytes_of(layout.type)));
    }
  }
  volume.samples = Samples(layout.type);
  volume.samples.visit([&](auto& samples) { samples.reserve(nodes); });
  for (const std::filesystem::path& file : files) {
    ByteReader reader(file, Encoding::plain);
    read_samples(reader, each, layout.order, volume.samples);
  }
  return volume;
}

}  // namespace isobench
