#include "oc_core/evaluation/frame_errors.h"

#include <algorithm>
#include <utility>

#include "oc_core/evaluation/flip.h"
#include "oc_core/evaluation/image_quality.h"
#include "oc_core/image/image_error.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {

ViewFrame renderFrame(const PinholeCamera& camera, const Mesh& mesh) {
  const FragmentImage fragments = rasterize(camera, mesh);
  return {positionImage(fragments, mesh), srgbFromLinear(colorImage(fragments, mesh, glm::vec3(0)))};
}

ViewFrame renderFrame(const PinholeCamera& camera, const RayTarget& target) {
  const HitImage hits = castRays(camera, target);
  Image<glm::vec4> points(hits.width(), hits.height(), glm::vec4(0));
  Image<glm::vec3> colors(hits.width(), hits.height(), glm::vec3(0));
  for (size_t i = 0; i < hits.size(); ++i) {
    if (hits[i]) {
      points[i] = glm::vec4(hits[i]->position, 1);
      colors[i] = hits[i]->color;
    }
  }
  return {std::move(points), srgbFromLinear(colors)};
}

FrameComparison compareViewFrames(const PinholeCamera& camera, const ViewFrame& truth, const ViewFrame& frame,
                                  const RayScene& scene) {
  return compareViewFrames(camera, truth, frame, searchOf(scene));
}

FrameComparison compareViewFrames(const PinholeCamera& camera, const ViewFrame& truth, const ViewFrame& frame,
                                  const SurfaceSearch& hasSurfaceNear) {
  FrameComparison comparison;
  comparison.states = compareFrames(camera, truth.points, frame.points);
  comparison.wrongFronts = wrongFronts(camera, truth.points, frame.points, comparison.states);
  comparison.falseSkins = falseSkins(camera, truth.points, frame.points, hasSurfaceNear);
  return comparison;
}

FrameErrors& FrameErrors::operator+=(const FrameErrors& other) {
  MissingSamples::operator+=(other);
  wrongFront += other.wrongFront;
  frame += other.frame;
  falseSkin += other.falseSkin;
  images += other.images;
  squaredError += other.squaredError;
  ssim += other.ssim;
  flip += other.flip;
  return *this;
}

double FrameErrors::meanPsnrDecibels() const {
  return images > 0 ? psnrDecibels(mean(squaredError, images)) : 0;
}

FrameErrors countErrors(const FrameComparison& comparison, const ViewFrame& frame) {
  const auto marked = [](const Image<uint8_t>& map) {
    return static_cast<size_t>(std::count(map.begin(), map.end(), uint8_t{1}));
  };
  FrameErrors errors;
  errors.MissingSamples::operator+=(countMissing(comparison.states));
  errors.wrongFront = marked(comparison.wrongFronts);
  errors.frame = static_cast<size_t>(
      std::count_if(frame.points.begin(), frame.points.end(), [](const glm::vec4& p) { return p.w > 0; }));
  errors.falseSkin = marked(comparison.falseSkins);
  return errors;
}

void addImageErrors(FrameErrors& errors, const ViewFrame& truth, const ViewFrame& frame) {
  FrameErrors image;
  image.images = 1;
  image.squaredError = meanSquaredError(truth.image, frame.image);
  image.ssim = ssim(truth.image, frame.image);
  image.flip = flip(truth.image, frame.image);
  errors += image;
}

}  // namespace ocelli
