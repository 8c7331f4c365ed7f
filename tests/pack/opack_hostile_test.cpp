// Damaged and hostile packed scenes: a clear refusal, never anything else, and no more memory than the file is large.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/pack/cluster_cut.h"
#include "oc_core/pack/pack_summary.h"
#include "oc_core/worlds/packed_source.h"
#include "tests/base/temporary_folder.h"
#include "tests/pack/opack_cases.h"
#include "tests/pack/opack_repair.h"

namespace ocelli::test {
namespace {

const std::filesystem::path kCorpus = OCELLI_CORPUS_FOLDER;

/// What is said of it once all of it is read; nothing where it is whole.
std::string complaintOf(const std::filesystem::path& path) {
  try {
    summaryOf(openPacked(path.string(), {}));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string complaintOf(const TemporaryFolder& folder, const std::vector<uint8_t>& bytes) {
  return complaintOf(folder.write("case.opack", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
}

TEST(OpackHostile, EveryCaseReadsAsItsNameSays) {
  const TemporaryFolder folder;
  for (const OpackCase& file : opackCases()) {
    const std::string complaint = complaintOf(folder, file.bytes);
    EXPECT_EQ(complaint.empty(), file.name.starts_with("good_")) << file.name << ": " << complaint;
    EXPECT_THAT(complaint, testing::HasSubstr(file.complaint)) << file.name;
    if (!complaint.empty()) {
      EXPECT_THAT(complaint, testing::HasSubstr("case.opack")) << file.name;
      EXPECT_LT(file.bytes.size(), 4096U) << file.name << ": the fuzzer takes no longer ones";
    }
  }
}

TEST(OpackHostile, TheCorpusHasEveryCase) {
  std::set<std::string> expected;
  for (const OpackCase& file : opackCases()) {
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

/// Whatever a reader asks for, and in whatever order: what is refused is refused each time.
TEST(OpackHostile, WhatIsDamagedIsRefusedAgain) {
  const TemporaryFolder folder;
  std::vector<uint8_t> bytes = smallPack();
  const auto group = opackRecord<opack::GroupRecord>(bytes, opackTrailer(bytes).tableOffset);
  bytes[group.offset + 40] ^= 1U;
  const PackedScene scene(folder.write("damaged.opack", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
  for (int time = 0; time < 2; ++time) {
    EXPECT_THROW(unpackedMesh(scene), InputError);
    EXPECT_THROW(scene.cluster(0, 0), InputError);
    // The coarse level does not touch what is damaged.
    EXPECT_GT(meshOf(scene, coarsestClusters(scene, 1)).triangles.size(), 0U);
  }
}

/// Bytes at random places become others, and the checksums are made right again.
TEST(OpackHostile, AnyBytesAreRefusedOrGiveAMesh) {
  const TemporaryFolder folder;
  const std::vector<uint8_t> whole = smallPack();
  std::mt19937 engine(20261124);
  size_t whichRead = 0;
  for (int round = 0; round < 4000; ++round) {
    std::vector<uint8_t> bytes = whole;
    for (int change = 0; change <= round % 3; ++change) {
      bytes[engine() % bytes.size()] = static_cast<uint8_t>(engine() % 4 == 0 ? 0xff : engine());
    }
    repairOpackChecksums(bytes);
    const auto path = folder.write("any.opack", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    try {
      const Mesh mesh = unpackedMesh(openPacked(path.string(), {}));
      // A triangle takes 3 bytes.
      EXPECT_LT(mesh.triangles.size(), bytes.size() / 3);
      ++whichRead;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("any.opack"));
    }
  }
  // Positions and colours may be any numbers.
  EXPECT_GT(whichRead, 400U);
}

}  // namespace
}  // namespace ocelli::test
