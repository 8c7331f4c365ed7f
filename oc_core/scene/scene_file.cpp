#include "oc_core/scene/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/scene/animated_scene.h"
#include "oc_core/scene/loose_parts.h"
#include "oc_core/scene/pcd_points.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/point_mesh.h"
#include "oc_core/scene/rest_pose.h"
#include "oc_core/scene/rigged_loose_parts.h"
#include "oc_core/scene/scene_reader.h"
#include "oc_core/scene/share_vertices.h"
#include "oc_core/scene/text_points.h"
#include "oc_core/scene/texture_bake.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMaxFileBytes = 8ull << 30;

void checkFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    throw InputError("there is no such file", path.string(),
                     "check the path; built-in scenes are written builtin:NAME (see `ocelli scene list`)");
  }
  if (!fs::is_regular_file(status)) {
    throw InputError("this is not a file", path.string(), "name one scene file, for example a PLY, OBJ or glTF");
  }
  const uintmax_t bytes = fs::file_size(path, error);
  if (error || bytes == 0) {
    throw InputError("the file is empty", path.string(), "copy or export it again");
  }
  if (bytes > kMaxFileBytes) {
    throw InputError("the file is larger than 8 GiB", path.string(),
                     "reduce the mesh, or give it as PLY to ocelli scene pack, which takes more");
  }
  if (!std::ifstream(path, std::ios::binary)) {
    throw InputError("this file cannot be opened", path.string(), "check its permissions");
  }
}

/// Nothing where the textures are whole.
std::vector<std::string> warningsOf(const BakedTextures& baked, size_t maxTriangles, const fs::path& path) {
  if ((baked.halvings == 0 && !baked.isCut) || maxTriangles == 0) {
    return {};
  }
  const std::string next = maxTriangles == kMaxTextureTriangles
                               ? "they are as fine as a scene may be"
                               : "--texture-triangles full keeps as much of them as a scene may have";
  return {fmt::format(
      "{}: its textures are drawn at 1/{} of their width and height{}: whole, they add "
      "{:.0f} triangles, and {} may be added; {}",
      path.string(), 1 << baked.halvings, baked.isCut ? " and less" : "", baked.wanted, maxTriangles, next)};
}

Scene readOther(const fs::path& path, const SceneFileOptions& options, const Progress& progress) {
  SceneRecord record = readInOtherProcess(path, options.textures, progress);
  poseAtRest(record);
  const BakedTextures baked = bakeTextures(record.parts, std::move(record.textures), options.textureTriangles);
  Scene scene;
  scene.warnings = std::move(record.warnings);
  std::ranges::move(warningsOf(baked, options.textureTriangles, path), std::back_inserter(scene.warnings));
  scene.instances = std::move(record.instances);
  for (Instance& instance : scene.instances) {
    instance.isLit = !record.parts[instance.mesh].isUnlit;
  }
  scene.meshes.resize(record.parts.size());
  addLooseParts(scene, record.parts, options.points, path.string(), progress);
  for (size_t i = 0; i < record.parts.size(); ++i) {
    Mesh& mesh = scene.meshes[i];
    mesh = std::move(record.parts[i].mesh);
    // A mesh that shares its vertices has half as many of them as triangles; one that repeats them, twice to three
    // times.
    if (mesh.triangles.empty()) {
      mesh = {};
    } else if (mesh.positions.size() > mesh.triangles.size()) {
      shareVertices(mesh);
    } else {
      dropUnusedVertices(mesh);
    }
  }
  return scene;
}

void checkCount(size_t triangles, const fs::path& path) {
  if (triangles > kMaxSceneTriangles) {
    throw InputError(
        "the scene has " + std::to_string(triangles) + " triangles, more than " + std::to_string(kMaxSceneTriangles),
        path.string(), "reduce the mesh");
  }
}

/// A format of files of points.
struct PointFormat {
  bool (*isOf)(const fs::path& path);
  PointCloud (*read)(const fs::path& path);
};

constexpr std::array<PointFormat, 3> kPointFormats{
    {{isPointText, [](const fs::path& path) { return readTextPoints(path); }},
     {isPcdFile, [](const fs::path& path) { return readPcdPoints(path); }},
     {[](const fs::path& path) { return isPlyFile(path) && plyHoldsPoints(path); },
      [](const fs::path& path) { return readPlyPoints(path); }}}};

const PointFormat* pointFormatOf(const fs::path& path) {
  const auto* const found =
      std::ranges::find_if(kPointFormats, [&](const PointFormat& format) { return format.isOf(path); });
  return found == kPointFormats.end() ? nullptr : found;
}

}  // namespace

bool isPlyFile(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::array<char, 4> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return extension == ".ply" || (std::string_view(start.data(), 3) == "ply" && (start[3] == '\n' || start[3] == '\r'));
}

Scene readSceneFile(const fs::path& path, const SceneFileOptions& options, const Progress& progress) {
  checkFile(path);
  Scene scene;
  // What claims to be PLY never reaches Assimp.
  if (const PointFormat* format = pointFormatOf(path); format != nullptr) {
    PointMesh points = meshOfPoints(format->read(path), options.points, path.string(), progress);
    scene.add(std::move(points.mesh));
    scene.points = points.facts;
  } else if (isPlyFile(path)) {
    scene.add(readPly(path));
    dropUnusedVertices(scene.meshes.back());
  } else {
    scene = readOther(path, options, progress);
  }
  scene.name = path.string();
  checkCount(triangleCount(scene), path);
  return scene;
}

std::unique_ptr<MovingScene> readAnimatedFile(const fs::path& path, const SceneFileOptions& options,
                                              const std::string& animation, std::vector<std::string>& warnings,
                                              const Progress& progress) {
  checkFile(path);
  if (isPlyFile(path) || pointFormatOf(path) != nullptr) {
    return nullptr;
  }
  SceneRecord record = readInOtherProcess(path, options.textures, progress);
  if (!record.rig || record.rig->animations.empty()) {
    return nullptr;
  }
  warnings.insert(warnings.end(), record.warnings.begin(), record.warnings.end());
  warnings.insert(warnings.end(), record.rig->warnings.begin(), record.rig->warnings.end());
  const BakedTextures baked = bakeTextures(record.parts, std::move(record.textures), options.textureTriangles);
  std::ranges::move(warningsOf(baked, options.textureTriangles, path), std::back_inserter(warnings));
  const std::optional<PointFacts> points =
      addRiggedLooseParts(record, options.points, path.string(), warnings, progress);
  std::vector<RiggedMesh> meshes;
  for (TexturedMesh& part : record.parts) {
    meshes.push_back({std::move(part.mesh), std::move(part.added), part.isUnlit});
  }
  size_t triangles = 0;
  for (const Instance& instance : record.instances) {
    triangles += meshes[instance.mesh].mesh.triangles.size();
  }
  checkCount(triangles, path);
  return std::make_unique<AnimatedScene>(std::move(meshes), std::move(record.instances), std::move(*record.rig),
                                         animation, path.string(), points);
}

}  // namespace ocelli
