#include "oc_core/scene/import/image_decode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

Image<Rgb8> decode(const std::string& bytes, const MemoryNotice& notice = {}) {
  return decodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "test", notice);
}

std::string bigEndian(uint32_t number) {
  return {static_cast<char>(number >> 24U), static_cast<char>(number >> 16U), static_cast<char>(number >> 8U),
          static_cast<char>(number)};
}

/// The start of a PNG of this size, 8-bit RGB, with pixels that are missing.
std::string pngStart(uint32_t width, uint32_t height) {
  return std::string("\x89PNG\r\n\x1a\n", 8) + bigEndian(13) + "IHDR" + bigEndian(width) + bigEndian(height) +
         std::string("\x08\x02\0\0\0", 5) + "CRC?" + bigEndian(10) + "IDAT" + std::string(10, 'x');
}

TEST(DecodeImage, RejectsWhatIsNoImage) {
  EXPECT_THROW(decode(""), InputError);
  EXPECT_THROW(decode("\1\2\3\4"), InputError);
  EXPECT_THROW(readImage("/no/such/file.png"), InputError);
}

TEST(DecodeImage, RejectsHugeSizesBeforeItAsksForMemory) {
  uint64_t asked = 0;
  const MemoryNotice notice = [&](uint64_t bytes) { asked += bytes; };
  // stb_image itself refuses images of more than 2^30 bytes.
  EXPECT_THROW(decode(pngStart(0x7fffffff, 0x7fffffff), notice), InputError);
  EXPECT_THAT([&] { decode(pngStart(18000, 17000), notice); }, ThrowsMessage<InputError>(HasSubstr("2^28")));
  EXPECT_EQ(asked, 0u);
}

TEST(DecodeImage, TellsOfTheMemoryThatALargeImageNeeds) {
  uint64_t asked = 0;
  EXPECT_THROW(decode(pngStart(1000, 100), [&](uint64_t bytes) { asked += bytes; }), InputError) << "it is cut off";
  EXPECT_GE(asked, 100'000u * 2 * sizeof(Rgb8));
}

TEST(ReadImage, TakesRegularFilesAlone) {
  EXPECT_THAT([] { readImage("/dev/zero"); }, ThrowsMessage<InputError>(HasSubstr("no such texture file")));
  const TemporaryFolder folder;
  EXPECT_THROW(readImage(folder.path()), InputError);
  writePng(folder / "a.png", Image<Rgb8>(2, 1, Rgb8(1, 2, 3)));
  const Image<Rgb8> image = readImage(folder / "a.png");
  ASSERT_EQ(image.size(), 2u);
  EXPECT_EQ(image(1, 0), Rgb8(1, 2, 3));
}

}  // namespace
}  // namespace ocelli
