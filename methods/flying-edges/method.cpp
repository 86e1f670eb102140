// VTK's flying edges: marching cubes on the samples, with linear interpolation along lattice edges, as most programs
// do.
#include "isobench/methods/method.h"

#include <tbb/parallel_for.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <string>
#include <vector>

namespace isobench {
namespace {

/// The values ±(sample − c) on a lattice of unit spacing. VTK's points are floats: on a unit lattice they are accurate
/// to about 3e-5 voxel, and the spacing in mm is applied afterwards in double.
vtkNew<vtkImageData> image_of(const Isosurface& surface) {
  const auto& size = surface.lattice().size;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size[0], size[1], size[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  tbb::parallel_for(tbb::blocked_range<int>(0, size[2]), [&](const auto& slabs) {
    std::vector<float> slab;
    for (int k = slabs.begin(); k < slabs.end(); ++k) {
      surface.sample_values(k, slab);
      std::copy(slab.begin(), slab.end(), values + surface.lattice().index(0, 0, k));
    }
  });
  return image;
}

TriangleMesh mesh_of(vtkPolyData& polygons, const Eigen::Vector3d& spacing) {
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<std::size_t>(polygons.GetNumberOfPoints()));
  for (std::size_t n = 0; n < mesh.vertices.size(); ++n) {
    polygons.GetPoint(static_cast<vtkIdType>(n), mesh.vertices[n].data());
    mesh.vertices[n] = mesh.vertices[n].cwiseProduct(spacing);
  }
  vtkCellArray& cells = *polygons.GetPolys();
  mesh.triangles.resize(static_cast<std::size_t>(cells.GetNumberOfCells()));
  vtkNew<vtkIdList> corners;
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    cells.GetCellAtId(static_cast<vtkIdType>(n), corners);
    for (std::size_t c = 0; c < 3; ++c) {
      mesh.triangles[n][c] = static_cast<std::uint32_t>(corners->GetId(static_cast<vtkIdType>(c)));
    }
  }
  return mesh;
}

TriangleMesh mesh(const MeshingTask& task, Monitor& monitor) {
  const std::string note =
      "flying-edges: meshes the trilinear interpolant of the samples, not the spline's F = c, with triangles of the "
      "lattice's size";
  monitor.note(is_empty(task.sizing) ? note : note + "; the requested sizing has no effect");
  vtkNew<vtkFlyingEdges3D> flying_edges;
  flying_edges->SetInputData(image_of(task.surface));
  flying_edges->SetValue(0, 0.0);
  flying_edges->ComputeNormalsOff();
  flying_edges->ComputeGradientsOff();
  flying_edges->ComputeScalarsOff();
  flying_edges->InterpolateAttributesOff();
  monitor.check();
  flying_edges->Update();
  monitor.check();
  TriangleMesh result = mesh_of(*flying_edges->GetOutput(), task.surface.lattice().spacing);
  if (result.triangles.empty()) throw Skipped("flying-edges: no lattice edge crosses the isovalue");
  return result;
}

}  // namespace

Method method_flying_edges() {
  Method method;
  method.name = "flying-edges";
  method.summary =
      "VTK's flying edges (Schroeder, Maynard, Geveci 2015): marching cubes on the trilinear interpolant of the "
      "samples; triangles have the lattice's size, any sizing is ignored";
  method.ignores_sizing = true;
  method.mesh = mesh;
  return method;
}

}  // namespace isobench
