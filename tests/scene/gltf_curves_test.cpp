// How glTF files go from key to key: STEP and CUBICSPLINE, in all the ways in which a file may hold its keys. What a
// spline must give is computed here by the formula of the specification (glTF 2.0, appendix C.5).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/scene/moving_scene.h"
#include "oc_core/scene/scene_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/scene/animated_gltf.h"

namespace ocelli {
namespace {

using test::AnimatedGltf;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

struct PlayedCurve {
  std::unique_ptr<MovingScene> scene;
  std::vector<std::string> warnings;

  std::vector<glm::vec3> at(double seconds) const {
    MovedMesh moved;
    scene->moveTo(seconds, moved);
    return moved.mesh.positions;
  }
};

PlayedCurve playFile(const std::filesystem::path& path) {
  PlayedCurve played;
  played.scene = readAnimatedFile(path, {}, "", played.warnings);
  return played;
}

PlayedCurve playText(const std::string& text) {
  const TemporaryFolder folder;
  return playFile(folder.write("a.gltf", text));
}

/// `keys`: of each time the tangent before it, the value and the tangent after it.
double splineAt(const std::vector<double>& times, const std::vector<std::array<double, 3>>& keys, double seconds) {
  size_t k = 0;
  while (k + 2 < times.size() && seconds >= times[k + 1]) {
    ++k;
  }
  const double duration = times[k + 1] - times[k];
  const double t = (seconds - times[k]) / duration;
  return (2 * std::pow(t, 3) - 3 * t * t + 1) * keys[k][1] + duration * (std::pow(t, 3) - 2 * t * t + t) * keys[k][2] +
         (-2 * std::pow(t, 3) + 3 * t * t) * keys[k + 1][1] + duration * (std::pow(t, 3) - t * t) * keys[k + 1][0];
}

const std::vector<double> kTimes{0, 1, 3};
const std::vector<std::array<double, 3>> kKeys{{{9, 0, 4}, {1, 2, -3}, {0.5, -1, 9}}};

/// A triangle whose node has one channel.
std::string nodeWith(const std::string& path, int corners, int times, int keys, const std::string& interpolation,
                     const std::string& node = R"("name": "arm", )") {
  return fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{{}"mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}}}}]}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}, "interpolation": "{}"}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "{}"}}}}]}}])",
      node, corners, times, keys, interpolation, path);
}

/// A spline along x, as far as `factor` along y, and none along z.
std::vector<float> keysAlongX(float factor) {
  std::vector<float> keys;
  for (const std::array<double, 3>& key : kKeys) {
    for (const double number : key) {
      const auto x = static_cast<float>(number);
      keys.insert(keys.end(), {x, factor * x, 0});
    }
  }
  return keys;
}

class SplineFile {
 public:
  SplineFile()
      : corners_(file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0})),
        times_(file.floats("SCALAR", {0, 1, 3})),
        keys_(file.floats("VEC3", keysAlongX(0.5f))) {}
  std::string members(const std::string& node = R"("name": "arm", )") const {
    return nodeWith("translation", corners_, times_, keys_, "CUBICSPLINE", node);
  }

  AnimatedGltf file;

 private:
  int corners_;
  int times_;
  int keys_;
};

void expectSpline(const PlayedCurve& played) {
  ASSERT_NE(played.scene, nullptr);
  EXPECT_TRUE(played.warnings.empty());
  EXPECT_DOUBLE_EQ(played.scene->durationSeconds(), 3);
  for (double seconds = 0; seconds <= 3; seconds += 0.125) {
    const double x = splineAt(kTimes, kKeys, seconds);
    const glm::vec3 p = played.at(seconds)[1];
    // Some roundings of single precision.
    EXPECT_NEAR(p.x, 1 + x, 2e-6) << seconds;
    EXPECT_NEAR(p.y, 0.5 * x, 2e-6) << seconds;
    EXPECT_EQ(p.z, 0.0f);
  }
}

TEST(GltfCurves, FollowCubicSplinesOfPlaces) {
  const SplineFile spline;
  expectSpline(playText(spline.file.text(spline.members())));
  // A straight line would be elsewhere, half-way between the first two keys.
  EXPECT_GT(std::abs(splineAt(kTimes, kKeys, 0.5) - 1), 0.3);
}

TEST(GltfCurves, AreReadFromBinaryFilesAndFromFilesBesideThem) {
  const TemporaryFolder folder;
  const SplineFile spline;
  expectSpline(playFile(folder.write("a.glb", spline.file.binary(spline.members()))));
  folder.write("keys of it.bin", spline.file.bytes());
  expectSpline(playFile(folder.write("b.gltf", spline.file.textBeside(spline.members(), "keys%20of%20it.bin"))));
}

TEST(GltfCurves, AreThoseOfNodesWithoutNames) {
  const SplineFile spline;
  expectSpline(playText(spline.file.text(spline.members(""))));
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int times = file.floats("SCALAR", {0, 2});
  const int keys = file.floats("VEC3", {0, 0, 0, 4, 0, 0});
  const PlayedCurve steps = playText(file.text(nodeWith("translation", corners, times, keys, "STEP", "")));
  EXPECT_EQ(steps.at(1.5)[0].x, 0.0f);
  EXPECT_EQ(steps.at(2)[0].x, 4.0f);
}

// A quarter about z within a second, with tangents that let it swing out about x: numbers of the quaternion follow the
// splines, and it is made one of length 1.
TEST(GltfCurves, FollowCubicSplinesOfRotations) {
  const float half = std::sqrt(0.5f);
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 1, 1, 0, 0, 0, 1, 0});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.floats("VEC4", {0, 0, 0, 0, 0, 0, 0,    1,    2,  0, 0, 0,  //
                                        0, 0, 0, 0, 0, 0, half, half, -1, 0, 0, 0});
  const PlayedCurve played = playText(file.text(nodeWith("rotation", corners, times, keys, "CUBICSPLINE")));
  EXPECT_TRUE(played.warnings.empty());
  for (const double seconds : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    const double x = splineAt({0, 1}, {{{0, 0, 2}, {0, 0, -1}}}, seconds);
    const double z = splineAt({0, 1}, {{{0, 0, 0}, {0, static_cast<double>(half), 0}}}, seconds);
    const double w = splineAt({0, 1}, {{{0, 1, 0}, {0, static_cast<double>(half), 0}}}, seconds);
    const double square = x * x + z * z + w * w;
    // What the quaternion (x, 0, z, w) makes of (1, 0, 0).
    const glm::dvec3 wanted{1 - 2 * z * z / square, 2 * z * w / square, 2 * x * z / square};
    EXPECT_LT(glm::distance(glm::dvec3(played.at(seconds)[1]), wanted), 1e-6) << seconds;
  }
}

/// A corner that two morph targets move, along x and along z.
PlayedCurve playWeights(AnimatedGltf& file, int times, int weights, const std::string& interpolation) {
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int wide = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 0, 0});
  const int deep = file.floats("VEC3", {0, 0, 0, 0, 0, 1, 0, 0, 0});
  return playText(file.text(fmt::format(
      R"("scenes": [{{"nodes": [0]}}], "nodes": [{{"name": "face", "mesh": 0}}],
         "meshes": [{{"primitives": [{{"attributes": {{"POSITION": {}}},
                                      "targets": [{{"POSITION": {}}}, {{"POSITION": {}}}]}}], "weights": [0, 0]}}],
         "animations": [{{"samplers": [{{"input": {}, "output": {}, "interpolation": "{}"}}],
                          "channels": [{{"sampler": 0, "target": {{"node": 0, "path": "weights"}}}}]}}])",
      corners, wide, deep, times, weights, interpolation)));
}

TEST(GltfCurves, FollowCubicSplinesOfWeights) {
  AnimatedGltf file;
  const int times = file.floats("SCALAR", {0, 1, 3});
  std::vector<float> numbers;
  for (const std::array<double, 3>& key : kKeys) {
    for (const double number : key) {
      numbers.insert(numbers.end(), {static_cast<float>(number), static_cast<float>(-2 * number)});
    }
  }
  const PlayedCurve played = playWeights(file, times, file.floats("SCALAR", numbers), "CUBICSPLINE");
  ASSERT_NE(played.scene, nullptr);
  EXPECT_TRUE(played.warnings.empty());
  for (double seconds = 0; seconds <= 3; seconds += 0.25) {
    const double x = splineAt(kTimes, kKeys, seconds);
    EXPECT_LT(glm::distance(glm::dvec3(played.at(seconds)[1]), {1 + x, 0, -2 * x}), 1e-5) << seconds;
  }
}

TEST(GltfCurves, HaveWeightsBelowZero) {
  AnimatedGltf file;
  const int times = file.floats("SCALAR", {0, 2});
  const PlayedCurve played = playWeights(file, times, file.floats("SCALAR", {0, 0, -1, 3}), "LINEAR");
  EXPECT_LT(glm::distance(played.at(1)[1], {0.5f, 0, 1.5f}), 1e-6f);
}

// As packing programs write them: 16-bit numbers with a sign, as shares of 32767.
TEST(GltfCurves, AreReadFromNormalizedNumbers) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 1, 1, 0, 0, 0, 1, 0});
  const int times = file.floats("SCALAR", {0, 1});
  const int keys = file.normalized("VEC4", {0, 0, 0, 32767, 0, 0, 23170, 23170});
  const PlayedCurve played = playText(file.text(nodeWith("rotation", corners, times, keys, "LINEAR")));
  const float half = std::sqrt(0.5f);
  EXPECT_LT(glm::distance(played.at(0)[1], {1, 0, 0}), 1e-4f);
  EXPECT_LT(glm::distance(played.at(0.5)[1], {half, half, 0}), 1e-4f) << "as well as 16 bits say";
  EXPECT_LT(glm::distance(played.at(1)[1], {0, 1, 0}), 1e-4f);
}

TEST(GltfCurves, SayWhereSplinesCannotBeRead) {
  AnimatedGltf file;
  const int corners = file.floats("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int times = file.floats("SCALAR", {0, 2});
  const int keys = file.sparse("VEC3", 18);
  const PlayedCurve played = playText(file.text(nodeWith("translation", corners, times, keys, "CUBICSPLINE")));
  EXPECT_THAT(played.warnings, ElementsAre(HasSubstr("cubic")));
}

}  // namespace
}  // namespace ocelli
