// Damaged and hostile `.svol` files: an InputError or the right volume, never anything else.
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "display_sim/svol_file.h"
#include "oc_core/base/error.h"
#include "tests/display_sim/svol_repair.h"
#include "tests/display_sim/test_files.h"

namespace ocelli {
namespace {

using test::bytesOf;

const std::filesystem::path kCorpus = OCELLI_CORPUS_FOLDER;

std::optional<Volume> readBytes(const std::vector<uint8_t>& bytes) {
  std::istringstream in(std::string(bytes.begin(), bytes.end()));
  try {
    return readSvol(in, "bytes");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

TEST(SvolHostile, corpusFilesReadAsTheirNamesSay) {
  size_t good = 0;
  size_t bad = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    const bool expectGood = entry.path().filename().string().starts_with("good_");
    (expectGood ? good : bad) += 1;
    EXPECT_EQ(readBytes(bytesOf(entry.path())).has_value(), expectGood) << entry.path();
  }
  EXPECT_GE(good, 2u);
  EXPECT_GE(bad, 8u);
}

class GoodFiles : public ::testing::TestWithParam<const char*> {
 protected:
  const std::vector<uint8_t> file_ = bytesOf(kCorpus / GetParam());
};

TEST_P(GoodFiles, everyTruncationIsRefused) {
  for (size_t size = 0; size < file_.size(); ++size) {
    EXPECT_FALSE(readBytes({file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
  }
  std::vector<uint8_t> longer = file_;
  longer.push_back(0);
  EXPECT_FALSE(readBytes(longer));
}

TEST_P(GoodFiles, everyFlippedByteIsRefused) {
  for (size_t at = 0; at < file_.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::vector<uint8_t> damaged = file_;
      damaged[at] ^= static_cast<uint8_t>(flip);
      EXPECT_FALSE(readBytes(damaged)) << "byte " << at;
    }
  }
}

// The same with checksums that fit: what the checksums guard must be safe without them.
TEST_P(GoodFiles, everyByteChangedBehindGoodChecksumsIsSafe) {
  size_t refused = 0;
  for (size_t at = 0; at < file_.size(); ++at) {
    for (const int flip : {0x01, 0x04, 0x10, 0x80, 0xff}) {
      std::vector<uint8_t> damaged = file_;
      damaged[at] ^= static_cast<uint8_t>(flip);
      test::repairSvolChecksums(damaged);
      const std::optional<Volume> volume = readBytes(damaged);
      refused += volume ? 0 : 1;
      if (volume) {
        EXPECT_LE(volume->litVoxels(), static_cast<size_t>(volume->slices() * volume->width() * volume->height()));
      }
    }
  }
  EXPECT_GT(refused, file_.size()) << "hardly anything is checked but the checksums";
}

INSTANTIATE_TEST_SUITE_P(SvolHostile, GoodFiles, ::testing::Values("good_small.svol", "good_own_second_half.svol"),
                         [](const auto& test) { return std::string(test.param, std::string(test.param).find('.')); });

}  // namespace
}  // namespace ocelli
