// libFuzzer target: any bytes as a PLY file, of a mesh and of points, and as points in text and PCD.
#include <sstream>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/scene/pcd_points.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/point_mesh.h"
#include "oc_core/scene/share_vertices.h"
#include "oc_core/scene/text_points.h"

namespace {

/// Any other exception than InputError is a finding.
template <class Read>
void tryTo(const Read& read, const std::string& bytes) {
  std::istringstream stream(bytes);
  try {
    read(stream);
  } catch (const ocelli::InputError&) {
  }
}

void drawPoints(ocelli::PointCloud cloud) {
  const std::string where = "fuzz";
  const ocelli::PointMesh points = ocelli::meshOfPoints(std::move(cloud), {}, where);
  // Coordinates near the largest float may have corners beyond it.
  ocelli::validate(points.mesh, where);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(data, data + size);
  tryTo(
      [&](std::istream& stream) {
        ocelli::Mesh mesh = ocelli::readPly(stream, size, "fuzz");
        ocelli::dropUnusedVertices(mesh);
        if (!mesh.empty()) {
          ocelli::validate(mesh, "fuzz");
        }
      },
      bytes);
  tryTo([&](std::istream& stream) { drawPoints(ocelli::readPlyPoints(stream, size, "fuzz")); }, bytes);
  tryTo([&](std::istream& stream) { drawPoints(ocelli::readPcdPoints(stream, size, "fuzz")); }, bytes);
  tryTo([&](std::istream& stream) { drawPoints(ocelli::readTextPoints(stream, "fuzz")); }, bytes);
  return 0;
}
