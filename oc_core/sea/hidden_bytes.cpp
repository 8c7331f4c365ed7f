#include "oc_core/sea/hidden_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "oc_core/base/error.h"
#include "oc_core/sea/sea_format.h"

namespace ocelli {
namespace {

constexpr int kCell = HiddenSamples::kCell;
constexpr int kHiddenBlock = 16;  ///< pixels a side; what a JPEG has of colours at half the resolution

/// The blocks of the image that hold samples, of one layer behind the other, in rows of so many that they are about as
/// wide as high.
class BlockAtlas {
 public:
  /// For each layer one bit for each block of the image, the first one the lowest of its byte.
  BlockAtlas(const SeaProjection& projection, std::span<const uint8_t> masks) {
    const glm::ivec2 blocks = blocksOf(projection);
    const size_t bytes = maskBytes(projection);
    for (size_t layer = 0; layer < masks.size() / bytes; ++layer) {
      const auto mask = masks.subspan(layer * bytes, bytes);
      for (int i = 0; i < blocks.x * blocks.y; ++i) {
        if ((mask[static_cast<size_t>(i) / 8] >> (i % 8) & 1) != 0) {
          blocks_.push_back({layer, {kHiddenBlock * (i % blocks.x), kHiddenBlock * (i / blocks.x)}});
        }
      }
    }
    columns_ = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(blocks_.size()))));
  }

  static size_t maskBytes(const SeaProjection& projection) {
    const glm::ivec2 blocks = blocksOf(projection);
    return (static_cast<size_t>(blocks.x) * static_cast<size_t>(blocks.y) + 7) / 8;
  }
  static std::vector<uint8_t> maskOf(const HiddenLayer& layer, const SeaProjection& projection) {
    std::vector<uint8_t> mask(maskBytes(projection));
    const int across = blocksOf(projection).x;
    for (int y = 0; y < layer.level.height(); ++y) {
      for (int x = 0; x < layer.level.width(); ++x) {
        if (layer.level(x, y) != 0) {
          const int block = y * kCell / kHiddenBlock * across + x * kCell / kHiddenBlock;
          mask[static_cast<size_t>(block) / 8] |= static_cast<uint8_t>(1 << block % 8);
        }
      }
    }
    return mask;
  }

  bool isEmpty() const { return blocks_.empty(); }
  glm::ivec2 size() const {
    const int rows = columns_ > 0 ? (static_cast<int>(blocks_.size()) + columns_ - 1) / columns_ : 0;
    return kHiddenBlock * glm::ivec2(columns_, rows);
  }

  /// Calls `visit` with the layer of each pixel of blocks, where it is in the image of this size, and where in the
  /// atlas. `scale`: 1 of pixels, kCell of cells.
  template <class Visit>
  void forEach(const glm::ivec2& image, int scale, const Visit& visit) const {
    const int side = kHiddenBlock / scale;
    for (size_t i = 0; i < blocks_.size(); ++i) {
      const auto number = static_cast<int>(i);
      const glm::ivec2 inAtlas = side * glm::ivec2(number % columns_, number / columns_);
      const glm::ivec2 inImage = blocks_[i].corner / scale;
      for (int y = 0; y < std::min(side, image.y - inImage.y); ++y) {
        for (int x = 0; x < std::min(side, image.x - inImage.x); ++x) {
          visit(blocks_[i].layer, inImage + glm::ivec2(x, y), inAtlas + glm::ivec2(x, y));
        }
      }
    }
  }

 private:
  struct Block {
    size_t layer;
    glm::ivec2 corner;  ///< in the image
  };

  static glm::ivec2 blocksOf(const SeaProjection& projection) {
    return {(projection.width + kHiddenBlock - 1) / kHiddenBlock,
            (projection.height + kHiddenBlock - 1) / kHiddenBlock};
  }

  std::vector<Block> blocks_;
  int columns_ = 0;
};

const DepthCodec& levelCodec() {
  const DepthCodec* codec = findDepthCodec("zstd");
  OC_CHECK(codec != nullptr, "zstd is a part of every build");
  return *codec;
}

template <class Bytes>
void appendTo(std::vector<uint8_t>& to, const Bytes& bytes) {
  const auto* first = reinterpret_cast<const uint8_t*>(bytes.data());
  to.insert(to.end(), first, first + bytes.size());
}

/// Takes bytes from the front.
class Reader {
 public:
  Reader(std::span<const uint8_t> bytes, std::string where) : bytes_(bytes), where_(std::move(where)) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError("these hidden samples are damaged: " + what, where_, "take another copy of the sea");
  }
  std::span<const uint8_t> take(size_t count) {
    if (count > bytes_.size()) {
      refuse("they end too early");
    }
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }
  bool isAtEnd() const { return bytes_.empty(); }

 private:
  std::span<const uint8_t> bytes_;
  std::string where_;
};

}  // namespace

std::vector<uint8_t> hiddenBytes(const HiddenSamples& hidden, const SeaProjection& projection, const ColorCodec& codec,
                                 double quality) {
  OC_CHECK(hidden.layers.size() <= HiddenSamples::kMaxLayers, "no more layers than that");
  std::vector<uint8_t> bytes;
  if (hidden.cellCount() == 0) {
    return bytes;
  }
  std::vector<uint8_t> masks;
  for (const HiddenLayer& layer : hidden.layers) {
    appendTo(masks, BlockAtlas::maskOf(layer, projection));
  }
  const BlockAtlas atlas(projection, masks);
  const glm::ivec2 size = atlas.size();
  Image<Rgb8> colors(size.x, size.y, Rgb8(128));
  atlas.forEach({projection.width, projection.height}, 1,
                [&](size_t layer, const glm::ivec2& at, const glm::ivec2& to) {
                  colors(to.x, to.y) = hidden.layers[layer].color(at.x, at.y);
                });
  Image<uint16_t> levels(size.x / kCell, size.y / kCell);
  atlas.forEach(HiddenSamples::levelSize(projection), kCell,
                [&](size_t layer, const glm::ivec2& at, const glm::ivec2& to) {
                  levels(to.x, to.y) = hidden.layers[layer].level(at.x, at.y);
                });
  const std::vector<std::byte> color = codec.encode(colors, quality);
  const std::vector<std::byte> level = levelCodec().encode(levels);
  appendTo(bytes, sea::bytesOf(sea::HiddenPrefix{.layers = static_cast<uint32_t>(hidden.layers.size()),
                                                 .nearest = hidden.nearest,
                                                 .colorBytes = static_cast<uint32_t>(color.size()),
                                                 .levelBytes = static_cast<uint32_t>(level.size())}));
  appendTo(bytes, masks);
  appendTo(bytes, color);
  appendTo(bytes, level);
  return bytes;
}

HiddenSamples hiddenFromBytes(std::span<const uint8_t> bytes, const SeaProjection& projection, const ColorCodec& codec,
                              const std::string& where) {
  Reader reader(bytes, where);
  sea::HiddenPrefix prefix;
  std::memcpy(&prefix, reader.take(sizeof(prefix)).data(), sizeof(prefix));
  if (prefix.layers == 0 || prefix.layers > HiddenSamples::kMaxLayers) {
    reader.refuse("the number of their layers");
  }
  if (!(prefix.nearest > 0 && prefix.nearest < 1e15f)) {
    reader.refuse("how near they are");
  }
  const BlockAtlas atlas(projection, reader.take(prefix.layers * BlockAtlas::maskBytes(projection)));
  if (atlas.isEmpty()) {
    reader.refuse("there are none");
  }
  const auto color = reader.take(prefix.colorBytes);
  const auto level = reader.take(prefix.levelBytes);
  if (!reader.isAtEnd()) {
    reader.refuse("there is more than they say");
  }
  const Image<Rgb8> colors = codec.decode(std::as_bytes(color), atlas.size());
  const Image<uint16_t> levels = levelCodec().decode(std::as_bytes(level), atlas.size() / kCell);
  const glm::ivec2 size = HiddenSamples::levelSize(projection);
  HiddenSamples hidden;
  hidden.nearest = prefix.nearest;
  hidden.layers.assign(prefix.layers,
                       {Image<Rgb8>(projection.width, projection.height, Rgb8(0)), Image<uint16_t>(size.x, size.y)});
  atlas.forEach({projection.width, projection.height}, 1,
                [&](size_t layer, const glm::ivec2& at, const glm::ivec2& from) {
                  hidden.layers[layer].color(at.x, at.y) = colors(from.x, from.y);
                });
  atlas.forEach(size, kCell, [&](size_t layer, const glm::ivec2& at, const glm::ivec2& from) {
    hidden.layers[layer].level(at.x, at.y) = levels(from.x, from.y);
  });
  return hidden;
}

}  // namespace ocelli
