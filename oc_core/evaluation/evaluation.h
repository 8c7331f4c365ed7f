// Measures representations against the scene they stand for: disocclusion errors over a view cell, how their images
// differ, their size, and times (section 3.5.5.7, Tables 3.5 and 3.6). docs/metrics.md defines every figure.
//
// What the scene itself shows from each viewpoint is rendered once, and shared by all representations.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/evaluation/evaluated_scene.h"
#include "oc_core/evaluation/frame_errors.h"
#include "oc_core/evaluation/stored_size.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/ranks/ranks.h"

namespace ocelli {

struct EvaluationOptions {
  View view;
  int width = 0;
  int height = 0;
  ViewCell cell;
  int interiorViews = 12;
  int edgeViews = 1;  ///< between the corners of each edge of a cube
  unsigned seed = 1;
  /// Whether PSNR, SSIM and FLIP are measured: most of the time that viewpoints take.
  bool compareImages = false;
  /// Distances from the reference viewpoint, in half sides of the cell, at which the errors are measured too.
  std::vector<float> offsets;
  int offsetDirections = 4;  ///< how many viewpoints at each distance, but at 0
  int runs = 1;              ///< how often each representation is made and sliced; the best times count
  /// Slices a mesh; its time is `sliceMilliseconds`. May be empty: the rooms above this one know how.
  std::function<void(const Mesh&)> slice;
  /// Those that measure together, each at some of the viewpoints; all call measure() with the same. Each makes the
  /// representations, only the first one more than once. None: this program alone.
  Ranks* ranks = nullptr;
};

/// The distances that the `evaluate` command takes: closer where errors begin.
std::vector<float> defaultOffsets();

struct RepresentationFigures {
  std::string name;
  size_t triangles = 0;
  size_t samples = 0;  ///< that its images hold; the vertices of the mesh where it has no image
  size_t pixels = 0;   ///< of its images
  StoredSize bytes;    ///< of its images; of the mesh where it has no image
  double buildMilliseconds = 0;
  double meshMilliseconds = 0;
  double sliceMilliseconds = 0;
  FrameErrors edges;                   ///< over the edges of the cell
  std::vector<FrameErrors> edgeViews;  ///< at each viewpoint of them, in the order of ViewCell::edgeViews()
  FrameErrors interior;                ///< over seeded points inside
  FrameErrors reference;               ///< at the reference viewpoint
  std::vector<FrameErrors> offsets;    ///< at each distance of the options
  /// Missing over the edges, relative to the depth image of the same view; 0 where that lacks nothing.
  double strictRatioToDi = 0;
  double thickRatioToDi = 0;
};

/// Makes a representation anew, and says how long it took.
using MakeRepresentation = std::function<Representation(RepresentationTimes& times)>;

using MeshVisitor = std::function<void(const Mesh&)>;

class Evaluator {
 public:
  /// `scene` must outlive it. Throws InputError where a viewpoint of the cell lies inside an object of the scene, or
  /// has no view.
  Evaluator(const Mesh& scene, const EvaluationOptions& options);
  /// The same of any scene.
  Evaluator(const EvaluatedScene& scene, const EvaluationOptions& options);
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// Makes the representation of a camera, and measures it. The stage of the progress is `choice.name`. `visit` gets
  /// the mesh; it may be empty.
  RepresentationFigures measure(const CameraChoice& choice, const Progress& progress = {},
                                const MeshVisitor& visit = {});
  /// The same of anything that `make` makes.
  RepresentationFigures measure(const std::string& name, const MakeRepresentation& make, const Progress& progress = {},
                                const MeshVisitor& visit = {});

  /// Half a side to the left, or along a segment against its direction: a viewpoint to show images of.
  View exampleView() const;
  /// The scene seen from there.
  Image<Rgb8> exampleImage() const;
  /// `mesh` seen from there, and its errors in false colours (error_image.h) over the image of the scene.
  struct Example {
    Image<Rgb8> image;
    Image<Rgb8> errors;
  };
  Example example(const Mesh& mesh) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One row for each choice, in their order.
std::vector<RepresentationFigures> evaluate(const Mesh& mesh, const std::vector<CameraChoice>& choices,
                                            const EvaluationOptions& options, const Progress& progress = {});

}  // namespace ocelli
