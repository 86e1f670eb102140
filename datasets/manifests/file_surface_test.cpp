#include "isobench/datasets/manifests/file_surface.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "isobench/datasets/formats/dicom/test_dicom_writer.h"
#include "isobench/datasets/formats/write_volume.h"
#include "isobench/foundation/error.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

constexpr std::uint32_t first_region = 312782546;  // two regions of an atlas whose numbers become one float
constexpr std::uint32_t second_region = 312782574;

template <class T>
Volume volume_by(const Lattice& lattice, const std::function<double(const Eigen::Vector3d&)>& value) {
  std::vector<T> samples;
  for (int k = 0; k < lattice.size[2]; ++k) {
    for (int j = 0; j < lattice.size[1]; ++j) {
      for (int i = 0; i < lattice.size[0]; ++i)
        samples.push_back(static_cast<T>(value(lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, k)))));
    }
  }
  return {lattice, std::move(samples)};
}

Lattice lattice_of(const std::array<int, 3>& size, const Eigen::Vector3d& spacing = Eigen::Vector3d::Ones()) {
  Lattice lattice;
  lattice.size = size;
  lattice.spacing = spacing;
  return lattice;
}

// Two balls of 6 mm and 4 mm with different labels.
Volume two_regions(const Lattice& lattice) {
  return volume_by<std::uint32_t>(lattice, [](const Eigen::Vector3d& x) -> double {
    if ((x - Eigen::Vector3d(9.0, 9.5, 9.5)).norm() < 6.0) return first_region;
    if ((x - Eigen::Vector3d(24.0, 9.5, 9.5)).norm() < 4.0) return second_region;
    return 0.0;
  });
}

std::vector<float> coefficients_of(const Dataset& dataset) {
  std::vector<float> all;
  std::vector<float> slab;
  for (int k = 0; k < dataset.surface->lattice().size[2]; ++k) {
    dataset.surface->node_values(k, slab);
    all.insert(all.end(), slab.begin(), slab.end());
  }
  return all;
}

std::string all_notes(const Monitor& monitor) {
  std::string text;
  for (const std::string& note : monitor.notes()) text += note + "\n";
  return text;
}

TEST(FileSurfaceLabels, AreSelectedExactlyAndSaidInNumbers) {
  const TestFolder folder;
  const auto path = folder.path() / "atlas.nrrd";
  const Volume volume = two_regions(lattice_of({32, 20, 20}));
  write_volume(volume, path);
  for (const std::uint32_t label : {first_region, second_region}) {
    Monitor monitor;
    const Dataset dataset = dataset_from_file(path, {.labels = {label}, .smooth_voxels = 0.0}, monitor);
    EXPECT_EQ(dataset.topology->kept_components(), 1U);
    const auto& samples = volume.samples.as<std::uint32_t>();
    const auto voxels = std::count(samples.begin(), samples.end(), label);
    EXPECT_NE(all_notes(monitor).find(fmt::format("the labels have {} voxels, {} mm³ in 1 island;", voxels, voxels)),
              std::string::npos)
        << all_notes(monitor);
  }
  Monitor monitor;
  const Dataset both = dataset_from_file(path, {.labels = {first_region, second_region}}, monitor);
  EXPECT_EQ(both.topology->kept_components(), 2U);
  EXPECT_NE(all_notes(monitor).find("a --smooth below 1 voxels keeps more"), std::string::npos) << all_notes(monitor);
  Monitor unsmoothed;
  dataset_from_file(path, {.labels = {second_region}, .smooth_voxels = 0.0}, unsmoothed);
  EXPECT_EQ(all_notes(unsmoothed).find("keeps more"), std::string::npos) << all_notes(unsmoothed);
  EXPECT_THROW(dataset_from_file(path, {.labels = {7}}, monitor), DataError);
}

TEST(FileSurfaceLabels, OfThickSlicesAreInterpolatedBetweenThem) {
  const TestFolder folder;
  const auto path = folder.path() / "thick.nrrd";
  const Lattice thick = lattice_of({20, 20, 8}, {1.0, 1.0, 3.0});
  write_volume(
      volume_by<std::uint8_t>(
          thick, [](const Eigen::Vector3d& x) { return (x - Eigen::Vector3d(9.5, 9.5, 10.5)).norm() < 7.0 ? 1 : 0; }),
      path);
  Monitor monitor;
  const Dataset dataset = dataset_from_file(path, {.labels = {1}}, monitor);
  EXPECT_LT((dataset.surface->lattice().spacing - Eigen::Vector3d::Ones()).norm(), 0.05);
  const Dataset coarser = dataset_from_file(path, {.labels = {1}, .resample = Eigen::Vector3d::Constant(1.5)}, monitor);
  EXPECT_NEAR(coarser.surface->lattice().spacing[0], 1.5, 0.1);
  // The ball's poles lie between slices.
  EXPECT_GT(dataset.surface->value(dataset.surface->lattice().to_local({9.5, 9.5, 10.5 + 5.5})), 0.0);
  EXPECT_LT(dataset.surface->value(dataset.surface->lattice().to_local({9.5, 9.5, 10.5 + 8.0})), 0.0);
}

TEST(FileSurface, ItsManifestGivesTheSameSurface) {
  const TestFolder folder;
  const auto path = folder.path() / "it's \"one\".nrrd";
  write_volume(two_regions(lattice_of({32, 20, 10}, {1.0, 1.0, 2.0})), path);
  const std::vector<FileSurface> questions = {
      {.isovalue = 1e8},
      {.isovalue = 1e8, .resample = Eigen::Vector3d(0.8, 0.9, 1.0), .smooth_voxels = 0.7},
      {.isovalue = 1e8,
       .inside = Inside::below,
       .kernel = Kernel::interpolating_bspline,
       .choices = {.min_component = 3.0}},
      {.labels = {first_region}},
      {.labels = {second_region, first_region}, .resample = Eigen::Vector3d::Constant(0.75), .smooth_voxels = 1.25}};
  for (const FileSurface& asked : questions) {
    const auto manifest = folder.path() / "saved.toml";
    Monitor monitor;
    const Dataset by_options = dataset_from_file(path, asked, monitor, manifest);
    const Dataset by_manifest = load_dataset(manifest.string(), monitor);
    EXPECT_EQ(coefficients_of(by_manifest), coefficients_of(by_options));
    EXPECT_EQ(by_manifest.surface->isovalue(), by_options.surface->isovalue());
    EXPECT_EQ(by_manifest.surface->lattice().origin, by_options.surface->lattice().origin);
  }
}

// What is meshed of a DICOM series is what is meshed of the same samples in one file.
TEST(FileSurface, OfADicomSeriesIsThatOfItsSamples) {
  const TestFolder folder;
  for (int k = 0; k < nz; ++k)
    dicom_slice(k, "1.2.3").write(folder.path() / "scan" / fmt::format("{}.dcm", (7 * k) % nz));
  Volume volume;
  volume.lattice = lattice_of({nx, ny, nz}, spacing);
  volume.lattice.direction = oblique();
  volume.lattice.origin = origin;
  volume.lattice.space = "LPS";
  const std::vector<float> values = samples();
  volume.samples = std::vector<std::uint16_t>(values.begin(), values.end());
  write_volume(volume, folder.path() / "scan.nrrd");
  Monitor monitor;
  const FileSurface asked = {.isovalue = closed_isovalue};
  const Dataset series = dataset_from_file(folder.path() / "scan" / "", asked, monitor);
  const Dataset file = dataset_from_file(folder.path() / "scan.nrrd", asked, monitor);
  EXPECT_EQ(series.name, "scan");
  EXPECT_EQ(coefficients_of(series), coefficients_of(file));
  EXPECT_LT(
      (series.surface->lattice().to_world({3.0, 2.0, 6.0}) - file.surface->lattice().to_world({3.0, 2.0, 6.0})).norm(),
      1e-5);
}

TEST(FileSurface, RefusesQuestionsThatContradictThemselves) {
  const std::vector<FileSurface> questions = {{},
                                              {.isovalue = NAN},
                                              {.isovalue = 1.0, .labels = {1}},
                                              {.inside = Inside::below, .labels = {1}},
                                              {.isovalue = 1.0, .resample = Eigen::Vector3d(1.0, 0.0, 1.0)},
                                              {.isovalue = 1.0, .smooth_voxels = -1.0}};
  Monitor monitor;
  for (const FileSurface& asked : questions)
    EXPECT_THROW(dataset_from_file("no-such-file.nrrd", asked, monitor), UsageError);
}

// Differences of 10 on a pedestal of 10^9 are less than a float can hold there.
TEST(FileSurface, KeepsWhatTheIsovalueNeedsOnAPedestal) {
  const TestFolder folder;
  const Lattice lattice = lattice_of({24, 24, 24});
  const auto depth = [](const Eigen::Vector3d& x) {
    return 10.0 * (7.0 - (x - Eigen::Vector3d::Constant(11.5)).norm());
  };
  const auto lifted = [&](const Eigen::Vector3d& x) { return 1e9 + std::round(depth(x)); };
  const auto path = folder.path() / "volume.nrrd";
  Monitor monitor;
  write_volume(volume_by<float>(lattice, [&](const Eigen::Vector3d& x) { return std::round(depth(x)); }), path);
  const FileSurface plain_question = {.isovalue = 0.25, .smooth_voxels = 0.8};
  const Dataset plain = dataset_from_file(path, plain_question, monitor);
  FileSurface asked = plain_question;
  asked.isovalue = 1e9 + 0.25;
  for (const Volume& volume : {volume_by<std::int32_t>(lattice, lifted), volume_by<std::int64_t>(lattice, lifted),
                               volume_by<std::uint64_t>(lattice, lifted), volume_by<double>(lattice, lifted)}) {
    write_volume(volume, path);
    const Dataset dataset = dataset_from_file(path, asked, monitor);
    const std::vector<float> values = coefficients_of(dataset);
    const std::vector<float> expected = coefficients_of(plain);
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t n = 0; n < values.size(); ++n) EXPECT_NEAR(values[n], expected[n], 1e-4);
  }
}

// Beyond 2^53, a double does not hold the samples either.
TEST(FileSurface, SubtractsWideIntegersAsIntegers) {
  const Lattice lattice = lattice_of({12, 12, 12});
  const auto depth = [](const Eigen::Vector3d& x) {
    return std::round(3.0 - (x - Eigen::Vector3d::Constant(5.5)).norm());
  };
  Volume volume = volume_by<std::int64_t>(lattice, depth);
  const Isosurface plain(volume, 0.0);
  const double pedestal = std::ldexp(1.0, 60);
  std::vector<std::int64_t> lifted = volume.samples.as<std::int64_t>();
  for (std::int64_t& sample : lifted) sample += std::int64_t{1} << 60;
  const Isosurface surface(Volume{lattice, lifted}, pedestal);
  for (int n = 0; n < 12; ++n) EXPECT_EQ(surface.coefficient(n, 5, 6), plain.coefficient(n, 5, 6));
}

}  // namespace
}  // namespace isobench
