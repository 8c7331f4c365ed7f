#include "oc_core/shade/glass_back_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "oc_core/base/check.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/parallel.h"
#include "oc_core/shade/vertex_normals.h"

namespace ocelli {
namespace {

/// The farthest surface of the object that a pixel shows first.
struct BackFace {
  const SpecularObject* object = nullptr;  ///< nothing: the pixel shows none
  float distance = 0;                      ///< from the eye
  glm::vec3 normal{0};                     ///< unit, towards the eye
};

Image<BackFace> backFaces(const FirstSurfaces& surfaces, const PinholeCamera& camera) {
  Image<BackFace> image(camera.width(), camera.height());
  parallelFor(static_cast<size_t>(camera.height()), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < camera.width(); ++x) {
        const RayPath path = camera.rayPath({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        const SpecularObject* object = surfaces.along(path).object;
        if (object == nullptr) {
          continue;
        }
        // The view ray backwards: what it meets first is the farthest surface.
        const Fragment last = surfaces.raysOf(*object).intersect({path.back(), path.front()});
        if (last.covered()) {
          const glm::vec3 incoming = glm::normalize(path.back() - path.front());
          image(x, y) = {object, glm::distance(positionOf(last, object->mesh), camera.eye()),
                         normalAt(last, object->mesh, object->normals, incoming)};
        }
      }
    }
  });
  return image;
}

/// Between the four pixels around the image of a point, of those that show the object; nothing where none does.
std::optional<BackFace> backFaceAt(const Image<BackFace>& image, const PinholeCamera& camera, const glm::vec3& point,
                                   const SpecularObject& object) {
  const std::optional<ImagePoint> place = camera.project(point);
  constexpr float kFarAside = 1e6f;
  if (!place || !(std::abs(place->u) < kFarAside) || !(std::abs(place->v) < kFarAside)) {
    return std::nullopt;
  }
  const float u = place->u - 0.5f;
  const float v = place->v - 0.5f;
  const auto x = static_cast<int>(std::floor(u));
  const auto y = static_cast<int>(std::floor(v));
  BackFace sum{&object};
  float weights = 0;
  for (int row = y; row <= y + 1; ++row) {
    for (int column = x; column <= x + 1; ++column) {
      if (image.contains(column, row) && image(column, row).object == &object) {
        const float weight =
            (1 - std::abs(u - static_cast<float>(column))) * (1 - std::abs(v - static_cast<float>(row)));
        sum.distance += image(column, row).distance * weight;
        sum.normal += image(column, row).normal * weight;
        weights += weight;
      }
    }
  }
  const float length = glm::length(sum.normal);
  if (!(weights > 0) || !(length > 0)) {
    return std::nullopt;
  }
  return BackFace{&object, sum.distance / weights, sum.normal / length};
}

/// Of unit vectors; exact for small ones, too.
float angleBetween(const glm::vec3& a, const glm::vec3& b) {
  return 2 * std::atan2(glm::length(a - b), glm::length(a + b));
}

/// How far it is through the object against the normal.
std::optional<float> thicknessAlong(const RayScene& object, const glm::vec3& place, const glm::vec3& inwards,
                                    float size) {
  constexpr float kStepInside = 1e-5f;
  const glm::vec3 from = place + inwards * (kStepInside * size);
  const Fragment exit = object.intersect({from, from + inwards * (2 * size)});
  return exit.covered() ? std::optional(exit.t) : std::nullopt;
}

/// How long the way inside is, as [171] has it.
float expectedWay(const RayScene& object, const SpecularHit& hit, const glm::vec3& place, const glm::vec3& normal,
                  const glm::vec3& inside, float alongView) {
  const float size = glm::length(boundsOf(hit.object.mesh).size());
  const float alongNormal = thicknessAlong(object, place, -normal, size).value_or(alongView);
  const float incidence = angleBetween(-hit.incoming, normal);
  constexpr float kUpright = 1e-4f;
  const float share = incidence > kUpright ? angleBetween(inside, -normal) / incidence
                                           : 1 / static_cast<float>(hit.object.refractiveIndex);
  return share * alongView + (1 - share) * alongNormal;
}

/// How long it is until the image of the back faces says that it is behind them, or outside of the object's image.
float searchedWay(const Image<BackFace>& back, const PinholeCamera& camera, const SpecularObject& glass,
                  const glm::vec3& place, const glm::vec3& inside) {
  const auto isInside = [&](float way) {
    const glm::vec3 point = place + inside * way;
    const std::optional<BackFace> face = backFaceAt(back, camera, point, glass);
    return face && glm::distance(point, camera.eye()) < face->distance;
  };
  // A walk finds the piece with the first crossing, halving finds the place in it.
  constexpr int kPieces = 16;
  constexpr int kHalvings = 8;
  const float size = glm::length(boundsOf(glass.mesh).size());
  float before = 0;
  float behind = size;
  for (int i = 1; i <= kPieces; ++i) {
    const float way = size * static_cast<float>(i) / kPieces;
    if (!isInside(way)) {
      behind = way;
      break;
    }
    before = way;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = (before + behind) / 2;
    (isInside(middle) ? before : behind) = middle;
  }
  return before;
}

}  // namespace

SecondaryRays refractedRaysByBackFaces(const FirstSurfaces& surfaces, const PinholeCamera& camera, BackFaceExit by) {
  const Image<BackFace> back = backFaces(surfaces, camera);
  return raysGoingOn(surfaces, camera, [&](const SpecularHit& hit) {
    const SpecularObject& glass = hit.object;
    const auto index = static_cast<float>(glass.refractiveIndex);
    const glm::vec3 place = positionOf(hit.fragment, glass.mesh);
    const glm::vec3 normal = normalAt(hit.fragment, glass.mesh, glass.normals, hit.incoming);
    const glm::vec3 inside = glm::normalize(glm::refract(hit.incoming, normal, 1 / index));
    const float alongView =
        std::max(back(hit.pixel.x, hit.pixel.y).distance - glm::distance(place, camera.eye()), 0.0f);
    const float way = by == BackFaceExit::kExpected
                          ? expectedWay(surfaces.raysOf(glass), hit, place, normal, inside, alongView)
                          : searchedWay(back, camera, glass, place, inside);
    const glm::vec3 exit = place + inside * way;
    const std::optional<BackFace> face = backFaceAt(back, camera, exit, glass);
    if (!face) {
      return SecondaryRay{exit, inside};
    }
    const glm::vec3 against = glm::dot(face->normal, inside) > 0 ? -face->normal : face->normal;
    const glm::vec3 out = glm::refract(inside, against, index);
    return SecondaryRay{exit, out != glm::vec3(0) ? glm::normalize(out) : inside};
  });
}

double meanDegreesBetween(const SecondaryRays& a, const SecondaryRays& b) {
  OC_CHECK(a.rays.size() == b.rays.size(), "rays of two pictures");
  double sum = 0;
  for (size_t i = 0; i < a.rays.size(); ++i) {
    sum += degreesFromRadians(static_cast<double>(angleBetween(a.rays[i].direction, b.rays[i].direction)));
  }
  return a.rays.empty() ? 0 : sum / static_cast<double>(a.rays.size());
}

}  // namespace ocelli
