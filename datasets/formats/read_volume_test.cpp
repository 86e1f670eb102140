// Every reader puts samples and nodes in their places, and gives the same samples as VTK's readers.
#include "isobench/datasets/formats/read_volume.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMetaImageReader.h>
#include <vtkNew.h>
#include <vtkNrrdReader.h>
#include <vtkPointData.h>

#include "isobench/datasets/formats/testing/oblique_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

/// Compares samples in the order of the file, also if VTK reads the first axis as the components of vectors.
void expect_samples_of(vtkDataArray* array, const Volume& volume) {
  ASSERT_EQ(array->GetNumberOfValues(), static_cast<vtkIdType>(volume.samples.size()));
  const std::vector<float> samples = floats_of(volume);
  const int components = array->GetNumberOfComponents();
  for (int n = 0; n < array->GetNumberOfValues(); ++n) {
    EXPECT_EQ(samples[static_cast<std::size_t>(n)], array->GetComponent(n / components, n % components));
  }
}

TEST(ReadNrrd, KeepsNodesInPlaceInEveryEncoding) {
  const TestFolder folder;
  expect_oblique(
      volume_of(folder.write("raw.nrrd", nrrd_header("float", "raw") + "\n" + bytes_of_samples<float>(samples()))));
  expect_oblique(volume_of(folder.write(
      "gz.nrrd", nrrd_header("short", "gzip") + "\n" + deflated(bytes_of_samples<std::int16_t>(samples()), true))));
  expect_oblique(volume_of(folder.write("text.nrrd", nrrd_header("uchar", "ascii") + "\n" + text_of_samples())));
  folder.write("data.bin", "skip me\n" + bytes_of_samples<double>(samples()));
  const Volume detached =
      volume_of(folder.write("detached.nhdr", nrrd_header("double", "raw") + "line skip: 1\ndata file: data.bin\n"));
  expect_oblique(detached);
  EXPECT_EQ(detached.lattice.space, "LPS");
}

TEST(ReadNrrd, SamplesAreAsVtkReadsThem) {
  const TestFolder folder;
  const auto path = folder.write("raw.nrrd", nrrd_header("float", "raw") + "\n" + bytes_of_samples<float>(samples()));
  vtkNew<vtkNrrdReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkDataArray* array = reader->GetOutput()->GetPointData()->GetScalars();
  const Volume volume = volume_of(path);
  expect_samples_of(array, volume);
}

TEST(ReadNrrd, ObeysByteOrderSpacingsAndUnits) {
  const TestFolder folder;
  const Volume volume =
      volume_of(folder.write("plain.nrrd", fmt::format("NRRD0001\ntype: unsigned short\ndimension: 3\nsizes: {} {} "
                                                       "{}\nspacings: 0.5 1.25 3\nendian: big\nencoding: raw\n\n",
                                                       nx, ny, nz) +
                                               bytes_of_samples<std::uint16_t>(samples(), true)));
  EXPECT_EQ(floats_of(volume), samples());
  EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-12);
  EXPECT_EQ(volume.lattice.space, "");
  std::string header = nrrd_header("uchar", "ascii");
  header.replace(header.find("left-posterior"), 14, "left-anterior");
  const Volume mirrored =
      volume_of(folder.write("las.nrrd", header + "space units: \"cm\" \"cm\" \"cm\"\n\n" + text_of_samples()));
  EXPECT_EQ(mirrored.lattice.space, "RAS");
  EXPECT_FALSE(mirrored.lattice.right_handed());
  EXPECT_NEAR(mirrored.lattice.origin[0], -10.0 * origin[0], 1e-9);
  EXPECT_NEAR(mirrored.lattice.spacing[1], 10.0 * spacing[1], 1e-9);
}

TEST(ReadMetaImage, KeepsNodesInPlaceInEveryEncoding) {
  const TestFolder folder;
  expect_oblique(
      volume_of(folder.write("local.mha", metaimage_header("ElementType = MET_FLOAT\nElementDataFile = LOCAL") +
                                              bytes_of_samples<float>(samples()))));
  const std::string zipped = deflated(bytes_of_samples<std::int16_t>(samples(), true), false);
  expect_oblique(volume_of(folder.write(
      "zipped.mha",
      metaimage_header(
          "BinaryDataByteOrderMSB = True\nCompressedData = True\nElementType = MET_SHORT\nElementDataFile = LOCAL") +
          zipped)));
  folder.write("data.zraw", zipped);
  const Volume volume = volume_of(
      folder.write("apart.mhd", metaimage_header("BinaryDataByteOrderMSB = True\nCompressedData = True\nElementType = "
                                                 "MET_SHORT\nElementDataFile = data.zraw")));
  expect_oblique(volume);
  EXPECT_EQ(volume.lattice.space, "LPS");
  folder.write("data.raw", "header" + bytes_of_samples<std::uint8_t>(samples()));
  expect_oblique(volume_of(folder.write(
      "tail.mhd", metaimage_header("HeaderSize = -1\nElementType = MET_UCHAR\nElementDataFile = data.raw"))));
}

TEST(ReadMetaImage, SamplesAreAsVtkReadsThem) {
  const TestFolder folder;
  const auto path = folder.write("local.mha", metaimage_header("ElementType = MET_FLOAT\nElementDataFile = LOCAL") +
                                                  bytes_of_samples<float>(samples()));
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkDataArray* array = reader->GetOutput()->GetPointData()->GetScalars();
  const Volume volume = volume_of(path);
  expect_samples_of(array, volume);
}

TEST(ReadNifti, KeepsNodesInPlaceBySformAndByQform) {
  const TestFolder folder;
  NiftiHeader by_sform;
  by_sform.put_sform(oblique(), origin);
  by_sform.put_qform(Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());  // the sform wins
  const Volume volume = volume_of(folder.write("sform.nii", by_sform.bytes() + bytes_of_samples<float>(samples())));
  expect_oblique(volume);
  EXPECT_EQ(volume.lattice.space, "RAS");
  NiftiHeader by_qform;
  by_qform.put_qform(oblique(), origin);
  expect_oblique(
      volume_of(folder.write("qform.nii.gz", deflated(by_qform.bytes() + bytes_of_samples<float>(samples()), true))));
  NiftiHeader swapped(true);
  swapped.put_sform(oblique(), origin);
  expect_oblique(volume_of(folder.write("swapped.nii", swapped.bytes() + bytes_of_samples<float>(samples(), true))));
}

TEST(ReadNifti, ALeftHandedQformKeepsEachSampleAtItsPlace) {
  const TestFolder folder;
  NiftiHeader header;
  header.put_qform(oblique(), origin);
  header.put<float>(76, -1.0F);
  const FloatVolume volume =
      as_float(volume_of(folder.write("left.nii", header.bytes() + bytes_of_samples<float>(samples()))));
  const Eigen::Matrix3d left = oblique() * Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const Eigen::Vector3d world = origin + left * spacing.cwiseProduct(Eigen::Vector3d(i, j, k));
        const Eigen::Vector3d node = volume.lattice.to_local(world).cwiseQuotient(volume.lattice.spacing);
        const Eigen::Vector3i n = node.array().round().cast<int>().matrix();
        ASSERT_LT((node - n.cast<double>()).norm(), 1e-4);
        EXPECT_EQ(volume.at(n[0], n[1], n[2]), sample_at(i, j, k));
      }
    }
  }
}

TEST(ReadNifti, AppliesSlopeAndInterceptOnceAndUnits) {
  const TestFolder folder;
  NiftiHeader header;
  header.put<std::int16_t>(70, 2);
  header.put<std::int16_t>(72, 8);
  header.put<float>(112, 0.25F);
  header.put<float>(116, -3.0F);
  const std::string data = bytes_of_samples<std::uint8_t>(samples());
  const FloatVolume volume = as_float(volume_of(folder.write("scaled.nii", header.bytes() + data)));
  for (std::size_t n = 0; n < volume.samples.size(); ++n) EXPECT_EQ(volume.samples[n], 0.25F * samples()[n] - 3.0F);
  EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-6);
  header.put<float>(112, 0.0F);  // no scaling at all, whatever the intercept says
  header.put<std::uint8_t>(123, 3);
  const Volume plain = volume_of(folder.write("plain.nii", header.bytes() + data));
  EXPECT_EQ(floats_of(plain), samples());
  EXPECT_LT((plain.lattice.spacing - 1e-3 * spacing).norm(), 1e-9);
}

TEST(ReadVti, KeepsNodesInPlaceAlsoWhereTheExtentDoesNotStartAtZero) {
  const TestFolder folder;
  expect_oblique(volume_of(folder.write("volume.vti", vti_text(text_of_samples()))));
}

TEST(ReadInrimage, ReadsTypesAndByteOrdersWithSpacing) {
  const TestFolder folder;
  const Volume volume = volume_of(folder.write(
      "f.inr", inrimage(inrimage_fields("TYPE=float\nPIXSIZE=32 bits", "decm"), bytes_of_samples<float>(samples()))));
  EXPECT_EQ(floats_of(volume), samples());
  EXPECT_EQ(volume.lattice.size, (std::array<int, 3>{nx, ny, nz}));
  EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-12);
  const std::string big = inrimage(inrimage_fields("TYPE=unsigned fixed\nPIXSIZE=16 bits", "sun"),
                                   bytes_of_samples<std::uint16_t>(samples(), true));
  EXPECT_EQ(floats_of(volume_of(folder.write("u.inr.gz", deflated(big, true)))), samples());
  const std::string bytes =
      inrimage(inrimage_fields("TYPE=unsigned fixed\nPIXSIZE=8 bits", "pc"), bytes_of_samples<std::uint8_t>(samples()));
  EXPECT_EQ(floats_of(volume_of(folder.write("b.inr", bytes))), samples());
}

TEST(ReadRaw, OneFileOrOneASliceInBothByteOrders) {
  const TestFolder folder;
  RawLayout layout{{nx, ny, nz}, spacing, SampleType::i16, ByteOrder::big};
  const std::string bytes = bytes_of_samples<std::int16_t>(samples(), true);
  const Volume one = read_raw({folder.write("all.raw", bytes)}, layout);
  EXPECT_EQ(floats_of(one), samples());
  EXPECT_EQ(one.lattice.spacing, spacing);
  std::vector<std::filesystem::path> slices;
  const std::size_t slice = bytes.size() / nz;
  for (std::size_t k = 0; k < nz; ++k)
    slices.push_back(folder.write(fmt::format("slice.{}", k), bytes.substr(k * slice, slice)));
  EXPECT_EQ(floats_of(read_raw(slices, layout)), samples());
  layout.size[2] = nz + 1;
  EXPECT_THROW(read_raw({folder.path() / "all.raw"}, layout), DataError);
  EXPECT_THROW(read_raw({folder.path() / "missing.raw"}, layout), DataError);
}

}  // namespace
}  // namespace isobench
