#include "oc_core/ocri/ddoc_builder.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/coverage.h"
#include "oc_core/ocri/depth_edges.h"
#include "oc_core/ocri/distortion_splats.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/ocri/visible_part.h"

namespace ocelli {
namespace {

/// z of each pixel, 0 where nothing is seen.
Image<float> depthsOf(const PinholeCamera& camera, const Image<glm::vec4>& seen) {
  Image<float> z(seen.width(), seen.height(), 0);
  for (size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].w > 0) {
      z[i] = camera.cameraFromWorld(glm::vec3(seen[i])).z;
    }
  }
  return z;
}

std::vector<DepthEdge> findEdges(const PinholeCamera& camera, const Image<float>& depths, const DdocOptions& options) {
  Image<float> inverseZ(depths.width(), depths.height(), 0);
  std::transform(depths.begin(), depths.end(), inverseZ.begin(), [](float z) { return z > 0 ? 1 / z : 0; });
  DepthEdgeOptions edgeOptions;
  // A step counts when the view cell can uncover a pixel behind it.
  edgeOptions.leastInverseZStep = 1 / (camera.focalPixels() * options.cellSideRadii / 2);
  // What lies behind everything has no depth of its own: it takes that of the farthest sample.
  float farthest = 0;
  for (const float w : inverseZ) {
    farthest = w > 0 && (farthest == 0 || w < farthest) ? w : farthest;
  }
  edgeOptions.backgroundInverseZ = farthest;
  return findDepthEdges(inverseZ, edgeOptions);
}

/// The parallax between occluder and background, in pixels, over the view cell: a step of the eye along the normal n of
/// the edge uncovers f * step * (1/zn - 1/zf). The longest step within a square along n is its support |nx| + |ny| half
/// sides.
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

ReferenceImage render(const DdocCamera& camera, const Mesh& mesh, const SubdivisionOptions& options) {
  return referenceImage(rasterize(camera, mesh, options), mesh, camera.reference(), "ddoc");
}

/// "Do no harm": shrinks the splats that cost samples which the reference view sees. Returns how many it lacks.
size_t shrinkHarmful(std::vector<DistortionSplat>& splats, const SplatOwners& owners, const Image<glm::vec4>& seen,
                     const DdocCamera& camera, const ReferenceImage& image, const DdocOptions& options) {
  const PinholeCamera& reference = camera.reference();
  const Image<SampleState> states = compareFrames(reference, seen, positionImage(reference, imageMesh(image)));

  std::vector<int> harm(splats.size());
  size_t missing = 0;
  // Whoever moved is to blame: the sample itself, and what now lies in front of it.
  const auto blame = [&](float u, float v, float inverseZ) {
    const int x = static_cast<int>(std::floor(u));
    const int y = static_cast<int>(std::floor(v));
    if (owners.contains(x, y) && owners(x, y) >= 0) {
      const auto owner = static_cast<size_t>(owners(x, y));
      harm[owner] += inverseZ < splats[owner].edge.inverseNear;
    }
  };
  for (int y = 0; y < seen.height(); ++y) {
    for (int x = 0; x < seen.width(); ++x) {
      if (states(x, y) != SampleState::kMissing && states(x, y) != SampleState::kMissingThick) {
        continue;
      }
      ++missing;
      const glm::vec3 point = reference.cameraFromWorld(glm::vec3(seen(x, y)));
      const ImagePoint q = camera.distort(reference.imageFromCamera(point));
      const int u = static_cast<int>(std::floor(q.u));
      const int v = static_cast<int>(std::floor(q.v));
      for (int dv = -1; dv <= 1; ++dv) {
        for (int du = -1; du <= 1; ++du) {
          if (image.z.contains(u + du, v + dv) && image.z(u + du, v + dv) > 0) {
            const ImagePoint other = image.undistorted(u + du, v + dv);
            if (other.z < point.z) {
              blame(other.u, other.v, 1 / other.z);
            }
          }
        }
      }
      blame(static_cast<float>(x), static_cast<float>(y), 1 / point.z);
    }
  }
  for (size_t i = 0; i < splats.size(); ++i) {
    if (static_cast<float>(harm[i]) > options.harmlessPerHiddenPixel * splats[i].hidden) {
      splats[i].hidden *= options.feedbackShrink;
    }
  }
  return missing;
}

}  // namespace

DdocOptions DdocOptions::paper(float constantRadiusPixels) {
  DdocOptions options;
  options.radius = Radius::kConstant;
  options.constantRadiusPixels = constantRadiusPixels;
  options.conflicts = Conflicts::kAll;
  options.mostHiddenPerRoom = 1;
  options.feedbackRounds = 0;
  options.steepestBandGrowth = 0;
  options.smoothingSigmaPixels = 0;
  return options;
}

DdocCamera buildDdocCamera(const PinholeCamera& reference, const Mesh& mesh, const DdocOptions& options,
                           const Progress& progress) {
  // Steps 1 and 2.
  report(progress, "depth edges", 0);
  const Image<glm::vec4> seen = positionImage(reference, mesh);
  const Image<float> depths = depthsOf(reference, seen);
  const std::vector<DepthEdge> edges = findEdges(reference, depths, options);

  // Steps 3 to 6.
  std::vector<DistortionSplat> splats = makeSplats(edges, reference, options);
  SplatOwners owners = claimPixels(splats, seen.width(), seen.height());
  shrinkConflicts(splats, owners, options.conflicts, options.mostHiddenPerRoom);
  limitBandGrowth(splats, options.steepestBandGrowth);
  owners = claimPixels(splats, seen.width(), seen.height());
  DdocCamera camera(reference, mapOf(splats, owners, options));

  // The first round draws the whole scene, later ones what can show in images that differ from it by less displacement.
  Mesh part;
  for (int round = 0; round < options.feedbackRounds; ++round) {
    report(progress, "do no harm", static_cast<double>(round) / options.feedbackRounds);
    const ReferenceImage image = render(camera, round == 0 ? mesh : part, options.feedbackSubdivision);
    if (round == 0) {
      part = visiblePart(mesh, camera, depths, image.z);
    }
    if (shrinkHarmful(splats, owners, seen, camera, image, options) == 0) {
      break;
    }
    limitBandGrowth(splats, options.steepestBandGrowth);
    owners = claimPixels(splats, seen.width(), seen.height());
    camera = DdocCamera(reference, mapOf(splats, owners, options));
  }
  report(progress, "do no harm", 1);
  return camera;
}

ReferenceImage buildDdocImage(const DdocCamera& camera, const Mesh& mesh, const SubdivisionOptions& options) {
  ReferenceImage image = render(camera, mesh, options);
  image.triangleBound = imageMesh(buildDepthImage(camera.reference(), mesh)).triangles.size();
  return image;
}

}  // namespace ocelli
