#include <vtkCellArray.h>
#include <vtkCutter.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCutter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMP.h>
#include <vtkSmartPointer.h>

#include "bench/slicer_peers.h"
#include "display_sim/frames/sweep_geometry.h"

namespace ocelli {
namespace {

vtkSmartPointer<vtkPolyData> polyData(const Mesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.positions.size()));
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    points->SetPoint(static_cast<vtkIdType>(i), static_cast<double>(p.x), static_cast<double>(p.y),
                     static_cast<double>(p.z));
  }
  vtkNew<vtkCellArray> cells;
  for (const glm::uvec3& t : mesh.triangles) {
    const vtkIdType corners[3] = {t.x, t.y, t.z};
    cells->InsertNextCell(3, corners);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/// Cuts with the plane of one slice after the other.
template <class Cutter, class SetPlane>
std::function<void()> cutting(const Mesh& mesh, const DisplayProfile& profile, SetPlane&& setPlane) {
  const auto cutter = vtkSmartPointer<Cutter>::New();
  const auto plane = vtkSmartPointer<vtkPlane>::New();
  cutter->SetInputData(polyData(mesh));
  setPlane(*cutter, plane);
  return [cutter, plane, sweep = SweepGeometry(profile)] {
    for (int i = 0; i < sweep.slicesPerHalfTurn(); ++i) {
      const glm::dvec2& d = sweep.sectorDirection(i);
      plane->SetNormal(-d.y, 0, d.x);
      cutter->Update();
    }
  };
}

}  // namespace

std::string vtkThreads() {
  return VTK_SMP_BACKEND;
}

std::vector<SlicerPeer> vtkPeers() {
  return {{"vtkPlaneCutter", "segments, its tree made once", 1'500'000,
           [](const Mesh& mesh, const DisplayProfile& profile) {
             return cutting<vtkPlaneCutter>(mesh, profile, [](vtkPlaneCutter& cutter, vtkPlane* plane) {
               cutter.SetPlane(plane);
               cutter.BuildTreeOn();
               cutter.ComputeNormalsOff();
               cutter.InterpolateAttributesOff();
             });
           }},
          {"vtkCutter", "segments", 150'000, [](const Mesh& mesh, const DisplayProfile& profile) {
             return cutting<vtkCutter>(mesh, profile, [](vtkCutter& cutter, vtkPlane* plane) {
               cutter.SetCutFunction(plane);
               cutter.GenerateCutScalarsOff();
             });
           }}};
}

}  // namespace ocelli
