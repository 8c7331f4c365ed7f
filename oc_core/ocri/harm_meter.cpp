#include "oc_core/ocri/harm_meter.h"

#include <algorithm>
#include <cmath>

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

/// Those flags, and those around them.
Image<char> widened(const Image<char>& flags) {
  const int width = flags.width();
  const int height = flags.height();
  Image<char> along = flags;
  for (size_t i = 1; i + 1 < flags.size(); ++i) {
    along[i] = static_cast<char>(flags[i - 1] | flags[i] | flags[i + 1]);
  }
  for (int y = 0; y < height && width > 1; ++y) {  // the next pixel of the first and of the last is of another row
    along(0, y) = static_cast<char>(flags(0, y) | flags(1, y));
    along(width - 1, y) = static_cast<char>(flags(width - 2, y) | flags(width - 1, y));
  }
  Image<char> wide = along;
  const auto columns = static_cast<size_t>(width);
  for (size_t i = columns; i < flags.size(); ++i) {
    wide[i] = static_cast<char>(wide[i] | along[i - columns]);
    wide[i - columns] = static_cast<char>(wide[i - columns] | along[i]);
  }
  return wide;
}

/// An image of geometry alone: without colours.
ReferenceImage blankGeometry(const PinholeCamera& reference) {
  const int width = reference.width();
  const int height = reference.height();
  return {.camera = "ddoc",
          .view = reference.view(),
          .color = {},
          .t = Image<float>(width, height),
          .held = Image<uint8_t>(width, height),
          .displacement = Image<glm::vec2>(width, height)};
}

/// The samples that `isWanted` holds for.
template <class Predicate>
ReferenceImage selectSamples(const ReferenceImage& image, const PinholeCamera& reference, const Predicate& isWanted) {
  ReferenceImage selected = blankGeometry(reference);
  forPixels(image.width(), image.height(), [&](int x, int y) {
    if (image.holds(x, y) && isWanted(x, y)) {
      selected.t(x, y) = image.t(x, y);
      selected.held(x, y) = 1;
      selected.displacement(x, y) = image.displacement(x, y);
    }
  });
  return selected;
}

/// The geometry of an occlusion camera's image. Fragments that are the pinhole's own have no displacement, whatever
/// mesh they are from.
ReferenceImage sampleImage(const FragmentImage& fragments, const Mesh& mesh, const FragmentImage& seen,
                           const PinholeCamera& reference) {
  ReferenceImage image = blankGeometry(reference);
  forPixels(fragments.width(), fragments.height(), [&](int x, int y) {
    const Fragment& fragment = fragments(x, y);
    if (!fragment.covered()) {
      return;
    }
    image.t(x, y) = fragment.t;
    image.held(x, y) = 1;
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
  ReferenceImage seen = blankGeometry(reference_);
  forPixels(width, height, [&](int x, int y) {
    const glm::vec2 corner(static_cast<float>(x), static_cast<float>(y));
    if (seen_(x, y).covered() && camera.displacesWithin({corner - 1.0f, corner + 2.0f})) {
      seen.t(x, y) = seen_(x, y).t;
      seen.held(x, y) = 1;
    }
  });
  surfaces_ = imageMesh(seen);

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
  hidden = widened(hidden);
  append(surfaces_, imageMesh(selectSamples(image, reference_, [&](int x, int y) { return hidden(x, y) != 0; })));
  surfacesPart_ = wholeOf(surfaces_, reference_);
}

/// As compareFrames() of what the reference pinhole sees with what the image's mesh shows it, but only where the two
/// images differ: elsewhere nothing can be missing.
Image<SampleState> HarmMeter::compare(const DdocCamera& camera, const ReferenceImage& image) const {
  const int width = image.width();
  const int height = image.height();
  Image<char> changed(width, height, 0);
  forPixels(width, height, [&](int x, int y) { changed(x, y) = image.t(x, y) != seen_(x, y).t; });
  const Image<char> nearChanged = widened(changed);
  const Mesh moved = imageMesh(selectSamples(image, reference_, [&](int x, int y) { return nearChanged(x, y) != 0; }));
  Image<glm::vec4> frame = positionImage(reference_, moved);
  Image<glm::vec4> truth(width, height, glm::vec4(0));
  const auto seenPoint = [&](int x, int y) { return glm::vec4(positionOf(seen_(x, y), mesh_), 1); };
  Image<char> judged(width, height, 0);
  forPixels(width, height, [&](int x, int y) {
    if (seen_(x, y).covered() && (changed(x, y) != 0 || !keepsPlace(camera, x, y, seen_(x, y).t))) {
      truth(x, y) = seenPoint(x, y);
      judged(x, y) = 1;
    }
  });
  const Image<char> nearJudged = widened(judged);
  forPixels(width, height, [&](int x, int y) {
    if (nearJudged(x, y) != 0 && seen_(x, y).covered() && changed(x, y) == 0) {
      frame(x, y) = seenPoint(x, y);
    }
  });
  return compareFrames(reference_, truth, frame);
}

Harm HarmMeter::measure(const DdocCamera& camera, const std::vector<DistortionSplat>& splats,
                        const SplatOwners& owners) {
  return measureIn(draw(camera), camera, splats, owners);
}

Harm HarmMeter::measureIn(const ReferenceImage& image, const DdocCamera& camera,
                          const std::vector<DistortionSplat>& splats, const SplatOwners& owners) const {
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
