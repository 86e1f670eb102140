#include "isobench/datasets/formats/nifti/nifti_header.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "isobench/foundation/error.h"
#include "isobench/foundation/text.h"

namespace isobench {

namespace {

constexpr std::size_t size_1 = 348;  // of a header of version 1, and of ANALYZE 7.5
constexpr std::size_t size_2 = 540;

template <class Value>
Value value_at(const std::string& bytes, std::size_t at, ByteOrder order) {
  return number_at<Value>(bytes.data() + at, order);
}

/// Consecutive fields of one type. The versions differ in the types and in the order of the groups.
template <class Value, class Target>
void fields_at(const std::string& bytes, std::size_t at, ByteOrder order, Target* target, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n)
    target[n] = static_cast<Target>(value_at<Value>(bytes, at + n * sizeof(Value), order));
}

template <class Real>
void read_places(const std::string& bytes, std::size_t quaternion, std::size_t qoffset, std::size_t srow,
                 NiftiFields& fields) {
  fields_at<Real>(bytes, quaternion, fields.order, fields.quaternion.data(), 3);
  fields_at<Real>(bytes, qoffset, fields.order, fields.qoffset.data(), 3);
  Eigen::Matrix<double, 4, 3> rows;
  fields_at<Real>(bytes, srow, fields.order, rows.data(), 12);
  fields.srow = rows.transpose();
}

/// What ANALYZE 7.5 and NIfTI-1 have at the same places.
NiftiFields analyze_fields(const std::string& bytes, ByteOrder order) {
  NiftiFields fields;
  fields.kind = NiftiKind::analyze;
  fields.bytes = size_1;
  fields.order = order;
  fields_at<std::int16_t>(bytes, 40, order, fields.dim.data(), 8);
  fields.datatype = value_at<std::int16_t>(bytes, 70, order);
  fields.bits = value_at<std::int16_t>(bytes, 72, order);
  fields_at<float>(bytes, 76, order, fields.pixdim.data(), 8);
  fields.offset = value_at<float>(bytes, 108, order);
  fields.slope = value_at<float>(bytes, 112, order);  // unused in ANALYZE; SPM keeps a scale factor there
  const std::string unit(bytes, 56, 4);
  fields.unit_name = trimmed(unit.substr(0, unit.find('\0')));
  return fields;
}

NiftiFields version_1(const std::string& bytes, ByteOrder order) {
  NiftiFields fields = analyze_fields(bytes, order);
  fields.kind = bytes[345] == '+' ? NiftiKind::one_file : NiftiKind::pair;
  fields.unit_name.clear();
  fields.intent = value_at<std::int16_t>(bytes, 68, order);
  fields.intercept = value_at<float>(bytes, 116, order);
  fields.units = static_cast<unsigned char>(bytes[123]);
  fields.qform = value_at<std::int16_t>(bytes, 252, order);
  fields.sform = value_at<std::int16_t>(bytes, 254, order);
  read_places<float>(bytes, 256, 268, 280, fields);
  return fields;
}

NiftiFields version_2(const std::string& bytes, ByteOrder order) {
  NiftiFields fields;
  fields.kind = bytes[5] == '+' ? NiftiKind::one_file : NiftiKind::pair;
  fields.bytes = size_2;
  fields.order = order;
  fields.datatype = value_at<std::int16_t>(bytes, 12, order);
  fields.bits = value_at<std::int16_t>(bytes, 14, order);
  fields_at<std::int64_t>(bytes, 16, order, fields.dim.data(), 8);
  fields_at<double>(bytes, 104, order, fields.pixdim.data(), 8);
  fields.offset = static_cast<double>(value_at<std::int64_t>(bytes, 168, order));
  fields.slope = value_at<double>(bytes, 176, order);
  fields.intercept = value_at<double>(bytes, 184, order);
  fields.qform = value_at<std::int32_t>(bytes, 344, order);
  fields.sform = value_at<std::int32_t>(bytes, 348, order);
  read_places<double>(bytes, 352, 376, 400, fields);
  fields.units = value_at<std::int32_t>(bytes, 500, order);
  fields.intent = value_at<std::int32_t>(bytes, 504, order);
  return fields;
}

bool is_count(long long dimensions) { return dimensions >= 1 && dimensions <= 7; }

/// True if the bytes have the mark "n+1" or "ni1", with the version's digit, at this place.
bool has_mark(const std::string& bytes, std::size_t at, char version) {
  return bytes[at] == 'n' && (bytes[at + 1] == '+' || bytes[at + 1] == 'i') && bytes[at + 2] == version &&
         bytes[at + 3] == '\0';
}

/// The order in which the number at the header's beginning is the header's size; std::nullopt if it is in neither.
std::optional<ByteOrder> order_by_size(const std::string& bytes, std::size_t size) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    if (value_at<std::uint32_t>(bytes, 0, order) == size) return order;
  }
  return std::nullopt;
}

/// The byte order of a header of version 1 or of ANALYZE. Throws DataError if two fields contradict each other.
std::optional<ByteOrder> order_of_version_1(const std::string& bytes, const std::filesystem::path& path) {
  const auto is_possible = [&](ByteOrder order) { return is_count(value_at<std::int16_t>(bytes, 40, order)); };
  const std::optional<ByteOrder> by_size = order_by_size(bytes, size_1);
  const bool little = is_possible(ByteOrder::little);
  const bool big = is_possible(ByteOrder::big);
  if (!by_size) return little == big ? std::nullopt : std::optional(little ? ByteOrder::little : ByteOrder::big);
  if (little != big && !is_possible(*by_size)) {
    throw DataError(path.string() +
                    ": the fields of its header have different byte orders; the header is damaged, export it again");
  }
  return by_size;
}

/// Makes the sizes beyond the number of dimensions 1, and puts a wrong number of dimensions right if the sizes tell it.
void settle_dimensions(NiftiFields& fields, const std::filesystem::path& path, std::vector<std::string>& notes) {
  const auto sizes = std::span(fields.dim).subspan(1);
  if (!is_count(fields.dim[0])) {
    const bool usable = *std::min_element(sizes.begin(), sizes.begin() + 3) >= 1 &&
                        std::all_of(sizes.begin(), sizes.end(), [](long long size) { return size >= 0; });
    const std::string found =
        fmt::format("{}: its header states {} dimensions, not 1 to 7", path.string(), fields.dim[0]);
    if (!usable) throw DataError(found + "; copy or export it again");
    notes.push_back(fmt::format("{}; the sizes that it states, {}, are taken", found, fmt::join(sizes, " × ")));
    fields.dim[0] = 7;
  }
  for (std::size_t axis = 0; axis < sizes.size(); ++axis) {
    const bool is_beyond = static_cast<long long>(axis) >= fields.dim[0];
    if (is_beyond || (axis >= 3 && sizes[axis] == 0)) sizes[axis] = 1;
  }
}

std::optional<NiftiFields> fields_of(ByteReader& reader, bool may_be_analyze, std::vector<std::string>& notes) {
  std::string bytes(size_2, '\0');
  const std::filesystem::path& path = reader.path();
  if (reader.read(bytes.data(), size_1) < size_1) return std::nullopt;
  if (has_mark(bytes, 4, '2')) {
    const std::optional<ByteOrder> order = order_by_size(bytes, size_2);
    if (!order) return std::nullopt;
    if (reader.read(bytes.data() + size_1, size_2 - size_1) < size_2 - size_1)
      throw DataError(path.string() + ": truncated in its header; copy or export it again");
    return version_2(bytes, *order);
  }
  const bool is_nifti = has_mark(bytes, 344, '1');
  if (!is_nifti && (!may_be_analyze || !order_by_size(bytes, size_1))) return std::nullopt;
  const std::optional<ByteOrder> order = order_of_version_1(bytes, path);
  if (!order) return std::nullopt;
  if (!is_nifti) return analyze_fields(bytes, *order);
  if (!order_by_size(bytes, size_1)) {
    notes.push_back(path.string() + ": the first field of its header is not the header's size; the rest is taken");
  }
  return version_1(bytes, *order);
}

}  // namespace

NiftiFields read_nifti_header(ByteReader& reader, bool may_be_analyze, std::vector<std::string>& notes) {
  std::optional<NiftiFields> fields = fields_of(reader, may_be_analyze, notes);
  if (!fields) {
    throw DataError(fmt::format("{}: not a {}; give it the ending of its own format", reader.path().string(),
                                may_be_analyze ? "header of NIfTI or ANALYZE 7.5" : "NIfTI file"));
  }
  settle_dimensions(*fields, reader.path(), notes);
  return *std::move(fields);
}

}  // namespace isobench
