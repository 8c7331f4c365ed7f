#include "oc_core/miv/miv_pose.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

namespace ocelli {
namespace {

MivPose poseOf(const View& view, double unitsPerMetre = 1) {
  return mivPose(PinholeCamera(view, 32, 24), unitsPerMetre);
}

void expectRotation(const MivPose& pose, double yaw, double pitch, double roll) {
  EXPECT_NEAR(pose.rotation[0], yaw, 1e-5);  // floats of the camera's axes
  EXPECT_NEAR(pose.rotation[1], pitch, 1e-5);
  EXPECT_NEAR(pose.rotation[2], roll, 1e-5);
}

// Along -z, which is forward there: no rotation. Ten units behind the origin.
TEST(MivPose, theDefaultViewLooksForward) {
  const MivPose pose = poseOf(View{});
  expectRotation(pose, 0, 0, 0);
  EXPECT_NEAR(pose.position[0], -10, 1e-6);
  EXPECT_NEAR(pose.position[1], 0, 1e-6);
  EXPECT_NEAR(pose.position[2], 0, 1e-6);
  EXPECT_NEAR(poseOf(View{}, 4).position[0], -2.5, 1e-6);
}

// x is to the right and y up; there y is to the left and z up.
TEST(MivPose, axesAreTurned) {
  View view;
  view.eye = {3, 5, 10};
  view.target = {3, 5, 0};
  view.fovVerticalDegrees = 40;
  const MivPose pose = poseOf(view);
  EXPECT_NEAR(pose.position[1], -3, 1e-6);
  EXPECT_NEAR(pose.position[2], 5, 1e-6);
}

TEST(MivPose, yawIsToTheLeftAndPitchDown) {
  View view;
  view.fovVerticalDegrees = 40;
  view.eye = {0, 0, 0};
  view.target = {-1, 0, -1};
  expectRotation(poseOf(view), 45, 0, 0);
  view.target = {0, -1, -1};
  expectRotation(poseOf(view), 0, 45, 0);
}

// The head leans to the right: what was up is now to the right of up.
TEST(MivPose, rollLeansToTheRight) {
  View view;
  view.up = {1, 1, 0};
  expectRotation(poseOf(view), 0, 0, 45);
}

TEST(MivPose, straightDownIsAPoseToo) {
  View view;
  view.eye = {0, 5, 0};
  view.target = {0, 0, 0};
  view.up = {0, 0, -1};
  expectRotation(poseOf(view), 0, 90, 0);
}

TEST(MivPose, viewsComeBack) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(-5, 5);
  const auto vector = [&] { return glm::vec3(anywhere(random), anywhere(random), anywhere(random)); };
  for (int i = 0; i < 200; ++i) {
    View view;
    view.eye = vector();
    view.target = view.eye + vector();
    view.up = vector();
    view.fovVerticalDegrees = 50;
    const PinholeCamera camera(view, 32, 24);
    const View back = viewOfMivPose(poseOf(view, 2.5), 2.5, view);
    const PinholeCamera again(back, 32, 24);
    EXPECT_LT(glm::distance(camera.eye(), again.eye()), 1e-5f);
    EXPECT_LT(glm::distance(camera.forward(), again.forward()), 1e-4f);
    EXPECT_LT(glm::distance(camera.right(), again.right()), 1e-4f);
  }
}

}  // namespace
}  // namespace ocelli
