// What decoders make of bytes that are no image: an InputError, or an image of the size that was asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <span>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/random_numbers.h"
#include "oc_core/image_codecs/image_codec.h"
#include "tests/image_codecs/coded_samples.h"

namespace ocelli {
namespace {

using namespace test;
using Bytes = std::vector<std::byte>;

constexpr glm::ivec2 kSize{61, 43};

/// A codec of either kind, with its bytes for an image.
struct HostileCase {
  std::string name;
  Bytes whole;
  Bytes ofAnotherSize;
  std::function<glm::ivec2(std::span<const std::byte>, glm::ivec2)> decode;  ///< gives the size
};

std::vector<HostileCase> allCases() {
  std::vector<HostileCase> cases;
  for (const ColorCodec& codec : colorCodecs()) {
    cases.push_back({std::string("color_") + codec.name, codec.encode(coloredDisc(kSize.x, kSize.y), 80),
                     codec.encode(coloredDisc(kSize.x + 1, kSize.y), 80),
                     [&codec](std::span<const std::byte> bytes, glm::ivec2 size) {
                       const Image<Rgb8> image = codec.decode(bytes, size);
                       return glm::ivec2(image.width(), image.height());
                     }});
  }
  for (const DepthCodec& codec : depthCodecs()) {
    cases.push_back({std::string("depth_") + codec.name, codec.encode(depthOfDisc(kSize.x, kSize.y)),
                     codec.encode(depthOfDisc(kSize.x + 1, kSize.y)),
                     [&codec](std::span<const std::byte> bytes, glm::ivec2 size) {
                       const Image<uint16_t> image = codec.decode(bytes, size);
                       return glm::ivec2(image.width(), image.height());
                     }});
  }
  return cases;
}

class HostileBytes : public testing::TestWithParam<HostileCase> {
 protected:
  /// Whether it was taken for an image. Anything but an InputError fails the test.
  static bool isTaken(std::span<const std::byte> bytes, glm::ivec2 size = kSize) {
    try {
      EXPECT_EQ(GetParam().decode(bytes, size), size);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }
};

INSTANTIATE_TEST_SUITE_P(All, HostileBytes, testing::ValuesIn(allCases()),
                         [](const auto& each) { return each.param.name; });

TEST_P(HostileBytes, TheWholeIsTaken) {
  EXPECT_TRUE(isTaken(GetParam().whole));
}

TEST_P(HostileBytes, TruncatedOnesAreRefused) {
  const std::span<const std::byte> whole = GetParam().whole;
  // The end of a format may hold no pixels: the last eighth need not be missed, all before must.
  for (size_t size = 0; size < whole.size(); size += 1 + whole.size() / 200) {
    const bool taken = isTaken(whole.first(size));
    EXPECT_TRUE(!taken || size > whole.size() * 7 / 8) << size << " of " << whole.size() << " bytes";
  }
}

TEST_P(HostileBytes, FlippedOnesDoNoHarm) {
  RandomNumbers random(11);
  for (int round = 0; round < 400; ++round) {
    Bytes bytes = GetParam().whole;
    for (uint64_t flips = 1 + random.below(4); flips > 0; --flips) {
      bytes[random.below(bytes.size())] ^= std::byte{1} << random.below(8);
    }
    isTaken(bytes);
  }
}

TEST_P(HostileBytes, NoiseIsRefused) {
  RandomNumbers random(12);
  for (int round = 0; round < 100; ++round) {
    Bytes bytes(random.below(300));
    for (std::byte& each : bytes) {
      each = static_cast<std::byte>(random.bits());
    }
    EXPECT_FALSE(isTaken(bytes));
  }
}

TEST_P(HostileBytes, OtherSizesAreRefused) {
  EXPECT_FALSE(isTaken(GetParam().ofAnotherSize));
  for (const glm::ivec2& size : {glm::ivec2(0, 5), glm::ivec2(-1, -1), glm::ivec2(kMaxCodedSide + 1, 1),
                                 glm::ivec2(kMaxCodedSide, kMaxCodedSide), glm::ivec2(kSize.y, kSize.x + 1)}) {
    EXPECT_FALSE(isTaken(GetParam().whole, size));
  }
}

/// A zlib stream of so many zeros.
Bytes deflatedZeros(size_t count) {
  const Bytes zeros(count);
  Bytes bytes(compressBound(count));
  uLongf size = bytes.size();
  compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(zeros.data()), count, 9);
  bytes.resize(size);
  return bytes;
}

TEST(DeflateBytes, ThatGrowAThousandfoldAreRefusedWithoutMakingThem) {
  constexpr size_t kZeros = size_t{64} << 20;
  const Bytes bomb = deflatedZeros(kZeros);
  EXPECT_LT(bomb.size(), kZeros / 900);
  EXPECT_THROW(findDepthCodec("deflate")->decode(bomb, kSize), InputError);
}

TEST(DeflateBytes, WithMoreBehindThemAreRefused) {
  Bytes bytes = findDepthCodec("deflate")->encode(depthOfDisc(kSize.x, kSize.y));
  bytes.push_back(std::byte{0});
  EXPECT_THROW(findDepthCodec("deflate")->decode(bytes, kSize), InputError);
}

/// A box of a JPEG XL container.
Bytes jxlBox(uint32_t size, std::string_view type, std::span<const std::byte> content) {
  Bytes box;
  for (const int shift : {24, 16, 8, 0}) {
    box.push_back(static_cast<std::byte>(size >> shift));
  }
  const auto letters = std::as_bytes(std::span(type));
  box.insert(box.end(), letters.begin(), letters.end());
  box.insert(box.end(), content.begin(), content.end());
  return box;
}

TEST(JxlBytes, OfAContainerAreTakenInOnePiece) {
  const ColorCodec* codec = findColorCodec("jxl");
  if (codec == nullptr) {
    GTEST_SKIP() << "this build lacks it";
  }
  const Image<Rgb8> disc = coloredDisc(kSize.x, kSize.y);
  const Bytes stream = codec->encode(disc, 100);
  const auto size = static_cast<uint32_t>(stream.size()) + 8;
  EXPECT_EQ(codec->decode(jxlBox(0, "jxlc", stream), kSize), disc);
  EXPECT_EQ(codec->decode(jxlBox(size, "jxlc", stream), kSize), disc);
  for (const Bytes& refused : {jxlBox(size + 1, "jxlc", stream), jxlBox(size - 1, "jxlc", stream),
                               jxlBox(7, "jxlc", stream), jxlBox(0, "jxlp", stream), jxlBox(0, "Exif", stream),
                               jxlBox(8, "jxlc", {}), jxlBox(8, "jxll", {}), jxlBox(0, "jxll", {})}) {
    EXPECT_THROW(codec->decode(refused, kSize), InputError);
  }
}

/// hidden_frame.jxl repeats a letter, which is in a frame of its own (libjxl 0.7, lossless, with patches). A
/// hidden frame may be of any size, and libjxl decodes it before it tells of anything.
TEST(JxlBytes, WithAHiddenFrameAreRefused) {
  const ColorCodec* codec = findColorCodec("jxl");
  if (codec == nullptr) {
    GTEST_SKIP() << "this build lacks it";
  }
  const std::string file = readFile(std::filesystem::path(OCELLI_HOSTILE_FOLDER) / "hidden_frame.jxl");
  try {
    codec->decode(std::as_bytes(std::span(file)), {256, 160});
    ADD_FAILURE() << "it was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("hidden frame"));
  }
}

/// PNG says its size in bytes 16 to 23, followed by a checksum: one for the size of another image comes from its PNG.
TEST(PngBytes, OfAHugeSizeAreRefusedByTheirHeader) {
  Bytes bytes = findColorCodec("png")->encode(coloredDisc(kSize.x, kSize.y), 0);
  bytes[16] = bytes[20] = std::byte{0x7f};
  const auto checksum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data() + 12), 17);
  for (size_t i = 0; i < 4; ++i) {
    bytes[29 + i] = static_cast<std::byte>(checksum >> (24 - 8 * i));
  }
  EXPECT_THROW(findColorCodec("png")->decode(bytes, kSize), InputError);
}

}  // namespace
}  // namespace ocelli
