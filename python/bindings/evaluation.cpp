// Representations measured against the scene, as the JSON of `ocelli evaluate`.
#include "oc_core/evaluation/evaluation.h"

#include <pybind11/stl.h>

#include "oc_core/evaluation/evaluation_json.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/options.h"
#include "python/bindings/progress.h"

namespace py = pybind11;

namespace ocelli {
namespace {

struct Asked {
  std::string scene;
  std::vector<CameraArgument> cameras;
  View view;
  int width;
  int height;
  float cellSideRadii;
  std::string cellShape;
  int interiorViews;
  int edgeViews;
  unsigned seed;
  bool compareImages;
  int runs;
};

std::string evaluated(const Mesh& mesh, const Asked& asked, const py::object& progress) {
  requireImageSize(asked.width, asked.height);
  EvaluationOptions options;
  options.view = asked.view;
  options.width = asked.width;
  options.height = asked.height;
  options.cell.sideRadii = asked.cellSideRadii;
  options.cell.shape = cellShapeFromName(asked.cellShape, "cell_shape");
  options.interiorViews = asked.interiorViews;
  options.edgeViews = asked.edgeViews;
  options.seed = asked.seed;
  options.compareImages = asked.compareImages;
  options.runs = asked.runs;
  const PythonProgress told(progress);
  const py::gil_scoped_release released;
  std::vector<CameraChoice> choices;
  for (const CameraArgument& camera : asked.cameras) {
    choices.push_back(cameraChoiceOf(camera, options.cell));
  }
  return evaluationJson(asked.scene, options, evaluate(mesh, choices, options, told.function()));
}

}  // namespace

void bindEvaluation(py::module_& module) {
  module.def(
      "evaluate",
      [](const Mesh& mesh, const std::string& scene, const std::vector<CameraArgument>& cameras, const View& view,
         int width, int height, float cellSideRadii, const std::string& cellShape, int interiorViews, int edgeViews,
         unsigned seed, bool compareImages, int runs, const py::object& progress) {
        return evaluated(mesh,
                         {scene, cameras, view, width, height, cellSideRadii, cellShape, interiorViews, edgeViews, seed,
                          compareImages, runs},
                         progress);
      },
      py::arg("mesh"), py::arg("scene"), py::arg("cameras"), py::arg("view"), py::arg("width"), py::arg("height"),
      py::arg("cell_side_radii"), py::arg("cell_shape"), py::arg("interior_views"), py::arg("edge_views"),
      py::arg("seed"), py::arg("compare_images"), py::arg("runs"), py::arg("progress"));
}

}  // namespace ocelli
