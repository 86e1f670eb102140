// OFF, OBJ, PLY and STL files as other programs write them. Each is read right or refused in one sentence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "isobench/methods/mesh_files/test_foreign_mesh.h"

namespace isobench::foreign {
namespace {

const Read octahedron{6, 8, octahedron_volume, ""};
const Read cube{8, 12, cube_volume, "6 of its 6 faces have more than three corners (up to 4); they were cut into 12"};

Read with_note(Read read, const std::string& note) {
  read.notes = note;
  return read;
}

TEST(ForeignMeshes, Off) {
  const std::string counts = "6 8 0\n", faces = face_lines(octahedron_faces, "3");
  const std::string plain = "OFF\n" + counts + octahedron_points + faces;
  const std::string quads = "OFF\n8 6 12\n" + cube_points + face_lines(cube_faces, "4");
  expect_all({
      {"plain.off", plain, octahedron},
      {"comments.off",
       "# made by hand\nOFF # yes\n\n6 8 0 # counts\n# vertices\n" + octahedron_points + "\n# faces\n" +
           face_lines(octahedron_faces, "3", 0, "", " 255 0 0"),
       octahedron},
      {"coff.off", "COFF\n" + counts + each_line(octahedron_points, "", " 255 0 0 255") + faces, octahedron},
      {"noff.off", "NOFF\n" + counts + each_line(octahedron_points, "", " 0 0 1") + faces, octahedron},
      {"stoff.off", "STOFF\n" + counts + each_line(octahedron_points, "", " .5 .5") + faces, octahedron},
      {"all.off", "STCNOFF\n" + counts + each_line(octahedron_points, "", " 0 0 1 1 1 1 1 .5 .5") + faces, octahedron},
      {"no-keyword.off", counts + octahedron_points + faces, octahedron},
      {"small.off", replaced(plain, "OFF", "off"), octahedron},
      {"without-edges.off", replaced(plain, "6 8 0", "6 8"), octahedron},
      {"glued.off", replaced(plain, "OFF\n", "OFF"), octahedron},
      {"crlf.off", replaced(plain, "\n", "\r\n"), octahedron},
      {"cr.OFF", replaced(plain, "\n", "\r"), octahedron},
      {"bom.off", "\xef\xbb\xbf" + plain, octahedron},
      {"quads.off", quads, cube},
      {"edges.off", replaced(plain, "6 8 0", "6 10 0") + "2 0 1\n1 3\n",
       with_note(octahedron, "its 1 point and 1 line are no part of a surface; left out")},
      {"isolated.off",
       replaced(replaced(plain, "6 8 0", "7 8 0"), "0 0 -3\n", "0 0 -3\n900 900 900\n"),
       {7, 8, octahedron_volume, ""}},
      {"inside-out.off", replaced(plain, "3 0 0\n-3 0 0", "-3 0 0\n3 0 0"), {6, 8, -octahedron_volume, ""}},
      {"4.off", "4OFF\n" + counts + each_line(octahedron_points, "", " 1") + faces, {}, "three coordinates"},
      {"n.off", "nOFF\n4\n" + counts, {}, "three coordinates"},
      {"binary.off", std::string("OFF BINARY\n\0\0\0\x06", 15), {}, "save it as text, or as PLY"},
      {"2-d.off", "OFF\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n", {}, "a point has 2 coordinates; three are needed"},
      {"nan.off", replaced(plain, "-3 0 0", "nan nan nan"), {}, "vertex 1 are not finite"},
      {"index.off", replaced(plain, "3 0 3 5", "3 0 3 6"), {}, "names vertex 6, but the vertices are 0 to 5"},
      {"empty.off", "OFF\n0 0 0\n", {}, "has no points and no triangles"},
      {"points.off", "OFF\n6 0 0\n" + octahedron_points, {}, "has 6 points and no triangles; make a surface"},
      {"cut.off", plain.substr(0, plain.size() - 8), {}, "truncated"},
      {"count.off", "OFF\nsix 8 0\n", {}, "'six' is not a number of vertices or faces"},
      {"other.off", "ply\nformat ascii 1.0\n", {}, "its first bytes are those of a PLY file"},
  });
}

TEST(ForeignMeshes, Obj) {
  const std::string v = each_line(octahedron_points, "v ", "");
  std::string soup;  // every triangle with vertices of its own
  for (const auto& face : octahedron_faces) {
    for (const int corner : face) soup += "v " + line_of(octahedron_points, corner) + '\n';
    soup += "f -3 -2 -1\n";
  }
  expect_all({
      {"vtvn.obj",
       "mtllib a.mtl\no s\n" + each_line(octahedron_points, "v ", " 1 0 0") +
           "vt 0 0\nvn 0 0 1\ns 1\nusemtl m\ng a b\n" + face_lines(octahedron_faces, "f", 1, "/1/1"),
       octahedron},
      {"vn.obj", v + "vn 0 0 1\n" + face_lines(octahedron_faces, "f", 1, "//1"), octahedron},
      {"vt.OBJ", v + "vt 0 0\n" + face_lines(octahedron_faces, "f", 1, "/1"), octahedron},
      {"negative.obj", v + face_lines(octahedron_faces, "f", -6, "//-1"), octahedron},
      {"soup.obj", soup, {24, 8, octahedron_volume, ""}},
      {"continued.obj", v + face_lines(octahedron_faces, "f \\\n", 1, " \\\n"), octahedron},
      {"weights.obj", each_line(octahedron_points, "v ", " 1.0") + face_lines(octahedron_faces, "f", 1), octahedron},
      {"faces-first.obj", face_lines(octahedron_faces, "f", 1) + v, octahedron},
      {"old-faces.obj", v + face_lines(octahedron_faces, "fo", 1), octahedron},
      {"odd-keywords.obj", "shadow_obj x.obj\n" + v + face_lines(octahedron_faces, "f", 1) + "end\n", octahedron},
      {"free-text.obj", "Exported by Some Program\n" + v + face_lines(octahedron_faces, "f", 1) + "bye\n",
       with_note(octahedron, "2 of its lines begin with a word that OBJ does not have ('Exported'); left out")},
      {"lines.obj", v + face_lines(octahedron_faces, "f", 1) + "l 1 2 3\np 1\n",
       with_note(octahedron, "1 point and 1 line")},
      {"free-form.obj", v + face_lines(octahedron_faces, "f", 1) + "cstype bezier\ncurv 0 1 1 2 3\nend\n",
       with_note(octahedron, "1 of its statements are of free-form curves and surfaces; left out")},
      {"crlf.obj", replaced(v + face_lines(octahedron_faces, "f", 1), "\n", "\r\n"), octahedron},
      {"quads.obj", each_line(cube_points, "v ", "") + face_lines(cube_faces, "f", 1), cube},
      {"two.obj", v + "f 1 2\n", {}, "a face needs three corners"},
      {"zero.obj", v + face_lines(octahedron_faces, "f", 0), {}, "names a vertex that is not there ('0'"},
      {"far-back.obj", v + "f -1 -2 -7\n", {}, "names a vertex that is not there ('-7', with 6 vertices so far)"},
      {"never.obj", v + "f 1 2 7\n", {}, "face 0 names a vertex that is not there (the file has 6"},
      {"word.obj", v + "f a b c\n", {}, "'a' is not a corner of a face"},
      {"flat.obj", "v 0 0\nv 1 0\nv 1 1\nf 1 2 3\n", {}, "a point has 2 coordinates; three are needed"},
      {"text.obj", "hello\n", {}, "it has no line that begins with v or f"},
      {"materials.obj", "mtllib a.mtl\n", {}, "it has no line that begins with v or f"},
  });
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

std::string ply(const std::string& format, const std::string& elements, const std::string& body) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body;
}

std::string binary_ply(std::endian order) {
  const std::string elements =
      "comment VCGLIB end_header\nobj_info x\nelement before 1\nproperty double time\n"
      "element vertex 6\nproperty float x\nproperty uchar red\nproperty float y\n"
      "property float z\nproperty list uchar short rings\nelement face 8\nproperty uchar material\n"
      "property list ushort uint vertex_indices\nproperty list uchar float texcoord\n"
      "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
  std::string body = binary<double>({1.5}, order);
  for (int v = 0; v < 6; ++v) {
    const float along = v % 2 == 0 ? 3.0F : -3.0F;
    body += binary<float>({v / 2 == 0 ? along : 0.0F}, order) + '\x0a' +
            binary<float>({v / 2 == 1 ? along : 0.0F, v / 2 == 2 ? along : 0.0F}, order) + '\x01' +
            binary<std::int16_t>({7}, order);
  }
  for (const auto& face : octahedron_faces) {
    body += '\x05' + binary<std::uint16_t>({3}, order);
    for (const int corner : face) body += binary<std::uint32_t>({static_cast<std::uint32_t>(corner)}, order);
    body += '\x01' + binary<float>({0.5F}, order);
  }
  body += binary<std::int32_t>({0, 1}, order);
  return ply(order == std::endian::big ? "binary_big_endian" : "binary_little_endian", elements, body);
}

TEST(ForeignMeshes, Ply) {
  const std::string vertices = "element vertex 6\n" + xyz;
  const std::string faces = "element face 8\nproperty list uchar int vertex_index\n";
  const std::string face_text = face_lines(octahedron_faces, "3");
  const std::string plain = ply("ascii", vertices + faces, octahedron_points + face_text);
  const std::string strips = vertices + "element tristrips 1\nproperty list int int vertex_indices\n";
  expect_all({
      {"plain.ply", plain, octahedron},
      {"crlf.ply", replaced(plain, "\n", "\r\n"), octahedron},
      {"cr.ply", replaced(plain, "\n", "\r"), octahedron},
      {"big.PLY", binary_ply(std::endian::big), octahedron},
      {"little.ply", binary_ply(std::endian::little), octahedron},
      {"face-first.ply", ply("ascii", faces + vertices, face_text + octahedron_points), octahedron},
      {"types.ply", replaced(replaced(plain, "float", "float64"), "uchar int", "uint8 int32"), octahedron},
      {"quads.ply",
       ply("ascii", "element vertex 8\n" + xyz + "element face 6\nproperty list uchar int vertex_indices\n",
           cube_points + face_lines(cube_faces, "4")),
       cube},
      {"tristrips.ply",
       ply("ascii", strips, octahedron_points + "16 0 2 4 1 3 5 0 2 -1 3 0 4 -1 1 2 5\n"),
       {6, 8, octahedron_volume, "its strips of triangles were cut into 8 triangles"}},
      {"edges.ply", replaced(plain, "face 8", "face 9") + "2 0 1\n", with_note(octahedron, "its 1 line is no part")},
      {"points.ply", ply("ascii", vertices, octahedron_points), {}, "has 6 points and no triangles; make a surface"},
      {"2-d.ply", ply("ascii", "element vertex 1\nproperty float x\nproperty float y\n", "0 0\n"), {}, "x, y and z"},
      {"no-list.ply",
       ply("ascii", vertices + "element face 1\nproperty int a\n", octahedron_points + "1\n"),
       {},
       "its element 'face' does not have one list vertex_indices"},
      {"twice.ply", ply("ascii", vertices + vertices, octahedron_points + octahedron_points), {}, "has vertices twice"},
      {"length.ply", replaced(plain, "\n3 0 2 4\n", "\n-3 0 2 4\n"), {}, "a list of 'vertex_index' has -3 values"},
      {"index.ply", replaced(plain, "3 0 3 5", "3 0 3 6"), {}, "face 7 names a vertex that is not there"},
      {"cut.ply", plain.substr(0, plain.size() - 3), {}, "is truncated"},
      {"header.ply", "ply\nformat ascii 1.0\nelement vertex 6\n", {}, "it ends within its header"},
      {"format.ply", replaced(plain, "ascii", "text"), {}, "'text' is not a PLY format"},
      {"stl.ply", "solid a\nfacet normal 0 0 1\n", {}, "its first bytes are those of an STL file"},
  });
}

std::string binary_stl(const std::string& header, std::uint32_t count) {
  std::string bytes = header;
  bytes.resize(80);
  bytes += binary<std::uint32_t>({count}, std::endian::little);
  for (const auto& face : octahedron_faces) {
    bytes += std::string(12, '\0');
    for (const int v : face) {
      const float along = v % 2 == 0 ? 3.0F : -3.0F;
      bytes += binary<float>({v / 2 == 0 ? along : 0.0F, v / 2 == 1 ? along : 0.0F, v / 2 == 2 ? along : 0.0F},
                             std::endian::little);
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

/// Facets number `from` to `to` of the octahedron.
std::string facets(std::size_t from, std::size_t to) {
  std::string text;
  for (std::size_t n = from; n < to; ++n) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const int v : octahedron_faces[n]) {
      const double along = v % 2 == 0 ? 3.0 : -3.0;
      text += fmt::format("      vertex {:.6e} {:.6e} {:.6e}\n", v / 2 == 0 ? along : 0.0, v / 2 == 1 ? along : 0.0,
                          v / 2 == 2 ? along : 0.0);
    }
    text += "    endloop\n  endfacet\n";
  }
  return text;
}

TEST(ForeignMeshes, Stl) {
  const std::string ascii = "solid a b c\n" + facets(0, 8) + "endsolid a b c\n";
  const std::string whole = binary_stl("x", 8);
  const std::string upper = replaced("SOLID a\n" + facets(0, 8) + "ENDSOLID a\n", "vertex", "VERTEX");
  const std::string square =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
      "endloop\nendfacet\n";
  expect_all({
      {"solid-header.stl", binary_stl("solid exported by SomeCAD", 8), octahedron},
      {"UPPER.STL", whole, octahedron},
      {"trailing.stl", whole + "\n", with_note(octahedron, "1 byte after its last triangle was left out")},
      {"more.stl", whole + std::string(333, ' '),
       with_note(octahedron, "333 bytes after its last triangle were left out")},
      {"zero-count.stl", binary_stl("x", 0),
       with_note(octahedron, "its header counts 0 triangles, but its size is that of 8; these were read")},
      {"no-count.stl", binary_stl("x", 0xFFFFFFFF),
       with_note(octahedron, "but its size is that of 8; these were read")},
      {"less.stl", binary_stl("x", 5), {}, "its header counts 5 triangles, but its size is that of 8; export it again"},
      {"more-count.stl",
       binary_stl("x", 9),
       {},
       "it is truncated, as its header counts 9 triangles and there is room for 8"},
      {"huge-count.stl", binary_stl("x", 0xFFFFFFFE), {}, "its header counts 4294967294 triangles"},
      {"cut.stl", whole.substr(0, 300), {}, "its header counts 8 triangles and there is room for 4"},
      {"ascii.stl", ascii, octahedron},
      {"ascii-crlf.stl", replaced(ascii, "\n", "\r\n"), octahedron},
      {"ascii-bom.stl", "\xef\xbb\xbf" + ascii, octahedron},
      {"two-solids.stl", "solid a\n" + facets(0, 3) + "endsolid a\nsolid b\n" + facets(3, 8) + "endsolid b\n",
       octahedron},
      {"upper-words.stl", upper, octahedron},
      {"mixed.stl", replaced(replaced(replaced(ascii, "facet", "Facet"), "loop", "Loop"), "endsolid", "EndSolid"),
       octahedron},
      {"unnamed.stl", "solid\n" + facets(0, 8) + "endsolid\n", octahedron},
      {"minus-zero.stl", replaced(ascii, " 0.000000e+00 0", " -0.000000e+00 0"), octahedron},
      {"no-end.stl", "solid a\n" + facets(0, 8), {}, "it ends without endsolid"},
      {"square.stl", "solid\n" + square + "endsolid\n", {4, 2, 0.0, "1 of its 1 faces have more than three corners"}},
      {"two-corners.stl",
       "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n",
       {},
       "the facet has fewer than three corners"},
      {"outside.stl", "solid\nvertex 0 0 0\nendsolid\n", {}, "a vertex is outside of a facet's loop"},
      {"word.stl", "solid\nfacets normal 0 0 1\nendsolid\n", {}, "'facets' is unknown in an ASCII STL file"},
      {"nothing.stl", "solid a\nendsolid a\n", {}, "has no points and no triangles"},
      {"text.stl", "hello\n", {}, "it is not binary and does not start with the word solid"},
      {"ply.stl", "ply\nformat ascii 1.0\n" + std::string(200, ' '), {}, "its first bytes are those of a PLY file"},
      {"long-text.stl", "hello, " + std::string(200, 'x'), {}, "does not start with the word solid"},
      {"page.stl", "<!DOCTYPE html>\n<html></html>\n", {}, "a web page, not a mesh; download it again"},
  });
}

TEST(ForeignMeshes, AsciiStlMayHoldMoreThanSinglePrecision) {
  const TestFolder folder;
  const std::string text =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 10000000.25 0 0\nvertex 10000000.5 0 0\n"
      "vertex 10000000.25 0.25 0\nendloop\nendfacet\nendsolid\n";
  const TriangleMesh mesh = read_mesh(folder.write("a.stl", text));
  EXPECT_EQ(mesh.vertices.at(1) - mesh.vertices.at(0), Eigen::Vector3d(0.25, 0, 0));
}

TEST(ForeignMeshes, OtherEndings) {
  const std::string known = "mesh files that can be read end in .vtp, .ply, .off, .obj, .stl, .vtk or .vtu";
  expect_all({{"a.msh", "$MeshFormat\n2.2 0 8\n", {}, known},
              {"a.3mf", "PK\x03\x04", {}, known},
              {"a", "OFF\n", {}, known},
              {"a.stl.gz", "\x1f\x8b", {}, "compressed mesh files cannot be read; unpack it first"}});
}

}  // namespace
}  // namespace isobench::foreign
