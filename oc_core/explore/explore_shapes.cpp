#include "oc_core/explore/explore_shapes.h"

#include <algorithm>
#include <map>
#include <utility>

#include "oc_core/multiperspective/plan_shapes.h"
#include "oc_core/multiperspective/ray_pieces.h"

namespace ocelli {
namespace {

/// Of the size of the scene: viewpoints that are nearer to each other are one.
constexpr double kSameViewpoint = 1e-6;
constexpr float kAround = 0.02f;  // around the scene, in shares of its size
constexpr int kSidePieces = 4;    // rays along each side of the image for an outline in the plan

/// Pixels of the picture from those of the camera's image.
struct Placed {
  FittedImage fit;

  glm::dvec2 at(const glm::dvec2& pixel) const { return glm::dvec2(fit.left, fit.top) + pixel * fit.scale; }
};

bool turns(const GraphCamera& camera, const GraphCamera::Frustum& frustum) {
  return frustum.parent >= 0 &&
         glm::distance(frustum.viewpoint, camera.frusta()[static_cast<size_t>(frustum.parent)].viewpoint) >
             kSameViewpoint * static_cast<double>(camera.root().view().zFar);
}

void addOutlines(const GraphCamera& camera, const Placed& placed, int firstPart,
                 std::vector<ExploreOutline>& outlines) {
  for (size_t i = 0; i < camera.frusta().size(); ++i) {
    const GraphCamera::Frustum& frustum = camera.frusta()[i];
    if (!turns(camera, frustum)) {
      continue;
    }
    ExploreOutline outline{{}, firstPart + static_cast<int>(i), frustum.name};
    for (const glm::dvec2& corner : frustum.part) {
      outline.corners.push_back(placed.at(corner));
    }
    outlines.push_back(std::move(outline));
  }
}

/// Its bends are one behind the other, so all of the image is in each.
void addOutlines(const CurvedRayCamera& camera, const Placed& placed, int firstPart,
                 std::vector<ExploreOutline>& outlines) {
  if (camera.bends().empty()) {
    return;
  }
  const double width = camera.width();
  const double height = camera.height();
  outlines.push_back({{placed.at({0, 0}), placed.at({width, 0}), placed.at({width, height}), placed.at({0, height})},
                      firstPart + 1,
                      "curved rays"});
}

bool bendsBefore(const GraphCamera& camera, int part) {
  for (int i = part; i > 0; i = camera.frusta()[static_cast<size_t>(i)].parent) {
    if (turns(camera, camera.frusta()[static_cast<size_t>(i)])) {
      return true;
    }
  }
  return false;
}

bool bendsBefore(const CurvedRayCamera& /*camera*/, int part) {
  return part > 0;
}

template <class Camera>
void addFootprints(const Camera& camera, const Box& bounds, int firstPart, bool behind,
                   std::vector<ExploreFootprint>& footprints) {
  const std::vector<std::string> names = partNames(camera);
  const std::vector<glm::vec3> viewpoints = partViewpoints(camera);
  std::vector<glm::vec2> pixels = cornerPixels(camera);
  for (int i = 1; i < kSidePieces; ++i) {
    const float share = static_cast<float>(i) / kSidePieces;
    const auto width = static_cast<float>(camera.width());
    const auto height = static_cast<float>(camera.height());
    pixels.insert(pixels.end(), {{width * share, height * 0.01f}, {width * share, height * 0.99f}});
  }
  std::map<std::pair<int, int>, std::vector<glm::vec2>> passed;
  for (const glm::vec2& pixel : pixels) {
    const std::vector<RayPiece> pieces = rayPieces(camera, pixel);
    for (size_t i = 0; i < pieces.size(); ++i) {
      const int next = i + 1 < pieces.size() ? pieces[i + 1].part : -1;
      for (const glm::vec3& point : clipped(pieces[i], bounds).points) {
        passed[{pieces[i].part, next}].push_back({point.x, point.z});
      }
    }
  }
  for (auto& [place, points] : passed) {
    std::vector<glm::vec2> hull = convexHull(std::move(points));
    if (hull.size() >= 3) {
      const auto part = static_cast<size_t>(place.first);
      footprints.push_back({std::move(hull),
                            {viewpoints[part].x, viewpoints[part].z},
                            firstPart + place.first,
                            names[part],
                            bendsBefore(camera, place.first),
                            behind});
    }
  }
}

int partCount(const MultiperspectiveCamera& camera) {
  return static_cast<int>(std::visit([](const auto& each) { return partNames(each).size(); }, camera));
}

}  // namespace

int widthOf(const MultiperspectiveCamera& camera) {
  return std::visit([](const auto& each) { return each.width(); }, camera);
}

int heightOf(const MultiperspectiveCamera& camera) {
  return std::visit([](const auto& each) { return each.height(); }, camera);
}

FittedImage fitted(int width, int height, int pictureWidth, int pictureHeight) {
  const double scale = std::min(pictureWidth / static_cast<double>(width), pictureHeight / static_cast<double>(height));
  return {(pictureWidth - width * scale) / 2, (pictureHeight - height * scale) / 2, scale};
}

FittedImage fittedAhead(const ExploreFrame& frame) {
  const int behind = frame.behind ? widthOf(*frame.behind) : 0;
  FittedImage fit =
      fitted(widthOf(frame.camera), heightOf(frame.camera), frame.pinhole.width() - behind, frame.pinhole.height());
  fit.left += behind;
  return fit;
}

std::vector<ExploreOutline> outlinesOf(const ExploreFrame& frame) {
  std::vector<ExploreOutline> outlines;
  const Placed ahead{fittedAhead(frame)};
  std::visit([&](const auto& camera) { addOutlines(camera, ahead, 0, outlines); }, frame.camera);
  if (frame.behind) {
    const Placed behind{};
    std::visit([&](const auto& camera) { addOutlines(camera, behind, partCount(frame.camera), outlines); },
               *frame.behind);
  }
  return outlines;
}

std::vector<ExploreFootprint> footprintsOf(const ExploreFrame& frame, const Box& bounds) {
  const glm::vec3 margin = bounds.size() * kAround + glm::vec3(1e-6f);
  // As tall as rays may rise, so that they are cut at its sides alone.
  const float tall = glm::length(bounds.size());
  const Box box{bounds.lower - margin - glm::vec3(0, tall, 0), bounds.upper + margin + glm::vec3(0, tall, 0)};
  std::vector<ExploreFootprint> footprints;
  std::visit([&](const auto& camera) { addFootprints(camera, box, 0, false, footprints); }, frame.camera);
  if (frame.behind) {
    std::visit([&](const auto& camera) { addFootprints(camera, box, partCount(frame.camera), true, footprints); },
               *frame.behind);
  }
  return footprints;
}

PictureSpot spotOf(const ExploreFrame& frame, const glm::dvec2& pixel) {
  const auto within = [](const MultiperspectiveCamera& camera, const glm::dvec2& p) {
    return p.x >= 0 && p.y >= 0 && p.x < widthOf(camera) && p.y < heightOf(camera);
  };
  const FittedImage fit = fittedAhead(frame);
  const glm::dvec2 ahead = (pixel - glm::dvec2(fit.left, fit.top)) / fit.scale;
  if (within(frame.camera, ahead)) {
    return {&frame.camera, glm::vec2(ahead)};
  }
  if (frame.behind && within(*frame.behind, pixel)) {
    return {&*frame.behind, glm::vec2(pixel)};
  }
  return {};
}

}  // namespace ocelli
