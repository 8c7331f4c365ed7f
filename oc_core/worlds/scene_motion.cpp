#include "oc_core/worlds/scene_motion.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/scene/mesh_series.h"
#include "oc_core/scene/scene.h"
#include "oc_core/scene/scene_file.h"
#include "oc_core/worlds/builtin_scenes.h"
#include "oc_core/worlds/labelled_scene.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kAnimatedEndings{".gltf", ".glb", ".fbx", ".dae", ".bvh"};
constexpr size_t kMotionVerticesPerRange = 1 << 14;

bool isFolder(const std::string& source) {
  std::error_code ignored;
  return fs::is_directory(source, ignored);
}

bool isAnimatedFormat(const std::string& source) {
  std::string ending = fs::path(source).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(kAnimatedEndings, ending) != kAnimatedEndings.end();
}

void tell(const SceneOptions& options, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (options.warn) {
      options.warn(warning);
    }
  }
}

std::unique_ptr<MovingScene> readSeries(const std::string& folder, const SceneOptions& options,
                                        const Progress& progress) {
  const std::vector<fs::path> files = numberedFiles(folder, meshEndingIn(folder));
  std::vector<Mesh> meshes;
  for (const fs::path& file : files) {
    report(progress, "loading the series", static_cast<double>(meshes.size()) / static_cast<double>(files.size()));
    const Scene scene = readSceneFile(file, fileOptionsOf(options), progress);
    refuseUnusedPoints(scene.points, options);
    tell(options, scene.warnings);
    meshes.push_back(flatten(scene));
    validate(meshes.back(), file.string());
  }
  const SeriesOptions defaults;
  return std::make_unique<MeshSeries>(
      std::move(meshes),
      SeriesOptions{options.motion.meshesPerSecond.value_or(defaults.meshesPerSecond), options.motion.between});
}

std::unique_ptr<MovingScene> openMotion(const std::string& source, const SceneOptions& options,
                                        const Progress& progress) {
  if (isFolder(source)) {
    return readSeries(source, options, progress);
  }
  if (isBuiltinScene(source)) {
    refuseUnusedPoints({}, options);
    return makeBuiltinMotion(source);
  }
  std::vector<std::string> warnings;
  std::unique_ptr<MovingScene> scene =
      readAnimatedFile(source, fileOptionsOf(options), options.motion.animation, warnings, progress);
  if (scene != nullptr) {
    refuseUnusedPoints(scene->facts().points, options);
  }
  tell(options, warnings);
  return scene;
}

}  // namespace

SceneMotion::SceneMotion(std::unique_ptr<MovingScene> scene, const SceneOptions& options, const std::string& where)
    : scene_(std::move(scene)), shadingKind_(options.shading) {
  if (options.fit) {
    worldFromScene_ = unitFromMotion(*scene_, where);
  }
}

SceneMotion::Topology& SceneMotion::prepare() {
  const auto [slot, isNew] = topologies_.try_emplace(raw_.topology);
  Topology& topology = slot->second;
  if (!isNew) {
    return topology;
  }
  // The creases are those of its first time, whatever time is asked for first.
  MovedMesh first;
  for (const double time : scene_->sampleTimes()) {
    scene_->moveTo(time, first);
    if (first.topology == raw_.topology) {
      break;
    }
  }
  OC_CHECK(first.topology == raw_.topology, "the sample times of a motion show all of its topologies");
  transform(first.mesh, worldFromScene_);
  switch (shadingKind_) {
    case Shading::kLambert:
      topology.shading = std::make_unique<VertexShading>(first.mesh);
      topology.sources = topology.shading->sources();
      break;
    case Shading::kNone:
      for (uint32_t i = 0; i < first.mesh.positions.size(); ++i) {
        topology.sources.push_back(i);
      }
      break;
  }
  topology.triangles = std::move(first.mesh.triangles);
  for (size_t i = 0; !first.unlit.empty() && i < topology.sources.size(); ++i) {
    topology.unlit.push_back(first.unlit[topology.sources[i]]);
  }
  return topology;
}

const Mesh& SceneMotion::at(double seconds) {
  const uint64_t before = raw_.shape;
  scene_->moveTo(seconds, raw_);
  if (topology_ == raw_.topology && before == raw_.shape) {
    return mesh_;
  }
  Topology& topology = prepare();
  const bool newTopology = std::exchange(topology_, raw_.topology) != raw_.topology;
  if (newTopology) {
    mesh_.triangles = topology.triangles;
  }
  const size_t vertices = topology.sources.size();
  mesh_.positions.resize(vertices);
  // A uniform scale and a translation, as unitFromMotion() makes them, or neither.
  const float scale = worldFromScene_[0][0];
  const glm::vec3 shift(worldFromScene_[3]);
  parallelFor(vertices, kMotionVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      mesh_.positions[i] = raw_.mesh.positions[topology.sources[i]] * scale + shift;
    }
  });
  if (std::exchange(coloring_, raw_.coloring) != raw_.coloring || newTopology) {
    const bool colored = !raw_.mesh.colors.empty();
    unshaded_.resize(colored ? vertices : 0);
    parallelFor(unshaded_.size(), kMotionVerticesPerRange, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        unshaded_[i] = raw_.mesh.colors[topology.sources[i]];
      }
    });
    if (topology.shading == nullptr) {
      mesh_.colors = unshaded_;
    }
  }
  if (topology.shading != nullptr) {
    topology.shading->shade(mesh_, unshaded_, topology.unlit);
  }
  return mesh_;
}

bool mayMove(const std::string& source) {
  return isFolder(source) || (isBuiltinScene(source) ? isMovingBuiltin(source) : isAnimatedFormat(source));
}

std::unique_ptr<SceneMotion> loadMotion(const std::string& source, const SceneOptions& options,
                                        const Progress& progress) {
  if (!mayMove(source)) {
    return nullptr;
  }
  if (options.motion.meshesPerSecond && !isFolder(source)) {
    throw InputError("only a folder of meshes has a rate of its own", "--rate", "leave it out");
  }
  if (!options.motion.animation.empty() && !isAnimatedFormat(source)) {
    throw InputError("only a file has animations of its own", "--animation", "leave it out");
  }
  report(progress, "loading the scene", 0);
  std::unique_ptr<MovingScene> scene = withLabels(openMotion(source, options, progress), options.labels);
  if (scene == nullptr) {
    return nullptr;
  }
  auto motion = std::make_unique<SceneMotion>(std::move(scene), options, source);
  report(progress, "loading the scene", 1);
  return motion;
}

}  // namespace ocelli
