#include "oc_core/ocri/layered_depth_image.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/scene_renderer.h"
#include "oc_core/scene/closed_parts.h"

namespace ocelli {
namespace {

DrawnSides sidesOf(Closure closure) {
  switch (closure) {
    case Closure::kOpen:
      return DrawnSides::kBoth;
    case Closure::kFacesOut:
      return DrawnSides::kFront;
    case Closure::kFacesIn:
      return DrawnSides::kBack;
  }
  OC_CHECK(false, "every closure has its sides");
}

bool isSeen(const PinholeCamera& camera, const Image<float>& depths, const glm::vec3& point) {
  constexpr float kToleranceFootprints = 1.5f;  // of the strict measure of coverage.h
  const auto q = camera.project(point);
  if (!q || !depths.contains(static_cast<int>(std::floor(q->u)), static_cast<int>(std::floor(q->v)))) {
    return false;
  }
  const float nearest = q->t * (1 - kToleranceFootprints / camera.focalPixels());
  for (int dv = -1; dv <= 1; ++dv) {
    for (int du = -1; du <= 1; ++du) {
      const int u = static_cast<int>(std::floor(q->u)) + du;
      const int v = static_cast<int>(std::floor(q->v)) + dv;
      if (depths.contains(u, v) && (depths(u, v) == 0 || depths(u, v) >= nearest)) {
        return true;
      }
    }
  }
  return false;
}

/// Where surfaces lie on each other, as many as are peeled beyond what is asked for.
constexpr int kRepeatedLayers = 6;
/// Samples that are so close behind one that stays are of its surface: squares at rims stand out by two footprints
/// (union_mesh.cpp), and a third is for how unevenly images sample a surface.
constexpr float kRepeatedFootprints = 3;

void moveSample(ReferenceImage& to, ReferenceImage& from, size_t pixel) {
  to.t[pixel] = from.t[pixel];
  to.color[pixel] = from.color[pixel];
  to.held[pixel] = 1;
  from.clear(pixel);
}

/// Drops what repeats the sample before it; those behind move forward. No more than `most` layers stay.
void dropRepeatedSamples(ReferenceImages& layers, size_t most) {
  const float footprint = 1 / layers.front().reference().focalPixels();
  parallelFor(layers.front().t.size(), 1 << 13, [&](size_t begin, size_t end) {
    for (size_t pixel = begin; pixel < end; ++pixel) {
      size_t kept = 0;
      for (ReferenceImage& layer : layers) {
        if (!layer.holds(pixel)) {
          continue;
        }
        const bool repeats =
            kept > 0 && layer.t[pixel] <= layers[kept - 1].t[pixel] * (1 + kRepeatedFootprints * footprint);
        if (repeats) {
          layer.clear(pixel);
        } else if (&layer != &layers[kept]) {
          moveSample(layers[kept++], layer, pixel);
        } else {
          ++kept;
        }
      }
    }
  });
  layers.resize(std::min(layers.size(), most));
  while (layers.size() > 1 && layers.back().sampleCount() == 0) {
    layers.pop_back();
  }
}

}  // namespace

std::vector<DrawnSides> visibleSides(const Mesh& mesh) {
  const std::vector<Closure> closures = closureOfTriangles(mesh);
  std::vector<DrawnSides> sides(closures.size());
  std::transform(closures.begin(), closures.end(), sides.begin(), sidesOf);
  return sides;
}

ReferenceImages buildLayeredDepthImage(const PinholeCamera& reference, const Mesh& mesh, int layers,
                                       const SceneRenderer* renderer) {
  if (layers < 1 || layers > kMaxLayers) {
    throw InputError("a layered depth image of " + std::to_string(layers) + " layers cannot be made", "layers",
                     "choose 1 to " + std::to_string(kMaxLayers));
  }
  std::optional<std::vector<FragmentImage>> drawn =
      renderer != nullptr ? renderer->drawLayers(reference, layers) : std::nullopt;
  if (!drawn) {
    const int peeled = mesh.isSampled ? std::min(kMaxLayers, layers + kRepeatedLayers) : layers;
    drawn = rasterizeLayers(reference, mesh, peeled, visibleSides(mesh));
  }
  ReferenceImages images;
  for (const FragmentImage& fragments : *drawn) {
    ReferenceImage image = referenceImage(fragments, mesh, reference, "ldi");
    // As in the depth image: a pinhole displaces nothing, what is left is rounding.
    std::fill(image.displacement.begin(), image.displacement.end(), glm::vec2(0));
    if (!images.empty() && image.sampleCount() == 0) {
      break;
    }
    images.push_back(std::move(image));
  }
  if (mesh.isSampled) {
    dropRepeatedSamples(images, static_cast<size_t>(layers));
  }
  return images;
}

void dropUnseenSamples(ReferenceImages& layers, const Mesh& mesh, const ViewCell& cell) {
  if (layers.size() < 2) {
    return;
  }
  const PinholeCamera reference = layers[0].reference();
  const size_t width = static_cast<size_t>(reference.width());
  std::vector<Image<unsigned char>> seen(layers.size(), Image<unsigned char>(reference.width(), reference.height()));
  for (const View& view : cell.edgeViews(reference.view())) {
    const PinholeCamera camera(view, reference.width(), reference.height());
    const Image<float> depths = buildDepthImage(camera, mesh).t;
    for (size_t layer = 1; layer < layers.size(); ++layer) {
      parallelFor(depths.size(), 1 << 13, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
          const auto point =
              reference.unproject(layers[layer].undistorted(static_cast<int>(i % width), static_cast<int>(i / width)));
          seen[layer][i] |= point && isSeen(camera, depths, *point);
        }
      });
    }
  }
  for (size_t layer = 1; layer < layers.size(); ++layer) {
    for (size_t i = 0; i < seen[layer].size(); ++i) {
      if (seen[layer][i] == 0) {
        layers[layer].clear(i);
      }
    }
  }
}

}  // namespace ocelli
