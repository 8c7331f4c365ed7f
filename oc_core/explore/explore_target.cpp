// Keeps an object in sight that is clicked (section 4.3.1.3): curved rays bend around what hides it. The target of a
// scene that has one is chosen at first.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "oc_core/constructor/target_constructor.h"
#include "oc_core/constructor/target_sight.h"
#include "oc_core/explore/explore_boxes.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

// Metres to the nearest corner of the target. Its rays begin to bend half way to it, so near ones swing far.
constexpr double kTargetStraightMetres = 0.5;
constexpr double kTargetBentMetres = 2.5;
constexpr double kSlowChange = 0.02;  // of f from frame to frame: as fast as one turns, at most

class LiveTarget final : public LiveConstructor {
 public:
  explicit LiveTarget(const ExploreScene& scene) : tracker_(options_) {
    options_.maxChange = kSlowChange;
    if (scene.guides().target) {
      aimAt(scene, scene.guides().target->box, scene.guides().target->object);
    }
  }

  LiveCamera camera(const LiveMoment& moment) override {
    LiveCamera live{CurvedRayCamera(moment.view)};
    if (!target_) {
      live.notes.push_back({ExploreNote::Kind::kState, "click an object to keep it in sight"});
      return live;
    }
    if (moment.seconds > 0) {
      tracker_.update(moment.view, occluders_, *target_);
    }
    const double faded =
        fadedByDepth(*target_, moment.view, moment.scene.metre(), kTargetStraightMetres, kTargetBentMetres) *
        moment.deployed;
    live.camera = bentCamera(moment.view, *target_, tracker_.f() * faded);
    live.notes.push_back(note(moment));
    return live;
  }

  bool accepts(const ExploreScene& scene, const ExplorePick& pick) const override {
    return clickedBox(scene, pick).has_value();
  }
  void pick(const ExploreScene& scene, const ExplorePick& pick) override {
    if (const std::optional<Box> box = clickedBox(scene, pick)) {
      aimAt(scene, *box, pick.object);
    }
  }
  std::optional<Box> picked() const override { return target_; }

  double option(size_t index) const override { return index < kNumbers ? options_.*kOptions[index] : sightIndex_; }
  void setOption(size_t index, double value) override {
    if (index < kNumbers) {
      options_.*kOptions[index] = value;
    } else {
      sightIndex_ = value;
      options_.sight = targetSights()[static_cast<size_t>(value)].name;
    }
    // Only f is remembered from frame to frame.
    TargetOptions options = options_;
    options.f = tracker_.f();
    tracker_ = TargetTracker(options);
  }

 private:
  static constexpr double TargetOptions::*kOptions[] = {&TargetOptions::maxF, &TargetOptions::maxChange,
                                                        &TargetOptions::visibleShare, &TargetOptions::enlarged,
                                                        &TargetOptions::enlargedPixels};
  static constexpr size_t kNumbers = std::size(kOptions);

  void aimAt(const ExploreScene& scene, const Box& box, uint32_t object) {
    target_ = box;
    occluders_.clear();
    for (size_t i = 1; i < scene.objects().size(); ++i) {
      const Box& other = scene.objects()[i];
      if (i != object && !other.empty() && !contains(box, other.center()) && !contains(other, box.center())) {
        occluders_.push_back(other);
      }
    }
    TargetOptions options = options_;
    options.f = 0;
    tracker_ = TargetTracker(options);
  }

  ExploreNote note(const LiveMoment& moment) const {
    const glm::vec3 middle = moment.view.cameraFromWorld(target_->center());
    if (!(middle.z > moment.view.view().zNear)) {
      return {ExploreNote::Kind::kState, "the target is not in view"};
    }
    const double f = tracker_.f();
    const double wanted = tracker_.wanted(moment.view, occluders_, *target_);
    const bool shown = targetSight(options_.sight)
                           .share(bentCamera(moment.view, *target_, wanted), occluders_, *target_,
                                  {options_.enlarged, options_.enlargedPixels}) >= options_.visibleShare;
    if (!shown) {
      return {ExploreNote::Kind::kProblem, "target hidden: no bend shows it"};
    }
    if (f == 0 && wanted == 0) {
      return {ExploreNote::Kind::kState, "the target is in sight: rays are straight"};
    }
    return {ExploreNote::Kind::kState, fmt::format("rays {} by {:.2f} to the {}", f == wanted ? "bend" : "swing",
                                                   std::abs(f), f > 0 || (f == 0 && wanted > 0) ? "right" : "left")};
  }

  TargetOptions options_;
  TargetTracker tracker_;
  std::optional<Box> target_;
  std::vector<Box> occluders_;
  double sightIndex_ = 0;
};

}  // namespace

LiveConstructorRow liveTarget() {
  const TargetOptions usual;
  std::vector<const char*> sights;
  for (const TargetSight& sight : targetSights()) {
    sights.push_back(sight.name);
  }
  return {"target",
          "keeps an object in sight that is clicked: rays bend around what hides it",
          "an object to keep in sight",
          {{"max_f", "Strongest bend", "", 0, 1, usual.maxF, "how far rays may bend, to either side"},
           {"max_change", "Swing", "a frame", 0.001, 0.2, kSlowChange, "how far the bend may change in a frame"},
           {"visible_share", "Enough of it", "", 0.01, 1, usual.visibleShare,
            "the share of the target's box that must be in sight"},
           {"enlarged", "Margin", "of its size", 0, 2, usual.enlarged,
            "by so much the target's box is larger on each side, in shares of its size"},
           {"enlarged_pixels", "Margin", "pixels", 0, 200, usual.enlargedPixels, "and by so many pixels of the image"},
           {"sight", "In sight by", "", 0, static_cast<double>(sights.size() - 1), 0,
            "what decides whether the target is in sight: rays to its box, or images of boxes", 1, sights}},
          true,
          [](const ExploreScene& scene) { return std::make_unique<LiveTarget>(scene); }};
}

}  // namespace ocelli
