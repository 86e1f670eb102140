// VTP, VTU and legacy VTK files as other programs write them. Each is read right or refused in one sentence. What VTK's
// own XML writer makes is in mesh_vtp_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "isobench/methods/mesh_files/test_foreign_mesh.h"

namespace isobench::foreign {
namespace {

const Read vtk_octahedron{6, 8, octahedron_volume, ""};
const Read vtk_cube{8, 12, cube_volume, "6 of its 6 faces have more than three corners"};

std::string array(const std::string& type, const std::string& name, const std::string& numbers, int components = 1) {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">{}</DataArray>\n",
                     type, name, components, numbers);
}

/// The offsets of `cells` cells of `corners` corners each.
std::string offsets(int cells, int corners) {
  std::string text;
  for (int n = 1; n <= cells; ++n) text += fmt::format("{} ", n * corners);
  return text;
}

std::string points(const std::string& coordinates) {
  return "<Points>" + array("Float32", "Points", coordinates, 3) + "</Points>";
}

std::string cells(const std::string& kind, const std::string& connectivity, const std::string& ends) {
  return "<" + kind + ">" + array("Int64", "connectivity", connectivity) + array("Int32", "offsets", ends) + "</" +
         kind + ">";
}

std::string xml(const std::string& type, const std::string& counts, const std::string& body) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type + "\" version=\"1.0\" byte_order=\"LittleEndian\"><" +
         type + "><Piece " + counts + ">" + body + "</Piece></" + type + "></VTKFile>\n";
}

const std::string octahedron_strips = "0 2 4 1 3 5 0 2 3 0 4 1 2 5";
const std::string strip_ends = "8 11 14";

TEST(ForeignVtk, Vtp) {
  const std::string triangles = cells("Polys", face_lines(octahedron_faces, ""), offsets(8, 3));
  const std::string six = "NumberOfPoints=\"6\" ";
  expect_all({
      {"plain.vtp", xml("PolyData", six + "NumberOfPolys=\"8\"", points(octahedron_points) + triangles),
       vtk_octahedron},
      {"quads.VTP",
       xml("PolyData", "NumberOfPoints=\"8\" NumberOfPolys=\"6\"",
           points(cube_points) + cells("Polys", face_lines(cube_faces, ""), offsets(6, 4))),
       vtk_cube},
      {"strips.vtp",
       xml("PolyData", six + "NumberOfStrips=\"3\"",
           points(octahedron_points) + cells("Strips", octahedron_strips, strip_ends)),
       {6, 8, octahedron_volume, "its 3 strips of triangles were cut into 8 triangles"}},
      {"all.vtp",
       xml("PolyData", six + "NumberOfVerts=\"1\" NumberOfLines=\"1\" NumberOfPolys=\"8\"",
           points(octahedron_points) + cells("Verts", "0 1", "2") + cells("Lines", "0 1 2", "3") + triangles),
       {6, 8, octahedron_volume, "its 2 points and 1 line are no part of a surface; left out"}},
      {"points.vtp", xml("PolyData", six, points(octahedron_points)), {}, "has 6 points and no triangles"},
      {"2-d.vtp",
       xml("PolyData", "NumberOfPoints=\"2\" NumberOfPolys=\"1\"",
           "<Points>" + array("Float32", "Points", "0 0 1 1", 2) + "</Points>"),
       {},
       "its points have 2 coordinates; three are needed"},
      {"image.vtp", xml("ImageData", "", ""), {}, "it holds 'ImageData', but PolyData is expected"},
      {"none.vtp",
       xml("PolyData", six + "NumberOfPolys=\"8\"", points(octahedron_points)),
       {},
       "it counts 8 of Polys, but has none"},
      {"legacy.vtp", "# vtk DataFile Version 3.0\n", {}, "its first bytes are those of a legacy VTK file"},
  });
}

TEST(ForeignVtk, CellDataOfVtpKeepTheirCells) {
  const TestFolder folder;
  const std::string data = "<CellData>" + array("Float32", "part", "1 2 3 4") + "</CellData>";
  const TriangleMesh mesh = read_mesh(folder.write(
      "a.vtp",
      xml("PolyData",
          "NumberOfPoints=\"8\" NumberOfVerts=\"1\" NumberOfLines=\"1\" NumberOfPolys=\"1\" NumberOfStrips=\"1\"",
          data + cells("Strips", "0 1 2 3", "4") + points(cube_points) + cells("Polys", "4 5 6 7", "4") +
              cells("Lines", "0 1", "2") + cells("Verts", "0", "1"))));
  EXPECT_EQ(mesh.triangle_data.at("part"), (std::vector<double>{3, 3, 4, 4}));
}

TEST(ForeignVtk, Vtu) {
  const auto grid = [](const std::string& coordinates, int number, const std::string& cells_text,
                       const std::string& ends, const std::string& types) {
    const auto count = std::count(types.begin(), types.end(), ' ');
    return xml("UnstructuredGrid", fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", number, count),
               points(coordinates) + "<Cells>" + array("Int64", "connectivity", cells_text) +
                   array("Int64", "offsets", ends) + array("UInt8", "types", types) + "</Cells>");
  };
  const std::string corners = face_lines(octahedron_faces, "");
  const std::string of_triangles = "5 5 5 5 5 5 5 5 ";
  expect_all({
      {"plain.vtu", grid(octahedron_points, 6, corners, offsets(8, 3), of_triangles), vtk_octahedron},
      {"named.vtp", grid(octahedron_points, 6, corners, offsets(8, 3), of_triangles), vtk_octahedron},
      {"mixed.vtu",
       grid(cube_points, 8, replaced(face_lines(cube_faces, ""), " 0 3 2 1", " 0 3 1 2") + "0 1 5",
            offsets(6, 4) + "25 27", "8 9 7 9 7 9 1 3 "),
       {8, 12, cube_volume, "its 1 point and 1 line are no part"}},
      {"strips.vtu",
       grid(octahedron_points, 6, octahedron_strips, strip_ends, "6 6 6 "),
       {6, 8, octahedron_volume, "its 3 strips"}},
      {"tetrahedra.vtu",
       grid(octahedron_points, 6, "0 2 4 1", "4", "10 "),
       {},
       "holds tetrahedra or other cells with a volume"},
      {"curved.vtu", grid(octahedron_points, 6, "0 1 2 3 4 5", "6", "22 "), {}, "holds cells of VTK's type 22"},
      {"four.vtu", grid(octahedron_points, 6, "0 1 2 3", "4", "5 "), {}, "a triangle has 4 corners"},
      {"ends.vtu", grid(octahedron_points, 6, "0 1 2 0 1 2", "9 6", "5 5 "), {}, "cell 0 ends at corner 9 of 6"},
  });
}

std::string legacy(const std::string& version, const std::string& mode, const std::string& body) {
  return "# vtk DataFile Version " + version + "\ntitle\n" + mode + "\n" + body;
}

TEST(ForeignVtk, LegacyText) {
  const std::string head = "DATASET POLYDATA\nPOINTS 6 float\n" + octahedron_points;
  const std::string lists = "POLYGONS 8 32\n" + face_lines(octahedron_faces, "3");
  const std::string plain = legacy("3.0", "ASCII", head + lists);
  const std::string arrays = "POLYGONS 9 24\nOFFSETS vtktypeint64\n0 " + offsets(8, 3) +
                             "\nCONNECTIVITY vtktypeint64\n" + face_lines(octahedron_faces, "");
  const std::string metadata = "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 3\n\n";
  const std::string field = "FIELD FieldData 2\nTIME 1 1 double\n0.5\n" + metadata + "STEP 3 1 int\n1 2 3\n";
  const std::string grid = "DATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n" + octahedron_points;
  const std::string data = "POINT_DATA 6\nSCALARS a float 1\nLOOKUP_TABLE default\n1 2 3 4 5 6\n";
  expect_all({
      {"plain.vtk", plain, vtk_octahedron},
      {"crlf.vtk", replaced(plain, "\n", "\r\n"), vtk_octahedron},
      {"data.vtk", plain + data, vtk_octahedron},
      {"small.VTK", legacy("2.0", "ascii", replaced(head, "DATASET POLYDATA", "dataset polydata") + lists),
       vtk_octahedron},
      {"arrays.vtk", legacy("5.1", "ASCII", head + metadata + arrays), vtk_octahedron},
      {"field.vtk", legacy("4.2", "ASCII", replaced(head, "POLYDATA\n", "POLYDATA\n" + field) + lists), vtk_octahedron},
      {"quads.vtk",
       legacy("3.0", "ASCII",
              "DATASET POLYDATA\nPOINTS 8 int\n" + cube_points + "POLYGONS 6 30\n" + face_lines(cube_faces, "4")),
       vtk_cube},
      {"strips.vtk",
       legacy("3.0", "ASCII",
              head + "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nTRIANGLE_STRIPS 3 17\n"
                     "8 0 2 4 1 3 5 0 2\n3 3 0 4\n3 1 2 5\n"),
       {6, 8, octahedron_volume,
        "its 3 strips of triangles were cut into 8 triangles | strips.vtk: its 1 point and 1 line"}},
      {"grid.vtk",
       legacy("3.0", "ASCII",
              grid + "CELLS 8 32\n" + face_lines(octahedron_faces, "3") + "CELL_TYPES 8\n5 5 5 5 5 5 7 7\n"),
       vtk_octahedron},
      {"grid-arrays.vtk",
       legacy("5.1", "ASCII", grid + replaced(arrays, "POLYGONS", "CELLS") + "CELL_TYPES 8\n5\n5\n5\n5\n5\n5\n5\n5\n"),
       vtk_octahedron},
      {"tetrahedra.vtk",
       legacy("3.0", "ASCII", grid + "CELLS 1 5\n4 0 2 4 1\nCELL_TYPES 1\n10\n"),
       {},
       "holds tetrahedra or other cells with a volume"},
      {"types.vtk", legacy("3.0", "ASCII", grid + "CELLS 1 4\n3 0 2 4\n"), {}, "its cells have no types"},
      {"image.vtk", legacy("3.0", "ASCII", "DATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n"), {}, "holds a volume"},
      {"points.vtk", legacy("3.0", "ASCII", head), {}, "has 6 points and no triangles"},
      {"cut.vtk", plain.substr(0, plain.size() - 3), {}, "is truncated"},
      {"count.vtk", replaced(plain, "POLYGONS 8", "POLYGONS 9"), {}, "it announces 9 cells and has 8"},
      {"length.vtk", replaced(plain, "\n3 0 2 4\n", "\n300 0 2 4\n"), {}, "a cell has more corners than there are"},
      {"index.vtk", replaced(plain, "3 0 3 5", "3 0 3 6"), {}, "face 7 names a vertex that is not there"},
      {"word.vtk", replaced(plain, "3 0 3 5", "3 0 x 5"), {}, "'x' is not a number"},
      {"keyword.vtk",
       replaced(plain, "POLYGONS", "POLYGON"),
       {},
       "'polygon' is found where a part of a mesh is expected"},
      {"type.vtk", replaced(plain, "float", "string"), {}, "its numbers of type 'string' cannot be read"},
      {"huge.vtk", replaced(plain, "POINTS 6", "POINTS 9000000000000000000"), {}, "is truncated"},
      {"xml.vtk",
       "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\">",
       {},
       "its first bytes are those of a VTK XML file"},
  });
}

/// The corners of the vtk_octahedron's faces, each face behind `before`.
template <typename Number>
std::string corners_of(std::initializer_list<Number> before) {
  std::string bytes;
  for (const auto& face : octahedron_faces) {
    bytes += binary<Number>(before, std::endian::big);
    for (const int v : face) bytes += binary<Number>({static_cast<Number>(v)}, std::endian::big);
  }
  return bytes;
}

TEST(ForeignVtk, LegacyBinary) {
  std::string head = "DATASET POLYDATA\nPOINTS 6 double\n";
  for (int v = 0; v < 6; ++v) {
    const double along = v % 2 == 0 ? 3.0 : -3.0;
    head += binary<double>({v / 2 == 0 ? along : 0.0, v / 2 == 1 ? along : 0.0, v / 2 == 2 ? along : 0.0},
                           std::endian::big);
  }
  std::string ends, types;
  for (std::int64_t n = 0; n <= 8; ++n) ends += binary<std::int64_t>({3 * n}, std::endian::big);
  for (int n = 0; n < 8; ++n) types += binary<std::int32_t>({5}, std::endian::big);
  const std::string lists = "POLYGONS 8 32\n" + corners_of<std::int32_t>({3});
  const std::string arrays =
      "POLYGONS 9 24\nOFFSETS vtktypeint64\n" + ends + "\nCONNECTIVITY vtktypeint64\n" + corners_of<std::int64_t>({});
  const std::string field = "FIELD FieldData 1\nTIME 1 1 double\n" + binary<double>({0.5}, std::endian::big) + "\n";
  const std::string metadata = "\nMETADATA\nINFORMATION 0\n\n";
  const std::string plain = legacy("3.0", "BINARY", head + "\n" + lists + "\n");
  expect_all({
      {"plain.vtk", plain, vtk_octahedron},
      {"arrays.vtk", legacy("5.1", "BINARY", head + metadata + arrays + metadata), vtk_octahedron},
      {"field.vtk", legacy("4.2", "BINARY", replaced(head, "POLYDATA\n", "POLYDATA\n" + field) + "\n" + lists),
       vtk_octahedron},
      {"grid.vtk",
       legacy("3.0", "BINARY",
              replaced(head, "POLYDATA", "UNSTRUCTURED_GRID") + "\n" + replaced(lists, "POLYGONS", "CELLS") +
                  "\nCELL_TYPES 8\n" + types),
       vtk_octahedron},
      {"cut.vtk", plain.substr(0, plain.size() - 2), {}, "is truncated"},
  });
}

}  // namespace
}  // namespace isobench::foreign
