// Pictures of files whose animation plays: cubic splines, and lines and points that move.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/base/temporary_folder.h"
#include "tests/render/file_pictures.h"
#include "tests/scene/animated_gltf.h"

namespace ocelli {
namespace {

using test::AnimatedGltf;
using test::covered;
using test::differences;
using test::kSide;
using test::Picture;
using test::pictureOf;
using test::pictureOfFile;
using test::pixelsOfUnit;
using test::TemporaryFolder;

const SceneOptions kPlain{.fit = false, .shading = Shading::kNone};

SceneOptions momentOptions(double seconds) {
  SceneOptions options = kPlain;
  options.motion.seconds = seconds;
  return options;
}

/// The middle of what is seen, in units of the scene.
glm::dvec2 middleOf(const Picture& picture) {
  glm::dvec2 sum(0);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      if (picture(x, y) != glm::vec3(0)) {
        sum += glm::dvec2(x + 0.5 - kSide / 2.0, kSide / 2.0 - y - 0.5);
      }
    }
  }
  return sum / static_cast<double>(covered(picture)) / static_cast<double>(pixelsOfUnit());
}

// A square goes from (-0.7, -0.5) to (0.7, 0.5) within a second, and leaves and arrives with 6 units a second upwards:
// a third of the way up it is far above the straight line.
TEST(MovingPictures, FollowCubicSplines) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {-0.1f, -0.1f, 0, 0.1f, -0.1f, 0, 0.1f, 0.1f, 0, -0.1f, 0.1f, 0});
  const int triangles = file.shorts("SCALAR", {0, 1, 2, 0, 2, 3});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC3", {0, 0, 0, -0.7f, -0.5f, 0, 0, 6, 0,  //
                                        0, 6, 0, 0.7f, 0.5f, 0, 0, 0, 0});
  const TemporaryFolder folder;
  const auto path =
      folder.write("a.gltf", file.text(fmt::format(
                                 R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"name": "square", "mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}, "indices": {}}}]}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}, "interpolation": "CUBICSPLINE"}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "translation"}}}}]}}])",
                                 corners, triangles, times, keys)));
  for (const double t : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    const glm::dvec2 at = middleOf(pictureOfFile(path, momentOptions(t), fmt::format("gltf_spline_{}", t)));
    const double from = 2 * t * t * t - 3 * t * t + 1;
    const double bulge = (t * t * t - 2 * t * t + t) + (t * t * t - t * t);
    // Less than a pixel: rows and columns of pixels at the rim come and go.
    const double slack = 0.6 / static_cast<double>(pixelsOfUnit());
    EXPECT_NEAR(at.x, 0.7 * (1 - 2 * from), slack) << t;
    EXPECT_NEAR(at.y, -0.5 * from + 0.5 * (1 - from) + 6 * bulge, slack) << t;
  }
}

/// A bent line, or its corners as points, at a node that turns by a quarter about z within a second.
std::string turningFile(int mode, bool turned) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {-0.8f, -0.3f, 0, 0, 0.4f, 0.2f, 0.7f, 0.1f, 0, 0.9f, -0.6f, 0});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC4", {0, 0, 0, 1, 0, 0, 0.70710678f, 0.70710678f});
  return file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"name": "arm", "mesh": 0{}}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}, "mode": {}}}]}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "rotation"}}}}]}}])",
      turned ? R"(, "rotation": [0, 0, 0.70710678, 0.70710678])" : "", corners, mode, times, keys));
}

// At its end the animation shows what the same file shows at rest, where its node stands so.
TEST(MovingPictures, TurnLinesAndPoints) {
  const TemporaryFolder folder;
  for (const int mode : {0, 3}) {
    SceneOptions playing = momentOptions(1);
    playing.points.width = 0.15;
    SceneOptions still = kPlain;
    still.points.width = 0.15;
    const std::string name = mode == 0 ? "points" : "line";
    const Picture played =
        pictureOfFile(folder.write("a.gltf", turningFile(mode, false)), playing, "gltf_turned_" + name);
    const Picture wanted = pictureOfFile(folder.write("b.gltf", turningFile(mode, true)), still, "gltf_still_" + name);
    const Picture begin = pictureOfFile(folder / "a.gltf", still, "gltf_begin_" + name);
    if (mode == 3) {
      // The sides of a tube start at any direction across it, so that the two differ by less than half a side.
      EXPECT_LT(differences(played, wanted), covered(wanted) / 10);
    } else {
      EXPECT_LT(std::abs(middleOf(played).x - middleOf(wanted).x), 0.01);
    }
    EXPECT_NEAR(middleOf(played).x, middleOf(wanted).x, 0.01);
    EXPECT_NEAR(middleOf(played).y, middleOf(wanted).y, 0.01);
    EXPECT_GT(differences(played, begin), covered(begin)) << "it has moved";
    EXPECT_GT(covered(played), 200u);
  }
}

}  // namespace
}  // namespace ocelli
