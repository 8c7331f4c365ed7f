#include "oc_core/constructor/graph_operations.h"

#include <gmock/gmock.h>

#include "tests/camera/inverse_errors.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/constructor/camera_text.h"

namespace ocelli {
namespace {

using test::crossroads;
using test::smallCamera;
using test::turnAt;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

GraphCamera graphCameraOf(const std::string& text) {
  GraphCamera camera(smallCamera());
  test::readText(text, [&](JsonFields& fields) { camera = readGraphCamera(fields, smallCamera()); });
  return camera;
}

std::string operationError(const std::string& text) {
  return test::errorOfText(text, [](JsonFields& fields) { readGraphCamera(fields, smallCamera()); });
}

std::string errorOfOperations(const std::string& operations) {
  return operationError("{'operations': [" + operations + "]}");
}

std::string plane(const std::string& point, const std::string& normal) {
  return "{'point': " + point + ", 'normal': " + normal + "}";
}

std::string bend(const std::string& of, const std::string& name, double z, const std::string& more = "") {
  return "{'operation': 'bend', 'of': '" + of + "', 'into': {'name': '" + name +
         "', 'plane': " + plane("[0, 0, " + std::to_string(z) + "]", "[0, 0, -1]") + ", 'viewpoint': [0.5, 0, " +
         std::to_string(z + 5) + "]" + more + "}}";
}

const std::string kSplit =
    "{'operation': 'split', 'of': 'root', 'into': ["
    "{'name': 'left', 'plane': " +
    plane("[0, 0, 0.5]", "[-0.3, 0, -1]") +
    ", 'viewpoint': [1.5, 0, 7]},"
    "{'name': 'right', 'plane': " +
    plane("[0, 0, 0.5]", "[0.3, 0, -1]") + ", 'viewpoint': [-1.5, 0, 7]}]}";
const std::string kMerge = "{'operation': 'merge', 'of': ['left', 'right'], 'into': {'name': 'behind', 'plane': " +
                           plane("[0, 0, -1.5]", "[0, 0, -1]") + ", 'viewpoint': [0, 0, 6]}}";

std::vector<std::string> namesOf(const GraphCamera& camera) {
  std::vector<std::string> names;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    names.push_back(frustum.name);
  }
  return names;
}

void expectSame(const GraphCamera& a, const GraphCamera& b) {
  ASSERT_EQ(a.frusta().size(), b.frusta().size());
  test::Numbers numbers;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 point(numbers.between(-2, 2), numbers.between(-2, 2), numbers.between(-9, 9));
    const auto one = a.projectExactly(point);
    const auto other = b.projectExactly(point);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (one) {
      EXPECT_NEAR(one->u, other->u, 1e-9 * (1 + std::abs(one->u)));
      EXPECT_NEAR(one->v, other->v, 1e-9 * (1 + std::abs(one->v)));
      EXPECT_NEAR(one->t, other->t, 1e-9);
    }
  }
}

TEST(GraphOperations, doWhatTheCameraDoes) {
  GraphCamera expected(smallCamera());
  const auto [left, right] = expected.split(0, turnAt({0, 0, 0.5}, {-0.3, 0, -1}, {1.5, 0, 7}),
                                            turnAt({0, 0, 0.5}, {0.3, 0, -1}, {-1.5, 0, 7}), "left", "right");
  expected.merge(left, right, turnAt({0, 0, -1.5}, {0, 0, -1}, {0, 0, 6}), "behind");
  expectSame(expected, graphCameraOf("{'camera': 'graph', 'operations': [" + kSplit + ", " + kMerge + "]}"));
}

TEST(GraphOperations, mayStandInAnyOrder) {
  const GraphCamera camera = graphCameraOf("{'operations': [" + kMerge + ", " + kSplit + "]}");
  EXPECT_THAT(namesOf(camera), ElementsAre("root", "left", "right", "behind of left", "behind of right"));
}

TEST(GraphOperations, actOnBothSubFrustaOfAMerge) {
  const std::string limit = ", {'operation': 'limit', 'of': 'far', 'plane': " + plane("[0, 0, -4]", "[0, 0, -1]") + "}";
  const GraphCamera camera =
      graphCameraOf("{'operations': [" + kSplit + ", " + kMerge + ", " + bend("behind", "far", -3) + limit + "]}");
  EXPECT_THAT(namesOf(camera), ElementsAre("root", "left", "right", "behind of left", "behind of right",
                                           "far of behind of left", "far of behind of right"));
  EXPECT_EQ(camera.frusta()[5].limits.size(), 1u);
  EXPECT_EQ(camera.frusta()[6].limits.size(), 1u);
}

TEST(GraphOperations, partsAreSharesOfTheImage) {
  const GraphCamera camera = graphCameraOf(
      "{'operations': [" + bend("root", "left", 0, ", 'part': [[0, 0], [0.5, 0], [0.5, 1], [0, 1]]") + "]}");
  EXPECT_DOUBLE_EQ(camera.frusta()[1].part[2].x, smallCamera().width() / 2.0);
  EXPECT_DOUBLE_EQ(camera.frusta()[1].part[2].y, smallCamera().height());
}

TEST(GraphOperations, viewOfTheFileGoesBeforeTheUsers) {
  const GraphCamera camera = graphCameraOf("{'view': {'eye': [0, 1, 5]}, 'operations': []}");
  EXPECT_EQ(camera.root().eye(), glm::vec3(0, 1, 5));
  EXPECT_EQ(camera.width(), smallCamera().width());
  EXPECT_EQ(graphCameraOf("{'operations': []}").root().eye(), smallCamera().eye());
}

TEST(GraphOperations, filesMayAskForAShapeOfImages) {
  EXPECT_EQ(graphCameraOf("{'size': {'width': 1800, 'height': 1200}, 'operations': []}").width(),
            smallCamera().width());
  EXPECT_THAT(operationError("{'size': {'width': 1280, 'height': 720}, 'operations': []}"),
              AllOf(HasSubstr("1280x720, not 90x60"), HasSubstr("--size")));
  EXPECT_THAT(operationError("{'size': {'width': 0, 'height': 720}, 'operations': []}"), HasSubstr("\"width\""));
}

TEST(GraphOperations, textOfACameraMakesItAgain) {
  GraphCamera limited = crossroads();
  limited.limit(1, Plane::through({0, 0, -4}, {0.1, 0, -1}));
  limited.limit(0, Plane::through({0, 0, -4}, {0.1, 0, -1}));
  expectSame(limited, graphCameraOf(jsonText(limited)));
  GraphCamera twins(smallCamera());
  twins.bend(twins.bend(0, turnAt({0, 0, 1}, {0, 0, -1}, {1, 0, 5}), "twin"), turnAt({0, 0, 0}, {0, 0, -1}, {1, 0, 5}),
             "twin");
  EXPECT_THAT(namesOf(graphCameraOf(jsonText(twins))), ElementsAre("root", "twin", "twin 2"));
}

// Two frusta whose rays cross beyond the plane.
TEST(GraphOperations, overlapsAreRefusedUnlessAllowed) {
  const auto side = [](const std::string& name, const std::string& part, double x) {
    return "{'operation': 'bend', 'of': 'root', 'into': {'name': '" + name +
           "', 'plane': " + plane("[0, 0, 1]", "[0, 0, -1]") + ", 'viewpoint': [" + std::to_string(x) +
           ", 0, 5], 'part': " + part + "}}";
  };
  const std::string operations = "'operations': [" + side("left", "[[0, 0], [0.5, 0], [0.5, 1], [0, 1]]", -3) + ", " +
                                 side("right", "[[0.5, 0], [1, 0], [1, 1], [0.5, 1]]", 3) + "]}";
  const auto errorIn = [](const std::string& text, const Box& world) {
    return test::errorOfText(text, [&](JsonFields& fields) { readGraphCamera(fields, smallCamera(), world); });
  };
  const Box world{glm::vec3(-3), glm::vec3(3)};
  EXPECT_THAT(errorIn("{" + operations, world), AllOf(HasSubstr("\"left\""), HasSubstr("\"right\"")));
  EXPECT_EQ(errorIn("{'overlap': 'allowed', " + operations, world), "");
  EXPECT_EQ(errorIn("{" + operations, Box{{-3, -3, 1.5f}, {3, 3, 3}}), "") << "not where they overlap";
  EXPECT_EQ(errorIn("{" + operations, Box{}), "");
  EXPECT_THAT(errorIn("{'overlap': 'perhaps', " + operations, world), HasSubstr("refused or allowed"));
}

TEST(GraphOperations, circlesAreNamed) {
  const std::string error = errorOfOperations(bend("c", "a", 0) + "," + bend("a", "b", -1) + "," + bend("b", "c", -2) +
                                              "," + bend("c", "outside", -3));
  EXPECT_THAT(error, HasSubstr("\"c\" comes from \"b\", which comes from \"a\", which comes from \"c\""));
  EXPECT_THAT(errorOfOperations(bend("a", "a", 0)), HasSubstr("\"a\" comes from \"a\""));
}

TEST(GraphOperations, refusesWhatCannotBe) {
  EXPECT_THAT(operationError("{}"), HasSubstr("\"operations\" is missing"));
  EXPECT_THAT(operationError("{'operations': 3}"), HasSubstr("must be an array"));
  EXPECT_THAT(operationError("{'operations': [], 'wrong': 1}"), HasSubstr("\"wrong\" is unknown"));
  EXPECT_THAT(errorOfOperations("3"), AllOf(HasSubstr("operation 1"), HasSubstr("JSON object")));
  EXPECT_THAT(errorOfOperations("{'operation': 'fold'}"), HasSubstr("must be bend, split, merge or limit"));
  EXPECT_THAT(errorOfOperations(bend("nowhere", "a", 0)), HasSubstr("no frustum \"nowhere\""));
  EXPECT_THAT(errorOfOperations(bend("root", "", 0)), HasSubstr("\"name\" is empty"));
  EXPECT_THAT(errorOfOperations(bend("root", "a", 0) + "," + bend("a", "a", -1)),
              AllOf(HasSubstr("operation 2"), HasSubstr("\"a\" already")));
  EXPECT_THAT(errorOfOperations(bend("root", "root", 0)), HasSubstr("\"root\" already"));
  EXPECT_THAT(errorOfOperations(bend("root", "a", 0, ", 'part': [[0, 0], [1, 0]]")), HasSubstr("3 to 64 corners"));
  EXPECT_THAT(errorOfOperations(bend("root", "a", 0, ", 'part': [[0, 0], [1, 0], [2, 1]]")),
              AllOf(HasSubstr("corner 3"), HasSubstr("between 0 and 1")));
  EXPECT_THAT(errorOfOperations(bend("root", "a", 0, ", 'colour': 1")), HasSubstr("\"colour\" is unknown"));
  EXPECT_THAT(
      errorOfOperations("{'operation': 'limit', 'of': 'root', 'plane': " + plane("[0, 0, 0]", "[0, 0, 0]") + "}"),
      HasSubstr("has no length"));
  EXPECT_THAT(errorOfOperations("{'operation': 'merge', 'of': ['root'], 'into': {}}"), HasSubstr("array of 2 names"));
  EXPECT_THAT(errorOfOperations(kSplit + "," + kMerge + "," + bend("behind", "b", -2, ", 'part': [[0,0],[1,0],[0,1]]")),
              HasSubstr("merged from two"));
  std::string partOfSecond = kSplit;
  partOfSecond.insert(partOfSecond.rfind("}]"), ", 'part': [[0, 0], [1, 0], [1, 1]]");
  EXPECT_THAT(errorOfOperations(partOfSecond), HasSubstr("only a bend takes"));
  EXPECT_THAT(errorOfOperations(bend("root", "behind the eye", 12)),
              AllOf(HasSubstr("behind the eye"), HasSubstr("not every ray")));
}

}  // namespace
}  // namespace ocelli
