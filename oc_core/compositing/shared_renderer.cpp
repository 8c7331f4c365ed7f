#include "oc_core/compositing/shared_renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/render/rasterize_gpc.h"
#include "oc_core/render/rasterize_graph.h"
#include "oc_core/render/rasterize_spans.h"

namespace ocelli {
namespace {

class Seconds {
 public:
  /// Since the last time, or since it was made.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Numbers that are the same where the same went in.
class Fingerprint {
 public:
  void add(float value) { hash_ = (hash_ ^ std::bit_cast<uint32_t>(value)) * 0x100000001b3u; }  // FNV-1a, by words
  uint64_t value() const { return hash_; }

 private:
  uint64_t hash_ = 0xcbf29ce484222325u;
};

/// What a camera does with some points of its image: what ranks have decided so far.
template <DistortedPinhole C>
uint64_t fingerprintOf(const C& camera) {
  constexpr int kSteps = 48;
  Fingerprint print;
  for (int y = 0; y < kSteps; ++y) {
    for (int x = 0; x < kSteps; ++x) {
      const auto u = static_cast<float>(camera.width()) * (static_cast<float>(x) + 0.5f) / kSteps;
      const auto v = static_cast<float>(camera.height()) * (static_cast<float>(y) + 0.5f) / kSteps;
      const View& view = camera.reference().view();
      const ImagePoint q = camera.distort({u, v, view.zNear + (view.zFar - view.zNear) / 4});
      print.add(q.u);
      print.add(q.v);
    }
  }
  return print.value();
}

/// A sample of a ray of several pieces (ordered_buffer.h).
struct OrderedPixel {
  uint32_t order = OrderedBuffer::kNone;
  Fragment sample;
};

struct NearestOrdered {
  static bool holds(const OrderedPixel& p) { return p.order != OrderedBuffer::kNone; }
  static bool isNearer(const OrderedPixel& a, const OrderedPixel& b) {
    return a.order < b.order || (a.order == b.order && NearestFragment::isNearer(a.sample, b.sample));
  }
};

/// Vertices [first, last].
struct VertexRange {
  uint32_t first = std::numeric_limits<uint32_t>::max();
  uint32_t last = 0;

  size_t size() const { return first <= last ? size_t{last} - first + 1 : 0; }
};

VertexRange verticesOf(std::span<const glm::uvec3> triangles) {
  constexpr size_t kChunks = 32;
  std::array<VertexRange, kChunks> ranges;
  parallelChunks(triangles.size(), kChunks, [&](size_t chunk, size_t begin, size_t end) {
    VertexRange range;
    for (const glm::uvec3& t : triangles.subspan(begin, end - begin)) {
      range.first = std::min({range.first, t.x, t.y, t.z});
      range.last = std::max({range.last, t.x, t.y, t.z});
    }
    ranges[chunk] = range;
  });
  VertexRange all;
  for (const VertexRange& range : ranges) {
    all = {std::min(all.first, range.first), std::max(all.last, range.last)};
  }
  return all;
}

Mesh withRange(const Mesh& mesh, std::span<const glm::uvec3> triangles, const VertexRange& range) {
  Mesh part;
  part.triangles.resize(triangles.size());
  parallelFor(triangles.size(), 1 << 14, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      part.triangles[i] = triangles[i] - range.first;
    }
  });
  const auto first = mesh.positions.begin() + range.first;
  part.positions.assign(first, first + static_cast<std::ptrdiff_t>(range.size()));
  return part;
}

Mesh withNewNumbers(const Mesh& mesh, std::span<const glm::uvec3> triangles) {
  constexpr uint32_t kNew = std::numeric_limits<uint32_t>::max();
  Mesh part;
  part.triangles.reserve(triangles.size());
  std::vector<uint32_t> numbers(mesh.positions.size(), kNew);
  const auto numberOf = [&](uint32_t vertex) {
    if (numbers[vertex] == kNew) {
      numbers[vertex] = static_cast<uint32_t>(part.positions.size());
      part.positions.push_back(mesh.positions[vertex]);
    }
    return numbers[vertex];
  };
  for (const glm::uvec3& t : triangles) {
    const uint32_t a = numberOf(t.x);
    const uint32_t b = numberOf(t.y);
    part.triangles.emplace_back(a, b, numberOf(t.z));
  }
  return part;
}

}  // namespace

Mesh trianglesOf(const Mesh& mesh, size_t begin, size_t end) {
  const std::span<const glm::uvec3> triangles(mesh.triangles.data() + begin, end - begin);
  const VertexRange range = verticesOf(triangles);
  // Of a scene in a coherent order a share has its own range of vertices.
  return range.size() <= triangles.size() ? withRange(mesh, triangles, range) : withNewNumbers(mesh, triangles);
}

void requireAgreement(Ranks& ranks, uint64_t number) {
  const uint64_t largest = ranks.largest(number);
  const uint64_t least = ~ranks.largest(~number);
  if (largest != least) {
    throw WorkError("the ranks have not computed the same", "MPI",
                    "run the same ocelli with the same files on machines with CPUs of one kind");
  }
}

/// A share as it is drawn along epipolar lines: kept for the cameras of one construction.
struct SharedLines {
  SharedLines(const PinholeCamera& basePinhole, const EpipolarLines& epipolarLines, const Mesh& part)
      : base(basePinhole), lines(epipolarLines), drawing(base, lines, part) {}

  PinholeCamera base;
  EpipolarLines lines;
  LineDrawing drawing;
};

struct SharedRenderer::Impl {
  Impl(const Mesh& whole, Ranks& all, Compositing compositing) : mesh(whole), ranks(all), how(compositing) {
    const RankShare share = shareOfRank(mesh.triangles.size(), ranks.rank(), ranks.size());
    first = static_cast<uint32_t>(share.begin);
    part = trianglesOf(mesh, share.begin, share.end);
  }

  /// `draw()` draws this rank's share, with the triangles of the share numbered from 0.
  template <class Draw>
  FragmentImage together(const Draw& draw, uint64_t camera = 0) {
    Seconds watch;
    FragmentImage image = draw();
    for (Fragment& fragment : image) {
      fragment.triangle += fragment.covered() ? first : 0;
    }
    startMerging(watch, image.size() ^ camera);
    compositeNearest(image, ranks, how);
    cost.mergeSeconds += watch.lap();
    return image;
  }

  /// The share as a pinhole sees it: kept for the next image, which is often of the same pinhole.
  const std::shared_ptr<const ProjectedMesh>& projectedBy(const PinholeCamera& camera) {
    if (!projected || projected->camera() != camera) {
      projected = std::make_shared<const ProjectedMesh>(camera, part);
    }
    return projected;
  }

  /// Whether these are the lines that the share was drawn along before.
  bool isAlong(const PinholeCamera& base, const EpipolarLines& along) const {
    return lines && lines->base == base && lines->lines == along;
  }
  LineDrawing& drawingAlong(const PinholeCamera& base, const EpipolarLines& along) {
    if (!isAlong(base, along)) {
      lines = std::make_unique<SharedLines>(base, along, part);
    }
    return lines->drawing;
  }

  /// `drawSpans(nothing)` draws what the share shows in disocclusions; nothing is what the base sees of it.
  template <class DrawSpans>
  FragmentImage disoccluded(const EpipolarCamera& camera, const FragmentImage& baseImage, const DrawSpans& drawSpans) {
    const FragmentImage nothing(baseImage.width(), baseImage.height());
    const FragmentImage spans = together([&] { return drawSpans(nothing); });
    FragmentImage image = baseFragments(camera, baseImage);
    for (size_t i = 0; i < image.size(); ++i) {
      if (NearestFragment::isNearer(spans[i], image[i])) {
        image[i] = spans[i];
      }
    }
    return image;
  }

  template <class C>
  FragmentImage displaced(const C& camera, const FragmentImage& seen, const SubdivisionOptions& options) {
    FragmentImage image = together(
        [&] {
          // What is displaced nowhere comes from what all ranks have seen.
          const FragmentImage nothing(camera.width(), camera.height());
          return rasterize(camera, nothing, displacedPart(camera, projectedBy(camera.reference())), options);
        },
        fingerprintOf(camera));
    keepUndisplaced(camera, seen, image);
    return image;
  }

  /// Cameras whose rays have several pieces: what a ray meets first is known by the piece, not by z.
  template <class C>
  FragmentImage alongPieces(const C& camera) {
    Seconds watch;
    if (!blocks) {
      blocks.emplace(part);
    }
    OrderedBuffer buffer = drawOrdered(camera, part, *blocks);
    std::vector<OrderedPixel> pixels(static_cast<size_t>(camera.width()) * static_cast<size_t>(camera.height()));
    for (size_t i = 0; i < pixels.size(); ++i) {
      if (buffer.order(i) != OrderedBuffer::kNone) {
        pixels[i] = {buffer.order(i), buffer.fragment(i)};
        pixels[i].sample.triangle += first;
      }
    }
    startMerging(watch, pixels.size());
    Composite<NearestOrdered, OrderedPixel>(pixels, ranks).run(how);
    cost.mergeSeconds += watch.lap();
    OrderedBuffer merged(pixels.size());
    for (size_t i = 0; i < pixels.size(); ++i) {
      if (NearestOrdered::holds(pixels[i])) {
        const Fragment& sample = pixels[i].sample;
        merged.put(i, static_cast<uint8_t>(pixels[i].order), sample.t, sample.triangle, {sample.b1, sample.b2});
      }
    }
    return fragmentsOf(camera, merged, mesh);
  }

  /// `drawn` is the same in all ranks where they have drawn the same.
  void startMerging(Seconds& watch, uint64_t drawn) {
    cost.drawSeconds += watch.lap();
    ++cost.images;
    requireAgreement(ranks, drawn + static_cast<uint64_t>(cost.images));
    cost.waitSeconds += watch.lap();
  }

  const Mesh& mesh;
  Ranks& ranks;
  Compositing how;
  Mesh part;
  std::optional<MeshBlocks> blocks;  ///< of the part
  uint32_t first = 0;                ///< triangle of the mesh in the part
  std::shared_ptr<const ProjectedMesh> projected;
  std::unique_ptr<SharedLines> lines;
  SharedDrawing cost;
};

SharedRenderer::SharedRenderer(const Mesh& mesh, Ranks& ranks, Compositing how)
    : impl_(std::make_unique<Impl>(mesh, ranks, how)) {}
SharedRenderer::~SharedRenderer() = default;

void SharedRenderer::finish() const {
  requireAgreement(impl_->ranks, static_cast<uint64_t>(impl_->cost.images) << 48);
}

const SharedDrawing& SharedRenderer::cost() const {
  return impl_->cost;
}

FragmentImage SharedRenderer::draw(const PinholeCamera& camera) const {
  return impl_->together([&] { return rasterize(*impl_->projectedBy(camera)); });
}

FragmentImage SharedRenderer::draw(const SpocCamera& camera) const {
  return impl_->displaced(camera, draw(camera.reference()), {});
}

FragmentImage SharedRenderer::draw(const ReversePinholeCamera& camera) const {
  return impl_->displaced(camera, draw(camera.reference()), {});
}

FragmentImage SharedRenderer::draw(const GpcCamera& camera) const {
  return impl_->together([&] { return rasterizeGpc(camera, *impl_->projectedBy(camera.reference())); });
}

FragmentImage SharedRenderer::draw(const DdocCamera& camera, const FragmentImage& seen,
                                   const SubdivisionOptions& subdivision) const {
  return impl_->displaced(camera, seen, subdivision);
}

FragmentImage SharedRenderer::drawLines(const PinholeCamera& base, const EpipolarLines& lines) const {
  return impl_->together([&] { return impl_->drawingAlong(base, lines).baseImage(); });
}

FragmentImage SharedRenderer::draw(const EpipolarCamera& camera, const FragmentImage& baseImage) const {
  return impl_->disoccluded(camera, baseImage, [&](const FragmentImage& nothing) {
    return impl_->drawingAlong(camera.base(), camera.lines()).draw(camera, nothing);
  });
}

FragmentImage SharedRenderer::drawTrimmed(const EpipolarCamera& camera, const FragmentImage& baseImage) const {
  OC_CHECK(impl_->isAlong(camera.base(), camera.lines()), "an epipolar camera of these lines was drawn before");
  return impl_->disoccluded(camera, baseImage, [&](const FragmentImage& nothing) {
    return impl_->drawingAlong(camera.base(), camera.lines()).drawAgain(camera, nothing);
  });
}

FragmentImage SharedRenderer::draw(const GraphCamera& camera) const {
  return impl_->alongPieces(camera);
}

FragmentImage SharedRenderer::draw(const CurvedRayCamera& camera) const {
  return impl_->alongPieces(camera);
}

}  // namespace ocelli
