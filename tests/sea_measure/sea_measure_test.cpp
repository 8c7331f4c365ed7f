// Seas measured, against what the parts of a measurement say one by one.
#include "oc_core/sea_measure/sea_measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "oc_core/evaluation/flip.h"
#include "oc_core/evaluation/image_quality.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote_measure/video_stream.h"
#include "oc_core/sea/sea_build.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea/made_sea.h"

namespace ocelli {
namespace {

using test::gridPoses;
using test::RoomImages;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class SeaMeasure : public testing::Test {
 protected:
  SeaMeasure() {
    SeaSettings settings = test::settingsOf(images_);
    settings.iCodec = settings.pCodec = codec();
    settings.iQuality = settings.pQuality = 40;
    buildSea(images_, test::roomProxy(), settings, folder_ / "room.sea");
    sea_ = std::make_unique<SeaFile>(folder_ / "room.sea");
  }
  static const char* codec() { return findColorCodec("jpeg") != nullptr ? "jpeg" : "png"; }

  TemporaryFolder folder_;
  RoomImages images_{gridPoses(4, 2, 0.15), {.width = 96, .height = 64}};
  std::unique_ptr<SeaFile> sea_;
};

TEST_F(SeaMeasure, ErrorsAreThoseOfTheImages) {
  const SeaMeasureResult result = measureSea(*sea_, images_, {.images = 8, .timed = 3});
  ASSERT_EQ(result.errors.images, 8u);
  double flips = 0;
  double most = 0;
  double ssims = 0;
  for (uint32_t i = 0; i < 8; ++i) {
    const double each = flip(images_.image(i), sea_->image(i));
    flips += each / 8;
    most = std::max(most, each);
    ssims += ssim(images_.image(i), sea_->image(i)) / 8;
  }
  EXPECT_NEAR(result.errors.flip, flips, 1e-12);
  EXPECT_NEAR(result.errors.mostFlip, most, 1e-12);
  EXPECT_NEAR(result.errors.ssim, ssims, 1e-12);
  EXPECT_NEAR(result.ratio, 3.0 * 96 * 64 * 8 / static_cast<double>(sea_->fileBytes()), 1e-9);
  EXPECT_GT(result.imagesPerSecond, 0);
  EXPECT_GT(result.secondsPerImage, 0);
}

TEST_F(SeaMeasure, ACodecAloneTakesWhatTheSameErrorCosts) {
  if (findColorCodec("jpeg") == nullptr) {
    GTEST_SKIP() << "built without libjpeg";
  }
  const SeaMeasureResult result = measureSea(*sea_, images_, {.images = 8, .timed = 1, .peers = {"jpeg"}});
  ASSERT_EQ(result.peers.size(), 1u);
  const SeaPeerResult& jpeg = result.peers[0];
  EXPECT_EQ(jpeg.missing, "");
  EXPECT_LE(jpeg.flip, result.errors.flip);
  EXPECT_GT(jpeg.flip, 0.7 * result.errors.flip) << "the lowest quality that does";
  EXPECT_GT(jpeg.ssim, 0);
  double bytes = 0;
  for (uint32_t i = 0; i < 8; ++i) {
    bytes += static_cast<double>(findColorCodec("jpeg")->encode(images_.image(i), jpeg.quality).size()) / 8;
  }
  EXPECT_NEAR(jpeg.bytesPerImage, bytes, 1e-6);
}

TEST_F(SeaMeasure, VideoIsMeasuredWhereFfmpegIs) {
  const StreamEncoder encoder(filmKinds()[0]);
  if (!encoder.isThere()) {
    GTEST_SKIP() << encoder.missing();
  }
  const SeaMeasureResult result = measureSea(*sea_, images_, {.images = 4, .timed = 1, .run = 8, .peers = {"x265"}});
  const SeaPeerResult& film = result.peers[0];
  ASSERT_EQ(film.missing, "");
  EXPECT_GT(film.bytesPerImage, 20);
  EXPECT_LT(film.bytesPerImage, 3.0 * 96 * 64);
  EXPECT_GT(film.secondsPerImage, 0);
}

TEST_F(SeaMeasure, RefusesAnotherSourceAndUnknownPeers) {
  const RoomImages fewer(gridPoses(3, 2, 0.15), {.width = 96, .height = 64});
  EXPECT_THAT([&] { measureSea(*sea_, fewer, {}); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("8 images"), HasSubstr("6 of"))));
  EXPECT_THAT([&] { measureSea(*sea_, images_, {.peers = {"mpeg2"}}); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("mpeg2"), HasSubstr("av1"))));
}

}  // namespace
}  // namespace ocelli
