#include "tests/camera_shader/run_shaders.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "oc_core/base/file_bytes.h"
#include "oc_core/image/exr_reader.h"
#include "oc_core/image/image.h"

namespace ocelli::test {
namespace osl {
namespace {

// ---- the language

/// The three types of three numbers, which do not mix.
template <int kType>
class Triple {
 public:
  explicit Triple(float all) : values_(all) {}
  Triple(float a, float b, float c) : values_(a, b, c) {}
  float operator[](int i) const { return values_[i]; }
  const glm::vec3& values() const { return values_; }

 private:
  glm::vec3 values_;
};
// NOLINTBEGIN(readability-identifier-naming): names are those of the language
using point = Triple<0>;
using vector = Triple<1>;
using color = Triple<2>;
using string = const char*;
// NOLINTEND(readability-identifier-naming)

float sin(float a) {
  return std::sin(a);
}
float cos(float a) {
  return std::cos(a);
}
float floor(float a) {
  return std::floor(a);
}
float abs(float a) {
  return std::abs(a);
}
float max(float a, float b) {
  return std::max(a, b);
}
float clamp(float a, float lower, float upper) {
  return std::clamp(a, lower, upper);
}
float length(const vector& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}
vector normalize(const vector& a) {
  const float l = length(a);
  return {a[0] / l, a[1] / l, a[2] / l};
}

glm::vec2 rasterPosition{0};
point camera_shader_raster_position() {  // NOLINT(readability-identifier-naming)
  return {rasterPosition.x, rasterPosition.y, 0};
}

// ---- textures

Image<glm::vec3> readTexture(const std::string& path) {
  const std::string bytes = readFile(path);
  const ExrPartHeader header = exrHeaders(bytes, 1).front();
  Image<glm::vec3> image(static_cast<int>(header.width), static_cast<int>(header.height));
  ExrReader(bytes).read(0, header,
                        {{"R", &image[0].x, sizeof(glm::vec3)},
                         {"G", &image[0].y, sizeof(glm::vec3)},
                         {"B", &image[0].z, sizeof(glm::vec3)}});
  return image;
}

Filtering filteringNow = Filtering::kClosest;

/// t = 0 is the upper border, as OpenImageIO has it.
color texture(string file, float s, float t, float, float, float, float, string interp, string closest, string wrap,
              string clamped) {
  static std::map<std::string, Image<glm::vec3>> images;
  const auto found = images.find(file);
  const Image<glm::vec3>& image =
      found != images.end() ? found->second : images.emplace(file, readTexture(file)).first->second;
  const bool asked = std::string(interp) + closest + wrap + clamped == "interpclosestwrapclamp";
  const glm::vec2 place = glm::vec2(s, t) * glm::vec2(image.width(), image.height());
  const auto texel = [&](float x, float y) {
    return image(static_cast<int>(std::clamp(x, 0.0f, static_cast<float>(image.width() - 1))),
                 static_cast<int>(std::clamp(y, 0.0f, static_cast<float>(image.height() - 1))));
  };
  glm::vec3 value = texel(std::floor(place.x), std::floor(place.y));
  if (filteringNow == Filtering::kLinear || !asked) {
    const glm::vec2 lower(std::floor(place.x - 0.5f), std::floor(place.y - 0.5f));
    const glm::vec2 share = place - 0.5f - lower;
    const auto row = [&](float y) { return texel(lower.x, y) * (1 - share.x) + texel(lower.x + 1, y) * share.x; };
    value = row(lower.y) * (1 - share.y) + row(lower.y + 1) * share.y;
  }
  return {value.x, value.y, value.z};
}

// ---- the shaders

using Shader = void (*)(point&, vector&, color&);

#define shader void  // NOLINT
#include OCELLI_SHADER_TEXTS
#undef shader

}  // namespace
}  // namespace osl

ShaderRay runShader(const std::string& name, const glm::vec2& raster, Filtering filtering) {
  osl::rasterPosition = raster;
  osl::filteringNow = filtering;
  osl::point position(0);
  osl::vector direction(0);
  osl::color throughput(0);
  osl::kShaders.at(name)(position, direction, throughput);
  return {position.values(), direction.values(), throughput.values()};
}

std::vector<std::string> shaderNames() {
  std::vector<std::string> names;
  for (const auto& [name, shader] : osl::kShaders) {
    names.push_back(name);
  }
  return names;
}

}  // namespace ocelli::test
