// Images of cameras that displace no pinhole's: samples, file and mesh.
#include "oc_core/ocri/placed_image.h"

#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/camera/cylinder_camera.h"
#include "oc_core/camera/panorama_camera.h"
#include "oc_core/ocri/camera_choice.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/rasterize.h"
#include "tests/base/temporary_folder.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

constexpr float kHalf = 2;

/// The inside of a cube around the origin.
Mesh room() {
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.emplace_back((corner & 1) != 0 ? kHalf : -kHalf, (corner & 2) != 0 ? kHalf : -kHalf,
                                (corner & 4) != 0 ? kHalf : -kHalf);
    mesh.colors.emplace_back(mesh.positions.back() / (2 * kHalf) + 0.5f);
  }
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

PinholeCamera inTheRoom(int width, int height) {
  View view;
  view.eye = {0.3f, -0.2f, 0.4f};
  view.target = {0, 0, -1};
  view.fovVerticalDegrees = 90;
  return {view, width, height};
}

float distanceToWalls(const glm::vec3& p) {
  const glm::vec3 inside = kHalf - glm::abs(p);
  return std::min({std::abs(inside.x), std::abs(inside.y), std::abs(inside.z)});
}

ReferenceImage panorama() {
  const PinholeCamera reference = inTheRoom(120, 60);
  const Mesh mesh = room();
  return placedImage(PanoramaCamera(reference), mesh, RayScene(mesh), reference.view(), "panorama", true);
}

TEST(PlacedImage, samplesAreWhereRaysMeetTheScene) {
  const ReferenceImage image = panorama();
  const PanoramaCamera camera(inTheRoom(120, 60));
  ASSERT_TRUE(image.isPlaced());
  EXPECT_EQ(image.sampleCount(), image.t.size()) << "walls all around";
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec3& point = image.position(x, y);
      EXPECT_LT(distanceToWalls(point), 1e-5f);
      EXPECT_NEAR(image.t(x, y), glm::distance(point, camera.view().eye), 1e-5f);
      EXPECT_LT(glm::distance(image.direction(x, y), glm::normalize(point - camera.view().eye)), 1e-5f);
      EXPECT_LT(glm::distance(image.color(x, y), point / (2 * kHalf) + 0.5f), 1e-5f);
    }
  }
}

/// How much of what a pinhole in the room sees the mesh lacks, and how far it is from the walls anywhere.
void expectClosedRoom(const Mesh& mesh) {
  for (const glm::vec3& p : mesh.positions) {
    EXPECT_LT(distanceToWalls(p), 0.12f) << p.x << " " << p.y << " " << p.z;  // a square bridges a corner of the room
  }
  for (const glm::vec3& target : {glm::vec3(0, 0, -1), glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0.1f, 1, 0),
                                  glm::vec3(0.1f, -1, 0), glm::vec3(-1, 0.2f, 0)}) {
    View view;
    view.eye = {-0.2f, 0.1f, 0};
    view.target = view.eye + target;
    view.fovVerticalDegrees = 60;
    const FragmentImage seen = rasterize(PinholeCamera(view, 90, 60), mesh);
    const auto covered = std::count_if(seen.begin(), seen.end(), [](const Fragment& each) { return each.covered(); });
    EXPECT_EQ(static_cast<size_t>(covered), seen.size()) << target.x << " " << target.y << " " << target.z;
  }
}

// From another place in the room no hole shows: neither at the border where the image goes on at the other one, nor at
// the poles.
TEST(PlacedImage, meshOfAPanoramaIsClosed) {
  expectClosedRoom(imageMesh(panorama()));
}

TEST(PlacedImage, withoutGoingAroundThereIsASeam) {
  ReferenceImage image = panorama();
  const size_t closed = imageMesh(image).triangles.size();
  image.wrapsAround = false;
  // Two triangles a row less, and two squares a row more, of two triangles.
  const size_t rows = static_cast<size_t>(image.height());
  const size_t open = imageMesh(image).triangles.size();
  EXPECT_GE(open, closed - 2 * rows);
  EXPECT_LE(open, closed + 4 * rows);
  EXPECT_NE(open, closed);
}

TEST(PlacedImage, fileHoldsAllOfIt) {
  const test::TemporaryFolder folder;
  const ReferenceImage image = panorama();
  writeReferenceImages(folder.path() / "p.exr", {image});
  const ReferenceImages read = readReferenceImages(folder.path() / "p.exr");
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].camera, "panorama");
  EXPECT_EQ(read[0].view, image.view);
  EXPECT_TRUE(read[0].wrapsAround);
  EXPECT_TRUE(test::sameBytes(read[0].t, image.t));
  EXPECT_TRUE(test::sameBytes(read[0].color, image.color));
  EXPECT_TRUE(test::sameBytes(read[0].position, image.position));
  EXPECT_TRUE(test::sameBytes(read[0].direction, image.direction));
  EXPECT_EQ(unionMesh(read).triangles, imageMesh(image).triangles);
}

TEST(PlacedImage, emptySamplesStayEmpty) {
  Mesh mesh = test::wall(-1, 2);  // a wall in front, nothing behind
  View view;
  view.eye = {0, 0, 1};
  view.target = {0, 0, 0};
  view.fovVerticalDegrees = 60;
  const PinholeCamera reference(view, 80, 40);
  const ReferenceImage image = placedImage(PanoramaCamera(reference), mesh, RayScene(mesh), view, "panorama", true);
  EXPECT_GT(image.sampleCount(), 100u);
  EXPECT_LT(image.sampleCount(), image.t.size() / 2);
  for (const glm::vec3& p : imageMesh(image).positions) {
    EXPECT_NEAR(p.z, mesh.positions[0].z, 0.05f) << "no skin to where nothing is";
  }
}

// A step of depth in front of the eye is none of a surface, however the rays are bent before it.
TEST(PlacedImage, bentRaysTooJoinOnlyWhatBelongsTogether) {
  const GraphCamera camera = test::crossroads();
  const Mesh mesh = test::boxBeforeWall();
  const ReferenceImage image = placedImage(camera, mesh, RayScene(mesh), camera.root().view(), "graph");
  ASSERT_GT(image.sampleCount(), 500u);
  const Mesh made = imageMesh(image);
  size_t across = 0;
  for (const glm::uvec3& t : made.triangles) {
    const auto isBox = [&](uint32_t vertex) { return made.positions[vertex].z > test::kWallZ + 0.2f; };
    const bool mixed = isBox(t.x) != isBox(t.y) || isBox(t.y) != isBox(t.z);
    across += mixed ? 1 : 0;
  }
  // Along the sides of the box, where it stands near the wall, triangles may lead to it.
  EXPECT_LT(across, made.triangles.size() / 100);
}

// `--camera panorama` gives what its rays meet, however it is asked for.
TEST(PlacedImage, representationsCastTheirRays) {
  const Mesh mesh = test::boxBeforeWall();
  for (const char* name : {"panorama", "cylinder"}) {
    const CameraChoice choice = cameraChoice(name);
    const Representation made = buildRepresentation(choice, test::smallCamera(), mesh);
    ASSERT_EQ(made.images.size(), 1u) << name;
    EXPECT_EQ(made.images[0].camera, name);
    EXPECT_TRUE(made.images[0].wrapsAround) << name;
    const ReferenceImage cast = raycastReferenceImage(choice, test::smallCamera(), mesh);
    EXPECT_TRUE(test::sameBytes(cast.position, made.images[0].position)) << name;
    ConstructionReport report;
    buildReferenceImages(choice, test::smallCamera(), mesh, {}, Construction::kRaster, nullptr, &report);
    EXPECT_TRUE(report.byRays) << name;
    EXPECT_THROW(drawReferenceImage(Technique::kPoints, choice, test::smallCamera(), mesh), InputError);
  }
}

}  // namespace
}  // namespace ocelli
