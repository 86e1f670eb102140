// TIFF files, written by libtiff: every sample and the spacing, whatever the coding and the order of the pages.
#include "isobench/datasets/formats/tiff/read_tiff.h"

#include <gtest/gtest.h>
#include <tiffio.h>

#include "isobench/datasets/formats/testing/oblique_files.h"
#include "isobench/datasets/formats/testing/volume_choices.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

struct TiffTestOptions {
  std::uint16_t format = SAMPLEFORMAT_UINT;
  std::uint16_t compression = COMPRESSION_NONE;
  std::uint16_t components = 1;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  bool is_tiled = false;
  bool is_separate = false;
  std::string mode = "w";
  std::string description;
  float resolution = 0.0F;  ///< along x; half of it along y
  std::uint16_t unit = RESUNIT_NONE;
};

/// Appends a page; `value` gives the sample at i, j of a component.
template <class T, class Value>
void add_page(TIFF* tiff, const TiffTestOptions& options, Value&& value) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, nx);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, ny);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, static_cast<int>(8 * sizeof(T)));
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, options.format);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, options.components);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, options.photometric);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, options.compression);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, options.is_separate ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  if (options.photometric == PHOTOMETRIC_PALETTE) {
    std::vector<std::uint16_t> colours(256, 7);
    TIFFSetField(tiff, TIFFTAG_COLORMAP, colours.data(), colours.data(), colours.data());
  }
  if (!options.description.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, options.description.c_str());
  if (options.resolution > 0.0F) {
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, static_cast<double>(options.resolution));
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, static_cast<double>(options.resolution) / 2.0);
    TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, options.unit);
  }
  constexpr int tile = 16;
  const int width = options.is_tiled ? tile : nx;
  const int height = options.is_tiled ? tile : 2;  // several strips
  if (options.is_tiled) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, height);
  }
  const int planes = options.is_separate ? options.components : 1;
  const int together = options.is_separate ? 1 : options.components;
  std::uint32_t chunk = 0;
  for (int plane = 0; plane < planes; ++plane) {
    for (int row = 0; row < ny; row += height) {
      std::vector<T> values;
      for (int j = row; j < row + height; ++j) {
        for (int i = 0; i < width; ++i) {
          for (int c = 0; c < together; ++c)
            values.push_back(i < nx && j < ny ? static_cast<T>(value(i, j, plane + c)) : T{});
        }
      }
      const auto bytes = static_cast<tmsize_t>(values.size() * sizeof(T));
      const tmsize_t written = options.is_tiled ? TIFFWriteEncodedTile(tiff, chunk++, values.data(), bytes)
                                                : TIFFWriteEncodedStrip(tiff, chunk++, values.data(), bytes);
      ASSERT_EQ(written, bytes);
    }
  }
  TIFFWriteDirectory(tiff);
}

/// Writes pages, of which `value` gives the sample at i, j of a component of a page.
template <class T, class Value>
std::filesystem::path write_tiff(const std::filesystem::path& path, int pages, const TiffTestOptions& options,
                                 Value&& value) {
  std::filesystem::create_directories(path.parent_path());
  TIFF* tiff = TIFFOpen(path.c_str(), options.mode.c_str());
  for (int page = 0; page < pages; ++page)
    add_page<T>(tiff, options, [&](int i, int j, int c) { return value(i, j, page, c); });
  TIFFClose(tiff);
  return path;
}

float slice_sample(int i, int j, int page, int /*component*/) { return sample_at(i, j, page); }

bool tiff_has_note(const VolumeFile& file, const std::string& part) {
  return std::any_of(file.notes.begin(), file.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

template <class T>
void expect_type(std::uint16_t format, SampleType type) {
  const TestFolder folder;
  for (const char* mode : {"wl", "wb", "w8"}) {
    for (const bool is_tiled : {false, true}) {
      TiffTestOptions options;
      options.format = format;
      options.mode = mode;
      options.is_tiled = is_tiled;
      const VolumeFile file = read_volume(write_tiff<T>(folder.path() / "a.tif", nz, options, slice_sample));
      EXPECT_EQ(file.volume.samples.type(), type);
      EXPECT_EQ(floats_of(file.volume), samples()) << mode << is_tiled;
      EXPECT_EQ(file.volume.lattice.spacing, Eigen::Vector3d::Ones());
      EXPECT_TRUE(tiff_has_note(file, "its spacing is not stated; 1 mm was taken"));
    }
  }
}

TEST(ReadTiff, EveryTypeInStripsAndTiles) {
  expect_type<std::uint8_t>(SAMPLEFORMAT_UINT, SampleType::u8);
  expect_type<std::int16_t>(SAMPLEFORMAT_INT, SampleType::i16);
  expect_type<std::uint16_t>(SAMPLEFORMAT_UINT, SampleType::u16);
  expect_type<std::uint32_t>(SAMPLEFORMAT_UINT, SampleType::u32);
  expect_type<std::int32_t>(SAMPLEFORMAT_INT, SampleType::i32);
  expect_type<float>(SAMPLEFORMAT_IEEEFP, SampleType::f32);
  expect_type<double>(SAMPLEFORMAT_IEEEFP, SampleType::f64);
}

TEST(ReadTiff, EveryCompression) {
  const TestFolder folder;
  for (const int compression :
       {COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS, COMPRESSION_ZSTD, COMPRESSION_LZMA}) {
    if (TIFFIsCODECConfigured(static_cast<std::uint16_t>(compression)) == 0) continue;
    TiffTestOptions options;
    options.compression = static_cast<std::uint16_t>(compression);
    EXPECT_EQ(floats_of(volume_of(write_tiff<std::uint16_t>(folder.path() / "a.tiff", nz, options, slice_sample))),
              samples())
        << compression;
  }
}

TEST(ReadTiff, ColoursAreChosenByComponent) {
  const TestFolder folder;
  for (const bool is_separate : {false, true}) {
    for (const bool is_tiled : {false, true}) {
      TiffTestOptions options;
      options.components = 3;
      options.photometric = PHOTOMETRIC_RGB;
      options.is_separate = is_separate;
      options.is_tiled = is_tiled;
      const auto path = write_tiff<std::uint8_t>(
          folder.path() / "a.tif", nz, options,
          [](int i, int j, int page, int component) { return component == 1 ? sample_at(i, j, page) : 0.0F; });
      expect_data_error(path, "choose one with --component 0 to 2");
      EXPECT_EQ(floats_of(volume_of(path, choose_component(1))), samples());
      EXPECT_EQ(floats_of(volume_of(path, choose_component(2))), std::vector<float>(nx * ny * nz, 0.0F));
    }
  }
}

TEST(ReadTiff, ImagejStatesSpacingChannelsAndSteps) {
  const TestFolder folder;
  TiffTestOptions options;
  options.resolution = 2.0F;
  options.description =
      "ImageJ=1.53t\nimages=30\nchannels=2\nslices=5\nframes=3\nhyperstack=true\nunit=micron\nspacing=3.5\n";
  // Channels follow each other, then slices, then frames.
  const auto path = write_tiff<std::uint16_t>(folder.path() / "a.tif", 30, options, [](int i, int j, int page, int) {
    const int frame = page / 10;
    return sample_at(i, j, page / 2 % 5) + 1000.0F * static_cast<float>(page % 2) + 5000.0F * static_cast<float>(frame);
  });
  expect_data_error(path, "choose one with --component 0 to 1");
  expect_data_error(path, "choose one with --step 0 to 2", choose_component(0));
  for (std::size_t component = 0; component < 2; ++component) {
    for (std::size_t step = 0; step < 3; ++step) {
      VolumeChoice choice = choose_component(component);
      choice.step = step;
      std::vector<float> expected = samples();
      for (float& value : expected)
        value += 1000.0F * static_cast<float>(component) + 5000.0F * static_cast<float>(step);
      const Volume volume = volume_of(path, choice);
      EXPECT_EQ(floats_of(volume), expected);
      EXPECT_LT((volume.lattice.spacing - Eigen::Vector3d(0.5e-3, 1e-3, 3.5e-3)).norm(), 1e-9);
    }
  }
}

TEST(ReadTiff, ImagejStacksBehindOnePage) {
  const TestFolder folder;
  TiffTestOptions options;
  options.mode = "wb";
  options.description = "ImageJ=1.53t\nimages=5\nslices=5\n";
  const auto path = folder.path() / "a.tif";
  TIFF* tiff = TIFFOpen(path.c_str(), "wb");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, nx);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, ny);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, ny);
  TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, options.description.c_str());
  std::vector<std::uint16_t> values(nx * ny, 9);
  TIFFWriteEncodedStrip(tiff, 0, values.data(), static_cast<tmsize_t>(2 * values.size()));
  TIFFClose(tiff);
  // The page's own samples are at its end: ImageJ writes the directory first.
  std::string bytes;
  {
    std::ifstream file(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  const std::size_t data = bytes.find(std::string("\0\x09\0\x09\0\x09", 6));
  ASSERT_NE(data, std::string::npos);
  const std::size_t page_bytes = 2 * nx * ny;
  const std::size_t room = 2 * nx * ny * nz;
  // Moves what follows the page: nothing may follow it, so the file is made again with the directory before the data.
  std::string behind = bytes + bytes_of_samples<std::uint16_t>(samples(), true);
  const std::string old_offset = bytes_of_value(static_cast<std::uint32_t>(data), true);
  const std::size_t entry = bytes.find(std::string("\x01\x11", 2), data + page_bytes);
  ASSERT_NE(entry, std::string::npos);
  const std::size_t field = bytes.find(old_offset, entry);
  ASSERT_NE(field, std::string::npos);
  behind.replace(field, 4, bytes_of_value(static_cast<std::uint32_t>(bytes.size()), true));
  ASSERT_EQ(behind.size(), bytes.size() + room);
  EXPECT_EQ(floats_of(volume_of(folder.write("a.tif", behind))), samples());
  expect_data_error(folder.write("a.tif", behind.substr(0, behind.size() - 1)), "truncated");
}

TEST(ReadTiff, OmeStatesSpacingAndTheOrderOfPages) {
  const TestFolder folder;
  TiffTestOptions options;
  options.description =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?><OME "
      "xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\"><Image "
      "ID=\"Image:0\"><Pixels DimensionOrder=\"XYZCT\" ID=\"Pixels:0\" PhysicalSizeX=\"0.5\" PhysicalSizeY=\"250\" "
      "PhysicalSizeYUnit=\"nm\" PhysicalSizeZ=\"3\" PhysicalSizeZUnit=\"&#181;m\" SizeC=\"2\" SizeT=\"1\" SizeX=\"7\" "
      "SizeY=\"6\" SizeZ=\"5\" Type=\"uint16\"><TiffData/></Pixels></Image></OME>";
  const auto path =
      write_tiff<std::uint16_t>(folder.path() / "a.ome.tif", 10, options, [](int i, int j, int page, int) {
        const int channel = page / 5;
        return sample_at(i, j, page % 5) + 1000.0F * static_cast<float>(channel);
      });
  const Volume volume = volume_of(path, choose_component(0));
  EXPECT_EQ(floats_of(volume), samples());
  EXPECT_LT((volume.lattice.spacing - Eigen::Vector3d(0.5e-3, 0.25e-3, 3e-3)).norm(), 1e-9);
  EXPECT_EQ(floats_of(volume_of(path, choose_component(1)))[0], samples()[0] + 1000.0F);
  expect_data_error(write_tiff<std::uint16_t>(folder.path() / "part.tif", 4, options, slice_sample),
                    "its description states 10 pages, but it has 4");
}

TEST(ReadTiff, ResolutionGivesTheSpacing) {
  const TestFolder folder;
  TiffTestOptions options;
  options.resolution = 20.0F;
  options.unit = RESUNIT_CENTIMETER;
  const VolumeFile file = read_volume(write_tiff<std::uint8_t>(folder.path() / "a.tif", nz, options, slice_sample));
  EXPECT_LT((file.volume.lattice.spacing - Eigen::Vector3d(0.5, 1.0, 0.5)).norm(), 1e-9);
  EXPECT_TRUE(tiff_has_note(file, "the distance of its slices is not stated; 0.5 mm was taken"));
}

/// Slices under names with numbers, in files of one page.
void write_slices(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  for (int k = 0; k < nz; ++k) {
    write_tiff<std::uint16_t>(folder / names[static_cast<std::size_t>(k)], 1, {},
                              [k](int i, int j, int, int) { return sample_at(i, j, k); });
  }
}

TEST(ReadTiff, FilesOfAFolderAreAStackInTheOrderOfTheirNumbers) {
  const TestFolder folder;
  const auto stack = folder.path() / "stack";
  write_slices(stack, {"s8.tif", "s9.tif", "s10.tif", "s11.TIF", "s12.tif"});
  std::filesystem::rename(stack / "s11.TIF", stack / "s11.tif");
  folder.write("stack/.hidden.tif", "x");
  EXPECT_EQ(floats_of(volume_of(stack)), samples());
  EXPECT_EQ(floats_of(volume_of(stack / "s*.tif")), samples());
  EXPECT_EQ(floats_of(volume_of(stack / "s%02d.tif")), samples());
  const VolumeFile one = read_volume(stack / "s9.tif");
  EXPECT_EQ(one.volume.lattice.size[2], 1);
  EXPECT_TRUE(tiff_has_note(one, "one slice; give its folder"));
  std::filesystem::remove(stack / "s10.tif");
  expect_data_error(stack, "the numbers of s9.tif and s11.tif are not as far apart as others");
  write_slices(folder.path() / "two", {"a1.tif", "a2.tif", "b1.tif", "b2.tif", "b3.tif"});
  expect_data_error(folder.path() / "two", "differ in more than a number");
  EXPECT_EQ(volume_of(folder.path() / "two" / "b*.tif").lattice.size[2], 3);
  write_slices(folder.path() / "both", {"z1c1.tif", "z1c2.tif", "z2c1.tif", "z2c2.tif", "z3c1.tif"});
  expect_data_error(folder.path() / "both", "numbered in 2 places");
  EXPECT_EQ(volume_of(folder.path() / "both" / "z*c1.tif").lattice.size[2], 3);
  expect_data_error(folder.path() / "none*.tif", "no such file");
  write_tiff<std::uint8_t>(folder.path() / "two/b4.tif", 1, {}, slice_sample);
  expect_data_error(folder.path() / "two" / "b*.tif", "b4.tif has 7 × 6 samples of u8");
}

TEST(ReadTiff, PalettesAndInvertedSamplesAreNoted) {
  const TestFolder folder;
  TiffTestOptions options;
  options.photometric = PHOTOMETRIC_PALETTE;
  const VolumeFile labels = read_volume(write_tiff<std::uint8_t>(folder.path() / "a.tif", nz, options, slice_sample));
  EXPECT_EQ(floats_of(labels.volume), samples());
  EXPECT_TRUE(tiff_has_note(labels, "table of colours"));
  options.photometric = PHOTOMETRIC_MINISWHITE;
  const VolumeFile white = read_volume(write_tiff<std::uint8_t>(folder.path() / "a.tif", nz, options, slice_sample));
  EXPECT_EQ(floats_of(white.volume), samples());
  EXPECT_TRUE(tiff_has_note(white, "small samples are bright"));
}

TEST(ReadBadTiff, EveryTruncationAndChangedByteIsHandled) {
  const TestFolder folder;
  for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE}) {
    TiffTestOptions options;
    options.compression = static_cast<std::uint16_t>(compression);
    const auto path = write_tiff<std::uint16_t>(folder.path() / "a.tif", 2, options, slice_sample);
    std::string whole;
    {
      std::ifstream file(path, std::ios::binary);
      whole.assign(std::istreambuf_iterator<char>(file), {});
    }
    const auto expect_handled = [&](const std::string& bytes) {
      try {
        read_volume(folder.write("a.tif", bytes));
      } catch (const DataError& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_NE(message.find("a.tif"), std::string::npos) << message;
      }
    };
    for (std::size_t at = 0; at < whole.size(); at += 3 + at % 3) {
      expect_handled(whole.substr(0, at));
      for (const char value : {'\0', '\xff', '\x7f'}) {
        std::string changed = whole;
        changed[at] = value;
        expect_handled(changed);
      }
    }
  }
}

TEST(ReadBadTiff, HostileSizesTakeNoMemory) {
  const TestFolder folder;
  const auto write_large = [&](std::uint16_t compression, std::uint32_t rows, bool is_tiled) {
    TIFF* tiff = TIFFOpen((folder.path() / "a.tif").c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 60000);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, rows);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, compression);
    if (is_tiled) TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 60000);
    if (is_tiled) TIFFSetField(tiff, TIFFTAG_TILELENGTH, 60000);
    if (!is_tiled) TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rows);
    TIFFWriteDirectory(tiff);
    TIFFClose(tiff);
    return folder.path() / "a.tif";
  };
  for (const std::uint16_t compression : {COMPRESSION_NONE, COMPRESSION_ADOBE_DEFLATE}) {
    expect_data_error(write_large(compression, 60000, false), "a.tif");
    expect_data_error(write_large(compression, 60000, true), "a.tif");
  }
  expect_data_error(folder.write("b.tif", "no TIFF"), "not a TIFF file, or damaged");
}

}  // namespace
}  // namespace isobench
