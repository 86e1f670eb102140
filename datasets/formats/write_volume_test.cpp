#include "isobench/datasets/formats/write_volume.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>

#include "isobench/datasets/formats/testing/oblique_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

Volume oblique_volume() {
  Volume volume;
  volume.lattice.size = {nx, ny, nz};
  volume.lattice.spacing = spacing;
  volume.lattice.origin = origin;
  volume.lattice.direction = oblique();
  volume.samples = samples();
  return volume;
}

TEST(WriteVolume, WhatIsWrittenIsReadAgainInPlace) {
  const TestFolder folder;
  for (const char* name : {"oblique.nrrd", "oblique.vti"}) {
    for (const char* space : {"", "RAS", "LPS"}) {
      Volume volume = oblique_volume();
      volume.lattice.space = space;
      write_volume(volume, folder.path() / name);
      const Volume again = volume_of(folder.path() / name);
      expect_oblique(again);
      EXPECT_LT((again.lattice.direction - volume.lattice.direction).norm(), 1e-12) << name;
      EXPECT_LT((again.lattice.origin - volume.lattice.origin).norm(), 1e-12) << name;
      EXPECT_EQ(again.lattice.space, std::string(name).ends_with(".nrrd") ? space : "") << "VTI cannot say it";
    }
  }
}

TEST(WriteVolume, SamplesKeepTheirType) {
  const TestFolder folder;
  const std::vector<Samples> all = {
      std::vector<std::uint8_t>(nx * ny * nz, 255),
      std::vector<std::int8_t>(nx * ny * nz, -128),
      std::vector<std::uint16_t>(nx * ny * nz, 65535),
      std::vector<std::int16_t>(nx * ny * nz, -32768),
      std::vector<std::uint32_t>(nx * ny * nz, 4294967295U),
      std::vector<std::int32_t>(nx * ny * nz, 312782546),
      std::vector<float>(nx * ny * nz, 0.1F),
      std::vector<double>(nx * ny * nz, 0.1),
      std::vector<std::int64_t>(nx * ny * nz, std::numeric_limits<std::int64_t>::min() + 1),
      std::vector<std::uint64_t>(nx * ny * nz, std::numeric_limits<std::uint64_t>::max())};
  for (const Samples& samples : all) {
    const Volume volume{oblique_volume().lattice, samples};
    for (const char* name : {"typed.nrrd", "typed.vti"}) {
      write_volume(volume, folder.path() / name);
      EXPECT_EQ(volume_of(folder.path() / name).samples, samples) << name << ' ' << to_string(samples.type());
    }
  }
}

TEST(WriteVolume, VtkReadsTheVti) {
  const TestFolder folder;
  const std::filesystem::path path = folder.path() / "oblique.vti";
  write_volume(oblique_volume(), path);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfPoints(), nx * ny * nz);
  double world[3];
  image->TransformIndexToPhysicalPoint(3, 2, 1, world);
  EXPECT_LT((Eigen::Vector3d(world) - world_of(3, 2, 1)).norm(), 1e-9);
  EXPECT_EQ(image->GetScalarComponentAsDouble(3, 2, 1, 0), sample_at(3, 2, 1));
}

TEST(WriteVolume, SaysWhatItCannotWrite) {
  const TestFolder folder;
  EXPECT_THROW(write_volume(oblique_volume(), folder.path() / "volume.mha"), UsageError);
  EXPECT_THROW(write_volume(oblique_volume(), folder.path() / "nowhere" / "volume.nrrd"), Error);
}

}  // namespace
}  // namespace isobench
