#include "oc_core/ocri/coverage.h"

#include <glm/geometric.hpp>
#include <random>

#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize.h"

namespace ocelli {
namespace {

constexpr float kStrictFootprints = 1.5f;

bool isPresent(const PinholeCamera& camera, const glm::vec3& point, const Image<glm::vec4>& frame, int x, int y) {
  const float reach = kStrictFootprints * camera.cameraFromWorld(point).z / camera.focalPixels();
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      if (frame.contains(u, v) && frame(u, v).w > 0 && glm::distance(glm::vec3(frame(u, v)), point) <= reach) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

MissingSamples& MissingSamples::operator+=(const MissingSamples& other) {
  truth += other.truth;
  strict += other.strict;
  thick += other.thick;
  return *this;
}

Image<glm::vec4> positionImage(const PinholeCamera& camera, const Mesh& mesh) {
  const FragmentImage fragments = rasterize(camera, mesh);
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
      states(x, y) =
          isPresent(camera, glm::vec3(truth(x, y)), frame, x, y) ? SampleState::kPresent : SampleState::kMissing;
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

std::vector<View> ViewCell::edgeViews(const View& reference) const {
  std::vector<View> views;
  const float half = sideRadii / 2;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      glm::vec3 offset(0);
      offset[(axis + 1) % 3] = (corner & 1) != 0 ? half : -half;
      offset[(axis + 2) % 3] = (corner & 2) != 0 ? half : -half;
      views.push_back(movedEye(reference, offset));
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    views.push_back(movedEye(reference, {(corner & 1) != 0 ? half : -half, (corner & 2) != 0 ? half : -half,
                                         (corner & 4) != 0 ? half : -half}));
  }
  return views;
}

std::vector<View> ViewCell::interiorViews(const View& reference, int count, unsigned seed) const {
  std::mt19937 random(seed);
  // Not std::uniform_real_distribution: its values differ between standard libraries.
  const auto next = [&] {
    return (static_cast<float>(random() >> 8) / static_cast<float>(1 << 24) - 0.5f) * sideRadii;
  };
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    const float x = next();
    const float y = next();
    const float z = next();
    views.push_back(movedEye(reference, {x, y, z}));
  }
  return views;
}

}  // namespace ocelli
