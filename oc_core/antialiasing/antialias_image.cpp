#include "oc_core/antialiasing/antialias_image.h"

#include <array>
#include <atomic>
#include <cmath>

#include "oc_core/antialiasing/pixel_area.h"
#include "oc_core/antialiasing/pixel_masks.h"
#include "oc_core/base/check.h"
#include "oc_core/base/parallel.h"

namespace ocelli {
namespace {

constexpr int kBlock = AntialiasBins::kBlock;
constexpr size_t kAhead = 8;  ///< triangles that memory is asked for in advance

void prefetch(const void* address) {
  __builtin_prefetch(address);
}

/// Draws blocks; keeps its memory from one to the next.
class BlockDrawing {
 public:
  BlockDrawing(const AntialiasScene& scene, const AntialiasPlan& plan, const glm::vec3& background,
               Image<glm::vec3>& image)
      : view_(scene.view()),
        bins_(scene.bins()),
        projected_(scene.projected()),
        mesh_(scene.projected().mesh()),
        plan_(plan),
        background_(background),
        image_(image) {}

  void draw(size_t block) {
    const int x0 = static_cast<int>(block) % bins_.across() * kBlock;
    const int y0 = static_cast<int>(block) / bins_.across() * kBlock;
    const PixelBounds bounds{x0, y0, std::min(x0 + kBlock, view_.width()), std::min(y0 + kBlock, view_.height())};
    const glm::dvec2 middle = view_.referencePoint(glm::dvec2(x0 + kBlock / 2, y0 + kBlock / 2));
    base_ = glm::ivec2(glm::floor(middle));
    collect(block, bounds);
    for (int y = bounds.y0; y < bounds.y1; ++y) {
      for (int x = bounds.x0; x < bounds.x1; ++x) {
        image_(x, y) = pixel(x, y, ofPixel_[static_cast<size_t>((y - y0) * kBlock + x - x0)]);
      }
    }
  }
  const AntialiasWork& work() const { return work_; }

 private:
  /// The triangles of the block, and which of them each of its pixels may show.
  void collect(size_t block, const PixelBounds& bounds) {
    triangles_.clear();
    for (std::vector<uint32_t>& each : ofPixel_) {
      each.clear();
    }
    const std::span<const uint32_t> of = bins_.trianglesOf(block);
    for (size_t i = 0; i < of.size(); ++i) {
      // They lie far apart in memory: without this, waiting for them takes most of the time.
      if (i + 2 * kAhead < of.size()) {
        prefetch(&mesh_.triangles[of[i + 2 * kAhead]]);
      }
      if (i + kAhead < of.size()) {
        const uint32_t vertex = mesh_.triangles[of[i + kAhead]].x;
        prefetch(&projected_.vertex(vertex));
        if (!mesh_.colors.empty()) {
          prefetch(&mesh_.colors[vertex]);
        }
      }
      bins_.parts().forEachPartAnywhere(of[i], [&](const RasterVertex& a, const RasterVertex& b,
                                                   const RasterVertex& c) { add(of[i], a, b, c, bounds); });
    }
  }

  void add(uint32_t index, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
           const PixelBounds& bounds) {
    const auto place = static_cast<uint32_t>(triangles_.size());
    AntialiasTriangle& t = triangles_.emplace_back();
    PixelBounds within;
    if (prepareTriangle(t, mesh_, index, a, b, c, base_)) {
      const glm::vec2 base(base_);
      const PixelBounds all =
          pixelsOf(view_.imageBox({t.box.lower + base, t.box.upper + base}), view_.width(), view_.height());
      within = {std::max(all.x0, bounds.x0), std::max(all.y0, bounds.y0), std::min(all.x1, bounds.x1),
                std::min(all.y1, bounds.y1)};
    }
    if (within.x0 >= within.x1 || within.y0 >= within.y1) {
      triangles_.pop_back();
      return;
    }
    for (int y = within.y0; y < within.y1; ++y) {
      for (int x = within.x0; x < within.x1; ++x) {
        ofPixel_[static_cast<size_t>((y - bounds.y0) * kBlock + x - bounds.x0)].push_back(place);
      }
    }
  }

  glm::vec3 pixel(int x, int y, const std::vector<uint32_t>& candidates) {
    if (candidates.empty()) {
      ++work_.plain;
      return background_;
    }
    const PixelRule& rule = plan_.rules[plan_.ruleOfPixel.empty() ? 0 : plan_.ruleOfPixel(x, y)];
    const PixelPlace place{x, y, base_, view_.areaOf(x, y)};
    ImageBox square;
    if (place.area.isSquare) {
      square = place.square();
    } else {
      samples_.place(view_, place, *rule.pattern);
      square = samples_.bounds();
    }
    const bool isFilled = select(candidates, square);
    if (seen_.empty()) {
      ++work_.plain;
      return background_;
    }
    if (isFilled && seen_.size() == 1) {
      ++work_.plain;
      const glm::vec2 middle = (square.lower + square.upper) * 0.5f;
      return seen_[0].triangle->colorAt(middle.x, middle.y, mesh_);
    }
    if (place.area.isSquare && seen_.size() <= rule.maxExactTriangles) {
      ++work_.exact;
      return areas_.mean(pointers(), square, mesh_, background_);
    }
    ++work_.sampled;
    work_.samples += static_cast<size_t>(rule.pattern->size());
    if (place.area.isSquare && !rule.shadesAtMiddle && PixelMasks::take(*rule.pattern)) {
      return masks_.mean(seen_, square, *rule.pattern, mesh_, background_);
    }
    if (place.area.isSquare) {
      samples_.place(view_, place, *rule.pattern);
    }
    return samples_.mean(pointers(), rule, mesh_, background_);
  }

  std::span<const AntialiasTriangle* const> pointers() {
    pointers_.clear();
    for (const PixelTriangle& each : seen_) {
      pointers_.push_back(each.triangle);
    }
    return pointers_;
  }

  /// Leaves those in seen_ that meet a square and are not behind one that fills it. Returns whether one fills it.
  bool select(const std::vector<uint32_t>& candidates, const ImageBox& square) {
    seen_.clear();
    float filledTo = 0;
    for (const uint32_t each : candidates) {
      const AntialiasTriangle& t = triangles_[each];
      PixelTriangle seen{&t, t.nearestInverseZ, t.farthestInverseZ};
      const glm::vec2 size = t.box.upper - t.box.lower;
      const float side = square.upper.x - square.lower.x;
      // Small ones are known to meet it, nearly, and cannot fill it.
      if (size.x > side || size.y > side) {
        bool meets = true;
        bool fills = true;
        for (size_t i = 0; i < 3; ++i) {
          meets = meets && t.edges[i].greatest(square) >= t.inside[i];
          fills = fills && t.edges[i].least(square) >= t.inside[i];
        }
        if (!meets) {
          continue;
        }
        seen.farthest = std::max(seen.farthest, t.inverseZ.least(square));
        // Rounding must not put a triangle behind itself.
        seen.nearest = std::max(std::min(seen.nearest, t.inverseZ.greatest(square)), seen.farthest);
        if (fills) {
          filledTo = std::max(filledTo, seen.farthest);
        }
      }
      if (seen.nearest >= filledTo) {
        seen_.push_back(seen);
      }
    }
    if (filledTo > 0) {
      std::erase_if(seen_, [&](const PixelTriangle& each) { return each.nearest < filledTo; });
    }
    return filledTo > 0;
  }

  const AntialiasView& view_;
  const AntialiasBins& bins_;
  const ProjectedMesh& projected_;
  const Mesh& mesh_;
  const AntialiasPlan& plan_;
  glm::vec3 background_;
  Image<glm::vec3>& image_;
  glm::ivec2 base_{0};
  std::vector<AntialiasTriangle> triangles_;
  std::array<std::vector<uint32_t>, static_cast<size_t>(kBlock) * kBlock> ofPixel_;
  std::vector<PixelTriangle> seen_;
  std::vector<const AntialiasTriangle*> pointers_;
  PixelSamples samples_;
  PixelMasks masks_;
  PixelArea areas_;
  AntialiasWork work_;
};

}  // namespace

AntialiasScene::AntialiasScene(const AntialiasView& view, const Mesh& mesh)
    : view_(view), projected_(view.reference(), mesh), bins_(view_, projected_) {}

Image<glm::vec3> AntialiasScene::draw(const AntialiasPlan& plan, const glm::vec3& background,
                                      AntialiasWork* work) const {
  OC_CHECK(!plan.rules.empty(), "a plan has a rule");
  Image<glm::vec3> image(view_.width(), view_.height());
  std::atomic<size_t> plain{0};
  std::atomic<size_t> exact{0};
  std::atomic<size_t> sampled{0};
  std::atomic<size_t> samples{0};
  parallelFor(bins_.blocks(), 16, [&](size_t begin, size_t end) {
    BlockDrawing drawing(*this, plan, background, image);
    for (size_t block = begin; block < end; ++block) {
      drawing.draw(block);
    }
    plain += drawing.work().plain;
    exact += drawing.work().exact;
    sampled += drawing.work().sampled;
    samples += drawing.work().samples;
  });
  if (work != nullptr) {
    *work = {plain, exact, sampled, samples};
  }
  return image;
}

}  // namespace ocelli
