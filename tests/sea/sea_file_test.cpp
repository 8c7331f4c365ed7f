// Seas that are built, read, stopped in between, and damaged.
#include "oc_core/sea/sea_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"
#include "oc_core/base/random.h"
#include "oc_core/sea/sea_build.h"
#include "oc_core/sea/sea_folder.h"
#include "oc_core/sea/sea_summary.h"
#include "oc_core/sea/sea_writer.h"
#include "tests/base/full_disk.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea/made_sea.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;

using test::fileBytes;
using test::gridPoses;
using test::meanDifference;
using test::RoomImages;
using test::roomProxy;
using test::settingsOf;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class SeaFileTest : public testing::Test {
 protected:
  fs::path build(const std::string& name, const SeaSettings& settings, bool startOver = false) const {
    buildSea(images_, roomProxy(), settings, folder_ / name, startOver);
    return folder_ / name;
  }

  TemporaryFolder folder_;
  RoomImages images_{gridPoses(5, 4, 0.15)};
};

TEST_F(SeaFileTest, GivesEveryImageInEachWay) {
  for (const SeaWay way : allSeaWays()) {
    SeaSettings settings = settingsOf(images_, way);
    settings.spacing = 2;
    const SeaFile sea(build("room.sea", settings));
    EXPECT_EQ(sea.count(), 20u);
    EXPECT_EQ(sea.settings(), settings);
    EXPECT_EQ(sea.names(), images_.names());
    uint32_t most = 0;
    for (uint32_t i = 0; i < sea.count(); ++i) {
      EXPECT_EQ(sea.pose(i), images_.poses()[i]);
      // Codecs without loss: all that is lost is the halving of residuals.
      EXPECT_LT(meanDifference(sea.image(i), images_.image(i)), 0.5) << nameOf(way) << " " << i;
      most = std::max(most, sea.stored(i).additions);
    }
    EXPECT_EQ(most == 1, way == SeaWay::kDirect) << nameOf(way);
    sea.verify(true);
  }
}

Image<Rgb8> decodedJpeg(const Image<Rgb8>& image, double quality) {
  const ColorCodec* codec = findColorCodec("jpeg");
  return codec->decode(codec->encode(image, quality), {image.width(), image.height()});
}

TEST_F(SeaFileTest, LossyCodecsTakeFewBytesOfThePNodes) {
  SeaSettings settings = settingsOf(images_);
  settings.iCodec = settings.pCodec = "jpeg";
  settings.iQuality = 75;
  settings.pQuality = 65;
  if (findColorCodec("jpeg") == nullptr) {
    GTEST_SKIP() << "built without libjpeg";
  }
  const SeaFile sea(build("room.sea", settings));
  const SeaSummary summary = summaryOf(sea);
  EXPECT_EQ(summary.inner, 1u);
  // Without what every JPEG begins with.
  const auto blank = static_cast<double>(findColorCodec("jpeg")->encode(Image<Rgb8>(64, 64, Rgb8(128)), 75).size());
  const double inner = static_cast<double>(summary.innerBytes) - blank;
  EXPECT_LT(static_cast<double>(summary.residualBytes) / 19 - blank, inner / 2) << "residuals are smaller than images";
  EXPECT_NEAR(summary.spacing, 0.15, 1e-9);
  for (uint32_t i = 0; i < sea.count(); ++i) {
    const Image<Rgb8> image = images_.image(i);
    const Image<Rgb8> alone = decodedJpeg(image, settings.iQuality);
    EXPECT_LT(meanDifference(sea.image(i), image), 1.3 * meanDifference(alone, image)) << i;
  }
}

TEST_F(SeaFileTest, HasTheSameBytesWithAnyNumberOfThreads) {
  setThreadCount(1);
  const std::string alone = fileBytes(build("one.sea", settingsOf(images_, SeaWay::kIndirect)));
  setThreadCount(0);
  EXPECT_EQ(fileBytes(build("many.sea", settingsOf(images_, SeaWay::kIndirect))), alone);
}

TEST_F(SeaFileTest, ABuildThatWasStoppedGoesOn) {
  const std::string whole = fileBytes(build("whole.sea", settingsOf(images_)));
  // What a killed build leaves: the records so far, the last of them cut off anywhere, and a header that says so.
  std::string stopped = whole;
  const sea::Header unfinished = sea::sealed(sea::Header{});
  std::memcpy(stopped.data(), &unfinished, sizeof(unfinished));
  for (const double share : {0.1, 0.35, 0.5, 0.77, 0.99}) {
    const size_t bytes = static_cast<size_t>(share * static_cast<double>(whole.size()));
    folder_.write("again.sea.partial", stopped.substr(0, bytes));
    const SeaBuildReport report = buildSea(images_, roomProxy(), settingsOf(images_), folder_ / "again.sea");
    EXPECT_TRUE(fileBytes(folder_ / "again.sea") == whole) << share;
    EXPECT_EQ(report.resumed > 0, share > 0.3) << share;
    EXPECT_FALSE(fs::exists(folder_ / "again.sea.partial"));
  }
}

TEST_F(SeaFileTest, WhatIsLeftOfAnotherBuildIsNeitherTakenNorRemoved) {
  const std::string whole = fileBytes(build("whole.sea", settingsOf(images_)));
  std::string stopped = whole.substr(0, whole.size() / 2);
  const sea::Header unfinished = sea::sealed(sea::Header{});
  std::memcpy(stopped.data(), &unfinished, sizeof(unfinished));
  const fs::path partial = folder_.write("other.sea.partial", stopped);
  SeaSettings other = settingsOf(images_);
  other.spacing = 3;
  EXPECT_THAT([&] { build("other.sea", other); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("other.sea.partial"), HasSubstr("--start-over"))));
  EXPECT_EQ(fileBytes(partial), stopped);
  build("other.sea", other, true);
  EXPECT_EQ(SeaFile(folder_ / "other.sea").settings().spacing, 3);
}

TEST_F(SeaFileTest, OneBuildWritesAFileAtATime) {
  const SeaSettings settings = settingsOf(images_);
  const SeaPreamble preamble{jsonText(settings), "", images_.poses(), {}};
  const SeaWriter first(folder_ / "busy.sea", preamble);
  EXPECT_THAT([&] { SeaWriter(folder_ / "busy.sea", preamble); }, ThrowsMessage<WorkError>(HasSubstr("another")));
}

TEST_F(SeaFileTest, RefusesWhatIsNoneOrNotComplete) {
  EXPECT_THAT([&] { SeaFile(folder_.write("text.sea", "what is this")); },
              ThrowsMessage<InputError>(HasSubstr("no sea")));
  EXPECT_THAT([&] { SeaFile(folder_ / "none.sea"); }, ThrowsMessage<InputError>(HasSubstr("none.sea")));
  std::string bytes = fileBytes(build("whole.sea", settingsOf(images_)));
  const sea::Header unfinished = sea::sealed(sea::Header{});
  std::memcpy(bytes.data(), &unfinished, sizeof(unfinished));
  EXPECT_THAT([&] { SeaFile(folder_.write("half.sea", bytes)); }, ThrowsMessage<InputError>(HasSubstr("not complete")));
  sea::Header newer;
  newer.version = 2;
  newer = sea::sealed(newer);
  std::memcpy(bytes.data(), &newer, sizeof(newer));
  EXPECT_THAT([&] { SeaFile(folder_.write("new.sea", bytes)); }, ThrowsMessage<InputError>(HasSubstr("version 2")));
}

TEST_F(SeaFileTest, EveryFlippedBitIsFound) {
  const std::string whole = fileBytes(build("whole.sea", settingsOf(images_)));
  const fs::path path = folder_.write("flipped.sea", whole);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  Random random(10000);
  constexpr int kFlips = 10000;
  for (int i = 0; i < kFlips; ++i) {
    const size_t at = random.below(whole.size());
    const char flipped = static_cast<char>(whole[at] ^ (1 << random.below(8)));
    const auto put = [&](char byte) {
      file.seekp(static_cast<std::streamoff>(at));
      file.put(byte);
      file.flush();
    };
    put(flipped);
    EXPECT_THROW(SeaFile(path).verify(false), InputError) << "byte " << at;
    put(whole[at]);
  }
  SeaFile(path).verify(true);
}

TEST_F(SeaFileTest, DamagedImagesDoNotTakeTheOthersAlong) {
  std::string bytes = fileBytes(build("whole.sea", settingsOf(images_)));
  // The last image record: a few bytes before the index.
  const SeaFile whole(folder_ / "whole.sea");
  sea::Header header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  bytes[header.indexOffset - sizeof(sea::RecordHeader) - 20] ^= 1;
  const SeaFile sea(folder_.write("damaged.sea", bytes));
  int damaged = 0;
  for (uint32_t i = 0; i < sea.count(); ++i) {
    try {
      EXPECT_EQ(sea.image(i), whole.image(i));
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("damaged.sea"), HasSubstr("image " + std::to_string(i))));
      ++damaged;
    }
  }
  EXPECT_EQ(damaged, 1);
}

TEST_F(SeaFileTest, ReadsNoMoreThanItNeeds) {
  const SeaFile sea(build("room.sea", settingsOf(images_)));
  for (uint32_t i = 0; i < sea.count(); ++i) {
    const SeaFile::Stored stored = sea.stored(i);
    const bool isInner = stored.reference == sea::kNoReference;
    const uint64_t codecs = stored.bytes + (isInner ? 0 : sea.stored(stored.reference).bytes);
    const uint64_t each = sizeof(sea::ImagePrefix) + sizeof(sea::IndexEntry) + sizeof(sea::PoseEntry);
    EXPECT_EQ(sea.bytesToRead(i), codecs + each * (isInner ? 1 : 2));
  }
}

TEST_F(SeaFileTest, AFullDiskIsNamedAndWhatWasBuiltStays) {
  const std::string whole = fileBytes(build("whole.sea", settingsOf(images_)));
  {
    const test::FileSizeLimit limit(whole.size() * 2 / 3);
    EXPECT_THAT([&] { build("full.sea", settingsOf(images_)); },
                ThrowsMessage<WorkError>(AllOf(HasSubstr("full.sea.partial"), HasSubstr("free some space"))));
  }
  EXPECT_FALSE(fs::exists(folder_ / "full.sea"));
  const SeaBuildReport report = buildSea(images_, roomProxy(), settingsOf(images_), folder_ / "full.sea");
  EXPECT_GT(report.resumed, 5u);
  EXPECT_TRUE(fileBytes(folder_ / "full.sea") == whole);
  EXPECT_THAT([&] { buildSea(images_, roomProxy(), settingsOf(images_), "/nowhere/at/all.sea"); },
              ThrowsMessage<WorkError>(HasSubstr("/nowhere/at/all.sea.partial")));
}

TEST_F(SeaFileTest, ViewsFromBetweenAreAsTheyWouldBeSeen) {
  const SeaFile sea(build("room.sea", settingsOf(images_)));
  const SeaPose between{{0.04, 0, 0.02}, glm::angleAxis(0.4, glm::dvec3(0, 1, 0))};
  EXPECT_LT(meanDifference(sea.view(between), images_.seenFrom(between)), 4);
  // At the place of an image it is that image.
  EXPECT_LT(meanDifference(sea.view(sea.pose(7)), sea.image(7)), 0.5);
}

TEST_F(SeaFileTest, WritesItsImagesAndTheirPlaces) {
  const SeaFile sea(build("room.sea", settingsOf(images_)));
  writeSeaFolder(sea, folder_ / "out");
  EXPECT_EQ(readPng(folder_ / "out/image3.png"), sea.image(3));
  EXPECT_THAT(fileBytes(folder_ / "out/positions.csv"),
              AllOf(HasSubstr("file,x,y,z,qw"), HasSubstr("image3.png,0.15,0,-0.22")));
  EXPECT_TRUE(fs::exists(folder_ / "out/proxy.ply"));
}

}  // namespace
}  // namespace ocelli
