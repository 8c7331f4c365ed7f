#include "oc_core/ocri/layered_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/grid_cell.h"
#include "oc_core/ocri/sample_join.h"
#include "oc_core/ocri/square_corner.h"

namespace ocelli {
namespace {

constexpr int kNone = -1;

class LayeredMesher {
 public:
  LayeredMesher(const ReferenceImages& layers, const ImageMeshOptions& options)
      : layers_(layers),
        options_(options),
        camera_(layers[0].reference()),
        width_(layers[0].width()),
        height_(layers[0].height()) {}

  Mesh mesh(std::vector<uint32_t>* sampleOfVertex) {
    addVertices();
    match();
    joinNeighbours();
    addSquares();
    if (sampleOfVertex != nullptr) {
      fillSamples(*sampleOfVertex);
    }
    return std::move(mesh_);
  }

 private:
  struct Pixel {
    int x, y;
  };
  /// The samples of a pixel: consecutive numbers.
  struct Range {
    int begin = 0, end = 0;
  };

  Range samplesOf(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) {
      return {};
    }
    const size_t pixel = layers_[0].t.index(x, y);
    return {first_[pixel], first_[pixel + 1]};
  }

  void addVertices() {
    first_.push_back(0);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        for (size_t i = 0; i < layers_.size(); ++i) {
          const ReferenceImage& layer = layers_[i];
          if (const auto point = camera_.unproject(layer.undistorted(x, y))) {
            sample_.push_back(static_cast<uint32_t>(i * layer.t.size() + layer.t.index(x, y)));
            mesh_.positions.push_back(*point);
            mesh_.colors.push_back(layer.color(x, y));
            z_.push_back(layer.t(x, y));
            pixel_.push_back({x, y});
          }
        }
        first_.push_back(static_cast<int>(z_.size()));
      }
    }
  }

  float z(int sample) const { return z_[static_cast<size_t>(sample)]; }
  float inverseZ(int sample) const { return 1 / z(sample); }
  float distance(int s, int t) const {
    const Pixel& p = pixel_[static_cast<size_t>(s)];
    const Pixel& q = pixel_[static_cast<size_t>(t)];
    return p.x == q.x || p.y == q.y ? 1.0f : std::sqrt(2.0f);
  }

  /// The least change of slope, in 1/z a step, with which some surface of the pixel before s or the one after t goes on
  /// from s to t. `before` and `after` are `kFar` where there is none.
  struct Bends {
    float before, after;
  };
  static constexpr float kFar = 1e30f;

  Bends bends(int s, int t) const {
    const Pixel& p = pixel_[static_cast<size_t>(s)];
    const Pixel& q = pixel_[static_cast<size_t>(t)];
    const float step = inverseZ(t) - inverseZ(s);
    Bends least{kFar, kFar};
    const Range before = samplesOf(2 * p.x - q.x, 2 * p.y - q.y);
    for (int i = before.begin; i < before.end; ++i) {
      least.before = std::min(least.before, std::abs(step - (inverseZ(s) - inverseZ(i))));
    }
    const Range after = samplesOf(2 * q.x - p.x, 2 * q.y - p.y);
    for (int i = after.begin; i < after.end; ++i) {
      least.after = std::min(least.after, std::abs(step - (inverseZ(i) - inverseZ(t))));
    }
    return least;
  }

  /// Whether imageMesh() would join the two, and if so how badly they continue each other.
  bool canJoin(int s, int t, float& cost) const {
    const float footprint = std::min(z(s), z(t)) / camera_.focalPixels();
    const Bends bend = bends(s, t);
    const float step = std::abs(inverseZ(t) - inverseZ(s));
    cost = std::min(bend.before, step) + std::min(bend.after, step);
    if (distance(s, t) > options_.longestStepPixels) {
      return false;
    }
    return depthsJoin(z(s), z(t), footprint, distance(s, t), options_) ||
           std::min(bend.before, bend.after) <= slopeTolerance(z(s), z(t), footprint, options_);
  }
  bool canJoin(int s, int t) const {
    float cost = 0;
    return s != kNone && t != kNone && canJoin(s, t, cost);
  }

  /// Joins the samples of two pixels one to one, the best continuations first.
  void matchPixels(const Range& p, const Range& q, std::vector<int>& next, std::vector<int>& previous) const {
    struct Candidate {
      float cost;
      int s, t;
    };
    std::vector<Candidate> candidates;
    for (int s = p.begin; s < p.end; ++s) {
      for (int t = q.begin; t < q.end; ++t) {
        float cost = 0;
        if (canJoin(s, t, cost)) {
          candidates.push_back({cost, s, t});
        }
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    for (const Candidate& candidate : candidates) {
      int& forward = next[static_cast<size_t>(candidate.s)];
      int& back = previous[static_cast<size_t>(candidate.t)];
      if (forward == kNone && back == kNone) {
        forward = candidate.t;
        back = candidate.s;
      }
    }
  }

  void match() {
    for (std::vector<int>* links : {&right_, &left_, &below_, &above_}) {
      links->assign(z_.size(), kNone);
    }
    parallelFor(static_cast<size_t>(height_), 4, [&](size_t begin, size_t end) {
      for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
        for (int x = 0; x < width_; ++x) {
          matchPixels(samplesOf(x, y), samplesOf(x + 1, y), right_, left_);
          matchPixels(samplesOf(x, y), samplesOf(x, y + 1), below_, above_);
        }
      }
    });
    trianglesAround_.assign(z_.size(), 0);
  }

  static int follow(const std::vector<int>& links, int sample) {
    return sample == kNone ? kNone : links[static_cast<size_t>(sample)];
  }
  /// `sample` where `links` lead from it nowhere.
  static int freeOf(const std::vector<int>& links, int sample) {
    return follow(links, sample) == kNone ? sample : kNone;
  }
  static bool linked(const std::vector<int>& links, int s, int t) { return t != kNone && follow(links, s) == t; }

  /// The piece of one surface between four pixels: a top left, then counter-clockwise; kNone where it has no sample.
  void joinCell(int a, int b, int c, int d) {
    const size_t before = mesh_.triangles.size();
    closeCell(
        a, b, c, d, {linked(below_, a, b), linked(right_, b, c), linked(above_, c, d), linked(left_, d, a)},
        [&](int s, int t) { return canJoin(s, t); }, [&](int s) { return inverseZ(s); },
        [&](int p, int q, int r) { mesh_.triangles.emplace_back(p, q, r); });
    for (const int corner : {a, b, c, d}) {
      if (corner != kNone) {
        trianglesAround_[static_cast<size_t>(corner)] += static_cast<uint8_t>(mesh_.triangles.size() - before);
      }
    }
  }

  void joinNeighbours() {
    for (int y = 0; y + 1 < height_; ++y) {
      for (int x = 0; x + 1 < width_; ++x) {
        const Range top = samplesOf(x, y);
        for (int a = top.begin; a < top.end; ++a) {
          int b = follow(below_, a);
          int d = follow(right_, a);
          // Round both ways to the opposite corner; where they end in different samples, one of them is cut.
          int c = follow(right_, b);
          if (c == kNone) {
            c = follow(below_, d);
          }
          b = b == kNone ? freeOf(above_, follow(left_, c)) : b;
          d = d == kNone ? freeOf(left_, follow(above_, c)) : d;
          joinCell(a, b, c, d);
        }
        const Range bottom = samplesOf(x + 1, y + 1);
        for (int c = bottom.begin; c < bottom.end; ++c) {
          // Those with a fourth corner have had their turn.
          joinCell(kNone, freeOf(above_, follow(left_, c)), c, freeOf(left_, follow(above_, c)));
        }
      }
    }
  }

  /// Of the samples, then of the corners of squares.
  void fillSamples(std::vector<uint32_t>& sampleOfVertex) const {
    sampleOfVertex = sample_;
    for (size_t s = 0; s < z_.size(); ++s) {
      for (size_t corner = 0; corner < kSquareSides.size() && isOpen(s); ++corner) {
        sampleOfVertex.push_back(sample_[s]);
      }
    }
  }

  /// The change of 1/z for a pixel to the right and a pixel down.
  glm::vec2 gradient(int s) const {
    const auto slope = [&](const std::vector<int>& forward, const std::vector<int>& back) {
      float rhs = 0;
      float weight = 1e-3f;
      if (const int t = follow(forward, s); t != kNone) {
        rhs += inverseZ(t) - inverseZ(s);
        weight += 1;
      }
      if (const int t = follow(back, s); t != kNone) {
        rhs += inverseZ(s) - inverseZ(t);
        weight += 1;
      }
      return rhs / weight;
    };
    return {slope(right_, left_), slope(below_, above_)};
  }

  /// Whether its surface ends there.
  bool isOpen(size_t sample) const { return trianglesAround_[sample] < kClosedTriangles; }

  void addSquares() {
    for (int s = 0; s < static_cast<int>(z_.size()); ++s) {
      if (isOpen(static_cast<size_t>(s))) {
        addSquare(s);
      }
    }
  }

  void addSquare(int s) {
    const Pixel& p = pixel_[static_cast<size_t>(s)];
    const ImagePoint center{static_cast<float>(p.x) + 0.5f, static_cast<float>(p.y) + 0.5f, z_[static_cast<size_t>(s)]};
    const glm::vec2 slope = gradient(s);
    const auto corner = static_cast<uint32_t>(mesh_.positions.size());
    for (const glm::vec2& side : kSquareSides) {
      const glm::vec2 offset = side * (options_.squarePixels / 2);
      const ImagePoint step{offset.x, offset.y, glm::dot(slope, offset)};
      mesh_.positions.push_back(camera_.worldFromCamera(
          camera_.cameraFromImage(squareCorner(center, step, camera_.focalPixels(), options_))));
      mesh_.colors.push_back(mesh_.colors[static_cast<size_t>(s)]);
    }
    mesh_.triangles.emplace_back(corner, corner + 1, corner + 2);
    mesh_.triangles.emplace_back(corner, corner + 2, corner + 3);
  }

  const ReferenceImages& layers_;
  const ImageMeshOptions& options_;
  PinholeCamera camera_;
  int width_;
  int height_;
  std::vector<int> first_;  ///< the first sample of each pixel, and one behind the last
  std::vector<float> z_;    ///< of each sample
  std::vector<Pixel> pixel_;
  std::vector<uint32_t> sample_;                   ///< its pixel, plus its layer times the pixels of one
  std::vector<int> right_, left_, below_, above_;  ///< the sample that each sample is joined with, or kNone
  std::vector<uint8_t> trianglesAround_;           ///< of each sample's surface, in the four cells around it
  Mesh mesh_;
};

}  // namespace

Mesh layeredMesh(const ReferenceImages& layers, const ImageMeshOptions& options,
                 std::vector<uint32_t>* sampleOfVertex) {
  if (layers.empty()) {
    return {};
  }
  for (const ReferenceImage& layer : layers) {
    OC_CHECK(layer.view == layers[0].view && layer.width() == layers[0].width() && layer.height() == layers[0].height(),
             "the layers of an image have one view and one size");
  }
  return LayeredMesher(layers, options).mesh(sampleOfVertex);
}

}  // namespace ocelli
