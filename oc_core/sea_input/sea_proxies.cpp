#include "oc_core/sea_input/sea_proxies.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <glm/common.hpp>

#include "oc_core/base/error.h"
#include "oc_core/ocri/simplified_mesh.h"
#include "oc_core/sea_input/depth_proxy.h"
#include "oc_core/worlds/scene_source.h"

namespace ocelli {
namespace {

Mesh noProxy(const ProxyInput& /*input*/) {
  return {};
}

Mesh sceneProxy(const ProxyInput& input) {
  if (input.scene == nullptr) {
    throw InputError("images in a folder have no scene to make a proxy of", "--proxy scene",
                     "give a mesh, box or none");
  }
  // Colours would keep vertices apart that stand at one place.
  const Mesh bare{input.scene->positions, {}, input.scene->triangles, input.scene->isPart};
  return simplifyMesh(bare, input.triangles, SimplifyMethod::kTopological).mesh;
}

Mesh boxProxy(const ProxyInput& input) {
  if (input.scene != nullptr) {
    const Box box = boundsOf(*input.scene);
    return boxAround({glm::dvec3(box.lower), glm::dvec3(box.upper)}, {});
  }
  if (input.points.empty()) {
    throw InputError("nothing is known of the surfaces around these images", "--proxy box",
                     "give a mesh of a dozen polygons, or none; COLMAP's points3D.txt would do");
  }
  return boxAround(input.positions, input.points);
}

Mesh depthProxy(const ProxyInput& input) {
  if (input.folder.empty()) {
    throw InputError("images that are rendered have no depth images beside them", "--proxy depth", "give scene");
  }
  return proxyOfDepths(input.folder / kDepthFolder, input.triangles);
}

constexpr std::array kProxyKinds{
    ProxyKind{"none", "everything is far away", noProxy}, ProxyKind{"scene", "the scene, simplified", sceneProxy},
    ProxyKind{"box", "a box around the scene, or around the positions and the points that are known", boxProxy},
    ProxyKind{"depth", "of the views with depth in the folder \"depth\" of the images' folder", depthProxy}};

}  // namespace

std::span<const ProxyKind> proxyKinds() {
  return kProxyKinds;
}

Mesh boxAround(const std::vector<glm::dvec3>& positions, const std::vector<glm::dvec3>& points) {
  Box box;
  for (const glm::dvec3& position : positions) {
    box.add(glm::vec3(position));
  }
  if (!points.empty()) {
    constexpr double kLeftOut = 0.02;
    glm::vec3 lower;
    glm::vec3 upper;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const glm::dvec3& point : points) {
        values.push_back(point[axis]);
      }
      std::sort(values.begin(), values.end());
      const auto last = static_cast<double>(values.size() - 1);
      lower[axis] = static_cast<float>(values[static_cast<size_t>(kLeftOut * last)]);
      upper[axis] = static_cast<float>(values[static_cast<size_t>((1 - kLeftOut) * last)]);
    }
    box.add(lower);
    box.add(upper);
  }
  // Nobody stands in a wall.
  const glm::vec3 margin = glm::max((box.upper - box.lower) * 0.01f, glm::vec3(1e-4f));
  const glm::vec3 lower = box.lower - margin;
  const glm::vec3 upper = box.upper + margin;
  Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.positions.emplace_back((i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                                (i & 4) != 0 ? upper.z : lower.z);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

Mesh makeSeaProxy(const std::string& nameOrFile, const ProxyInput& input) {
  std::string known;
  for (const ProxyKind& kind : kProxyKinds) {
    if (nameOrFile == kind.name) {
      return kind.make(input);
    }
    known += std::string(known.empty() ? "" : ", ") + kind.name;
  }
  std::error_code ignored;
  if (!std::filesystem::exists(nameOrFile, ignored) && !nameOrFile.starts_with("builtin:")) {
    throw InputError("there is no such proxy", nameOrFile, "give the file of a mesh, or one of " + known);
  }
  return loadScene(nameOrFile, {.fit = false, .shading = Shading::kNone, .textures = false});
}

}  // namespace ocelli
