#include "oc_core/ocri/viewers.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/set_difference.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

glm::vec3 turnedAboutAxis(const glm::vec3& v, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  return glm::vec3(glm::dvec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x));
}

/// Samples that gave in to the bound of their mesh are in no triangle, but held: each gets one of its own, a point.
Mesh withSamplesAlone(Mesh mesh) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const glm::uvec3& t : mesh.triangles) {
    used[t.x] = used[t.y] = used[t.z] = true;
  }
  for (uint32_t vertex = 0; vertex < used.size(); ++vertex) {
    if (!used[vertex]) {
      mesh.triangles.emplace_back(vertex, vertex, vertex);
    }
  }
  return mesh;
}

/// What earlier viewers show.
class HeldSurface {
 public:
  HeldSurface(const Mesh& mesh, const ViewerMergeOptions& options) : mesh_(mesh), scene_(mesh), options_(options) {}

  bool holds(const glm::vec3& point, float footprint) const {
    const auto closest = scene_.closestSurface(point, options_.maxFootprints * footprint);
    if (!closest) {
      return false;
    }
    const glm::uvec3& t = mesh_.triangles[closest->triangle];
    for (int corner = 0; corner < 3; ++corner) {
      if (glm::distance(mesh_.positions[t[corner]], point) <= options_.maxFootprintsToSample * footprint) {
        return true;
      }
    }
    return false;
  }

 private:
  const Mesh& mesh_;
  RayScene scene_;
  const ViewerMergeOptions& options_;
};

void subtract(ReferenceImage& image, const HeldSurface& held, int seamPixels) {
  const PinholeCamera reference = image.reference();
  Image<uint8_t> marks(image.width(), image.height(), 0);
  parallelFor(static_cast<size_t>(image.height()), 4, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < image.width(); ++x) {
        const std::optional<glm::vec3> point = image.pointOf(x, y, reference);
        marks(x, y) = point && !held.holds(*point, image.t(x, y) / reference.focalPixels()) ? 1 : 0;
      }
    }
  });
  for (int step = 0; step < seamPixels; ++step) {
    growAlongSurface(marks, image);
  }
  keepMarked(image, marks);
}

size_t sampleCount(const ReferenceImages& images) {
  size_t samples = 0;
  for (const ReferenceImage& image : images) {
    samples += image.sampleCount();
  }
  return samples;
}

}  // namespace

std::vector<View> viewsAround(const View& first, int count) {
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    const double radians = 2 * kPi * i / count;
    views.push_back(first);
    if (i > 0) {
      views.back().eye = turnedAboutAxis(first.eye, radians);
      views.back().target = turnedAboutAxis(first.target, radians);
      views.back().up = turnedAboutAxis(first.up, radians);
    }
  }
  return views;
}

MergedViewers mergeViewers(std::vector<ReferenceImages> viewers, const ViewerMergeOptions& options) {
  MergedViewers merged;
  Mesh shown;
  for (ReferenceImages& images : viewers) {
    for (ReferenceImage& image : images) {
      image.seenFromAside = image.seenFromAside || viewers.size() > 1;
    }
    ViewerShare share{.built = sampleCount(images)};
    if (!shown.empty()) {
      const HeldSurface held(shown, options);
      for (ReferenceImage& image : images) {
        subtract(image, held, options.seamPixels);
      }
    }
    share.kept = sampleCount(images);
    if (&images != &viewers.back()) {
      append(shown, withSamplesAlone(unionMesh(images)));
    }
    merged.shares.push_back(share);
    std::move(images.begin(), images.end(), std::back_inserter(merged.images));
  }
  return merged;
}

}  // namespace ocelli
