// Points as scenes: what a scan's vertices alone look like beside its mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "oc_core/base/random.h"
#include "oc_core/camera/view.h"
#include "oc_core/render/rasterize.h"
#include "oc_core/scene/point_mesh.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/shading.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"

namespace ocelli {
namespace {

struct Likeness {
  double open = 0;     ///< background within the silhouette, in parts of it
  double through = 0;  ///< something far behind the surface seen through it
  double outside = 0;  ///< points seen beside the silhouette
  double shade = 0;    ///< RMS of the differences of colour where both are seen
};

/// Of an unfitted mesh and points of its surface, in the default view.
Likeness likenessOf(Mesh mesh, std::vector<glm::vec3> positions) {
  const PointMesh points = meshOfPoints({std::move(positions), {}, {}}, {}, "test");
  const glm::mat4 unit = unitFromWorld(mesh, "test");
  Mesh drawn = points.mesh;
  for (Mesh* each : {&mesh, &drawn}) {
    transform(*each, unit);
    bakeLambert(*each);
  }
  const PinholeCamera camera(View{}, 720, 480);
  const FragmentImage surface = rasterize(camera, mesh);
  const FragmentImage cloud = rasterize(camera, drawn);
  Likeness found;
  double inside = 0;
  double both = 0;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 720; ++x) {
      const Fragment& a = surface(x, y);
      const Fragment& b = cloud(x, y);
      inside += a.covered() ? 1 : 0;
      found.open += a.covered() && !b.covered() ? 1 : 0;
      found.outside += !a.covered() && b.covered() ? 1 : 0;
      if (a.covered() && b.covered()) {
        constexpr float kFar = 0.05f;  // of the scene's radius, about 5 widths of points
        found.through += b.t > a.t + kFar ? 1 : 0;
        const float difference = colorOf(a, mesh).x - colorOf(b, drawn).x;
        found.shade += static_cast<double>(difference * difference);
        ++both;
      }
    }
  }
  found.open /= inside;
  found.through /= inside;
  found.outside /= inside;
  found.shade = std::sqrt(found.shade / both);
  return found;
}

Likeness likenessOfVertices(const Mesh& mesh) {
  return likenessOf(mesh, mesh.positions);
}

void expectAlmostClosed(const Likeness& likeness, const std::string& name) {
  SCOPED_TRACE(name);
  testing::Test::RecordProperty("open", std::to_string(likeness.open));
  testing::Test::RecordProperty("through", std::to_string(likeness.through));
  testing::Test::RecordProperty("outside", std::to_string(likeness.outside));
  testing::Test::RecordProperty("shade", std::to_string(likeness.shade));
  // What docs/files.md tells of the worst scan, and a third more for other compilers.
  EXPECT_LT(likeness.open, 0.001);
  EXPECT_LT(likeness.through, 0.005);
  EXPECT_LT(likeness.outside, 0.045);
  EXPECT_LT(likeness.shade, 0.15);
}

class Scans : public testing::TestWithParam<std::string> {};

TEST_P(Scans, LooksClosedAsPointsAlone) {
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set";
  }
  const std::string path = (std::filesystem::path(folder) / GetParam()).string();
  expectAlmostClosed(likenessOfVertices(loadScene(path, {.fit = false, .shading = Shading::kNone})), path);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Scans,
                         testing::Values("bunny.obj", "dragon.obj", "buddha.obj", "horse.obj", "armadillo.ply"),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

/// Random points have gaps of any size, which no neighbour tells of.
TEST(RandomPoints, LookClosedOnASphere) {
  Random random(5);
  std::vector<glm::vec3> points;
  while (points.size() < 50'000) {
    const glm::vec3 p(random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(-1, 1));
    if (glm::length(p) > 0.1f && glm::length(p) < 1) {
      points.push_back(glm::normalize(p));
    }
  }
  expectAlmostClosed(likenessOf(makeSphere(400), std::move(points)), "sphere");
}

}  // namespace
}  // namespace ocelli
