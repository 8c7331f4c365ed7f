// Recordings: `.svol` files of several frames, written and read while they grow.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "display_sim/frames/svol_file.h"
#include "display_sim/frames/svol_join.h"
#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/svol_summary.h"
#include "display_sim/frames/svol_writer.h"
#include "oc_core/base/error.h"
#include "tests/base/temporary_folder.h"
#include "tests/display_sim_observing/recorded_frames.h"
#include "tests/display_sim_slicing/test_files.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::recordedProfile;
using test::recordedTime;
using test::recordedVolume;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

void record(const std::filesystem::path& path, const DisplayProfile& profile, uint32_t frames, int framesPerKey = 4) {
  SvolWriter writer(path, profile, {.metadata = R"({"scene":"made up"})", .framesPerKey = framesPerKey});
  for (uint32_t k = 0; k < frames; ++k) {
    writer.append(recordedVolume(profile, k), recordedTime(k));
  }
  writer.finish();
}

TEST(SvolRecording, framesAreReadInAnyOrderAndSliceBySlice) {
  const TemporaryFolder folder;
  for (const int bits : {1, 3, 8}) {
    const DisplayProfile profile = recordedProfile(11, 19, 9, bits);
    record(folder / "a.svol", profile, 11);
    SvolReader reader(folder / "a.svol");
    ASSERT_EQ(reader.frames().size(), 11u);
    SvolPlayer player(reader);
    std::vector<uint8_t> planes(reader.layout().sliceBytes);
    for (const uint32_t k : {0, 1, 2, 3, 4, 5, 10, 9, 3, 3, 8, 2, 6}) {
      player.seek(k);
      const Volume expected = recordedVolume(profile, k);
      EXPECT_EQ(player.volume(), expected) << "frame " << k << ", " << bits << " bits";
      EXPECT_EQ(reader.frames()[k].timeMicroseconds, recordedTime(k));
      for (int i = 0; i < expected.slices(); ++i) {
        reader.readSlice(k, i, planes);
        EXPECT_TRUE(std::ranges::equal(planes, expected.slice(i))) << "frame " << k << ", slice " << i;
      }
    }
  }
}

TEST(SvolRecording, deltaFramesHoldTheSameAsWholeOnes) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(10, 64, 64, 1);
  record(folder / "deltas.svol", profile, 8, 8);
  record(folder / "keys.svol", profile, 8, 1);
  for (size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(readSvol(folder / "deltas.svol", k), readSvol(folder / "keys.svol", k));
  }
  EXPECT_LT(bytesOf(folder / "deltas.svol").size(), bytesOf(folder / "keys.svol").size());
}

TEST(SvolRecording, slicesAreKeptAsTheyChange) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 64, 64, 1);
  record(folder / "a.svol", profile, 6, 4);
  SvolReader reader(folder / "a.svol");
  using enum SvolSliceKind;
  const auto kinds = [&](size_t frame) {
    std::vector<SvolSliceKind> list;
    for (const svol::SliceEntry& slice : reader.readHead(frame).slices) {
      list.push_back(slice.kind);
    }
    return list;
  };
  EXPECT_THAT(kinds(0), ElementsAre(kDark, kWhole, kWhole, kWhole, kWhole));
  EXPECT_THAT(kinds(1), ElementsAre(kUnchanged, kUnchanged, kDelta, kWhole, kDark));
  EXPECT_THAT(kinds(2), ElementsAre(kUnchanged, kUnchanged, kDelta, kWhole, kWhole));
  EXPECT_THAT(kinds(4), ElementsAre(kDark, kWhole, kWhole, kWhole, kWhole)) << "the second key frame";
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(reader.frames()[k].key, k % 4 == 0);
    EXPECT_EQ(reader.keyFrameOf(k), k / 4 * 4);
  }
  const std::vector<SvolFrameSummary> frames = summarizeSvol(reader).frames;
  ASSERT_EQ(frames.size(), 6u);
  EXPECT_THAT(frames[1].slices, ElementsAre(1, 1, 1, 2));
  EXPECT_EQ(frames[1].bytes, reader.frames()[2].offset - reader.frames()[1].offset);
}

TEST(SvolRecording, thePlayerTellsWhichSlicesChanged) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 64, 64, 1);
  record(folder / "a.svol", profile, 7, 4);
  SvolReader reader(folder / "a.svol");
  SvolPlayer player(reader);
  player.seek(0);
  EXPECT_THAT(player.changed(), ElementsAre(1, 2, 3, 4));
  for (size_t k = 1; k < 7; ++k) {
    player.seek(k);
    EXPECT_THAT(player.changed(), ElementsAre(2, 3, 4)) << "to frame " << k << ", key frames included";
  }
  player.seek(6);
  EXPECT_THAT(player.changed(), ElementsAre());
  player.seek(0);
  EXPECT_THAT(player.changed(), ElementsAre(2, 3)) << "slice 4 is lit in even frames";
}

TEST(SvolRecording, framesAreFoundByTheirTime) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 8, 8, 1);
  {
    SvolWriter writer(folder / "a.svol", profile);
    for (const uint64_t time : {100, 200, 200, 500}) {
      writer.append(Volume(profile), time);
    }
    writer.finish();
  }
  const SvolReader reader(folder / "a.svol");
  EXPECT_EQ(reader.frameAt(0), 0u);
  EXPECT_EQ(reader.frameAt(199), 0u);
  EXPECT_EQ(reader.frameAt(200), 2u);
  EXPECT_EQ(reader.frameAt(499), 2u);
  EXPECT_EQ(reader.frameAt(1u << 30), 3u);
  EXPECT_EQ(reader.durationMicroseconds(), 400 + static_cast<uint64_t>(std::llround(1e6 / profile.refreshHertz())));
}

TEST(SvolRecording, aGrowingFileIsReadableAfterEveryFrameAndTheOthersAppearWhenFinished) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  SvolWriter growing(folder / "growing.svol", profile, {.growing = true});
  SvolWriter hidden(folder / "hidden.svol", profile);
  EXPECT_EQ(SvolReader(folder / "growing.svol").frames().size(), 0u);
  for (uint32_t k = 0; k < 3; ++k) {
    const Volume volume = recordedVolume(profile, k);
    growing.append(volume, recordedTime(k));
    hidden.append(volume, recordedTime(k));
    SvolReader reader(folder / "growing.svol");
    EXPECT_EQ(reader.ending(), SvolEnding::kUnfinished);
    ASSERT_EQ(reader.frames().size(), k + 1);
    EXPECT_EQ(readFrame(reader, k), volume);
    EXPECT_EQ(growing.bytes(), reader.fileBytes());
    EXPECT_FALSE(std::filesystem::exists(folder / "hidden.svol"));
  }
  growing.finish();
  hidden.finish();
  EXPECT_EQ(SvolReader(folder / "growing.svol").ending(), SvolEnding::kFinished);
  EXPECT_EQ(bytesOf(folder / "growing.svol"), bytesOf(folder / "hidden.svol"));
  EXPECT_THROW(growing.append(Volume(profile), recordedTime(3)), WorkError);
}

TEST(SvolRecording, anAbandonedGrowingFileStaysAndAnotherLeavesNothing) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  for (const bool growing : {true, false}) {
    SvolWriter writer(folder / (growing ? "growing.svol" : "hidden.svol"), profile, {.growing = growing});
    writer.append(Volume(profile), 0);
  }
  EXPECT_EQ(SvolReader(folder / "growing.svol").frames().size(), 1u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

/// Files of this process cannot grow beyond so many bytes while it lives: like a full disk.
class FullDisk {
 public:
  explicit FullDisk(size_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(SvolRecording, aFullDiskLeavesAllWholeFrames) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(20, 64, 64, 3);
  uint32_t whole = 0;
  {
    const FullDisk disk(300000);
    SvolWriter writer(folder / "a.svol", profile, {.growing = true});
    try {
      for (;; ++whole) {
        ASSERT_LT(whole, 1000u) << "the disk is not full";
        writer.append(recordedVolume(profile, whole), recordedTime(whole));
      }
    } catch (const WorkError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.svol"));
    }
    EXPECT_THROW(writer.finish(), WorkError);
  }
  SvolReader reader(folder / "a.svol");
  EXPECT_EQ(reader.ending(), SvolEnding::kUnfinished);
  ASSERT_EQ(reader.frames().size(), whole);
  ASSERT_GT(whole, 2u);
  verifySvol(reader);
  for (uint32_t k = 0; k < whole; ++k) {
    EXPECT_EQ(readFrame(reader, k), recordedVolume(profile, k));
  }
}

TEST(SvolRecording, volumesAndRecordingsAreJoined) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  record(folder / "a.svol", profile, 3);
  writeSvol(folder / "b.svol", recordedVolume(profile, 7));
  const JoinResult result =
      joinSvol({folder / "b.svol", folder / "a.svol", folder / "b.svol"}, folder / "c.svol", {.framesPerSecond = 10});
  EXPECT_EQ(result.frames, 5u);
  EXPECT_TRUE(result.incomplete.empty());
  SvolReader reader(folder / "c.svol");
  const uint32_t numbers[] = {7, 0, 1, 2, 7};
  const uint64_t times[] = {0, 100000, 100000 + recordedTime(1), 100000 + recordedTime(2), 200000 + recordedTime(2)};
  ASSERT_EQ(reader.frames().size(), 5u);
  for (size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(readFrame(reader, k), recordedVolume(profile, numbers[k])) << k;
    EXPECT_EQ(reader.frames()[k].timeMicroseconds, times[k]) << k;
  }
  EXPECT_EQ(reader.metadata(), "{}") << "that of the first";
}

TEST(SvolRecording, joiningTakesNoRateOutOfRange) {
  const TemporaryFolder folder;
  writeSvol(folder / "a.svol", Volume(recordedProfile(5, 17, 9, 1)));
  for (const double rate : {0.0, -1.0, 1e7, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(joinSvol({folder / "a.svol"}, folder / "b.svol", {.framesPerSecond = rate}), InputError) << rate;
    EXPECT_FALSE(std::filesystem::exists(folder / "b.svol"));
  }
}

TEST(SvolRecording, joiningStopsBeforeTimesRunOut) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  SvolWriter writer(folder / "a.svol", profile);
  writer.append(Volume(profile), 0);
  writer.append(Volume(profile), svol::kMaxMicroseconds);
  writer.finish();
  EXPECT_EQ(joinSvol({folder / "a.svol"}, folder / "b.svol").frames, 2u);
  EXPECT_THROW(joinSvol({folder / "a.svol", folder / "a.svol"}, folder / "c.svol"), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "c.svol"));
}

TEST(SvolRecording, joiningSalvagesOnlyWhenAsked) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  record(folder / "a.svol", profile, 6);
  const std::vector<uint8_t> bytes = bytesOf(folder / "a.svol");
  const std::vector<SvolFrame> frames = SvolReader(folder / "a.svol").frames();
  const auto expectFrames = [&](std::vector<uint8_t> file, size_t count) {
    folder.write("b.svol", std::string(file.begin(), file.end()));
    EXPECT_THROW(joinSvol({folder / "b.svol"}, folder / "c.svol"), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder / "c.svol"));
    const JoinResult result = joinSvol({folder / "b.svol"}, folder / "c.svol", {.salvage = true});
    EXPECT_THAT(result.incomplete, ElementsAre(folder / "b.svol"));
    SvolReader reader(folder / "c.svol");
    EXPECT_EQ(reader.ending(), SvolEnding::kFinished);
    verifySvol(reader);
    EXPECT_EQ(reader.frames().size(), count);
    std::filesystem::remove(folder / "c.svol");
  };
  expectFrames({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(frames[4].offset + 9)}, 4);
  std::vector<uint8_t> damaged = bytes;
  damaged[frames[3].offset - 1] ^= 1;
  expectFrames(damaged, 2);
  damaged = bytes;
  damaged.back() ^= 1;
  expectFrames(damaged, 6);
}

/// The message of the InputError that reading this frame throws; empty where it does not.
std::string problemOf(const std::filesystem::path& path, size_t frame) {
  try {
    readSvol(path, frame);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The bytes of a recording, and the same without its index and its end.
struct FileAndCut {
  std::string whole;
  std::string cut;
};

FileAndCut withAndWithoutIndex(std::vector<uint8_t> bytes, size_t frames) {
  const std::string whole(bytes.begin(), bytes.end());
  return {whole, whole.substr(0, whole.size() - svol::indexBytes(frames) - svol::kEndBytes)};
}

TEST(SvolRecording, framesBeforeADamagedOneAreReadWithAndWithoutTheIndex) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  record(folder / "a.svol", profile, 4);
  std::vector<uint8_t> bytes = bytesOf(folder / "a.svol");
  const std::vector<SvolFrame> places = SvolReader(folder / "a.svol").frames();
  bytes[places[3].offset + 8] ^= 1;  // its time
  const FileAndCut files = withAndWithoutIndex(bytes, 4);
  for (const std::string& file : {files.whole, files.cut}) {
    const std::filesystem::path path = folder.write("b.svol", file);
    for (uint32_t k = 0; k < 3; ++k) {
      EXPECT_EQ(readSvol(path, k), recordedVolume(profile, k)) << k;
    }
    EXPECT_THAT(problemOf(path, 3), AllOf(HasSubstr("frame 3: the checksum is wrong"), HasSubstr("--salvage")));
    SvolReader reader(path);
    const SvolSummary summary = summarizeSvol(reader);
    ASSERT_EQ(summary.frames.size(), 3u);
    EXPECT_EQ(summary.keyFrames, 1u);
    EXPECT_EQ(summary.litVoxels, recordedVolume(profile, 0).litVoxels());
    EXPECT_EQ(summary.durationMicroseconds,
              recordedTime(2) + static_cast<uint64_t>(std::llround(1e6 / profile.refreshHertz())));
    ASSERT_TRUE(summary.damage);
    EXPECT_EQ(summary.damage->what(), problemOf(path, 3));
    EXPECT_THROW(verifySvol(reader), InputError);
  }
}

TEST(SvolRecording, aDamagedPayloadIsToldTheSameWithAndWithoutTheIndex) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  for (const uint32_t frames : {1u, 3u}) {
    record(folder / "a.svol", profile, frames);
    const uint64_t place = SvolReader(folder / "a.svol").frames().back().offset;
    std::vector<uint8_t> bytes = bytesOf(folder / "a.svol");
    bytes[bytes.size() - svol::indexBytes(frames) - svol::kEndBytes - 1] ^= 1;
    const FileAndCut files = withAndWithoutIndex(bytes, frames);
    const std::string problem = problemOf(folder.write("b.svol", files.whole), frames - 1);
    EXPECT_THAT(problem, HasSubstr("the checksum is wrong (in the record at byte " + std::to_string(place) + ")"));
    EXPECT_EQ(problemOf(folder.write("b.svol", files.cut), frames - 1), problem);
    EXPECT_EQ(problem.find("--salvage") != std::string::npos, frames > 1) << "no frame is whole";
  }
}

TEST(SvolRecording, aFirstFrameThatIsDamagedOrCutLeavesNone) {
  const TemporaryFolder folder;
  const DisplayProfile profile = recordedProfile(5, 17, 9, 1);
  record(folder / "a.svol", profile, 1);
  std::vector<uint8_t> bytes = bytesOf(folder / "a.svol");
  bytes[bytes.size() - svol::indexBytes(1) - svol::kEndBytes - 1] ^= 1;
  const FileAndCut files = withAndWithoutIndex(bytes, 1);
  for (const std::string& file : {files.whole, files.cut, files.cut.substr(0, files.cut.size() - 1)}) {
    SvolReader reader(folder.write("b.svol", file));
    const SvolSummary summary = summarizeSvol(reader);
    EXPECT_TRUE(summary.frames.empty());
    EXPECT_FALSE(summary.litVoxels);
    EXPECT_EQ(summary.durationMicroseconds, 0u);
    EXPECT_EQ(summary.damage.has_value(), file.size() >= files.cut.size()) << "cut within a frame is unfinished";
  }
}

TEST(SvolRecording, onlyVolumesOfOneDisplayAreJoined) {
  const TemporaryFolder folder;
  writeSvol(folder / "a.svol", Volume(recordedProfile(5, 17, 9, 1)));
  writeSvol(folder / "b.svol", Volume(recordedProfile(5, 18, 9, 1)));
  EXPECT_THROW(joinSvol({folder / "a.svol", folder / "b.svol"}, folder / "c.svol"), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "c.svol"));
}

}  // namespace
}  // namespace ocelli
