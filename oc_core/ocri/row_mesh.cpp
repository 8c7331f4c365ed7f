#include "oc_core/ocri/row_mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <ranges>
#include <span>

#include "oc_core/base/parallel.h"
#include "oc_core/ocri/sample_join.h"
#include "oc_core/ocri/square_corner.h"

namespace ocelli {
namespace {

constexpr int kNoSample = -1;
/// Partners are no farther apart along their rows, pixels.
constexpr float kFarthestPartner = 1.25f;

/// A sample of a row. Neighbours are indices in the lists of their rows.
struct RowSample {
  ImagePoint place;  ///< undistorted
  int column = 0;
  float along = 0;  ///< position along the row, pixels
  uint32_t vertex = 0;
  int above = kNoSample;  ///< the nearest in the row above, whether or not it is of the same surface
  int below = kNoSample;
  bool joinsNext = false;
  bool closedAbove = false;  ///< between this sample and the next one there is a triangle that reaches up
  bool closedBelow = false;
};

struct Row {
  std::vector<RowSample> samples;
  glm::vec2 direction{1, 0};
  /// Indices of samples by the whole pixel of their position: those of pixel i are sorted[first[i] .. first[i + 1]).
  float origin = 0;
  std::vector<uint32_t> first;
  std::vector<uint32_t> sorted;
  /// Of the strip to the next row.
  std::vector<glm::uvec3> triangles;
  std::vector<uint32_t> open;  ///< indices of samples that get a square
};

/// Where what belongs to each row starts in a list of all rows, and where the list ends.
template <class SizeOf>
std::vector<size_t> startsOf(const std::vector<Row>& rows, const SizeOf& sizeOf) {
  std::vector<size_t> starts{0};
  for (const Row& row : rows) {
    starts.push_back(starts.back() + sizeOf(row));
  }
  return starts;
}

class RowMesher {
 public:
  RowMesher(const ReferenceImage& image, const ImageMeshOptions& options)
      : image_(image),
        options_(options),
        camera_(image.reference()),
        focal_(camera_.focalPixels()),
        rows_(static_cast<size_t>(image.height())) {}

  Mesh mesh(std::vector<uint32_t>* pixelOfVertex) {
    wantsPixels_ = pixelOfVertex != nullptr;
    makeMesh();
    if (wantsPixels_) {
      *pixelOfVertex = std::move(pixelOfVertex_);
    }
    return std::move(mesh_);
  }

 private:
  void makeMesh() {
    forRows([&](size_t y) { findSamples(y); });
    firstVertex_ = startsOf(rows_, [](const Row& row) { return row.samples.size(); });
    if (firstVertex_.back() == 0) {
      return;
    }
    forRows([&](size_t y) {
      for (RowSample& sample : rows_[y].samples) {
        sample.vertex += static_cast<uint32_t>(firstVertex_[y]);
      }
    });
    setDirections();
    forRows([&](size_t y) { sortSamples(rows_[y]); });
    forRows([&](size_t y) {
      findPartners(y);
      joinAlong(rows_[y]);
    });
    forRows([&](size_t y) { closeStrip(y); });
    forRows([&](size_t y) { findOpen(rows_[y]); });
    writeMesh();
  }
  template <class Body>
  void forRows(const Body& body) {
    parallelFor(rows_.size(), 8, [&](size_t begin, size_t end) {
      for (size_t y = begin; y < end; ++y) {
        body(y);
      }
    });
  }

  std::optional<size_t> below(size_t y) const {
    if (y + 1 < rows_.size()) {
      return y + 1;
    }
    return image_.rows == ImageRows::kShiftedRing && rows_.size() > 2 ? std::optional<size_t>(0) : std::nullopt;
  }
  std::optional<size_t> above(size_t y) const {
    if (y > 0) {
      return y - 1;
    }
    return image_.rows == ImageRows::kShiftedRing && rows_.size() > 2 ? std::optional(rows_.size() - 1) : std::nullopt;
  }

  void findSamples(size_t row) {
    const int y = static_cast<int>(row);
    std::vector<RowSample>& samples = rows_[row].samples;
    samples.reserve(static_cast<size_t>(image_.width()));
    for (int x = 0; x < image_.width(); ++x) {
      if (image_.holds(x, y) && camera_.unproject(image_.undistorted(x, y))) {
        RowSample sample{image_.undistorted(x, y), x};
        sample.vertex = static_cast<uint32_t>(samples.size());  // of the row
        samples.push_back(sample);
      }
    }
  }

  void notePixel(size_t vertex, const RowSample& sample, size_t y) {
    if (wantsPixels_) {
      pixelOfVertex_[vertex] = static_cast<uint32_t>(image_.t.index(sample.column, static_cast<int>(y)));
    }
  }

  /// First the samples, then the corners of squares; first the triangles of strips, then those of squares; row by row.
  void writeMesh() {
    const std::vector<size_t> firstTriangle = startsOf(rows_, [](const Row& row) { return row.triangles.size(); });
    const std::vector<size_t> firstSquare = startsOf(rows_, [](const Row& row) { return row.open.size(); });
    parallelChunks(2, 2, [&](size_t chunk, size_t, size_t) {
      if (chunk == 0) {
        mesh_.triangles.resize(firstTriangle.back() + 2 * firstSquare.back());
      } else {
        mesh_.positions.resize(firstVertex_.back() + 4 * firstSquare.back());
        mesh_.colors.resize(mesh_.positions.size());
        pixelOfVertex_.resize(wantsPixels_ ? mesh_.positions.size() : 0);
      }
    });
    forRows([&](size_t y) {
      const Row& row = rows_[y];
      for (const RowSample& sample : row.samples) {
        notePixel(sample.vertex, sample, y);
        mesh_.positions[sample.vertex] = *camera_.unproject(sample.place);
        mesh_.colors[sample.vertex] = image_.color(sample.column, static_cast<int>(y));
      }
      std::copy(row.triangles.begin(), row.triangles.end(),
                mesh_.triangles.begin() + static_cast<std::ptrdiff_t>(firstTriangle[y]));
      for (size_t i = 0; i < row.open.size(); ++i) {
        const size_t square = firstSquare[y] + i;
        addSquare(y, row.open[i], firstVertex_.back() + 4 * square, firstTriangle.back() + 2 * square);
      }
    });
  }

  /// Rows run towards larger columns. One whose samples are all at one place runs as the next one
  /// below it that has a direction, or else as the last one above.
  void setDirections() {
    constexpr float kMinLength = 1;
    std::optional<glm::vec2> last;
    const auto set = [&](Row& row) {
      if (row.samples.size() > 1) {
        // The undistorted places fold back behind occluders: the farthest is not the last one.
        const glm::vec2 start(row.samples.front().place.u, row.samples.front().place.v);
        glm::vec2 longest(0);
        for (const RowSample& sample : row.samples) {
          const glm::vec2 d = glm::vec2(sample.place.u, sample.place.v) - start;
          longest = glm::dot(d, d) > glm::dot(longest, longest) ? d : longest;
        }
        if (glm::length(longest) >= kMinLength) {
          last = glm::normalize(longest);
        }
      }
      row.direction = last.value_or(glm::vec2(1, 0));
    };
    for (Row& row : rows_) {
      set(row);
    }
    for (Row& row : std::views::reverse(rows_)) {
      set(row);
    }
  }

  static void sortSamples(Row& row) {
    if (row.samples.empty()) {
      return;
    }
    float least = 1e30f;
    float most = -1e30f;
    for (RowSample& sample : row.samples) {
      sample.along = glm::dot(row.direction, glm::vec2(sample.place.u, sample.place.v));
      least = std::min(least, sample.along);
      most = std::max(most, sample.along);
    }
    row.origin = std::floor(least);
    row.first.assign(static_cast<size_t>(most - row.origin) + 2, 0);
    for (const RowSample& sample : row.samples) {
      ++row.first[pixelOf(row, sample.along) + 1];
    }
    for (size_t i = 1; i < row.first.size(); ++i) {
      row.first[i] += row.first[i - 1];
    }
    std::vector<uint32_t> next(row.first.begin(), row.first.end() - 1);
    row.sorted.resize(row.samples.size());
    for (size_t i = 0; i < row.samples.size(); ++i) {
      row.sorted[next[pixelOf(row, row.samples[i].along)]++] = static_cast<uint32_t>(i);
    }
  }
  static size_t pixelOf(const Row& row, float along) { return static_cast<size_t>(along - row.origin); }

  /// The sample of `row` that is nearest to `sample`, undistorted: along the row in pixels, in depth in as many
  /// footprints as join neighbours.
  int nearest(const RowSample& sample, const Row& row) const {
    if (row.samples.empty()) {
      return kNoSample;
    }
    const float along = glm::dot(row.direction, glm::vec2(sample.place.u, sample.place.v));
    const auto last = static_cast<float>(row.first.size() - 2);
    const float from = along - kFarthestPartner - row.origin;
    const float to = along + kFarthestPartner - row.origin;
    if (!(to >= 0) || !(from <= last + 1)) {
      return kNoSample;
    }
    const uint32_t begin = row.first[static_cast<size_t>(std::clamp(from, 0.0f, last))];
    const uint32_t end = row.first[static_cast<size_t>(std::clamp(to, 0.0f, last)) + 1];
    const float depthStep = options_.depthStepFootprints * sample.place.t / focal_;
    int best = kNoSample;
    float minCost = 1e30f;
    for (const uint32_t i : std::span(row.sorted).subspan(begin, end - begin)) {
      const RowSample& other = row.samples[i];
      const float offset = std::abs(other.along - along);
      const float cost = offset + std::abs(other.place.t - sample.place.t) / depthStep;
      if (offset <= kFarthestPartner && cost < minCost) {
        minCost = cost;
        best = static_cast<int>(i);
      }
    }
    return best;
  }

  void findPartners(size_t y) {
    const std::optional<size_t> up = above(y);
    const std::optional<size_t> down = below(y);
    for (RowSample& sample : rows_[y].samples) {
      sample.above = up ? nearest(sample, rows_[*up]) : kNoSample;
      sample.below = down ? nearest(sample, rows_[*down]) : kNoSample;
    }
  }

  void joinAlong(Row& row) {
    const auto place = [&](size_t i) { return i < row.samples.size() ? row.samples[i].place : ImagePoint{}; };
    for (size_t i = 0; i + 1 < row.samples.size(); ++i) {
      RowSample& sample = row.samples[i];
      sample.joinsNext = row.samples[i + 1].column == sample.column + 1 &&
                         samplesJoin(place(i - 1), sample.place, place(i + 1), place(i + 2), true, focal_, 1, options_);
    }
  }

  /// Of a row, the sample next to `from` that is nearest to a position along the row; from itself, or one that is
  /// joined to it. No place where `from` is kNoSample.
  static ImagePoint placeNear(const Row& row, int from, float along) {
    if (from == kNoSample) {
      return {};
    }
    const auto i = static_cast<size_t>(from);
    const RowSample* nearest = &row.samples[i];
    const auto consider = [&](const RowSample& other) {
      if (std::abs(other.along - along) < std::abs(nearest->along - along)) {
        nearest = &other;
      }
    };
    if (i > 0 && row.samples[i - 1].joinsNext) {
      consider(row.samples[i - 1]);
    }
    if (row.samples[i].joinsNext) {
      consider(row.samples[i + 1]);
    }
    return nearest->place;
  }

  /// Whether a sample of row y and one of the row below lie on one surface.
  bool joinsAcross(size_t y, const RowSample& a, const RowSample& b) const {
    if (samplesJoin({}, a.place, b.place, {}, false, focal_, 1, options_)) {
      return true;
    }
    // The samples that go on in the same direction beyond a and b.
    const std::optional<size_t> up = above(y);
    const std::optional<size_t> next = below(*below(y));
    const float step = b.along - a.along;
    const ImagePoint before = up ? placeNear(rows_[*up], a.above, a.along - step) : ImagePoint{};
    const ImagePoint after = next ? placeNear(rows_[*next], b.below, b.along + step) : ImagePoint{};
    return samplesJoin(before, a.place, b.place, after, false, focal_, 1, options_);
  }

  /// The longest list of partners that keeps the order of columns in both rows: for each sample of `row` its partner in
  /// the row below, or kNoSample.
  std::vector<int> orderedPartners(size_t y) const {
    const std::vector<RowSample>& samples = rows_[y].samples;
    const std::vector<RowSample>& others = rows_[*below(y)].samples;
    std::vector<int> tails;  // the sample that ends the best list of each length
    std::vector<int> previous(samples.size(), kNoSample);
    for (size_t i = 0; i < samples.size(); ++i) {
      const int partner = samples[i].below;
      if (partner == kNoSample || !joinsAcross(y, samples[i], others[static_cast<size_t>(partner)])) {
        continue;
      }
      const auto at = std::upper_bound(tails.begin(), tails.end(), partner, [&](int value, int tail) {
        return value < samples[static_cast<size_t>(tail)].below;
      });
      previous[i] = at == tails.begin() ? kNoSample : *std::prev(at);
      if (at == tails.end()) {
        tails.push_back(static_cast<int>(i));
      } else {
        *at = static_cast<int>(i);
      }
    }
    std::vector<int> partners(samples.size(), kNoSample);
    for (int i = tails.empty() ? kNoSample : tails.back(); i != kNoSample; i = previous[static_cast<size_t>(i)]) {
      partners[static_cast<size_t>(i)] = samples[static_cast<size_t>(i)].below;
    }
    return partners;
  }

  /// Whether samples from..to of a row are joined one to the next.
  static bool connected(const Row& row, int from, int to) {
    for (int i = from; i < to; ++i) {
      if (!row.samples[static_cast<size_t>(i)].joinsNext) {
        return false;
      }
    }
    return true;
  }

  /// Closes the gap between a row and the one below.
  struct Strip {
    RowMesher& mesher;
    size_t y;
    Row& upper;
    Row& lower;
    bool mirrored = false;  ///< the row below lies to the left of the row's direction
    int i = kNoSample;      ///< the last edge across, from sample i of the upper row to sample j of the lower one
    int j = kNoSample;

    RowSample& a(int k) const { return upper.samples[static_cast<size_t>(k)]; }
    RowSample& b(int k) const { return lower.samples[static_cast<size_t>(k)]; }

    bool canAdvanceUpper() const {
      return i + 1 < static_cast<int>(upper.samples.size()) && a(i).joinsNext && !a(i).closedBelow &&
             mesher.joinsAcross(y, a(i + 1), b(j));
    }
    bool canAdvanceLower() const {
      return j + 1 < static_cast<int>(lower.samples.size()) && b(j).joinsNext && !b(j).closedAbove &&
             mesher.joinsAcross(y, a(i), b(j + 1));
    }
    float cost(int ia, int jb) const {
      const ImagePoint& p = a(ia).place;
      const ImagePoint& q = b(jb).place;
      return undistortedDistance(p, q) +
             std::abs(p.t - q.t) * mesher.focal_ / (mesher.options_.depthStepFootprints * p.t);
    }
    void add(uint32_t p, uint32_t q, uint32_t r) const {
      upper.triangles.emplace_back(p, mirrored ? r : q, mirrored ? q : r);
    }
    void advanceUpper() {
      add(a(i).vertex, b(j).vertex, a(i + 1).vertex);
      a(i).closedBelow = true;
      ++i;
    }
    void advanceLower() {
      add(a(i).vertex, b(j).vertex, b(j + 1).vertex);
      b(j).closedAbove = true;
      ++j;
    }
    /// Goes on to the edge from `toI` to `toJ`, as far as all samples in between are of one surface.
    void advance(int toI, int toJ) {
      while (i < toI || j < toJ) {
        const bool up = i < toI && canAdvanceUpper();
        const bool low = j < toJ && canAdvanceLower();
        if (!up && !low) {
          return;
        }
        if (up && (!low || cost(i + 1, j) <= cost(i, j + 1))) {
          advanceUpper();
        } else {
          advanceLower();
        }
      }
    }
  };

  void closeStrip(size_t y) {
    const std::optional<size_t> down = below(y);
    if (!down) {
      return;
    }
    Row& upper = rows_[y];
    Row& lower = rows_[*down];
    const std::vector<int> partners = orderedPartners(y);
    std::vector<bool> lowerTaken(lower.samples.size(), false);
    for (const int partner : partners) {
      if (partner != kNoSample) {
        lowerTaken[static_cast<size_t>(partner)] = true;
      }
    }
    const auto free = [&](int i, int j) {  // neither has a partner of its own
      return (i < 0 || partners[static_cast<size_t>(i)] == kNoSample) && (j < 0 || !lowerTaken[static_cast<size_t>(j)]);
    };
    Strip strip{*this, y, upper, lower};
    // Beyond the last partners of a surface there may be one more sample in one of the two rows.
    const auto endSurface = [&] {
      if (strip.i == kNoSample) {
        return;
      }
      if (strip.canAdvanceUpper() && free(strip.i + 1, kNoSample)) {
        strip.advanceUpper();
      } else if (strip.canAdvanceLower() && free(kNoSample, strip.j + 1)) {
        strip.advanceLower();
      }
    };
    // The same before its first partners.
    const auto beginSurface = [&](int i, int j) {
      strip.i = i;
      strip.j = j;
      const int lastI = i - 1;
      const int lastJ = j - 1;
      if (lastI >= 0 && free(lastI, kNoSample) && strip.a(lastI).joinsNext && !strip.a(lastI).closedBelow &&
          joinsAcross(y, strip.a(lastI), strip.b(j))) {
        strip.i = lastI;
        strip.advanceUpper();
      } else if (lastJ >= 0 && free(kNoSample, lastJ) && strip.b(lastJ).joinsNext && !strip.b(lastJ).closedAbove &&
                 joinsAcross(y, strip.a(i), strip.b(lastJ))) {
        strip.j = lastJ;
        strip.advanceLower();
      }
    };
    for (int i = 0; i < static_cast<int>(partners.size()); ++i) {
      const int j = partners[static_cast<size_t>(i)];
      if (j == kNoSample) {
        continue;
      }
      strip.mirrored = isMirrored(upper.direction, strip.a(i), strip.b(j));
      if (strip.i != kNoSample && connected(upper, strip.i, i) && connected(lower, strip.j, j)) {
        strip.advance(i, j);
        if (strip.i == i && strip.j == j) {
          continue;
        }
      } else {
        endSurface();
      }
      beginSurface(i, j);
    }
    endSurface();
  }

  static bool isMirrored(const glm::vec2& direction, const RowSample& a, const RowSample& b) {
    return direction.x * (b.place.v - a.place.v) - direction.y * (b.place.u - a.place.u) < 0;
  }

  /// A sample with triangles on three of its four sides leaves no opening that matters; with fewer, its surface ends
  /// here.
  static void findOpen(Row& row) {
    constexpr int kClosed = 3;
    for (size_t i = 0; i < row.samples.size(); ++i) {
      const RowSample& sample = row.samples[i];
      int closed = sample.closedAbove + sample.closedBelow;
      if (i > 0) {
        const RowSample& last = row.samples[i - 1];
        closed += last.closedAbove + last.closedBelow;
      }
      if (closed < kClosed) {
        row.open.push_back(static_cast<uint32_t>(i));
      }
    }
  }

  /// Half the way to the neighbours of a sample, in pixels and 1/z, given the one before and the one after it.
  static std::optional<ImagePoint> halfStep(const ImagePoint& p, const ImagePoint* before, const ImagePoint* after) {
    const auto step = [](const ImagePoint& from, const ImagePoint& to, float share) {
      return ImagePoint{(to.u - from.u) * share, (to.v - from.v) * share, (1 / to.t - 1 / from.t) * share};
    };
    if (before != nullptr && after != nullptr) {
      return step(*before, *after, 0.25f);
    }
    if (before != nullptr) {
      return step(*before, p, 0.5f);
    }
    return after != nullptr ? std::optional(step(p, *after, 0.5f)) : std::nullopt;
  }

  static ImagePoint halfStepAlong(const Row& row, size_t i) {
    const ImagePoint* before = i > 0 && row.samples[i - 1].joinsNext ? &row.samples[i - 1].place : nullptr;
    const ImagePoint* after = row.samples[i].joinsNext ? &row.samples[i + 1].place : nullptr;
    return halfStep(row.samples[i].place, before, after)
        .value_or(ImagePoint{row.direction.x / 2, row.direction.y / 2, 0});
  }

  ImagePoint halfStepAcross(size_t y, const RowSample& sample) const {
    const std::optional<size_t> up = above(y);
    const std::optional<size_t> down = below(y);
    const RowSample* before = nullptr;
    const RowSample* after = nullptr;
    if (up && sample.above != kNoSample) {
      const RowSample& other = rows_[*up].samples[static_cast<size_t>(sample.above)];
      before = joinsAcross(*up, other, sample) ? &other : nullptr;
    }
    if (down && sample.below != kNoSample) {
      const RowSample& other = rows_[*down].samples[static_cast<size_t>(sample.below)];
      after = joinsAcross(y, sample, other) ? &other : nullptr;
    }
    const glm::vec2& direction = rows_[y].direction;
    return halfStep(sample.place, before != nullptr ? &before->place : nullptr,
                    after != nullptr ? &after->place : nullptr)
        .value_or(ImagePoint{-direction.y / 2, direction.x / 2, 0});
  }

  void addSquare(size_t y, size_t i, size_t vertex, size_t triangle) {
    const RowSample& sample = rows_[y].samples[i];
    const ImagePoint along = halfStepAlong(rows_[y], i);
    const ImagePoint across = halfStepAcross(y, sample);
    const bool mirrored = along.u * across.v - along.v * across.u < 0;
    const auto corner = static_cast<uint32_t>(vertex);
    for (const glm::vec2& side : kSquareSides) {
      const glm::vec2 share = side * options_.squarePixels;
      const ImagePoint offset{along.u * share.x + across.u * share.y, along.v * share.x + across.v * share.y,
                              along.t * share.x + across.t * share.y};
      const ImagePoint q = squareCorner(sample.place, offset, focal_, options_);
      notePixel(vertex, sample, y);
      mesh_.positions[vertex] = camera_.worldFromCamera(camera_.cameraFromImage(q));
      mesh_.colors[vertex++] = image_.color(sample.column, static_cast<int>(y));
    }
    mesh_.triangles[triangle] = {corner, corner + (mirrored ? 2u : 1u), corner + (mirrored ? 1u : 2u)};
    mesh_.triangles[triangle + 1] = {corner, corner + (mirrored ? 3u : 2u), corner + (mirrored ? 2u : 3u)};
  }

  const ReferenceImage& image_;
  const ImageMeshOptions& options_;
  PinholeCamera camera_;
  float focal_;
  std::vector<Row> rows_;
  std::vector<size_t> firstVertex_;  ///< of each row
  Mesh mesh_;
  bool wantsPixels_ = false;
  std::vector<uint32_t> pixelOfVertex_;
};

}  // namespace

Mesh rowMesh(const ReferenceImage& image, const ImageMeshOptions& options, std::vector<uint32_t>* pixelOfVertex) {
  return RowMesher(image, options).mesh(pixelOfVertex);
}

}  // namespace ocelli
