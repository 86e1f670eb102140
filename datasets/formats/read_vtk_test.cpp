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
  expect_data_error(with("Name=\"v\"", "Name=\"v\" NumberOfComponents=\"3\""), "choose one with --component 0 to 2");
  expect_data_error(with("<PointData", "<!DOCTYPE a><PointData"), "not well-formed XML");
}

/// An image of 3 × 2 × 2 points with these elements in its piece.
std::string image_with(const std::string& data) {
  return "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"4 6 0 1 0 1\" "
         "Origin=\"10 20 30\" Spacing=\"1 2 3\"><Piece Extent=\"4 6 0 1 0 1\">" +
         data + "</Piece></ImageData></VTKFile>";
}

std::string array_of(const std::string& name, std::size_t count, int first, int components = 1) {
  std::string text = fmt::format("<DataArray type=\"Int16\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">",
                                 name, components);
  for (std::size_t n = 0; n < count * static_cast<std::size_t>(components); ++n)
    text += fmt::format("{} ", first + static_cast<int>(n));
  return text + "</DataArray>";
}

TEST(ReadVti, TakesTheArrayThatIsMeantOrAsks) {
  const TestFolder folder;
  const auto file = [&](const std::string& data) { return folder.write("image.vti", image_with(data)); };
  const auto first_of = [](const Volume& volume) { return volume.samples.as<std::int16_t>().front(); };
  const std::string vectors = array_of("gradient", 12, 500, 3);
  const std::string ct = array_of("ct", 12, 100);
  const std::string labels = array_of("labels", 12, 200);
  const std::string text = "<Array type=\"String\" Name=\"s\" NumberOfTuples=\"1\" format=\"ascii\">65 0</Array>";
  EXPECT_EQ(first_of(volume_of(file("<PointData>" + text + ct + "</PointData>"))), 100);
  const VolumeFile noted = read_volume(file("<PointData>" + vectors + ct + "</PointData>"));
  EXPECT_EQ(first_of(noted.volume), 100);
  ASSERT_EQ(noted.notes.size(), 1U);
  EXPECT_NE(noted.notes.front().find("'ct' (at points) is taken"), std::string::npos) << noted.notes.front();
  EXPECT_EQ(first_of(volume_of(file("<PointData Scalars=\"labels\">" + ct + labels + "</PointData>"))), 200);
  const auto both = file("<PointData>" + ct + labels + "</PointData>");
  expect_data_error(both, "choose one with --array");
  EXPECT_EQ(first_of(volume_of(both, {.array = "labels"})), 200);
  expect_data_error(both, "did you mean 'labels'", {.array = "label"});
  const auto only_vectors = file("<PointData>" + vectors + "</PointData>");
  expect_data_error(only_vectors, "it has 3 components");
  EXPECT_EQ(first_of(volume_of(only_vectors, {.component = 2})), 502);
  expect_data_error(only_vectors, "no component 3", {.component = 3});
}

TEST(ReadVti, CellsAreVoxels) {
  const TestFolder folder;
  const Volume volume =
      volume_of(folder.write("cells.vti", image_with("<CellData>" + array_of("labels", 2, 7) + "</CellData>")));
  EXPECT_EQ(volume.lattice.size, (std::array<int, 3>{2, 1, 1}));
  EXPECT_EQ(volume.lattice.origin, Eigen::Vector3d(14.5, 21.0, 31.5));
  EXPECT_EQ(volume.samples, Samples(std::vector<std::int16_t>{7, 8}));
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
