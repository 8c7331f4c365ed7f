// What someone sees who walks with a portal camera: how much consecutive images differ, beside the pinhole's.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "oc_core/constructor/portal_constructor.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/constructor/image_change.h"
#include "tests/constructor/image_motion.h"
#include "tests/constructor/random_walk.h"

namespace ocelli {
namespace {

constexpr int kSamples = 2;  // of a pixel, along each axis

struct Changes {
  double pinhole = 0;
  double camera = 0;
  double pinholeMotion = 0;  ///< image_motion.h
  double cameraMotion = 0;
  bool bent = false;  ///< the rays of some portal turn in one of the two frames
};

/// Frame after frame of one camera.
class Shown {
 public:
  explicit Shown(const Mesh& mesh) : mesh_(mesh), change_(kSamples) {}

  /// Change and motion from the frame before; nothing for the first.
  std::optional<std::pair<double, double>> next(const GraphCamera& camera, FragmentImage fragments) {
    const std::optional<double> change = change_.next(fragments, mesh_);
    const double motion = camera_ ? test::meanMotion(*camera_, fragments_, mesh_, camera, kSamples) : 0;
    camera_ = camera;
    fragments_ = std::move(fragments);
    return change ? std::optional(std::pair(*change, motion)) : std::nullopt;
  }

 private:
  const Mesh& mesh_;
  test::ImageChange change_;
  std::optional<GraphCamera> camera_;
  FragmentImage fragments_;
};

/// From each frame to the next.
std::vector<Changes> changesAlong(const std::vector<View>& views, const GuidedScene& scene,
                                  const PortalOptions& options = {}) {
  std::vector<Changes> changes;
  bool wasBent = false;
  Shown pinhole(scene.mesh);
  Shown camera(scene.mesh);
  const MeshBlocks blocks(scene.mesh);
  for (const View& view : views) {
    const PinholeCamera reference(view, 160 * kSamples, 90 * kSamples);
    const auto ofPinhole = pinhole.next(GraphCamera(reference), rasterize(reference, scene.mesh));
    const GraphCamera graph = buildPortalCamera(options, scene.guides, reference);
    const bool bent = graph.frusta().size() > 1;
    const auto ofCamera = camera.next(graph, rasterize(graph, scene.mesh, blocks));
    if (ofPinhole) {
      changes.push_back({ofPinhole->first, ofCamera->first, ofPinhole->second, ofCamera->second, bent || wasBent});
    }
    wasBent = bent;
  }
  return changes;
}

Changes greatest(const std::vector<Changes>& changes) {
  Changes most;
  for (const Changes& each : changes) {
    most.pinhole = std::max(most.pinhole, each.pinhole);
    most.camera = std::max(most.camera, each.camera);
    most.pinholeMotion = std::max(most.pinholeMotion, each.pinholeMotion);
    most.cameraMotion = std::max(most.cameraMotion, each.cameraMotion);
  }
  return most;
}

/// A step and a turn as at a walk, 2 m/s and 90 degrees/s at 20 frames a second.
constexpr float kStepMetres = 0.1f;
constexpr float kStepDegrees = 4.5f;

/// How many mazes; OCELLI_TEST_WALKS=100 gives those that docs/results.md tells of.
uint64_t walkCount() {
  const char* given = std::getenv("OCELLI_TEST_WALKS");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : 12;
}

TEST(PortalWalk, imagesChangeAsThePinholesDoInMazes) {
  size_t bent = 0;
  std::vector<double> ofSteps;
  std::vector<double> ofWalks;
  std::vector<double> motionOfWalks;
  double camera = 0;
  double pinhole = 0;
  for (uint64_t seed = 1; seed <= walkCount(); ++seed) {
    const GuidedScene scene = loadGuidedScene("builtin:maze,seed=" + std::to_string(seed), {.fit = false});
    Random random(seed);
    const std::vector<View> views =
        test::walkAlong(test::randomLine(*scene.guides.maze, 6, random), 0, kStepMetres, kStepDegrees);
    const std::vector<Changes> changes = changesAlong(views, scene);
    for (const Changes& each : changes) {
      ofSteps.push_back(each.camera / std::max(each.pinhole, 1e-9));
      camera += each.camera;
      bent += each.bent;
      pinhole += each.pinhole;
    }
    ofWalks.push_back(greatest(changes).camera / greatest(changes).pinhole);
    motionOfWalks.push_back(greatest(changes).cameraMotion / greatest(changes).pinholeMotion);
  }
  test::report("camera / pinhole, each of the steps", ofSteps);
  test::report("camera / pinhole, the largest step of each walk", ofWalks);
  test::report("motion, camera / pinhole, the largest step of each walk", motionOfWalks);
  std::printf("camera / pinhole, all steps together: %.3f; rays turn in %zu of them\n", camera / pinhole, bent);
  EXPECT_GT(bent, ofSteps.size() / 4);
  // The largest step of a walk is one in which the head turns. No ray moves in the scene by that (portal_sight_test),
  // so what is shown moves in the image as the pinhole's does: not 1 alone because the eye walks on meanwhile.
  EXPECT_LE(*std::max_element(motionOfWalks.begin(), motionOfWalks.end()), 1.025);
  // But the colours change by more where more is to be seen than the wall that the pinhole sees in its place.
  EXPECT_LE(*std::max_element(ofWalks.begin(), ofWalks.end()), 1.045);
  EXPECT_LE(camera / pinhole, 1.015);
}

TEST(PortalWalk, nothingJumpsInADoorway) {
  const GuidedScene scene = loadGuidedScene("builtin:town", {.fit = false});
  size_t doors = 0;
  for (const Portal& portal : scene.guides.portals) {
    if (portal.center.y - portal.halfUp.y > 0.5f || ++doors % 24 != 0) {
      continue;  // a window, or one of many doors
    }
    const auto plan = [](const glm::vec3& p) { return glm::vec2(p.x, p.z); };
    const glm::vec2 center = plan(portal.center);
    const glm::vec2 out = plan(portal.normal);
    const glm::vec2 right = plan(glm::normalize(portal.halfRight));
    // From the side of the street through the door, and in.
    const std::vector<glm::vec2> line{center + out * 2.0f + right * 2.0f, center + out * 0.8f + right * 0.2f,
                                      center - out * 0.5f, center - out * 1.8f};
    const float floor = portal.center.y - portal.halfUp.y;
    PortalOptions options;
    options.bentBeyond = 1.5;  // rays turn up to close before the door
    const auto greatestBent = [&](float stepMetres, float stepDegrees) {
      std::vector<Changes> changes =
          changesAlong(test::walkAlong(line, floor, stepMetres, stepDegrees), scene, options);
      std::erase_if(changes, [](const Changes& each) { return !each.bent; });
      EXPECT_GT(changes.size(), 10u);
      return greatest(changes);
    };
    const Changes coarse = greatestBent(0.05f, 2);
    const Changes fine = greatestBent(0.05f / 4, 0.5f);
    std::printf("door %zu: pinhole %.4f, camera %.4f; at a quarter of the steps %.4f and %.4f\n", doors, coarse.pinhole,
                coarse.camera, fine.pinhole, fine.camera);
    // An image that jumped would change as much by however small a step.
    EXPECT_LE(fine.camera, 0.6 * coarse.camera);
  }
  EXPECT_GE(doors, 24u);
}

}  // namespace
}  // namespace ocelli
