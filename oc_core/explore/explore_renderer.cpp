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

constexpr size_t kRowGrain = 8;
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
  const Mesh& mesh = scene_.mesh();
  const FragmentImage fragments =
      std::visit([&](const auto& each) { return rasterize(each, mesh, scene_.blocks()); }, camera);
  const Rgb8 sky = encoded(skyColor());
  Image<Rgb8> image(fragments.width(), fragments.height());
  const ByteTable& table = byteTable();
  parallelFor(static_cast<size_t>(image.height()), kRowGrain, [&](size_t begin, size_t end) {
    const auto width = static_cast<size_t>(image.width());
    for (size_t i = begin * width; i < end * width; ++i) {
      const Fragment& fragment = fragments[i];
      if (!fragment.covered()) {
        image[i] = sky;
        continue;
      }
      // Most triangles have one colour.
      const glm::uvec3& t = mesh.triangles[fragment.triangle];
      const Rgb8& a = vertexColors_[t.x];
      if (a == vertexColors_[t.y] && a == vertexColors_[t.z]) {
        image[i] = a;
      } else {
        const glm::vec3 color = colorOf(fragment, mesh);
        image[i] = {table.at(color.x), table.at(color.y), table.at(color.z)};
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
