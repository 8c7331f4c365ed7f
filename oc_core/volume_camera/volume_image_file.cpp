#include "oc_core/volume_camera/volume_image_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/parallel.h"
#include "oc_core/image/exr_writer.h"

namespace ocelli {
namespace {

bool passesThrough(const RayPath& ray, const Box& box) {
  for (size_t i = 0; i + 1 < ray.size(); ++i) {
    if (meets(box, ray[i], ray[i + 1])) {
      return true;
    }
  }
  return false;
}

}  // namespace

Image<glm::vec3> imageBefore(const glm::vec3& background, const VolumeImage& image) {
  Image<glm::vec3> picture(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    picture[i] = colorBefore(background, image[i]);
  }
  return picture;
}

Image<glm::vec3> opaquePoints(const VolumeImage& image, const VolumeCamera& camera) {
  Image<glm::vec3> points(image.width(), image.height());
  parallelFor(static_cast<size_t>(image.height()), 8, [&](size_t begin, size_t end) {
    for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const float t = image(x, y).opaqueT();
        if (t != VolumePixel::kNowhere) {
          const RayPath ray = camera.ray({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
          points(x, y) = ray.pointAt(ray.positionAt(t));
        }
      }
    }
  });
  return points;
}

VolumeImageFacts factsOf(const VolumeImage& image) {
  VolumeImageFacts facts;
  for (const VolumePixel& pixel : image) {
    facts.samples += pixel.samples;
    facts.touched += pixel.color.w > 0 ? 1 : 0;
    facts.opaque += pixel.opaqueT() != VolumePixel::kNowhere ? 1 : 0;
    facts.meanOpacity += static_cast<double>(pixel.color.w) / static_cast<double>(image.size());
  }
  return facts;
}

void failShowingNothing(const VolumeCamera& camera, const VolumeScene& scene) {
  const Box box = scene.bounds();
  for (int y = 0; y < camera.size.y; ++y) {
    for (int x = 0; x < camera.size.x; ++x) {
      if (passesThrough(camera.ray({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}), box)) {
        throw InputError("all that the view sees of the volume is transparent", "--transfer",
                         "choose a transfer function that shows its values, which `ocelli scene info` tells, and look "
                         "at what --clip takes away");
      }
    }
  }
  throw InputError("the volume lies outside of the view", "--view", "turn the view to it, or leave --no-fit out");
}

void writeVolumeImage(const std::filesystem::path& path, const VolumeImage& image, const VolumeCamera& camera,
                      double depthOpacity) {
  Image<float> depths(image.width(), image.height());
  for (size_t i = 0; i < image.size(); ++i) {
    const float t = image[i].opaqueT();
    depths[i] = t == VolumePixel::kNowhere ? 0 : t;
  }
  const Image<glm::vec3> points = opaquePoints(image, camera);
  nlohmann::ordered_json description = nlohmann::ordered_json::parse(camera.description);
  description["depth_opacity"] = depthOpacity;
  const VolumePixel* pixel = image.data();
  const glm::vec3* point = points.data();
  const ExrPart part{"image",
                     image.width(),
                     image.height(),
                     {{"R", &pixel->color.x, sizeof(*pixel)},
                      {"G", &pixel->color.y, sizeof(*pixel)},
                      {"B", &pixel->color.z, sizeof(*pixel)},
                      {"A", &pixel->color.w, sizeof(*pixel)},
                      {"Z", depths.data(), sizeof(float)},
                      {"P.X", &point->x, sizeof(*point)},
                      {"P.Y", &point->y, sizeof(*point)},
                      {"P.Z", &point->z, sizeof(*point)}},
                     description.dump(1)};
  writeFile(path, exrBytes({part}));
}

}  // namespace ocelli
