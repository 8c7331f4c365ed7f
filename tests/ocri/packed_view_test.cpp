// Reference images of packed scenes against those of the scene itself, for every representation that there is.
#include "oc_core/ocri/packed_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "oc_core/base/error.h"
#include "oc_core/ocri/representation.h"
#include "oc_core/ocri/representation_kind.h"
#include "oc_core/render/view_cut.h"
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

/// Balls of a few thousand triangles before a bumpy wall, everywhere in the frustum of the default view and well beside
/// it. Some are large and stand near the eye, beside the border of the image: what they hide lies outside of it. No
/// surface is flat and no vertex has its neighbour's colour, so that every level of detail has an error.
Mesh ballsBesideTheFrustum() {
  std::mt19937 random(5);
  const auto between = [&](float least, float most) {
    return least + (most - least) * static_cast<float>(random() >> 8U) / static_cast<float>(1U << 24U);
  };
  Mesh scene;
  Mesh ball = test::bumpyBall(1'500);
  const auto add = [&](const glm::vec3& at, float radius) {
    for (glm::vec3& color : ball.colors) {
      color = {between(0.2f, 0.8f), between(0.2f, 0.8f), between(0.2f, 0.8f)};
    }
    append(scene, ball, glm::scale(glm::translate(glm::mat4(1), at), glm::vec3(radius)));
  };
  for (int i = 0; i < 40; ++i) {
    add({between(-4, 4), between(-3, 3), between(-3, 0.5f)}, between(0.05f, 0.3f));
  }
  for (const glm::vec2& corner : {glm::vec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
    add({1.2f * corner.x, 0.8f * corner.y, 1.5f}, 0.25f);
  }
  // The wall: a ball so large that it is nearly flat there.
  ball = test::bumpyBall(30'000);
  add({0, 0, -10}, 7);
  return scene;
}

/// One scene for all tests of this file; packing it takes a second.
struct Balls {
  Balls() : mesh(ballsBesideTheFrustum()), scene(test::packed(mesh, folder / "balls.opack")) {}

  TemporaryFolder folder;
  Mesh mesh;
  PackedScene scene;
};
const Balls& balls() {
  static const Balls made;
  return made;
}

PinholeCamera defaultView() {
  return {View{}, kWidth, kHeight};
}

std::vector<CameraChoice> everyChoice() {
  std::vector<CameraChoice> choices;
  for (const CameraName& name : cameraNames()) {
    choices.push_back(cameraChoice(name.name));
  }
  return choices;
}

/// How many samples of the images are others.
struct ImageDifference {
  size_t samples = 0;    ///< of the images that are wanted
  size_t onlyOne = 0;    ///< that one of the two images has
  size_t depth = 0;      ///< with another t: by more than a share of it
  size_t color = 0;      ///< with another colour: by more than a share of full light
  size_t elsewhere = 0;  ///< with another displacement or position: by more than a share of a pixel
  double share() const {
    return static_cast<double>(std::max({onlyOne, depth, color, elsewhere})) / static_cast<double>(samples);
  }
};

std::ostream& operator<<(std::ostream& out, const ImageDifference& d) {
  return out << d.samples << " samples: " << d.onlyOne << " in one only, " << d.depth << " of another depth, "
             << d.color << " of another colour, " << d.elsewhere << " elsewhere";
}

struct Tolerance {
  float depth;   ///< of t
  float color;   ///< of full light
  float pixels;  ///< of displacements; of positions a thousandth of that
};

ImageDifference difference(const ReferenceImages& wanted, const ReferenceImages& got, const Tolerance& allowed) {
  ImageDifference found;
  EXPECT_EQ(wanted.size(), got.size());
  for (size_t k = 0; k < std::min(wanted.size(), got.size()); ++k) {
    const ReferenceImage& a = wanted[k];
    const ReferenceImage& b = got[k];
    if (a.width() != b.width() || a.height() != b.height()) {
      ADD_FAILURE() << "image " << k << " is of " << b.width() << "x" << b.height() << ", not " << a.width() << "x"
                    << a.height();
      continue;
    }
    for (size_t i = 0; i < a.t.size(); ++i) {
      found.samples += a.holds(i) ? 1 : 0;
      found.onlyOne += a.holds(i) != b.holds(i) ? 1 : 0;
      if (!a.holds(i) || !b.holds(i)) {
        continue;
      }
      found.depth += std::abs(a.t[i] - b.t[i]) > allowed.depth * std::abs(a.t[i]) ? 1 : 0;
      const glm::vec3 color = glm::abs(a.color[i] - b.color[i]);
      found.color += std::max({color.r, color.g, color.b}) > allowed.color ? 1 : 0;
      found.elsewhere += (a.isPlaced() ? 1000 * glm::distance(a.position[i], b.position[i])
                                       : glm::distance(a.displacement[i], b.displacement[i])) > allowed.pixels
                             ? 1
                             : 0;
    }
  }
  return found;
}

TEST(PackedView, ProbeDifferences) {
  const PinholeCamera view = defaultView();
  const auto all = test::trianglesOf(balls().mesh);
  for (const CameraChoice& choice : everyChoice()) {
    const Mesh finest = meshForView(balls().scene, choice, view, kNoError);
    const auto triangles = test::trianglesOf(finest);
    std::cout << choice.name << " finest " << finest.triangles.size() << " of " << balls().mesh.triangles.size()
              << " includes " << std::includes(all.begin(), all.end(), triangles.begin(), triangles.end()) << "\n";
    if (!choice.hasImages()) {
      continue;
    }
    const ReferenceImages wanted = buildReferenceImages(choice, view, balls().mesh);
    for (const Tolerance& t : {Tolerance{0, 0, 0}, {1e-6f, 1e-5f, 1e-3f}, {1e-5f, 1e-4f, 1e-2f}}) {
      std::cout << "   " << difference(wanted, buildReferenceImages(choice, view, finest), t) << "\n";
    }
    for (const float pixels : {0.5f, 4.0f}) {
      const Mesh cut = meshForView(balls().scene, choice, view, pixels);
      std::cout << "   at " << pixels << ": " << cut.triangles.size() << " "
                << difference(wanted, buildReferenceImages(choice, view, cut), {0.01f, 0.1f, 1}) << "\n";
    }
    if (choice.kind->viewed) {
      const Mesh narrow = meshOf(balls().scene, viewCut(balls().scene, view, {.maxErrorPixels = kNoError}));
      std::cout << "   narrow " << narrow.triangles.size() << " "
                << difference(wanted, buildReferenceImages(choice, view, narrow), {1e-5f, 1e-4f, 1e-2f}) << "\n";
    }
  }
}

}  // namespace
}  // namespace ocelli
