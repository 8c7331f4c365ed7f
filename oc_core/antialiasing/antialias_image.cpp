#include "oc_core/antialiasing/antialias_image.h"

#include <array>
#include <atomic>
#include <cmath>

#include "oc_core/antialiasing/block_triangles.h"
#include "oc_core/antialiasing/pixel_area.h"
#include "oc_core/antialiasing/pixel_masks.h"
#include "oc_core/antialiasing/pixel_samples.h"
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
    triangles_.start(base_);
    for (std::vector<PixelTriangle>& each : ofPixel_) {
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
      }
      bins_.parts().forEachPartAnywhere(of[i], [&](const RasterVertex& a, const RasterVertex& b,
                                                   const RasterVertex& c) { add(of[i], a, b, c, bounds); });
    }
  }

  void add(uint32_t index, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
           const PixelBounds& bounds) {
    // Preparing it may move a vertex by half a step of its grid.
    constexpr float kSnap = 1.0f / 4096;
    const glm::vec2 lower(std::min({a.u, b.u, c.u}), std::min({a.v, b.v, c.v}));
    const glm::vec2 upper(std::max({a.u, b.u, c.u}), std::max({a.v, b.v, c.v}));
    const PixelBounds all = pixelsOf(view_.imageBox({lower - kSnap, upper + kSnap}), view_.width(), view_.height());
    const PixelBounds within{std::max(all.x0, bounds.x0), std::max(all.y0, bounds.y0), std::min(all.x1, bounds.x1),
                             std::min(all.y1, bounds.y1)};
    if (within.x0 >= within.x1 || within.y0 >= within.y1) {
      return;
    }
    const PixelTriangle entry{triangles_.add(index, a, b, c), std::max({a.inverseZ, b.inverseZ, c.inverseZ}),
                              std::min({a.inverseZ, b.inverseZ, c.inverseZ}),
                              std::max(upper.x - lower.x, upper.y - lower.y) + 2 * kSnap};
    for (int y = within.y0; y < within.y1; ++y) {
      for (int x = within.x0; x < within.x1; ++x) {
        ofPixel_[static_cast<size_t>((y - bounds.y0) * kBlock + x - bounds.x0)].push_back(entry);
      }
    }
  }

  glm::vec3 pixel(int x, int y, const std::vector<PixelTriangle>& candidates) {
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
      return triangles_.prepared(seen_[0].number)->colorAt(middle.x, middle.y, mesh_);
    }
    if (place.area.isSquare && seen_.size() <= rule.maxExactTriangles) {
      ++work_.exact;
      return areas_.mean(pointers(), square, mesh_, background_);
    }
    ++work_.sampled;
    work_.samples += static_cast<size_t>(rule.pattern->size());
    if (place.area.isSquare && !rule.shadesAtMiddle && PixelMasks::take(*rule.pattern)) {
      return masks_.mean(seen_, triangles_, square, *rule.pattern, mesh_, background_);
    }
    if (place.area.isSquare) {
      samples_.place(view_, place, *rule.pattern);
    }
    return samples_.mean(pointers(), rule, mesh_, background_);
  }

  std::span<const AntialiasTriangle* const> pointers() {
    pointers_.clear();
    for (const PixelTriangle& each : seen_) {
      if (const AntialiasTriangle* t = triangles_.prepared(each.number)) {
        pointers_.push_back(t);
      }
    }
    return pointers_;
  }

  /// Leaves those in seen_ that meet a square and are not behind one that fills it. Returns whether one fills it.
  bool select(const std::vector<PixelTriangle>& candidates, const ImageBox& square) {
    seen_.clear();
    float filledTo = 0;
    const float side = std::min(square.upper.x - square.lower.x, square.upper.y - square.lower.y);
    for (const PixelTriangle& each : candidates) {
      PixelTriangle seen = each;
      // Small ones are known to meet it, nearly, and cannot fill it.
      if (each.extent > side) {
        const AntialiasTriangle* t = triangles_.prepared(each.number);
        bool meets = t != nullptr;
        bool fills = meets;
        for (size_t i = 0; i < 3 && meets; ++i) {
          meets = t->edges[i].greatest(square) >= t->inside[i];
          fills = fills && t->edges[i].least(square) >= t->inside[i];
        }
        if (!meets) {
          continue;
        }
        seen.farthest = std::max(seen.farthest, t->inverseZ.least(square));
        // Rounding must not put a triangle behind itself.
        seen.nearest = std::max(std::min(seen.nearest, t->inverseZ.greatest(square)), seen.farthest);
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
  BlockTriangles triangles_;
  std::array<std::vector<PixelTriangle>, static_cast<size_t>(kBlock) * kBlock> ofPixel_;
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
