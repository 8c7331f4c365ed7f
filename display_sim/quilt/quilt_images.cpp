#include "display_sim/quilt/quilt_images.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "display_sim/quilt/line_painter.h"
#include "display_sim/quilt/quilt_render.h"
#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"
#include "oc_core/ocri/eoc_construction.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/render/scene_renderer.h"

namespace ocelli {
namespace {

/// How the rows of a base image lie on those of the tiles, and where each view sees its points.
class RowPlacement {
 public:
  /// Nothing where they do not lie on them.
  static std::optional<RowPlacement> of(const QuiltViews& views, const QuiltLines& image) {
    // Rows that are off by more would show as an edge of half a pixel.
    constexpr float kMaxRowError = 0.02f;
    constexpr float kMaxAxisError = 1e-5f;
    const PinholeCamera& base = image.lines.base;
    const PinholeCamera& tile = views.camera(0);
    const float side = glm::dot(base.right(), tile.right()) > 0 ? 1.0f : -1.0f;
    const glm::vec3 between = base.eye() - views.middleEye();
    const float farAway = kMaxRowError / tile.focalPixels();
    if (glm::distance(base.forward(), tile.forward()) > kMaxAxisError ||
        glm::distance(base.right() * side, tile.right()) > kMaxAxisError ||
        std::abs(glm::dot(between, tile.forward())) > farAway || std::abs(glm::dot(between, tile.down())) > farAway ||
        std::abs(base.focalPixels() - tile.focalPixels()) * static_cast<float>(tile.height()) >
            kMaxRowError * tile.focalPixels()) {
      return std::nullopt;
    }
    // The row of the tile that base row 0 lies on, and the error.
    const float row = tile.centerPixels().y + side * (0.5f - base.centerPixels().y) - 0.5f;
    const float whole = std::round(row);
    if (std::abs(row - whole) > kMaxRowError) {
      return std::nullopt;
    }
    return RowPlacement(views, image, side, static_cast<int>(whole));
  }

  /// The row of the base image on a row of the tiles; nothing where the image has none.
  std::optional<size_t> baseRow(int tileRow) const {
    const int row = side_ > 0 ? tileRow - firstRow_ : firstRow_ - tileRow;
    return row >= 0 && row < rowCount_ ? std::optional(static_cast<size_t>(row)) : std::nullopt;
  }
  const LineMap& mapOf(int view) const { return maps_[static_cast<size_t>(view)]; }

 private:
  RowPlacement(const QuiltViews& views, const QuiltLines& image, float side, int firstRow)
      : side_(side), firstRow_(firstRow), rowCount_(static_cast<int>(image.lines.rows.size())) {
    const PinholeCamera& base = image.lines.base;
    // To the right of the middle eye a point lies at X = e + side (u - c) / f z in the world of the image, at s X in
    // that of the tiles, and a view at E sees it at c' + f (s X - E) / z.
    const double s = views.stretch() / image.stretch;
    const auto eyeOf = [&](const PinholeCamera& camera) {
      return static_cast<double>(glm::dot(camera.eye() - views.middleEye(), views.right()));
    };
    for (int view = 0; view < views.count(); ++view) {
      const PinholeCamera& tile = views.camera(view);
      const double perU = s * static_cast<double>(side * tile.focalPixels() / base.focalPixels());
      const double perW = static_cast<double>(tile.focalPixels()) * (s * eyeOf(base) - eyeOf(tile));
      const double offset =
          static_cast<double>(tile.centerPixels().x) - perU * static_cast<double>(base.centerPixels().x);
      maps_.push_back({static_cast<float>(perU), static_cast<float>(perW), static_cast<float>(offset)});
    }
  }

  float side_;
  int firstRow_;
  int rowCount_;
  std::vector<LineMap> maps_;
};

/// Of a camera whose lines are parallel: y is 1/z.
FarEndOf farEndsOf(const EpipolarCamera& camera) {
  return [&camera](int column, int row) -> std::optional<FarEnd> {
    const std::optional<EpipolarCamera::PlaneRay> ray = camera.planeRay(row, column + 0.5);
    if (!ray) {
      return std::nullopt;
    }
    return FarEnd{static_cast<float>(camera.lines().position(row, ray->xFar)), static_cast<float>(ray->yEnd)};
  };
}

/// Whether all of the scene is before a pinhole: then the window of its image was made to show all that the views see.
bool isBefore(const PinholeCamera& base, const Box& scene) {
  return std::ranges::all_of(
      cornersOf(scene), [&](const glm::vec3& corner) { return base.cameraFromWorld(corner).z >= base.view().zNear; });
}

size_t middleOf(const QuiltViews& views) {
  return static_cast<size_t>(views.count()) / 2;
}

}  // namespace

std::vector<QuiltLines> quiltLines(const QuiltViews& views, const Mesh& scene, const QuiltImageOptions& options,
                                   const SceneRenderer* renderer) {
  OC_CHECK(options.images == 1 || options.images == 2, "one image, or one to each side");
  const double stretch = views.stretch() * options.sampling;
  const int width = std::max(1, static_cast<int>(std::ceil(views.display().tileWidth() * options.sampling - 1e-6)));
  const PinholeCamera middle = views.middle(stretch, width);
  const glm::vec3 left = views.eyeIn(stretch, 0);
  const glm::vec3 right = views.eyeIn(stretch, views.count() - 1);
  const RayTarget* rays = renderer != nullptr ? renderer->rays() : nullptr;
  const Box box = rays != nullptr ? rays->bounds() : boundsOf(scene);
  std::vector<QuiltLines> images;
  const auto add = [&](const ViewSegment& segment, int firstView, int endView) {
    const EocConstruction built = constructEoc(middle, segment, scene, options.eoc, renderer);
    const EmptyRays empty{farEndsOf(built.camera), isBefore(built.camera.base(), box)};
    images.push_back(
        {sampleLines(built.image, empty), stretch, firstView, endView, built.image.sampleCount(), built.image.width()});
  };
  if (options.images == 1) {
    add({left, right}, 0, views.count());
  } else {
    const auto half = static_cast<int>(middleOf(views));
    add({middle.eye(), left}, 0, half);
    add({middle.eye(), right}, half, views.count());
  }
  return images;
}

std::optional<QuiltLines> quiltLinesOf(const QuiltViews& views, const ReferenceImage& image) {
  if (image.isPlaced() || image.rows == ImageRows::kShiftedRing || image.tileSide > 0 || image.layer > 0 ||
      !image.layout.regions.empty()) {
    return std::nullopt;
  }
  const bool isPinhole = image.rows == ImageRows::kAligned && image.pinholeSize.x == 0 &&
                         std::ranges::all_of(image.displacement, [](const glm::vec2& d) { return d == glm::vec2(0); });
  QuiltLines lines{sampleLines(image, EmptyRays{isPinhole ? straightRays() : FarEndOf()}),
                   1,
                   0,
                   views.count(),
                   image.sampleCount(),
                   image.width()};
  return RowPlacement::of(views, lines) ? std::optional(std::move(lines)) : std::nullopt;
}

QuiltPicture quiltFromLines(const QuiltViews& views, const std::vector<QuiltLines>& images, QuiltDepths depths) {
  static const SrgbEncoder encoder;
  const QuiltDisplay& display = views.display();
  QuiltPicture picture = blankQuilt(display, depths);
  std::vector<RowPlacement> placements;
  for (const QuiltLines& image : images) {
    std::optional<RowPlacement> placement = RowPlacement::of(views, image);
    OC_CHECK(placement.has_value(), "the rows of the image are rows of the tiles");
    placements.push_back(*std::move(placement));
  }
  std::vector<size_t> filled(static_cast<size_t>(display.tileHeight()), 0);
  parallelFor(filled.size(), 4, [&](size_t begin, size_t end) {
    LinePainter painter(display.tileWidth());
    const SampleLine nothing;
    for (size_t y = begin; y < end; ++y) {
      for (size_t k = 0; k < images.size(); ++k) {
        const SampleLines& lines = images[k].lines;
        const std::optional<size_t> row = placements[k].baseRow(static_cast<int>(y));
        const SampleLine& line = row ? lines.rows[*row] : nothing;
        for (int view = images[k].firstView; view < images[k].endView; ++view) {
          const glm::ivec2 origin = views.tileOrigin(view);
          const size_t at = picture.color.index(origin.x, origin.y + static_cast<int>(y));
          painter.draw(line, placements[k].mapOf(view));
          filled[y] += painter.write(line, lines, encoder, picture.color.data() + at,
                                     depths == QuiltDepths::kKept ? picture.inverseZ.data() + at : nullptr);
        }
      }
    }
  });
  for (const size_t count : filled) {
    picture.filled += count;
  }
  return picture;
}

QuiltPicture quiltFromMesh(const QuiltViews& views, const ReferenceImages& images, double stretch, QuiltDepths depths,
                           const Progress& progress) {
  Mesh mesh = unionMesh(images);
  views.stretchScene(mesh, views.stretch() / stretch);
  QuiltPicture picture = quiltByRender(views, mesh, QuiltDepths::kKept, progress);
  const auto seen = static_cast<size_t>(std::ranges::count_if(picture.inverseZ, [](float w) { return w > 0; }));
  picture.filled = views.display().tilePixels() - seen;
  if (depths == QuiltDepths::kNone) {
    picture.inverseZ = {};
  }
  return picture;
}

}  // namespace ocelli
