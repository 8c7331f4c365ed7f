// Damaged and hostile `.svol` files: an InputError or what was written, never anything else.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <sstream>

#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/svol_summary.h"
#include "oc_core/base/error.h"
#include "tests/display_sim_frames/svol_cases.h"
#include "tests/display_sim_frames/svol_repair.h"
#include "tests/display_sim_slicing/test_files.h"

namespace ocelli {
namespace {

using test::bytesOf;
using test::smallRecording;
using test::SvolCase;

const std::filesystem::path kCorpus = OCELLI_CORPUS_FOLDER;

/// "good", "unfinished" or "bad": what the names of the cases begin with.
std::string verdict(const std::vector<uint8_t>& bytes) {
  std::istringstream in(std::string(bytes.begin(), bytes.end()));
  try {
    SvolReader reader(in, "bytes");
    verifySvol(reader);
    return reader.ending() == SvolEnding::kFinished ? "good" : "unfinished";
  } catch (const InputError&) {
    return "bad";
  }
}

TEST(SvolHostile, everyCaseReadsAsItsNameSays) {
  for (const SvolCase& file : test::svolCases()) {
    EXPECT_EQ(verdict(file.bytes), file.name.substr(0, file.name.find('_'))) << file.name;
  }
}

TEST(SvolHostile, theCorpusHasEveryCase) {
  std::set<std::string> expected;
  for (const SvolCase& file : test::svolCases()) {
    expected.insert(file.name);
  }
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    const std::string name = entry.path().stem();
    found.insert(name);
    EXPECT_EQ(verdict(bytesOf(entry.path())), name.substr(0, name.find('_'))) << name;
  }
  EXPECT_EQ(found, expected);
}

TEST(SvolHostile, tenThousandFlippedBitsAreAllFound) {
  const std::vector<uint8_t> file = smallRecording(5);
  std::mt19937 engine(20261122);
  for (int flip = 0; flip < 10000; ++flip) {
    const size_t bit = engine() % (8 * file.size());
    std::vector<uint8_t> damaged = file;
    damaged[bit / 8] ^= static_cast<uint8_t>(1u << (bit % 8));
    ASSERT_EQ(verdict(damaged), "bad") << "bit " << bit << " of " << 8 * file.size();
  }
}

TEST(SvolHostile, everyFlippedBitOfAFileOfOneVolumeIsFound) {
  const std::vector<uint8_t> file = smallRecording(1);
  for (size_t bit = 0; bit < 8 * file.size(); ++bit) {
    std::vector<uint8_t> damaged = file;
    damaged[bit / 8] ^= static_cast<uint8_t>(1u << (bit % 8));
    ASSERT_EQ(verdict(damaged), "bad") << "bit " << bit;
  }
}

// Up to the end of the last whole frame; what follows is no part of it yet.
TEST(SvolHostile, flippedBitsInTheFramesOfAnUnfinishedRecordingAreFound) {
  std::vector<uint8_t> file = smallRecording(3);
  file.erase(file.end() - static_cast<std::ptrdiff_t>(svol::indexBytes(3) + svol::kEndBytes), file.end());
  ASSERT_EQ(verdict(file), "unfinished");
  for (size_t bit = 0; bit < 8 * file.size(); ++bit) {
    std::vector<uint8_t> damaged = file;
    damaged[bit / 8] ^= static_cast<uint8_t>(1u << (bit % 8));
    ASSERT_EQ(verdict(damaged), "bad") << "bit " << bit;
  }
}

TEST(SvolHostile, everyTruncationOpensUpToTheLastWholeFrame) {
  const std::vector<uint8_t> file = smallRecording(5);
  std::istringstream whole(std::string(file.begin(), file.end()));
  const std::vector<SvolFrame> frames = SvolReader(whole, "whole").frames();
  ASSERT_EQ(frames.size(), 5u);
  const size_t index = file.size() - svol::indexBytes(5) - svol::kEndBytes;
  for (size_t size = 0; size < file.size(); ++size) {
    const std::vector<uint8_t> cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    if (size < frames.front().offset) {
      EXPECT_EQ(verdict(cut), "bad") << size;
      continue;
    }
    EXPECT_EQ(verdict(cut), "unfinished") << size;
    std::istringstream in(std::string(cut.begin(), cut.end()));
    size_t expected = size >= index ? 1 : 0;
    for (size_t k = 1; k < frames.size(); ++k) {
      expected += size >= frames[k].offset ? 1 : 0;
    }
    EXPECT_EQ(SvolReader(in, "cut").frames().size(), expected) << size;
  }
}

// What the checksums guard must be safe without them.
TEST(SvolHostile, everyByteChangedBehindGoodChecksumsIsSafe) {
  const std::vector<uint8_t> file = smallRecording(2);
  size_t refused = 0;
  for (size_t at = 0; at < file.size(); ++at) {
    for (const int flip : {0x01, 0x04, 0x10, 0x80, 0xff}) {
      std::vector<uint8_t> damaged = file;
      damaged[at] ^= static_cast<uint8_t>(flip);
      test::repairSvolChecksums(damaged);
      refused += verdict(damaged) == "good" ? 0 : 1;
    }
  }
  EXPECT_GT(refused, file.size()) << "hardly anything is checked but the checksums";
}

}  // namespace
}  // namespace ocelli
