#include "oc_core/relief/relief_errors.h"

#include <algorithm>
#include <cmath>

#include "oc_core/base/parallel.h"
#include "oc_core/image/color.h"
#include "oc_core/image/image_error.h"
#include "oc_core/ocri/coverage.h"

namespace ocelli {
namespace {

bool showsTile(const ReliefPicture& picture, size_t pixel) {
  return picture.shown[pixel] >= 0;
}

ReliefState stateOf(const ReliefPicture& truth, const ReliefPicture& picture, size_t pixel, const RayScene& tiles,
                    const PinholeCamera& camera) {
  const bool real = showsTile(truth, pixel);
  const bool shown = showsTile(picture, pixel);
  if (!real && !shown) {
    return ReliefState::kElsewhere;
  }
  const float z = real ? truth.z[pixel] : picture.z[pixel];
  const float near = kNearFootprints * z / camera.focalPixels();
  if (real && shown && std::abs(picture.z[pixel] - truth.z[pixel]) <= near) {
    return ReliefState::kRight;
  }
  if (shown && !tiles.hasSurfaceNear(picture.point[pixel], near)) {
    return ReliefState::kFalse;
  }
  const bool farther = !shown || picture.z[pixel] > truth.z[pixel];
  return real && farther ? ReliefState::kMissing : ReliefState::kOther;
}

}  // namespace

ReliefPicture traceTiles(const TracedTiles& traced, const PinholeCamera& camera, const ReliefDrawing& how) {
  // The same renderer, without tiles: all of it is geometry.
  const auto none = std::make_shared<const ReliefScene>(ReliefScene::Objects{}, std::vector<ReliefTile>{});
  // Not owned: what it points to outlives the renderer.
  const std::shared_ptr<const PlainGeometry> all(std::shared_ptr<const PlainGeometry>(), &traced.all);
  ReliefPicture picture = ReliefRenderer(none, all).draw(camera, how);
  for (size_t i = 0; i < picture.shown.size(); ++i) {
    if (picture.shown[i] == ReliefPicture::kGeometry && picture.triangle[i] < traced.tileTriangles) {
      picture.shown[i] = 0;
    }
  }
  return picture;
}

Image<ReliefState> reliefStates(const ReliefPicture& truth, const ReliefPicture& picture, const RayScene& tiles,
                                const PinholeCamera& camera) {
  Image<ReliefState> states(camera.width(), camera.height());
  parallelFor(states.size(), 1 << 10, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      states[i] = stateOf(truth, picture, i, tiles, camera);
    }
  });
  return states;
}

double ReliefFigures::wrongShare() const {
  return tilePixels > 0 ? static_cast<double>(wrong) / static_cast<double>(tilePixels) : 0;
}

double ReliefFigures::psnrDecibels() const {
  const double values = 255.0 * 255 * 3 * static_cast<double>(comparedPixels);
  return ocelli::psnrDecibels(comparedPixels > 0 ? squaredError / values : 0);
}

ReliefFigures& ReliefFigures::operator+=(const ReliefFigures& more) {
  tilePixels += more.tilePixels;
  wrong += more.wrong;
  missing += more.missing;
  falseSurface += more.falseSurface;
  other += more.other;
  sunPixels += more.sunPixels;
  shadowWrong += more.shadowWrong;
  squaredError += more.squaredError;
  comparedPixels += more.comparedPixels;
  return *this;
}

ReliefFigures reliefFigures(const ReliefPicture& truth, const ReliefPicture& picture,
                            const Image<ReliefState>& states) {
  ReliefFigures figures;
  for (size_t i = 0; i < states.size(); ++i) {
    const ReliefState state = states[i];
    figures.tilePixels += showsTile(truth, i);
    figures.missing += state == ReliefState::kMissing;
    figures.falseSurface += state == ReliefState::kFalse;
    figures.other += state == ReliefState::kOther;
    const bool same =
        state == ReliefState::kRight || (state == ReliefState::kElsewhere && truth.shown[i] != ReliefPicture::kNothing);
    figures.sunPixels += same;
    figures.shadowWrong += same && truth.inShadow[i] != picture.inShadow[i];
    if (state != ReliefState::kElsewhere) {
      ++figures.comparedPixels;
      for (int channel = 0; channel < 3; ++channel) {
        const float difference = srgbFromLinear(glm::clamp(truth.color[i][channel], 0.0f, 1.0f)) -
                                 srgbFromLinear(glm::clamp(picture.color[i][channel], 0.0f, 1.0f));
        figures.squaredError += static_cast<double>(difference * difference * 255 * 255);
      }
    }
  }
  figures.wrong = figures.missing + figures.falseSurface + figures.other;
  return figures;
}

}  // namespace ocelli
