#include "isobench/datasets/formats/mrc/mrc_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

class MrcBytes {
 public:
  MrcBytes(const std::string& bytes, ByteOrder order) : bytes_(bytes), order_(order) {}
  int integer(std::size_t at) const { return number_at<std::int32_t>(bytes_.data() + at, order_); }
  double real(std::size_t at) const { return number_at<float>(bytes_.data() + at, order_); }
  std::array<long long, 3> integers(std::size_t at) const { return {integer(at), integer(at + 4), integer(at + 8)}; }
  Eigen::Vector3d reals(std::size_t at) const { return {real(at), real(at + 4), real(at + 8)}; }

 private:
  const std::string& bytes_;
  ByteOrder order_;
};

/// Columns, rows and sections along X, Y and Z in some order; old programs leave the fields 0, which means this order.
bool are_axes(std::array<long long, 3> axes) {
  std::sort(axes.begin(), axes.end());
  return axes == std::array<long long, 3>{1, 2, 3} || axes == std::array<long long, 3>{0, 0, 0};
}

/// True if the header makes sense in this byte order; the other one turns small numbers into large ones.
bool makes_sense(const MrcBytes& header) {
  const auto size = header.integers(0);
  double nodes = 1.0;
  for (const long long length : size) {
    if (length < 1) return false;
    nodes *= static_cast<double>(length);
  }
  const int mode = header.integer(12);
  return nodes < 1e13 && mode >= 0 && mode < 256 && are_axes(header.integers(64));
}

/// The byte order that the machine stamp states.
std::optional<ByteOrder> stamped_order(const std::string& bytes) {
  if (bytes[212] == 0x44) return ByteOrder::little;
  if (bytes[212] == 0x11) return ByteOrder::big;
  return std::nullopt;
}

ByteOrder order_of(const std::string& bytes, const std::filesystem::path& path, std::vector<std::string>& notes) {
  const bool little = makes_sense(MrcBytes(bytes, ByteOrder::little));
  const bool big = makes_sense(MrcBytes(bytes, ByteOrder::big));
  if (!little && !big) {
    throw DataError(
        path.string() +
        ": its header is none of an MRC or CCP4 map; give it the ending of its own format, or export it again");
  }
  const std::optional<ByteOrder> stamped = stamped_order(bytes);
  if (little && big) return stamped.value_or(ByteOrder::little);
  const ByteOrder order = little ? ByteOrder::little : ByteOrder::big;
  if (stamped && *stamped != order) {
    notes.push_back(fmt::format("{}: its machine stamp states the wrong byte order; it is read as {}-endian",
                                path.string(), little ? "little" : "big"));
  }
  return order;
}

}  // namespace

MrcHeader read_mrc_header(ByteReader& reader, std::vector<std::string>& notes) {
  const std::filesystem::path& path = reader.path();
  std::string bytes(mrc_header_bytes, '\0');
  if (reader.read(bytes.data(), bytes.size()) < bytes.size())
    throw DataError(path.string() + ": shorter than the header of an MRC or CCP4 map; copy or export it again");
  MrcHeader header;
  header.order = order_of(bytes, path, notes);
  const MrcBytes fields(bytes, header.order);
  header.size = fields.integers(0);
  header.mode = fields.integer(12);
  header.start = fields.integers(16);
  header.intervals = fields.integers(28);
  header.cell = fields.reals(40);
  header.angles = fields.reals(52);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int number = fields.integer(64 + 4 * axis);
    if (number > 0) header.axis[axis] = number - 1;
  }
  header.least = fields.real(76);
  header.largest = fields.real(80);
  header.space_group = fields.integer(88);
  header.extension_bytes = fields.integer(92);
  header.version = fields.integer(108);
  constexpr int stamp = 1146047817;  // "IMOD"
  header.is_imod = fields.integer(152) == stamp;
  if (header.is_imod) header.imod_flags = fields.integer(156);
  header.origin = fields.reals(196);
  if (header.extension_bytes < 0) {
    throw DataError(fmt::format("{}: its header states an extension of {} bytes; copy or export it again",
                                path.string(), header.extension_bytes));
  }
  return header;
}

}  // namespace isobench
