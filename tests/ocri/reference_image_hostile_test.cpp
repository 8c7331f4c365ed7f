// Damaged and hostile EXR files: an InputError or an image, never anything else.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>

#include "oc_core/base/error.h"
#include "oc_core/ocri/reference_image_file.h"
#include "oc_core/ocri/union_mesh.h"
#include "tests/base/temporary_folder.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli {
namespace {

using test::fileBytes;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr int kSide = 24;
constexpr const char* kAttributeText = R"({"format": 1, "camera": "di", "view": {}})";

/// The message of the error, empty where the bytes are an image; that one can be meshed without harm.
std::string errorOf(std::string_view bytes) {
  try {
    const Mesh mesh = unionMesh(referenceImagesFromBytes(bytes, "bytes"));
    for (const glm::uvec3& t : mesh.triangles) {
      EXPECT_LT(std::max({t.x, t.y, t.z}), mesh.positions.size());
    }
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string goodBytes() {
  const TemporaryFolder folder;
  ReferenceImage image = buildDepthImage(PinholeCamera(View{}, kSide, kSide), test::boxBeforeWall());
  image.triangleBound = 4000;
  writeReferenceImages(folder / "image.exr", {image});
  return fileBytes(folder / "image.exr");
}

/// A reference image as OpenEXR writes it from values of our own.
struct Forged {
  Imf::Header header{kSide, kSide};
  std::shared_ptr<const Imf::Attribute> attribute = std::make_shared<Imf::StringAttribute>(kAttributeText);
  std::vector<float> values = std::vector<float>(static_cast<size_t>(kSide) * kSide, 10.0f);

  Forged() {
    for (const char* name : {"R", "G", "B", "Z", "offset.u", "offset.v"}) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    }
  }

  std::string bytes() {
    const TemporaryFolder folder;
    const std::string path = folder / "forged.exr";
    if (attribute) {
      header.insert("ocelli", *attribute);
    }
    {
      Imf::OutputFile file(path.c_str(), header);
      Imf::FrameBuffer buffer;
      // The same values for every channel, whatever its type: 4 bytes a pixel. OpenEXR wants the address of (0, 0).
      float* origin = values.data() - header.dataWindow().min.y * kSide;
      for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        buffer.insert(channel.name(), Imf::Slice(channel.channel().type, reinterpret_cast<char*>(origin), 4, 4 * kSide,
                                                 channel.channel().xSampling, channel.channel().ySampling));
      }
      file.setFrameBuffer(buffer);
      file.writePixels(kSide);
    }
    return fileBytes(path);
  }
};

std::string forgedError(const std::function<void(Forged&)>& change) {
  Forged forged;
  change(forged);
  return errorOf(forged.bytes());
}

TEST(ReferenceImageHostile, theForgedFileItselfIsGood) {
  EXPECT_EQ(forgedError([](Forged&) {}), "");
}

std::string goodUnionBytes() {
  const TemporaryFolder folder;
  const ReferenceImage image = buildDepthImage(PinholeCamera(View{}, kSide, kSide), test::boxBeforeWall());
  writeReferenceImages(folder / "union.exr", {image, image});
  return fileBytes(folder / "union.exr");
}

class ReferenceImageHostileFiles : public ::testing::TestWithParam<bool> {
 protected:
  static std::string bytes() { return GetParam() ? goodUnionBytes() : goodBytes(); }
};
INSTANTIATE_TEST_SUITE_P(OneOrTwoParts, ReferenceImageHostileFiles, ::testing::Bool());

TEST_P(ReferenceImageHostileFiles, truncatedFilesAreRefused) {
  const std::string good = bytes();
  ASSERT_EQ(errorOf(good), "");
  for (size_t size = 0; size < good.size(); size += size < 600 ? 1 : 97) {
    EXPECT_NE(errorOf(std::string_view(good).substr(0, size)), "") << size;
  }
  EXPECT_NE(errorOf(std::string_view(good).substr(0, good.size() - 1)), "");
}

TEST_P(ReferenceImageHostileFiles, flippedBytesAreRefusedOrHarmless) {
  const std::string good = bytes();
  size_t refused = 0;
  for (size_t at = 0; at < good.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::string damaged = good;
      damaged[at] = static_cast<char>(damaged[at] ^ flip);
      refused += !errorOf(damaged).empty();
    }
  }
  EXPECT_GT(refused, good.size()) << "compressed data has a checksum, the header a syntax";
}

TEST(ReferenceImageHostile, everyChannelIsNeeded) {
  for (const std::string name : {"R", "G", "B", "Z", "offset.u", "offset.v"}) {
    const std::string error = forgedError([&](Forged& forged) {
      Imf::ChannelList others;
      for (auto channel = forged.header.channels().begin(); channel != forged.header.channels().end(); ++channel) {
        if (name != channel.name()) {
          others.insert(channel.name(), channel.channel());
        }
      }
      forged.header.channels() = others;
    });
    EXPECT_THAT(error, HasSubstr("channel " + name));
  }
}

TEST(ReferenceImageHostile, channelsMustBeFullSizeFloats) {
  EXPECT_THAT(forgedError([](Forged& f) { f.header.channels().insert("Z", Imf::Channel(Imf::HALF)); }),
              HasSubstr("channel Z"));
  EXPECT_THAT(forgedError([](Forged& f) { f.header.channels().insert("R", Imf::Channel(Imf::UINT)); }),
              HasSubstr("channel R"));
  EXPECT_THAT(forgedError([](Forged& f) { f.header.channels().insert("G", Imf::Channel(Imf::FLOAT, 2, 2)); }),
              HasSubstr("channel G"));
}

TEST(ReferenceImageHostile, attributeIsNeededAndChecked) {
  EXPECT_THAT(forgedError([](Forged& f) { f.attribute = nullptr; }), HasSubstr("ocelli"));
  EXPECT_THAT(forgedError([](Forged& f) { f.attribute = std::make_shared<Imf::IntAttribute>(1); }),
              HasSubstr("ocelli"));
  const auto errorWith = [](const char* text) {
    return forgedError([&](Forged& f) { f.attribute = std::make_shared<Imf::StringAttribute>(text); });
  };
  EXPECT_NE(errorWith(""), "");
  EXPECT_NE(errorWith("[]"), "");
  EXPECT_THAT(errorWith(R"({"camera": "di", "view": {}})"), HasSubstr("format"));
  EXPECT_THAT(errorWith(R"({"format": 2, "camera": "di", "view": {}})"), HasSubstr("format"));
  EXPECT_THAT(errorWith(R"({"format": 1, "view": {}})"), HasSubstr("camera"));
  EXPECT_THAT(errorWith(R"({"format": 1, "camera": "di"})"), HasSubstr("view"));
  EXPECT_THAT(errorWith(R"({"format": 1, "camera": "di", "view": {"eye": [0, 0, 0]}})"), HasSubstr("eye"));
  EXPECT_THAT(errorWith(R"({"format": 1, "camera": "di", "view": {}, "triangle_bound": -1})"),
              HasSubstr("triangle_bound"));
  EXPECT_THAT(errorWith(R"({"format": 1, "camera": "di", "view": {}, "extra": 0})"), HasSubstr("extra"));
  EXPECT_THAT(errorWith(R"({"format": 1, "camera": "di", "view": {}, "rows": "crooked"})"), HasSubstr("rows"));
  EXPECT_THAT(errorWith(R"({"format": 1, "camera": "di", "view": {}, "tile_side": 1})"), HasSubstr("tile_side"));
  EXPECT_THAT(errorWith(R"({"format": 1, "camera": "di", "view": {}, "pinhole_size": {"width": 9}})"),
              HasSubstr("height"));
  EXPECT_THAT(
      errorWith(R"({"format": 1, "camera": "di", "view": {}, "pinhole_size": {"width": 32768, "height": 32768}})"),
      HasSubstr("2^26"));
}

TEST(ReferenceImageHostile, valuesThatAreNoNumbersAreNamedByTheirPixel) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), -1.0f}) {
    EXPECT_THAT(forgedError([&](Forged& f) { f.values[3 * kSide + 7] = bad; }), HasSubstr("pixel (7, 3)"));
  }
}

TEST(ReferenceImageHostile, depthsOutOfTheViewAreHarmless) {
  for (const float odd : {1e9f, 1e-9f, 1e30f, 0.0f}) {
    EXPECT_EQ(forgedError([&](Forged& f) { std::fill_n(f.values.begin() + 100, 90, odd); }), "");
  }
}

TEST(ReferenceImageHostile, dataWindowMustStartAtTheOrigin) {
  EXPECT_THAT(forgedError([](Forged& f) {
                f.header.dataWindow().min.y = -2;
                f.header.dataWindow().max.y -= 2;
              }),
              HasSubstr("data window"));
}

// The bytes of max.x and max.y follow those of min.x and min.y behind the attribute's name, type and size.
std::string withDataWindow(std::string bytes, int32_t maxX, int32_t maxY) {
  const std::string name("dataWindow\0box2i\0\x10\0\0\0", 21);
  const size_t at = bytes.find(name);
  EXPECT_NE(at, std::string::npos);
  for (size_t i = 0; i < 4; ++i) {
    bytes[at + name.size() + 8 + i] = static_cast<char>(static_cast<uint32_t>(maxX) >> (8 * i));
    bytes[at + name.size() + 12 + i] = static_cast<char>(static_cast<uint32_t>(maxY) >> (8 * i));
  }
  return bytes;
}

TEST(ReferenceImageHostile, promisesOfHugeImagesTakeNoMemory) {
  const std::string good = goodBytes();
  ASSERT_EQ(errorOf(withDataWindow(good, kSide - 1, kSide - 1)), "");
  for (const auto& [x, y] : {std::pair(40000, 10),
                             {10, 40000},
                             {32767, 32767},
                             {2147483647, 2147483647},
                             {2147483647, 0},
                             {-5, 10},
                             {-2147483647, -2147483647}}) {
    EXPECT_THAT(errorOf(withDataWindow(good, x, y)), HasSubstr("data window")) << x << " " << y;
  }
  // 2^26 pixels are allowed; 1.6 GB for a file of a few kB are not.
  EXPECT_THAT(errorOf(withDataWindow(good, 32767, 2047)), HasSubstr("too short"));
}

}  // namespace
}  // namespace ocelli
