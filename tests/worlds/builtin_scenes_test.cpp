#include "oc_core/worlds/builtin_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <set>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/solids.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<std::string> allNames() {
  std::vector<std::string> names;
  for (const BuiltinScene& scene : listBuiltinScenes()) {
    names.push_back(scene.name);
  }
  return names;
}

bool isLarge(const std::string& name) {
  return name == "office" || name == "shop" || name == "corridor" || name == "courtyard";
}

/// A scene as these tests build it: not in its own size where that is a million triangles.
std::string sourceOf(const std::string& name) {
  return "builtin:" + name + (name == "city" ? ",size=60" : isLarge(name) ? ",texel=0.15" : "");
}

class EveryBuiltin : public testing::TestWithParam<std::string> {};

TEST_P(EveryBuiltin, IsAFittedColoredMeshInTheDefaultView) {
  const Mesh mesh = loadScene(sourceOf(GetParam()));
  ASSERT_EQ(mesh.colors.size(), mesh.positions.size());
  float radius = 0;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    radius = std::max(radius, glm::length(mesh.positions[i]));
    const glm::vec3& c = mesh.colors[i];
    EXPECT_GT(std::max({c.x, c.y, c.z}), 0.02f) << "black is invisible on the display";
    EXPECT_LE(std::max({c.x, c.y, c.z}), 1.0f);
  }
  EXPECT_NEAR(radius, 1.0f, 1e-5f);
}

TEST_P(EveryBuiltin, IsTheSameWithAnyNumberOfThreads) {
  setThreadCount(1);
  const Mesh one = loadScene(sourceOf(GetParam()));
  setThreadCount(4);
  const Mesh four = loadScene(sourceOf(GetParam()));
  setThreadCount(0);
  EXPECT_EQ(one.positions, four.positions);
  EXPECT_EQ(one.colors, four.colors);
  EXPECT_EQ(one.triangles, four.triangles);
}

TEST_P(EveryBuiltin, TakesTheEndsOfItsRanges) {
  for (const BuiltinScene& scene : listBuiltinScenes()) {
    for (const BuiltinParameter& parameter : scene.parameters) {
      if (scene.name != GetParam() || parameter.kind == BuiltinParameter::Kind::kFile) {
        continue;
      }
      const bool isFineness = parameter.name == "texel";
      const bool isSize = parameter.name == "size" || isFineness;
      const std::string base = isSize ? "builtin:" + scene.name : sourceOf(scene.name);
      const std::string source = base + "," + parameter.name + "=";
      if (!isFineness) {  // whose least and usual value make millions of triangles
        EXPECT_NO_THROW(makeBuiltinScene(source + parameter.otherwise));
        EXPECT_NO_THROW(makeBuiltinScene(source + std::to_string(parameter.least)));
      }
      for (const double beyond : {parameter.least - 1, parameter.most + 1}) {
        EXPECT_THAT([&] { makeBuiltinScene(source + std::to_string(beyond)); },
                    ThrowsMessage<InputError>(AllOf(HasSubstr("from "), HasSubstr(parameter.name))));
      }
      for (const char* bad : {"", "nan", "inf", "1e999", "0x10", " 1", "1 ", "1,5", "one", "-"}) {
        EXPECT_THROW(makeBuiltinScene(source + bad), InputError) << source << bad;
      }
    }
  }
}

/// Those that take a second or less; places_test.cpp has the others, whose parameters are those of the office.
std::vector<std::string> quickNames() {
  std::vector<std::string> names = allNames();
  std::erase_if(names, [](const std::string& name) { return name == "museum" || name == "library"; });
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryBuiltin, testing::ValuesIn(quickNames()),
                         [](const auto& test) { return test.param; });

TEST(BuiltinScenes, HaveNamesAndSummariesOfTheirOwn) {
  const std::vector<std::string> names = allNames();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_THAT(names, testing::IsSupersetOf({"teapot", "fence", "doors", "statues", "room", "boxes"}));
  for (const BuiltinScene& scene : listBuiltinScenes()) {
    EXPECT_FALSE(scene.summary.empty());
    for (const BuiltinParameter& parameter : scene.parameters) {
      EXPECT_FALSE(parameter.summary.empty()) << scene.name << " " << parameter.name;
    }
  }
}

TEST(BuiltinScenes, ErrorsListWhatIsValid) {
  EXPECT_THAT([] { makeBuiltinScene("builtin:castle"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("castle"), HasSubstr("teapot"), HasSubstr("statues"))));
  EXPECT_THROW(makeBuiltinScene("builtin:"), InputError);
  EXPECT_THROW(makeBuiltinScene("builtin:fence,"), InputError);
  EXPECT_THAT([] { makeBuiltinScene("builtin:fence,gop=1"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("'gop'"), HasSubstr("gap, pickets"))));
  EXPECT_THAT([] { makeBuiltinScene("builtin:fence,gap"); }, ThrowsMessage<InputError>(HasSubstr("key=value")));
  EXPECT_THAT([] { makeBuiltinScene("builtin:fence,gap=1,gap=2"); }, ThrowsMessage<InputError>(HasSubstr("twice")));
  EXPECT_THAT([] { makeBuiltinScene("builtin:boxes,count=2.5"); },
              ThrowsMessage<InputError>(HasSubstr("whole number")));
}

TEST(BuiltinScenes, MeshErrorNamesBothPlaces) {
  const TemporaryFolder folder;
  const char* before = std::getenv("OCELLI_DATA_DIR");
  const std::string saved = before != nullptr ? before : "";
  setenv("OCELLI_DATA_DIR", folder.path().c_str(), 1);
  EXPECT_THAT(
      [] { makeBuiltinScene("builtin:room,mesh=none.ply"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("none.ply: there"), HasSubstr((folder.path() / "none.ply").string()))));
  writePly(folder.path() / "box.ply", makeBox(glm::vec3(1)));
  EXPECT_NO_THROW(makeBuiltinScene("builtin:room,mesh=box.ply"));
  unsetenv("OCELLI_DATA_DIR");
  EXPECT_THAT([] { makeBuiltinScene("builtin:room,mesh=box.ply"); },
              ThrowsMessage<InputError>(HasSubstr("OCELLI_DATA_DIR")));
  EXPECT_NO_THROW(makeBuiltinScene("builtin:room,mesh=" + (folder.path() / "box.ply").string()));
  if (before != nullptr) {
    setenv("OCELLI_DATA_DIR", saved.c_str(), 1);
  }
}

TEST(Fence, GapsArePixelsOfTheDefaultView) {
  for (const double gap : {1.0, 4.0}) {
    const std::string source = "builtin:fence,pickets=5,gap=" + std::to_string(gap);
    const Scene scene = makeBuiltinScene(source);
    // Five copies of the picket stand between the wall and the two rails.
    ASSERT_EQ(scene.instances.size(), 1u + 5u + 2u);
    const Mesh& picket = scene.meshes[1];
    const Box box = boundsOf(picket);
    const double step = scene.instances[2].worldFromMesh[3].x - scene.instances[1].worldFromMesh[3].x;
    const Mesh fitted = loadScene(source, {.shading = Shading::kNone});
    const double scale = boundsOf(fitted).size().x / boundsOf(flatten(scene)).size().x;
    EXPECT_NEAR(scale, 1.0, 1e-6);
    // u = f x / z, with f the focal length of a view that just holds the unit sphere from 10 away.
    const double focal = 240 / std::tan(std::asin(0.1));
    const double pixels = focal * (step - box.size().x) / (kDefaultEyeDistance - box.upper.z);
    EXPECT_NEAR(pixels, gap, 1e-3);  // positions are floats of about 1: 6e-8 * focal 2388 = 1.4e-4 pixels each
  }
}

TEST(Fence, SaysWhereItDoesNotFit) {
  EXPECT_THAT([] { makeBuiltinScene("builtin:fence,pickets=200,gap=50"); },
              ThrowsMessage<InputError>(HasSubstr("wider than the fence")));
}

TEST(Boxes, StandApartAndFollowTheSeed) {
  const Scene scene = makeBuiltinScene("builtin:boxes,count=300,seed=7");
  ASSERT_EQ(scene.instances.size(), 300u);
  const auto center = [&](size_t i) { return glm::vec3(scene.instances[i].worldFromMesh[3]); };
  const auto reach = [&](size_t i) { return glm::length(glm::mat3(scene.instances[i].worldFromMesh) * glm::vec3(1)); };
  for (size_t i = 0; i < 300; ++i) {
    EXPECT_LE(glm::length(center(i)) + reach(i), 1.0f + 1e-6f);
    for (size_t j = 0; j < i; ++j) {
      EXPECT_GE(glm::distance(center(i), center(j)) + 1e-6f, reach(i) + reach(j));
    }
  }
  EXPECT_EQ(flatten(scene).positions, flatten(makeBuiltinScene("builtin:boxes,count=300,seed=7")).positions);
  EXPECT_NE(flatten(scene).positions, flatten(makeBuiltinScene("builtin:boxes,count=300,seed=8")).positions);
}

TEST(Solids, AreClosed) {
  for (const char* name : {"sphere", "torus", "box", "boxes,count=20"}) {
    EXPECT_TRUE(isClosed(loadScene(std::string("builtin:") + name))) << name;
  }
}

TEST(Statues, HasAboutAsManyTrianglesAsAsked) {
  for (const size_t triangles : {200'000u, 500'000u}) {
    const Mesh mesh = loadScene("builtin:statues,triangles=" + std::to_string(triangles));
    // Each of the four copies may end one split of an edge, two triangles, from its share.
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), static_cast<double>(triangles), 8);
  }
}

TEST(Statues, OfTheBuddhaInSeconds) {
  if (std::getenv("OCELLI_DATA_DIR") == nullptr) {
    GTEST_SKIP() << "OCELLI_DATA_DIR is not set";
  }
  const Mesh mesh = loadScene("builtin:statues,mesh=buddha.obj");
  EXPECT_EQ(triangleCount(makeBuiltinScene("builtin:statues,mesh=buddha.obj")), mesh.triangles.size());
  EXPECT_GT(mesh.triangles.size(), 400'000u);
}

}  // namespace
}  // namespace ocelli
