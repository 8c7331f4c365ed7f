#include "oc_core/volume_gl/listed_volume_rays.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "oc_core/base/parallel.h"
#include "oc_core/volume_render/ray_pieces.h"

namespace ocelli {
namespace {

/// As shaders/volume_ray.glsl has it: a parameter that no ray has.
constexpr float kListedNowhere = 3.0e38f;

ListedPiece listed(const VolumeRayPiece& piece) {
  const double length = piece.continues ? -piece.length : piece.length;
  return {glm::vec4(glm::dvec4(piece.from, length)), glm::vec4(glm::dvec4(piece.way, piece.t)),
          glm::vec4(glm::dvec4(piece.direction, piece.tByLength))};
}

}  // namespace

VolumeRayLister::VolumeRayLister(const VolumeScene& scene)
    : scene_(scene),
      surfaces_(scene.surfaces.triangles.empty() ? nullptr : std::make_unique<RayScene>(scene.surfaces)) {}

std::vector<ListedRow> VolumeRayLister::rows(int width, int first, int end, const RayOfPixel& rayPath) const {
  const VolumeExtent extent(scene_);
  std::vector<ListedRow> rows(static_cast<size_t>(end - first));
  parallelFor(rows.size(), 1, [&](size_t begin, size_t last) {
    VolumeExtent::Pieces pieces;
    for (size_t i = begin; i < last; ++i) {
      ListedRow& row = rows[i];
      const float y = static_cast<float>(first) + static_cast<float>(i) + 0.5f;
      for (int x = 0; x < width; ++x) {
        const RayPath ray = rayPath({static_cast<float>(x) + 0.5f, y});
        const std::optional<Hit> surface = surfaces_ && ray.size() > 1 ? surfaces_->hit(ray) : std::nullopt;
        const double rayEnd = surface ? static_cast<double>(surface->t) : std::numeric_limits<double>::infinity();
        const size_t count = extent.cut(ray, rayEnd, pieces);
        double length = 0;
        for (size_t k = 0; k < count; ++k) {
          row.pieces.push_back(listed(pieces[k]));
          length += pieces[k].length;
        }
        row.counts.push_back(static_cast<uint32_t>(count));
        row.longest = std::max(row.longest, length);
        if (surfaces_) {
          row.surfaces.push_back(surface ? glm::vec4(surface->color, surface->t) : glm::vec4(0, 0, 0, kListedNowhere));
        }
      }
    }
  });
  return rows;
}

GlListedRows uploadRows(GlContext& context, const ListedRow* first, size_t count) {
  std::vector<ListedPiece> pieces;
  std::vector<uint32_t> firstPieces;
  std::vector<glm::vec4> surfaces;
  uint32_t sum = 0;
  for (const ListedRow* row = first; row != first + count; ++row) {
    pieces.insert(pieces.end(), row->pieces.begin(), row->pieces.end());
    surfaces.insert(surfaces.end(), row->surfaces.begin(), row->surfaces.end());
    for (const uint32_t each : row->counts) {
      firstPieces.push_back(sum);
      sum += each;
    }
  }
  firstPieces.push_back(sum);
  return {makeBuffer(context, pieces), makeBuffer(context, firstPieces), makeBuffer(context, surfaces)};
}

}  // namespace ocelli
