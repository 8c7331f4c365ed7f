// libFuzzer target: the first line as a camera file, each of the others as an edit of it. What is read sees points and
// follows rays, and is written.
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/constructor/camera_editor.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"

namespace {

void use(const ocelli::MultiperspectiveCamera& camera) {
  std::visit(
      [](const auto& each) {
        for (const glm::vec2 pixel : {glm::vec2(0, 0), glm::vec2(7.5f, 3.5f), glm::vec2(15, 9)}) {
          for (const glm::vec3& point : each.rayPath(pixel)) {
            const auto image = each.project(point);
            if (image && !std::isfinite(image->u + image->v + image->t)) {
              std::abort();
            }
          }
        }
        jsonText(each);
      },
      camera);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::istringstream lines(std::string(data, data + size));
  std::string line;
  std::getline(lines, line);
  try {
    ocelli::CameraEditor editor(line, "fuzz", ocelli::PinholeCamera({}, 16, 10), {glm::vec3(-2), glm::vec3(2)});
    use(editor.camera());
    while (std::getline(lines, line)) {
      try {
        editor.apply(line, "fuzz");
        use(editor.camera());
      } catch (const ocelli::InputError&) {
        // Any other exception is a finding.
      }
    }
  } catch (const ocelli::InputError&) {
    // The camera itself is wrong.
  }
  return 0;
}
