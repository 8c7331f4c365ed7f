// The work of the viewer that takes its time, on a thread of its own: loading the scene, building reference images and
// their mesh, the camera's rays, and the volume. A newer request takes the place of an older one, whose results are
// dropped; what the newer one has in common with it is not made again.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "display_sim/frames/volume.h"
#include "display_sim/viewer/camera_rays.h"
#include "display_sim/viewer/loaded_volume.h"
#include "display_sim/viewer/viewer_state.h"
#include "oc_core/ocri/representation.h"

namespace ocelli {

struct LoadedScene {
  std::string source;
  uint64_t revision = 0;  ///< of the request
  Mesh mesh;              ///< of a volume that of its surface, or empty
  Box bounds;
  PointSceneOptions points{};                       ///< with which it was loaded
  LabelOptions labels{};                            ///< with which it was loaded
  std::shared_ptr<const LoadedVolume> volume = {};  ///< null: the scene is none
  uint64_t volumeRevision = 0;                      ///< of the request of the volume
  VolumeSceneOptions volumeOptions = {};            ///< with which that was loaded
  std::optional<bool> volumeIsShaded = {};          ///< as the user said then; nothing: as its transfer function says
  std::optional<double> iso = {};                   ///< the value of the surface that the mesh is
};

struct BuiltCamera {
  CameraChoice choice;
  PinholeCamera reference;
  Representation representation;
  RepresentationTimes times;
};

struct SlicedVolume {
  Volume volume;
  size_t litVoxels = 0;
  double milliseconds = 0;
};

enum class WorkStep { kScene, kCamera, kVolume, kRays };

/// What has been finished, or has failed, since the last look: null pointers stand for "nothing new".
struct WorkResult {
  std::shared_ptr<const LoadedScene> scene = nullptr;
  std::shared_ptr<const BuiltCamera> camera = nullptr;
  std::shared_ptr<const std::vector<RayFunction>> rays = nullptr;
  std::shared_ptr<const SlicedVolume> volume = nullptr;

  std::exception_ptr error = nullptr;  ///< of `step`
  WorkStep step = WorkStep::kScene;
};

struct WorkStatus {
  bool busy = false;
  std::string stage;
  double fraction = 0;
};

class BackgroundWork {
 public:
  BackgroundWork();
  /// Waits for the step that is under way.
  ~BackgroundWork();
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// Whatever differs in its revisions from what was wanted before is made. One whose scene, camera or display failed
  /// does not try that again until its revision changes.
  void want(const WorkWanted& wanted);
  WorkStatus status() const;
  /// One finished step after the other; nothing where there is none.
  std::optional<WorkResult> take();
  /// Until nothing is left to do. Results wait to be taken.
  void waitUntilIdle();

 private:
  struct Done;
  /// What a step depends on.
  struct Key {
    uint64_t scene = 0;
    uint64_t camera = 0;
    uint64_t display = 0;
    bool operator==(const Key&) const = default;
  };
  using Make = std::function<WorkResult(const Progress& progress)>;

  static Key keyOf(const WorkWanted& wanted, WorkStep step);
  void run();
  static SlicedVolume sliced(const WorkWanted& wanted, Done& done, const Progress& progress);
  static LoadedScene loaded(const WorkWanted& wanted, const Done& done, const Progress& progress);
  void makeAll(const WorkWanted& wanted, Done& done);
  /// Makes what has another key than `done`, and hands it on, or its error; nothing where it stands. Throws Superseded
  /// where something else is wanted by now.
  std::optional<WorkResult> make(const WorkWanted& wanted, WorkStep step, Key& done, const Make& body);

  mutable std::mutex mutex_;  ///< guards what follows
  std::condition_variable changed_;
  std::optional<WorkWanted> wanted_;
  bool fresh_ = false;  ///< wanted_ has not been looked at
  bool busy_ = false;
  bool stop_ = false;
  WorkStatus status_;
  std::vector<WorkResult> results_;
  std::thread thread_;
};

}  // namespace ocelli
