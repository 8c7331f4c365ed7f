#include "oc_core/ocri/coverage.h"

#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
bool hasSampleNear(const Image<glm::vec4>& positions, int x, int y, const glm::vec3& point, float reach) {
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      if (positions.contains(u, v) && positions(u, v).w > 0 &&
          glm::distance(glm::vec3(positions(u, v)), point) <= reach) {
        return true;
      }
    }
  }
  return false;
}

MissingSamples& MissingSamples::operator+=(const MissingSamples& other) {
  truth += other.truth;
  strict += other.strict;
  thick += other.thick;
  return *this;
}

Image<glm::vec4> positionImage(const PinholeCamera& camera, const Mesh& mesh) {
  return positionImage(rasterize(camera, mesh), mesh);
}

Image<glm::vec4> positionImage(const FragmentImage& fragments, const Mesh& mesh) {
  Image<glm::vec4> positions(fragments.width(), fragments.height(), glm::vec4(0));
  parallelFor(fragments.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (fragments[i].covered()) {
        positions[i] = glm::vec4(positionOf(fragments[i], mesh), 1);
      }
    }
  });
  return positions;
}

Image<SampleState> compareFrames(const PinholeCamera& camera, const Image<glm::vec4>& truth,
                                 const Image<glm::vec4>& frame) {
  const int width = truth.width();
  const int height = truth.height();
  OC_CHECK(frame.width() == width && frame.height() == height, "truth and frame have the same size");
  Image<SampleState> states(width, height, SampleState::kNoTruth);
  const auto forRows = [&](const auto& body) {
    parallelFor(static_cast<size_t>(height), 8, [&](size_t begin, size_t end) {
      for (size_t y = begin; y < end; ++y) {
        for (int x = 0; x < width; ++x) {
          body(x, static_cast<int>(y));
        }
      }
    });
  };
  forRows([&](int x, int y) {
    if (truth(x, y).w > 0) {
      const glm::vec3 point(truth(x, y));
      states(x, y) =
          hasSampleNear(frame, x, y, point, nearReach(camera, point)) ? SampleState::kPresent : SampleState::kMissing;
    }
  });
  const Image<SampleState> strict = states;
  forRows([&](int x, int y) {
    for (int v = y - 1; v <= y + 1; ++v) {
      for (int u = x - 1; u <= x + 1; ++u) {
        if (!strict.contains(u, v) || strict(u, v) != SampleState::kMissing) {
          return;
        }
      }
    }
    states(x, y) = SampleState::kMissingThick;
  });
  return states;
}

MissingSamples countMissing(const Image<SampleState>& states) {
  MissingSamples count;
  for (const SampleState state : states) {
    count.truth += state != SampleState::kNoTruth;
    count.strict += state == SampleState::kMissing || state == SampleState::kMissingThick;
    count.thick += state == SampleState::kMissingThick;
  }
  return count;
}

}  // namespace ocelli
