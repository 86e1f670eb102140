// NIfTI and ANALYZE: which files a volume is made of, and headers that are wrong.
#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include "isobench/datasets/formats/testing/nifti_files.h"
#include "isobench/datasets/formats/testing/note_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

std::string nifti_floats(bool swapped = false) { return bytes_of_samples<float>(samples(), swapped); }

NiftiHeader placed(bool swapped = false) {
  NiftiHeader header(swapped);
  header.put_sform(oblique(), origin);
  return header;
}

TEST(ReadNiftiFiles, EitherFileOfAPairCanBeNamed) {
  const std::pair<const char*, const char*> names[] = {{"a.hdr", "a.img"},    {"a.hdr.gz", "a.img.gz"},
                                                       {"a.hdr", "a.img.gz"}, {"a.hdr.gz", "a.img"},
                                                       {"A.HDR", "A.IMG"},    {"A.B.hdr", "A.B.IMG"}};
  for (const auto& [header_name, image_name] : names) {
    for (const bool second_version : {false, true}) {
      for (const bool swapped : {false, true}) {
        SCOPED_TRACE(std::string(header_name) + " " + image_name);
        const TestFolder folder;
        // The name does not matter: what is compressed shows it by its first bytes.
        const std::string header = second_version ? nifti_2_header(swapped, true) : pair_header(placed(swapped));
        const bool compressed = std::string(image_name).ends_with(".gz");
        const auto first = folder.write(header_name, compressed ? deflated(header, true) : header);
        const auto second =
            folder.write(image_name, compressed ? deflated(nifti_floats(swapped), true) : nifti_floats(swapped));
        expect_oblique(volume_without_note(first));
        expect_oblique(volume_without_note(second));
      }
    }
  }
}

TEST(ReadNiftiFiles, SamplesAndPlacesAreAsVtkReadsThem) {
  const TestFolder folder;
  folder.write("pair.img", nifti_floats(true));
  NiftiHeader by_qform;
  by_qform.put_qform(oblique(), origin);
  const std::filesystem::path paths[] = {folder.write("one.nii.gz", deflated(placed().bytes() + nifti_floats(), true)),
                                         folder.write("two.nii", nifti_2_header() + nifti_floats()),
                                         folder.write("qform.nii", by_qform.bytes() + nifti_floats()),
                                         folder.write("pair.hdr", pair_header(placed(true)))};
  for (const std::filesystem::path& path : paths) {
    SCOPED_TRACE(path);
    const Volume volume = volume_without_note(path);
    vtkNew<vtkNIFTIImageReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkDataArray* array = reader->GetOutput()->GetPointData()->GetScalars();
    ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(volume.samples.size()));
    for (std::size_t n = 0; n < volume.samples.size(); ++n)
      EXPECT_EQ(volume.samples.as<float>()[n], array->GetComponent(static_cast<vtkIdType>(n), 0));
    vtkMatrix4x4* matrix = reader->GetSFormMatrix() != nullptr ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
    ASSERT_NE(matrix, nullptr);
    const double* step = reader->GetOutput()->GetSpacing();
    const double node[] = {3.0 * step[0], 1.0 * step[1], 4.0 * step[2], 1.0};
    double world[4] = {};
    matrix->MultiplyPoint(node, world);
    const Eigen::Vector3d place = volume.lattice.spacing.cwiseProduct(Eigen::Vector3d(3.0, 1.0, 4.0));
    EXPECT_LT((volume.lattice.to_world(place) - Eigen::Vector3d(world)).norm(), 1e-5);
  }
}

TEST(ReadNiftiFiles, AMissingHalfIsNamed) {
  const TestFolder folder;
  expect_data_error(folder.write("a.hdr", pair_header(placed())), "a.img, are missing");
  expect_data_error(folder.write("b.img", nifti_floats()), "b.hdr, is missing");
  expect_data_error(folder.write("c.nii", pair_header(placed()) + nifti_floats()), "its samples are in another file");
  folder.write("d.img", "short");
  expect_data_error(folder.write("d.hdr", "!INTERFILE  :=\n" + std::string(500, ' ')), "not a header of NIfTI");
  folder.write("e.img", nifti_floats().substr(4));
  try {
    read_volume(folder.write("e.hdr", pair_header(placed())));
    ADD_FAILURE() << "a truncated file was read";
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("e.img: truncated"), std::string::npos) << error.what();
  }
}

TEST(ReadNiftiFiles, OneFileMayHaveTheEndingOfAPair) {
  const TestFolder folder;
  expect_oblique(volume_without_note(folder.write("a.img", placed().bytes() + nifti_floats())));
  expect_oblique(volume_without_note(folder.write("b.hdr", placed().bytes() + nifti_floats())));
  // Compressed or not, whatever the ending says.
  expect_oblique(volume_without_note(folder.write("c.nii", deflated(placed().bytes() + nifti_floats(), true))));
  expect_oblique(volume_without_note(folder.write("d.nii.gz", placed().bytes() + nifti_floats())));
}

TEST(ReadNiftiFiles, TheSecondVersionInBothByteOrders) {
  const TestFolder folder;
  for (const bool swapped : {false, true}) {
    const std::string bytes = nifti_2_header(swapped) + nifti_floats(swapped);
    const Volume volume = volume_without_note(folder.write("a.nii", bytes));
    expect_oblique(volume);
    EXPECT_EQ(volume.lattice.space, "RAS");
    expect_data_error(folder.write("cut.nii", bytes.substr(0, 500)), "truncated in its header");
    expect_data_error(folder.write("less.nii", bytes.substr(0, bytes.size() - 1)), "truncated");
  }
  std::string hostile = nifti_2_header();
  for (const std::size_t at : {24U, 32U, 40U, 48U}) hostile.replace(at, 8, bytes_of_value(std::int64_t{1} << 40));
  expect_data_error(folder.write("hostile.nii", hostile), "its size");
  std::string steps = nifti_2_header();
  steps.replace(16, 8, bytes_of_value(std::int64_t{7}));
  for (const std::size_t at : {48U, 56U, 64U, 72U}) steps.replace(at, 8, bytes_of_value(std::int64_t{1} << 30));
  expect_data_error(folder.write("steps.nii", steps), "the header is damaged");
}

TEST(ReadNiftiFiles, AnalyzeHasNoPlace) {
  const TestFolder folder;
  for (const bool swapped : {false, true}) {
    folder.write("a.img", bytes_of_samples<std::int16_t>(samples(), swapped));
    const Volume volume = volume_with_note(folder.write("a.hdr", analyze_header(swapped)), "ANALYZE 7.5");
    EXPECT_EQ(volume.samples.type(), SampleType::i16);
    EXPECT_EQ(floats_of(volume), samples());
    EXPECT_LT((volume.lattice.spacing - spacing).norm(), 1e-6);
    EXPECT_EQ(volume.lattice.origin, Eigen::Vector3d::Zero());
    EXPECT_EQ(volume.lattice.space, "");
    EXPECT_EQ(floats_of(volume_with_note(folder.path() / "a.img", "mirror image")), samples());
  }
  expect_data_error(folder.write("a.nii", analyze_header() + nifti_floats()), "not a NIfTI file");
}

TEST(ReadNiftiFiles, AnalyzeKeepsItsUnitAndTheFactorOfSpm) {
  const TestFolder folder;
  const auto read = [&](const std::string& header) {
    folder.write("a.img", bytes_of_samples<std::int16_t>(samples()));
    return read_volume(folder.write("a.hdr", header));
  };
  std::string microns = analyze_header();
  microns.replace(56, 4, std::string("um\0\0", 4));
  EXPECT_LT((read(microns).volume.lattice.spacing - 1e-3 * spacing).norm(), 1e-9);
  const VolumeFile strange = read(microns.replace(56, 4, "ell\x01"));
  EXPECT_LT((strange.volume.lattice.spacing - spacing).norm(), 1e-6);
  ASSERT_EQ(strange.notes.size(), 2U);
  EXPECT_NE(strange.notes[0].find("'ell\\x01' is not known"), std::string::npos) << strange.notes[0];
  const VolumeFile scaled = read(analyze_header(false, 0.5F));
  ASSERT_EQ(scaled.notes.size(), 2U);
  EXPECT_NE(scaled.notes[1].find("are multiplied by the factor 0.5"), std::string::npos) << scaled.notes[1];
  for (std::size_t n = 0; n < samples().size(); ++n) EXPECT_EQ(floats_of(scaled.volume)[n], 0.5F * samples()[n]);
  const VolumeFile insane = read(analyze_header(false, 1e-38F));
  ASSERT_EQ(insane.notes.size(), 2U);
  EXPECT_NE(insane.notes[1].find("are not multiplied"), std::string::npos) << insane.notes[1];
  EXPECT_EQ(floats_of(insane.volume), samples());
  EXPECT_EQ(read(analyze_header(false, 1.0F)).notes.size(), 1U);
}

TEST(ReadNiftiFiles, AnalyzeThatCannotBeRead) {
  const TestFolder folder;
  folder.write("a.img", nifti_floats());
  const auto with = [&](std::size_t at, std::int16_t value) {
    return folder.write("a.hdr", analyze_header().replace(at, 2, bytes_of_value(value)));
  };
  expect_data_error(with(70, 128), "its samples are colours");
  expect_data_error(with(70, 1), "single bits");
  expect_data_error(with(70, 0), "of datatype 0");
  expect_data_error(with(0, 7), "not a header of NIfTI or ANALYZE 7.5");
  expect_data_error(with(40, 0x300), "different byte orders");
  expect_data_error(with(42, -7), "its size");
  expect_data_error(folder.write("a.hdr", analyze_header().replace(108, 4, bytes_of_value(-8.0F))),
                    "cannot begin at byte -8");
  expect_data_error(folder.write("a.hdr", analyze_header().substr(0, 300)), "not a header of NIfTI or ANALYZE 7.5");
}

TEST(ReadNiftiHeaders, SamplesBeginWhereTheHeaderSaysOrAfterIt) {
  const TestFolder folder;
  NiftiHeader header = placed();
  header.put<float>(108, 384.0F);
  const std::string extension(32, '\x55');
  expect_oblique(volume_without_note(folder.write("extension.nii", header.bytes() + extension + nifti_floats())));
  header.put<float>(108, 0.0F);
  expect_oblique(volume_without_note(folder.write("zero.nii", header.bytes() + nifti_floats())));
  for (const float inside : {-1.0F, 100.0F, 348.0F}) {
    header.put<float>(108, inside);
    expect_oblique(
        volume_with_note(folder.write("inside.nii", header.bytes() + nifti_floats()), "taken from byte 352"));
  }
  header.put<float>(108, 10000.0F);
  expect_data_error(folder.write("beyond.nii", header.bytes() + nifti_floats()), "truncated");
  for (const float wrong : {1e30F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    header.put<float>(108, wrong);
    expect_data_error(folder.write("wrong.nii", header.bytes() + nifti_floats()), "cannot begin at byte");
  }
}

TEST(ReadNiftiHeaders, AWrongNumberOfDimensionsIsPutRightIfTheSizesTellIt) {
  const TestFolder folder;
  for (const std::int16_t number : {std::int16_t{0}, std::int16_t{8}, std::int16_t{-1}}) {
    NiftiHeader header = placed();
    header.put<std::int16_t>(40, number);
    expect_oblique(volume_with_note(folder.write("a.nii", header.bytes() + nifti_floats()), "7 × 6 × 5 × 1"));
    header.put<std::int16_t>(44, 0);
    expect_data_error(folder.write("b.nii", header.bytes() + nifti_floats()), "dimensions, not 1 to 7");
  }
  NiftiHeader mixed = placed();
  mixed.put<std::int16_t>(40, 0x300);  // 3 in the other byte order
  expect_data_error(folder.write("c.nii", mixed.bytes() + nifti_floats()), "different byte orders");
  // The first field alone is wrong.
  NiftiHeader size = placed(true);
  size.put<std::int32_t>(0, 0);
  expect_oblique(volume_with_note(folder.write("d.nii", size.bytes() + nifti_floats(true)), "first field"));
  NiftiHeader none = placed();
  none.put<std::int16_t>(46, 0);
  expect_data_error(folder.write("f.nii", none.bytes() + nifti_floats()), "not that of a 3-D volume");
  // Sizes beyond the number of dimensions mean nothing.
  NiftiHeader more = placed();
  more.put<std::int16_t>(48, 9);
  expect_oblique(volume_without_note(folder.write("e.nii", more.bytes() + nifti_floats())));
}

TEST(ReadNiftiHeaders, AnImageIsOneSlice) {
  const TestFolder folder;
  const std::string slice = nifti_floats().substr(0, std::size_t{4} * nx * ny);
  NiftiHeader flat;
  flat.put<std::int16_t>(40, 2);
  flat.put<std::int16_t>(46, 0);
  flat.put<float>(88, 0.0F);  // no thickness either
  NiftiHeader single = placed();
  single.put<std::int16_t>(46, 1);
  NiftiHeader flat_sform = single;
  for (const std::size_t row : {280U, 296U, 312U}) flat_sform.put<float>(row + 8, 0.0F);
  for (const NiftiHeader& header : {flat, single, flat_sform}) {
    const Volume volume = volume_without_note(folder.write("a.nii", header.bytes() + slice));
    EXPECT_EQ(volume.lattice.size, (std::array<int, 3>{nx, ny, 1}));
    std::vector<float> first = samples();
    first.resize(std::size_t{nx} * ny);
    EXPECT_EQ(floats_of(volume), first);
    EXPECT_GT(volume.lattice.spacing[2], 0.0);
  }
  const Volume unplaced = volume_of(folder.write("b.nii", flat.bytes() + slice));
  EXPECT_NEAR(unplaced.lattice.spacing[2], spacing[1], 1e-6);
  const Volume turned = volume_of(folder.write("b.nii", flat_sform.bytes() + slice));
  EXPECT_LT((turned.lattice.direction - oblique()).norm(), 1e-6);
  EXPECT_NEAR(turned.lattice.spacing[2], spacing[2], 1e-6);
}

}  // namespace
}  // namespace isobench
