#include "oc_core/shade/shadow_picture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/shade/first_surfaces.h"
#include "oc_core/shade/vertex_normals.h"

namespace ocelli {
namespace {

constexpr float kEvenLight = 0.22f;
constexpr float kAreaLight = 1.0f;
constexpr int kSquare = 16;  ///< of neighbouring receivers, pixels

/// A point so near the plane of a light is a part of its panel, world units.
constexpr float kOnPanel = 1e-4f;

bool isOnLight(const glm::vec3& point, const LightFrame& frame) {
  return std::abs(point.z) < kOnPanel && std::abs(point.x) <= frame.half().x + kOnPanel &&
         std::abs(point.y) <= frame.half().y + kOnPanel;
}

}  // namespace

ShadowSurfaces::ShadowSurfaces(const ShadedScene& scene) : scene_(scene), frame_(scene.lights.front()) {
  for (const Mesh* part : {&scene.cast, &scene.billboards, &scene.surroundings}) {
    append(mesh_, *part);
  }
  for (const std::vector<SpecularObject>* all : {&scene.mirrors, &scene.lenses}) {
    for (const SpecularObject& object : *all) {
      append(mesh_, object.mesh);
    }
  }
  normals_ = vertexNormals(mesh_);
  rays_ = std::make_unique<RayScene>(mesh_);
}

ShadowPixels ShadowSurfaces::seenBy(const PinholeCamera& camera) const {
  ShadowPixels result{Image<glm::vec3>(camera.width(), camera.height(), shadeBackground()), {}, {}};
  struct Seen {
    ShadowPixel pixel;
    ShadowReceiver receiver;
  };
  Image<std::optional<Seen>> seen(camera.width(), camera.height());
  parallelFor(static_cast<size_t>(camera.height()), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < camera.width(); ++x) {
        const RayPath path = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        const Fragment fragment = rays_->intersect(path);
        if (!fragment.covered()) {
          continue;
        }
        const glm::vec3 position = positionOf(fragment, mesh_);
        const glm::vec3 color = colorOf(fragment, mesh_);
        const glm::vec3 inLight = frame_.fromWorld(position);
        if (isOnLight(inLight, frame_)) {
          result.base(x, y) = glm::vec3(1);
          continue;
        }
        const glm::uvec3& t = mesh_.triangles[fragment.triangle];
        glm::vec3 normal =
            glm::cross(mesh_.positions[t.y] - mesh_.positions[t.x], mesh_.positions[t.z] - mesh_.positions[t.x]);
        const float length = glm::length(normal);
        if (!(length > 0)) {
          result.base(x, y) = color * kEvenLight;
          continue;
        }
        const glm::vec3 incoming = glm::normalize(path.back() - path.front());
        normal = glm::dot(normal, incoming) > 0 ? -normal / length : normal / length;
        Seen each{{static_cast<uint32_t>(result.base.index(x, y)), false, color, 0},
                  {position, normal, fragment.triangle < scene_.cast.triangles.size()}};
        LitReceiver lit;
        if (isLit(each.receiver, frame_, {}, lit)) {
          each.pixel.isMeasured = fragment.triangle < scene_.receives.size() && scene_.receives[fragment.triangle] != 0;
          const glm::vec3 smooth = normalAt(fragment, mesh_, normals_, incoming);
          const glm::vec3 towards = glm::normalize(frame_.light().center - position);
          each.pixel.cosines = std::max(0.0f, glm::dot(smooth, towards)) * inLight.z / glm::length(inLight);
        }
        seen(x, y) = each;
      }
    }
  });
  for (int top = 0; top < camera.height(); top += kSquare) {
    for (int left = 0; left < camera.width(); left += kSquare) {
      for (int y = top; y < std::min(top + kSquare, camera.height()); ++y) {
        for (int x = left; x < std::min(left + kSquare, camera.width()); ++x) {
          if (seen(x, y)) {
            result.pixels.push_back(seen(x, y)->pixel);
            result.receivers.push_back(seen(x, y)->receiver);
          }
        }
      }
    }
  }
  return result;
}

Image<glm::vec3> litPicture(const ShadowPixels& pixels, const std::vector<float>& visibility) {
  Image<glm::vec3> picture = pixels.base;
  for (size_t i = 0; i < pixels.pixels.size(); ++i) {
    const ShadowPixel& pixel = pixels.pixels[i];
    picture[pixel.pixel] = pixel.color * (kEvenLight + kAreaLight * pixel.cosines * visibility[i]);
  }
  return picture;
}

}  // namespace ocelli
