// A plan of a camera in its scene, as Figures 4.14, 4.18 and 4.25 are: the frusta, and rays to what they see, over a
// section of the scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oc_core/camera/ray_map_camera.h"
#include "oc_core/constructor/multiperspective_camera.h"
#include "oc_core/image/png_file.h"
#include "oc_core/multiperspective/plan_section.h"

namespace ocelli {

struct PlanOptions {
  PlanSide side = PlanSide::kTop;
  std::optional<float> cut{};  ///< where the section is, along the axis of `side`; at the root's eye where missing
  int rays = 48;               ///< from the left of the image to its right
  int groundPixels = 1200;     ///< longer side of the image of the scene below; 0 for none
};

/// Lengths are those of the world, on the paper (plan_side.h).
struct CameraPlan {
  /// A frustum, or a segment of a curved ray camera.
  struct Part {
    std::string name;
    glm::vec2 viewpoint{0};
    std::vector<std::vector<glm::vec2>> outlines;  ///< convex; around what its rays pass
  };
  /// A ray to the first surface that it meets, or out of the scene.
  struct Ray {
    struct Piece {
      int part = 0;
      std::vector<glm::vec2> points;
    };
    std::vector<Piece> pieces;
    bool meetsSurface = false;
  };

  PlanSide side = PlanSide::kTop;
  glm::vec2 lower{0};  ///< the frame: what is worth showing
  glm::vec2 upper{0};
  std::vector<Part> parts;
  std::vector<Ray> rays;
  std::vector<SectionLine> section;
  Image<Rgb8> ground;  ///< of the frame; what lies beyond the cut, seen from that side
};

/// Of each column of the image, the ray to the farthest surface is drawn, or where none meets one the longest. Throws
/// InputError for an empty scene.
CameraPlan planOf(const MultiperspectiveCamera& camera, const Mesh& mesh, const PlanOptions& options = {});
/// The same of a ray map, which is one part. Without a cut it is cut in the middle of where its rays begin.
CameraPlan planOf(const RayMapCamera& camera, const Mesh& mesh, const PlanOptions& options = {});

}  // namespace ocelli
