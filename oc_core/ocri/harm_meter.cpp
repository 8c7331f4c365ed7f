#include "oc_core/ocri/harm_meter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/image_mesh.h"
#include "oc_core/render/displacement_reach.h"
#include "oc_core/render/scene_renderer.h"

namespace ocelli {
namespace {

/// A sample this much farther away than the pinhole's at the same place is hidden from it, pixel footprints.
constexpr float kHiddenFootprints = 2;

template <class Body>
void forPixels(int width, int height, const Body& body) {
  parallelFor(static_cast<size_t>(height), 8, [&](size_t begin, size_t end) {
    for (size_t y = begin; y < end; ++y) {
      for (int x = 0; x < width; ++x) {
        body(x, static_cast<int>(y));
      }
    }
  });
}

bool anyAround(const Image<char>& flags, int x, int y) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, flags.height() - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, flags.width() - 1); ++u) {
      if (flags(u, v) != 0) {
        return true;
      }
    }
  }
  return false;
}

/// The samples that `isWanted` holds for, without colours.
template <class Predicate>
ReferenceImage selectSamples(const ReferenceImage& image, const Predicate& isWanted) {
  ReferenceImage selected = image;
  forPixels(image.width(), image.height(), [&](int x, int y) {
    if (image.holds(x, y) && !isWanted(x, y)) {
      selected.clear(selected.t.index(x, y));
    }
  });
  return selected;
}

/// The geometry of an occlusion camera's image; its samples are all black. Fragments that are the pinhole's own have no
/// displacement, whatever mesh they are from.
ReferenceImage sampleImage(const FragmentImage& fragments, const Mesh& mesh, const FragmentImage& seen,
                           const PinholeCamera& reference) {
  const int width = fragments.width();
  const int height = fragments.height();
  ReferenceImage image = blankReferenceImage("ddoc", reference.view(), width, height);
  forPixels(width, height, [&](int x, int y) {
    const Fragment& fragment = fragments(x, y);
    if (!fragment.covered()) {
      return;
    }
    image.set(x, y, fragment.t, glm::vec3(0));
    if (fragment != seen(x, y)) {
      const ImagePoint q = reference.imageFromCamera(reference.cameraFromWorld(positionOf(fragment, mesh)));
      image.t(x, y) = q.t;
      image.displacement(x, y) = {static_cast<float>(x) + 0.5f - q.u, static_cast<float>(y) + 0.5f - q.v};
    }
  });
  return image;
}

TrianglePart wholeOf(const Mesh& mesh, const PinholeCamera& reference) {
  return selectTriangles(std::make_shared<const ProjectedMesh>(reference, mesh), [](const ImageBox&) { return true; });
}

}  // namespace

/// The first time this draws the scene. As bands only shrink, all that can show later is seen by the reference pinhole
/// or in that image: later on this draws the meshes of these two, whatever the size of the scene.
ReferenceImage HarmMeter::draw(const DdocCamera& camera) {
  if (!surfaces_.empty()) {
    return sampleImage(rasterize(camera, seen_, surfacesPart_, subdivision_), surfaces_, seen_, reference_);
  }
  const FragmentImage drawn = renderer_ != nullptr ? renderer_->draw(camera, seen_, subdivision_)
                                                   : rasterize(camera, seen_, part_, subdivision_);
  ReferenceImage image = sampleImage(drawn, mesh_, seen_, reference_);
  gatherSurfaces(camera, image);
  return image;
}

void HarmMeter::gatherSurfaces(const DdocCamera& camera, const ReferenceImage& image) {
  const int width = image.width();
  const int height = image.height();
  const ReferenceImage seen = sampleImage(seen_, mesh_, seen_, reference_);
  surfaces_ = imageMesh(selectSamples(seen, [&](int x, int y) {
    const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
    return camera.displacesWithin({corner - 1.0f, corner + 2.0f});
  }));

  Image<char> hidden(width, height, 0);
  forPixels(width, height, [&](int x, int y) {
    if (image.holds(x, y) && image.displacement(x, y) != glm::vec2(0)) {
      const ImagePoint q = image.undistorted(x, y);
      const int u = static_cast<int>(std::floor(q.u));
      const int v = static_cast<int>(std::floor(q.v));
      const float footprint = q.t / reference_.focalPixels();
      hidden(x, y) =
          !seen_.contains(u, v) || !seen_(u, v).covered() || seen_(u, v).t < q.t - kHiddenFootprints * footprint;
    }
  });
  // With their neighbours, so that no gap opens between the two meshes.
  append(surfaces_, imageMesh(selectSamples(image, [&](int x, int y) { return anyAround(hidden, x, y); })));
  surfacesPart_ = wholeOf(surfaces_, reference_);
}

/// As compareFrames() of what the reference pinhole sees with what the image's mesh shows it, but only where the two
/// images differ: elsewhere nothing can be missing.
Image<SampleState> HarmMeter::compare(const DdocCamera& camera, const ReferenceImage& image) const {
  const int width = image.width();
  const int height = image.height();
  Image<char> changed(width, height, 0);
  forPixels(width, height, [&](int x, int y) { changed(x, y) = image.t(x, y) != seen_(x, y).t; });
  const Mesh moved = imageMesh(selectSamples(image, [&](int x, int y) { return anyAround(changed, x, y); }));
  Image<glm::vec4> frame = positionImage(reference_, moved);
  Image<glm::vec4> truth(width, height, glm::vec4(0));
  forPixels(width, height, [&](int x, int y) {
    if (!seen_(x, y).covered()) {
      return;
    }
    const glm::vec4 point(positionOf(seen_(x, y), mesh_), 1);
    const ImagePoint p = seenAt(x, y);
    const ImagePoint q = camera.distort(p);
    if (changed(x, y) != 0 || q.u != p.u || q.v != p.v) {
      truth(x, y) = point;
    }
    if (changed(x, y) == 0) {
      frame(x, y) = point;
    }
  });
  return compareFrames(reference_, truth, frame);
}

Harm HarmMeter::measure(const DdocCamera& camera, const std::vector<DistortionSplat>& splats,
                        const SplatOwners& owners) {
  const ReferenceImage image = draw(camera);
  const Image<SampleState> states = compare(camera, image);
  Harm harm;
  harm.ofSplats.resize(splats.size());
  // To blame are the splats that moved the sample, and those that moved what now lies in front of it.
  const auto blame = [&](const ImagePoint& undistorted) {
    const int x = static_cast<int>(std::floor(undistorted.u));
    const int y = static_cast<int>(std::floor(undistorted.v));
    if (owners.contains(x, y) && owners(x, y) >= 0) {
      const auto owner = static_cast<size_t>(owners(x, y));
      harm.ofSplats[owner] += 1 / undistorted.t < splats[owner].edge.inverseNear;
    }
  };
  for (int y = 0; y < seen_.height(); ++y) {
    for (int x = 0; x < seen_.width(); ++x) {
      if (states(x, y) != SampleState::kMissing && states(x, y) != SampleState::kMissingThick) {
        continue;
      }
      ++harm.missing;
      const ImagePoint p = seenAt(x, y);
      const ImagePoint q = camera.distort(p);
      for (int v = static_cast<int>(std::floor(q.v)) - 1; v <= static_cast<int>(std::floor(q.v)) + 1; ++v) {
        for (int u = static_cast<int>(std::floor(q.u)) - 1; u <= static_cast<int>(std::floor(q.u)) + 1; ++u) {
          if (image.t.contains(u, v) && image.holds(u, v) && image.t(u, v) < p.t) {
            blame(image.undistorted(u, v));
          }
        }
      }
      blame(p);
    }
  }
  return harm;
}

}  // namespace ocelli
