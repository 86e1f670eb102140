// Every reader keeps the type and the exact value of every sample that its format can hold.
#include <gtest/gtest.h>

#include <limits>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/formats/testing/oblique_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

/// What the formats call a type of samples.
struct Names {
  const char* nrrd;
  const char* meta;
  const char* vti;
  const char* inrimage;
  std::int16_t nifti;
  SampleType type;
};
template <class T>
constexpr Names names = {};
template <>
constexpr Names names<std::uint8_t> = {"unsigned char", "MET_UCHAR", "UInt8", "unsigned fixed", 2, SampleType::u8};
template <>
constexpr Names names<std::int8_t> = {"signed char", "MET_CHAR", "Int8", "signed fixed", 256, SampleType::i8};
template <>
constexpr Names names<std::uint16_t> = {"ushort", "MET_USHORT", "UInt16", "unsigned fixed", 512, SampleType::u16};
template <>
constexpr Names names<std::int16_t> = {"short", "MET_SHORT", "Int16", "signed fixed", 4, SampleType::i16};
template <>
constexpr Names names<std::uint32_t> = {"uint32", "MET_UINT", "UInt32", "unsigned fixed", 768, SampleType::u32};
template <>
constexpr Names names<std::int32_t> = {"int", "MET_INT", "Int32", "signed fixed", 8, SampleType::i32};
template <>
constexpr Names names<float> = {"float", "MET_FLOAT", "Float32", "float", 16, SampleType::f32};
template <>
constexpr Names names<double> = {"double", "MET_DOUBLE", "Float64", "float", 64, SampleType::f64};
template <>
constexpr Names names<std::int64_t> = {"int64", "MET_LONG_LONG", "Int64", "signed fixed", 1024, SampleType::i64};
template <>
constexpr Names names<std::uint64_t> = {"uint64", "MET_ULONG_LONG", "UInt64", "unsigned fixed", 1280, SampleType::u64};

/// The extremes of the type, values that a float or a double would round, and small numbers.
template <class T>
std::vector<T> values_of_type() {
  using Limits = std::numeric_limits<T>;
  std::vector<T> values = {T{0}, T{1}, Limits::lowest(), Limits::max()};
  if constexpr (std::is_floating_point_v<T>) {
    values = {T{0}, static_cast<T>(0.1), Limits::lowest(), Limits::max(), Limits::denorm_min(), static_cast<T>(1) / 3};
  } else {
    values.push_back(static_cast<T>(Limits::max() - 1));
  }
  for (int n = 2; values.size() < std::size_t{nx} * ny * nz; n = (n + 1) % 100) values.push_back(static_cast<T>(n));
  return values;
}

template <class T>
std::string bytes_of(const std::vector<T>& values, bool swapped = false) {
  std::string bytes;
  for (const T value : values) bytes += bytes_of_value(value, swapped);
  return bytes;
}

template <class T>
std::string text_of(const std::vector<T>& values) {
  std::string text;
  for (const T value : values) text += fmt::format("{} ", value);
  return text;
}

template <class T>
class ReadTypes : public testing::Test {
 protected:
  void expect_kept(const std::filesystem::path& path) { expect_kept(volume_of(path), path.filename().string()); }
  void expect_kept(const Volume& volume, const std::string& name) {
    EXPECT_EQ(volume.samples.type(), names<T>.type) << name;
    EXPECT_TRUE(volume.samples == Samples(values)) << name;
    const std::size_t taken =
        volume.samples.visit([](const auto& samples) { return samples.capacity() * sizeof(samples[0]); });
    EXPECT_EQ(taken, values.size() * sizeof(T)) << name;
  }
  std::string vti(const std::string& numbers) const {
    std::string file = vti_text(numbers);
    return file.replace(file.find("Float32"), 7, names<T>.vti);
  }

  TestFolder folder;
  std::vector<T> values = values_of_type<T>();
  std::string bytes = bytes_of(values);
  std::string swapped = bytes_of(values, true);
  std::string text = text_of(values);
};

using AllTypes = testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t, std::int32_t,
                                float, double, std::int64_t, std::uint64_t>;
TYPED_TEST_SUITE(ReadTypes, AllTypes);

TYPED_TEST(ReadTypes, Nrrd) {
  const std::string type = names<TypeParam>.nrrd;
  this->expect_kept(this->folder.write("raw.nrrd", nrrd_header(type, "raw") + "\n" + this->bytes));
  this->expect_kept(this->folder.write("gz.nrrd", nrrd_header(type, "gzip") + "\n" + deflated(this->bytes, true)));
  this->expect_kept(this->folder.write("text.nrrd", nrrd_header(type, "ascii") + "\n" + this->text));
  std::string big = nrrd_header(type, "raw") + "\n";
  big.replace(big.find("little"), 6, "big");
  this->expect_kept(this->folder.write("big.nrrd", big + this->swapped));
}

TYPED_TEST(ReadTypes, MetaImage) {
  const std::string fields = fmt::format("ElementType = {}\nElementDataFile = LOCAL", names<TypeParam>.meta);
  this->expect_kept(this->folder.write("raw.mha", metaimage_header(fields) + this->bytes));
  this->expect_kept(
      this->folder.write("big.mha", metaimage_header("CompressedData = True\nElementByteOrderMSB = True\n" + fields) +
                                        deflated(this->swapped, false)));
  this->expect_kept(this->folder.write("text.mha", metaimage_header("BinaryData = False\n" + fields) + this->text));
}

TYPED_TEST(ReadTypes, Nifti) {
  for (const bool other : {false, true}) {
    // A slope of 1 and an intercept of 0 are what most programs write; labels must pass unchanged.
    for (const float slope : {0.0F, 1.0F}) {
      NiftiHeader header(other);
      header.put<std::int16_t>(70, names<TypeParam>.nifti);
      header.put<std::int16_t>(72, 8 * sizeof(TypeParam));
      header.put<float>(112, slope);
      this->expect_kept(this->folder.write("volume.nii", header.bytes() + (other ? this->swapped : this->bytes)));
    }
  }
}

TYPED_TEST(ReadTypes, Vti) {
  this->expect_kept(this->folder.write("text.vti", this->vti(this->text)));
  std::string appended = this->vti("");
  appended.replace(appended.find("format=\"ascii\""), 14, "format=\"appended\" offset=\"0\"");
  const std::string head = bytes_of_value(static_cast<std::uint32_t>(this->bytes.size()));
  appended.replace(appended.find("</VTKFile>"), 10,
                   "<AppendedData encoding=\"raw\">_" + head + this->bytes + "</AppendedData></VTKFile>");
  this->expect_kept(this->folder.write("appended.vti", appended));
}

TYPED_TEST(ReadTypes, Inrimage) {
  const std::string type = fmt::format("TYPE={}\nPIXSIZE={} bits", names<TypeParam>.inrimage, 8 * sizeof(TypeParam));
  this->expect_kept(this->folder.write("little.inr", inrimage(inrimage_fields(type, "decm"), this->bytes)));
  this->expect_kept(this->folder.write("big.inr", inrimage(inrimage_fields(type, "sun"), this->swapped)));
}

TYPED_TEST(ReadTypes, Raw) {
  const RawLayout little{{nx, ny, nz}, spacing, names<TypeParam>.type, ByteOrder::little};
  const RawLayout big{{nx, ny, nz}, spacing, names<TypeParam>.type, ByteOrder::big};
  this->expect_kept(read_raw({this->folder.write("little.raw", this->bytes)}, little), "little.raw");
  this->expect_kept(read_raw({this->folder.write("big.raw", this->swapped)}, big), "big.raw");
  std::vector<std::filesystem::path> slices;
  const std::size_t slice = this->bytes.size() / nz;
  for (std::size_t k = 0; k < nz; ++k)
    slices.push_back(this->folder.write(fmt::format("slice.{}", k), this->bytes.substr(k * slice, slice)));
  this->expect_kept(read_raw(slices, little), "slices");
}

TEST(ReadNifti, ScaledSamplesAreComputedInDouble) {
  const TestFolder folder;
  NiftiHeader header;
  header.put<std::int16_t>(70, names<std::int32_t>.nifti);
  header.put<std::int16_t>(72, 32);
  header.put<float>(112, 0.5F);
  header.put<float>(116, 1.0F);
  const std::vector<std::int32_t> values = values_of_type<std::int32_t>();
  const Volume wide = volume_of(folder.write("i32.nii", header.bytes() + bytes_of(values)));
  ASSERT_EQ(wide.samples.type(), SampleType::f64);  // a float cannot hold 32 bits
  for (std::size_t n = 0; n < values.size(); ++n) EXPECT_EQ(wide.samples.as<double>()[n], 0.5 * values[n] + 1.0);
  header.put<std::int16_t>(70, names<std::int16_t>.nifti);
  header.put<std::int16_t>(72, 16);
  const std::vector<std::int16_t> shorts = values_of_type<std::int16_t>();
  const Volume narrow = volume_of(folder.write("i16.nii", header.bytes() + bytes_of(shorts)));
  ASSERT_EQ(narrow.samples.type(), SampleType::f32);
  for (std::size_t n = 0; n < shorts.size(); ++n)
    EXPECT_EQ(narrow.samples.as<float>()[n], 0.5F * static_cast<float>(shorts[n]) + 1.0F);
}

TEST(ReadTextSamples, AnIntegerMayBeWrittenAsARealNumberButMustBeOfItsType) {
  const TestFolder folder;
  const auto with_first = [&](const std::string& type, const std::string& word) {
    std::string text = text_of_samples();
    return folder.write("text.nrrd", nrrd_header(type, "ascii") + "\n" + text.replace(0, 1, word));
  };
  EXPECT_EQ(volume_of(with_first("uchar", "2.0")).samples.as<std::uint8_t>().front(), 2);
  EXPECT_EQ(volume_of(with_first("uchar", "2.5e1")).samples.as<std::uint8_t>().front(), 25);
  for (const char* word : {"256", "-1", "2.5", "nan", "1e3", "0x10"}) {
    expect_data_error(with_first("uchar", word), "is not a number of type u8");
  }
  expect_data_error(with_first("int64", "9223372036854775808"), "is not a number of type i64");
  EXPECT_EQ(volume_of(with_first("float", "1e39")).samples.as<float>().front(), std::numeric_limits<float>::infinity());
  EXPECT_EQ(volume_of(with_first("float", "1e-60")).samples.as<float>().front(), 0.0F);
}

TEST(ReadVti, PiecesOfDifferentTypesAndNodesThatNoPieceHasAreRefused) {
  const TestFolder folder;
  const std::string whole = vti_text(text_of_samples());
  const std::size_t begin = whole.find("<Piece");
  const std::size_t end = whole.find("</ImageData>");
  const std::string piece = whole.substr(begin, end - begin);
  std::string other = piece;
  other.replace(other.find("Float32"), 7, "UInt8");
  expect_data_error(folder.write("types.vti", std::string(whole).insert(end, other)), "different types");
  // Two equal halves have as many samples as the whole, but leave the other half of the nodes without any.
  std::string half = piece;
  half.replace(half.find("2 8 0 5 0 4"), 11, "2 8 0 5 0 2");
  const std::string values = half.substr(half.find("ascii\">") + 7);
  std::string fewer;
  for (int n = 0; n < nx * ny * 3; ++n) fewer += "1 ";
  half.replace(half.find("ascii\">") + 7, values.find('<'), fewer);
  expect_data_error(folder.write("halves.vti", whole.substr(0, begin) + half + half + whole.substr(end)),
                    "pieces of it are missing");
}

}  // namespace
}  // namespace isobench
