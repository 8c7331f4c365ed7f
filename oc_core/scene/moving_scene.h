// A scene whose surface moves in time: a series of meshes (mesh_series.h), a file with animations (animated_scene.h),
// or one made by code (oc_core/worlds/waving_scene.h). Who plays one sees triangles that stay the same as long as the
// topology does, so that whatever depends on it alone (creases, orders, acceleration structures) is made once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/scene/mesh.h"
#include "oc_core/scene/point_cloud.h"

namespace ocelli {

/// A mesh as it is at one time.
struct MovedMesh {
  Mesh mesh;
  /// Which triangles, how many vertices, and whether there are colours: the same number stands for the same of them.
  /// 0: nothing yet.
  uint64_t topology = 0;
  /// The same number stands for the same positions and colours, where the topology is the same, too.
  uint64_t shape = 0;
  /// The same number stands for the same colours, where the topology is the same, too.
  uint64_t coloring = 0;
  /// Of each vertex: 1 where its colour is light already, as that of a copy that is not lit (scene.h). Empty where
  /// there is none. The same for one topology.
  std::vector<uint8_t> unlit{};
};

/// What there is to tell of a motion.
struct MotionFacts {
  struct Animation {
    std::string name;  ///< may be empty
    double seconds = 0;
  };
  std::vector<Animation> animations;  ///< of a file that has some
  size_t played = 0;                  ///< which of them
  size_t meshes = 0;                  ///< of a series
  size_t topologies = 1;
  std::optional<PointFacts> points{};  ///< of a file with points or lines, which became geometry
};

class MovingScene {
 public:
  virtual ~MovingScene() = default;

  /// Positive.
  virtual double durationSeconds() const = 0;
  virtual MotionFacts facts() const = 0;
  /// Times that show all of the motion, as well as that is known: every mesh of a series, or some between which nothing
  /// moves far. In ascending order, from 0 on, each less than or equal to the duration.
  virtual std::vector<double> sampleTimes() const = 0;

  /// Sets `moved` to the scene at that time; times before the begin and after the end stand for these. `moved` is new,
  /// or what an earlier call of the same scene left, which makes it faster. Where the topology is the same its
  /// triangles are not touched. The same bytes for any number of threads, and whatever was there before.
  virtual void moveTo(double seconds, MovedMesh& moved) const = 0;
};

/// So many times from 0 to the duration, both included, in equal steps.
std::vector<double> evenTimes(double durationSeconds, size_t count);

/// The time within a motion of that duration after it has been played for `seconds`; where it does not loop, its end.
double timeInMotion(double seconds, double durationSeconds, bool loop);

/// The uniform scale and translation that put all of the motion into the unit sphere around the origin: the sphere
/// around the centre of the box that holds every vertex at every one of the sampleTimes(). What moves far between two
/// of these may reach beyond it. Throws InputError naming `where` if there is no extent.
glm::mat4 unitFromMotion(const MovingScene& scene, const std::string& where);

}  // namespace ocelli
