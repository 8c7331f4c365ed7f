// No first hit is lost, over as many rays as one has time for: OCELLI_TEST_RAYS=10000000 gives those that
// docs/results.md tells of.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "oc_core/base/parallel.h"
#include "oc_core/depth_rays/depth_image_target.h"
#include "tests/depth_rays/sampled_scenes.h"

namespace ocelli {
namespace {

size_t rayCount() {
  const char* given = std::getenv("OCELLI_TEST_RAYS");
  return given != nullptr ? static_cast<size_t>(std::strtoull(given, nullptr, 10)) : 100'000;
}

TEST(FirstHits, thePyramidFindsWhatTestingEveryTriangleFinds) {
  const Mesh mesh = test::thingsBeforeWall();
  std::vector<std::pair<std::string, std::unique_ptr<DepthImageTarget>>> targets;
  test::forEachSampledScene(mesh, PinholeCamera({}, 30, 20),
                            [&](const std::string& name, const ReferenceImages& images) {
                              targets.emplace_back(name, std::make_unique<DepthImageTarget>(images));
                            });
  const size_t rays = rayCount() / targets.size() + 1;
  for (const auto& [name, target] : targets) {
    constexpr size_t kChunks = 64;
    std::atomic<size_t> lost = 0;
    std::atomic<size_t> met = 0;
    std::atomic<size_t> beyond = 0;
    parallelChunks(rays, kChunks, [&, &hit = *target](size_t chunk, size_t begin, size_t end) {
      Random random(1000 + chunk);
      for (size_t i = begin; i < end; ++i) {
        const RayPath ray = test::randomRay(random);
        RayCost cost;
        const auto fast = hit.hit(ray, cost);
        const auto slow = hit.hitSlowly(ray);
        met += slow.has_value();
        lost +=
            fast.has_value() != slow.has_value() || (slow && (slow->element != fast->element || slow->t != fast->t));
        beyond += cost.steps() > hit.maxSteps();
      }
    });
    EXPECT_EQ(lost, 0u) << name;
    EXPECT_EQ(beyond, 0u) << name;
    EXPECT_GT(met, rays / 20) << name;
  }
}

}  // namespace
}  // namespace ocelli
