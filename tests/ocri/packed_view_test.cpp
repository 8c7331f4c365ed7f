// Reference images of packed scenes against those of the scene itself, for every representation that there is.
#include "oc_core/ocri/packed_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <random>

#include "oc_core/base/error.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/view_cut.h"
#include "oc_core/worlds/solids.h"
#include "tests/base/temporary_folder.h"
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
Mesh ballsBesideTheFrustum() {
  Numbers numbers;
  Mesh scene;
  Mesh ball = bumpyBall(32);
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
Mesh ballsBeforeAWall() {
  Mesh scene = ballsBesideTheFrustum();
  constexpr int kColumns = 200;
  constexpr int kRows = 150;
  Mesh wall;
  for (int row = 0; row <= kRows; ++row) {
    for (int column = 0; column <= kColumns; ++column) {
      const float x = 10.0f * static_cast<float>(column) / kColumns - 5;
      const float y = 8.0f * static_cast<float>(row) / kRows - 4;
      wall.positions.emplace_back(x, y, -3 + 0.1f * std::sin(5 * x) * std::cos(4 * y));
      if (row < kRows && column < kColumns) {
        const auto at = static_cast<uint32_t>(row * (kColumns + 1) + column);
        wall.triangles.emplace_back(at, at + 1, at + kColumns + 2);
        wall.triangles.emplace_back(at, at + kColumns + 2, at + kColumns + 1);
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
      others += isSame ? 0 : 1;
    }
  }
  return others;
}

/// The distance from the reference's eye at each pixel of the reference that any of the images shows, 0 elsewhere.
/// Cameras put samples elsewhere when an edge moves by a pixel, and images become wider or higher; the reference sees
/// the same.
Image<float> seenByReference(const ReferenceImages& images, const PinholeCamera& view) {
  Image<float> seen(view.width(), view.height(), 0);
  for (const ReferenceImage& image : images) {
    const PinholeCamera own = image.reference();
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const std::optional<glm::vec3> point = image.pointOf(x, y, own);
        const std::optional<ImagePoint> at = point ? view.project(*point) : std::nullopt;
        if (at && at->u >= 0 && at->v >= 0 && at->u < static_cast<float>(view.width()) &&
            at->v < static_cast<float>(view.height())) {
          float& t = seen(static_cast<int>(at->u), static_cast<int>(at->v));
          t = t == 0 ? at->t : std::min(t, at->t);
        }
      }
    }
  }
  return seen;
}

size_t samplesOf(const ReferenceImages& images) {
  size_t samples = 0;
  for (const ReferenceImage& image : images) {
    samples += image.sampleCount();
  }
  return samples;
}

/// The share of the reference's pixels that one of the two lacks, or that show something a hundredth nearer or farther.
double otherShare(const ReferenceImages& wanted, const ReferenceImages& got, const PinholeCamera& view) {
  const Image<float> a = seenByReference(wanted, view);
  const Image<float> b = seenByReference(got, view);
  size_t covered = 0;
  size_t others = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    covered += a[i] > 0 ? 1 : 0;
    others += (a[i] > 0) != (b[i] > 0) || std::abs(a[i] - b[i]) > 0.01f * a[i] ? 1 : 0;
  }
  return static_cast<double>(others) / static_cast<double>(covered);
}

bool hasAllTriangles(const Mesh& mesh, const Mesh& of) {
  const auto some = test::trianglesOf(mesh);
  const auto all = test::trianglesOf(of);
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// Where no error is allowed, images hold the same samples bit by bit: the triangles are the scene's own, each pixel
/// has one of them whatever their order, and what is left out would be in no image.
TEST(PackedView, WithoutErrorEveryRepresentationIsThatOfTheScene) {
  for (const PinholeCamera& view : {defaultView(), nearView()}) {
    for (const CameraChoice& choice : everyChoice()) {
      const Mesh viewed = meshForView(ballsAndWall().scene, choice, view, kNoError);
      EXPECT_TRUE(hasAllTriangles(viewed, ballsAndWall().mesh)) << choice.name;
      if (!viewedPart(choice, view)) {
        EXPECT_EQ(viewed.triangles.size(), ballsAndWall().mesh.triangles.size()) << choice.name;
      }
      if (choice.hasImages()) {
        const ReferenceImages wanted = buildReferenceImages(choice, view, ballsAndWall().mesh);
        EXPECT_GT(samplesOf(wanted), 300U) << choice.name;
        EXPECT_EQ(otherSamples(wanted, buildReferenceImages(choice, view, viewed)), 0U) << choice.name;
      }
    }
  }
}

TEST(PackedView, ProbeSky) {
  for (const PinholeCamera& view : {defaultView(), nearView()}) {
    for (const CameraChoice& choice : everyChoice()) {
      if (choice.hasImages()) {
        const Mesh viewed = meshForView(ballsAndSky().scene, choice, view, kNoError);
        const ReferenceImages wanted = buildReferenceImages(choice, view, ballsAndSky().mesh);
        std::cout << choice.name << " " << otherSamples(wanted, buildReferenceImages(choice, view, viewed)) << " of "
                  << samplesOf(wanted) << "\n";
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
      std::cout << choice.name << " " << part->reach << " " << part->marginPixels << " "
                << otherSamples(buildReferenceImages(choice, view, ballsAndWall().mesh),
                                buildReferenceImages(choice, view, narrow))
                << "\n";
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
  const PinholeCamera view = nearView();
  // The largest box of a cluster of the scene.
  float longest = 0;
  const PackedScene& scene = ballsAndWall().scene;
  for (const ClusterChoice& cluster : allClusters(scene)) {
    longest = std::max(longest, 2 * scene.cluster(cluster.group, cluster.cluster).bounds.radius);
  }
  for (const CameraChoice& choice : everyChoice()) {
    std::optional<ViewedPart> part = viewedPart(choice, view);
    if (!part) {
      continue;
    }
    const Mesh viewed = meshForView(scene, choice, view, kNoError);
    EXPECT_LT(viewed.triangles.size(), ballsAndWall().mesh.triangles.size()) << choice.name;
    part->reach += longest;
    EXPECT_TRUE(std::ranges::all_of(viewed.positions, [&](const glm::vec3& p) { return isViewed(*part, view, p); }))
        << choice.name;
  }
}

TEST(PackedView, ByDefaultTheReferenceSeesTheSame) {
  for (const PinholeCamera& view : {defaultView(), nearView()}) {
    for (const CameraChoice& choice : everyChoice()) {
      if (!choice.hasImages()) {
        continue;
      }
      const ReferenceImages wanted = buildReferenceImages(choice, view, ballsAndWall().mesh);
      const ReferenceImages got = buildReferenceImages(choice, view, ballsAndWall().scene);
      const Mesh coarse = meshForView(ballsAndWall().scene, choice, view, 8);
      std::cout << choice.name << " " << otherShare(wanted, got, view) << " "
                << static_cast<double>(samplesOf(got)) / static_cast<double>(samplesOf(wanted)) << " "
                << meshForView(ballsAndWall().scene, choice, view).triangles.size() << " coarse "
                << otherShare(wanted, buildReferenceImages(choice, view, coarse), view) << "\n";
    }
  }
}

/// A ball around a viewpoint: the packed scene is refused where the scene is, with the same words.
TEST(PackedView, ViewpointsInsideAnObjectAreRefusedAsInTheScene) {
  const PinholeCamera view = defaultView();
  struct Case {
    const char* where;
    glm::vec3 center;
  };
  for (const Case& each : {Case{"nowhere", {0, 0, -6}}, Case{"eye", {0, 0, 10}}, Case{"left", {-0.8f, 0, 10}},
                           Case{"top", {0, 0.8f, 10}}, Case{"corner", {0.8f, 0.8f, 9.2f}}}) {
    Mesh scene = bumpyBall(64);
    append(scene, bumpyBall(64), glm::scale(glm::translate(glm::mat4(1), each.center), glm::vec3(0.3f)));
    Numbers().paint(scene);
    const PackedMesh made(scene);
    for (const CameraChoice& choice : everyChoice()) {
      if (choice.hasImages()) {
        const std::string wanted = errorOf([&] { buildReferenceImages(choice, view, made.mesh); });
        EXPECT_EQ(errorOf([&] { buildReferenceImages(choice, view, made.scene); }), wanted)
            << choice.name << ", " << each.where;
        EXPECT_EQ(wanted.empty(), each.where != std::string("eye") && wanted.empty());
        if (each.where == std::string("eye")) {
          EXPECT_THAT(wanted, HasSubstr("inside")) << choice.name;
        }
      }
    }
  }
}

/// In a room with thick walls and a small window: the inner faces of the walls may be one cluster, whose sum of solid
/// angles is that of a closed object.
TEST(PackedView, AnEyeInARoomIsNoEyeInAWall) {
  Mesh room = makeSphere(12);
  std::erase_if(room.triangles, [&](const glm::uvec3& t) { return t == room.triangles.front(); });
  for (glm::uvec3& t : room.triangles) {
    std::swap(t.y, t.z);
  }
  // The window: what lies at the hole leads to the outer face.
  Mesh outer = makeSphere(64);
  for (glm::vec3& p : room.positions) {
    p *= 1.0f;
  }
  append(room, outer, glm::scale(glm::mat4(1), glm::vec3(1.5f)));
  Numbers().paint(room);
  View inside;
  inside.eye = {0.1f, 0, 0.1f};
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
