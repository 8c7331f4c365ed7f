#include "oc_core/multiperspective/camera_plan.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/multiperspective/plan_ground.h"
#include "oc_core/multiperspective/plan_shapes.h"
#include "oc_core/multiperspective/ray_pieces.h"
#include "oc_core/render/raycast.h"

namespace ocelli {
namespace {

constexpr int kRowsTried = 24;        // of a column
constexpr int kOutlineSamples = 160;  // along each side of the image
constexpr float kMargin = 0.04f;      // around what is shown

/// Ends a ray at a point on it.
void endAt(std::vector<RayPiece>& pieces, const glm::vec3& hit) {
  size_t bestPiece = 0;
  size_t bestPoint = 0;
  float best = 1e30f;
  for (size_t i = 0; i < pieces.size(); ++i) {
    for (size_t k = 0; k + 1 < pieces[i].points.size(); ++k) {
      const glm::vec3 from = pieces[i].points[k];
      const glm::vec3 run = pieces[i].points[k + 1] - from;
      const float share = glm::clamp(glm::dot(hit - from, run) / std::max(glm::dot(run, run), 1e-30f), 0.0f, 1.0f);
      const float off = glm::distance(hit, from + run * share);
      if (off < best) {
        best = off;
        bestPiece = i;
        bestPoint = k;
      }
    }
  }
  pieces.resize(bestPiece + 1);
  pieces.back().points.resize(bestPoint + 1);
  pieces.back().points.push_back(hit);
}

float lengthOf(const std::vector<RayPiece>& pieces) {
  float length = 0;
  for (const RayPiece& piece : pieces) {
    for (size_t k = 0; k + 1 < piece.points.size(); ++k) {
      length += glm::distance(piece.points[k], piece.points[k + 1]);
    }
  }
  return length;
}

template <class Camera>
class Planner {
 public:
  Planner(const Camera& camera, const Mesh& mesh, const PlanOptions& options)
      : camera_(camera), mesh_(mesh), scene_(mesh), options_(options), box_(scene_.bounds()) {
    // Flat seen from this side, so that no ray passes over what it shows.
    glm::vec3 margin = box_.size() * kMargin + 1e-6f;
    margin[axisOf(options.side)] = 1e-6f;
    box_ = {box_.lower - margin, box_.upper + margin};
  }

  CameraPlan make() {
    plan_.side = options_.side;
    addParts();
    addRays();
    frame();
    const float at = options_.cut.value_or(partViewpoints(camera_).front()[axisOf(options_.side)]);
    plan_.section = sectionOf(mesh_, options_.side, at);
    if (options_.groundPixels > 0) {
      plan_.ground = planGround(mesh_, options_.side, plan_.lower, plan_.upper, at, options_.groundPixels);
    }
    return std::move(plan_);
  }

 private:
  glm::vec2 paper(const glm::vec3& p) const { return onPaper(options_.side, p); }

  void addParts() {
    const std::vector<std::string> names = partNames(camera_);
    const std::vector<glm::vec3> viewpoints = partViewpoints(camera_);
    for (size_t i = 0; i < names.size(); ++i) {
      plan_.parts.push_back({names[i], paper(viewpoints[i]), {}});
    }
    std::vector<glm::vec2> pixels = cornerPixels(camera_);
    const glm::vec2 step = glm::vec2(camera_.width(), camera_.height()) / static_cast<float>(kOutlineSamples);
    for (int y = 0; y <= kOutlineSamples; ++y) {
      for (int x = 0; x <= kOutlineSamples; ++x) {
        pixels.push_back(glm::vec2(x, y) * step);
      }
    }
    // The points that rays pass in each part, apart for each part that they go on to.
    std::map<std::pair<int, int>, std::vector<glm::vec2>> passed;
    for (const glm::vec2& pixel : pixels) {
      const std::vector<RayPiece> pieces = rayPieces(camera_, pixel);
      for (size_t i = 0; i < pieces.size(); ++i) {
        const int next = i + 1 < pieces.size() ? pieces[i + 1].part : -1;
        for (const glm::vec3& point : clipped(pieces[i], box_).points) {
          passed[{pieces[i].part, next}].push_back(paper(point));
        }
      }
    }
    for (const auto& [place, points] : passed) {
      const std::vector<glm::vec2> hull = convexHull(points);
      if (hull.size() >= 3) {
        plan_.parts[static_cast<size_t>(place.first)].outlines.push_back(hull);
      }
    }
  }

  /// A ray within the scene, to what it meets.
  std::pair<std::vector<RayPiece>, bool> seen(const glm::vec2& pixel) const {
    std::vector<RayPiece> pieces = rayPieces(camera_, pixel);
    const Fragment hit = scene_.intersect(camera_.rayPath(pixel));
    if (hit.covered()) {
      endAt(pieces, positionOf(hit, mesh_));
    }
    for (RayPiece& piece : pieces) {
      piece = clipped(piece, box_);
    }
    std::erase_if(pieces, [](const RayPiece& piece) { return piece.points.size() < 2; });
    return {pieces, hit.covered()};
  }

  void addRays() {
    for (int i = 0; i < options_.rays; ++i) {
      const float u =
          (static_cast<float>(i) + 0.5f) / static_cast<float>(options_.rays) * static_cast<float>(camera_.width());
      std::pair<std::vector<RayPiece>, bool> farthest;
      for (int row = 0; row < kRowsTried; ++row) {
        const float v = (static_cast<float>(row) + 0.5f) / kRowsTried * static_cast<float>(camera_.height());
        auto ray = seen({u, v});
        if (std::pair(ray.second, lengthOf(ray.first)) > std::pair(farthest.second, lengthOf(farthest.first))) {
          farthest = std::move(ray);
        }
      }
      CameraPlan::Ray ray{{}, farthest.second};
      for (const RayPiece& piece : farthest.first) {
        ray.pieces.push_back({piece.part, {}});
        for (const glm::vec3& point : piece.points) {
          ray.pieces.back().points.push_back(paper(point));
        }
      }
      plan_.rays.push_back(std::move(ray));
    }
  }

  void frame() {
    glm::vec2 lower(1e30f);
    glm::vec2 upper(-1e30f);
    const auto add = [&](const glm::vec2& point) {
      lower = glm::min(lower, point);
      upper = glm::max(upper, point);
    };
    for (const CameraPlan::Ray& ray : plan_.rays) {
      for (const CameraPlan::Ray::Piece& piece : ray.pieces) {
        std::for_each(piece.points.begin(), piece.points.end(), add);
      }
    }
    if (lower.x > upper.x) {  // no ray comes near the scene
      add(paper(box_.lower));
      add(paper(box_.upper));
    }
    const glm::vec2 margin(kMargin * std::max(upper.x - lower.x, upper.y - lower.y) + 1e-6f);
    plan_.lower = lower - margin;
    plan_.upper = upper + margin;
  }

  const Camera& camera_;
  const Mesh& mesh_;
  RayScene scene_;
  PlanOptions options_;
  Box box_;
  CameraPlan plan_;
};

template <class Camera>
CameraPlan planOfOne(const Camera& camera, const Mesh& mesh, const PlanOptions& options) {
  if (mesh.triangles.empty()) {
    throw InputError("the scene has no triangle", "plan", "choose another scene");
  }
  return Planner(camera, mesh, options).make();
}

}  // namespace

CameraPlan planOf(const MultiperspectiveCamera& camera, const Mesh& mesh, const PlanOptions& options) {
  return std::visit([&](const auto& each) { return planOfOne(each, mesh, options); }, camera);
}

CameraPlan planOf(const RayMapCamera& camera, const Mesh& mesh, const PlanOptions& options) {
  return planOfOne(camera, mesh, options);
}

}  // namespace ocelli
