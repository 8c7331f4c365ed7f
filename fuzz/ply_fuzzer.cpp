// libFuzzer target: any bytes as a PLY file.
#include <sstream>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/scene/ply_file.h"
#include "oc_core/scene/share_vertices.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::istringstream stream(std::string(data, data + size));
  try {
    ocelli::Mesh mesh = ocelli::readPly(stream, size, "fuzz");
    ocelli::dropUnusedVertices(mesh);
    if (!mesh.empty()) {
      ocelli::validate(mesh, "fuzz");
    }
  } catch (const ocelli::InputError&) {
    // Any other exception is a finding.
  }
  return 0;
}
