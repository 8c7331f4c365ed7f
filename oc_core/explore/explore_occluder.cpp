// Looks around an object that is clicked (section 4.3.1.2). Its rays straighten where the object leaves the image or
// comes near.
#include <glm/geometric.hpp>

#include "oc_core/constructor/occluder_constructor.h"
#include "oc_core/explore/explore_boxes.h"
#include "oc_core/explore/live_constructor_rows.h"

namespace ocelli {
namespace {

constexpr double kOccluderStraightMetres = 0.4;  // to the nearest corner
constexpr double kOccluderBentMetres = 2;
constexpr double kInsideObject = 0.01;  // how far in rays part, in sizes of its box

/// Rays bend less where the object leaves the image. At the usual speed frames of the walks of
/// tests/explore/explore_jumps_test.cpp change by up to 6 % more than the pinhole's.
constexpr double kOccluderTurnShare = 0.85;

/// The triangles of an object.
Mesh meshOfObject(const ExploreScene& scene, uint32_t object) {
  Mesh mesh;
  mesh.positions = scene.mesh().positions;
  const std::vector<uint32_t>& objects = scene.scene().objectOfTriangle;
  for (size_t i = 0; i < objects.size(); ++i) {
    if (objects[i] == object) {
      mesh.triangles.push_back(scene.mesh().triangles[i]);
    }
  }
  return mesh;
}

struct ObjectAlone {
  ObjectAlone(const ExploreScene& scene, uint32_t object) : mesh(meshOfObject(scene, object)), rays(mesh) {}

  Mesh mesh;
  RayScene rays;
};

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
    options.splitDepth = surfaceDepth(moment.view);
    options.steady = true;
    live.camera = buildOccluderCamera(options, moment.scene.scene(), moment.view);
    live.notes.push_back({ExploreNote::Kind::kState, "rays run around the object"});
    return live;
  }

  bool accepts(const ExploreScene& /*scene*/, const ExplorePick& pick) const override { return pick.object > 0; }
  void pick(const ExploreScene& scene, const ExplorePick& pick) override {
    box_ = clickedBox(scene, pick);
    object_ = std::make_unique<ObjectAlone>(scene, pick.object);
  }
  std::optional<Box> picked() const override { return box_; }

  double option(size_t /*index*/) const override { return shadow_; }
  void setOption(size_t /*index*/, double value) override { shadow_ = value; }

 private:
  /// How far the object itself is, a little into it, on the level way to the middle of its box
  /// (occluder_constructor.h): its box may be larger. Nothing where that way passes through a hole of it.
  std::optional<double> surfaceDepth(const PinholeCamera& view) const {
    const glm::vec3 middle = box_->center();
    const glm::vec3 way = middle - view.eye();
    const glm::vec3 forward = glm::normalize(way - view.down() * glm::dot(view.down(), way));
    const float reach = glm::dot(forward, way);
    const glm::vec3 from = middle - forward * reach;
    const Fragment met = object_->rays.intersect(RayPath{from, middle + forward * glm::length(box_->size())});
    if (!met.covered()) {
      return std::nullopt;
    }
    const double depth = static_cast<double>(met.t) + kInsideObject * static_cast<double>(glm::length(box_->size()));
    return depth < static_cast<double>(reach) ? std::optional(depth) : std::nullopt;
  }

  std::optional<Box> box_;
  std::unique_ptr<ObjectAlone> object_;
  double shadow_ = 1;
};

}  // namespace

LiveConstructorRow liveOccluder() {
  LiveConstructorRow row{"occluder",
                         "looks around an object that is clicked",
                         "an object to look around",
                         {{"shadow", "Hidden behind it", "widths", 0.2, 10, OccluderOptions{}.shadow,
                           "the length of what stays hidden behind the object, in its widths"}},
                         true,
                         [](const ExploreScene&) { return std::make_unique<LiveOccluder>(); }};
  row.turnShare = kOccluderTurnShare;
  return row;
}

}  // namespace ocelli
