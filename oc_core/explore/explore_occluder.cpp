// Looks around an object that is clicked (section 4.3.1.2). Its rays straighten where the object leaves the image or
// comes near.
#include "oc_core/constructor/occluder_constructor.h"
#include "oc_core/explore/explore_boxes.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

constexpr double kOccluderStraightMetres = 0.4;  // to the nearest corner
constexpr double kOccluderBentMetres = 2;

class LiveOccluder final : public LiveConstructor {
 public:
  LiveCamera camera(const LiveMoment& moment) override {
    LiveCamera live{GraphCamera(moment.view)};
    if (!box_) {
      live.notes.push_back({ExploreNote::Kind::kState, "click an object to look around it"});
      return live;
    }
    const double faded = fadedByBorder(*box_, moment.view) * fadedByDepth(*box_, moment.view, moment.scene.metre(),
                                                                          kOccluderStraightMetres, kOccluderBentMetres);
    if (faded == 0) {
      live.notes.push_back({ExploreNote::Kind::kState, "the object is too near, or not in view: rays are straight"});
      return live;
    }
    OccluderOptions options;
    options.box = box_;
    options.shadow = shadow_;
    options.deployed = faded * moment.deployed;
    live.camera = buildOccluderCamera(options, moment.scene.scene(), moment.view);
    live.notes.push_back({ExploreNote::Kind::kState, "rays run around the object"});
    return live;
  }

  bool accepts(const ExploreScene& /*scene*/, const ExplorePick& pick) const override { return pick.object > 0; }
  void pick(const ExploreScene& scene, const ExplorePick& pick) override { box_ = clickedBox(scene, pick); }
  std::optional<Box> picked() const override { return box_; }

  double option(size_t /*index*/) const override { return shadow_; }
  void setOption(size_t /*index*/, double value) override { shadow_ = value; }

 private:
  std::optional<Box> box_;
  double shadow_ = 1;
};

}  // namespace

LiveConstructorRow liveOccluder() {
  return {"occluder",
          "looks around an object that is clicked",
          "an object to look around",
          {{"shadow", "Hidden behind it", "widths", 0.2, 10, OccluderOptions{}.shadow,
            "the length of what stays hidden behind the object, in its widths"}},
          true,
          [](const ExploreScene&) { return std::make_unique<LiveOccluder>(); }};
}

}  // namespace ocelli
