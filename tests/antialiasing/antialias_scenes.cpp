#include "tests/antialiasing/antialias_scenes.h"

#include <cmath>

#include "oc_core/base/random.h"

namespace ocelli::test {

PinholeCamera flatCamera(int width, int height) {
  View view;
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  view.eye = {w / 2, h / 2, h};
  view.target = {w / 2, h / 2, 0};
  view.fovVerticalDegrees = 2 * std::atan(0.5) * 180 / M_PI;
  view.zFar = 1e5f;
  return {view, width, height};
}

void addFlat(Mesh& mesh, const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec3& color,
             const PinholeCamera& camera, float above) {
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  const auto height = static_cast<float>(camera.height());
  for (const glm::vec2& p : {a, b, c}) {
    // Towards the eye, so that the image stays where it is.
    const glm::vec3 onPlane(p.x, height - p.y, 0);
    mesh.positions.push_back(onPlane + (camera.eye() - onPlane) * (above / height));
    mesh.colors.push_back(color);
  }
  mesh.triangles.emplace_back(first, first + 1, first + 2);
}

Mesh triangleCloud(size_t count, float size) {
  Random random(7);
  Mesh mesh;
  for (size_t i = 0; i < count; ++i) {
    const glm::vec3 at(random.inRange(-0.6f, 0.6f), random.inRange(-0.6f, 0.6f), random.inRange(-0.6f, 0.6f));
    const glm::vec3 color(random.inRange(0, 1), random.inRange(0, 1), random.inRange(0, 1));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back(at +
                               size * glm::vec3(random.inRange(-1, 1), random.inRange(-1, 1), random.inRange(-1, 1)));
      mesh.colors.push_back(color);
    }
    const auto first = static_cast<uint32_t>(3 * i);
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  return mesh;
}

AntialiasPlan everywhere(const PixelRule& rule) {
  return {{rule}, {}};
}

PixelRule squareRule(int side, const char* placement, size_t maxExactTriangles) {
  return {std::make_shared<SamplePattern>(side, *findSamplePlacement(placement)), false, maxExactTriangles};
}

PixelRule multisampleRule(int samples) {
  return {std::make_shared<SamplePattern>(SamplePattern::multisample(samples)), true, 0};
}

double rmse(const Image<glm::vec3>& a, const Image<glm::vec3>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(a[i]) - glm::dvec3(b[i]);
    sum += glm::dot(d, d);
  }
  return std::sqrt(sum / static_cast<double>(3 * a.size()));
}

double greatestDifference(const Image<glm::vec3>& a, const Image<glm::vec3>& b) {
  double greatest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const glm::vec3 d = glm::abs(a[i] - b[i]);
    greatest = std::max(greatest, static_cast<double>(std::max({d.x, d.y, d.z})));
  }
  return greatest;
}

}  // namespace ocelli::test
