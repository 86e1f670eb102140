#include "isobench/methods/mesh_files/vtk_cells.h"

#include <fmt/format.h>

#include <utility>

#include "isobench/methods/mesh_files/mesh_formats.h"
#include "isobench/methods/mesh_files/mesh_text.h"

namespace isobench {

template <typename TypeOf>
void VtkCellAdder::add_each(const VtkCells& cells, std::size_t first, TypeOf type_of) {
  double begin = 0.0;
  for (std::size_t n = 0; n < cells.ends.size(); ++n) {
    const double end = cells.ends[n];
    if (!(end >= begin) || end > static_cast<double>(cells.corners.size())) {
      bad_mesh(path_, fmt::format("damaged: cell {} ends at corner {} of {}; copy or export it again", n, end,
                                  cells.corners.size()));
    }
    cell_.clear();
    for (auto c = static_cast<std::size_t>(begin); c < static_cast<std::size_t>(end); ++c) {
      const double corner = cells.corners[c];
      cell_.push_back(to_index(corner < 0.0 ? corner : corner + static_cast<double>(first)));
    }
    begin = end;
    const std::size_t before = mesh_.size();
    add_cell(type_of(n));
    polygons_of_cells_.push_back(mesh_.size() - before);
  }
}

void VtkCellAdder::add(const VtkCells& cells, VtkCellType type, std::size_t first) {
  add_each(cells, first, [type](std::size_t) { return static_cast<int>(type); });
}

void VtkCellAdder::add(const VtkCells& cells, const std::vector<double>& types, std::size_t first) {
  add_each(cells, first,
           [&types](std::size_t n) { return types[n] >= 0.0 && types[n] < 256.0 ? static_cast<int>(types[n]) : -1; });
}

void VtkCellAdder::need(std::size_t corners, const char* cell) const {
  if (cell_.size() == corners) return;
  bad_mesh(path_, fmt::format("damaged: a {} has {} corners; copy or export it again", cell, cell_.size()));
}

void VtkCellAdder::add_cell(int type) {
  switch (type) {
    case 0:  // an empty cell
      return;
    case 1:
    case 2:
      points_ += cell_.size();
      return;
    case 3:
    case 4:
      ++lines_;
      return;
    case 5:
      need(3, "triangle");
      break;
    case 6:
      ++strips_;
      of_strips_ += mesh_.add_strip(cell_);
      return;
    case 7:
      if (cell_.size() < 3) {
        ++(cell_.size() == 1 ? points_ : lines_);
        return;
      }
      break;
    case 8:  // a pixel, whose corners go by rows
      need(4, "pixel");
      std::swap(cell_[2], cell_[3]);
      break;
    case 9:
      need(4, "quadrilateral");
      break;
    case 10:
    case 11:
    case 12:
    case 13:
    case 14:
    case 15:
    case 16:
    case 42:
      bad_mesh(path_,
               "holds tetrahedra or other cells with a volume, so it is no surface; extract its surface first (in "
               "ParaView: Extract Surface)");
    default:
      bad_mesh(path_, fmt::format("holds cells of VTK's type {}; only triangles, quadrilaterals, polygons and strips "
                                  "can be read; convert it first (in ParaView: Extract Surface, Triangulate)",
                                  type));
  }
  mesh_.add_polygon(cell_);
}

void VtkCellAdder::add_notes() {
  if (strips_ > 0) {
    mesh_.notes.push_back(fmt::format("its {} strip{} of triangles {} cut into {} triangles", strips_,
                                      strips_ == 1 ? "" : "s", strips_ == 1 ? "was" : "were", of_strips_));
  }
  mesh_.note_left_out(points_, lines_);
}

}  // namespace isobench
