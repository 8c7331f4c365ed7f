#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>

#include "bench/slicer_peers.h"

namespace ocelli {

std::vector<SlicerPeer> openVdbPeers() {
  return {{"OpenVDB meshToVolume", "a distance field in cubes as wide as a column", 1'500'000,
           [](const Mesh& mesh, const DisplayProfile& profile) -> std::function<void()> {
             openvdb::initialize();
             const auto scale = static_cast<float>(profile.width) / 2;
             auto points = std::make_shared<std::vector<openvdb::Vec3s>>();
             for (const glm::vec3& p : mesh.positions) {
               points->emplace_back(p.x * scale, p.y * scale, p.z * scale);
             }
             auto triangles = std::make_shared<std::vector<openvdb::Vec3I>>();
             for (const glm::uvec3& t : mesh.triangles) {
               triangles->emplace_back(t.x, t.y, t.z);
             }
             return [points, triangles] {
               const openvdb::math::Transform::Ptr cubes = openvdb::math::Transform::createLinearTransform();
               const auto grid = openvdb::tools::meshToUnsignedDistanceField<openvdb::FloatGrid>(
                   *cubes, *points, *triangles, std::vector<openvdb::Vec4I>(), 1.0f);
               if (grid->empty()) {
                 throw std::runtime_error("OpenVDB gave an empty grid");
               }
             };
           }}};
}

}  // namespace ocelli
