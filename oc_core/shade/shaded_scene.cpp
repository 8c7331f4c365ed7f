#include "oc_core/shade/shaded_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>

#include "oc_core/base/error.h"
#include "oc_core/render/raycast.h"
#include "oc_core/scene/scene.h"
#include "oc_core/shade/vertex_normals.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/placement.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

/// The triangles of one object, with the vertices that they use.
Mesh partOf(const GuidedScene& scene, uint32_t object) {
  Mesh part;
  std::vector<uint32_t> vertexOf(scene.mesh.positions.size(), 0xffffffffu);
  for (size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
    if (scene.objectOfTriangle[i] != object) {
      continue;
    }
    glm::uvec3 triangle = scene.mesh.triangles[i];
    for (int corner = 0; corner < 3; ++corner) {
      uint32_t& vertex = vertexOf[triangle[corner]];
      if (vertex == 0xffffffffu) {
        vertex = static_cast<uint32_t>(part.positions.size());
        part.positions.push_back(scene.mesh.positions[triangle[corner]]);
        part.colors.push_back(scene.mesh.color(triangle[corner]));
      }
      triangle[corner] = vertex;
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

Mesh loadedObject(const RoledObject& object, const SceneOptions& options, const Progress& progress) {
  SceneOptions own = options;
  own.fit = true;
  own.points = {};
  own.labels = {};
  own.iso.reset();
  own.transfer.clear();
  own.series.clear();
  const Mesh mesh = loadScene(object.source, own, progress);
  const std::vector<glm::mat4> places = placesOf(object);
  if (places.size() * mesh.triangles.size() > kMaxSceneTriangles) {
    throw InputError(
        "this object at all of its places has more than " + std::to_string(kMaxSceneTriangles) + " triangles",
        object.source, "give it fewer \"places\", or simplify it");
  }
  Mesh placed;
  for (const glm::mat4& place : places) {
    append(placed, mesh, place);
  }
  return placed;
}

void addSpecular(std::vector<SpecularObject>& objects, Mesh mesh, double refractiveIndex, bool isCast) {
  SpecularObject object{std::move(mesh), {}, refractiveIndex, isCast};
  object.normals = vertexNormals(object.mesh);
  objects.push_back(std::move(object));
}

/// From the middle of what sends rays towards the cast objects, 90 degrees high. Nothing where they have one middle.
std::optional<View> viewTowards(const Mesh& cast, const Box& senders) {
  View view;
  view.eye = senders.center();
  view.target = boundsOf(cast).center();
  const glm::vec3 way = view.target - view.eye;
  if (!(glm::length(way) > 0)) {
    return std::nullopt;
  }
  view.up = std::abs(way.y) > 0.95f * glm::length(way) ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  view.zNear = 1e-3f * glm::length(way);
  view.fovVerticalDegrees = 90;
  return view;
}

}  // namespace

std::string rolesFileBeside(const std::string& source) {
  return fs::path(source).replace_extension(".roles.json").string();
}

std::vector<RoledObject> rolesFor(const std::string& source, const std::string& rolesFile, bool needed) {
  if (!rolesFile.empty()) {
    return readObjectRoles(rolesFile);
  }
  if (isBuiltinScene(source)) {
    const std::vector<RoledObject>& roles = builtinRoles(source);
    if (roles.empty() && needed) {
      throw InputError("nothing says which objects of this scene mirror, refract or cast", source,
                       "give --roles FILE.json, or take builtin:mirror or builtin:lens");
    }
    return roles;
  }
  const std::string beside = rolesFileBeside(source);
  std::error_code ignored;
  if (!fs::exists(beside, ignored)) {
    if (!needed) {
      return {};
    }
    throw InputError("nothing says which objects of this scene mirror, refract or cast", source,
                     "give --roles FILE.json, or put " + beside + " beside it");
  }
  return readObjectRoles(beside);
}

ShadedScene loadShadedScene(const std::string& source, const std::vector<RoledObject>& roles,
                            const SceneOptions& options, const Progress& progress) {
  const GuidedScene scene = loadGuidedScene(source, options, progress);
  std::map<uint32_t, RoledObject> roleOf;
  for (const uint32_t object : scene.objectOfTriangle) {
    roleOf.try_emplace(object, RoledObject{.object = object});
  }
  std::vector<std::pair<RoledObject, Mesh>> objects;
  for (const RoledObject& role : roles) {
    if (role.light) {
      objects.emplace_back(role, panelOf(*role.light));
    } else if (!role.source.empty()) {
      objects.emplace_back(role, loadedObject(role, options, progress));
    } else if (const auto found = roleOf.find(role.object); found != roleOf.end()) {
      found->second = role;
    } else {
      throw InputError("this scene has no object " + std::to_string(role.object), source,
                       "its objects are numbered from 0 to " +
                           std::to_string(roleOf.empty() ? 0 : roleOf.rbegin()->first) + "; 0 is its structure");
    }
  }
  for (const auto& [object, role] : roleOf) {
    objects.emplace_back(role, partOf(scene, object));
  }
  ShadedScene shaded;
  shaded.source = source;
  shaded.whole.guides = scene.guides;
  shaded.whole.worldFromScene = scene.worldFromScene;
  uint32_t nextIdentity = roleOf.empty() ? 1 : roleOf.rbegin()->first + 1;
  std::array<std::vector<uint8_t>, 3> receives;
  const std::array<Mesh*, 3> parts{&shaded.cast, &shaded.billboards, &shaded.surroundings};
  for (auto& [role, mesh] : objects) {
    if (role.has(kShines)) {
      shaded.lights.push_back(role.light ? *role.light : areaLightOfPanel(mesh, source));
    }
    append(shaded.whole.mesh, mesh);
    const uint32_t identity = role.source.empty() && !role.light ? role.object : nextIdentity++;
    shaded.whole.objectOfTriangle.resize(shaded.whole.mesh.triangles.size(), identity);
    shaded.rolesOfTriangle.resize(shaded.whole.mesh.triangles.size(), role.roles);
    if (role.has(kMirrors)) {
      addSpecular(shaded.mirrors, std::move(mesh), 1, role.has(kCasts));
    } else if (role.has(kRefracts)) {
      addSpecular(shaded.lenses, std::move(mesh), role.refractiveIndex, false);
    } else {
      const size_t part = role.has(kIsBillboard) ? 1 : role.has(kCasts) ? 0 : 2;
      append(*parts[part], mesh);
      receives[part].resize(parts[part]->triangles.size(), role.has(kReceives) ? 1 : 0);
    }
  }
  for (const std::vector<uint8_t>& each : receives) {
    shaded.receives.insert(shaded.receives.end(), each.begin(), each.end());
  }
  if (std::any_of(roles.begin(), roles.end(), [](const RoledObject& role) { return role.has(kIsRelief); })) {
    shaded.tiled = std::make_shared<TiledScene>(loadTiledScene(source, roles, scene.worldFromScene, options, progress));
  }
  return shaded;
}

void requireCast(const ShadedScene& scene) {
  if (scene.cast.empty()) {
    throw InputError("no object of this scene has the role \"cast\": there is nothing for a depth image to stand for",
                     scene.source, "give one that role with --roles FILE.json");
  }
}

View viewAround(View view, const Box& box, double proportions) {
  constexpr double kRoomAround = 1.04;
  constexpr double kMinTangent = 1e-3;  // of a box that is a point
  const PinholeCamera camera(view, 16, 16);
  double tangent = kMinTangent;
  for (const glm::vec3& corner : cornersOf(box)) {
    const glm::dvec3 p(camera.cameraFromWorld(corner));
    tangent = std::max(tangent, std::max(std::abs(p.y), std::abs(p.x) / proportions) / p.z);
  }
  view.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(std::min(tangent * kRoomAround, 1.0)));
  return view;
}

View pictureView(const Box& senders) {
  constexpr double kMargin = 1.05;
  View view;
  view.target = senders.center();
  const auto distance = static_cast<double>(glm::distance(view.eye, view.target));
  const double radius = kMargin * static_cast<double>(glm::length(senders.size())) / 2;
  view.fovVerticalDegrees = 2 * degreesFromRadians(std::atan(std::min(radius / distance, 1.0)));
  return view;
}

std::optional<View> planeView(const Mesh& cast, const Box& senders, int width, int height) {
  std::optional<View> view = viewTowards(cast, senders);
  if (!view) {
    return view;
  }
  const PinholeCamera wide(*view, width, height);
  constexpr double kMargin = 1.04;
  constexpr double kMaxTangent = 4;  // 152 degrees
  double tangent = 0;
  for (const glm::uvec3& triangle : cast.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3 p(wide.cameraFromWorld(cast.positions[triangle[corner]]));
      const double aside = std::max(std::abs(p.y), std::abs(p.x) * height / width);
      tangent = std::max(tangent, p.z > static_cast<double>(view->zNear) ? aside / p.z : 2 * kMaxTangent);
    }
  }
  if (tangent * kMargin > kMaxTangent) {
    return std::nullopt;
  }
  view->fovVerticalDegrees = 2 * degreesFromRadians(std::atan(tangent * kMargin));
  return view;
}

View referenceView(const Mesh& cast, const Box& senders, int width, int height, WhatLiesAround around) {
  if (const std::optional<View> view = planeView(cast, senders, width, height)) {
    return *view;
  }
  std::optional<View> view = viewTowards(cast, senders);
  if (!view) {
    throw InputError("the objects that are cast stand around what mirrors or refracts", "the roles",
                     "move them apart, or give objects on the other side the role \"billboard\"");
  }
  if (around == WhatLiesAround::kIsAnError) {
    throw InputError("the objects that are cast reach around what mirrors or refracts: no image plane holds them",
                     "the roles", "give those beside and behind it another role, such as \"billboard\"");
  }
  constexpr double kWideTangent = 1.2;  // 100 degrees
  view->fovVerticalDegrees = 2 * degreesFromRadians(std::atan(kWideTangent));
  return *view;
}

View aroundView(const Mesh& cast, const Box& senders) {
  View view;
  view.eye = senders.center();
  view.target = view.eye + glm::vec3(0, 0, 1);
  view.zNear = 1e-3f * glm::length(boundsOf(cast).size());
  view.fovVerticalDegrees = 90;
  return view;
}

View unhiddenView(const View& view, const ShadedScene& scene, const Box& senders) {
  constexpr int kSteps = 5;
  constexpr double kStepDegrees = 15;
  Mesh others;
  for (const Mesh* part : {&scene.cast, &scene.billboards, &scene.surroundings}) {
    append(others, *part);
  }
  const RayScene rays(others);
  std::vector<glm::vec3> points{senders.center()};
  for (const glm::vec3& corner : cornersOf(senders)) {
    points.push_back(glm::mix(senders.center(), corner, 0.5f));
  }
  const glm::vec3 away = view.eye - view.target;
  const float level = glm::length(glm::vec2(away.x, away.z));
  const glm::vec3 heading = level > 0 ? glm::vec3(away.x, 0, away.z) / level : glm::vec3(0, 0, 1);
  for (int step = 0; step <= kSteps; ++step) {
    const auto angle = static_cast<float>(radiansFromDegrees(kStepDegrees * step));
    View raised = view;
    if (step > 0) {
      raised.eye = view.target + glm::length(away) * (heading * std::cos(angle) + glm::vec3(0, std::sin(angle), 0));
    }
    const auto hidden = std::count_if(points.begin(), points.end(), [&](const glm::vec3& point) {
      return rays.hit({raised.eye, point}).has_value();
    });
    const auto count = static_cast<size_t>(hidden);
    if (step == 0 ? count < points.size() : 2 * count <= points.size()) {
      return raised;
    }
  }
  return view;
}

Box boundsOf(const std::vector<SpecularObject>& objects) {
  Box box;
  for (const SpecularObject& object : objects) {
    const Box own = boundsOf(object.mesh);
    if (!own.empty()) {
      box.add(own.lower);
      box.add(own.upper);
    }
  }
  return box;
}

}  // namespace ocelli
