#include "display_driver/pacing/eyes_source.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "display_sim/slicing/slice_mesh.h"
#include "oc_core/base/error.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/ocri/union_mesh.h"

namespace ocelli {
namespace {

enum Step { kBuilding, kMeshing, kSlicing, kMoving };

/// Of a refresh, what making may take: the rest is for what else the machine does.
constexpr double kShareOfRefresh = 0.85;
/// Refreshes that an eye must rest until it is shown all pixels of what it sees, however long that takes.
constexpr int kRestingRefreshes = 12;

class StopWatch {
 public:
  /// Since the last time, or since it was made.
  std::chrono::nanoseconds lap() {
    const auto now = std::chrono::steady_clock::now();
    return now - std::exchange(begin_, now);
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

View viewFrom(const glm::vec3& eye) {
  View view;
  view.eye = eye;
  // Straight above, any direction is up.
  if (std::abs(glm::dot(glm::normalize(view.eye), view.up)) > 0.9999f) {
    view.up = {0, 0, -1};
  }
  validate(view, "the eye");
  return view;
}

int scaled(int pixels, double scale) {
  return std::max(1, static_cast<int>(std::lround(pixels * scale)));
}

}  // namespace

EyesSource::EyesSource(ImagesFor imagesFor, const DisplayProfile& profile, const EyesOptions& options, EyeFeed& feed)
    : imagesFor_(std::move(imagesFor)),
      options_(options),
      feed_(feed),
      slicer_(profile, options_.slicing),
      stages_{{"reference image", {}}, {"mesh", {}}, {"slices", {}}},
      scale_(kShareOfRefresh / profile.refreshHertz(), options_.minImageScale) {
  if (options_.moveScene) {
    stages_.push_back({"motion", {}});
  }
}

EyesSource::~EyesSource() = default;

SourcedVolume EyesSource::leaveOut(const std::string& why) {
  if (leftOut_++ == 0) {
    firstLeftOut_ = why;
  }
  return {.kind = SourcedVolume::Kind::kSame};
}

TwoStageLine::SecondStage EyesSource::begin(HostTime seen) {
  const auto nothing = [](const SourcedVolume& volume) { return [volume] { return volume; }; };
  StopWatch watch;
  const auto scene = options_.moveScene ? options_.moveScene(seen) : EyesOptions::SceneState::kSame;
  const auto moving = watch.lap();
  const bool ended = feed_.ended(seen) || scene == EyesOptions::SceneState::kEnded;
  // After the scene has moved, so that the place is as late as can be.
  const std::optional<glm::vec3> eye = feed_.eyeAt(seen);
  const bool isSame = eye == eye_ && scene == EyesOptions::SceneState::kSame;
  resting_ = isSame ? resting_ + 1 : 0;
  const bool refines = isSame && lastScale_ < 1 && (ended || resting_ >= kRestingRefreshes);
  if (!eye || scene == EyesOptions::SceneState::kEnded || (isSame && !refines)) {
    return nothing({.kind = ended ? SourcedVolume::Kind::kEnd : SourcedVolume::Kind::kSame});
  }
  eye_ = eye;
  const double scale = [&] {
    const std::lock_guard lock(scaleMutex_);
    return refines ? 1 : scale_.next();
  }();
  lastScale_ = scale;
  try {
    const PinholeCamera reference(viewFrom(*eye), scaled(options_.width, scale), scaled(options_.height, scale));
    const auto made = std::make_shared<const Made>(imagesFor_(reference));
    const auto took = watch.lap();
    stages_[kBuilding].times.add(took);
    if (options_.moveScene) {
      stages_[kMoving].times.add(moving);
    }
    // One cold image comes once; where one follows the other they are the rule.
    const bool isException = refines || (made->beganCold && !lastBeganCold_);
    lastBeganCold_ = made->beganCold;
    const ImageCost cost{scale, std::chrono::duration<double>(moving + took).count(), isException};
    return [this, made, cost] { return sliced(made->images, cost); };
  } catch (const InputError& error) {
    lastScale_ = 1;  // nothing to refine
    return nothing(leaveOut(error.what()));
  }
}

SourcedVolume EyesSource::sliced(const ReferenceImages& images, const ImageCost& cost) {
  StopWatch watch;
  const Mesh mesh = unionMesh(images);
  const auto meshing = watch.lap();
  slicer_.slice(SliceMesh(mesh));
  const auto slicing = watch.lap();
  stages_[kMeshing].times.add(meshing);
  stages_[kSlicing].times.add(slicing);
  if (!cost.isException) {
    const double slicingSeconds = std::chrono::duration<double>(meshing + slicing).count();
    const std::lock_guard lock(scaleMutex_);
    scale_.add(cost.scale,
               options_.refreshesToMake == 1 ? cost.seconds + slicingSeconds : std::max(cost.seconds, slicingSeconds));
  }
  return {
      .kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared(), .imageScale = static_cast<float>(cost.scale)};
}

SourcedVolume EyesSource::volumeFor(HostTime seen) {
  return begin(seen)();
}

VolumeLine* EyesSource::line() {
  if (line_ == nullptr) {
    line_ = std::make_unique<TwoStageLine>([this](HostTime seen) { return begin(seen); });
  }
  return line_.get();
}

}  // namespace ocelli
