// Reference images of packed scenes against those of the scene itself, for every representation that there is.
#include "oc_core/ocri/packed_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <optional>
#include <random>

#include "oc_core/base/error.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/view_cut.h"
#include "oc_core/worlds/solids.h"
#include "tests/base/temporary_folder.h"
#include "tests/ocri/seen_by_reference.h"
#include "tests/pack/packed_meshes.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr int kWidth = 180;
constexpr int kHeight = 120;
/// Far below every error that a level has, so that the scene's own triangles are taken.
constexpr float kNoError = 1e-6f;

/// Numbers that are the same in each run.
class Numbers {
 public:
  float between(float least, float most) {
    return least + (most - least) * static_cast<float>(random_() >> 8U) / static_cast<float>(1U << 24U);
  }
  /// No vertex has its neighbour's colour, so that every level of detail has an error.
  void paint(Mesh& mesh) {
    mesh.colors.resize(mesh.positions.size());
    for (glm::vec3& color : mesh.colors) {
      color = {between(0.2f, 0.8f), between(0.2f, 0.8f), between(0.2f, 0.8f)};
    }
  }

 private:
  std::mt19937 random_{5};
};

/// A ball with bumps of `segments` around its axis.
Mesh bumpyBall(int segments) {
  Mesh ball = makeSphere(segments);
  for (glm::vec3& n : ball.positions) {
    n *= 0.9f + 0.05f * std::sin(9 * n.x) * std::sin(7 * n.y) * std::cos(8 * n.z);
  }
  return ball;
}

/// Balls everywhere in the frustum of the default view and well beside it. Some stand near the eye and reach only a few
/// pixels into the image, all along its border: what they hide lies outside of it, within reach of cameras that look
/// around them.
Mesh ballsBesideTheFrustum(int detail = 1) {
  Numbers numbers;
  Mesh scene;
  Mesh ball = bumpyBall(32 * detail);
  const auto add = [&](const glm::vec3& at, float radius) {
    numbers.paint(ball);
    append(scene, ball, glm::scale(glm::translate(glm::mat4(1), at), glm::vec3(radius)));
  };
  for (int i = 0; i < 40; ++i) {
    add({numbers.between(-4, 4), numbers.between(-3, 3), numbers.between(-2.5f, 0.5f)}, numbers.between(0.05f, 0.3f));
  }
  constexpr float kZ = 1.5f;
  const float border = std::tan(std::asin(0.1f)) * (10 - kZ);
  constexpr float kRadius = 0.15f;
  for (float along = -1; along <= 1; along += 0.25f) {
    for (const float side : {-1.0f, 1.0f}) {
      const float inside = numbers.between(-0.02f, 0.06f);
      add({side * (1.5f * border + 0.9f * kRadius - inside), along * border, kZ}, kRadius);
      add({along * 1.5f * border, side * (border + 0.9f * kRadius - inside), kZ}, kRadius);
    }
  }
  return scene;
}

/// The same before a wall that fills the image.
Mesh ballsBeforeAWall(int detail = 1) {
  Mesh scene = ballsBesideTheFrustum(detail);
  const int columns = 200 * detail;
  const int rows = 150 * detail;
  Mesh wall;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const float x = 10.0f * static_cast<float>(column) / static_cast<float>(columns) - 5;
      const float y = 8.0f * static_cast<float>(row) / static_cast<float>(rows) - 4;
      wall.positions.emplace_back(x, y, -3 + 0.1f * std::sin(5 * x) * std::cos(4 * y));
      if (row < rows && column < columns) {
        const auto at = static_cast<uint32_t>(row * (columns + 1) + column);
        wall.triangles.emplace_back(at, at + 1, at + columns + 2);
        wall.triangles.emplace_back(at, at + columns + 2, at + columns + 1);
      }
    }
  }
  Numbers().paint(wall);
  append(scene, wall, glm::mat4(1));
  return scene;
}

struct PackedMesh {
  explicit PackedMesh(Mesh made) : mesh(std::move(made)), scene(test::packed(mesh, folder / "scene.opack")) {}

  TemporaryFolder folder;
  Mesh mesh;
  PackedScene scene;
};
/// Made once for all tests of this file.
const PackedMesh& ballsAndWall() {
  static const PackedMesh made(ballsBeforeAWall());
  return made;
}
const PackedMesh& ballsAndSky() {
  static const PackedMesh made(ballsBesideTheFrustum());
  return made;
}

/// The same with triangles so small that a quarter of a pixel allows coarser ones.
const PackedMesh& fineBallsAndWall() {
  static const PackedMesh made(ballsBeforeAWall(2));
  return made;
}

PinholeCamera defaultView() {
  return {View{}, kWidth, kHeight};
}

/// From nearer by, and from aside.
PinholeCamera nearView() {
  View view;
  view.eye = {2.5f, 1, 5};
  view.target = {0.3f, 0.2f, 0};
  view.fovVerticalDegrees = 25;
  return {view, kWidth, kHeight};
}

std::vector<CameraChoice> everyChoice() {
  std::vector<CameraChoice> choices;
  for (const CameraName& name : cameraNames()) {
    choices.push_back(cameraChoice(name.name));
  }
  return choices;
}

std::optional<ViewedPart> viewedPart(const CameraChoice& choice, const PinholeCamera& view) {
  return choice.kind->viewed ? choice.kind->viewed(choice, view) : std::nullopt;
}

std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Where the samples of a general pinhole bend, both triangles at an edge draw the pixels on it (rasterize_gpc.h):
/// which of them shows depends on their order. Their samples are a chord apart at most, and so are nearly the same.
bool isOfANeighbour(const ReferenceImage& a, const ReferenceImage& b, size_t i) {
  constexpr float kChordPixels = 1.0f / 64;
  constexpr float kNearColor = 0.01f;  // of the random colours of these scenes, a chord apart
  const glm::vec3 color = glm::abs(a.color[i] - b.color[i]);
  return a.camera == "gpc" && a.holds(i) && b.holds(i) && std::abs(a.t[i] - b.t[i]) <= 1e-6f * a.t[i] &&
         glm::distance(a.displacement[i], b.displacement[i]) <= kChordPixels &&
         std::max({color.r, color.g, color.b}) <= kNearColor;
}

/// Samples that are not bit by bit the same; all of them where the images have other sizes. Of colours, those that
/// differ by more than a step of 1/65535: a packed scene rounds them to such steps.
size_t otherSamples(const ReferenceImages& wanted, const ReferenceImages& got) {
  size_t others = wanted.size() == got.size() ? 0 : 1;
  for (size_t k = 0; k < std::min(wanted.size(), got.size()); ++k) {
    const ReferenceImage& a = wanted[k];
    const ReferenceImage& b = got[k];
    if (a.width() != b.width() || a.height() != b.height()) {
      others += a.t.size();
      continue;
    }
    for (size_t i = 0; i < a.t.size(); ++i) {
      bool isSame = a.holds(i) == b.holds(i);
      if (isSame && a.holds(i)) {
        const glm::vec3 color = glm::abs(a.color[i] - b.color[i]);
        isSame = a.t[i] == b.t[i] && std::max({color.r, color.g, color.b}) <= 1.0f / 65535 &&
                 (a.isPlaced() ? a.position[i] == b.position[i] : a.displacement[i] == b.displacement[i]);
      }
      others += isSame || isOfANeighbour(a, b, i) ? 0 : 1;
    }
  }
  return others;
}

bool hasAllTriangles(const Mesh& mesh, const Mesh& of) {
  const auto some = test::trianglesOf(mesh);
  const auto all = test::trianglesOf(of);
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// Where no error is allowed, images hold the same samples bit by bit: the triangles are the scene's own, each pixel
/// has one of them whatever their order, and what is left out would be in no image.
TEST(PackedView, WithoutErrorEveryRepresentationIsThatOfTheScene) {
  struct Case {
    const PackedMesh& made;
    PinholeCamera view;
  };
  for (const auto& [made, view] :
       {Case{ballsAndWall(), defaultView()}, Case{ballsAndWall(), nearView()}, Case{ballsAndSky(), defaultView()}}) {
    for (const CameraChoice& choice : everyChoice()) {
      const Mesh viewed = meshForView(made.scene, choice, view, kNoError);
      EXPECT_TRUE(hasAllTriangles(viewed, made.mesh)) << choice.name;
      if (!viewedPart(choice, view)) {
        EXPECT_EQ(viewed.triangles.size(), made.mesh.triangles.size()) << choice.name;
      }
      if (choice.hasImages()) {
        const ReferenceImages wanted = buildReferenceImages(choice, view, made.mesh);
        EXPECT_GT(test::samplesOf(wanted), 50U) << choice.name;
        EXPECT_EQ(otherSamples(wanted, buildReferenceImages(choice, view, viewed)), 0U) << choice.name;
      }
    }
  }
}

/// That the test above can fail: these images are made of what lies in the frustum alone.
TEST(PackedView, WhatLiesBesideTheFrustumIsNeeded) {
  const PinholeCamera view = defaultView();
  const PackedScene& scene = ballsAndWall().scene;
  const Mesh narrow = meshOf(scene, viewCut(scene, view, {.maxErrorPixels = kNoError}));
  for (const CameraChoice& choice : everyChoice()) {
    const std::optional<ViewedPart> part = viewedPart(choice, view);
    if (part && (part->reach > 0 || part->marginPixels > 0)) {
      EXPECT_GT(otherSamples(buildReferenceImages(choice, view, ballsAndWall().mesh),
                             buildReferenceImages(choice, view, narrow)),
                50U)
          << choice.name;
    }
  }
}

/// Whether the pinhole of `view` sees the point, wherever within `reach` its eye is and with that margin around it.
bool isViewed(const ViewedPart& part, const PinholeCamera& view, const glm::vec3& point) {
  const glm::vec3 p = view.cameraFromWorld(point);
  const float f = view.focalPixels();
  const float halfWidth = static_cast<float>(view.width()) / 2 + part.marginPixels;
  const float halfHeight = static_cast<float>(view.height()) / 2 + part.marginPixels;
  // The sides of the frustum, moved outwards by the reach; a thousandth of a pixel is rounding.
  constexpr float kRounding = 1e-3f;
  const auto within = [&](float x, float half) {
    return f * std::abs(x) - half * p.z <= part.reach * std::hypot(f, half) + kRounding * p.z;
  };
  return within(p.x, halfWidth) && within(p.y, halfHeight);
}

/// No sample of the scene's own images lies outside of what a packed scene would deliver, not even by less than a
/// cluster is large. That part is convex and holds all viewpoints, so what may hide such a sample is in it, too.
TEST(PackedView, EverySampleLiesInWhatIsViewed) {
  for (const PinholeCamera& view : {defaultView(), nearView()}) {
    for (const CameraChoice& choice : everyChoice()) {
      const std::optional<ViewedPart> part = viewedPart(choice, view);
      if (!part) {
        continue;
      }
      size_t outside = 0;
      for (const ReferenceImage& image : buildReferenceImages(choice, view, ballsAndWall().mesh)) {
        const PinholeCamera own = image.reference();
        for (int y = 0; y < image.height(); ++y) {
          for (int x = 0; x < image.width(); ++x) {
            const std::optional<glm::vec3> point = image.pointOf(x, y, own);
            outside += point && !isViewed(*part, view, *point) ? 1 : 0;
          }
        }
      }
      EXPECT_EQ(outside, 0U) << choice.name << ": reach " << part->reach << ", margin " << part->marginPixels;
    }
  }
}

TEST(PackedView, ClustersOutOfReachAreLeftOut) {
  View narrow = nearView().view();
  narrow.fovVerticalDegrees = 6;
  const PinholeCamera view(narrow, 60, 40);
  // The largest sphere of a cluster of the scene.
  float largest = 0;
  const PackedScene& scene = ballsAndWall().scene;
  for (const ClusterChoice& cluster : allClusters(scene)) {
    largest = std::max(largest, scene.cluster(cluster.group, cluster.cluster).bounds.radius);
  }
  for (const CameraChoice& choice : everyChoice()) {
    std::optional<ViewedPart> part = viewedPart(choice, view);
    if (!part) {
      continue;
    }
    const Mesh viewed = meshForView(scene, choice, view, kNoError);
    EXPECT_GT(viewed.triangles.size(), 0U) << choice.name;
    EXPECT_LT(viewed.triangles.size(), ballsAndWall().mesh.triangles.size()) << choice.name;
    // A cluster whose sphere is reached may lie behind its centre.
    part->reach += 2 * largest;
    EXPECT_TRUE(std::ranges::all_of(viewed.positions, [&](const glm::vec3& p) { return isViewed(*part, view, p); }))
        << choice.name;
  }
}

/// At the default of a quarter of a pixel. Where surfaces are off by that, silhouettes move by as much: of 21,600
/// pixels some thousands lie beside one, and one in two thousand at most shows another surface. A DDOC puts its samples
/// where edges displace them: where an edge is found one pixel on, the samples beside it are others, and the reference
/// lacks some that it had: 0.03 to 2.5 %. Errors of sixteen pixels move a fifth of its samples.
TEST(PackedView, ByDefaultTheReferenceSeesTheSame) {
  for (const PinholeCamera& view : {defaultView(), nearView()}) {
    for (const CameraChoice& choice : everyChoice()) {
      if (!choice.hasImages()) {
        continue;
      }
      const ReferenceImages wanted = buildReferenceImages(choice, view, fineBallsAndWall().mesh);
      const ReferenceImages got = buildReferenceImages(choice, view, fineBallsAndWall().scene);
      // That there is anything to see: some clusters are coarser ones.
      const size_t looked = meshForView(fineBallsAndWall().scene, choice, view).triangles.size();
      EXPECT_LT(looked, meshForView(fineBallsAndWall().scene, choice, view, kNoError).triangles.size() * 49 / 50)
          << choice.name;
      const bool isDisplaced = choice.name.starts_with("ddoc");
      EXPECT_LT(test::otherShare(wanted, got, view), isDisplaced ? 0.03 : 0.001) << choice.name;
      EXPECT_NEAR(static_cast<double>(test::samplesOf(got)), static_cast<double>(test::samplesOf(wanted)),
                  0.02 * static_cast<double>(test::samplesOf(wanted)))
          << choice.name;
    }
  }
}

/// That the bounds of the test above can be broken.
TEST(PackedView, ErrorsOfSixteenPixelsAreFound) {
  const PinholeCamera view = defaultView();
  for (const char* name : {"di", "ddoc", "eoc-h", "cell", "spoc", "corners-4"}) {
    const CameraChoice choice = cameraChoice(name);
    const Mesh coarse = meshForView(ballsAndWall().scene, choice, view, 16);
    EXPECT_GT(test::otherShare(buildReferenceImages(choice, view, ballsAndWall().mesh),
                               buildReferenceImages(choice, view, coarse), view),
              choice.name == "ddoc" ? 0.1 : 0.004)
        << name;
  }
}

/// A ball around a viewpoint: the packed scene is refused where the scene is, with the same words.
TEST(PackedView, ViewpointsInsideAnObjectAreRefusedAsInTheScene) {
  const PinholeCamera view = defaultView();
  struct Case {
    const char* where;
    glm::vec3 center;
    bool isRefused;  ///< by some representation
  };
  for (const Case& each : {Case{"nowhere", {0, 0, -6}, false}, Case{"eye", {0, 0, 10}, true},
                           Case{"left end", {-0.8f, 0, 10}, true}, Case{"upper end", {0, 0.8f, 10}, true}}) {
    Mesh scene = bumpyBall(64);
    append(scene, bumpyBall(64), glm::scale(glm::translate(glm::mat4(1), each.center), glm::vec3(0.3f)));
    Numbers().paint(scene);
    const PackedMesh made(scene);
    size_t refused = 0;
    for (const CameraChoice& choice : everyChoice()) {
      if (choice.hasImages()) {
        const std::string wanted = errorOf([&] { buildReferenceImages(choice, view, made.mesh); });
        EXPECT_EQ(errorOf([&] { buildReferenceImages(choice, view, made.scene); }), wanted)
            << choice.name << ", " << each.where;
        refused += wanted.empty() ? 0 : 1;
        if (each.where == std::string("eye")) {
          EXPECT_THAT(wanted, HasSubstr("inside")) << choice.name;
        }
      }
    }
    EXPECT_EQ(refused > 0, each.isRefused) << each.where;
  }
}

/// A room with a thick wall: a coarse inner face, a fine outer one, and a window, through which they are one object. A
/// cluster of the inner face alone is closed but for the window, as an object around the eye would be.
TEST(PackedView, AnEyeInARoomIsInNoObject) {
  constexpr int kSegments = 10;
  Mesh room = makeSphere(kSegments);
  const glm::uvec3 window = room.triangles[room.triangles.size() / 2];
  std::erase(room.triangles, window);
  Mesh outer = room;
  for (glm::uvec3& t : room.triangles) {
    std::swap(t.y, t.z);
  }
  const auto first = static_cast<uint32_t>(room.positions.size());
  append(room, outer, glm::scale(glm::mat4(1), glm::vec3(1.2f)));
  for (glm::length_t i = 0; i < 3; ++i) {
    const uint32_t a = window[i];
    const uint32_t b = window[(i + 1) % 3];
    room.triangles.insert(room.triangles.end(), {{a, b, first + b}, {a, first + b, first + a}});
  }
  // The outer face becomes fine: each of its triangles into 64.
  for (int round = 0; round < 3; ++round) {
    Mesh finer;
    finer.positions = room.positions;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    for (const glm::uvec3& t : room.triangles) {
      const bool isOuter = std::min({t.x, t.y, t.z}) >= first;
      if (!isOuter) {
        finer.triangles.push_back(t);
        continue;
      }
      const auto middle = [&](uint32_t a, uint32_t b) {
        const auto [known, isNew] = middles.try_emplace(std::minmax(a, b), finer.positions.size());
        if (isNew) {
          finer.positions.push_back((room.positions[a] + room.positions[b]) * 0.5f);
        }
        return known->second;
      };
      const uint32_t ab = middle(t.x, t.y);
      const uint32_t bc = middle(t.y, t.z);
      const uint32_t ca = middle(t.z, t.x);
      finer.triangles.insert(finer.triangles.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
    }
    room = std::move(finer);
  }
  Numbers().paint(room);
  View inside;
  inside.eye = {0.1f, 0.05f, 0.1f};
  inside.target = {0.1f, 0, -10};
  inside.fovVerticalDegrees = 40;
  const PinholeCamera view(inside, kWidth, kHeight);
  const PackedMesh made(room);
  for (const CameraChoice& choice : everyChoice()) {
    if (choice.hasImages()) {
      EXPECT_EQ(errorOf([&] { buildReferenceImages(choice, view, made.scene); }),
                errorOf([&] { buildReferenceImages(choice, view, made.mesh); }))
          << choice.name;
    }
  }
}

TEST(PackedView, ViewsThatShowNothingAreRefusedAsInTheScene) {
  View away;
  away.target = {0, 0, 20};
  away.fovVerticalDegrees = 20;
  const PinholeCamera view(away, kWidth, kHeight);
  for (const CameraChoice& choice : everyChoice()) {
    if (choice.hasImages()) {
      const std::string wanted = errorOf([&] { buildReferenceImages(choice, view, ballsAndSky().mesh); });
      EXPECT_EQ(errorOf([&] { buildReferenceImages(choice, view, ballsAndSky().scene); }), wanted) << choice.name;
    }
  }
  EXPECT_THAT(errorOf([&] { buildReferenceImages(cameraChoice("ddoc"), view, ballsAndSky().scene); }),
              HasSubstr("sees nothing"));
}

}  // namespace
}  // namespace ocelli
