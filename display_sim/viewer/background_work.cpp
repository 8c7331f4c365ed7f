#include "display_sim/viewer/background_work.h"

#include <algorithm>
#include <chrono>

#include "display_sim/slicing/slicer.h"
#include "display_sim/volume_slicing/swept_range.h"
#include "display_sim/volume_solidity/shown_volume.h"
#include "oc_core/isosurface/isosurface.h"

namespace ocelli {
namespace {

/// Thrown through work that a newer request has made useless.
struct Superseded {};

/// A volume as a display shows it, whatever its transfer function.
struct VolumeOnDisplay {
  std::shared_ptr<const LoadedVolume> volume;
  std::string profile;
  std::array<glm::dvec2, 3> kept;
  VolumeShading shading;
  ValueRange all;  ///< of its voxels
  ShownVolume shown;
};

/// Whether samples tell all values apart that a transfer function does, of those that the volume has.
bool tellApart(const VolumeOnDisplay& there, const TransferFunction& transfer) {
  const ValueRange& told = there.shown.samples().range();
  return std::ranges::all_of(valuesOfChange(transfer), [&](double value) {
    const double inside = std::clamp(value, there.all.least, there.all.greatest);
    return inside >= told.least && inside <= told.greatest;
  });
}

std::shared_ptr<const LoadedVolume> loadedVolume(const WorkWanted& wanted, const Progress& progress) {
  VolumeSceneOptions options = wanted.volumeOptions;
  options.fit = wanted.sceneOptions.fit;
  options.warn = wanted.sceneOptions.warn;
  LoadedVolume loaded{loadVolumeScene(wanted.source, options, progress), {}};
  if (wanted.volumeIsShaded) {
    loaded.scene.appearance.shading.isOn = *wanted.volumeIsShaded;
  }
  report(progress, "counting values", 0);
  loaded.histogram = histogramOf(*loaded.scene.volume);
  return std::make_shared<const LoadedVolume>(std::move(loaded));
}

}  // namespace

/// What stands, and what was tried last, whether it came off or not.
struct BackgroundWork::Done {
  std::shared_ptr<const LoadedScene> scene;
  std::shared_ptr<const BuiltCamera> camera;
  Key sceneKey;
  Key cameraKey;
  Key volumeKey;
  Key raysKey;
  std::optional<VolumeOnDisplay> onDisplay;
};

BackgroundWork::BackgroundWork() : thread_([this] { run(); }) {}

BackgroundWork::~BackgroundWork() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWork::want(const WorkWanted& wanted) {
  {
    const std::scoped_lock lock(mutex_);
    if (wanted_ && keyOf(*wanted_, WorkStep::kVolume) == keyOf(wanted, WorkStep::kVolume)) {
      return;
    }
    wanted_ = wanted;
    fresh_ = true;
    busy_ = true;
  }
  changed_.notify_all();
}

WorkStatus BackgroundWork::status() const {
  const std::scoped_lock lock(mutex_);
  WorkStatus status = status_;
  status.busy = busy_;
  return status;
}

std::optional<WorkResult> BackgroundWork::take() {
  const std::scoped_lock lock(mutex_);
  if (results_.empty()) {
    return std::nullopt;
  }
  WorkResult result = std::move(results_.front());
  results_.erase(results_.begin());
  return result;
}

void BackgroundWork::waitUntilIdle() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !busy_; });
}

BackgroundWork::Key BackgroundWork::keyOf(const WorkWanted& wanted, WorkStep step) {
  Key key{.scene = wanted.sceneRevision};
  if (step != WorkStep::kScene) {
    key.camera = wanted.cameraRevision;
  }
  if (step == WorkStep::kVolume) {
    key.display = wanted.displayRevision;
  }
  return key;
}

void BackgroundWork::run() {
  Done done;
  while (true) {
    WorkWanted wanted;
    {
      std::unique_lock lock(mutex_);
      busy_ = fresh_;
      status_ = {};
      changed_.notify_all();
      changed_.wait(lock, [&] { return stop_ || fresh_; });
      if (stop_) {
        return;
      }
      wanted = *wanted_;
      fresh_ = false;
    }
    try {
      makeAll(wanted, done);
    } catch (const Superseded&) {  // there is something else to make
    }
  }
}

std::optional<WorkResult> BackgroundWork::make(const WorkWanted& wanted, WorkStep step, Key& done, const Make& body) {
  const Key key = keyOf(wanted, step);
  if (key == done) {
    return std::nullopt;
  }
  const auto requireWanted = [&] {  // hold the lock
    if (stop_ || keyOf(*wanted_, step) != key) {
      throw Superseded{};
    }
  };
  const Progress progress = [&](std::string_view stage, double fraction) {
    const std::scoped_lock lock(mutex_);
    requireWanted();
    status_.stage = stage;
    status_.fraction = fraction;
  };
  WorkResult result;
  try {
    result = body(progress);
  } catch (const std::exception&) {
    result = {.error = std::current_exception()};
  }
  result.step = step;
  const std::scoped_lock lock(mutex_);
  requireWanted();
  results_.push_back(result);
  done = key;
  return result;
}

LoadedScene BackgroundWork::loaded(const WorkWanted& wanted, const Done& done, const Progress& progress) {
  LoadedScene scene{
      wanted.source, wanted.sceneRevision, {}, {}, wanted.sceneOptions.points, wanted.sceneOptions.labels};
  if (!isVolumeSource(wanted.source)) {
    scene.mesh = loadScene(wanted.source, wanted.sceneOptions, progress);
    scene.bounds = boundsOf(scene.mesh);
    return scene;
  }
  const bool stands = done.scene && done.scene->volume && done.scene->volumeRevision == wanted.volumeRevision;
  scene.volume = stands ? done.scene->volume : loadedVolume(wanted, progress);
  scene.volumeRevision = wanted.volumeRevision;
  scene.volumeOptions = wanted.volumeOptions;
  scene.volumeIsShaded = wanted.volumeIsShaded;
  scene.iso = wanted.sceneOptions.iso;
  scene.bounds = scene.volume->scene.bounds();
  if (scene.iso) {
    const IsosurfaceOptions options{.value = *scene.iso, .isShaded = wanted.sceneOptions.shading == Shading::kLambert};
    scene.mesh = isosurface(scene.volume->scene, options, wanted.source, progress);
  }
  return scene;
}

SlicedVolume BackgroundWork::sliced(const WorkWanted& wanted, Done& done, const Progress& progress) {
  report(progress, "slicing", 0);
  const DisplayProfile profile = loadProfile(wanted.profile);
  const LoadedScene& scene = *done.scene;
  const bool isOfVolume = scene.volume && (wanted.sliceScene || scene.mesh.triangles.empty());
  using Clock = std::chrono::steady_clock;
  auto start = Clock::now();
  Volume volume(profile);
  if (!isOfVolume) {
    volume = slice(wanted.sliceScene ? scene.mesh : done.camera->representation.mesh, profile);
  } else {
    const VolumeAppearance& appearance = wanted.appearance ? *wanted.appearance : scene.volume->scene.appearance;
    std::optional<VolumeOnDisplay>& there = done.onDisplay;
    if (!there || there->volume != scene.volume || there->profile != wanted.profile || there->kept != wanted.kept ||
        !isSameOnDisplay(there->shading, appearance.shading) || !tellApart(*there, appearance.transfer)) {
      there.reset();
      VolumeScene shown = scene.volume->scene;
      shown.appearance = appearance;
      shown.clips = clipsOf(scene.volume->scene, wanted.kept);
      there.emplace(VolumeOnDisplay{scene.volume, wanted.profile, wanted.kept, appearance.shading,
                                    valueRange(*scene.volume->scene.volume),
                                    ShownVolume(std::move(shown), profile, {}, progress)});
    }
    start = Clock::now();
    VolumeSlicer slicer(profile);
    slicer.slice(there->shown.samples(), there->shown.lightOf(appearance.transfer));
    volume = slicer.takeVolume();
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const size_t lit = volume.litVoxels();
  return {std::move(volume), lit, 1000 * seconds};
}

void BackgroundWork::makeAll(const WorkWanted& wanted, Done& done) {
  if (done.scene == nullptr || done.scene->revision != wanted.sceneRevision) {
    const auto made = make(wanted, WorkStep::kScene, done.sceneKey, [&](const Progress& progress) {
      return WorkResult{.scene = std::make_shared<const LoadedScene>(loaded(wanted, done, progress))};
    });
    if (!made || !made->scene) {
      return;
    }
    done.scene = made->scene;
  }
  const Mesh& mesh = done.scene->mesh;
  const auto makeVolume = [&] {
    make(wanted, WorkStep::kVolume, done.volumeKey, [&](const Progress& progress) {
      return WorkResult{.volume = std::make_shared<const SlicedVolume>(sliced(wanted, done, progress))};
    });
  };
  if (done.scene->volume && mesh.triangles.empty()) {
    makeVolume();
    return;  // the rest is made of triangles
  }
  const auto builtCamera = make(wanted, WorkStep::kCamera, done.cameraKey, [&](const Progress& progress) {
    report(progress, "building \"" + wanted.camera.name + "\"", 0);
    BuiltCamera built{wanted.camera, {wanted.reference, wanted.width, wanted.height}, {}, {}};
    built.representation = buildRepresentation(built.choice, built.reference, mesh, progress, &built.times);
    return WorkResult{.camera = std::make_shared<const BuiltCamera>(std::move(built))};
  });
  if (builtCamera) {
    done.camera = builtCamera->camera;
  }
  if (done.camera == nullptr) {
    return;
  }
  makeVolume();
  make(wanted, WorkStep::kRays, done.raysKey, [&](const Progress& progress) {
    report(progress, "rays of the camera", 0);
    return WorkResult{
        .rays = std::make_shared<const std::vector<RayFunction>>(cameraRays(
            done.camera->choice, done.camera->reference, mesh, done.camera->representation.images, progress))};
  });
}

}  // namespace ocelli
