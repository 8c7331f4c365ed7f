#include "oc_core/ocri/ddoc_builder.h"

#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/depth_edges.h"
#include "oc_core/ocri/distortion_splats.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

/// The parallax between occluder and background, in pixels, over the view cell: a step of the eye along the normal n of the
/// edge uncovers f * step * (1/zn - 1/zf). The longest step within a square along n is its support |nx| + |ny| half sides.
float uncoveredPixels(const DepthEdge& edge, const PinholeCamera& camera, const DdocOptions& options) {
  const float support = options.cellSideRadii / 2 * (std::abs(edge.normal.x) + std::abs(edge.normal.y));
  return camera.focalPixels() * support * (edge.inverseNear - edge.inverseFar);
}

std::vector<DistortionSplat> makeSplats(const std::vector<DepthEdge>& edges, const PinholeCamera& camera,
                                        const DdocOptions& options) {
  std::vector<DistortionSplat> splats;
  for (const DepthEdge& edge : edges) {
    DistortionSplat splat{edge, options.constantRadiusPixels, options.constantRadiusPixels};
    if (options.radius == DdocOptions::Radius::kViewCell) {
      splat.hidden = std::min(uncoveredPixels(edge, camera, options) * options.safetyFactor, options.mostHiddenPixels);
      splat.room = splat.hidden * options.roomPerHidden;
    }
    splats.push_back(splat);
  }
  return splats;
}

DistortionMap mapOf(const std::vector<DistortionSplat>& splats, const SplatOwners& owners, const DdocOptions& options) {
  if (options.smoothingSigmaPixels <= 0) {
    return finalizeMap(splats, owners, DistortionMap::Lookup::kNearest);
  }
  return smoothMap(finalizeMap(splats, owners, DistortionMap::Lookup::kBilinear), options.smoothingSigmaPixels);
}

/// "Do no harm": shrinks the splats that bury samples which the reference view sees. Returns how many samples are buried.
size_t shrinkHarmful(std::vector<DistortionSplat>& splats, const SplatOwners& owners, const FragmentImage& seen,
                     const DdocCamera& camera, const Mesh& mesh, const DdocOptions& options) {
  const PinholeCamera& reference = camera.reference();
  const FragmentImage image = rasterize(camera, mesh, options.subdivision);
  Image<glm::vec3> points(image.width(), image.height(), glm::vec3(1e30f));
  parallelFor(image.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (image[i].covered()) {
        points[i] = reference.cameraFromWorld(positionOf(image[i], mesh));
      }
    }
  });

  std::vector<int> harm(splats.size());
  size_t buried = 0;
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      if (!seen(x, y).covered()) {
        continue;
      }
      const glm::vec3 point = reference.cameraFromWorld(positionOf(seen(x, y), mesh));
      const ImagePoint q = camera.distort(reference.imageFromCamera(point));
      const int u = static_cast<int>(std::floor(q.u));
      const int v = static_cast<int>(std::floor(q.v));
      const float reach = (1.5f + options.mostHiddenPerRoom) * point.z / reference.focalPixels();
      bool present = false;
      glm::vec3 blocker(1e30f);
      for (int dv = -1; dv <= 1 && !present; ++dv) {
        for (int du = -1; du <= 1 && !present; ++du) {
          if (points.contains(u + du, v + dv)) {
            const glm::vec3& other = points(u + du, v + dv);
            present = glm::distance(other, point) <= reach;
            if (other.z < blocker.z) {
              blocker = other;
            }
          }
        }
      }
      if (present) {
        continue;
      }
      ++buried;
      // Whoever moved is to blame: the sample itself, and what now lies in front of it.
      const auto blame = [&](float pu, float pv, float inverseZ) {
        const int px = static_cast<int>(std::floor(pu));
        const int py = static_cast<int>(std::floor(pv));
        if (owners.contains(px, py) && owners(px, py) >= 0) {
          const DistortionSplat& splat = splats[static_cast<size_t>(owners(px, py))];
          if (inverseZ < splat.edge.inverseNear) {
            ++harm[static_cast<size_t>(owners(px, py))];
          }
        }
      };
      if (blocker.z < point.z) {
        const ImagePoint b = reference.imageFromCamera(blocker);
        blame(b.u, b.v, 1 / b.z);
      }
      blame(static_cast<float>(x), static_cast<float>(y), 1 / point.z);
    }
  }
  for (size_t i = 0; i < splats.size(); ++i) {
    if (harm[i] > 0) {
      splats[i].hidden *= options.feedbackShrink;
    }
  }
  return buried;
}

}  // namespace

DdocOptions DdocOptions::paper(float constantRadiusPixels) {
  DdocOptions options;
  options.radius = Radius::kConstant;
  options.constantRadiusPixels = constantRadiusPixels;
  options.mostHiddenPerRoom = 1;
  options.feedbackRounds = 0;
  options.smoothingSigmaPixels = 0;
  return options;
}

DdocCamera buildDdocCamera(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                           const Progress& progress) {
  // Steps 1 and 2.
  report(progress, "depth edges", 0);
  const FragmentImage seen = rasterize(reference, mesh);
  Image<float> inverseZ(seen.width(), seen.height(), 0);
  float farthest = 0;
  for (size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].covered()) {
      inverseZ[i] = 1 / seen[i].z;
      farthest = std::max(farthest, seen[i].z);
    }
  }
  DepthEdgeOptions edgeOptions;
  // A step counts when the view cell can uncover at least one pixel behind it.
  edgeOptions.leastInverseZStep = 1 / (reference.focalPixels() * options.cellSideRadii / 2);
  edgeOptions.backgroundInverseZ = farthest > 0 ? 1 / farthest : 0;
  const std::vector<DepthEdge> edges = findDepthEdges(inverseZ, edgeOptions);

  // Steps 3 to 6.
  std::vector<DistortionSplat> splats = makeSplats(edges, reference, options);
  SplatOwners owners = claimPixels(splats, seen.width(), seen.height());
  shrinkConflicts(splats, owners, options.mostHiddenPerRoom);
  owners = claimPixels(splats, seen.width(), seen.height());
  DdocCamera camera(reference, mapOf(splats, owners, options));
  for (int round = 0; round < options.feedbackRounds; ++round) {
    report(progress, "do no harm", static_cast<double>(round) / options.feedbackRounds);
    if (shrinkHarmful(splats, owners, seen, camera, mesh, options) == 0) {
      break;
    }
    owners = claimPixels(splats, seen.width(), seen.height());
    camera = DdocCamera(reference, mapOf(splats, owners, options));
  }
  return camera;
}

ReferenceImage buildDdocImage(const DdocCamera& camera, const Mesh& mesh, const SubdivisionOptions& options) {
  return referenceImage(rasterize(camera, mesh, options), mesh, camera.reference(), "ddoc");
}

}  // namespace ocelli
