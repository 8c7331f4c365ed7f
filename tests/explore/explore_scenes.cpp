#include "tests/explore/explore_scenes.h"

#include <array>
#include <cmath>

#include "oc_core/base/conventions.h"

namespace ocelli::test {
namespace {

void addTriangle(GuidedScene& scene, const std::array<glm::vec3, 3>& corners, uint32_t object, const glm::vec3& color) {
  const auto first = static_cast<uint32_t>(scene.mesh.positions.size());
  for (const glm::vec3& corner : corners) {
    scene.mesh.positions.push_back(corner);
    scene.mesh.colors.push_back(color);
  }
  scene.mesh.triangles.push_back({first, first + 1, first + 2});
  scene.objectOfTriangle.push_back(object);
}

void addFace(GuidedScene& scene, const glm::vec3& corner, const glm::vec3& a, const glm::vec3& b, uint32_t object,
             const glm::vec3& color) {
  addTriangle(scene, {corner, corner + a, corner + a + b}, object, color);
  addTriangle(scene, {corner, corner + a + b, corner + b}, object, color);
}

}  // namespace

ExplorerOptions smallPictures() {
  ExplorerOptions options;
  options.width = 160;
  options.height = 90;
  return options;
}

void addBox(GuidedScene& scene, const Box& box, uint32_t object, const glm::vec3& color) {
  const glm::vec3 size = box.size();
  const glm::vec3 x(size.x, 0, 0);
  const glm::vec3 y(0, size.y, 0);
  const glm::vec3 z(0, 0, size.z);
  addFace(scene, box.lower, y, x, object, color * 0.9f);
  addFace(scene, box.lower + z, x, y, object, color);
  addFace(scene, box.lower, z, y, object, color * 0.7f);
  addFace(scene, box.lower + x, y, z, object, color * 0.8f);
  addFace(scene, box.lower, x, z, object, color * 0.5f);
  addFace(scene, box.lower + y, z, x, object, color);
}

GuidedScene hall() {
  GuidedScene scene;
  for (int x = -10; x < 10; x += 2) {
    for (int z = -10; z < 10; z += 2) {
      const bool dark = (x + z) % 4 == 0;
      addFace(scene, glm::vec3(x, 0, z), {0, 0, 2}, {2, 0, 0}, 0, glm::vec3(dark ? 0.2f : 0.6f));
    }
  }
  for (int i = -10; i < 10; i += 2) {
    const auto at = static_cast<float>(i);
    const glm::vec3 color = i % 4 == 0 ? glm::vec3(0.5f, 0.4f, 0.3f) : glm::vec3(0.3f, 0.4f, 0.5f);
    addFace(scene, {at, 0, -10}, {2, 0, 0}, {0, 3, 0}, 0, color);
    addFace(scene, {at, 0, 10}, {0, 3, 0}, {2, 0, 0}, 0, color);
    addFace(scene, {-10, 0, at}, {0, 3, 0}, {0, 0, 2}, 0, color);
    addFace(scene, {10, 0, at}, {0, 0, 2}, {0, 3, 0}, 0, color);
  }
  return scene;
}

GuidedScene twoRooms() {
  GuidedScene scene = hall();
  const glm::vec3 white(0.8f);
  addBox(scene, {{-10, 0, -3.1f}, {-0.5f, 3, -2.9f}}, 0, white);
  addBox(scene, {{0.5f, 0, -3.1f}, {10, 3, -2.9f}}, 0, white);
  addBox(scene, {{-0.5f, 2, -3.1f}, {0.5f, 3, -2.9f}}, 0, white);
  addBox(scene, {{-3, 0, -7}, {-2, 1.5f, -6}}, 1, {0.8f, 0.1f, 0.1f});
  addBox(scene, {{2, 0, -7}, {3, 1.5f, -6}}, 2, {0.1f, 0.7f, 0.1f});
  scene.guides.portals = {{{0, 1, -3}, {0, 0, 1}, {0.5f, 0, 0}, {0, 1, 0}}};
  return scene;
}

GuidedScene hiddenBox() {
  GuidedScene scene = hall();
  addBox(scene, {{-0.6f, 0, -4.5f}, {0.6f, 2.5f, -4}}, 1, {0.2f, 0.3f, 0.8f});
  addBox(scene, {{-0.3f, 0.5f, -7.3f}, {0.3f, 1.8f, -6.7f}}, 2, {0.8f, 0.1f, 0.1f});
  return scene;
}

GuidedScene hallWithPath() {
  GuidedScene scene = hall();
  scene.guides.path.push_back({-7, 1.6f, 8});
  for (int i = 0; i <= 8; ++i) {  // a quarter of a circle to the right, and one to the left
    const double angle = kPi / 2 * i / 8;
    scene.guides.path.emplace_back(-7 + 5 * (1 - std::cos(angle)), 1.6, 3 - 5 * std::sin(angle));
  }
  for (int i = 1; i <= 8; ++i) {
    const double angle = kPi / 2 * i / 8;
    scene.guides.path.emplace_back(-2 + 5 * std::sin(angle), 1.6, -7 + 5 * std::cos(angle));
  }
  return scene;
}

}  // namespace ocelli::test
