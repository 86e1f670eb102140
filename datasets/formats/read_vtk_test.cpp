// VTI and NIfTI files written by VTK, in every encoding that its writers have.
#include <gtest/gtest.h>
#include <vtkFloatArray.h>
#include <vtkImageCast.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNIFTIImageHeader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNIFTIImageWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include "isobench/datasets/formats/testing/oblique_files.h"
#include "isobench/datasets/formats/vtk/test_vtk_writer.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

void fill(vtkImageData& image) {
  image.SetExtent(2, nx + 1, 0, ny - 1, 0, nz - 1);
  image.SetSpacing(spacing.data());
  const Eigen::Matrix3d direction = oblique();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      image.GetDirectionMatrix()->SetElement(row, column, direction(row, column));
  }
  const Eigen::Vector3d first = origin - direction * Eigen::Vector3d(2.0 * spacing[0], 0.0, 0.0);
  image.SetOrigin(first.data());
  vtkNew<vtkFloatArray> array;
  array->SetName("v");
  for (const float sample : samples()) array->InsertNextValue(sample);
  image.GetPointData()->SetScalars(array);
}

TEST(ReadVti, AllThatVtkWrites) {
  const TestFolder folder;
  vtkNew<vtkImageData> image;
  fill(*image);
  const auto path = (folder.path() / "volume.vti").string();
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetBlockSize(256);  // four blocks, the last one shorter
  write_all_variants(*writer, path, [&path] { expect_oblique(volume_of(path)); });
}

TEST(ReadVti, EverySampleTypeAndSeveralPieces) {
  const TestFolder folder;
  vtkNew<vtkImageData> image;
  fill(*image);
  const auto path = (folder.path() / "volume.vti").string();
  for (const int type : {VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT,
                         VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE}) {
    SCOPED_TRACE(type);
    vtkNew<vtkImageCast> cast;
    cast->SetInputData(image);
    cast->SetOutputScalarType(type);
    cast->ClampOverflowOn();
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputConnection(cast->GetOutputPort());
    writer->SetNumberOfPieces(type % 2 == 0 ? 3 : 1);
    ASSERT_EQ(writer->Write(), 1);
    std::vector<float> expected = samples();
    if (type == VTK_SIGNED_CHAR) {
      for (float& sample : expected) sample = std::min(sample, 127.0F);
    }
    EXPECT_EQ(floats_of(volume_of(path)), expected);
  }
}

TEST(ReadVti, PiecesThatDoNotFitAreRefused) {
  const TestFolder folder;
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string text = vti_text(text_of_samples());
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos);
    return folder.write("volume.vti", text.replace(at, what.size(), by));
  };
  expect_data_error(with("Piece Extent=\"2", "Piece Extent=\"1"), "outside its whole extent");
  expect_data_error(with("WholeExtent=\"2 8", "WholeExtent=\"2 9"), "pieces of it are missing");
  expect_data_error(with("WholeExtent=\"2 8", "WholeExtent=\"8 2"), "not that of a 3-D volume");
  expect_data_error(with("Name=\"v\"", "Name=\"v\" NumberOfComponents=\"3\""), "vectors");
  expect_data_error(with("<PointData", "<!DOCTYPE a><PointData"), "not well-formed XML");
}

/// VTK may reverse the order of slices to make its axes right-handed. Nodes then have other numbers, but the same
/// places. 1e-3 voxels: version 1 keeps places in single precision.
void expect_same_in_space(vtkNIFTIImageReader& reader, const FloatVolume& volume) {
  ASSERT_EQ(volume.lattice.size, (std::array<int, 3>{nx, ny, nz}));
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const Eigen::Vector3d local =
            Eigen::Vector3d(reader.GetOutput()->GetSpacing()).cwiseProduct(Eigen::Vector3d(i, j, k));
        Eigen::Vector4d world;
        reader.GetQFormMatrix()->MultiplyPoint(local.homogeneous().eval().data(), world.data());
        const Eigen::Vector3d node = volume.lattice.to_local(world.head<3>()).cwiseQuotient(volume.lattice.spacing);
        const Eigen::Array3i n = node.array().round().cast<int>();
        ASSERT_LT((node - n.cast<double>().matrix()).norm(), 1e-3);
        ASSERT_TRUE((n >= 0).all() && (n < Eigen::Array3i(nx, ny, nz)).all());
        EXPECT_EQ(volume.at(n[0], n[1], n[2]), reader.GetOutput()->GetScalarComponentAsDouble(i, j, k, 0));
      }
    }
  }
}

TEST(ReadNifti, AllThatVtkWrites) {
  const TestFolder folder;
  vtkNew<vtkImageData> image;
  fill(*image);
  for (const int version : {1, 2}) {
    for (const double handedness : {1.0, -1.0}) {
      for (const char* ending : {".nii", ".nii.gz"}) {
        SCOPED_TRACE(fmt::format("version {}, {}, {}", version, handedness, ending));
        const auto path = (folder.path() / fmt::format("volume{}", ending)).string();
        vtkNew<vtkMatrix4x4> matrix;
        for (int row = 0; row < 3; ++row) {
          for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, oblique()(row, column));
          matrix->SetElement(row, 3, origin[row]);
        }
        vtkNew<vtkNIFTIImageWriter> writer;
        writer->SetFileName(path.c_str());
        writer->SetInputData(image);
        writer->SetNIFTIVersion(version);
        writer->SetQFac(handedness);
        writer->SetQFormMatrix(matrix);
        writer->SetSFormMatrix(nullptr);
        writer->Write();
        vtkNew<vtkNIFTIImageReader> reader;
        reader->SetFileName(path.c_str());
        reader->Update();
        expect_same_in_space(*reader, as_float(volume_of(path)));
      }
    }
  }
}

}  // namespace
}  // namespace isobench
