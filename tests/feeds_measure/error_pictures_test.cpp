#include "oc_core/feeds_measure/error_pictures.h"

#include <gtest/gtest.h>

#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

size_t changedPixels(const Image<Rgb8>& image, int from, int to, const Rgb8& ground) {
  size_t count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = from; x < to; ++x) {
      count += image(x, y) != ground;
    }
  }
  return count;
}

TEST(ErrorPictures, MarkTheWalkerInBothImages) {
  const Rgb8 ground(90);
  const Image<Rgb8> image(100, 80, ground);
  WalkerArea none = emptyAreas(1, 1)[0];
  WalkerArea body = none;
  body.add(0, 40, 30);
  body.add(0, 49, 59);
  const Image<Rgb8> neither = markedPair(image, none, image, none);
  EXPECT_EQ(neither.width(), 200);
  EXPECT_EQ(changedPixels(neither, 0, 200, ground), 0u);
  const Image<Rgb8> missing = markedPair(image, none, image, body);
  const size_t broken = changedPixels(missing, 0, 100, ground);
  const size_t whole = changedPixels(missing, 100, 200, ground);
  EXPECT_GT(broken, whole / 4);
  EXPECT_LT(broken, whole * 3 / 4);
  EXPECT_EQ(missing(145, 45), ground) << "the walker itself is not painted over";
  // At the rim of the image the frame is cut, and stays in its half.
  WalkerArea rim = none;
  rim.add(0, 99, 0);
  EXPECT_EQ(changedPixels(markedPair(image, rim, image, none), 100, 102, ground), 0u);
}

TEST(ErrorPictures, KeepsAFewOfEachKindAWhileApart) {
  const test::TemporaryFolder folder;
  ErrorPictures pictures(folder.path());
  const Image<Rgb8> image(8, 4, Rgb8(1));
  size_t kept = 0;
  for (double seconds = 0; seconds < 20; seconds += 0.1) {
    for (const WalkerFate fate : {WalkerFate::kRight, WalkerFate::kMissing, WalkerFate::kGhost}) {
      if (pictures.wants(fate, seconds)) {
        EXPECT_NE(fate, WalkerFate::kRight);
        pictures.add(fate, 1, seconds, image);
        ++kept;
      }
    }
  }
  EXPECT_EQ(kept, 6u);
  EXPECT_EQ(pictures.list().size(), kept);
  for (const ErrorPicture& picture : pictures.list()) {
    EXPECT_EQ(readPng(folder.path() / picture.file).width(), 8);
  }
}

}  // namespace
}  // namespace ocelli
