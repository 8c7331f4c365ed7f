// The views of a quilt: pinholes along a line, whose image planes are one (off-axis, or sheared, frusta). The plane
// through the target of the middle view is where the display itself stands: a point in it has the same pixel in all
// views, points before and behind it move against each other.
//
// View i of N is seen from eye + right d tan(a_i), where d is the distance of the target and a_i runs from -cone/2
// (view 0, the leftmost) to +cone/2.
//
// Pinholes have square pixels, and those of a tile need not be: they are as wide as pixelAspect() of the display. So
// the cameras look at a world that is stretched along the right of the view, around its eye, by 1 / pixelAspect().
// stretchScene() takes a scene there. Colours, depths and rows are the same.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "display_sim/quilt/quilt_display.h"
#include "oc_core/camera/epipolar_lines.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/scene/mesh.h"

namespace ocelli {

class QuiltViews {
 public:
  /// `view` is the middle view. Where it has no field of view, one that holds the unit sphere around its target in both
  /// directions. Throws InputError as validate(View) does, and where a view would lie too far aside.
  QuiltViews(QuiltDisplay display, const View& view);

  const QuiltDisplay& display() const { return display_; }
  int count() const { return display_.viewCount(); }
  double angleDegrees(int view) const;
  /// A view as it stands in the stretched world, as large as a tile.
  const PinholeCamera& camera(int view) const { return cameras_[static_cast<size_t>(view)]; }
  /// The top left pixel of its tile.
  glm::ivec2 tileOrigin(int view) const { return tileOriginOf(display_, view); }

  /// Between the views, in a world that is stretched by `stretch`: its image has `width` pixels.
  PinholeCamera middle(double stretch, int width) const;
  /// The eye of a view there.
  glm::vec3 eyeIn(double stretch, int view) const;
  glm::vec3 middleEye() const { return view_.eye; }

  /// 1 / pixelAspect().
  double stretch() const { return stretch_; }
  /// Unit vector, the same in all these worlds.
  const glm::vec3& right() const { return right_; }
  /// Moves all that lies to the right or left of the middle eye to `factor` times as far.
  void stretchScene(Mesh& scene, double factor) const;

 private:
  double offset(int view) const;  ///< of its eye, to the right, in the world as it is
  PinholeCamera cameraAt(double offset, double stretch, int width) const;

  QuiltDisplay display_;
  View view_;
  double stretch_;
  glm::vec3 right_;
  std::vector<PinholeCamera> cameras_;
};

}  // namespace ocelli
