#include "oc_core/camera/view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/camera/pinhole_camera.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

std::string viewError(const std::string& json) {
  try {
    viewFromJsonText(json, "view.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expectRefused(const View& view) {
  EXPECT_THROW(validate(view, "view"), InputError);
  EXPECT_THROW(PinholeCamera(view, 10, 10), InputError);
}

TEST(View, emptyObjectIsTheDefaultView) {
  EXPECT_EQ(viewFromJsonText("{}", "text"), View{});
  EXPECT_EQ(View{}.eye, glm::vec3(0, 0, 10));
  EXPECT_EQ(View{}.target, glm::vec3(0, 0, 0));
}

TEST(View, jsonTextReadsBackBitForBit) {
  View view;
  view.eye = {0.1f, -1 / 3.0f, 12.7f};
  view.target = {1e-3f, 0.25f, -0.7f};
  view.up = {0.3f, 0.9f, 0.01f};
  view.fovVerticalDegrees = 100.0 / 7;
  view.zNear = 0.123f;
  view.zFar = 98765.4f;
  view.centerShift = {0.3f, -1 / 7.0f};
  EXPECT_EQ(viewFromJsonText(jsonText(view), "text"), view);
}

TEST(View, jsonTextOfTheDefaultResolvesItsFieldOfView) {
  const View back = viewFromJsonText(jsonText(View{}), "text");
  EXPECT_EQ(back.fovVerticalDegrees, View{}.resolvedFovVerticalDegrees());
  View expected;
  expected.fovVerticalDegrees = back.fovVerticalDegrees;
  EXPECT_EQ(back, expected);
}

TEST(View, readsAFileWithComments) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("view.json", "// from the left\n{\"eye\": [-4, 0, 9], \"comment\": \"left\"}");
  EXPECT_EQ(readView(path).eye, glm::vec3(-4, 0, 9));
  EXPECT_THROW(readView(folder / "missing.json"), InputError);
}

TEST(View, wrongFieldsAreNamed) {
  EXPECT_THAT(viewError(R"({"eyes": [0, 0, 10]})"), HasSubstr("\"eyes\" is unknown"));
  EXPECT_THAT(viewError(R"({"eye": [0, 0]})"), HasSubstr("\"eye\""));
  EXPECT_THAT(viewError(R"({"eye": [0, 0, "ten"]})"), HasSubstr("\"eye\""));
  EXPECT_THAT(viewError(R"({"target": [0, 0, 1e7]})"), HasSubstr("\"target\""));
  EXPECT_THAT(viewError(R"({"up": 1})"), HasSubstr("\"up\""));
  EXPECT_THAT(viewError(R"({"fov_vertical_degrees": 180})"), HasSubstr("fov_vertical_degrees"));
  EXPECT_THAT(viewError(R"({"fov_vertical_degrees": "wide"})"), HasSubstr("fov_vertical_degrees"));
  EXPECT_THAT(viewError(R"({"z_near": -1})"), HasSubstr("z_near"));
  EXPECT_THAT(viewError(R"({"center_shift": [0, 0, 0]})"), HasSubstr("an array of 2 numbers"));
  EXPECT_THAT(viewError(R"({"center_shift": [0, 11]})"), HasSubstr("center_shift"));
  EXPECT_THAT(viewError(R"([1, 2])"), HasSubstr("view.json"));
  EXPECT_THAT(viewError("{"), HasSubstr("view.json:1"));
}

TEST(View, degenerateViewsAreRefused) {
  EXPECT_THAT(viewError(R"({"eye": [1, 2, 3], "target": [1, 2, 3]})"), HasSubstr("eye"));
  EXPECT_THAT(viewError(R"({"eye": [0, 5, 0]})"), HasSubstr("up"));
  EXPECT_THAT(viewError(R"({"up": [0, 0, 0]})"), HasSubstr("up"));
  EXPECT_THAT(viewError(R"({"eye": [0, 0, 0.5]})"), HasSubstr("fov_vertical_degrees"));
  EXPECT_EQ(viewError(R"({"eye": [0, 0, 0.5], "fov_vertical_degrees": 60})"), "");
  EXPECT_THAT(viewError(R"({"fov_vertical_degrees": 179})"), HasSubstr("fov_vertical_degrees"));
  EXPECT_THAT(viewError(R"({"z_near": 5, "z_far": 5})"), HasSubstr("z_near"));
}

TEST(View, numbersThatAreNotFiniteAreRefused) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (glm::vec3 View::*vector : {&View::eye, &View::target, &View::up}) {
      View view;
      (view.*vector).x = bad;
      expectRefused(view);
    }
    View view;
    view.fovVerticalDegrees = bad;
    expectRefused(view);
    view = View{};
    view.zNear = bad;
    expectRefused(view);
    view = View{};
    view.zFar = bad;
    expectRefused(view);
    view = View{};
    view.centerShift.y = bad;
    expectRefused(view);
  }
}

// A plane that faces the view: its image moves by the shift, and keeps its size.
TEST(PinholeCamera, shearedFrustumMovesTheImageWithoutTurningIt) {
  View view;
  const PinholeCamera straight(view, 300, 200);
  view.centerShift = {0.25f, -0.5f};
  const PinholeCamera sheared(view, 300, 200);
  for (const glm::vec3& point : {glm::vec3(0, 0, 0), glm::vec3(0.5f, 0.25f, 0), glm::vec3(-0.7f, 0.1f, 3)}) {
    const std::optional<ImagePoint> a = straight.project(point);
    const std::optional<ImagePoint> b = sheared.project(point);
    ASSERT_TRUE(a && b);
    EXPECT_NEAR(b->u, a->u + 50, 1e-3);
    EXPECT_NEAR(b->v, a->v - 100, 1e-3);
    EXPECT_EQ(b->t, a->t);
    EXPECT_LT(glm::distance(*sheared.unproject(*b), point), 1e-5f);
  }
}

// The field of view's cone touches the unit sphere: sin(fov / 2) = 1 / distance. A point of the sphere on the tangent
// from the eye, straight up, is (0, sqrt(1 - 1/d^2), 1/d); its image is the middle of the top border.
TEST(View, defaultFieldOfViewJustHoldsTheUnitSphere) {
  for (const float distance : {1.5f, 10.0f, 100.0f}) {
    View view;
    view.eye = {0, 0, distance};
    EXPECT_NEAR(view.resolvedFovVerticalDegrees(), degreesFromRadians(2 * std::asin(1.0 / distance)), 1e-4);
    const PinholeCamera camera(view, 300, 200);
    const float z = 1 / distance;
    const std::optional<ImagePoint> top = camera.project({0, std::sqrt(1 - z * z), z});
    ASSERT_TRUE(top);
    EXPECT_NEAR(top->u, 150, 1e-3);
    EXPECT_NEAR(top->v, 0, 2e-3) << "coordinates of 100 units round by 4e-6, times a focal length of 1e4 pixels / 100";
  }
}

TEST(View, movedEyeMovesAlongTheViewAndKeepsTargetAndField) {
  View view;
  view.eye = {10, 0, 0};  // looks along -x: right is -z, up is y, backward is x
  const View moved = movedEye(view, {1, 2, 3});
  EXPECT_LT(glm::distance(moved.eye, glm::vec3(13, 2, -1)), 1e-6f);
  EXPECT_EQ(moved.target, view.target);
  EXPECT_EQ(moved.fovVerticalDegrees, view.resolvedFovVerticalDegrees());
}

TEST(PinholeCamera, refusesSizesThatNoImageHas) {
  for (const auto& [width, height] : {std::pair(0, 10), {10, 0}, {-1, 10}, {32769, 10}, {10, 32769}}) {
    EXPECT_THROW(PinholeCamera(View{}, width, height), InputError);
  }
  EXPECT_NO_THROW(PinholeCamera(View{}, 32768, 1));
}

TEST(PinholeCamera, focalLengthIsThatOfTheField) {
  View view;
  view.fovVerticalDegrees = 90;
  EXPECT_NEAR(PinholeCamera(view, 300, 200).focalPixels(), 100, 1e-4);
}

}  // namespace
}  // namespace ocelli
