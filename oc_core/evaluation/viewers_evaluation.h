// What each of several viewers around a display misses who share one mesh, over a view cell of his own: against what he
// would miss with the mesh of his own reference image alone. docs/metrics.md defines the figures.
#pragma once

#include <string>
#include <vector>

#include "oc_core/evaluation/evaluation.h"
#include "oc_core/ocri/viewers.h"

namespace ocelli {

struct ViewerFigures {
  View view;
  ViewerShare samples;
  RepresentationFigures own;     ///< of his own images alone
  RepresentationFigures merged;  ///< of the mesh of all, seen from his cell
};

struct ViewersFigures {
  std::string camera;
  size_t triangles = 0;  ///< of the mesh of all
  size_t samples = 0;
  double mergeMilliseconds = 0;  ///< for leaving out what earlier viewers hold, and the mesh
  std::vector<ViewerFigures> viewers;
};

/// The view of `options` is of no meaning: each viewer has one in `views`. The camera must have images. Throws as
/// Evaluator and buildReferenceImages() do.
ViewersFigures evaluateViewers(const Mesh& scene, const CameraChoice& camera, const std::vector<View>& views,
                               const EvaluationOptions& options, const Progress& progress = {});

/// For people, as text of fixed width.
std::string viewersTable(const ViewersFigures& figures);
/// {"scene", "camera", "size", "cell", "triangles", "samples", "viewers": [...]}.
std::string viewersJson(const std::string& scene, const EvaluationOptions& options, const ViewersFigures& figures);

}  // namespace ocelli
