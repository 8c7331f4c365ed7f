// Builds a cell camera for a scene and a cell of viewpoints: a single-layer reference image that holds what is seen
// from anywhere in the cell (the text's future work, section 8.2, here for a region of viewpoints).
//
// The reference view keeps all of its samples, as in a depth image. Then satellites, pinholes at other viewpoints of
// the cell, each add what the mesh made so far lacks there: the image-set-difference of section 3.1.4, with the mesh in
// the place of the image, since what the mesh interpolates need not be stored again. The rays of a satellite thus start
// where no viewpoint before it sees, which keeps the projection unambiguous (cell_camera.h).
#pragma once

#include "oc_core/base/progress.h"
#include "oc_core/camera/cell_camera.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/ocri/view_cell.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct CellOptions {
  ViewCell cell;
  /// Most samples, relative to the depth image. Where they do not suffice, satellites take theirs farther apart.
  float maxSamples = 1.3f;
  float coarsestSpacing = 2;  ///< of the samples of satellites, pixels of the reference image
  int maxSatellites = 24;     ///< viewpoints that are tried: the corners of the cell, then points spread over it
  /// A satellite that would add fewer samples than this share of the depth image's is passed over.
  float minShare = 1e-3f;
  /// Missing samples in groups smaller than this are seams of the mesh: they are not stored.
  int minGroup = 4;
  /// Around what is missing, so many pixels of the same surface are stored too: they close the seam to the mesh so far.
  int seamPixels = 1;
  int feedbackRounds = 2;  ///< "do no harm": satellite samples that bury what a viewpoint sees are taken out again
};

/// A view that sees nothing gives a camera without satellites. `renderer`, here and below, draws the images that the
/// construction takes.
CellCamera buildCellCamera(const PinholeCamera& reference, const Mesh& mesh, const CellOptions& options = {},
                           const Progress& progress = {}, const SceneRenderer* renderer = nullptr);

/// The samples of each viewpoint, where its rays end.
ReferenceImage buildCellImage(const CellCamera& camera, const Mesh& mesh, const SceneRenderer* renderer = nullptr);

/// The same image without the camera: both share what they draw, which is faster than one after the other.
ReferenceImage buildCellImage(const PinholeCamera& reference, const Mesh& mesh, const CellOptions& options,
                              const Progress& progress = {}, const SceneRenderer* renderer = nullptr);

/// The same from fragments that some renderer left at the pixels of the camera.
ReferenceImage cellImage(const CellCamera& camera, const FragmentImage& fragments, const Mesh& mesh);

}  // namespace ocelli
