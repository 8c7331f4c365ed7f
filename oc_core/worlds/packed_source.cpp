#include "oc_core/worlds/packed_source.h"

#include <fmt/format.h>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/json_document.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/mapped_file.h"
#include "oc_core/base/sha256.h"
#include "oc_core/pack/cluster_cut.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/scene_file.h"
#include "oc_core/scene/shading.h"
#include "oc_core/volume/volume_scene.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/labelled_scene.h"
#include "oc_core/worlds/streamed_ply.h"

namespace ocelli {
namespace {

const char* nameOf(Shading shading) {
  return shading == Shading::kLambert ? "lambert" : "none";
}

/// The copies of a scene one after the other, as they stand in the mesh that loadScene() gives.
class CopiesSource final : public TriangleSource {
 public:
  CopiesSource(Scene scene, const SceneOptions& options, std::string where)
      : scene_(std::move(scene)), shading_(options.shading), where_(std::move(where)) {
    Box box;
    forEachCopy([&](const Mesh& copy, const Instance& /*instance*/) {
      const Box one = boundsOf(copy);
      box.lower = glm::min(box.lower, one.lower);
      box.upper = glm::max(box.upper, one.upper);
    });
    if (options.fit) {
      const glm::dvec3 center = (glm::dvec3(box.lower) + glm::dvec3(box.upper)) * 0.5;
      double reach = 0;
      forEachCopy(
          [&](const Mesh& copy, const Instance& /*instance*/) { reach = std::max(reach, reachOf(copy, center)); });
      worldFromScene_ = unitFromSphere(center, reach, where_);
    }
  }

  void forEachPart(const std::function<void(const Mesh& part)>& visit) const override {
    forEachCopy([&](Mesh& copy, const Instance& instance) {
      transform(copy, worldFromScene_);
      if (shading_ == Shading::kLambert && instance.isLit) {
        bakeLambert(copy);
      }
      visit(copy);
    });
  }

 private:
  template <class Visit>
  void forEachCopy(const Visit& visit) const {
    for (size_t i = 0; i < scene_.instances.size(); ++i) {
      Mesh copy = flattenInstance(scene_, i);
      if (!copy.empty()) {
        validate(copy, where_);
        visit(copy, scene_.instances[i]);
      }
    }
  }

  Scene scene_;
  Shading shading_;
  std::string where_;
  glm::mat4 worldFromScene_{1};
};

template <class T>
std::string digestOf(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  return sha256({reinterpret_cast<const uint8_t*>(values.data()), values.size() * sizeof(T)});
}

/// What tells that a scene is the same as in an earlier job: all that the packed file depends on, but its triangles.
std::string sourceKeyOf(const SceneOptions& options, const std::string& description) {
  // What this says of how scenes are packed changes with that.
  return fmt::format("packing 4 {} fit={} shading={}", description, options.fit, nameOf(options.shading));
}

std::string sourceKeyOf(const Scene& scene, const SceneOptions& options, const std::string& description) {
  std::string key = sourceKeyOf(options, description);
  for (const Mesh& mesh : scene.meshes) {
    key += "\n" + digestOf(mesh.positions) + digestOf(mesh.colors) + digestOf(mesh.triangles);
  }
  for (const Instance& instance : scene.instances) {
    const std::vector<glm::mat4> place{instance.worldFromMesh};
    key += fmt::format("\n{} {} {} {} {}{}", instance.mesh, digestOf(place), instance.tint.r, instance.tint.g,
                       instance.tint.b, instance.isLit ? "" : " unlit");
  }
  return key;
}

/// Whether it has more triangles than fit into memory as one mesh, and can be read without one.
bool isStreamed(const std::string& source) {
  std::error_code noFile;
  return !isBuiltinScene(source) && std::filesystem::is_regular_file(source, noFile) && isPlyFile(source) &&
         plyFaceCount(source) > kMaxSceneTriangles;
}

PackReport packStreamed(const std::string& source, const SceneOptions& options, const std::string& description,
                        const std::filesystem::path& path, const Progress& progress) {
  refuseLabels(options.labels, "a scene larger than memory", "leave them out");
  report(progress, "looking at the file", 0);
  const std::string key = sourceKeyOf(options, description) + " streamed " + sha256(MappedFile(source).bytes());
  const StreamedPly triangles(source, options, path.parent_path(), progress);
  return packScene(triangles, path, {.description = description, .sourceKey = key}, progress);
}

}  // namespace

bool isPackedScene(const std::string& source) {
  return !isBuiltinScene(source) && source.ends_with(".opack");
}

PackReport packSource(const std::string& source, const SceneOptions& options, const std::filesystem::path& path,
                      const Progress& progress) {
  if (isPackedScene(source)) {
    throw InputError("this scene is packed already", source, "copy the file");
  }
  if (options.motion.seconds) {
    throw InputError("a moment of a moving scene is not packed", source, "write it with ocelli scene export first");
  }
  requireSurfaceOfVolume(source, options);
  const std::string description =
      textOfJson({{"scene", source}, {"fit", options.fit}, {"shading", nameOf(options.shading)}});
  if (isStreamed(source)) {
    return packStreamed(source, options, description, path, progress);
  }
  report(progress, "loading the scene", 0);
  if (isVolumeSource(source)) {
    Scene scene;
    scene.name = source;
    // Shaded and fitted as the volume is: no part of the mesh knows its gradient, or the volume's box, later on.
    scene.add(loadVolumeSurface(source, options, progress).mesh);
    const SceneOptions done{.fit = false, .shading = Shading::kNone};
    const std::string key = sourceKeyOf(scene, options, description);
    return packScene(CopiesSource(std::move(scene), done, source), path, {.description = description, .sourceKey = key},
                     progress);
  }
  Scene scene = readLabelledScene(source, options, progress);
  refuseUnusedPoints(scene.points, options);
  for (const std::string& warning : scene.warnings) {
    if (options.warn) {
      options.warn(warning);
    }
  }
  const std::string key = sourceKeyOf(scene, options, description);
  const CopiesSource copies(std::move(scene), options, source);
  return packScene(copies, path, {.description = description, .sourceKey = key}, progress);
}

PackedOrigin originOf(const PackedScene& scene) {
  const JsonDocument description(scene.description(), scene.path().string());
  JsonFields fields(description, UnknownFields::kIgnored);
  return {fields.text("scene", ""), fields.boolean("fit", false), fields.text("shading", nameOf(Shading::kNone))};
}

PackedScene openPacked(const std::string& source, const SceneOptions& options) {
  PackedScene scene(source);
  const PackedOrigin origin = originOf(scene);
  if (!options.fit && origin.fit) {
    throw InputError("this scene was fitted when it was packed", source, "pack it with --no-fit");
  }
  if (origin.shading != nameOf(options.shading) && options.shading != Shading::kLambert) {
    throw InputError("this scene was shaded when it was packed", source, "pack it with --shading none");
  }
  return scene;
}

Mesh unpackedMesh(const PackedScene& scene) {
  if (scene.triangleCount() > kMaxSceneTriangles) {
    throw InputError(fmt::format("this scene has {} triangles, more than the {} that this command takes at once",
                                 scene.triangleCount(), kMaxSceneTriangles),
                     scene.path().string(), "use a command that reads packed scenes level by level");
  }
  const std::vector<ClusterChoice> all = allClusters(scene);
  uint64_t triangles = 0;
  for (const ClusterChoice& choice : all) {
    triangles += scene.cluster(choice.group, choice.cluster).triangles;
  }
  if (triangles > scene.triangleCount()) {
    throw InputError("this packed scene is damaged: it holds more triangles than its end says", scene.path().string(),
                     "pack the scene again");
  }
  return weldedMeshOf(scene, all);
}

}  // namespace ocelli
