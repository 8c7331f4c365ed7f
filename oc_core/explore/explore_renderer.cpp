#include "oc_core/explore/explore_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "oc_core/explore/explore_shapes.h"
#include "oc_core/image/color.h"
#include "oc_core/multiperspective/multiperspective_image.h"
#include "oc_core/render/rasterize_curved.h"
#include "oc_core/render/rasterize_graph.h"

namespace ocelli {
namespace {

constexpr size_t kPixelGrain = 1 << 13;
constexpr int kSteps = 4096;  // of linear light in the table of encoded bytes
const Rgb8 kSplitColor(90, 93, 98);
const Rgb8 kBesideColor(32, 34, 38);  // where an image of another shape leaves the picture empty

Rgb8 encoded(const glm::vec3& linear) {
  return {srgbByteFromLinear(linear.x), srgbByteFromLinear(linear.y), srgbByteFromLinear(linear.z)};
}

/// sRGB bytes by linear light: within a byte of srgbByteFromLinear().
class ByteTable {
 public:
  ByteTable() {
    for (size_t i = 0; i < bytes_.size(); ++i) {
      // Evenly in the square root, as sRGB is nearly.
      const float root = static_cast<float>(i) / kSteps;
      bytes_[i] = srgbByteFromLinear(root * root);
    }
  }

  uint8_t at(float linear) const {
    const float root = std::sqrt(std::clamp(linear, 0.0f, 1.0f));
    return bytes_[static_cast<size_t>(root * kSteps + 0.5f)];
  }

 private:
  std::array<uint8_t, kSteps + 1> bytes_{};
};

const ByteTable& byteTable() {
  static const ByteTable table;
  return table;
}

/// Colours of samples side by side, most of which are of the triangle before.
class TriangleColors {
 public:
  TriangleColors(const Mesh& mesh, const std::vector<Rgb8>& vertexColors) : mesh_(mesh), vertexColors_(vertexColors) {}

  Rgb8 at(const Fragment& fragment) {
    if (fragment.triangle != triangle_) {
      triangle_ = fragment.triangle;
      const glm::uvec3& t = mesh_.triangles[triangle_];
      color_ = vertexColors_[t.x];
      isOneColor_ = color_ == vertexColors_[t.y] && color_ == vertexColors_[t.z];
    }
    if (isOneColor_) {  // as most are
      return color_;
    }
    const glm::vec3 color = colorOf(fragment, mesh_);
    return {table_.at(color.x), table_.at(color.y), table_.at(color.z)};
  }

 private:
  const Mesh& mesh_;
  const std::vector<Rgb8>& vertexColors_;
  const ByteTable& table_ = byteTable();
  uint32_t triangle_ = Fragment::kNoTriangle;
  Rgb8 color_{0};
  bool isOneColor_ = false;
};

void copyFitted(const Image<Rgb8>& image, const FittedImage& fit, Image<Rgb8>& picture) {
  const int left = static_cast<int>(std::lround(fit.left));
  const int right = static_cast<int>(std::lround(fit.left + image.width() * fit.scale));
  const int top = static_cast<int>(std::lround(fit.top));
  const int bottom = static_cast<int>(std::lround(fit.top + image.height() * fit.scale));
  for (int y = top; y < bottom; ++y) {
    const int sourceY = std::min(image.height() - 1, static_cast<int>((y + 0.5 - fit.top) / fit.scale));
    for (int x = left; x < right; ++x) {
      const int sourceX = std::min(image.width() - 1, static_cast<int>((x + 0.5 - fit.left) / fit.scale));
      picture(x, y) = image(sourceX, sourceY);
    }
  }
}

void drawSplits(const std::vector<SplitLine>& splits, Image<Rgb8>& picture) {
  const int half = std::max(1, picture.width() / 1280);
  for (const SplitLine& line : splits) {
    const int middle = static_cast<int>(line.u);
    const int top = std::max(0, static_cast<int>(line.top));
    const int bottom = std::min(picture.height(), static_cast<int>(line.bottom));
    for (int y = top; y < bottom; ++y) {
      for (int x = std::max(0, middle - half); x < std::min(picture.width(), middle + half); ++x) {
        picture(x, y) = kSplitColor;
      }
    }
  }
}

/// `share` of the first.
Image<Rgb8> mixed(const Image<Rgb8>& one, const Image<Rgb8>& other, double share) {
  Image<Rgb8> image(other.width(), other.height());
  const int weight = static_cast<int>(std::lround(share * 256));
  parallelFor(image.size(), size_t{1} << 15, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      for (int k = 0; k < 3; ++k) {
        image[i][k] = static_cast<uint8_t>((one[i][k] * weight + other[i][k] * (256 - weight) + 128) >> 8);
      }
    }
  });
  return image;
}

}  // namespace

ExploreRenderer::ExploreRenderer(const ExploreScene& scene) : scene_(scene) {
  const Mesh& mesh = scene.mesh();
  vertexColors_.resize(mesh.positions.size());
  parallelFor(vertexColors_.size(), 4096, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      vertexColors_[i] = encoded(mesh.color(static_cast<uint32_t>(i)));
    }
  });
}

Image<Rgb8> ExploreRenderer::draw(const MultiperspectiveCamera& camera) const {
  const int width = std::visit([](const auto& each) { return each.width(); }, camera);
  const int height = std::visit([](const auto& each) { return each.height(); }, camera);
  Image<Rgb8> image(width, height, encoded(skyColor()));
  const auto* graph = std::get_if<GraphCamera>(&camera);
  if (graph != nullptr && endsBeforeZFar(*graph, scene_.bounds())) {
    visitSamples(*graph, scene_.mesh(), scene_.blocks(), [&](const RegionBuffer::SampleRun& run) {
      TriangleColors colors(scene_.mesh(), vertexColors_);
      Rgb8* to = &image(run.x, run.y);
      for (size_t i = 0; i < run.size; ++i) {
        to[i] = colors.at(run.fragment(i));
      }
    });
    return image;
  }
  const FragmentImage fragments =
      std::visit([&](const auto& each) { return rasterize(each, scene_.mesh(), scene_.blocks()); }, camera);
  parallelFor(image.size(), kPixelGrain, [&](size_t begin, size_t end) {
    TriangleColors colors(scene_.mesh(), vertexColors_);
    for (size_t i = begin; i < end; ++i) {
      if (fragments[i].covered()) {
        image[i] = colors.at(fragments[i]);
      }
    }
  });
  return image;
}

Image<Rgb8> ExploreRenderer::imageOf(const ExploreFrame& frame) {
  if (!frame.still || frame.still != still_) {
    Image<Rgb8> image = draw(frame.camera);
    ++drawnCameras_;
    still_ = frame.still;
    stillImage_ = still_ ? image : Image<Rgb8>();
    return image;
  }
  return stillImage_;
}

ExplorePicture ExploreRenderer::draw(const ExploreFrame& frame, bool pinholeBeside) {
  const int width = frame.pinhole.width();
  const int height = frame.pinhole.height();
  Image<Rgb8> picture = imageOf(frame);
  if (frame.behind || picture.width() != width || picture.height() != height) {
    const Image<Rgb8> ahead = std::move(picture);
    picture = Image<Rgb8>(width, height, kBesideColor);
    copyFitted(ahead, fittedAhead(frame), picture);
    if (frame.behind) {
      copyFitted(draw(*frame.behind), FittedImage{}, picture);
    }
  }
  drawSplits(frame.splits, picture);
  if (frame.dissolve > 0) {
    if (dissolvingFrom_ != frame.dissolveFrom) {
      dissolvingFrom_ = frame.dissolveFrom;
      dissolving_ = last_;
    }
    if (dissolving_.width() == width && dissolving_.height() == height) {
      picture = mixed(dissolving_, picture, frame.dissolve);
    }
  }
  last_ = picture;
  ExplorePicture done{std::move(picture), {}, frame.number};
  if (pinholeBeside) {
    done.pinhole = draw(MultiperspectiveCamera(GraphCamera(frame.pinhole)));
  }
  return done;
}

ExploreDrawing::ExploreDrawing(const ExploreScene& scene) : renderer_(scene), thread_([this] { run(); }) {}

ExploreDrawing::~ExploreDrawing() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ExploreDrawing::want(const ExploreFrame& frame, bool pinholeBeside) {
  {
    const std::scoped_lock lock(mutex_);
    wanted_ = frame;
    pinholeBeside_ = pinholeBeside;
  }
  changed_.notify_all();
}

std::optional<ExplorePicture> ExploreDrawing::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(done_, std::nullopt);
}

void ExploreDrawing::waitUntilIdle() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !wanted_ && !busy_; });
}

void ExploreDrawing::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    busy_ = false;
    changed_.notify_all();
    changed_.wait(lock, [this] { return stop_ || wanted_; });
    if (stop_) {
      return;
    }
    const ExploreFrame frame = *std::exchange(wanted_, std::nullopt);
    const bool pinholeBeside = pinholeBeside_;
    busy_ = true;
    lock.unlock();
    ExplorePicture picture = renderer_.draw(frame, pinholeBeside);
    lock.lock();
    done_ = std::move(picture);
  }
}

}  // namespace ocelli
