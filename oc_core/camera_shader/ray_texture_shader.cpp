#include "oc_core/camera_shader/ray_texture_shader.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/camera_shader/osl_text.h"
#include "oc_core/image/exr_writer.h"

namespace ocelli {
namespace {

constexpr const char* kStatements =
    "    point raster = camera_shader_raster_position();\n"
    "    float first = 0.0;\n"
    "    float lastColumn = width - 1;\n"
    "    float lastRow = height - 1;\n"
    "    float column = clamp(floor(raster[0] * width), first, lastColumn);\n"
    "    float row = clamp(floor((1 - raster[1]) * height), first, lastRow);\n"
    "    // The centres of two texels, from the top left: in the upper half of the texture, and in the lower one.\n"
    "    float s = (2 * column + 1) / (2 * width);\n"
    "    float upper = (2 * row + 1) / (4 * height);\n"
    "    float lower = (2 * row + 2 * height + 1) / (4 * height);\n"
    "    color from = texture(rays, s, upper, 0.0, 0.0, 0.0, 0.0, \"interp\", \"closest\", \"wrap\", \"clamp\");\n"
    "    color along = texture(rays, s, lower, 0.0, 0.0, 0.0, 0.0, \"interp\", \"closest\", \"wrap\", \"clamp\");\n"
    "    vector ray = vector(along[0], along[1], along[2]);\n"
    "    if (2 * length(ray) > 1) {  // 0 where a pixel has no ray\n"
    "        position = point(from[0], from[1], from[2]);\n"
    "        direction = normalize(ray);\n"
    "        throughput = color(1.0);\n"
    "    }\n";

/// What of a map is to be in the space of the camera.
class SpaceOfMap {
 public:
  explicit SpaceOfMap(const RayMap& map)
      : isLens_(map.notes().frame == RayFrame::kView), space_(map.notes().view.value_or(View{})) {}
  /// A lens says its own space, with z backward.
  glm::dvec3 point(const glm::dvec3& p) const { return isLens_ ? glm::dvec3(p.x, p.y, -p.z) : space_.point(p); }
  glm::dvec3 direction(const glm::dvec3& d) const { return isLens_ ? glm::dvec3(d.x, d.y, -d.z) : space_.direction(d); }

 private:
  bool isLens_;
  OslCameraSpace space_;
};

}  // namespace

void requireStraightRays(const RayMap& map) {
  const RayMapFacts facts = factsOf(map);
  if (facts.bent > 0) {
    throw InputError(
        fmt::format("{} of its {} rays bend, into {} segments at most, and a camera shader has one straight "
                    "ray a pixel",
                    facts.bent, facts.rays, facts.segments),
        "camera \"" + map.notes().name + "\"",
        "choose a camera whose rays are straight, or write all segments with `ocelli camera rays`");
  }
}

std::string rayTextureShader(const RayMap& map, const std::string& texture) {
  requireStraightRays(map);
  const bool stands = map.notes().frame == RayFrame::kWorld;
  return oslText(
      {.name = map.notes().name,
       .size = {map.width(), map.height()},
       .view = stands ? std::optional(map.notes().view.value_or(View{})) : std::nullopt,
       .remarks = "// The texture `rays` holds where the ray of each pixel begins, and below that its direction.\n",
       .parameters = ",\n    string rays = " + oslString(texture),
       .statements = oslFloat("width", map.width(), "of the camera's image, pixels") +
                     oslFloat("height", map.height()) + kStatements});
}

std::string rayTextureBytes(const RayMap& map, const Progress& progress) {
  requireStraightRays(map);
  const SpaceOfMap space(map);
  const auto width = static_cast<size_t>(map.width());
  const auto pixels = width * static_cast<size_t>(map.height());
  std::vector<glm::vec3> texels(2 * pixels, glm::vec3(0));
  parallelFor(static_cast<size_t>(map.height()), 8, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (int x = 0; x < map.width(); ++x) {
        const RayMapRay ray = map.ray(x, static_cast<int>(y));
        if (ray.empty()) {
          continue;
        }
        const glm::dvec3 from(ray.points.front());
        const glm::dvec3 way = space.direction(glm::dvec3(ray.points.back()) - from);
        const double length = glm::length(way);
        if (length > 0) {
          const size_t i = y * width + static_cast<size_t>(x);
          texels[i] = glm::vec3(space.point(from));
          texels[pixels + i] = glm::vec3(way / length);
        }
      }
    }
  });
  report(progress, "texture", 0.5);
  std::string bytes = exrBytes({{.name = "rays",
                                 .width = map.width(),
                                 .height = 2 * map.height(),
                                 .channels = {{"R", &texels[0].x, sizeof(glm::vec3)},
                                              {"G", &texels[0].y, sizeof(glm::vec3)},
                                              {"B", &texels[0].z, sizeof(glm::vec3)}},
                                 .description = R"({"type": "rays of a camera shader"})"}});
  report(progress, "texture", 1);
  return bytes;
}

}  // namespace ocelli
