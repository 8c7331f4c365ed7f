// Points as scenes: what a scan's vertices alone look like beside its mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>

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

/// Of an unfitted mesh and its vertices as points, in the default view.
Likeness likenessOfPoints(Mesh mesh) {
  const PointMesh points = meshOfPoints({mesh.positions, {}, {}}, {}, "test");
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

class Scan : public testing::TestWithParam<std::string> {};

TEST_P(Scan, LooksClosedAsPointsAlone) {
  const char* folder = std::getenv("OCELLI_DATA_DIR");
  if (folder == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set";
  }
  const Likeness likeness = likenessOfPoints(
      loadScene((std::filesystem::path(folder) / GetParam()).string(), {.fit = false, .shading = Shading::kNone}));
  std::printf("%s open %.5f through %.5f outside %.5f shade %.4f\n", GetParam().c_str(), likeness.open,
              likeness.through, likeness.outside, likeness.shade);
  // Measured: see docs/files.md.
  EXPECT_LT(likeness.open, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Scan,
                         testing::Values("bunny.obj", "dragon.obj", "buddha.obj", "horse.obj", "armadillo.ply"),
                         [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

}  // namespace
}  // namespace ocelli
