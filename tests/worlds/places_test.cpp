// The museum, the office and the library: places for seas of images.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/place_builder.h"
#include "oc_core/worlds/place_walk.h"
#include "oc_core/worlds/placement.h"
#include "oc_core/worlds/printed_textures.h"
#include "oc_core/worlds/scene_source.h"
#include "oc_core/worlds/surface_noise.h"
#include "tests/scene/mesh_checks.h"

namespace ocelli {
namespace {

constexpr float kEye = 1.6f;
constexpr float kClearance = 0.35f;

struct Place {
  const char* name;
  size_t count;
  double inches;
};

class EveryPlace : public testing::TestWithParam<Place> {
 protected:
  static Scene built(double texel, int seed = 1) {
    return makeBuiltinScene("builtin:" + std::string(GetParam().name) + ",texel=" + std::to_string(texel) +
                            ",seed=" + std::to_string(seed));
  }
};

TEST_P(EveryPlace, IsMadeOfClosedSolids) {
  for (const Mesh& mesh : built(0.09).meshes) {
    EXPECT_TRUE(isBalanced(mesh));
    EXPECT_GT(signedVolume(mesh), 0);
  }
}

TEST_P(EveryPlace, HasTheWalkOfTheText) {
  const Scene scene = built(0.2);
  ASSERT_TRUE(scene.guides.sea);
  EXPECT_EQ(scene.guides.sea->count, GetParam().count);
  EXPECT_NEAR(scene.guides.sea->spacing, GetParam().inches * 0.0254, 1e-7);
  const std::vector<glm::vec3>& path = scene.guides.path;
  double length = 0;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    length += glm::distance(glm::dvec3(path[i]), glm::dvec3(path[i + 1]));
    EXPECT_EQ(path[i].y, kEye);
  }
  // Some hundred corners, rounded to floats of a few metres: 2.4e-7 each.
  EXPECT_NEAR(length, static_cast<double>(GetParam().count - 1) * scene.guides.sea->spacing, 1e-3);
  const std::vector<glm::vec3> positions = seaPositions(path, *scene.guides.sea);
  EXPECT_EQ(positions.size(), GetParam().count);
  size_t turns = 0;
  for (size_t i = 0; i + 1 < positions.size(); ++i) {
    const float step = glm::distance(positions[i], positions[i + 1]);
    EXPECT_LE(step, scene.guides.sea->spacing * 1.0001f);
    EXPECT_GT(step, 0.2f * scene.guides.sea->spacing) << "two in one place";
    // Corners of lanes are cut at right angles, by 1 / sqrt(2) at most; only ways to the next area turn more sharply.
    turns += step < 0.7f * scene.guides.sea->spacing ? 1 : 0;
  }
  EXPECT_LE(turns, 6u);
}

TEST_P(EveryPlace, KeepsAwayFromAllThings) {
  constexpr float kTexel = 0.04f;
  const Scene scene = built(kTexel);
  const std::vector<glm::vec3> positions = seaPositions(scene.guides.path, *scene.guides.sea);
  Box walked;
  for (const glm::vec3& p : positions) {
    walked.add(p);
  }
  // What stands in the way of a body: everything between the ankles and over the head, as vertices in a plan of cells.
  const glm::vec2 origin(walked.lower.x - 1, walked.lower.z - 1);
  constexpr float kCell = kClearance;
  const auto columns = static_cast<int>((walked.size().x + 2) / kCell) + 1;
  const auto rows = static_cast<int>((walked.size().z + 2) / kCell) + 1;
  std::vector<std::vector<glm::vec2>> cells(static_cast<size_t>(columns * rows));
  const auto cellOf = [&](const glm::vec2& p) {
    return glm::ivec2(std::floor((p.x - origin.x) / kCell), std::floor((p.y - origin.y) / kCell));
  };
  for (const Mesh& mesh : scene.meshes) {
    for (const glm::vec3& p : mesh.positions) {
      const glm::ivec2 cell = cellOf({p.x, p.z});
      if (p.y > 0.1f && p.y < 2.0f && cell.x >= 0 && cell.y >= 0 && cell.x < columns && cell.y < rows) {
        cells[static_cast<size_t>(cell.y * columns + cell.x)].emplace_back(p.x, p.z);
      }
    }
  }
  constexpr int kReach = 3;  // cells around
  float nearest = 10;
  for (const glm::vec3& position : positions) {
    const glm::vec2 p(position.x, position.z);
    const glm::ivec2 cell = cellOf(p);
    for (int j = std::max(0, cell.y - kReach); j <= std::min(rows - 1, cell.y + kReach); ++j) {
      for (int i = std::max(0, cell.x - kReach); i <= std::min(columns - 1, cell.x + kReach); ++i) {
        for (const glm::vec2& thing : cells[static_cast<size_t>(j * columns + i)]) {
          nearest = std::min(nearest, glm::distance(thing, p));
        }
      }
    }
  }
  EXPECT_GE(nearest, kClearance);
  EXPECT_LE(nearest, 1.0f) << "nothing was found: the test looks in the wrong place";
}

TEST_P(EveryPlace, IsTheSameOfASeedWithAnyNumberOfThreads) {
  setThreadCount(1);
  const Mesh one = flatten(built(0.15));
  setThreadCount(4);
  const Mesh same = flatten(built(0.15));
  setThreadCount(0);
  const Mesh other = flatten(built(0.15, 2));
  EXPECT_EQ(one.positions, same.positions);
  EXPECT_EQ(one.colors, same.colors);
  EXPECT_EQ(one.triangles, same.triangles);
  EXPECT_NE(one.colors, other.colors);
}

TEST_P(EveryPlace, IsFittedWithItsWalk) {
  const std::string source = "builtin:" + std::string(GetParam().name) + ",texel=0.2";
  const GuidedScene fitted = loadGuidedScene(source);
  const GuidedScene metres = loadGuidedScene(source, {.fit = false});
  float radius = 0;
  for (const glm::vec3& p : fitted.mesh.positions) {
    radius = std::max(radius, glm::length(p));
  }
  EXPECT_NEAR(radius, 1, 1e-5);
  EXPECT_EQ(fitted.mesh.colors.size(), fitted.mesh.positions.size());
  // No light falls on what has its light already.
  EXPECT_EQ(loadScene(source, {.fit = false, .shading = Shading::kNone}).colors.front(), metres.mesh.colors.front());
  const float scale = glm::length(glm::vec3(fitted.worldFromScene[0]));
  ASSERT_TRUE(fitted.guides.sea);
  EXPECT_NEAR(fitted.guides.sea->spacing, scale * metres.guides.sea->spacing, 1e-7);
  EXPECT_EQ(seaPositions(fitted.guides.path, *fitted.guides.sea).size(), GetParam().count);
}

TEST_P(EveryPlace, IsNeitherDarkNorOverexposed) {
  const Mesh mesh = built(0.1).meshes.front();  // walls, floors and ceilings
  glm::dvec3 sum(0);
  size_t full = 0;
  for (const glm::vec3& c : mesh.colors) {
    EXPECT_GE(std::max({c.x, c.y, c.z}), 0.02f);
    sum += c;
    full += c.x >= 0.999f && c.y >= 0.999f ? 1 : 0;
  }
  const auto count = static_cast<double>(mesh.colors.size());
  const double mean = (sum.x + sum.y + sum.z) / (3 * count);
  EXPECT_GT(mean, 0.1);
  EXPECT_LT(mean, 0.5);
  EXPECT_LT(static_cast<double>(full), 0.02 * count);
}

TEST(Office, HasMillionsOfTrianglesByDefault) {
  const size_t triangles = triangleCount(makeBuiltinScene("builtin:office"));
  EXPECT_GT(triangles, 2'000'000u);
  EXPECT_LT(triangles, 5'000'000u);
}

INSTANTIATE_TEST_SUITE_P(Places, EveryPlace,
                         testing::Values(Place{"museum", 9832, 2.2}, Place{"office", 3475, 0.7},
                                         Place{"library", 1947, 1.6}),
                         [](const auto& test) { return std::string(test.param.name); });

/// Grey values of a square of a texture, a centimetre apart.
std::vector<double> sampled(const SurfaceTexture& texture, const glm::vec2& corner, int side) {
  std::vector<double> greys;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const glm::vec3 c = texture(corner + 0.01f * glm::vec2(i, j));
      greys.push_back((c.x + c.y + c.z) / 3.0);
    }
  }
  return greys;
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double ma = meanOf(a);
  const double mb = meanOf(b);
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - ma) * (b[i] - mb);
    aa += (a[i] - ma) * (a[i] - ma);
    bb += (b[i] - mb) * (b[i] - mb);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 1;
}

/// Whether a texture looks like a photograph's: not flat, not white noise, and nowhere the same again.
std::string faultOf(const SurfaceTexture& texture) {
  constexpr int kSide = 64;
  const std::vector<double> here = sampled(texture, {0.1f, 0.1f}, kSide);
  const double mean = meanOf(here);
  double variance = 0;
  for (const double grey : here) {
    variance += (grey - mean) * (grey - mean) / static_cast<double>(here.size());
  }
  if (std::sqrt(variance) < 0.015 * mean) {
    return "flat";
  }
  // White noise has nothing in common with itself a centimetre on.
  const double beside = (correlation(here, sampled(texture, {0.11f, 0.1f}, kSide)) +
                         correlation(here, sampled(texture, {0.1f, 0.11f}, kSide))) /
                        2;
  if (beside < 0.2) {
    return "white noise";
  }
  if (beside > 0.999) {
    return "smooth";
  }
  for (int k = 1; k <= 40; ++k) {  // half a metre to 20 m away, at what tiles, planks and bricks repeat by
    for (const glm::vec2& step : {glm::vec2(0.9f, 0), glm::vec2(0, 0.9f), glm::vec2(0.5f, 0.5f), glm::vec2(0.6f, 0)}) {
      const glm::vec2 shift = step * static_cast<float>(k);
      if (correlation(here, sampled(texture, glm::vec2(0.1f) + shift, kSide)) > 0.97) {
        return "repeats";
      }
    }
  }
  return "";
}

TEST(SurfaceTextures, LookLikePhotographs) {
  const glm::vec3 color(0.4f, 0.3f, 0.2f);
  const std::vector<std::pair<const char*, SurfaceTexture>> textures{
      {"plaster", plasterTexture(color, 1)},     {"wood", woodTexture(color, 2)},
      {"upright", uprightWoodTexture(color, 3)}, {"parquet", parquetTexture(color, 4)},
      {"marble", marbleTexture(color, 5)},       {"tiles", marbleTilesTexture(color, 0.6f, 6)},
      {"carpet", carpetTexture(color, 7)},       {"ceiling", ceilingTexture(color, 8)},
      {"brick", brickTexture(color, 9)},         {"cloth", clothTexture(color, 10)},
      {"metal", metalTexture(color, 11)},        {"plastic", plasticTexture(color, 12)},
      {"leaf", leafTexture(color, 13)},          {"rug", rugTexture({2, 3}, color, {0.1f, 0.1f, 0.3f}, 14)}};
  for (const auto& [name, texture] : textures) {
    EXPECT_EQ(faultOf(texture), "") << name;
  }
}

TEST(SurfaceTextures, FaultsAreFound) {
  EXPECT_EQ(faultOf([](const glm::vec2&) { return glm::vec3(0.5f); }), "flat");
  EXPECT_EQ(faultOf([](const glm::vec2& p) {
              return glm::vec3(
                  latticeNoise(static_cast<int>(std::lround(p.x * 100)), static_cast<int>(std::lround(p.y * 100)), 1));
            }),
            "white noise");
  EXPECT_EQ(faultOf([](const glm::vec2& p) { return glm::vec3(0.5f + 0.01f * p.x); }), "flat");
  EXPECT_EQ(faultOf([](const glm::vec2& p) {
              const glm::vec2 once(p.x - 0.9f * std::floor(p.x / 0.9f), p.y - 0.9f * std::floor(p.y / 0.9f));
              return glm::vec3(0.5f + 0.3f * layeredNoise(once * 20.0f, 3, 1));
            }),
            "repeats");
}

TEST(PrintedTextures, DifferFromSeedToSeed) {
  const glm::vec2 size(0.8f, 0.8f);
  using Maker = SurfaceTexture (*)(const glm::vec2&, uint32_t);
  const std::vector<Maker> makers{paintingTexture, spineTexture,      folderTexture,   posterTexture,  paperTexture,
                                  screenTexture,   whiteboardTexture, keyboardTexture, outdoorsTexture};
  for (size_t k = 0; k < makers.size(); ++k) {
    const std::vector<double> one = sampled(makers[k](size, 100), {0.05f, 0.05f}, 70);
    EXPECT_EQ(one, sampled(makers[k](size, 100), {0.05f, 0.05f}, 70)) << k;
    EXPECT_NE(one, sampled(makers[k](size, 101), {0.05f, 0.05f}, 70)) << k;
    EXPECT_LT(correlation(one, sampled(makers[k](size, 107), {0.05f, 0.05f}, 70)), 0.98) << k;
  }
}

TEST(PlaceBuilder, EachSolidIsClosed) {
  const SurfaceTexture grey = plasterTexture(glm::vec3(0.5f), 1);
  const auto built = [](const std::function<void(PlaceBuilder&)>& add) {
    PlaceBuilder place(0.05f);
    add(place);
    return flatten(place.build());
  };
  EXPECT_TRUE(isClosed(built([&](PlaceBuilder& p) { p.addBox({1, 0.3f, 0.7f}, placedAt({1, 2, 3}, 33), grey); })));
  EXPECT_TRUE(isClosed(built([&](PlaceBuilder& p) {
    p.addBox({1, 0.3f, 0.7f}, placedAt({1, 2, 3}, 33), BoxLook(grey).plain(BoxFace::kBack).plain(BoxFace::kTop));
  })));
  EXPECT_TRUE(isClosed(built([&](PlaceBuilder& p) { p.addBall({0.3f, 0.2f, 0.1f}, placedAt({1, 2, 3}, 40), grey); })));
  EXPECT_TRUE(isClosed(built([&](PlaceBuilder& p) {
    p.addTurned({{0, 0}, {0.4f, 0.1f}, {0.2f, 0.7f}, {0, 0.8f}}, placedAt({0, 1, 0}), grey);
  })));
  EXPECT_TRUE(isClosed(built([&](PlaceBuilder& p) { p.addTube({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0.05f, grey); })));
  const Mesh wall = built([&](PlaceBuilder& p) {
    PlaceWall w;
    w.size = {3, 2};
    w.openings = {{glm::vec2(1, 0.2f), glm::vec2(2, 1.5f)}};
    w.front = w.back = w.rim = grey;
    p.addWall(w, placedAt({0, 0, 0}, 90));
  });
  EXPECT_TRUE(isClosed(wall));
  EXPECT_NEAR(signedVolume(wall), (3 * 2 - 1 * 1.3) * 0.2, 1e-4);
}

TEST(IndoorLight, FallsOffAndCastsShadows) {
  IndoorLight light;
  light.setAmbient(glm::vec3(0.2f));
  light.addLamp({{0, 3, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}, {0, -1, 0}, glm::vec3(20)});
  const glm::vec3 up(0, 1, 0);
  const float below = light.at({0, 0, 0}, up).x;
  EXPECT_GT(below, light.at({2, 0, 0}, up).x);
  EXPECT_GT(light.at({2, 0, 0}, up).x, light.at({2, 0, 0}, {1, 0, 0}).x) << "what faces away has reflected light only";
  EXPECT_NEAR(light.at({2, 0, 0}, {1, 0, 0}).x, 1.25f * (1 - std::exp(-0.2f)), 1e-6f);
  light.addOccluder({1.6f, 0.05f, 1.6f}, placedAt({0, 0.725f, 0}));
  // Its middle is in full shadow, and some reflected light is kept away too.
  EXPECT_LT(light.at({0, 0, 0}, up).x, 1.25f * (1 - std::exp(-0.2f)));
  EXPECT_GT(below, 2 * light.at({0, 0, 0}, up).x);
  const float rim = light.at({1.05f, 0, 0}, up).x;
  EXPECT_GT(rim, light.at({0, 0, 0}, up).x);
}

TEST(LaneWalk, CoversAreasInTurn) {
  const std::vector<glm::vec3> path = laneWalk({{{0, 0}, {1, 0.5f}, true}}, {31, 0.1f}, 1.5f);
  // Lanes of 1 m, 0.1 m apart: 3 m end at the end of a lane less two steps from one to the next.
  const std::vector<glm::vec3> expected{{0, 1.5f, 0},    {1, 1.5f, 0},    {1, 1.5f, 0.1f},
                                        {0, 1.5f, 0.1f}, {0, 1.5f, 0.2f}, {0.8f, 1.5f, 0.2f}};
  ASSERT_EQ(path.size(), expected.size());
  for (size_t i = 0; i < path.size(); ++i) {
    EXPECT_LT(glm::distance(path[i], expected[i]), 1e-5f) << i;
  }
}

TEST(SeaPositions, AreAsManyAndAsFarApartAsSaid) {
  const std::vector<glm::vec3> path{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}};
  const std::vector<glm::vec3> positions = seaPositions(path, {5, 0.5f});
  const std::vector<glm::vec3> expected{{0, 0, 0}, {0.5f, 0, 0}, {1, 0, 0}, {1, 0, 0.5f}, {1, 0, 1}};
  ASSERT_EQ(positions.size(), expected.size());
  for (size_t i = 0; i < positions.size(); ++i) {
    EXPECT_LT(glm::distance(positions[i], expected[i]), 1e-6f) << i;
  }
  EXPECT_THAT(
      [&] {
        seaPositions(path, {8, 0.5f});
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("of 8 positions")));
}

TEST(SceneGuides, MovedSeasKeepTheirCount) {
  SceneGuides guides;
  guides.path = {{0, 0, 0}, {2, 0, 0}};
  guides.sea = {5, 0.5f};
  const SceneGuides half = moved(guides, glm::mat4(glm::mat3(0.5f)));
  ASSERT_TRUE(half.sea);
  EXPECT_EQ(half.sea->count, 5u);
  EXPECT_FLOAT_EQ(half.sea->spacing, 0.25f);
  EXPECT_EQ(seaPositions(half.path, *half.sea).size(), 5u);
}

}  // namespace
}  // namespace ocelli
