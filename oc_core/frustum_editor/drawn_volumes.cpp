#include "oc_core/frustum_editor/drawn_volumes.h"

#include <algorithm>
#include <cmath>

#include "oc_core/camera/convex_polyhedron.h"
#include "oc_core/camera/frustum_pieces.h"
#include "oc_core/multiperspective/ray_pieces.h"

namespace ocelli {
namespace {

constexpr int kBorderSamples = 12;  // of rays, along each side of the image

/// The ray of a pixel from where it crosses the plane of frustum `i`, also where another frustum has its pixel.
DrawnRay rayBehind(const GraphCamera& camera, int i, const glm::dvec2& pixel) {
  const GraphCamera::Frustum& frustum = camera.frusta()[static_cast<size_t>(i)];
  if (frustum.parent < 0) {
    const PinholeCamera& root = camera.root();
    const glm::dvec2 offset = (pixel - glm::dvec2(root.centerPixels())) / static_cast<double>(root.focalPixels());
    const glm::dvec3 direction =
        glm::dvec3(root.right()) * offset.x + glm::dvec3(root.down()) * offset.y + glm::dvec3(root.forward());
    return {glm::dvec3(root.eye()) + direction * static_cast<double>(root.view().zNear), direction};
  }
  const DrawnRay ray = rayBehind(camera, frustum.parent, pixel);
  const glm::dvec3 at = frustum.plane.crossing(ray.from, ray.from + ray.direction);
  return {at, at - frustum.viewpoint};
}

ConvexPolyhedron polyhedronOf(const Box& room) {
  return {glm::dvec3(room.lower), glm::dvec3(room.upper)};
}

DrawnVolume cornersOfFaces(const ConvexPolyhedron& polyhedron) {
  DrawnVolume corners;
  for (const std::vector<glm::dvec3>& face : polyhedron.faces()) {
    corners.insert(corners.end(), face.begin(), face.end());
  }
  return corners;
}

void cutBy(ConvexPolyhedron& polyhedron, const FrustumPiece& piece) {
  for (const Plane& side : piece.sides) {
    polyhedron.cut(side);
  }
}

std::vector<glm::vec2> sampledPixels(const CurvedRayCamera& camera) {
  std::vector<glm::vec2> pixels = cornerPixels(camera);
  const glm::vec2 size(static_cast<float>(camera.width()), static_cast<float>(camera.height()));
  const float inside = 0.999f;  // of the way from the middle: on the border, rounding decides what is in the image
  for (int k = 0; k <= kBorderSamples; ++k) {
    const float share = 0.5f + (static_cast<float>(k) / kBorderSamples - 0.5f) * inside;
    const float end = 0.5f + 0.5f * inside;
    for (const glm::vec2& uv : {glm::vec2(share, 1 - end), glm::vec2(share, end), glm::vec2(1 - end, share),
                                glm::vec2(end, share), glm::vec2(share, 0.5f)}) {
      pixels.push_back(uv * size);
    }
  }
  return pixels;
}

}  // namespace

glm::dvec3 meanOf(const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum(0);
  for (const glm::dvec3& point : points) {
    sum += point;
  }
  return sum / static_cast<double>(std::max<size_t>(points.size(), 1));
}

std::vector<glm::dvec3> crossingsOf(const GraphCamera& camera, int i) {
  std::vector<glm::dvec3> points;
  for (const glm::dvec2& corner : camera.frusta()[static_cast<size_t>(i)].part) {
    points.push_back(rayBehind(camera, i, corner).from);
  }
  return points;
}

DrawnRay middleRayOf(const GraphCamera& camera, int i) {
  const GraphCamera::Part& part = camera.frusta()[static_cast<size_t>(i)].part;
  DrawnRay ray = rayBehind(camera, i, GraphCamera::middleOf(part));
  ray.direction = glm::normalize(ray.direction);
  return ray;
}

std::vector<glm::dvec3> polygonWithin(std::vector<glm::dvec3> polygon, const Box& box) {
  const std::vector<glm::dvec3> whole = polygon;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      glm::dvec3 normal(0);
      normal[axis] = sign;
      const Plane side{normal, static_cast<double>(sign > 0 ? box.upper[axis] : -box.lower[axis])};
      std::vector<glm::dvec3> kept;
      for (size_t k = 0; k < polygon.size(); ++k) {
        const glm::dvec3& a = polygon[k];
        const glm::dvec3& b = polygon[(k + 1) % polygon.size()];
        if (side.height(a) <= 0) {
          kept.push_back(a);
        }
        if ((side.height(a) < 0 && side.height(b) > 0) || (side.height(a) > 0 && side.height(b) < 0)) {
          kept.push_back(side.crossing(a, b));
        }
      }
      polygon = std::move(kept);
    }
  }
  return polygon.size() >= 3 ? polygon : whole;
}

std::vector<DrawnVolume> graphVolumesOf(const GraphCamera& camera, int i, const Box& room) {
  std::vector<DrawnVolume> volumes;
  for (const FrustumPiece& piece : piecesOf(camera, i)) {
    ConvexPolyhedron polyhedron = polyhedronOf(room);
    cutBy(polyhedron, piece);
    if (!polyhedron.empty()) {
      volumes.push_back(cornersOfFaces(polyhedron));
    }
  }
  return volumes;
}

std::vector<DrawnVolume> commonVolumesOf(const GraphCamera& camera, int i, int j, const Box& room) {
  std::vector<DrawnVolume> volumes;
  for (const FrustumPiece& one : piecesOf(camera, i)) {
    for (const FrustumPiece& other : piecesOf(camera, j)) {
      ConvexPolyhedron polyhedron = polyhedronOf(room);
      cutBy(polyhedron, one);
      cutBy(polyhedron, other);
      if (!polyhedron.empty()) {
        volumes.push_back(cornersOfFaces(polyhedron));
      }
    }
  }
  return volumes;
}

std::vector<glm::dvec3> cornersIn(const std::vector<DrawnVolume>& volumes, const Plane& plane, double slack) {
  std::vector<glm::dvec3> corners;
  for (const DrawnVolume& volume : volumes) {
    for (const glm::dvec3& corner : volume) {
      if (std::abs(plane.height(corner)) <= slack) {
        corners.push_back(corner);
      }
    }
  }
  return corners;
}

std::vector<DrawnVolume> curvedVolumesOf(const CurvedRayCamera& camera, const Box& room) {
  std::vector<DrawnVolume> volumes(2 * camera.bends().size() + 1);
  for (const glm::vec2& pixel : sampledPixels(camera)) {
    for (const RayPiece& piece : rayPieces(camera, pixel)) {
      for (size_t k = 0; k + 1 < piece.points.size(); ++k) {
        const glm::dvec3 a(piece.points[k]);
        const glm::dvec3 b(piece.points[k + 1]);
        if (const std::optional<SegmentPart> part = partWithin(room, a, b)) {
          volumes[static_cast<size_t>(piece.part)].push_back(a + (b - a) * part->first);
          volumes[static_cast<size_t>(piece.part)].push_back(a + (b - a) * part->last);
        }
      }
    }
  }
  return volumes;
}

std::array<std::vector<glm::dvec3>, 3> crossingsOfBend(const CurvedRayCamera& camera, size_t bend) {
  std::array<std::vector<glm::dvec3>, 3> crossings;
  const RayTransition& transition = camera.bends()[bend];
  const int part = static_cast<int>(2 * bend) + 1;
  for (const glm::vec2& pixel : sampledPixels(camera)) {
    for (const RayPiece& piece : rayPieces(camera, pixel)) {
      if (piece.part == part) {
        const glm::dvec3 start(piece.points.front());
        crossings[0].push_back(start);
        crossings[1].push_back(transition.planes().middle.crossing(transition.before(), start));
        crossings[2].emplace_back(piece.points.back());
      }
    }
  }
  return crossings;
}

}  // namespace ocelli
