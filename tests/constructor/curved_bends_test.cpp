#include "oc_core/constructor/curved_bends.h"

#include <gmock/gmock.h>

#include "tests/camera/inverse_errors.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/constructor/camera_text.h"

namespace ocelli {
namespace {

using test::smallCamera;
using testing::AllOf;
using testing::HasSubstr;

CurvedRayCamera cameraOf(const std::string& text) {
  CurvedRayCamera camera(smallCamera());
  test::readText(text, [&](JsonFields& fields) { camera = readCurvedRayCamera(fields, smallCamera()); });
  return camera;
}

std::string errorOf(const std::string& text) {
  return test::errorOfText(text, [](JsonFields& fields) { readCurvedRayCamera(fields, smallCamera()); });
}

TEST(CurvedBends, textOfACameraMakesItAgain) {
  const CurvedRayCamera camera = test::bendingTwice();
  const CurvedRayCamera again = cameraOf(jsonText(camera));
  ASSERT_EQ(again.bends().size(), 2u);
  test::Numbers numbers;
  for (int i = 0; i < 1000; ++i) {
    const ExactImagePoint q{numbers.between(0, 90), numbers.between(0, 60), numbers.between(1, 30)};
    const auto one = camera.unprojectExactly(q);
    const auto other = again.unprojectExactly(q);
    ASSERT_TRUE(one && other);
    EXPECT_LT(glm::distance(*one, *other), 1e-9);
  }
}

TEST(CurvedBends, withoutBendsItIsThePinhole) {
  const CurvedRayCamera camera = cameraOf("{'camera': 'curved', 'view': {'eye': [0, 0, 5]}, 'turns': []}");
  EXPECT_EQ(camera.root().eye(), glm::vec3(0, 0, 5));
  EXPECT_TRUE(camera.bends().empty());
}

TEST(CurvedBends, refusesWhatCannotBe) {
  const std::string plane = "{'point': [0, 0, 0], 'normal': [0, 0, -1]}";
  EXPECT_THAT(errorOf("{}"), HasSubstr("\"turns\" is missing"));
  EXPECT_THAT(errorOf("{'turns': [{'from': " + plane + "}]}"), AllOf(HasSubstr("turn 1"), HasSubstr("\"middle\"")));
  EXPECT_THAT(errorOf("{'turns': [{'from': 1}]}"), AllOf(HasSubstr("\"from\""), HasSubstr("JSON object")));
  EXPECT_THAT(errorOf("{'turns': [{'from': " + plane + ", 'middle': " + plane + ", 'to': " + plane +
                      ", 'viewpoint': [0, 0, 9]}]}"),
              HasSubstr("parallel"));
  const std::string to = "{'point': [5, 0, 0], 'normal': [0.1, 0, -1]}";
  const std::string middle = "{'point': [3, 0, 0], 'normal': [0.05, 0, -1]}";
  EXPECT_THAT(errorOf("{'turns': [{'from': " + plane + ", 'middle': " + middle + ", 'to': " + to +
                      ", 'viewpoint': [0, 0, 9]}]}"),
              HasSubstr("do not meet in a line"));
}

}  // namespace
}  // namespace ocelli
