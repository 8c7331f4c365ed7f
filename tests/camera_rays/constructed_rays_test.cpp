// The cameras of all constructors leave as ray maps, and come back: their images are the same.
#include <gtest/gtest.h>

#include <set>

#include "oc_core/camera_rays/camera_rays.h"
#include "oc_core/constructor/camera_constructors.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera_rays/images_of_rays.h"

namespace ocelli::test {
namespace {

/// A camera of each constructor, in a scene and a view where its rays bend.
struct Constructed {
  std::string constructor;
  std::string camera;  ///< name or file
  std::string scene;
  std::string view;  ///< file; the default view where empty
  bool fit = true;
};

std::vector<Constructed> constructedCameras(const TemporaryFolder& folder) {
  const std::string examples = OCELLI_SOURCE_DIR "/docs/cameras/examples/";
  const std::string graph = folder.write("graph.json", R"({"camera": "graph", "operations": [
      {"operation": "split", "of": "root", "into": [
        {"name": "left", "plane": {"point": [0, 0, 0.5], "normal": [-0.3, 0, -1]}, "viewpoint": [1.5, 0, 7]},
        {"name": "right", "plane": {"point": [0, 0, 0.5], "normal": [0.3, 0, -1]}, "viewpoint": [-1.5, 0, 7]}]}]})");
  return {{"graph", graph, "builtin:boxes", ""},
          {"curved", examples + "engine_curved.json", "builtin:boxes", examples + "engine_view.json"},
          {"comprehensive", "comprehensive", "builtin:maze,rows=3,columns=3", ""},
          {"portal", examples + "portal.json", "builtin:maze", examples + "portal_maze_view.json", false},
          {"maze", examples + "maze_forward.json", "builtin:maze,file=" + examples + "street_maze.json", "", false},
          {"path", examples + "path.json", "builtin:canyon", examples + "path_view.json", false},
          {"occluder", examples + "occluder.json", "builtin:town", examples + "occluder_view.json", false},
          {"target", examples + "target.json", "builtin:boxes,count=700,floor=1", examples + "target_view.json"}};
}

TEST(ConstructedRays, everyConstructorsCameraComesBack) {
  const TemporaryFolder folder;
  std::set<std::string> tried;
  for (const Constructed& each : constructedCameras(folder)) {
    SCOPED_TRACE(each.constructor);
    const GuidedScene scene = loadGuidedScene(each.scene, {.fit = each.fit});
    const PinholeCamera reference(each.view.empty() ? View{} : readView(each.view), 120, 80);
    const MultiperspectiveCamera camera = constructCamera(each.camera, scene, reference);
    const RayScene rays(scene.mesh);
    const FragmentImage want = std::visit(
        [&](const auto& any) {
          return castRays(any.width(), any.height(), rays, [&](const glm::vec2& pixel) { return any.rayPath(pixel); });
        },
        camera);
    const RayMap map = rayMapOf(camera, each.camera, reference.view());
    EXPECT_GT(map.maxSegments(), 1u) << "its rays bend";
    expectSame(imageOf(throughAFile(map), scene.mesh), want, scene.mesh, each.constructor);
    tried.insert(each.constructor);
  }
  for (const CameraConstructor& constructor : cameraConstructors()) {
    EXPECT_TRUE(tried.contains(constructor.name)) << constructor.name;
  }
}

}  // namespace
}  // namespace ocelli::test
