// Looks straight into the portals in view (section 4.3.1.1). A click chooses one; the same click again, all.
#include <fmt/format.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/explore/explore_picking.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

/// What shows in openings has more edges than the walls that the pinhole sees there. At the usual speed frames of the
/// walks of tests/explore/explore_jumps_test.cpp change by up to 6 % more than the pinhole's. Some of that is left
/// where the head turns by less, as there is less to compare with then.
constexpr double kPortalTurnShare = 0.8;

/// Its portals' viewpoints are that share of the way from the eye to where they stand.
GraphCamera partlyDeployed(const GraphCamera& camera, double share) {
  GraphCamera partly(camera.root());
  const glm::dvec3 eye(camera.root().eye());
  for (const int child : camera.frusta()[GraphCamera::kRoot].children) {
    const GraphCamera::Frustum& frustum = camera.frusta()[static_cast<size_t>(child)];
    partly.bend(GraphCamera::kRoot, {frustum.plane, glm::mix(eye, frustum.viewpoint, share)}, frustum.name,
                frustum.part);
  }
  return partly;
}

bool samePlace(const Portal& one, const Portal& other) {
  return one.center == other.center;
}

class LivePortal final : public LiveConstructor {
 public:
  LiveCamera camera(const LiveMoment& moment) override {
    SceneGuides guides;
    if (picked_) {
      guides.portals = {*picked_};
    } else if (moment.scene.guides().portals.empty() && moment.scene.guides().maze) {
      guides.maze = moment.scene.guides().maze;
    } else {
      guides.portals = knownPortals(moment.scene);
    }
    if (guides.portals.empty() && !guides.maze) {
      throw InputError("there are no portals here", "portal camera", "choose another constructor");
    }
    const GraphCamera made = buildPortalCamera(options(), guides, moment.view);
    LiveCamera live{moment.deployed < 1 ? partlyDeployed(made, moment.deployed) : made};
    live.notes.push_back(note(made, moment));
    return live;
  }

  bool accepts(const ExploreScene& /*scene*/, const ExplorePick& pick) const override {
    return pick.portal.has_value();
  }
  void pick(const ExploreScene& scene, const ExplorePick& pick) override {
    if (picked_ && samePlace(*picked_, *pick.portal)) {
      picked_.reset();
      return;
    }
    picked_ = pick.portal;
    leadsNowhere_ = !hasFloorBehind(scene);
  }
  double option(size_t /*index*/) const override { return curve_; }
  void setOption(size_t /*index*/, double value) override { curve_ = value; }
  std::optional<Box> picked() const override {
    if (!picked_) {
      return std::nullopt;
    }
    Box box;
    for (const glm::vec3& corner : picked_->corners()) {
      box.add(corner);
    }
    return box;
  }

 private:
  const PortalOptions& options() const { return portalCurves()[static_cast<size_t>(curve_)].options; }

  ExploreNote note(const GraphCamera& made, const LiveMoment& moment) const {
    const size_t bends = made.frusta().size() - 1;
    if (picked_) {
      if (leadsNowhere_) {
        return {ExploreNote::Kind::kProblem, "this portal leads nowhere: nothing is behind it"};
      }
      if (!(portalShare(*picked_, glm::dvec3(moment.view.eye()), options()) > 0)) {
        return {ExploreNote::Kind::kState,
                "the chosen portal is too near, too far, faced or behind: rays are straight"};
      }
    }
    if (bends == 0) {
      return {ExploreNote::Kind::kState, picked_ ? "the chosen portal is not in view" : "no portal in view to bend at"};
    }
    return {ExploreNote::Kind::kState,
            fmt::format("rays bend at {} part{} of the image", bends, bends == 1 ? "" : "s")};
  }

  /// Whether there is a surface at all in the directions that one looks to through it.
  bool hasFloorBehind(const ExploreScene& scene) const {
    const float reach = glm::length(scene.bounds().size());
    const glm::vec3 behind = picked_->center - picked_->normal * static_cast<float>(0.05 * scene.metre());
    for (const glm::vec3& tilt :
         {glm::vec3(0), picked_->halfRight, -picked_->halfRight, picked_->halfUp, -picked_->halfUp}) {
      const glm::vec3 direction =
          glm::normalize(-picked_->normal + tilt / std::max(glm::length(picked_->halfUp), 1e-20f) * 0.5f);
      if (scene.cast(behind, direction, reach)) {
        return true;
      }
    }
    return false;
  }

  std::optional<Portal> picked_;
  bool leadsNowhere_ = false;
  double curve_ = 0;  // of portalCurves()
};

}  // namespace

LiveConstructorRow livePortal() {
  std::vector<const char*> curves;
  for (const PortalCurve& curve : portalCurves()) {
    curves.push_back(curve.name);
  }
  LiveConstructorRow row{
      "portal",
      "looks straight into every opening in view, or into one that is clicked",
      "an opening to look into; the same again: all openings",
      {{"curve", "Bends", "", 0, static_cast<double>(curves.size() - 1), 0,
        "how much each opening bends rays from where", 1, curves, false}},
      true,
      [](const ExploreScene&) { return std::make_unique<LivePortal>(); },
      [](const ExploreScene& scene) { return scene.guides().portals.empty() && !scene.guides().maze; }};
  row.turnShare = kPortalTurnShare;
  return row;
}

}  // namespace ocelli
