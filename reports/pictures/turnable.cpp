#include "isobench/reports/pictures/turnable.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricClustering.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "isobench/methods/sizing/medial_axis/point_tree.h"

namespace isobench {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

Eigen::AlignedBox3d box_of(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& vertex : mesh.vertices) box.extend(vertex);
  return box;
}

std::vector<Eigen::Vector3d> centres_of(const TriangleMesh& mesh) {
  std::vector<Eigen::Vector3d> centres;
  centres.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    centres.emplace_back((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0);
  return centres;
}

vtkSmartPointer<vtkPolyData> to_vtk(const TriangleMesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& vertex : mesh.vertices) points->InsertNextPoint(vertex.data());
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : mesh.triangles) cells->InsertNextCell({t[0], t[1], t[2]});
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

TriangleMesh from_vtk(vtkPolyData* data) {
  TriangleMesh mesh;
  for (vtkIdType v = 0; v < data->GetNumberOfPoints(); ++v) mesh.vertices.emplace_back(data->GetPoint(v));
  vtkNew<vtkIdList> corners;
  data->GetPolys()->InitTraversal();
  while (data->GetPolys()->GetNextCell(corners) != 0) {
    const auto corner = [&corners](vtkIdType n) { return static_cast<std::uint32_t>(corners->GetId(n)); };
    if (corners->GetNumberOfIds() == 3) mesh.triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return mesh;
}

// Clusters the vertices in cubic cells; `cells` is their number along the longest side of the box.
TriangleMesh clustered(vtkPolyData* data, const Eigen::AlignedBox3d& box, double cells) {
  const double side = box.sizes().maxCoeff() / cells;
  const auto divisions = [side](double length) { return std::max(1, static_cast<int>(std::ceil(length / side))); };
  vtkNew<vtkQuadricClustering> clustering;
  clustering->SetInputData(data);
  clustering->AutoAdjustNumberOfDivisionsOff();
  clustering->SetNumberOfDivisions(divisions(box.sizes().x()), divisions(box.sizes().y()), divisions(box.sizes().z()));
  clustering->Update();
  return from_vtk(clustering->GetOutput());
}

std::vector<double> least_values(const TriangleMesh& copy, const ValuedMesh& mesh) {
  const std::vector<Eigen::Vector3d> centres = centres_of(copy);
  const PointTree tree(centres);
  std::vector<double> least(centres.size(), 2.0);
  std::size_t near = 0;
  const std::vector<Eigen::Vector3d> places = centres_of(mesh.mesh);
  for (std::size_t t = 0; t < places.size(); ++t) {
    near = tree.nearest(places[t], near).first;
    least[near] = std::min(least[near], mesh.values[t]);
  }
  // A triangle that replaces none gets the value of the nearest original triangle.
  const PointTree original(places);
  for (std::size_t t = 0; t < least.size(); ++t) {
    if (least[t] > 1.0) least[t] = mesh.values[original.nearest(centres[t]).first];
  }
  return least;
}

// Morton code of ten bits of each coordinate, so that triangles near in space are near in the file.
std::uint32_t place_on_curve(const Eigen::Vector3d& offset) {
  std::uint32_t code = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::uint32_t>(std::clamp(1023.0 * offset[axis], 0.0, 1023.0));
    for (unsigned bit = 0; bit < 10; ++bit) code |= ((cell >> bit) & 1U) << (3 * bit + axis);
  }
  return code;
}

std::vector<std::size_t> order_of(const TriangleMesh& mesh, const Eigen::Vector3d& low, double side) {
  const std::vector<Eigen::Vector3d> centres = centres_of(mesh);
  std::vector<std::uint32_t> codes;
  for (const Eigen::Vector3d& centre : centres) codes.push_back(place_on_curve((centre - low) / side));
  std::vector<std::size_t> order(centres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&codes](std::size_t a, std::size_t b) { return codes[a] < codes[b]; });
  return order;
}

class Bytes {
 public:
  void add(std::uint32_t value, int bytes) {
    for (int n = 0; n < bytes; ++n) text_ += static_cast<char>((value >> (8 * n)) & 0xFFU);
  }
  void add(double value) { add(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4); }
  void add_short(std::uint32_t value) {
    for (; value >= 128; value >>= 7U) text_ += static_cast<char>((value & 127U) | 128U);
    text_ += static_cast<char>(value);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

std::uint32_t steps(double share, double count) {
  return static_cast<std::uint32_t>(std::lround(count * std::clamp(share, 0.0, 1.0)));
}

}  // namespace

ValuedMesh simplified(ValuedMesh mesh, std::size_t most) {
  if (mesh.mesh.triangles.size() <= most) return mesh;
  const vtkSmartPointer<vtkPolyData> data = to_vtk(mesh.mesh);
  const Eigen::AlignedBox3d box = box_of(mesh.mesh);
  // The number of triangles is about proportional to the square of the number of cells along a side.
  double cells = std::sqrt(static_cast<double>(most));
  ValuedMesh copy;
  for (int tries = 0; tries < 12; ++tries) {
    copy.mesh = clustered(data, box, cells);
    const double share = static_cast<double>(copy.mesh.triangles.size()) / static_cast<double>(most);
    if (share <= 1.0 && share > 0.85) break;
    cells *= std::sqrt(0.93 / std::max(share, 0.05));
  }
  while (copy.mesh.triangles.size() > most) copy.mesh = clustered(data, box, cells *= 0.9);
  copy.values = least_values(copy.mesh, mesh);
  return copy;
}

ValuedMesh around(const ValuedMesh& mesh, std::size_t triangle, std::size_t most) {
  std::vector<std::vector<std::uint32_t>> at(mesh.mesh.vertices.size());
  for (std::uint32_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.mesh.triangles[t]) at[v].push_back(t);
  }
  std::vector<std::uint32_t> found = {static_cast<std::uint32_t>(triangle)};
  std::vector<bool> seen(mesh.mesh.triangles.size());
  seen[triangle] = true;
  for (std::size_t next = 0; next < found.size() && found.size() < most; ++next) {
    for (const std::uint32_t v : mesh.mesh.triangles[found[next]]) {
      for (const std::uint32_t t : at[v]) {
        if (!seen[t]) found.push_back(t);
        seen[t] = true;
      }
    }
  }
  found.resize(std::min(found.size(), most));
  ValuedMesh part;
  std::vector<std::uint32_t> number(mesh.mesh.vertices.size(), none);
  for (const std::uint32_t t : found) {
    Triangle corners = mesh.mesh.triangles[t];
    for (std::uint32_t& v : corners) {
      if (number[v] == none) {
        number[v] = static_cast<std::uint32_t>(part.mesh.vertices.size());
        part.mesh.vertices.push_back(mesh.mesh.vertices[v]);
      }
      v = number[v];
    }
    part.mesh.triangles.push_back(corners);
    part.values.push_back(mesh.values[t]);
  }
  return part;
}

std::string turnable(const ValuedMesh& mesh) {
  const Eigen::AlignedBox3d box = box_of(mesh.mesh);
  const Eigen::Vector3d& low = box.min();
  const double side = std::max(box.sizes().maxCoeff(), 1e-9);
  const std::vector<std::size_t> order = order_of(mesh.mesh, low, side);
  std::vector<std::uint32_t> number(mesh.mesh.vertices.size(), none);
  std::uint32_t used = 0;
  Bytes vertices;
  Bytes corners;
  Bytes values;
  for (const std::size_t t : order) {
    for (const std::uint32_t v : mesh.mesh.triangles[t]) {
      corners.add_short(number[v] == none ? 0 : used - number[v]);
      if (number[v] == none) {
        number[v] = used++;
        for (int axis = 0; axis < 3; ++axis)
          vertices.add(steps((mesh.mesh.vertices[v][axis] - low[axis]) / side, 65535.0), 2);
      }
    }
    values.add(steps(mesh.values[t], 255.0), 1);
  }
  Bytes head;
  head.add(used, 4);
  head.add(static_cast<std::uint32_t>(mesh.mesh.triangles.size()), 4);
  for (int axis = 0; axis < 3; ++axis) head.add(low[axis]);
  head.add(side);
  return head.take() + vertices.take() + corners.take() + values.take();
}

}  // namespace isobench
