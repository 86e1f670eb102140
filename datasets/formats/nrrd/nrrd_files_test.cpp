// The files that an NRRD header names: one, lists and patterns. And headers that are wrong.
#include <gtest/gtest.h>

#include "isobench/datasets/formats/read_volume.h"
#include "isobench/datasets/formats/testing/packed_files.h"
#include "isobench/foundation/testing/test_folder.h"

namespace isobench {
namespace {

constexpr std::size_t slice_bytes = std::size_t{2} * nx * ny;

std::string slice_of(int k) { return shorts.substr(slice_bytes * static_cast<std::size_t>(k), slice_bytes); }

/// Writes a slice a file, with the names that the pattern of fmt makes.
void write_slices(const TestFolder& folder, const std::string& pattern, const std::string& before = "",
                  bool gzip = false) {
  for (int k = 0; k < nz; ++k) {
    const std::string data = before + slice_of(k);
    folder.write(fmt::format(fmt::runtime(pattern), k), gzip ? deflated(data, true) : data);
  }
}

std::filesystem::path nhdr(const TestFolder& folder, const std::string& more, const std::string& encoding = "raw") {
  return folder.write("a.nhdr", nrrd_header("short", encoding) + more);
}

TEST(NrrdFiles, PatternsAndLists) {
  const TestFolder folder;
  write_slices(folder, "s{:03d}.raw");
  write_slices(folder, "t {}.raw");
  write_slices(folder, "sub/h{}", "header");
  write_slices(folder, "z{}.gz", "12", true);
  expect_oblique(volume_of(nhdr(folder, "data file: s%03d.raw 0 4 1\n")));
  expect_oblique(volume_of(nhdr(folder, "data file: t %d.raw 0 4 1 2\n")));
  expect_oblique(volume_of(nhdr(folder, "byte skip: 6\ndata file: ./sub/h%d 0 4 1\n")));
  expect_oblique(volume_of(nhdr(folder, "byte skip: -1\ndata file: sub/h%i 0 4 1\n")));
  expect_oblique(volume_of(nhdr(folder, "byte skip: 2\ndata file: z%u.gz 0 4 1\n", "gzip")));
  expect_oblique(volume_of(nhdr(folder, "data file: LIST\ns000.raw\ns001.raw\nt 2.raw\ns003.raw\ns004.raw\n")));
  expect_oblique(
      volume_of(nhdr(folder, "data file: LIST 2\r\ns000.raw\r\ns001.raw\r\nt 2.raw\r\ns003.raw\r\ns004.raw")));
  // Backwards, and every second number.
  for (int k = 0; k < nz; ++k) folder.write(fmt::format("r{}%", 10 - 2 * k), slice_of(k));
  expect_oblique(volume_of(nhdr(folder, "data file: r%d%% 10 2 -2\n")));
}

TEST(NrrdFiles, PartsOfSeveralSlicesAndOfSeries) {
  const TestFolder folder;
  // Files of the array's own dimension share its slowest axis: here five files of one slice each, or one file.
  write_slices(folder, "s{}.raw");
  expect_oblique(volume_of(nhdr(folder, "data file: s%d.raw 0 4 1 3\n")));
  folder.write("all1.raw", shorts);
  expect_oblique(volume_of(nhdr(folder, "data file: all%d.raw 1 1 1 3\n")));
  const std::string four =
      "NRRD0004\ntype: short\ndimension: 4\nsizes: 7 6 5 4\nspacings: 1 1 1 nan\nkinds: domain domain domain "
      "time\nendian: little\nencoding: raw\n";
  const std::string all = bytes_with_axis(3, 4);
  VolumeChoice choice;
  for (const std::size_t step : {0U, 3U}) {
    choice.step = step;
    // Two steps a file, one step a file, one slice a file. Files of other steps are not read, but must be there.
    for (int n = 0; n < 2; ++n)
      folder.write(fmt::format("two{}", n),
                   all.substr(2 * shorts.size() * static_cast<std::size_t>(n), 2 * shorts.size()));
    for (int n = 0; n < 4; ++n)
      folder.write(fmt::format("one{}", n), all.substr(shorts.size() * static_cast<std::size_t>(n), shorts.size()));
    for (std::size_t n = 0; n < 20; ++n)
      folder.write(fmt::format("slice{:02d}", n), all.substr(slice_bytes * n, slice_bytes));
    for (const char* files : {"two%d 0 1 1 4", "one%d 0 3 1", "one%d 0 3 1 3", "slice%02d 0 19 1 2"}) {
      SCOPED_TRACE(files);
      EXPECT_EQ(floats_of(volume_of(folder.write("b.nhdr", four + "data file: " + files + "\n"), choice)),
                samples_at(static_cast<int>(step)));
    }
  }
}

TEST(NrrdFiles, FilesThatAreMissingOrOfAnotherSize) {
  const TestFolder folder;
  write_slices(folder, "s{}.raw");
  write_slices(folder, "z{}.gz", "", true);
  std::filesystem::remove(folder.path() / "s3.raw");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 1\n"), "its data file 's3.raw', 4 of 5, is missing");
  expect_data_error(nhdr(folder, "data file: LIST\ns0.raw\ns1.raw\ns2.raw\ns3.raw\ns4.raw\n"),
                    "'s3.raw', 4 of 5, is missing");
  std::filesystem::create_directory(folder.path() / "s3.raw");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 1\n"), "is not a file");
  std::filesystem::remove(folder.path() / "s3.raw");
  folder.write("s3.raw", slice_of(3) + "?");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 1\n"), "'s3.raw' is 1 byte longer than its samples");
  folder.write("s3.raw", slice_of(3).substr(2));
  try {
    volume_of(nhdr(folder, "data file: s%d.raw 0 4 1\n"));
    ADD_FAILURE();
  } catch (const DataError& error) {
    EXPECT_NE(std::string(error.what()).find("s3.raw: truncated: its header states 42 samples"), std::string::npos);
  }
  folder.write("z1.gz", deflated(slice_of(1) + slice_of(1), true));
  expect_data_error(nhdr(folder, "data file: z%d.gz 0 4 1\n", "gzip"), "'z1.gz' is 84 bytes longer");
  folder.write("z1.gz", deflated(slice_of(1).substr(4), true));
  EXPECT_THROW(volume_of(nhdr(folder, "data file: z%d.gz 0 4 1\n", "gzip")), DataError);
  expect_data_error(nhdr(folder, "data file: none.raw\n"), "its data file 'none.raw' is missing");
  expect_data_error(nhdr(folder, "data file: .\n"), "is not a file");
  expect_data_error(nhdr(folder, "data file:\n"), "its data file ''");
}

TEST(NrrdFiles, NumbersOfFilesThatDoNotFit) {
  const TestFolder folder;
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 3 1\n"), "it names 4 data files, but its sizes make 5");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 1000000000 1\n"), "it names 1000000001 data files");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 1 1\n"), "but its sizes make 30");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 1 4\n"), "cannot have 4 of its 3 dimensions");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 1 -1\n"), "of its 3 dimensions");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 2 1 3\n"), "cannot be divided among 3 data files");
  expect_data_error(nhdr(folder, "data file: LIST\ns0.raw\n"), "it names 1 data file, but its sizes make 5");
  expect_data_error(nhdr(folder, "data file: LIST\n"), "list of data files is empty");
  // So many files that no disk has them: nothing is made for those that are missing.
  std::string hostile = nrrd_header("short", "raw");
  hostile.replace(hostile.find("sizes: 7 6 5"), 12, "sizes: 1 1 1000000000");
  expect_data_error(folder.write("b.nhdr", hostile + "data file: s%d.raw 1 1000000000 1\n"),
                    "'s1.raw', 1 of 1000000000,");
}

TEST(NrrdFiles, PatternsThatAreNone) {
  const TestFolder folder;
  for (const char* pattern : {"%s",   "%n",  "%d%d", "%d-%03d",     "%",    "%5",  "%-3d", "%+d", "% d", "%*d",
                              "%1$d", "%ld", "%x",   "%999999999d", "%d%s", "%d%", "%.3d", "%f",  "%c",  "%%"}) {
    SCOPED_TRACE(pattern);
    expect_data_error(nhdr(folder, fmt::format("data file: {} 0 4 1\n", pattern)),
                      "is not understood; write one number");
  }
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 0\n"), "in steps of 0");
  expect_data_error(nhdr(folder, "data file: s%d.raw 0 4 -1\n"), "in steps of -1");
  expect_data_error(nhdr(folder, "data file: s%d.raw 4 0 1\n"), "from 4 to 0");
  expect_data_error(nhdr(folder, "data file: s%d.raw -9223372036854775808 9223372036854775807 1\n"),
                    "is not understood");
  expect_data_error(nhdr(folder, "data file: s%d.raw\n"), "'s%d.raw' is missing");
}

TEST(NrrdFiles, HeadersThatAreWrong) {
  struct Wrong {
    const char* remove;  ///< the line that begins so is taken out
    const char* add;
    const char* message;
  };
  const std::vector<Wrong> wrongs = {
      {"type", "type: block\nblock size: 4", "samples of type 'block' cannot be read"},
      {"type", "type: quad", "samples of type 'quad' cannot be read"},
      {"type", "", "has no 'type'"},
      {"encoding", "encoding: lz4", "its encoding 'lz4' is not known"},
      {"endian", "endian: middle", "neither little nor big"},
      {"dimension", "dimension: 0", "its dimension is '0'"},
      {"dimension", "dimension: 1e300", "its dimension is '1e300'"},
      {"dimension", "dimension: 2.5", "its dimension is '2.5'"},
      {"dimension", "dimension: 4", "4 axes"},
      {"sizes", "sizes: 1000000000 1000000000 1000000000", "is not that of a 3-D volume"},
      {"sizes", "sizes: 7 6 5.5", "is not that of a 3-D volume"},
      {"sizes", "sizes: 7 6", "3 numbers are expected"},
      {"", "sizes: 7 6 5", "'sizes' twice"},
      {"", "just words", "'just words' in its header is neither a field nor a comment"},
      {"", "kinds: domain domain", "3 entries are expected"},
      {"", "line skip: -1", "its line skip is below 0"},
      {"", "line skip: 1e300", "not a whole number"},
      {"", "byte skip: 1.5", "not a whole number"},
      {"", "byte skip: 1000000000000", "truncated"},
      {"", "line skip: 1000000000000", "truncated"},
      {"", "byte skip: -2", "truncated"},  // one byte would follow the samples
      {"", "byte skip: -1000000000000", "truncated"},
      {"space directions", "space directions: (1,0,0) (0,1,0)", "it has 2 space directions for its 3 axes"},
      {"space directions", "space directions: (1,0) (0,1,0) (0,0,1)", "has 2 numbers, but its space has 3 dimensions"},
      {"space directions", "space directions: (1,0,0) (0,1,0) 0,0,1", "vectors such as (1,0,0) are expected"},
      {"space directions", "space directions: (1,0,0) (0,1,0) (0,0,1", "vectors such as (1,0,0) are expected"},
      {"space directions", "space directions: (1,0,0) (0,x,0) (0,0,1)", "numbers are expected"},
      {"space directions", "space directions: (1,0,0) (0,0,0) (0,0,1)", "must be > 0"},
      {"space directions", "space directions: (1,0,0) (0,inf,0) (0,0,1)", "must be > 0"},
      {"space directions", "space directions: (1,0,0) none none", "1 of the 3 axes of its array is space"},
      {"space directions", "space directions: (1,0,0) (0,1,0) (1,1,0)", "nearly in a plane"},
      {"space origin", "space origin: (0,0)", "is not one point of its space"},
      {"space origin", "space origin: (0,0,0) (0,0,0)", "is not one point of its space"},
      {"space origin", "space origin: (0,inf,0)", "not a finite point"},
      {"", "space units: \"ell\" \"mm\" \"mm\"", "'ell' is not known"},
      {"", "space units: \"mm\"", "3 entries are expected"},
      {"", "units: \"mm\" \"mm\" \"cm\"", "its axes have different units"},
      {"space:", "space dimension: 1e9", "its space dimension is '1e9'"},
      {"space:", "space dimension: 2", "but its space has 2 dimensions"},
  };
  const TestFolder folder;
  for (const Wrong& wrong : wrongs) {
    SCOPED_TRACE(wrong.add);
    std::string header = nrrd_header("short", "raw");
    if (*wrong.remove != '\0') {
      const std::size_t at = header.find(std::string("\n") + wrong.remove) + 1;
      header.erase(at, header.find('\n', at) + 1 - at);
    }
    if (*wrong.add != '\0') header += std::string(wrong.add) + "\n";
    expect_data_error(folder.write("a.nrrd", with_data(header, shorts)), wrong.message);
  }
  // The packed data hold the samples, but not the bytes that are said to follow them.
  expect_data_error(
      folder.write("a.nrrd", with_data(nrrd_header("short", "gzip") + "byte skip: -4\n", deflated(shorts, true))),
      "truncated");
  for (const char* encoding : {"ascii", "hex"}) {
    expect_data_error(folder.write("a.nrrd", nrrd_header("short", encoding) + "byte skip: -1\n\n1 2 3"),
                      "a byte skip below 0 is not possible");
  }
  expect_data_error(folder.write("a.nrrd", nrrd_header("short", "hex") + "\n" + hex_text(shorts) + "0"), "stop before");
  expect_data_error(folder.write("a.nrrd", nrrd_header("short", "hex") + "\n0g" + hex_text(shorts)),
                    "no hexadecimal digit");
  expect_data_error(folder.write("a.nrrd", nrrd_header("short", "bzip2") + "\n" + bzipped(shorts).substr(0, 60)), "");
  expect_data_error(folder.write("a.nrrd", "NRRD0006\n" + nrrd_header("short", "raw").substr(9)), "versions 1 to 5");
  expect_data_error(folder.write("a.nrrd", "NRRD0004\nkey:=" + std::string(std::size_t{2} << 20U, 'x')), "has no end");
  std::string five = nrrd_header("short", "raw");
  five.replace(five.find("dimension: 3"), 12, "dimension: 5");
  five.replace(five.find("sizes: 7 6 5"), 12, "sizes: 7 6 5 2 2");
  five.replace(five.find("\nspace origin"), 1, " none none\n");
  expect_data_error(folder.write("a.nrrd", five + "\n" + shorts), "two axes of steps");
}

TEST(NrrdFiles, HostileSizesTakeNoMemory) {
  const TestFolder folder;
  for (const std::string encoding : {"raw", "gzip", "bzip2", "hex", "ascii"}) {
    for (const char* sizes : {"1000000 1000000 1", "1 1 1000000000", "1000 1000 1000"}) {
      for (const char* skip : {"", "byte skip: -1\n"}) {
        if (*skip != '\0' && (encoding == "hex" || encoding == "ascii")) continue;
        std::string header = nrrd_header("double", encoding) + skip;
        header.replace(header.find("sizes: 7 6 5"), 12, std::string("sizes: ") + sizes);
        const std::string data = encoding == "gzip"    ? deflated("1234", true)
                                 : encoding == "bzip2" ? bzipped("1234")
                                                       : "1234";
        SCOPED_TRACE(encoding + sizes + skip);
        expect_data_error(folder.write("a.nrrd", with_data(header, data)), "truncated");
      }
    }
  }
}

}  // namespace
}  // namespace isobench
