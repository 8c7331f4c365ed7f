#include "oc_core/image/exr_writer.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>

#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

/// A pixel with more in it than is written.
struct Sample {
  float depth = 0;
  std::array<float, 2> unwritten{-7, -7};
  uint32_t identity = 0;
};

std::vector<Sample> samples(int count) {
  std::vector<Sample> result(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    result[static_cast<size_t>(i)].depth = 0.1f * static_cast<float>(i) - 1;
    result[static_cast<size_t>(i)].identity = 0xffffffffu - 3 * static_cast<uint32_t>(i);
  }
  return result;
}

ExrPart partOf(const std::string& name, const std::vector<Sample>& pixels, int width, int height) {
  return {name,
          width,
          height,
          {{"Z", &pixels[0].depth, sizeof(Sample)}, {"object", &pixels[0].identity, sizeof(Sample), true}},
          "about " + name};
}

/// One channel of a part, rows after each other, as OpenEXR reads it.
template <class T>
std::vector<T> channel(Imf::InputPart& part, const char* name, Imf::PixelType type) {
  const Imath::Box2i window = part.header().dataWindow();
  const size_t width = static_cast<size_t>(window.max.x) + 1;
  std::vector<T> values(width * (static_cast<size_t>(window.max.y) + 1));
  Imf::FrameBuffer buffer;
  buffer.insert(name, Imf::Slice(type, reinterpret_cast<char*>(values.data()), sizeof(T), sizeof(T) * width));
  part.setFrameBuffer(buffer);
  part.readPixels(window.min.y, window.max.y);
  return values;
}

void expectPart(Imf::MultiPartInputFile& file, int index, const std::string& name, const std::vector<Sample>& pixels,
                int width, int height) {
  Imf::InputPart part(file, index);
  const Imf::Header& header = part.header();
  EXPECT_EQ(header.name(), name);
  EXPECT_EQ(header.dataWindow(), Imath::Box2i({0, 0}, {width - 1, height - 1}));
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>(kExrDescription).value(), "about " + name);
  ASSERT_NE(header.channels().findChannel("Z"), nullptr);
  ASSERT_NE(header.channels().findChannel("object"), nullptr);
  EXPECT_EQ(header.channels().findChannel("Z")->type, Imf::FLOAT);
  EXPECT_EQ(header.channels().findChannel("object")->type, Imf::UINT);
  const auto depths = channel<float>(part, "Z", Imf::FLOAT);
  const auto identities = channel<uint32_t>(part, "object", Imf::UINT);
  ASSERT_EQ(depths.size(), pixels.size());
  for (size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_EQ(depths[i], pixels[i].depth) << name << " " << i;
    EXPECT_EQ(identities[i], pixels[i].identity) << name << " " << i;
  }
}

TEST(ExrWriter, partsOfDifferentSizeReadBack) {
  const test::TemporaryFolder folder;
  const std::vector<Sample> wide = samples(7 * 3);
  const std::vector<Sample> tall = samples(2 * 40);  // more rows than a block of ZIP compression
  const auto path = folder.write("two.exr", exrBytes({partOf("wide", wide, 7, 3), partOf("tall", tall, 2, 40)}));
  Imf::MultiPartInputFile file(path.c_str());
  ASSERT_EQ(file.parts(), 2);
  expectPart(file, 0, "wide", wide, 7, 3);
  expectPart(file, 1, "tall", tall, 2, 40);
  // The display window, which parts must share, holds both.
  for (const int i : {0, 1}) {
    EXPECT_EQ(file.header(i).displayWindow(), Imath::Box2i({0, 0}, {6, 39}));
  }
}

TEST(ExrWriter, numbersThatAreNoneReadBack) {
  const test::TemporaryFolder folder;
  const std::vector<float> values{std::numeric_limits<float>::infinity(), -0.0f, 1e-42f,
                                  std::numeric_limits<float>::quiet_NaN()};
  const auto path =
      folder.write("one.exr", exrBytes({{"image", 4, 1, {{"Z", values.data(), sizeof(float)}}, std::string()}}));
  Imf::MultiPartInputFile file(path.c_str());
  ASSERT_EQ(file.parts(), 1);
  Imf::InputPart part(file, 0);
  const auto back = channel<float>(part, "Z", Imf::FLOAT);
  EXPECT_EQ(back[0], values[0]);
  EXPECT_TRUE(std::signbit(back[1]));
  EXPECT_EQ(back[2], values[2]);
  EXPECT_TRUE(std::isnan(back[3]));
}

TEST(ExrWriter, theSameImageGivesTheSameBytes) {
  const std::vector<Sample> pixels = samples(6);
  const ExrPart part = partOf("image", pixels, 3, 2);
  EXPECT_EQ(exrBytes({part}), exrBytes({part}));
  EXPECT_NE(exrBytes({part}), exrBytes({partOf("image", pixels, 2, 3)}));
}

TEST(ExrWriter, partsNeedNamesOfTheirOwn) {
  const std::vector<Sample> pixels = samples(6);
  EXPECT_THROW(exrBytes({partOf("image", pixels, 3, 2), partOf("image", pixels, 2, 3)}), std::exception);
}

TEST(ExrWriterDeathTest, emptyImagesAreBugs) {
  const std::vector<Sample> pixels = samples(6);
  EXPECT_DEATH(exrBytes({partOf("image", pixels, 0, 2)}), "an empty image has no EXR form");
  EXPECT_DEATH(exrBytes({partOf("image", pixels, 3, -1)}), "an empty image has no EXR form");
  EXPECT_DEATH(exrBytes({}), "an EXR file holds an image at least");
}

}  // namespace
}  // namespace ocelli
