// Every camera of the registry leaves as a ray map, and comes back: its image is the same.
#include "oc_core/camera_rays/camera_rays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_constructors.h"
#include "oc_core/ocri/ray_map_kind.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/ray_map/ray_map_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera/test_ray_maps.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {
namespace {

using testing::HasSubstr;

/// What other programs get, and read.
std::shared_ptr<const RayMap> throughAFile(const RayMap& map) {
  return std::make_shared<const RayMap>(rayMapFromBytes(rayMapBytes(map), "map.exr"));
}

ReferenceImage imageOf(const std::shared_ptr<const RayMap>& map, const Mesh& mesh) {
  const PinholeCamera reference(map->notes().view.value_or(View{}), map->width(), map->height());
  return buildReferenceImages(rayMapChoice(map), reference, mesh).front();
}

/// How many samples differ: covered in one image alone, at another place, or of another colour.
struct Differences {
  size_t covered = 0;
  size_t differing = 0;
};

/// Coordinates of rays are rounded to 32 bits twice more on their way through a file, by 1e-6 each where they are 10.
/// Hits at grazing angles, of edges, and of what lies exactly between two triangles may be others.
constexpr float kPlaceRounding = 1e-4f;

Differences compare(const ReferenceImage& got, const FragmentImage& want, const Mesh& mesh) {
  Differences differences;
  for (int y = 0; y < want.height(); ++y) {
    for (int x = 0; x < want.width(); ++x) {
      const Fragment& fragment = want(x, y);
      differences.covered += fragment.covered() ? 1 : 0;
      const bool same =
          fragment.covered() == got.holds(x, y) &&
          (!fragment.covered() || (glm::distance(positionOf(fragment, mesh), got.position(x, y)) < kPlaceRounding &&
                                   std::abs(fragment.t - got.t(x, y)) < kPlaceRounding &&
                                   glm::distance(colorOf(fragment, mesh), got.color(x, y)) < 1e-3f));
      differences.differing += same ? 0 : 1;
    }
  }
  return differences;
}

/// Of the pixels of an image.
constexpr double kMaxDifferingShare = 0.002;

void expectSame(const ReferenceImage& got, const FragmentImage& want, const Mesh& mesh, const std::string& name) {
  ASSERT_EQ(got.width(), want.width()) << name;
  ASSERT_EQ(got.height(), want.height()) << name;
  const Differences differences = compare(got, want, mesh);
  EXPECT_GT(differences.covered, 20u) << name;
  EXPECT_LE(static_cast<double>(differences.differing),
            kMaxDifferingShare * static_cast<double>(want.width()) * want.height())
      << name << ": " << differences.differing << " of " << want.width() << "x" << want.height();
}

TEST(CameraRays, everyCameraThatBuildsImagesComesBack) {
  const Mesh mesh = boxBeforeWall();
  const RayScene scene(mesh);
  size_t cameras = 0;
  for (const CameraName& name : cameraNames()) {
    const CameraChoice choice = cameraChoice(name.name);
    if (!choice.hasImages()) {
      EXPECT_THROW(rayMapOf(choice, smallCamera(), mesh, 0), InputError) << name.name;
      continue;
    }
    const ReferenceImages images = buildReferenceImages(choice, smallCamera(), mesh);
    const std::vector<RayFunction> rays = cameraRays(choice, smallCamera(), mesh, images);
    ASSERT_EQ(rays.size(), images.size()) << name.name;
    for (size_t i = 0; i < rays.size(); ++i) {
      const RayMap map = rayMapOf(choice, smallCamera(), mesh, rays.size() == 1 ? 0 : static_cast<int>(i) + 1);
      EXPECT_EQ(map.notes().wrapsAround, images[i].wrapsAround) << name.name;
      const FragmentImage want = castRays(map.width(), map.height(), scene, rays[i]);
      expectSame(imageOf(throughAFile(map), mesh), want, mesh, map.notes().name);
      ++cameras;
    }
  }
  EXPECT_GT(cameras, 20u);
}

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

TEST(CameraRays, everyConstructorsCameraComesBack) {
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

TEST(CameraRays, unionsNeedTheNumberOfAnImage) {
  const Mesh mesh = boxBeforeWall();
  const auto errorOf = [&](const char* name, int image) -> std::string {
    try {
      rayMapOf(cameraChoice(name), smallCamera(), mesh, image);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(errorOf("corners-4", 0), HasSubstr("has 5 images"));
  EXPECT_EQ(errorOf("corners-4", 5), "");
  EXPECT_THAT(errorOf("corners-4", 6), HasSubstr("from 1 to 5"));
  EXPECT_THAT(errorOf("ddoc", 2), HasSubstr("has 1 image"));
  EXPECT_THAT(errorOf("geometry", 0), HasSubstr("no rays"));
}

TEST(CameraRays, thoseOfTheViewAloneNeedNoScene) {
  for (const char* name : {"di", "gpc", "panorama", "cylinder"}) {
    const CameraChoice choice = cameraChoice(name);
    EXPECT_FALSE(needsScene(choice)) << name;
    EXPECT_EQ(rayMapOf(choice, smallCamera(), Mesh{}, 0).rayCount(), static_cast<size_t>(kWidth * kHeight)) << name;
  }
  EXPECT_TRUE(needsScene(cameraChoice("ddoc")));
}

TEST(CameraRays, aMapOfAMapIsTheSame) {
  const auto map = std::make_shared<const RayMap>(fisheyeMap(40));
  const RayMap again = rayMapOf(rayMapChoice(map), PinholeCamera(View{}, 40, 40), Mesh{}, 0);
  EXPECT_EQ(again.rayCount(), map->rayCount());
  EXPECT_EQ(again.ray(20, 13).path(), map->ray(20, 13).path());
}

/// No view says where its rays begin, so an object around the eye of the reference view is none of its business.
TEST(RayMapImage, rayMapsInTheWorldHaveNoEye) {
  Mesh mesh = boxBeforeWall();
  addWall(mesh, 10.5f, 1);
  EXPECT_GT(imageOf(std::make_shared<const RayMap>(pushBroomMap({40, 30})), mesh).sampleCount(), 100u);
}

TEST(RayMapImage, aMapInTheViewIsPlacedThere) {
  RayMapNotes notes;
  notes.frame = RayFrame::kView;
  const auto lens = std::make_shared<const RayMap>(straightMap(
      {31, 31},
      [](double u, double v) { return std::pair(glm::dvec3(0), glm::dvec3((u - 15.5) / 60, (15.5 - v) / 60, -1)); }, 0,
      100, notes));
  View view;
  view.eye = {0.5f, 0, 6};
  view.target = {0.5f, 0, 0};
  view.fovVerticalDegrees = 30;
  const ReferenceImage image = buildReferenceImages(rayMapChoice(lens), PinholeCamera(view, 31, 31), wall(0)).front();
  ASSERT_TRUE(image.holds(15, 15));
  EXPECT_LT(glm::distance(image.position(15, 15), glm::vec3(0.5f, 0, 0)), 1e-5f);
  EXPECT_LT(glm::distance(image.position(21, 15), glm::vec3(1.1f, 0, 0)), 1e-5f) << "6 / 60 of the distance of 6";
  EXPECT_LT(glm::distance(image.position(15, 12), glm::vec3(0.5f, 0.3f, 0)), 1e-5f);
}

TEST(RayMapImage, otherWaysToDrawAreRefused) {
  const auto map = std::make_shared<const RayMap>(pushBroomMap({40, 30}));
  const Mesh mesh = boxBeforeWall();
  EXPECT_THROW(drawReferenceImage(Technique::kPoints, rayMapChoice(map), PinholeCamera(View{}, 40, 30), mesh),
               InputError);
  EXPECT_GT(
      drawReferenceImage(Technique::kRaycast, rayMapChoice(map), PinholeCamera(View{}, 40, 30), mesh).sampleCount(),
      100u);
}

}  // namespace
}  // namespace ocelli::test
