// Representations measured against the scene, as the JSON of `ocelli evaluate`.
#include "oc_core/evaluation/evaluation.h"

#include <pybind11/stl.h>

#include "oc_core/evaluation/evaluation_json.h"
#include "oc_core/volume_ocri/volume_first_hits.h"
#include "python/bindings/bindings.h"
#include "python/bindings/images.h"
#include "python/bindings/options.h"
#include "python/bindings/progress.h"
#include "python/bindings/volumes.h"

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

/// `measure(choices, options, progress)` gives the figures.
template <class Measure>
std::string evaluated(const Asked& asked, const py::object& progress, const Measure& measure) {
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
  return evaluationJson(asked.scene, options, measure(choices, options, told.function()));
}

std::string evaluatedMesh(const Mesh& mesh, const Asked& asked, const py::object& progress) {
  return evaluated(asked, progress, [&](const auto& choices, const EvaluationOptions& options, const Progress& told) {
    return evaluate(mesh, choices, options, told);
  });
}

/// What rays hit first, at this opacity, stands for the scene.
std::string evaluatedVolume(const PythonVolume& volume, const Asked& asked, std::optional<double> opacity,
                            const py::object& progress) {
  const double depthOpacity = depthOpacityOf(opacity);
  return evaluated(asked, progress, [&](const auto& choices, const EvaluationOptions& options, const Progress& told) {
    const VolumeFirstHits hits(volume.scene, {.depthOpacity = depthOpacity});
    const TargetScene scene = hits.evaluated();
    Evaluator evaluator(scene, options);
    std::vector<RepresentationFigures> rows;
    for (const CameraChoice& choice : choices) {
      rows.push_back(evaluator.measure(choice, told));
    }
    return rows;
  });
}

}  // namespace

void bindEvaluation(py::module_& module) {
  module.def(
      "evaluate",
      [](const std::variant<const Mesh*, const PythonVolume*>& truth, const std::string& scene,
         const std::vector<CameraArgument>& cameras, const View& view, int width, int height, float cellSideRadii,
         const std::string& cellShape, int interiorViews, int edgeViews, unsigned seed, bool compareImages, int runs,
         std::optional<double> opacity, const py::object& progress) {
        const Asked asked{scene,     cameras,       view,      width, height,        cellSideRadii,
                          cellShape, interiorViews, edgeViews, seed,  compareImages, runs};
        if (const auto* volume = std::get_if<const PythonVolume*>(&truth)) {
          return evaluatedVolume(**volume, asked, opacity, progress);
        }
        return evaluatedMesh(*std::get<const Mesh*>(truth), asked, progress);
      },
      py::arg("truth"), py::arg("scene"), py::arg("cameras"), py::arg("view"), py::arg("width"), py::arg("height"),
      py::arg("cell_side_radii"), py::arg("cell_shape"), py::arg("interior_views"), py::arg("edge_views"),
      py::arg("seed"), py::arg("compare_images"), py::arg("runs"), py::arg("opacity"), py::arg("progress"));
}

}  // namespace ocelli
