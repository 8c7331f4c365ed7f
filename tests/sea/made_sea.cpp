#include "tests/sea/made_sea.h"

#include <cmath>
#include <cstdlib>
#include <glm/gtc/quaternion.hpp>
#include <utility>

namespace ocelli::test {
namespace {

void addBox(Mesh& mesh, const glm::vec3& lower, const glm::vec3& upper) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                                (i & 4) != 0 ? upper.z : lower.z);
  }
  for (const glm::uvec3& t : {glm::uvec3{0, 2, 1},
                              {1, 2, 3},
                              {4, 5, 6},
                              {5, 7, 6},
                              {0, 1, 4},
                              {1, 5, 4},
                              {2, 6, 3},
                              {3, 6, 7},
                              {0, 4, 2},
                              {2, 4, 6},
                              {1, 3, 5},
                              {3, 7, 5}}) {
    mesh.triangles.push_back(t + first);
  }
}

Rgb8 patternAt(const glm::vec3& p) {
  const auto wave = [](float x) { return static_cast<uint8_t>(std::lround(128 + 100 * std::sin(x))); };
  return {wave(3 * p.x + p.y), wave(2 * p.y - 3 * p.z), wave(2 * p.z + 2 * p.x)};
}

}  // namespace

Mesh roomProxy() {
  Mesh mesh;
  addBox(mesh, {-2, -1.5f, -2.5f}, {2, 1.5f, 2.5f});
  addBox(mesh, {0.8f, -1.5f, -0.2f}, {1.1f, 1.5f, 0.2f});
  return mesh;
}

RoomImages::RoomImages(std::vector<SeaPose> poses, SeaProjection projection)
    : poses_(std::move(poses)), projection_(projection), room_(roomProxy()) {
  for (size_t i = 0; i < poses_.size(); ++i) {
    names_.push_back("image" + std::to_string(i) + ".png");
  }
}

Image<Rgb8> RoomImages::seenFrom(const SeaPose& pose) const {
  Image<Rgb8> image(projection_.width, projection_.height);
  const glm::vec3 eye(pose.position);
  const glm::quat worldFromCamera(pose.worldFromCamera);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const glm::vec3 direction = worldFromCamera * projection_.direction(glm::vec2(x, y) + 0.5f);
      const SightLine line{eye, eye + direction * 100.0f};
      float share = 0;
      room_.rays().meet({&line, 1}, {&share, 1});
      image(x, y) = patternAt(glm::mix(line.from, line.to, share));
    }
  }
  return image;
}

Image<Rgb8> RoomImages::image(uint32_t index) const {
  return seenFrom(poses_[index]);
}

std::vector<SeaPose> gridPoses(int columns, int rows, double spacing) {
  std::vector<SeaPose> poses;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      poses.push_back(
          {{(column - (columns - 1) / 2.0) * spacing, 0, (row - (rows - 1) / 2.0) * spacing}, glm::dquat(1, 0, 0, 0)});
    }
  }
  return poses;
}

std::vector<SeaPose> aroundThePillar() {
  std::vector<SeaPose> poses;
  for (const double z : {0.0, -0.2, 0.2, -0.4, 0.4}) {
    poses.push_back({{0.3, 0, z}, glm::dquat(1, 0, 0, 0)});
  }
  return poses;
}

std::vector<glm::vec3> wallPoints(float spacing) {
  std::vector<glm::vec3> points;
  for (float y = -1.5f; y <= 1.5f; y += spacing) {
    for (float z = -2.5f; z <= 2.5f; z += spacing) {
      points.emplace_back(2, y, z);
      points.emplace_back(-2, y, z);
    }
  }
  for (float x = -2; x <= 2; x += spacing) {
    for (float z = -2.5f; z <= 2.5f; z += spacing) {
      points.emplace_back(x, -1.5f, z);
      points.emplace_back(x, 1.5f, z);
    }
  }
  return points;
}

SeaSettings settingsOf(const SeaSource& source, SeaWay way) {
  SeaSettings settings;
  settings.source = source.description();
  settings.projection = source.projection();
  settings.way = way;
  settings.iCodec = "png";
  settings.pCodec = "png";
  return settings;
}

double meanDifference(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      sum += std::abs(int{a[i][c]} - int{b[i][c]});
    }
  }
  return sum / (3.0 * static_cast<double>(a.size()));
}

}  // namespace ocelli::test
