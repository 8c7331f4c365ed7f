// A camera that was made elsewhere: of a file, or drawn by hand (section 4.3.2.1). It stands where it was put, so the
// picture dissolves from the walker's.
#include <memory>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

constexpr int kRays = 12;             // along each side of the image, that should meet something
constexpr double kMinMeeting = 0.01;  // of them
constexpr float kFarOutside = 1;      // sizes of the scene

/// What is wrong with a camera in this scene, if anything.
std::optional<std::string> problemOf(const MultiperspectiveCamera& camera, const ExploreScene& scene) {
  return std::visit(
      [&](const auto& each) -> std::optional<std::string> {
        const glm::vec3 margin = scene.bounds().size() * kFarOutside;
        const Box around{scene.bounds().lower - margin, scene.bounds().upper + margin};
        if (!contains(around, each.root().eye())) {
          return "this camera stands far outside of the scene: its file may be of another scene";
        }
        int met = 0;
        for (int i = 0; i < kRays * kRays; ++i) {
          const glm::vec2 share = (glm::vec2(i % kRays, i / kRays) + 0.5f) / static_cast<float>(kRays);
          const RayPath ray = each.rayPath(share * glm::vec2(each.width(), each.height()));
          met += ray.size() >= 2 && scene.cast(ray) ? 1 : 0;
        }
        return met < kMinMeeting * kRays * kRays
                   ? std::optional<std::string>("this camera sees nothing here: its file may be of another scene")
                   : std::nullopt;
      },
      camera);
}

class LiveDrawn final : public LiveConstructor {
 public:
  LiveCamera camera(const LiveMoment& moment) override {
    if (!camera_) {
      throw InputError("there is no camera yet", "drawn camera", "open a camera file, or draw one");
    }
    if (!checked_) {
      problem_ = problemOf(*camera_, moment.scene);
      checked_ = true;
    }
    LiveCamera live{*camera_};
    live.still = camera_;
    live.notes.push_back(problem_ ? ExploreNote{ExploreNote::Kind::kProblem, *problem_}
                                  : ExploreNote{ExploreNote::Kind::kState, name_});
    return live;
  }
  bool show(const MultiperspectiveCamera& camera, const std::string& name) override {
    camera_ = std::make_shared<const MultiperspectiveCamera>(camera);
    name_ = name;
    checked_ = false;
    return true;
  }

 private:
  std::shared_ptr<const MultiperspectiveCamera> camera_;
  std::string name_;
  bool checked_ = false;
  std::optional<std::string> problem_;
};

}  // namespace

LiveConstructorRow liveDrawn() {
  LiveConstructorRow row{"drawn", "a camera of a file, or drawn by hand, that stands where it was put", "", {},
                         false,   [](const ExploreScene&) { return std::make_unique<LiveDrawn>(); }};
  row.showsOthers = true;
  return row;
}

}  // namespace ocelli
