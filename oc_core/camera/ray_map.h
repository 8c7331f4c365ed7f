// A camera as an array: the ray of each pixel, or none. It holds any camera of anyone, and those of this toolkit, whose
// rays bend (camera.h). ray_map_camera.h makes a camera of it, oc_core/ray_map its file.
//
// Lengths are those of the scene: radii of a fitted one, what its file says with --no-fit.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/camera/ray_path.h"
#include "oc_core/camera/view.h"

namespace ocelli {

/// What the coordinates of a ray map are.
enum class RayFrame {
  kWorld,  ///< those of the scene as it is drawn: the camera stands where it is
  kView,   ///< right, up and backward from the eye of the view that the camera is placed at: a lens on its own
};
inline constexpr std::array<RayFrame, 2> kRayFrames{RayFrame::kWorld, RayFrame::kView};
/// As files say it.
const char* nameOf(RayFrame frame);

/// What there is to say of a map beside its rays.
struct RayMapNotes {
  std::string name = "rays";  ///< what tables and files call the camera
  RayFrame frame = RayFrame::kWorld;
  std::optional<View> view = {};  ///< the one that it was made for
  bool wrapsAround = false;       ///< the last column is next to the first
};

/// One ray of a map: world points from near to far and their parameters, which grow.
struct RayMapRay {
  std::span<const glm::vec3> points;
  std::span<const float> parameters;

  bool empty() const { return points.empty(); }
  float tMin() const { return parameters.front(); }
  float tMax() const { return parameters.back(); }
  RayPath path() const;
};

class RayMap {
 public:
  /// How far straight rays reach where nothing says it: as far as those of a view.
  static constexpr float kDefaultFar = 1000;

  /// Straight rays, of row after row from the top: one origin and one direction for each pixel. t is the distance from
  /// the origin; the ray runs from t = `near` to `far`. A direction is of any length but 0; a pixel has no ray where
  /// its direction is 0, or a number of its ray is not finite. Throws InputError, naming `where`, where the size is not
  /// positive or exceeds that of images (pinhole_camera.h), the arrays are not as large, no pixel has a ray, or `near`
  /// is negative or not below `far`.
  static RayMap ofStraightRays(const glm::ivec2& size, std::span<const glm::vec3> origins,
                               std::span<const glm::vec3> directions, float near, float far, RayMapNotes notes,
                               const std::string& where);

  /// The rays of a camera at the centres of its pixels; called from many threads. Throws InputError as above.
  static RayMap ofCamera(const glm::ivec2& size, const std::function<RayPath(const glm::vec2& pixel)>& ray,
                         RayMapNotes notes, const std::string& where, const Progress& progress = {});

  /// Polylines one after the other: those of pixel i are the points from ends[i - 1] (0 for the first) to ends[i].
  /// Throws InputError as above, and where a ray has one point or more than a RayPath holds, a number that is not
  /// finite, or a parameter that does not grow.
  static RayMap ofPolylines(const glm::ivec2& size, std::vector<size_t> ends, std::vector<glm::vec3> points,
                            std::vector<float> parameters, RayMapNotes notes, const std::string& where);

  int width() const { return size_.x; }
  int height() const { return size_.y; }
  const RayMapNotes& notes() const { return notes_; }
  RayMapRay ray(int x, int y) const;
  size_t rayCount() const { return rays_; }
  /// Straight segments of the ray that has most of them.
  size_t maxSegments() const { return maxPoints_ - 1; }

  /// The same map with its rays in the world, where the camera stands at `view`; itself where they are there already.
  RayMap placedAt(const View& view) const;

 private:
  RayMap() = default;

  glm::ivec2 size_{0};
  std::vector<size_t> ends_;
  std::vector<glm::vec3> points_;
  std::vector<float> parameters_;
  RayMapNotes notes_;
  size_t rays_ = 0;
  size_t maxPoints_ = 0;
};

/// What a map consists of, for those who look at it.
struct RayMapFacts {
  size_t rays = 0;
  size_t bent = 0;      ///< of them
  size_t segments = 0;  ///< of the ray that has most
  glm::vec3 lower{0};   ///< of the box around where the rays begin
  glm::vec3 upper{0};
  float tMin = 0;
  float tMax = 0;
};
RayMapFacts factsOf(const RayMap& map);

}  // namespace ocelli
