// Builds an epipolar occlusion camera for a scene and a view segment (section 3.3.1.1), and its reference image.
//
// The base pinhole stands at the left end of the segment with the reference view's direction; its frustum is sheared,
// so that its window covers what is seen from the whole segment. Where the segment is parallel to the image plane the
// base view is rolled until the segment runs along its rows.
//
// DEVIATION: a step of 1/z is a depth discontinuity where the slopes on both of its sides do not explain it, and the
// segment can uncover `minAddedPixels` behind it. Planes, however grazing, have none.
//
// DEVIATION: what an edge adds is bounded by what its occluder hides ("compact" rows). Where a narrow occluder leaves
// the text's rays of R without a sample (the black gaps of Figure 3.20, right), they turn into rays of L earlier in the
// row.
//
// DEVIATION: z_f is that of the farthest surface among the next `backgroundReachPixels` of the row. The text takes the
// pixel next to the edge; what that surface hides in turn then stays hidden, though R sees it between the two.
//
// DEVIATION: added columns that turn out to hold nothing, at the left end of those of an edge, are taken out again.
//
// DEVIATION: behind the last surface of a row the text has no z_f: what nothing covers counts as far as the farthest
// vertex of the scene.
#pragma once

#include "oc_core/camera/epipolar_camera.h"
#include "oc_core/ocri/reference_image.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

struct EocOptions {
  /// Steps of depth that uncover less are no edges, pixels.
  float minAddedPixels = 0.75f;
  /// Bound the columns of an edge by what its occluder hides and `compactSlackPixels`.
  bool compact = true;
  int compactSlackPixels = 2;
  int backgroundReachPixels = 50;
  /// Take out columns that hold nothing: costs drawing what is hidden once more.
  bool trim = true;
  /// Where not 0: edges are where z steps by more than its slopes explain, by this much, display radii.
  float edgeDepthStepRadii = 0;

  /// The text's algorithm: z_f of the pixel next to the edge, black gaps, no trimming, edges on z.
  static EocOptions literal();
};

/// Directions of view segments, along (right, up, backward) of a view.
inline constexpr glm::vec3 kHorizontalSegment{1, 0, 0};
inline constexpr glm::vec3 kVerticalSegment{0, 1, 0};
inline constexpr glm::vec3 kForwardSegment{0, 0, -1};

/// The segment of this length (display radii) whose middle is the eye of the view. Throws InputError for a length that
/// is not positive and a direction without one.
ViewSegment segmentAround(const View& view, const glm::vec3& direction, float lengthRadii);

/// The pinhole at the left end of the segment. `reference` gives its direction, focal length and least size.
PinholeCamera basePinhole(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh);

/// The edges of a row. `inverseZ` holds 1/z of its base pixels, 0 where nothing is seen; `backgroundInverseZ` stands
/// for what is behind everything.
std::vector<EpipolarEdge> findEpipolarEdges(const std::vector<float>& inverseZ, int row, const EpipolarLines& lines,
                                            float zNear, float backgroundInverseZ, const EocOptions& options);

/// Throws InputError where an end of the segment lies inside an object, or the segment is none. Where
/// `renderer`, here and below, has rays, no step touches all triangles (construction.h): the box around the scene
/// stands for its vertices, and the caller must have checked the ends.
EpipolarCamera buildEpipolarCamera(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh,
                                   const EocOptions& options = {}, const SceneRenderer* renderer = nullptr);
/// As that throws; this touches all triangles.
void requireOutsideEnds(const ViewSegment& segment, const Mesh& mesh);

/// The OCRI. Its `reference()` is the base pinhole.
ReferenceImage buildEocImage(const EpipolarCamera& camera, const Mesh& mesh, const SceneRenderer* renderer = nullptr);
/// Both steps at once: faster, as they share what the base pinhole sees.
ReferenceImage buildEocImage(const PinholeCamera& reference, const ViewSegment& segment, const Mesh& mesh,
                             const EocOptions& options = {}, const SceneRenderer* renderer = nullptr);

/// Turns what a renderer left for `camera` into a reference image.
ReferenceImage eocImage(const FragmentImage& fragments, const EpipolarCamera& camera, const Mesh& mesh);

}  // namespace ocelli
