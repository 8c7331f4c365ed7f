// libFuzzer target: the first line as a camera file, each of the others as an edit of it. What is read sees points and
// follows rays, and is written. The same line as the regions of a general pinhole camera.
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/camera/gpc_map.h"
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

void useRegions(const std::string& text) {
  try {
    const nlohmann::json json = ocelli::parseJson(text, "fuzz");
    ocelli::JsonFields fields(json, "fuzz");
    ocelli::GpcLayout layout;
    ocelli::readGpcLayout(fields, layout);
    ocelli::jsonText(layout);
    const ocelli::GpcMap map(layout, 16, 10);
    for (double v = 0; v <= 10; v += 0.5) {
      for (double u = 0; u <= 16; u += 0.5) {
        // Regions as small as a thousandth of the image, in double precision.
        const glm::dvec2 back = map.imageFromPinhole(map.pinholeFromImage({u, v}));
        if (!(glm::distance(back, glm::dvec2(u, v)) < 1e-6)) {
          std::abort();
        }
      }
    }
  } catch (const ocelli::InputError&) {
    // The regions are wrong.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::istringstream lines(std::string(data, data + size));
  std::string line;
  std::getline(lines, line);
  useRegions(line);
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
