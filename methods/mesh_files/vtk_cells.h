// The cells of VTK's files, legacy and XML, as polygons.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <utility>
#include <vector>

#include "isobench/methods/mesh_files/polygon_mesh.h"

namespace isobench {

/// VTK's numbers of the types that a PolyData file has.
enum class VtkCellType { vertex = 2, line = 4, strip = 6, polygon = 7 };

/// Cells as VTK stores them: the corners of all, one cell after another.
struct VtkCells {
  std::vector<double> corners;
  std::vector<double> ends;  ///< of each cell: the place in `corners` behind its last corner
};

/// Adds the surface cells of a file to a mesh and counts the others.
class VtkCellAdder {
 public:
  VtkCellAdder(PolygonMesh& mesh, std::filesystem::path path) : mesh_(mesh), path_(std::move(path)) {}

  /// `first` is the number of the vertex that the cells call 0. Throws DataError if the cells do not fit their corners.
  void add(const VtkCells& cells, VtkCellType type, std::size_t first = 0);
  /// The same with a type for each cell, as an unstructured grid has. Throws DataError for cells that are not flat.
  void add(const VtkCells& cells, const std::vector<double>& types, std::size_t first = 0);
  /// How many polygons each cell since the last call has become; cells count in the order in which they were added.
  std::vector<std::size_t> take_polygons_of_cells() { return std::exchange(polygons_of_cells_, {}); }
  /// Notes what was left out. Call it last.
  void add_notes();

 private:
  template <typename TypeOf>
  void add_each(const VtkCells& cells, std::size_t first, TypeOf type_of);
  void add_cell(int type);
  void need(std::size_t corners, const char* cell) const;

  PolygonMesh& mesh_;
  std::filesystem::path path_;
  std::vector<std::uint32_t> cell_;  // corners of one cell
  std::vector<std::size_t> polygons_of_cells_;
  std::size_t points_ = 0, lines_ = 0, strips_ = 0, of_strips_ = 0;
};

}  // namespace isobench
