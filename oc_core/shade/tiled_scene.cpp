#include "oc_core/shade/tiled_scene.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <map>

#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/worlds/labelled_scene.h"
#include "oc_core/worlds/packed_source.h"
#include "oc_core/worlds/placement.h"

namespace ocelli {
namespace {

Scene unlitScene(const std::string& source, const SceneOptions& options, const Progress& progress) {
  if (isPackedScene(source)) {
    throw InputError("a packed scene is one object with its light, and has no relief tiles", source,
                     "give the file that it was packed from, or another role than \"relief\"");
  }
  if (isVolumeSource(source)) {
    throw InputError("the surface of a volume is one object, and has no relief tiles", source,
                     "write it with ocelli scene export, or give another role than \"relief\"");
  }
  if (options.motion.seconds) {
    throw InputError("a scene that moves has no relief tiles", source, "leave out --time, or the role \"relief\"");
  }
  return readLabelledScene(source, options, progress);
}

bool isRelief(const std::vector<RoledObject>& roles, uint32_t object) {
  for (const RoledObject& role : roles) {
    if (role.source.empty() && !role.light && role.object == object) {
      return role.has(kIsRelief);
    }
  }
  return false;
}

}  // namespace

Mesh TiledScene::flatTiles() const {
  Mesh flat;
  for (const Tile& tile : tiles) {
    Mesh tinted = objects[tile.object];
    tinted.colors.resize(tinted.positions.size(), glm::vec3(1));
    for (glm::vec3& color : tinted.colors) {
      color *= tile.tint;
    }
    append(flat, tinted, tile.worldFromTile);
  }
  return flat;
}

TiledScene loadTiledScene(const std::string& source, const std::vector<RoledObject>& roles,
                          const glm::mat4& worldFromScene, const SceneOptions& options, const Progress& progress) {
  TiledScene tiled;
  const Scene scene = unlitScene(source, options, progress);
  struct Fitted {
    size_t object = 0;
    glm::mat4 meshFromTile{1};
  };
  std::map<size_t, Fitted> fittedMesh;
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (!isRelief(roles, instance.object)) {
      append(tiled.around, flattenInstance(scene, i), worldFromScene);
      continue;
    }
    if (scene.meshes[instance.mesh].empty()) {
      continue;
    }
    auto [found, isNew] = fittedMesh.try_emplace(instance.mesh);
    if (isNew) {
      Mesh mesh = scene.meshes[instance.mesh];
      const glm::mat4 tileFromMesh = unitFromWorld(mesh, source);
      transform(mesh, tileFromMesh);
      found->second = {tiled.objects.size(), glm::inverse(tileFromMesh)};
      tiled.objects.push_back(std::move(mesh));
    }
    tiled.tiles.push_back(
        {found->second.object, worldFromScene * instance.worldFromMesh * found->second.meshFromTile, instance.tint});
  }
  std::map<std::string, size_t> objectOfSource;
  for (const RoledObject& role : roles) {
    if (role.source.empty()) {
      continue;
    }
    SceneOptions own = options;
    own.fit = true;
    own.points = {};
    own.labels = {};
    own.shading = Shading::kNone;
    if (!role.has(kIsRelief)) {
      append(tiled.around, loadScene(role.source, own, progress), placesOf(role)[0]);
      continue;
    }
    const auto [found, isNew] = objectOfSource.try_emplace(role.source, tiled.objects.size());
    if (isNew) {
      tiled.objects.push_back(loadScene(role.source, own, progress));
    }
    for (const glm::mat4& place : placesOf(role)) {
      tiled.tiles.push_back({found->second, place});
    }
  }
  return tiled;
}

std::vector<glm::mat4> placesOf(const RoledObject& object) {
  const glm::vec3 size(static_cast<float>(object.radius));
  std::vector<glm::mat4> places;
  for (const glm::dvec4& place : object.places) {
    places.push_back(glm::scale(placedAt(glm::vec3(place), place.w), size));
  }
  if (places.empty()) {
    places.push_back(glm::scale(placedAt(object.center, object.turnDegrees), size));
  }
  return places;
}

}  // namespace ocelli
