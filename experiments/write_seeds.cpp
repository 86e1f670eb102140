// Writes the seeds of the fuzz targets (datasets/fuzz_target.h): good inputs from the project's own writers, and those
// that differ from them by one hostile change. What fuzzing found lies beside them under names of its own and is not
// touched. To make them again, with the preset "fuzz":
//   ninja -C build/fuzz write_seeds && build/fuzz/bin/write_seeds .
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "datasets/oblique_files.h"
#include "methods/mesh_files.h"
#include "reports/sample_records.h"

namespace isobench {
namespace {

namespace fs = std::filesystem;

class Corpus {
 public:
  Corpus(const fs::path& root, const std::string& floor, const std::string& target)
      : folder_(root / floor / "corpus" / target) {
    fs::create_directories(folder_);
  }
  void write(std::string name, const std::string& bytes) const {
    std::replace(name.begin(), name.end(), ' ', '_');
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::logic_error("no '" + what + "' to replace");
  return text.replace(at, what.size(), with);
}

std::string floats() { return bytes_of_samples<float>(samples()); }

void write_nrrd(const fs::path& root) {
  const Corpus corpus(root, "datasets", "nrrd");
  const std::string head = nrrd_header("float", "raw") + "\n";
  const std::string sizes = "sizes: 7 6 5";
  corpus.write("good-float", head + floats());
  corpus.write("good-big-short", replaced(nrrd_header("short", "raw"), "little", "big") + "\n" +
                                     bytes_of_samples<std::int16_t>(samples(), true));
  corpus.write("good-gzip",
               nrrd_header("uchar", "gzip") + "\n" + deflated(bytes_of_samples<std::uint8_t>(samples()), true));
  corpus.write("good-ascii", nrrd_header("float", "ascii") + "\n" + text_of_samples());
  const std::string detached =
      "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nspacings: 0.5 nan 2\nspace: LAS\nspace units: \"cm\" \"cm\" "
      "\"cm\"\nencoding: raw\nbyte skip: -1\ndata file: data.raw\n";
  corpus.write("good-detached", detached);
  corpus.write("good-skips", replaced(replaced(replaced(detached, "byte skip: -1", "line skip: 1\nbyte skip: 2"),
                                               "encoding: raw", "encoding: text"),
                                      "data.raw", "data.txt"));
  corpus.write("bad-cut", (head + floats()).substr(0, 700));
  corpus.write("bad-damaged-gzip",
               replaced(nrrd_header("uchar", "gzip") + "\n" + deflated(bytes_of_samples<std::uint8_t>(samples()), true),
                        "\x1f\x8b\x08", "\x1f\x8b\x07"));
  for (const char* hostile : {"7 6 0", "7 6 -5", "999999 999999 999999", "2147483648 1 1", "4294967303 6 5",
                              "1e300 1 1", "nan 6 5", "7 6", "60000 60000 200"}) {
    corpus.write(fmt::format("bad-sizes {}", hostile),
                 replaced(head, sizes, fmt::format("sizes: {}", hostile)) + "1234");
  }
  // A gibibyte promised by, and one of zeros within, a few hundred bytes of gzip would be: this is a mebibyte each.
  const std::string mebibyte = deflated(std::string(std::size_t{1} << 20U, '\0'), true);
  const std::string zipped = nrrd_header("uchar", "gzip") + "\n";
  corpus.write("bad-promises-more-than-gzip", replaced(zipped, sizes, "sizes: 1000 1000 2") + mebibyte);
}

void write_metaimage(const fs::path& root) {
  const Corpus corpus(root, "datasets", "metaimage");
  const std::string local = metaimage_header("ElementType = MET_FLOAT\nElementDataFile = LOCAL");
  const std::string size = "DimSize = 7 6 5";
  corpus.write("good-float", local + floats());
  corpus.write("good-compressed",
               metaimage_header("CompressedData = True\nElementType = MET_SHORT\nElementDataFile = LOCAL") +
                   deflated(bytes_of_samples<std::int16_t>(samples()), false));
  corpus.write("good-text", replaced(local, "BinaryData = True", "BinaryData = False") + text_of_samples());
  const std::string detached =
      "NDims = 3\nDimSize = 4 4 4\nElementSize = 1 2 3\nDistanceUnits = cm\nHeaderSize = -1\nElementType = MET_UCHAR\n"
      "ElementDataFile = data.raw\n";
  corpus.write("good-detached", detached);
  corpus.write("bad-header-size", replaced(detached, "HeaderSize = -1", "HeaderSize = 1e300"));
  corpus.write("bad-unit", replaced(detached, "cm", "ell"));
  corpus.write("bad-cut", (local + floats()).substr(0, 600));
  for (const char* hostile : {"7 6 0", "7 -6 5", "60000 60000 200", "2147483647 2147483647 2147483647", "7 6 5 4"}) {
    corpus.write(fmt::format("bad-size {}", hostile),
                 replaced(local, size, fmt::format("DimSize = {}", hostile)) + "1234");
  }
}

void write_inrimage(const fs::path& root) {
  const Corpus corpus(root, "datasets", "inrimage");
  const std::string whole = inrimage(inrimage_fields("TYPE=float\nPIXSIZE=32 bits", "decm"), floats());
  corpus.write("good-float", whole);
  corpus.write("good-big-short", inrimage(inrimage_fields("TYPE=signed fixed\nPIXSIZE=16 bits", "sun"),
                                          bytes_of_samples<std::int16_t>(samples(), true)));
  corpus.write("good-gzip", deflated(whole, true));
  corpus.write("bad-cut", whole.substr(0, 500));
  corpus.write("bad-endless-header", replaced(whole, "##}\n", "\n\n\n\n"));
  for (const char* hostile : {"0", "-7", "90000", "4294967303", "1e300"}) {
    corpus.write(fmt::format("bad-xdim {}", hostile), replaced(whole, "XDIM=7\n", fmt::format("XDIM={}\n", hostile)));
  }
}

void write_nifti(const fs::path& root) {
  const Corpus corpus(root, "datasets", "nifti");
  NiftiHeader header;
  header.put_sform(oblique(), origin);
  corpus.write("good-sform", header.bytes() + floats());
  corpus.write("good-gzip", deflated(header.bytes() + floats(), true));
  corpus.write("bad-cut", header.bytes() + floats().substr(0, 300));
  NiftiHeader swapped(true);
  swapped.put_qform(oblique(), origin);
  swapped.put<std::int16_t>(70, 4);
  swapped.put<std::int16_t>(72, 16);
  swapped.put<float>(112, 0.5F);
  swapped.put<float>(116, -3.0F);
  corpus.write("good-swapped-qform", swapped.bytes() + bytes_of_samples<std::int16_t>(samples(), true));
  const auto hostile = [&](const std::string& name, std::size_t at, auto value) {
    NiftiHeader changed = header;
    changed.put(at, value);
    corpus.write("bad-" + name, changed.bytes() + floats());
  };
  hostile("size-zero", 42, std::int16_t{0});
  hostile("size-negative", 44, std::int16_t{-6});
  hostile("size-large", 46, std::int16_t{32767});
  hostile("dimensions", 40, std::int16_t{8});
  hostile("type", 70, std::int16_t{1536});
  hostile("bits", 72, std::int16_t{0});
  hostile("offset-large", 108, 1e30F);
  hostile("offset-nan", 108, std::numeric_limits<float>::quiet_NaN());
  NiftiHeader unplaced;
  corpus.write("good-unplaced", unplaced.bytes() + floats());
  unplaced.put(80, 0.0F);
  corpus.write("bad-spacing-zero", unplaced.bytes() + floats());
}

void write_vti(const fs::path& root) {
  const Corpus corpus(root, "datasets", "vti");
  const std::string whole = vti_text(text_of_samples());
  corpus.write("good-text", whole);
  corpus.write("bad-cut", whole.substr(0, 900));
  const std::string extent = "2 8 0 5 0 4";
  const std::string all = "WholeExtent=\"" + extent;
  const std::string piece = "Piece Extent=\"" + extent;
  corpus.write("bad-extent-large", replaced(replaced(whole, all, "WholeExtent=\"0 99999 0 99999 0 99999"), piece,
                                            "Piece Extent=\"0 99999 0 99999 0 99999"));
  corpus.write("bad-extent-turned", replaced(whole, all, "WholeExtent=\"8 2 0 5 0 4"));
  corpus.write("bad-piece-outside", replaced(whole, piece, "Piece Extent=\"2 8 0 5 0 400"));
  corpus.write("bad-components", replaced(whole, "Name=\"v\"", "Name=\"v\" NumberOfComponents=\"1000000000\""));
  corpus.write("bad-spacing", replaced(whole, "Spacing=\"0.5", "Spacing=\"nan"));
  const std::string small =
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\"{}>\n"
      "<ImageData WholeExtent=\"0 1 0 1 0 1\" Origin=\"0 0 0\" Spacing=\"1 1 1\">\n"
      "<Piece Extent=\"0 1 0 1 0 1\"><PointData Scalars=\"v\"><DataArray type=\"UInt8\" Name=\"v\" "
      "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>\n"
      "<AppendedData encoding=\"raw\">_{}</AppendedData></VTKFile>\n";
  const std::string eight("\1\2\3\4\5\6\7\x08", 8);
  corpus.write("good-appended", replaced(replaced(small, "{}", ""), "{}", bytes_of_value<std::uint32_t>(8) + eight));
  const std::string zipped = deflated(eight, false);
  const auto compressed = [&](std::uint32_t blocks, std::uint32_t size, std::uint32_t last, std::uint32_t bytes) {
    std::string data;
    for (const std::uint32_t number : {blocks, size, last, bytes}) data += bytes_of_value(number);
    return replaced(replaced(small, "{}", " compressor=\"vtkZLibDataCompressor\""), "{}", data + zipped);
  };
  const auto length = static_cast<std::uint32_t>(zipped.size());
  corpus.write("good-compressed", compressed(1, 32768, 8, length));
  corpus.write("bad-blocks", compressed(4000000000U, 32768, 8, length));
  corpus.write("bad-block-size", compressed(1, 4000000000U, 4000000000U, length));
  corpus.write("bad-block-bytes", compressed(1, 32768, 8, 4000000000U));
}

void write_raw(const fs::path& root) {
  const Corpus corpus(root, "datasets", "raw");
  // Sizes of a low and an upper byte each, type, byte order, number of files.
  corpus.write("good-u8", std::string("\3\0\2\0\2\0\0\0\1", 9) + std::string(12, '\x05'));
  corpus.write("good-i16-slices", std::string("\3\0\2\0\2\0\3\1\2", 9) + std::string(24, '\x05'));
  corpus.write("bad-no-files", std::string("\3\0\2\0\2\0\0\0\0", 9) + std::string(12, '\x05'));
  corpus.write("bad-size-zero", std::string("\3\0\0\0\2\0\0\0\1", 9) + std::string(12, '\x05'));
  corpus.write("bad-size-negative", std::string("\3\x80\2\0\2\0\0\0\1", 9) + std::string(12, '\x05'));
  corpus.write("bad-size-overflows", std::string("\3\x7f\2\x7f\2\x7f\0\0\1", 9) + std::string(12, '\x05'));
  corpus.write("bad-too-short", std::string("\3\0\2\0\2\0\7\0\1", 9) + std::string(12, '\x05'));
}

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  const double third = 1.0 / 3.0;
  mesh.vertices = {{0.0, 0.0, third}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1e-3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

std::string written(const TriangleMesh& mesh, const std::string& ending) {
  const TestFolder folder;
  const fs::path path = folder.path() / ("mesh" + ending);
  write_mesh(mesh, path);
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write_vtp(const fs::path& root) {
  const Corpus corpus(root, "methods", "vtp");
  TriangleMesh mesh = tetrahedron();
  mesh.vertex_data["h0"] = {1.0, 2.0, 3.0, 4.0};
  mesh.triangle_data["radius_ratio"] = {0.1, 0.2, 0.3, 0.4};
  const std::string whole = written(mesh, ".vtp");
  corpus.write("good-compressed", whole);
  corpus.write("bad-cut", whole.substr(0, whole.size() - 100));
  const std::string text =
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>\n"
      "<Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"1\">\n"
      "<PointData><DataArray type=\"Float32\" Name=\"h0\" format=\"ascii\">1 2 3</DataArray></PointData>\n"
      "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray>"
      "</Points>\n"
      "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>\n"
      "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys>\n"
      "</Piece></PolyData></VTKFile>\n";
  corpus.write("good-text", text);
  // Three indices of 32 bits behind their length, in base64.
  corpus.write("good-base64", replaced(text, "\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2",
                                       "\"Int32\" Name=\"connectivity\" format=\"binary\">DAAAAAAAAAABAAAAAgAAAA=="));
  corpus.write("bad-index", replaced(text, ">0 1 2<", ">0 1 3<"));
  corpus.write("bad-offsets", replaced(text, ">3<", ">900<"));
  corpus.write("bad-offsets-negative", replaced(text, ">3<", ">-3<"));
  corpus.write("bad-counts", replaced(replaced(text, "NumberOfPoints=\"3\"", "NumberOfPoints=\"900000000000\""),
                                      "NumberOfPolys=\"1\"", "NumberOfPolys=\"18446744073709551615\""));
  corpus.write("bad-nan", replaced(text, "0 0 0 1 0 0", "0 0 0 nan 0 0"));
  corpus.write("bad-lines", replaced(text, "NumberOfLines=\"0\"", "NumberOfLines=\"1\""));
}

void write_ply(const fs::path& root) {
  const Corpus corpus(root, "methods", "ply");
  const std::string whole = written(tetrahedron(), ".ply");
  corpus.write("good-binary", whole);
  const std::string text =
      "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nelement face 1\nproperty list uchar int vertex_index\n"
      "property list uchar float texture\nelement edge 1\nproperty int first\nend_header\n"
      "0 0 0 255\n1 0 0 255\n0 1 0.5 255\n3 0 1 2 2 0.5 0.5\n7\n";
  corpus.write("good-text", text);
  corpus.write("bad-cut", whole.substr(0, whole.size() - 7));
  corpus.write("bad-index", replaced(text, "3 0 1 2", "3 0 1 3"));
  corpus.write("bad-counts", replaced(text, "element vertex 3", "element vertex 900000000000000000"));
  corpus.write("bad-count-negative", replaced(text, "element face 1", "element face -1"));
  corpus.write("bad-list", replaced(text, "2 0.5 0.5", "1e300 0.5 0.5"));
  corpus.write("bad-axes", replaced(text, "property float z", "property float x"));
  corpus.write("bad-nan", replaced(text, "0 1 0.5", "0 nan 0.5"));
}

void write_text_meshes(const fs::path& root) {
  const Corpus off(root, "methods", "off");
  const std::string whole = written(tetrahedron(), ".off");
  off.write("good-written", whole);
  off.write("good-coloured", "COFF 3 1 0\n# corners\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n\n0 1 0 1 1 1 1\n3 0 1 2\n");
  off.write("bad-cut", whole.substr(0, whole.size() - 9));
  off.write("bad-index", replaced(whole, "3 0 1 2", "3 0 1 4"));
  off.write("bad-index-negative", replaced(whole, "3 0 1 2", "3 0 1 -2"));
  off.write("bad-counts", replaced(whole, "4 4 0", "900000000000000000 4 0"));
  off.write("bad-polygon", replaced(whole, "3 0 1 2", "4 0 1 2"));
  off.write("bad-infinite", replaced(whole, "1 0 0", "1e999 0 0"));
  const Corpus obj(root, "methods", "obj");
  const std::string text = "# by hand\no thing\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 +1 0\nf 1//1 2//1 3//1\nf -3 -2 -1\n";
  obj.write("good-written", written(tetrahedron(), ".obj"));
  obj.write("good-text", text);
  obj.write("bad-index", replaced(text, "3//1", "4//1"));
  obj.write("bad-index-zero", replaced(text, "1//1 ", "0//1 "));
  obj.write("bad-index-far-back", replaced(text, "f -3", "f -9223372036854775808"));
  obj.write("bad-nan", replaced(text, "v 1 0 0", "v nan 0 0"));
}

void write_stl(const fs::path& root) {
  const Corpus corpus(root, "methods", "stl");
  const std::string whole = written(tetrahedron(), ".stl");
  const std::string text =
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 -0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid x\n";
  corpus.write("good-binary", whole);
  corpus.write("good-text", text);
  corpus.write("bad-cut", whole.substr(0, whole.size() - 1));
  corpus.write("bad-count", replaced(whole, std::string("\4\0\0\0", 4), "\xff\xff\xff\xff"));
  corpus.write("bad-half-triangle", "solid x\nvertex 0 0 0\nvertex 1 0 0\nendsolid x\n");
  corpus.write("bad-infinite", replaced(text, "1 0 0", "1e40 0 0"));
  corpus.write("bad-empty", "solid x\nendsolid x\n");
}

void write_manifest(const fs::path& root) {
  const Corpus corpus(root, "datasets", "manifest");
  const std::string text = R"(title = "T"
licence = "L"
isovalue = -3
inside = "below"
kernel = "catmull-rom"
prepare = [
  { step = "crop", margin = 1 }, { step = "pad", voxels = 3, value = -1 }, { step = "signed-distance" },
  { step = "resample", spacing = 0.7 }, { step = "gaussian", sigma = [1, 2.5, 3] },
  { step = "close-border", value = 9.5, layers = 3 }, { step = "subsample", factor = 2 },
]
[data]
folder = "f"
raw = { size = [4, 5, 6], spacing = 2, type = "i16", byte_order = "big" }
files = [ { name = "a" }, { name = "b" } ]
)";
  corpus.write("good-steps", text);
  corpus.write("good-labels", replaced(text, "{ step = \"crop\", margin = 1 }",
                                       "{ step = \"labels\", labels = [1, 3] }, { step = \"largest-component\" }"));
  corpus.write("good-threshold", replaced(text, "step = \"crop\", margin = 1", "step = \"threshold\", at = 2"));
  corpus.write("good-phantom", "title = \"P\"\n[phantom]\nname = \"torus\"\nnodes = 64\n");
  const std::string package = R"(title = "T"
isovalue = 30.5
[data]
package = "libcgal-demo"
archive = "usr/share/data.tar.gz"
files = [ { name = "s.inr", member = "data/s.inr", sha256 = ")" +
                              std::string(64, 'a') + "\" } ]\n";
  corpus.write("good-package", package);
  corpus.write("bad-package-option", replaced(package, "libcgal-demo", "--option=x"));
  corpus.write("bad-member-option", replaced(package, "data/s.inr", "--to-command=x"));
  corpus.write("bad-archive-outside", replaced(package, "usr/share", "../share"));
  corpus.write("bad-folder-outside", replaced(text, "folder = \"f\"", "folder = \"f/../../g\""));
  corpus.write("bad-name-absolute", replaced(text, "name = \"a\"", "name = \"/etc/passwd\""));
  corpus.write("bad-name-long", replaced(text, "name = \"a\"", "name = \"" + std::string(300, 'n') + "\""));
  corpus.write("bad-name-control", replaced(text, "name = \"a\"", "name = \"a\\u001bb\""));
  corpus.write("bad-nodes", "title = \"P\"\n[phantom]\nname = \"torus\"\nnodes = 2147483647\n");
  corpus.write("bad-pad", replaced(text, "voxels = 3", "voxels = 99999999999"));
  corpus.write("bad-sigma", replaced(text, "sigma = [1", "sigma = [1e9"));
  corpus.write("good-sigma-small", replaced(text, "sigma = [1", "sigma = [1e-200"));
  corpus.write("bad-value", replaced(text, "value = -1", "value = 1e39"));
  // Found by fuzzing: no double is exactly this integer.
  corpus.write("good-integer-beyond-double", replaced(text, "spacing = 2,", "spacing = 9007199254740993,"));
  corpus.write("bad-raw-size", replaced(text, "[4, 5, 6]", "[4, 5, -6]"));
  corpus.write("bad-nested", std::string(500, '[') + "\n");
}

void write_measure(const fs::path& root) {
  const Corpus corpus(root, "metrics", "measure");
  const auto bytes = [](const std::vector<Eigen::Vector3d>& vertices, const std::string& corners) {
    std::string text(1, static_cast<char>(vertices.size()));
    for (const Eigen::Vector3d& vertex : vertices) {
      for (int axis = 0; axis < 3; ++axis) text += bytes_of_value(vertex[axis]);
    }
    return text + corners;
  };
  const std::vector<Eigen::Vector3d> vertices = {{7, 4, 4}, {1, 4, 4}, {4, 7, 4}, {4, 1, 4}, {4, 4, 7}, {4, 4, 1}};
  const std::string corners("\0\2\4\2\1\4\1\3\4\3\0\4\2\0\5\1\2\5\3\1\5\0\3\5", 24);
  corpus.write("good-octahedron", bytes(vertices, corners));
  corpus.write("good-open", bytes(vertices, corners.substr(0, 9)));
  corpus.write("good-collapsed", bytes(vertices, corners + std::string("\1\1\1\2\2\3", 6)));
  corpus.write("good-all-collapsed", bytes(vertices, std::string("\1\1\1\2\2\3", 6)));
  corpus.write("good-twice", bytes(vertices, corners + corners));
  corpus.write("good-one-place", bytes(std::vector<Eigen::Vector3d>(6, {4, 4, 4}), corners));
  std::vector<Eigen::Vector3d> flat = vertices;
  for (Eigen::Vector3d& vertex : flat) vertex.tail<2>().setZero();
  corpus.write("good-one-line", bytes(flat, corners));
  corpus.write("bad-index", bytes(vertices, corners + std::string("\0\1\6", 3)));
  corpus.write("bad-no-triangles", bytes(vertices, ""));
  for (const auto& [name, value] :
       {std::pair("nan", std::numeric_limits<double>::quiet_NaN()),
        std::pair("infinite", std::numeric_limits<double>::infinity()), std::pair("far", 1e300)}) {
    std::vector<Eigen::Vector3d> hostile = vertices;
    hostile[2].y() = value;
    corpus.write(fmt::format("bad-{}", name), bytes(hostile, corners));
  }
}

std::string text_of_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// JSON without line breaks and indentation: libFuzzer cuts seeds that are longer than the inputs it makes.
std::string compact(const std::string& json) {
  std::string text;
  for (std::size_t n = 0; n < json.size(); ++n) {
    if (json[n] == '\n')
      n = json.find_first_not_of(' ', n + 1) - 1;
    else
      text += json[n];
  }
  return text;
}

void write_records(const fs::path& root) {
  const Corpus corpus(root, "reports", "record");
  RunRecord record = sample_record("skull", "particles", "best");
  record.measurement->radius_ratio.histogram = Histogram(0.0, 1.0, 3);
  const std::string whole = compact(to_json(record));
  corpus.write("good-whole", whole);
  RunRecord failed = record;
  failed.status = Status::timeout;
  failed.measurement.reset();
  failed.dataset.reset();
  failed.reason = "longer than 20 minutes | no table's business & \\LaTeX's";
  corpus.write("good-failed", compact(to_json(failed)));
  corpus.write("bad-cut", whole.substr(0, 1000));
  corpus.write("bad-run-outside", replaced(whole, "\"skull-best\"", "\"../../skull\""));
  corpus.write("bad-run-empty", replaced(whole, "\"skull-best\"", "\"\""));
  corpus.write("bad-dataset-hidden", replaced(whole, "\"dataset\": \"skull\"", "\"dataset\": \"x/.tmp-y.toml\""));
  corpus.write("bad-threads", replaced(whole, "\"threads\": 2", "\"threads\": 1e300"));
  corpus.write("bad-cores", replaced(whole, "\"cores\": 0", "\"cores\": 99999999999"));
  corpus.write("bad-triangles", replaced(whole, "\"triangles\": 2000", "\"triangles\": -1"));
  corpus.write("bad-schema", replaced(whole, "\"schema_version\": 1", "\"schema_version\": 2"));
  corpus.write("bad-reference", replaced(whole, "\"reference_k\": 2", "\"reference_k\": 1000000"));
  corpus.write("bad-nested", std::string(2000, '['));
}

void write_plans(const fs::path& root) {
  const Corpus corpus(root, "reports", "plan");
  RunRequest uniform = sample_record("torus", "marching-cubes").request;
  uniform.sizing = {};
  uniform.sizing.vertices = 50000;
  const std::string whole = compact(plan_to_json({sample_record("skull", "particles").request, uniform}));
  corpus.write("good-whole", whole);
  corpus.write("good-empty", compact(plan_to_json({})));
  corpus.write("bad-cut", whole.substr(0, 700));
  corpus.write("bad-run-outside", replaced(whole, "\"torus-marching-cubes\"", "\"/elsewhere/torus\""));
  corpus.write("bad-seed", replaced(whole, "\"seed\": 1", "\"seed\": -1"));
  corpus.write("bad-parameter", replaced(whole, "\"sweeps\": 60.0", "\"sweeps\": [60.0]"));
}

void write_published(const fs::path& root) {
  const Corpus corpus(root, "reports", "published");
  const std::string text = R"(source = "Somebody 1999"
short = "S. 1999"
[[method]]
printed = "ps"
name = "particles-2007"
beside = ["particles"]
[[method]]
printed = "mc"
name = "marching-cubes"
[[quantity]]
name = "radius_ratio_min"
[[quantity]]
name = "share"
unit = "%"
[[figures]]
table = "Table 2"
method = "ps"
dataset = "skull"
radius_ratio_min = "0.40"
share = "< 0.004"
[[claim]]
words = "It is so."
figure = "radius_ratio_min"
order = "ps >> mc"
much = 1.25
[[claim]]
words = "And so."
figure = ["valence_lt5_percent", "valence_gt7_percent"]
method = "ps"
at_most = 0.008
[[claim]]
words = "And so, too."
figure = "distance_mean"
method = "ps"
smaller = "epsilon"
gives = "smaller"
)";
  corpus.write("good-whole", text);
  corpus.write("good-not-finite", replaced(text, "\"0.40\"", "\"1e999\""));
  corpus.write("bad-order", replaced(text, "ps >> mc", "ps >> mc >>"));
  corpus.write("bad-method", replaced(text, "method = \"ps\"\nsmaller", "method = \"pt\"\nsmaller"));
  corpus.write("bad-figure", replaced(text, "\"distance_mean\"", "\"distance_maen\""));
  corpus.write("bad-number", replaced(text, "\"0.40\"", "0.40"));
}

void write_configs(const fs::path& root) {
  const Corpus corpus(root, "experiments", "config");
  for (const char* name : {"ablation", "quick", "sweep"}) {
    corpus.write(fmt::format("good-{}", name), text_of_file(root / "experiments" / (std::string(name) + ".toml")));
  }
  const std::string text = R"(title = "a \"quoted\" title"
dataset = ["torus", "sphere"]
seed = [1, 7]
repeats = 2
timing = false
[sampling]
epsilon = [0.5, 0.75]
delta = 0.3
floor = 0.25
[[override]]
dataset = "sphere"
method = "few"
sampling = { edge_length = 2.5 }
limits = { minutes = 3 }
[[vary]]
key = "method.few.rounds"
values = [1, 2]
[[vary]]
key = "reference.k"
values = 3
[[method]]
name = "particles"
label = "few"
sweeps = [5, 10]
[[method]]
name = "marching-cubes"
[limits]
minutes = 20
memory_gb = 8
[quick]
dataset = "slab"
method = ["few"]
repeats = 1
)";
  corpus.write("good-grid", text);
  corpus.write("bad-published", text + "[published]\nsource = \"/etc/passwd\"\n");
  corpus.write("bad-published-folder", text + "[published]\nsource = \".\"\n");
  corpus.write("bad-dataset-path", replaced(text, "\"sphere\"]", "\"../../sphere\"]"));
  corpus.write("bad-dataset-control", replaced(text, "\"sphere\"]", "\"sph\\u001bere\"]"));
  corpus.write("bad-method", replaced(text, "name = \"particles\"", "name = \"../particles\""));
  corpus.write("bad-label-control", replaced(text, "label = \"few\"", "label = \"f\\new\""));
  corpus.write("bad-label-long", replaced(text, "label = \"few\"", "label = \"" + std::string(300, 'l') + "\""));
  corpus.write("bad-title-control", replaced(text, "a \\\"", "a \\u0007"));
  corpus.write("bad-seed", replaced(text, "[1, 7]", "[1, -7]"));
  corpus.write("bad-repeats", replaced(text, "repeats = 2", "repeats = 99999999999"));
  corpus.write("bad-vary", replaced(text, "values = 3", "values = 3000000000"));
  corpus.write("bad-nested", "dataset = " + std::string(1000, '[') + "\n");
  std::string list = "1";
  for (int n = 2; n <= 100; ++n) list += fmt::format(",{}", n);
  corpus.write("good-many-runs", replaced(replaced(text, "[0.5, 0.75]", "[" + list + "]"), "[1, 7]", "[" + list + "]"));
  const Corpus set(root, "experiments", "set");
  set.write("good-number", "sweeps=7");
  set.write("good-negative-zero", "sweeps=-0");  // found by fuzzing: it was another config when read again
  set.write("bad-range", "sweeps=-1");
  set.write("bad-number", "sweeps=7e");
  set.write("bad-infinite", "sweeps=inf");
  set.write("bad-name", "swepes=7");
  set.write("bad-control", "sweeps\x1b[31m=7\n");
  set.write("bad-equals", "=");
}

int write_seeds(const fs::path& root) {
  write_nrrd(root);
  write_metaimage(root);
  write_inrimage(root);
  write_nifti(root);
  write_vti(root);
  write_raw(root);
  write_manifest(root);
  write_vtp(root);
  write_ply(root);
  write_text_meshes(root);
  write_stl(root);
  write_measure(root);
  write_records(root);
  write_plans(root);
  write_published(root);
  write_configs(root);
  return 0;
}

}  // namespace
}  // namespace isobench

int main(int argc, char** argv) {
  if (argc == 2) return isobench::write_seeds(argv[1]);
  fmt::print(stderr, "give the root of the project\n");
  return 2;
}
