// Measures reference images against the scene they stand for: disocclusion error over a view cell, size, and time
// (section 3.5.5.7, Table 3.5).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/coverage.h"

namespace ocelli {

struct EvaluationOptions {
  View view;
  int width = 0;
  int height = 0;
  ViewCell cell;
  int interiorViews = 12;
  unsigned seed = 1;
  /// Slices a mesh; its time is `sliceMilliseconds`. May be empty: the rooms above this one know how.
  std::function<void(const Mesh&)> slice;
};

struct RepresentationFigures {
  std::string name;
  size_t triangles = 0;
  size_t samples = 0;
  double buildMilliseconds = 0;
  double meshMilliseconds = 0;
  double sliceMilliseconds = 0;
  MissingSamples edges;      ///< over the edge midpoints and corners of the cell
  MissingSamples interior;   ///< over seeded points inside
  MissingSamples reference;  ///< at the reference viewpoint
  /// Missing over the edges, relative to the depth image of the same view; 0 where that lacks nothing.
  double strictRatioToDi = 0;
  double thickRatioToDi = 0;
};

/// One row for each choice, in their order.
std::vector<RepresentationFigures> evaluate(const Mesh& mesh, const std::vector<CameraChoice>& choices,
                                            const EvaluationOptions& options, const Progress& progress = {});

/// {"scene", "view", "size", "cell", "seed", "representations": [...]}: see docs/metrics.md.
std::string evaluationJson(const std::string& scene, const EvaluationOptions& options,
                           const std::vector<RepresentationFigures>& figures);
/// A table for people, one line a representation.
std::string evaluationTable(const std::vector<RepresentationFigures>& figures);

}  // namespace ocelli
