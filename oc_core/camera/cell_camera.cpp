#include "oc_core/camera/cell_camera.h"

#include <algorithm>

namespace ocelli {
namespace {

/// Neighbouring tiles of a viewpoint are this far apart: they share a row or a column of pixels.
constexpr int kStride = CellCamera::kTileSide - 1;
/// A surface is reached where it lies at most this many footprints (z / focal length) behind the end of a ray: between
/// the rays it may be a little farther.
constexpr float kReachFootprints = 2;
/// Step along the ray of a satellite, as parallax in pixels of the reference image.
constexpr float kStepPixels = 0.5f;

int tilesAlong(int pixels) {
  return (pixels + kStride - 1) / kStride;
}

/// Among the pixels of a tile that no later tile shares.
bool holdsAny(const Image<float>& reach, const glm::ivec2& corner) {
  for (int y = corner.y; y < std::min(corner.y + kStride, reach.height()); ++y) {
    for (int x = corner.x; x < std::min(corner.x + kStride, reach.width()); ++x) {
      if (reach(x, y) > 0) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

CellCamera::CellCamera(std::vector<Viewpoint> viewpoints) : viewpoints_(std::move(viewpoints)) {
  OC_CHECK(!viewpoints_.empty(), "a cell camera has a reference viewpoint");
  for (size_t i = 0; i < viewpoints_.size(); ++i) {
    const Image<float>& reach = viewpoints_[i].reach;
    OC_CHECK(reach.width() == viewpoints_[i].camera.width() && reach.height() == viewpoints_[i].camera.height(),
             "each pixel of a viewpoint has its reach");
    tileOf_.emplace_back(tilesAlong(reach.width()), tilesAlong(reach.height()), -1);
    if (i == 0) {
      continue;
    }
    for (int y = 0; y < tileOf_[i].height(); ++y) {
      for (int x = 0; x < tileOf_[i].width(); ++x) {
        if (holdsAny(reach, {x * kStride, y * kStride})) {
          tileOf_[i](x, y) = static_cast<int>(tiles_.size());
          tiles_.push_back({i, {x * kStride, y * kStride}});
        }
      }
    }
  }
  tilesPerRow_ = std::max(width() / kTileSide, 1);
  height_ = reference().height() + (static_cast<int>(tiles_.size()) + tilesPerRow_ - 1) / tilesPerRow_ * kTileSide;
}

glm::ivec2 CellCamera::cornerOf(size_t tile) const {
  const auto index = static_cast<int>(tile);
  return {index % tilesPerRow_ * kTileSide, reference().height() + index / tilesPerRow_ * kTileSide};
}

bool CellCamera::reaches(size_t viewpoint, const ImagePoint& q) const {
  const Viewpoint& v = viewpoints_[viewpoint];
  const int x = static_cast<int>(std::floor(q.u));
  const int y = static_cast<int>(std::floor(q.v));
  return v.reach.contains(x, y) && q.t <= v.reach(x, y) * (1 + kReachFootprints / v.camera.focalPixels());
}

bool CellCamera::reachedBefore(size_t viewpoint, const glm::vec3& worldPoint) const {
  for (size_t i = 0; i < viewpoint; ++i) {
    const std::optional<ImagePoint> q = viewpoints_[i].camera.project(worldPoint);
    if (q && reaches(i, *q)) {
      return true;
    }
  }
  return false;
}

std::optional<ImagePoint> CellCamera::project(const glm::vec3& worldPoint) const {
  const float z = reference().cameraFromWorld(worldPoint).z;
  for (size_t i = 0; i < viewpoints_.size(); ++i) {
    const std::optional<ImagePoint> q = viewpoints_[i].camera.project(worldPoint);
    if (!q || !reaches(i, *q)) {
      continue;
    }
    if (i == 0) {
      return q;
    }
    const auto tile =
        static_cast<size_t>(tileOf_[i](static_cast<int>(q->u) / kStride, static_cast<int>(q->v) / kStride));
    const glm::vec2 inTile = glm::vec2(q->u, q->v) - glm::vec2(tiles_[tile].corner);
    const glm::vec2 place = glm::vec2(cornerOf(tile)) + inTile;
    return ImagePoint{place.x, place.y, z};
  }
  return std::nullopt;
}

std::optional<CellCamera::Place> CellCamera::placeOf(const glm::vec2& pixel) const {
  const auto w = static_cast<float>(width());
  const auto h = static_cast<float>(height_);
  if (!(pixel.x >= 0 && pixel.y >= 0 && pixel.x < w && pixel.y < h)) {
    return std::nullopt;
  }
  const int below = static_cast<int>(pixel.y) - reference().height();
  if (below < 0) {
    return Place{0, pixel};
  }
  const int column = static_cast<int>(pixel.x) / kTileSide;
  const size_t tile =
      static_cast<size_t>(below / kTileSide) * static_cast<size_t>(tilesPerRow_) + static_cast<size_t>(column);
  if (column >= tilesPerRow_ || tile >= tiles_.size()) {
    return std::nullopt;
  }
  return Place{tiles_[tile].viewpoint, pixel - glm::vec2(cornerOf(tile)) + glm::vec2(tiles_[tile].corner)};
}

/// Where the ray of a viewpoint's pixel has this depth along the reference direction.
std::optional<glm::vec3> CellCamera::pointAt(const Place& place, float referenceZ) const {
  const PinholeCamera& camera = viewpoints_[place.viewpoint].camera;
  if (place.viewpoint == 0) {
    return camera.unproject({place.pixel.x, place.pixel.y, referenceZ});
  }
  const glm::vec3 direction =
      camera.worldFromCamera(camera.cameraFromImage({place.pixel.x, place.pixel.y, 1})) - camera.eye();
  const float start = reference().cameraFromWorld(camera.eye()).z;
  const float slope = reference().cameraFromWorld(camera.eye() + direction).z - start;
  const float z = (referenceZ - start) / slope;  // along the satellite's own direction
  return camera.unproject({place.pixel.x, place.pixel.y, z});
}

std::optional<glm::vec3> CellCamera::unproject(const ImagePoint& q) const {
  const std::optional<Place> place = placeOf({q.u, q.v});
  if (!place || !std::isfinite(q.t)) {
    return std::nullopt;
  }
  const std::optional<glm::vec3> point = pointAt(*place, q.t);
  if (!point || !reaches(place->viewpoint, *viewpoints_[place->viewpoint].camera.project(*point)) ||
      reachedBefore(place->viewpoint, *point)) {
    return std::nullopt;
  }
  return point;
}

RayPath CellCamera::rayPath(const glm::vec2& pixel) const {
  const std::optional<Place> place = placeOf(pixel);
  if (!place) {
    return {};
  }
  const Viewpoint& v = viewpoints_[place->viewpoint];
  const int x = static_cast<int>(place->pixel.x);
  const int y = static_cast<int>(place->pixel.y);
  if (!v.reach.contains(x, y) || v.reach(x, y) <= 0) {
    return {};
  }
  const auto at = [&](float z) {
    return v.camera.worldFromCamera(v.camera.cameraFromImage({place->pixel.x, place->pixel.y, z}));
  };
  // Half of the tolerance beyond the surface, so that a ray tracer finds it.
  const float end =
      std::min(v.reach(x, y) * (1 + 0.5f * kReachFootprints / v.camera.focalPixels()), v.camera.view().zFar);
  const auto piece = [&](float zStart) {
    RayPath path;
    for (const float z : {zStart, end}) {
      const glm::vec3 point = at(z);
      path.add(point, place->viewpoint == 0 ? z : reference().cameraFromWorld(point).z);
    }
    return path;
  };
  if (place->viewpoint == 0) {
    return piece(v.camera.view().zNear);
  }
  // Back from the surface, up to where an earlier viewpoint takes over.
  const float baseline = glm::distance(v.camera.eye(), reference().eye());
  const float step = kStepPixels / (reference().focalPixels() * std::max(baseline, 1e-6f));
  float start = end;
  for (float inverseZ = 1 / end; !reachedBefore(place->viewpoint, at(start)); inverseZ += step) {
    const float next = 1 / (inverseZ + step);
    if (next <= v.camera.view().zNear || reachedBefore(place->viewpoint, at(next))) {
      break;
    }
    start = next;
  }
  return start < end ? piece(start) : RayPath{};
}

}  // namespace ocelli
