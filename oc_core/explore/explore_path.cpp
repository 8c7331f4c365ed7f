// Travels along the path of the scene and shows what is behind its next turns (section 4.3.1.5).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/constructor/path_constructor.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

constexpr int kPathPlaces = 400;  // tried along the path, for that which is nearest
constexpr double kMaxPreview = 0.6;

double lengthOf(const std::vector<glm::vec3>& path) {
  double length = 0;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    length += static_cast<double>(glm::distance(path[i], path[i + 1]));
  }
  return length;
}

class LivePath final : public LiveConstructor {
 public:
  explicit LivePath(const ExploreScene& scene) : length_(lengthOf(scene.guides().path)) {}

  LiveCamera camera(const LiveMoment& moment) override {
    PathOptions options = options_;
    options.deployed = moment.deployed;
    LiveCamera live{buildPathCamera(options, moment.scene.guides(), moment.view)};
    live.notes.push_back(
        {ExploreNote::Kind::kState,
         fmt::format("{:.0f} of {:.0f} m along the path, the next {:.0f} m in view",
                     options_.position * length_ / moment.scene.metre(), length_ / moment.scene.metre(),
                     options_.preview * length_ / moment.scene.metre())});
    return live;
  }

  /// Where the walker is nearest to the path.
  std::optional<WalkerView> wantedView(const LiveMoment& moment) override {
    if (!(length_ > 0)) {
      return std::nullopt;  // camera() says so
    }
    double nearest = 1e300;
    PathOptions best = options_;
    for (int i = 0; i <= kPathPlaces; ++i) {
      PathOptions tried = options_;
      tried.position = static_cast<double>(i) / kPathPlaces;
      const double distance =
          glm::distance(glm::dvec3(pathPinhole(tried, moment.scene.guides(), moment.view).eye()), moment.walker.eye);
      if (distance < nearest) {
        nearest = distance;
        best = tried;
      }
    }
    options_ = best;
    return viewAt(moment);
  }

  std::optional<WalkerView> lead(const LiveMoment& moment, const WalkInput& input) override {
    if (!(length_ > 0)) {
      return std::nullopt;
    }
    const double speed = moment.walkerOptions.speed * (input.fast ? moment.walkerOptions.fastFactor : 1);
    const double way = speed * moment.scene.metre() * input.forward * moment.seconds;
    options_.position = std::clamp(options_.position + way / length_, 0.0, 1.0);
    return viewAt(moment);
  }

  double option(size_t index) const override {
    return index == 0 ? options_.preview : index == 1 ? options_.turns : options_.eyeHeight;
  }
  void setOption(size_t index, double value) override {
    if (index == 0) {
      options_.preview = value;
    } else if (index == 1) {
      options_.turns = static_cast<int>(value);
    } else {
      options_.eyeHeight = value;
    }
  }

 private:
  WalkerView viewAt(const LiveMoment& moment) const {
    const PinholeCamera camera = pathPinhole(options_, moment.scene.guides(), moment.view);
    const glm::dvec3 forward(camera.forward());
    return {glm::dvec3(camera.eye()), headingDegreesOf(forward, moment.walker.headingDegrees),
            degreesFromRadians(std::asin(std::clamp(forward.y, -1.0, 1.0)))};
  }

  PathOptions options_;
  double length_;
};

}  // namespace

LiveConstructorRow livePath() {
  const PathOptions usual;
  return {
      "path",
      "travels along the scene's path, and shows what is behind its next turns",
      "",
      {{"preview", "Preview", "of the path", 0.01, kMaxPreview, usual.preview, "how far ahead rays follow the path"},
       {"turns",
        "Turns",
        "",
        1,
        8,
        static_cast<double>(usual.turns),
        "how many turns rays make in the preview",
        1,
        {},
        false},
       {"eye_height", "Eye over the path", "units", -20, 20, usual.eyeHeight, "over the path, in units of the scene"}},
      true,
      [](const ExploreScene& scene) { return std::make_unique<LivePath>(scene); }};
}

}  // namespace ocelli
