#include "oc_core/scene/mesh_series.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 12> kMeshEndings{".ply", ".obj", ".stl", ".off", ".gltf", ".glb",
                                                        ".fbx", ".dae", ".3ds", ".xyz", ".pts",  ".pcd"};
constexpr size_t kSeriesVerticesPerRange = 1 << 14;

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

[[noreturn]] void failFolder(const fs::path& folder, const std::error_code& error) {
  throw InputError("this folder cannot be read: " + error.message(), folder.string(), "give another one");
}

/// `to` becomes the list that is `share` of the way from `a` to `b`.
void blend(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b, float share, std::vector<glm::vec3>& to) {
  to.resize(a.size());
  parallelFor(a.size(), kSeriesVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      to[i] = glm::mix(a[i], b[i], share);
    }
  });
}

}  // namespace

std::vector<fs::path> numberedFiles(const fs::path& folder, const std::string& ending) {
  std::error_code error;
  std::map<uint64_t, fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ending) {
      continue;
    }
    const auto number = numberAtEnd(entry.path().stem().string());
    if (number && !files.emplace(*number, entry.path()).second) {
      throw InputError("two files have the same number", entry.path().string(), "number them one after the other");
    }
  }
  if (error) {
    failFolder(folder, error);
  }
  if (files.empty()) {
    throw InputError("there is no numbered " + ending + " file in this folder", folder.string(),
                     "name them like walk_1" + ending + ", walk_2" + ending);
  }
  std::vector<fs::path> ordered;
  for (auto& [number, path] : files) {
    ordered.push_back(std::move(path));
  }
  return ordered;
}

std::string meshEndingIn(const fs::path& folder) {
  std::error_code error;
  std::string found;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string ending = entry.path().extension().string();
    if (std::ranges::find(kMeshEndings, ending) == kMeshEndings.end() || !numberAtEnd(entry.path().stem().string())) {
      continue;
    }
    if (!found.empty() && ending != found) {
      const auto [first, second] = std::minmax(found, ending);
      throw InputError("this folder holds numbered meshes that end in " + first + " and in " + second, folder.string(),
                       "leave one kind of them in it");
    }
    found = ending;
  }
  if (error) {
    failFolder(folder, error);
  }
  if (found.empty()) {
    throw InputError("there is no numbered mesh in this folder", folder.string(),
                     "name them like walk_1.ply, walk_2.ply");
  }
  return found;
}

MeshSeries::MeshSeries(std::vector<Mesh> meshes, const SeriesOptions& options) : options_(options) {
  OC_CHECK(!meshes.empty() && options.meshesPerSecond > 0, "a series has meshes and a rate");
  const auto sameTopology = [&](const Mesh& mesh, size_t frame) {
    return mesh.positions.size() == frames_[frame].positions.size() &&
           mesh.colors.size() == frames_[frame].colors.size() && mesh.triangles == topologies_[frames_[frame].topology];
  };
  std::vector<size_t> firstFrames;  // of each topology
  for (Mesh& mesh : meshes) {
    const auto known = std::ranges::find_if(firstFrames, [&](size_t frame) { return sameTopology(mesh, frame); }) -
                       firstFrames.begin();
    const auto topology = static_cast<size_t>(known);
    if (topology == firstFrames.size()) {
      firstFrames.push_back(frames_.size());
      topologies_.push_back(std::move(mesh.triangles));
    }
    frames_.push_back({std::move(mesh.positions), std::move(mesh.colors), topology});
    mesh = {};
  }
}

double MeshSeries::durationSeconds() const {
  return static_cast<double>(frames_.size()) / options_.meshesPerSecond;
}

MotionFacts MeshSeries::facts() const {
  return {.animations = {}, .meshes = frames_.size(), .topologies = topologies_.size()};
}

std::vector<double> MeshSeries::sampleTimes() const {
  std::vector<double> times;
  for (size_t i = 0; i < frames_.size(); ++i) {
    times.push_back(static_cast<double>(i) / options_.meshesPerSecond);
  }
  return times;
}

void MeshSeries::moveTo(double seconds, MovedMesh& moved) const {
  // The time of a mesh is the quotient that rounds to its number.
  constexpr double kRounding = 1e-9;
  const double at =
      std::clamp(seconds * options_.meshesPerSecond + kRounding, 0.0, static_cast<double>(frames_.size() - 1));
  const auto number = static_cast<size_t>(at);
  const Frame& frame = frames_[number];
  if (moved.topology != frame.topology + 1) {
    moved.topology = frame.topology + 1;
    moved.mesh.triangles = topologies_[frame.topology];
  }
  const Frame& next = frames_[std::min(number + 1, frames_.size() - 1)];
  const auto share = static_cast<float>(at - static_cast<double>(number));
  const bool blended = options_.between == BetweenMeshes::kLinear && share > 1e-6f && next.topology == frame.topology;
  moved.shape = std::bit_cast<uint64_t>(blended ? at : static_cast<double>(number));
  moved.coloring = moved.shape;
  if (blended) {
    blend(frame.positions, next.positions, share, moved.mesh.positions);
    blend(frame.colors, next.colors, share, moved.mesh.colors);
  } else {
    moved.mesh.positions = frame.positions;
    moved.mesh.colors = frame.colors;
  }
}

}  // namespace ocelli
