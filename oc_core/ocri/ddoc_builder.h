// Builds a depth discontinuity occlusion camera for a scene and a reference view (section 3.2.2, six steps), and its
// reference image.
//
// Three variants. `DdocOptions::literal()` is the text's algorithm. `paper()` has its constant splat radius D and
// nearest sample of the map, with our edges on 1/z, which planes have none of. The default goes further:
//
// DEVIATION: the hidden band of an edge is as wide as the view cell can uncover, f * support(n) * (1/zn - 1/zf). The
// visible band that makes room for it may be narrower, which squeezes it harder. The text's D fits no edge.
//
// DEVIATION: only splats that face each other conflict (step 4): behind a thin occluder two splats share what it hides.
//
// DEVIATION: the bands change gradually along a silhouette: neighbours of different width tear the image.
//
// DEVIATION: "do no harm": edges that bury samples the reference view sees are shrunk, for some rounds.
//
// DEVIATION: the field is smoothed and looked up bilinearly, so that it folds and tears less at the borders of splats.
#pragma once

#include "oc_core/base/progress.h"
#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/ocri/band_memory.h"
#include "oc_core/ocri/distortion_splats.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/render/rasterize_subdivided.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct DdocOptions {
  enum class Radius {
    kConstant,  ///< `constantRadiusPixels` for every edge
    kViewCell,  ///< from the parallax over the view cell
  };
  Radius radius = Radius::kViewCell;
  float constantRadiusPixels = 15;

  /// The view cell is a cube of this side around the reference eye, display radii (8 in at the reference display).
  float cellSideRadii = 1.6f;
  float safetyFactor = 1.15f;  ///< on the parallax
  float maxHiddenPixels = 48;  ///< cap on the hidden band
  float roomPerHidden = 0.6f;  ///< visible band for each pixel of hidden band, where nothing competes for it
  Conflicts conflicts = Conflicts::kFacing;
  float maxHiddenPerRoom = 6;      ///< hardest squeeze: (hidden + room) / room - 1
  float steepestBandGrowth = 6;    ///< of the bands along a silhouette, pixels a pixel; 0 leaves them as they are
  float smoothingSigmaPixels = 1;  ///< of the field; 0 turns smoothing off: nearest lookup, as in the text

  int feedbackRounds = 3;               ///< most "do no harm" rounds; 0 turns it off
  float feedbackShrink = 0.5f;          ///< what a round leaves of the hidden band of an edge that does harm
  float harmlessPerHiddenPixel = 0.1f;  ///< missing samples that an edge may cost for each pixel of its hidden band

  /// Where not 0: edges are where z steps by more than its slopes explain, by this much, display radii: the text's
  /// "second order finite depth difference", whose threshold it does not say.
  float edgeDepthStepRadii = 0;
  /// Whether pixels that a shrunk splat has given up go to another one; in the text (step 5) they are deleted.
  bool reclaimPixels = true;

  SubdivisionOptions subdivision;
  /// Of the rounds, whose images only have to show what is lost: coarser, and three times as fast.
  SubdivisionOptions feedbackSubdivision{.longestEdgePixels = 2, .shortestEdgePixels = 0.25f, .tornEdgePixels = 4};

  /// What the text's figures need: a constant radius, all conflicts, equal bands, no smoothing and no feedback.
  static DdocOptions paper(float constantRadiusPixels = 15);
  /// The same to the letter: edges on z, and no pixel changes hands after step 3.
  static DdocOptions literal();
};

/// `mesh` is in the coordinates of the view of `reference`. Throws nothing of its own: a view that sees nothing gives a
/// camera that displaces nothing. `renderer`, here and below, draws the images that the construction takes.
DdocCamera buildDdocCamera(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options = {},
                           const Progress& progress = {}, const SceneRenderer* renderer = nullptr);

/// The OCRI. Its `triangleBound` is that of the depth image of the same view.
ReferenceImage buildDdocImage(const DdocCamera& camera, const Mesh& mesh, const SubdivisionOptions& options = {},
                              const SceneRenderer* renderer = nullptr);

/// The same image without the camera: both share what they draw, which is faster than one after the other.
ReferenceImage buildDdocImage(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                              const Progress& progress = {}, const SceneRenderer* renderer = nullptr);

struct NextDdocImage {
  ReferenceImage image;
  bool warm = false;  ///< whether it began from what the last one knew
};

/// For an eye that moves: the same image, whose bands begin as they ended in the last one, in place of the rounds of
/// feedback, and are judged by this image itself for the next one. It is built cold, as above, where the last image's
/// silhouettes are not most of this one's, and where the eye has left its view cell: the first time, and after a jump.
NextDdocImage buildNextDdocImage(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                                 BandMemory& memory, const Progress& progress = {},
                                 const SceneRenderer* renderer = nullptr);

}  // namespace ocelli
