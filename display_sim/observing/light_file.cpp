#include "display_sim/observing/light_file.h"

#include "oc_core/base/file_bytes.h"
#include "oc_core/image/exr_writer.h"
#include "oc_core/image/png_file.h"

namespace ocelli {

void writeLightExr(const std::filesystem::path& path, const Image<glm::vec3>& light, const std::string& description) {
  ExrPart part;
  part.name = "light";
  part.width = light.width();
  part.height = light.height();
  part.description = description;
  constexpr const char* kNames[] = {"R", "G", "B"};
  for (int channel = 0; channel < 3; ++channel) {
    part.channels.push_back({kNames[channel], &light.data()[0][channel], sizeof(glm::vec3)});
  }
  writeFile(path, exrBytes({part}));
}

void writeTonedPng(const std::filesystem::path& path, Image<glm::vec3> light, const Tone& tone) {
  applyTone(light, tone);
  writePng(path, srgbFromLinear(light));
}

}  // namespace ocelli
