// libFuzzer target: any bytes as what `ocelli-read-scene` hands back. What is read is baked, and written as the same
// bytes again; what moves is played.
#include <algorithm>
#include <cstdlib>

#include "oc_core/base/error.h"
#include "oc_core/scene/animated_scene.h"
#include "oc_core/scene/loose_parts.h"
#include "oc_core/scene/rest_pose.h"
#include "oc_core/scene/scene_record.h"

namespace {

// A larger texture, or more triangles of it, takes long and is baked in the same way.
constexpr uint64_t kMaxPixels = 1 << 12;
constexpr size_t kFuzzedTextureTriangles = 2000;
constexpr size_t kMaxPlayedTriangles = 10'000;

void check(const ocelli::Mesh& mesh) {
  if (!mesh.colors.empty() && mesh.colors.size() != mesh.positions.size()) {
    std::abort();
  }
  for (const glm::uvec3& t : mesh.triangles) {
    if (std::max({t.x, t.y, t.z}) >= mesh.positions.size()) {
      std::abort();
    }
  }
}

/// Lines and points may only be refused.
void drawLoose(const ocelli::SceneRecord& record) {
  constexpr size_t kMaxPieces = 100'000;
  size_t pieces = 0;
  for (const ocelli::Instance& instance : record.instances) {
    const ocelli::TexturedMesh& part = record.parts[instance.mesh];
    pieces += part.lines.size() + part.points.size() + part.mesh.triangles.size();
  }
  if (pieces > kMaxPieces) {
    return;
  }
  ocelli::Scene scene;
  scene.instances = record.instances;
  scene.meshes.resize(record.parts.size());
  ocelli::addLooseParts(scene, record.parts, {}, "fuzz", {});
  check(ocelli::flatten(scene));
}

/// A rig that was read can be played at any time; numbers may only be refused.
void play(ocelli::SceneRecord& record) {
  size_t triangles = 0;
  for (const ocelli::Instance& instance : record.instances) {
    triangles += record.parts[instance.mesh].mesh.triangles.size();
  }
  if (!record.rig || record.rig->animations.empty() || triangles > kMaxPlayedTriangles) {
    return;
  }
  std::vector<ocelli::RiggedMesh> meshes;
  for (const ocelli::TexturedMesh& part : record.parts) {
    meshes.push_back({part.mesh, part.added, part.isUnlit});
  }
  const ocelli::AnimatedScene scene(meshes, record.instances, *record.rig, "", "fuzz");
  ocelli::MovedMesh moved;
  for (const double share : {0.0, 0.5, 1.0}) {
    scene.moveTo(share * scene.durationSeconds(), moved);
    check(moved.mesh);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  try {
    const auto bytes = std::as_bytes(std::span(data, size));
    ocelli::SceneRecord record = ocelli::sceneFromRecord(bytes, "fuzz");
    std::vector<std::byte> again;
    ocelli::writeSceneRecord(
        record, [&](std::span<const std::byte> part) { again.insert(again.end(), part.begin(), part.end()); });
    if (!std::equal(again.begin(), again.end(), bytes.begin(), bytes.end())) {
      std::abort();
    }
    uint64_t pixels = 0;
    for (const ocelli::Texture& texture : record.textures) {
      pixels += texture.image.size();
    }
    ocelli::SceneRecord still = record;
    ocelli::poseAtRest(still);
    if (pixels <= kMaxPixels) {
      ocelli::bakeTextures(still.parts, still.textures, kFuzzedTextureTriangles);
      ocelli::bakeTextures(record.parts, record.textures, kFuzzedTextureTriangles);
    }
    for (const ocelli::SceneRecord* each : {&still, &record}) {
      for (const ocelli::TexturedMesh& part : each->parts) {
        check(part.mesh);
      }
    }
    drawLoose(still);
    play(record);
  } catch (const ocelli::Error&) {
    // Any other exception is a finding.
  }
  return 0;
}
