#include "oc_core/ocri/set_difference.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/image_mesh.h"

namespace ocelli {
namespace {

/// World position of the sample at (x, y), if there is one.
std::optional<glm::vec3> positionAt(const ReferenceImage& image, const PinholeCamera& reference, int x, int y) {
  return image.t.contains(x, y) ? image.pointOf(x, y, reference) : std::nullopt;
}

bool holds(const ReferenceImage& other, const PinholeCamera& reference, const Projection& projection,
           const glm::vec3& point, float maxFootprints) {
  const std::optional<ImagePoint> q = projection(point);
  if (!q || !(std::abs(q->u) < PinholeCamera::kMaxPixelsASide && std::abs(q->v) < PinholeCamera::kMaxPixelsASide)) {
    return false;
  }
  const float reach = maxFootprints * q->t / reference.focalPixels();
  const int x = static_cast<int>(std::floor(q->u));
  const int y = static_cast<int>(std::floor(q->v));
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      const std::optional<glm::vec3> held = positionAt(other, reference, u, v);
      if (held && glm::distance(*held, point) <= reach) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

size_t subtract(ReferenceImage& image, const ReferenceImage& other, const Projection& projection,
                const SetDifferenceOptions& options) {
  const PinholeCamera imageReference = image.reference();
  const PinholeCamera otherReference = other.reference();
  Image<uint8_t> marks(image.width(), image.height(), 0);
  parallelFor(static_cast<size_t>(image.height()), 8, [&](size_t begin, size_t end) {
    for (size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < image.width(); ++x) {
        const std::optional<glm::vec3> point = positionAt(image, imageReference, x, y);
        marks(x, y) = point && !holds(other, otherReference, projection, *point, options.maxFootprints) ? 1 : 0;
      }
    }
  });
  for (int step = 0; step < options.seamPixels; ++step) {
    growAlongSurface(marks, image);
  }
  keepMarked(image, marks);
  return image.sampleCount();
}

void growAlongSurface(Image<uint8_t>& marks, const ReferenceImage& image) {
  constexpr std::array<glm::ivec2, 4> kSteps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  const size_t steps = image.rows == ImageRows::kAligned ? 4 : 2;
  const float focal = image.reference().focalPixels();
  const Image<uint8_t> before = marks;
  for (int y = 0; y < marks.height(); ++y) {
    for (int x = 0; x < marks.width(); ++x) {
      if (before(x, y) == 0) {
        continue;
      }
      for (size_t step = 0; step < steps; ++step) {
        const int u = x + kSteps[step].x;
        const int v = y + kSteps[step].y;
        if (!marks.contains(u, v) || !image.holds(u, v)) {
          continue;
        }
        const float footprint = std::min(image.t(x, y), image.t(u, v)) / focal;
        if (std::abs(image.t(x, y) - image.t(u, v)) <= ImageMeshOptions{}.depthStepFootprints * footprint) {
          marks(u, v) = 1;
        }
      }
    }
  }
}

void keepMarked(ReferenceImage& image, const Image<uint8_t>& marks) {
  for (size_t pixel = 0; pixel < marks.size(); ++pixel) {
    if (marks[pixel] == 0) {
      image.clear(pixel);
    }
  }
}

}  // namespace ocelli
