#include "display_driver/pacing/series_source.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "display_sim/slicing/display_bounds.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/scene/scene.h"

namespace ocelli {
namespace {

/// The digits at the end; nullopt where there are none, or so many that they are no number.
std::optional<uint64_t> numberAtEnd(const std::string& name) {
  size_t begin = name.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) {
    --begin;
  }
  const std::string digits = name.substr(begin);
  if (digits.empty() || digits.size() > 18) {
    return std::nullopt;
  }
  return std::stoull(digits);
}

/// What fits all of them.
glm::mat4 unitFromSeries(const std::vector<Mesh>& meshes, const std::string& where) {
  Mesh points;
  for (const Mesh& mesh : meshes) {
    points.positions.insert(points.positions.end(), mesh.positions.begin(), mesh.positions.end());
  }
  return unitFromWorld(points, where);
}

}  // namespace

std::vector<std::filesystem::path> numberedFiles(const std::filesystem::path& folder, const std::string& ending) {
  std::error_code error;
  std::map<uint64_t, std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ending) {
      continue;
    }
    const auto number = numberAtEnd(entry.path().stem().string());
    if (number && !files.emplace(*number, entry.path()).second) {
      throw InputError("two files have the same number", entry.path().string(), "number them one after the other");
    }
  }
  if (error) {
    throw InputError("this folder cannot be read: " + error.message(), folder.string(), "give another one");
  }
  if (files.empty()) {
    throw InputError("there is no numbered " + ending + " file in this folder", folder.string(),
                     "name them like walk_1" + ending + ", walk_2" + ending);
  }
  std::vector<std::filesystem::path> ordered;
  for (auto& [number, path] : files) {
    ordered.push_back(std::move(path));
  }
  return ordered;
}

SeriesSource::SeriesSource(const std::vector<std::filesystem::path>& files, const SceneOptions& scene,
                           const DisplayProfile& profile, const SliceOptions& options, double meshesPerSecond,
                           bool loop, const Progress& progress)
    : slicer_(profile, options), meshesPerSecond_(meshesPerSecond), loop_(loop) {
  OC_CHECK(!files.empty() && meshesPerSecond > 0, "a series has meshes and a rate");
  SceneOptions asItIs = scene;
  asItIs.fit = false;
  std::vector<Mesh> meshes;
  for (const std::filesystem::path& file : files) {
    report(progress, "loading the series", static_cast<double>(meshes.size()) / static_cast<double>(files.size()));
    meshes.push_back(loadScene(file.string(), asItIs));
  }
  const glm::mat4 unit = scene.fit ? unitFromSeries(meshes, files.front().string()) : glm::mat4(1);
  for (Mesh& mesh : meshes) {
    transform(mesh, unit);
    cutOff_ = cutOff_ || !liesWithin(mesh, profile);
    meshes_.emplace_back(mesh);
    mesh = {};
  }
}

SourcedVolume SeriesSource::volumeFor(HostTime seen) {
  if (!start_) {
    start_ = seen;
  }
  const double number = std::floor(std::chrono::duration<double>(seen - *start_).count() * meshesPerSecond_);
  auto mesh = static_cast<size_t>(std::max(0.0, number));
  if (mesh >= meshes_.size() && !loop_) {
    return {};
  }
  mesh %= meshes_.size();
  if (mesh == mesh_) {
    return {.kind = SourcedVolume::Kind::kSame};
  }
  mesh_ = mesh;
  slicer_.slice(meshes_[mesh]);
  return {.kind = SourcedVolume::Kind::kNew, .volume = slicer_.takeShared()};
}

}  // namespace ocelli
