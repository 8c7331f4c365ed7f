// Seas that are made to mislead: a clear refusal, never anything else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/random.h"
#include "oc_core/sea/sea_file.h"
#include "tests/base/temporary_folder.h"
#include "tests/sea/sea_cases.h"
#include "tests/sea/sea_repair.h"

namespace ocelli::test {
namespace {

const std::filesystem::path kCorpus = OCELLI_CORPUS_FOLDER;

/// What is said of it once all of it is read; nothing where it is whole.
std::string complaintOf(const std::filesystem::path& path) {
  try {
    SeaFile(path).verify(true);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string complaintOf(const TemporaryFolder& folder, const std::vector<uint8_t>& bytes) {
  return complaintOf(folder.write("case.sea", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
}

TEST(SeaHostile, EveryCaseReadsAsItsNameSays) {
  const TemporaryFolder folder;
  for (const SeaCase& file : seaCases()) {
    const std::string complaint = complaintOf(folder, file.bytes);
    EXPECT_EQ(complaint.empty(), file.name.starts_with("good_")) << file.name << ": " << complaint;
    EXPECT_THAT(complaint, testing::HasSubstr(file.complaint)) << file.name;
    if (!complaint.empty()) {
      EXPECT_THAT(complaint, testing::HasSubstr("case.sea")) << file.name;
    }
    EXPECT_LT(file.bytes.size(), 4096U) << file.name << ": the fuzzer takes no longer ones";
  }
}

TEST(SeaHostile, TheCorpusHasEveryCase) {
  std::set<std::string> expected;
  for (const SeaCase& file : seaCases()) {
    expected.insert(file.name);
  }
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(kCorpus)) {
    const std::string name = entry.path().stem();
    found.insert(name);
    EXPECT_EQ(complaintOf(entry.path()).empty(), name.starts_with("good_")) << name;
  }
  EXPECT_EQ(found, expected);
}

TEST(SeaHostile, ChangedBytesBehindChecksumsThatFitAreNoDanger) {
  const TemporaryFolder folder;
  std::vector<SeaCase> cases = seaCases();
  std::erase_if(cases, [](const SeaCase& file) { return !file.name.starts_with("good_"); });
  Random random(11);
  for (int i = 0; i < 1500; ++i) {
    std::vector<uint8_t> bytes = cases[random.below(cases.size())].bytes;
    for (size_t change = random.below(4) + 1; change-- > 0;) {
      bytes[random.below(bytes.size())] = static_cast<uint8_t>(random.below(256));
    }
    repairSeaChecksums(bytes);
    complaintOf(folder, bytes);
  }
}

}  // namespace
}  // namespace ocelli::test
