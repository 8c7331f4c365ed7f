#include "oc_core/ocri/camera_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/ocri/representation.h"
#include "tests/base/temporary_folder.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::kHeight;
using test::kWidth;
using test::smallCamera;
using ::testing::HasSubstr;

CameraChoice fromJson(const std::string& json) {
  const test::TemporaryFolder folder;
  return cameraChoice(folder.write("camera.json", json));
}

std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string jsonError(const std::string& json) {
  return errorOf([&] { fromJson(json); });
}

// The recipe of camera.h: every name that the list shows is known and builds an image that says so.
TEST(CameraChoice, everyNameBuildsItsImage) {
  const Mesh mesh = test::boxBeforeWall();
  for (const CameraName& name : cameraNames()) {
    const CameraChoice choice = cameraChoice(name.name);
    EXPECT_EQ(choice.name, name.name);
    EXPECT_STRNE(name.description, "");
    const Representation made = buildRepresentation(choice, smallCamera(), mesh);
    EXPECT_EQ(made.name, name.name);
    EXPECT_EQ(made.images.empty(), !choice.hasImages()) << name.name;
    for (const ReferenceImage& image : made.images) {
      EXPECT_EQ(image.camera, name.name);
    }
    // Those that look all around see as little of the box and the wall as they are large from here.
    const bool looksAllAround = !made.images.empty() && made.images[0].wrapsAround;
    EXPECT_GT(made.sampleCount(), 10u) << name.name;
    EXPECT_GT(made.mesh.triangles.size(), looksAllAround       ? made.sampleCount()
                                          : choice.hasImages() ? static_cast<size_t>(kWidth * kHeight)
                                                               : 10u)
        << name.name;
  }
}

TEST(CameraChoice, meshesHaveNoImage) {
  for (const char* name : {"simplified", "simplified-sloppy", "geometry"}) {
    EXPECT_THAT(errorOf([&] { buildReferenceImages(cameraChoice(name), smallCamera(), test::boxBeforeWall()); }),
                HasSubstr("is a mesh and has no image"));
  }
}

TEST(CameraChoice, layersAreCountedByTheName) {
  EXPECT_EQ(cameraChoice("ldi-1").count, 1);
  EXPECT_EQ(cameraChoice("ldi-16").count, 16);
  for (const char* name : {"ldi-0", "ldi-17", "ldi-", "ldi-04", "ldi-4x"}) {
    EXPECT_THAT(errorOf([&] { cameraChoice(name); }), HasSubstr(name));
  }
}

TEST(CameraChoice, unknownNamesListTheKnownOnes) {
  const std::string error = errorOf([] { cameraChoice("fisheye"); });
  EXPECT_THAT(error, HasSubstr("fisheye"));
  for (const CameraName& name : cameraNames()) {
    EXPECT_THAT(error, HasSubstr(name.name));
  }
  EXPECT_NE(errorOf([] { cameraChoice(""); }), "");
  EXPECT_THAT(errorOf([] { cameraChoice("no_such_file.json"); }), HasSubstr("no_such_file.json"));
}

TEST(CameraChoice, cellIsTheCallersUnlessTheFileSetsIt) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(cameraChoice("ddoc").ddoc.cellSideRadii, DdocOptions{}.cellSideRadii);
  EXPECT_EQ(cameraChoice("ddoc", ViewCell{.sideRadii = 0.8f}).ddoc.cellSideRadii, 0.8f);
  EXPECT_EQ(
      cameraChoice(folder.write("plain.json", R"({"camera": "ddoc"})"), ViewCell{.sideRadii = 0.8f}).ddoc.cellSideRadii,
      0.8f);
  EXPECT_EQ(
      cameraChoice(folder.write("own.json", R"({"camera": "ddoc", "cell_side_radii": 2})"), ViewCell{.sideRadii = 0.8f})
          .ddoc.cellSideRadii,
      2.0f);
}

TEST(CameraChoice, fileSetsNameAndOptions) {
  const CameraChoice choice = fromJson(
      R"({"camera": "ddoc", "name": "gentle", "cell_side_radii": 0.8, "feedback_rounds": 3, "longest_edge_pixels": 2})");
  EXPECT_EQ(choice.name, "gentle");
  EXPECT_EQ(choice.ddoc.cellSideRadii, 0.8f);
  EXPECT_EQ(choice.ddoc.feedbackRounds, 3);
  EXPECT_EQ(choice.ddoc.subdivision.longestEdgePixels, 2);
  EXPECT_EQ(choice.ddoc.safetyFactor, DdocOptions{}.safetyFactor) << "what is not said stays";
  const CameraChoice constant = fromJson(R"({"camera": "ddoc", "constant_radius_pixels": 9})");
  EXPECT_EQ(constant.ddoc.radius, DdocOptions::Radius::kConstant);
  EXPECT_EQ(constant.ddoc.constantRadiusPixels, 9);
  EXPECT_EQ(buildReferenceImages(choice, smallCamera(), test::wall(0)).front().camera, "gentle");
}

TEST(CameraChoice, wrongFilesAreRefusedByField) {
  EXPECT_THAT(jsonError(R"({"name": "x"})"), HasSubstr("\"camera\""));
  EXPECT_THAT(jsonError(R"({"camera": "fisheye"})"), HasSubstr("fisheye"));
  EXPECT_THAT(jsonError(R"({"camera": 3})"), HasSubstr("\"camera\""));
  EXPECT_THAT(jsonError(R"({"camera": "ddoc", "cell": 3})"), HasSubstr("\"cell\" is unknown"));
  EXPECT_THAT(jsonError(R"({"camera": "ddoc", "safety_factor": 0})"), HasSubstr("\"safety_factor\""));
  EXPECT_THAT(jsonError(R"({"camera": "ddoc", "feedback_rounds": 1.5})"), HasSubstr("\"feedback_rounds\""));
  EXPECT_THAT(jsonError(R"({"camera": "di", "safety_factor": 1})"), HasSubstr("\"safety_factor\" is unknown"));
  EXPECT_THAT(jsonError(R"(["ddoc"])"), HasSubstr("camera.json"));
  EXPECT_THAT(jsonError("{\n\"camera\" \"ddoc\"}"), HasSubstr("camera.json:2"));
}

TEST(BuildReferenceImage, viewsThatShowNothingAreRefused) {
  View away;
  away.target = {0, 0, 20};
  away.fovVerticalDegrees = 20;
  for (const char* name : {"di", "ddoc"}) {
    const PinholeCamera camera(away, kWidth, kHeight);
    EXPECT_THAT(errorOf([&] { buildReferenceImages(cameraChoice(name), camera, test::boxBeforeWall()); }),
                HasSubstr("sees nothing"));
    EXPECT_THAT(errorOf([&] { raycastReferenceImage(cameraChoice(name), camera, test::boxBeforeWall()); }),
                HasSubstr("sees nothing"));
  }
}

TEST(BuildReferenceImage, viewsFromInsideAnObjectAreRefused) {
  View inside;
  inside.eye = {0, 0, 0.4f};
  inside.fovVerticalDegrees = 40;
  const PinholeCamera camera(inside, kWidth, kHeight);
  Mesh box = makeBox(glm::vec3(0.5f));
  EXPECT_THAT(errorOf([&] { buildReferenceImages(cameraChoice("di"), camera, box); }), HasSubstr("inside"));
}

// The camera with a constant radius is not among them: its map tears and folds, so its rays have several solutions or
// none (section 3.2.3).
TEST(RaycastReferenceImage, agreesWithTheRasterisedOne) {
  const Mesh mesh = test::boxBeforeWall();
  const auto different = [&](const char* name) {
    const ReferenceImage drawn = buildReferenceImages(cameraChoice(name), smallCamera(), mesh).front();
    const ReferenceImage cast = raycastReferenceImage(cameraChoice(name), smallCamera(), mesh);
    EXPECT_EQ(cast.camera, drawn.camera);
    size_t count = 0;
    for (size_t i = 0; i < drawn.t.size(); ++i) {
      // Another depth, or a place more than a fifth of a pixel away.
      count +=
          std::abs(drawn.t[i] - cast.t[i]) > 0.05f || glm::distance(drawn.displacement[i], cast.displacement[i]) > 0.2f;
    }
    return count;
  };
  EXPECT_LE(different("di"), 4u) << "rounding at silhouettes";
  EXPECT_LE(different("ddoc"), 77u) << "a pixel along the box's silhouette, where the field is steepest";
}

// The images themselves are compared in technique_matrix_test.cpp: here only that each technique is what it says.
TEST(DrawReferenceImage, techniquesDrawTheSameCamera) {
  const Mesh mesh = test::boxBeforeWall();
  for (const char* name : {"di", "rppc", "spoc", "ddoc"}) {
    const CameraChoice choice = cameraChoice(name);
    const ReferenceImage cast = drawReferenceImage(Technique::kRaycast, choice, smallCamera(), mesh);
    const ReferenceImage hybrid = drawReferenceImage(Technique::kHybrid, choice, smallCamera(), mesh);
    const ReferenceImage points = drawReferenceImage(Technique::kPoints, choice, smallCamera(), mesh);
    size_t hybridDiffers = 0;
    size_t pointsLack = 0;
    for (size_t i = 0; i < cast.t.size(); ++i) {
      hybridDiffers += std::abs(hybrid.t[i] - cast.t[i]) > 1e-3f;
      pointsLack += cast.holds(i) && !points.holds(i);
    }
    EXPECT_EQ(hybrid.camera, name);
    EXPECT_EQ(points.camera, name);
    EXPECT_LE(hybridDiffers, 2u) << name << ": rounding";
    EXPECT_EQ(pointsLack, 0u) << name;
    // Samples of a splat stand next to the centre of its pixel, those of rays in it.
    EXPECT_FALSE(test::sameBytes(points.displacement, cast.displacement)) << name;
  }
}

TEST(DrawReferenceImage, camerasThatATechniqueCannotDrawAreRefused) {
  const Mesh mesh = test::boxBeforeWall();
  for (const Technique technique : {Technique::kPoints, Technique::kHybrid}) {
    EXPECT_THAT(errorOf([&] { drawReferenceImage(technique, cameraChoice("cell"), smallCamera(), mesh); }),
                HasSubstr("--method"));
  }
}

}  // namespace
}  // namespace ocelli
