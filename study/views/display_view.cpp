// What an eye before a swept-screen volumetric display sees, simulated: a part of the scene ahead of the task's eye
// stands in the display, whole or as a representation holds it, and nothing hides anything (display_sim/observing). The
// eye may move about the display: a representation that was made where it rests shows gaps then, and the whole scene
// its hidden light.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "study/views/camera_field.h"
#include "study/views/image_store.h"
#include "study/views/shown_cache.h"
#include "study/views/view_registry.h"

namespace ocelli {
namespace {

constexpr double kMaxDistanceMeters = 100;
constexpr double kMaxRadiusMeters = 60;
/// So far from the display's centre, in its radii, the eye is outside of it, wherever it stands.
constexpr double kMinDistanceRadii = 1.5;
constexpr int kMinImageRows = 64;
constexpr int kMaxImageRows = 2160;
constexpr std::array kMadeAt{MadeAt::kRest, MadeAt::kEach};

class DisplayView final : public SceneView, public std::enable_shared_from_this<DisplayView> {
 public:
  explicit DisplayView(DisplayViewOptions options) : options_(std::move(options)) {}

  std::vector<TrialLayout::View> views(const Vantage& from) const override {
    std::vector<TrialLayout::View> views;
    for (const Vantage::Pane& pane : from.pinholes) {
      // They hold the view: a layout may outlive the protocol.
      const auto show = [self = shared_from_this(), camera = pane.camera, panes = from.pinholes.size()](
                            const TrialLayout& layout) { return self->show(layout, camera, panes); };
      const auto prepare = [self = shared_from_this(), camera = pane.camera](const TrialLayout& layout,
                                                                             const Progress& progress) {
        self->prepare(layout, camera, progress);
      };
      views.emplace_back(pane.place, pane.camera, show, prepare);
    }
    return views;
  }
  bool movesEye() const override { return options_.head.moves(); }
  bool reaches(const PinholeCamera& pinhole, const Box& box) const override {
    const DisplayFrame frame(pinhole, options_);
    const auto corners = cornersOf(box);
    return std::all_of(corners.begin(), corners.end(), [&](const glm::vec3& corner) {
      const glm::dvec3 p(frame.fromWorld(corner));
      return std::hypot(p.x, p.z) <= 1 && std::abs(p.y) <= options_.profile.halfHeightRadii;
    });
  }

 private:
  /// With the size of the images that are kept.
  PinholeCamera imageCamera(const PinholeCamera& pinhole) const {
    const int rows = options_.imageRows;
    if (rows == 0 || rows >= pinhole.height()) {
      return pinhole;
    }
    const double columns = static_cast<double>(pinhole.width()) * rows / pinhole.height();
    return {pinhole.view(), std::max(1, static_cast<int>(std::lround(columns))), rows};
  }
  /// Of one pose: what shown images are told apart by.
  PinholeCamera poseCamera(const PinholeCamera& pinhole, size_t pose) const {
    const DisplayFrame frame(pinhole, options_);
    View view = pinhole.view();
    view.eye = frame.toWorld(options_.head.eyeOf(pose, frame.fromWorld(pinhole.eye())));
    return {view, pinhole.width(), pinhole.height()};
  }

  std::shared_ptr<const ShownContent> show(const TrialLayout& layout, const PinholeCamera& pinhole,
                                           size_t panes) const {
    const size_t pose = options_.head.poseAt(layout.tick);
    const PinholeCamera key = options_.head.moves() ? poseCamera(pinhole, pose) : pinhole;
    return shown_.get(layout, key, panes, [&] {
      const std::shared_ptr<PoseImages> images = store_.get(options_, layout, imageCamera(pinhole));
      ShownImage image = images->at(pose, layout).at({pinhole.width(), pinhole.height()});
      for (size_t i = 0; i < layout.scene->objectCount(); ++i) {
        const Box& box = layout.scene->boxOf(i);
        image.placesOfObjects.push_back(box.center() +
                                        (i < layout.objectOffsets.size() ? layout.objectOffsets[i] : glm::vec3(0)));
      }
      return std::make_shared<const ShownContent>(std::move(image));
    });
  }

  void prepare(const TrialLayout& layout, const PinholeCamera& pinhole, const Progress& progress) const {
    const std::shared_ptr<PoseImages> images = store_.get(options_, layout, imageCamera(pinhole));
    const size_t count = options_.head.poseCount();
    for (size_t pose = 0; pose < count; ++pose) {
      images->at(pose, layout);
      report(progress, "images of the display", static_cast<double>(pose + 1) / static_cast<double>(count));
    }
    images->forgetVolumes();
    if (store_.bytes() > ImageStore::kMaxBytes) {
      throw InputError(fmt::format("the images of all trials of a condition would take more than {} MiB",
                                   ImageStore::kMaxBytes >> 20),
                       "a view of kind \"display\"",
                       "take fewer \"images\" of \"head\", fewer \"image_rows\", or fewer cases");
    }
  }

  DisplayViewOptions options_;
  mutable ImageStore store_;
  mutable ShownCache shown_;
};

/// A database holds all that its trials show: no profile stands in a file beside it.
DisplayProfile readProfileField(JsonFields& fields) {
  const nlohmann::json& value = fields.value("profile");
  if (value.is_object()) {
    return profileFromJsonText(value.dump(), fmt::format("{}, \"profile\"", fields.where()));
  }
  const std::vector<std::string>& names = builtinProfileNames();
  if (!value.is_string() || std::find(names.begin(), names.end(), value.get<std::string>()) == names.end()) {
    fields.fail("profile", fmt::format("must be one of {}, or an object with a profile", fmt::join(names, ", ")));
  }
  return loadProfile(value.get<std::string>());
}

/// Around the eye at rest, just large enough for all of its poses, in radii of the display; the usual one where the eye
/// rests.
ViewCell cellOf(const DisplayViewOptions& options) {
  ViewCell cell;
  const glm::vec3 rest(0, 0, options.distanceMeters / options.radiusMeters);
  float farthest = 0;
  for (size_t pose = 0; options.head.moves() && pose < options.head.poseCount(); ++pose) {
    const glm::vec3 by = glm::abs(options.head.eyeOf(pose, rest) - rest);
    farthest = std::max({farthest, by.x, by.y, by.z});
  }
  if (farthest > 0) {
    cell.sideRadii = 2 * farthest;
  }
  return cell;
}

std::shared_ptr<const SceneView> readDisplayView(JsonFields& fields) {
  DisplayViewOptions options{.profile = loadProfile("perspecta")};
  if (fields.has("profile")) {
    options.profile = readProfileField(fields);
  }
  options.distanceMeters = fields.number("distance_meters", 0.1, kMaxDistanceMeters, options.distanceMeters);
  options.radiusMeters = fields.number("radius_meters", 0.01, kMaxRadiusMeters, options.radiusMeters);
  const double corner = std::max(kMinDistanceRadii, std::hypot(1.0, options.profile.halfHeightRadii) + 0.01);
  if (options.distanceMeters < corner * options.radiusMeters) {
    fields.fail("distance_meters", fmt::format("is {:g}, but must be {:.2f} times \"radius_meters\", which is {:g}, so "
                                               "that the eye is outside of the display",
                                               options.distanceMeters, corner, options.radiusMeters));
  }
  if (fields.has("head")) {
    JsonFields head = fields.inner("head");
    options.head = HeadMotion::read(head, options.profile);
    head.rejectUnknown();
  }
  if (fields.has("camera")) {
    options.camera = readCameraField(fields, cellOf(options));
  }
  if (fields.has("made_at")) {
    options.madeAt = fields.choiceOf("made_at", kMadeAt);
    if (!options.camera || !options.head.moves()) {
      fields.fail("made_at",
                  "says where a \"camera\" is made for an eye that moves: there must be \"camera\" and \"head\"");
    }
  }
  if (fields.has("mean_luminance")) {
    options.meanLuminance = fields.number("mean_luminance", 0.0001, 0.5);
  }
  options.imageRows = fields.integer("image_rows", kMinImageRows, kMaxImageRows, 0);
  return std::make_shared<DisplayView>(std::move(options));
}

}  // namespace

ViewKind displayViewKind() {
  return {"display", "what an eye before a volumetric display sees, simulated", readDisplayView};
}

}  // namespace ocelli
