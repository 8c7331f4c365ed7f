// The process that reads volume files: where voxels come to lie, what becomes of its crashes and nonsense, and folders.
#include "oc_core/volume/volume_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/reader_process.h"
#include "oc_core/volume/volume_formats.h"
#include "oc_core/volume/volume_scene.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume_import/volume_samples.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::volumeSample;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;
using Clock = std::chrono::steady_clock;

/// 2 x 2 x 2 voxels of int16: 0, 256, ... 1792, as each has its number in the upper byte. The header has `comment` more
/// bytes.
std::string smallNrrd(const std::string& comment = "", const std::string& endian = "little") {
  std::string file = "NRRD0004\n" + comment +
                     "type: short\ndimension: 3\nsizes: 2 2 2\nspacings: 1 1 1\nendian: " + endian +
                     "\nencoding: raw\n\n";
  for (char at = 0; at < 8; ++at) {
    file += endian == "little" ? std::string{'\0', at} : std::string{at, '\0'};
  }
  return file;
}

/// An environment variable while it lives.
class ReaderVariable {
 public:
  ReaderVariable(const char* name, const std::string& value) : name_(name) { setenv(name, value.c_str(), 1); }
  ~ReaderVariable() { unsetenv(name_); }
  ReaderVariable(const ReaderVariable&) = delete;
  ReaderVariable& operator=(const ReaderVariable&) = delete;

 private:
  const char* name_;
};

TEST(VolumeReader, KnowsVolumesByTheirNamesAndDicomByItsBytes) {
  const TemporaryFolder folder;
  for (const char* name : {"a.nrrd", "a.NHDR", "a.mha", "a.mhd", "a.vti", "a.nii", "a.Nii.Gz", "a.dcm", "a.IMA"}) {
    EXPECT_TRUE(isVolumeSource(name)) << name;
  }
  for (const char* name : {"a.ply", "a.gz", ".nii", "nrrd", "a.vtk"}) {
    EXPECT_FALSE(isVolumeSource(name)) << name;
  }
  EXPECT_FALSE(isVolumeSource(folder.path()));
  folder.write("IM0001", std::string(128, '\0') + "DICM");
  EXPECT_TRUE(isVolumeSource(folder / "IM0001"));
  EXPECT_TRUE(isVolumeSource(folder.path()));
}

TEST(VolumeReader, MapsVoxelsThatAreAsTheyMustBe) {
  const TemporaryFolder folder;
  // The header has an even number of bytes with this.
  const std::string even = smallNrrd().size() % 2 == 0 ? "" : "#!\n";
  const fs::path path = folder.write("a.nrrd", smallNrrd(even));
  const VolumeFile file = readVolumeFile(path);
  EXPECT_EQ(file.volumes.front().valueAt({1, 1, 1}), 7 * 256);
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary).seekp(-1, std::ios::end).put(1);
  EXPECT_EQ(file.volumes.front().valueAt({1, 1, 1}), 256) << "it stands on the file";
}

TEST(VolumeReader, CopiesVoxelsThatAreMisplacedOrSwapped) {
  const TemporaryFolder folder;
  const std::string odd = smallNrrd().size() % 2 == 1 ? "" : "#!\n";
  for (const std::string& bytes : {smallNrrd(odd), smallNrrd("", "big")}) {
    const fs::path path = folder.write("a.nrrd", bytes);
    const VolumeFile file = readVolumeFile(path);
    fs::remove(path);
    EXPECT_EQ(file.volumes.front().valueAt({1, 1, 1}), 7 * 256);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(file.volumes.front().voxels().data()) % 2, 0U);
  }
}

TEST(VolumeReader, OpensSixtyFourGibibytesWithoutReadingThem) {
  const TemporaryFolder folder;
  const fs::path data = folder.write("big.raw", "");
  if (truncate(data.c_str(), off_t{1} << 36U) != 0) {
    GTEST_SKIP() << "no sparse files of 64 GiB here";
  }
  const std::string sizes = "4096 4096 2048";
  const fs::path nrrd =
      folder.write("a.nhdr", "NRRD0004\ntype: short\ndimension: 3\nsizes: " + sizes +
                                 "\nspacings: 1 1 1\nendian: little\nencoding: raw\ndata file: big.raw\n");
  const fs::path meta = folder.write("a.mhd", "ObjectType = Image\nNDims = 3\nDimSize = " + sizes +
                                                  "\nElementType = MET_SHORT\nElementDataFile = big.raw\n");
  // Its voxels begin at an odd byte, and are copied: holes as holes.
  const std::string header =
      "NRRD0004\n#\ntype: short\ndimension: 3\nsizes: " + sizes + "\nspacings: 1 1 1\nendian: little\nencoding: raw\n";
  const fs::path odd = folder.write("b.nrrd", header + (header.size() % 2 == 1 ? "#!\n" : "") + "\n");
  ASSERT_EQ(fs::file_size(odd) % 2, 1U);
  ASSERT_EQ(truncate(odd.c_str(), static_cast<off_t>(fs::file_size(odd)) + (off_t{1} << 36U)), 0);
  for (const fs::path& path : {nrrd, meta, odd}) {
    const auto start = Clock::now();
    const VolumeFile file = readVolumeFile(path);
    EXPECT_EQ(file.volumes.front().valueAt({4095, 4095, 2047}), 0);
    // Well below a second where nothing else runs; reading them would take minutes.
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(10)) << path;
  }
}

TEST(VolumeReader, TakesAFolderOfNumberedFilesForTimes) {
  const TemporaryFolder folder;
  for (const int number : {1, 2, 10}) {
    std::string bytes = smallNrrd();
    bytes.back() = static_cast<char>(number);
    folder.write("t" + std::to_string(number) + ".nrrd", bytes);
  }
  folder.write("notes.txt", "passed over");
  const VolumeFile file = readVolumeFile(folder.path());
  EXPECT_THAT(file.times, ElementsAre(0, 1, 2));
  ASSERT_EQ(file.volumes.size(), 3U);
  EXPECT_EQ(file.volumes[2].valueAt({1, 1, 1}), 2560) << "t10 stands last";

  std::string other = smallNrrd();
  other.replace(other.find("spacings: 1"), 11, "spacings: 2");
  folder.write("t11.nrrd", other);
  EXPECT_THAT([&] { readVolumeFile(folder.path()); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("t11.nrrd"), HasSubstr("differs from that of t1.nrrd"))));
}

TEST(VolumeReader, RefusesAFolderOfSeveralFormats) {
  const TemporaryFolder folder;
  for (int slice = 0; slice < 40; ++slice) {
    folder.write("IM" + std::to_string(100 + slice), std::string(128, '\0') + "DICM");
  }
  for (int note = 0; note < 40; ++note) {
    folder.write("A" + std::to_string(note) + ".txt", "a note");
  }
  EXPECT_TRUE(isVolumeFile(folder.path())) << "behind many others";
  folder.write("stray.nrrd", smallNrrd());
  EXPECT_THAT([&] { readVolumeFile(folder.path()); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(folder.path().string()), HasSubstr("40 of DICOM (IM100, ...)"),
                                              HasSubstr("1 of NRRD (stray.nrrd)"))));
}

TEST(VolumeReader, TakesASeriesOfDicomAlone) {
  const TemporaryFolder folder;
  folder.write("t1.nrrd", smallNrrd());
  for (const fs::path& path : {volumeSample("oblique.nii"), folder.path()}) {
    EXPECT_THAT([&] { readVolumeFile(path, {"7"}); }, ThrowsMessage<InputError>(HasSubstr("leave --series out")));
  }
}

TEST(VolumeReader, AnswersWhereThereIsNone) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { readVolumeFile(folder / "no.nrrd"); }, ThrowsMessage<InputError>(HasSubstr("no such file")));
  EXPECT_THAT([&] { readVolumeFile(folder.path()); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("no volume"), HasSubstr("NIfTI (.nii, .nii.gz)"))));
  fs::create_directory(folder / "a.nrrd");
  EXPECT_THROW(readVolumeFile(folder / "a.nrrd"), InputError);
}

/// Reads a sound file with a shell script in place of the reader.
class FakeVolumeReader : public testing::Test {
 protected:
  VolumeFile readWith(const std::string& script) const {
    const fs::path path = folder_.write("reader", "#!/bin/sh\n" + script + "\n");
    fs::permissions(path, fs::perms::owner_all);
    const ReaderVariable reader("OCELLI_VOLUME_READER", path.string());
    return readVolumeFile(file_);
  }

  TemporaryFolder folder_;
  fs::path file_ = folder_.write("a.nrrd", smallNrrd());
};

TEST_F(FakeVolumeReader, EndsAreErrors) {
  EXPECT_THAT([&] { readWith("echo 'bad chunk'; kill -SEGV $$"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr(file_.string()), HasSubstr("the reader crashed"), HasSubstr("bad chunk"))));
  EXPECT_THAT([&] { readWith("exit 3"); }, ThrowsMessage<InputError>(HasSubstr("OCELLI_VOLUME_MEMORY_GIB")));
  EXPECT_THAT([&] { readWith("kill -XCPU $$"); }, ThrowsMessage<InputError>(HasSubstr("OCELLI_VOLUME_SECONDS")));
  EXPECT_THAT([&] { readWith("echo nonsense >&3"); }, ThrowsMessage<WorkError>(HasSubstr("no volume")));
  EXPECT_THAT([&] { readWith("echo cannot >&2; exit 1"); }, ThrowsMessage<WorkError>(HasSubstr("cannot")));
}

/// The packages for developers that a text names.
std::set<std::string> packagesIn(const std::string& text) {
  static const std::regex kPackage("lib[a-z0-9]+-dev");
  std::set<std::string> packages;
  for (std::sregex_iterator at(text.begin(), text.end(), kPackage), end; at != end; ++at) {
    packages.insert(at->str());
  }
  return packages;
}

// What an installation without the program says: the option, and the packages that the guide has for it.
TEST(VolumeReader, WhereItIsMissingSaysWhatTheGuideSays) {
  const std::string option = "OCELLI_WITH_VOLUME_IMPORT";
  const std::string guide = readFile(OCELLI_INSTALL_GUIDE);
  const size_t row = guide.find("| `" + option + "`");
  ASSERT_NE(row, std::string::npos);
  const std::set<std::string> packages = packagesIn(guide.substr(row, guide.find('\n', row) - row));
  ASSERT_GE(packages.size(), 3U);
  OwnProgram missing = volumeReader().program;
  missing.name = "ocelli-read-nothing";
  missing.installed = "/nowhere/ocelli-read-nothing";
  try {
    findOwnProgram(missing);
    FAIL() << "there is no such program";
  } catch (const WorkError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("reads volume files"), HasSubstr(option + "=ON"),
                                    HasSubstr("OCELLI_VOLUME_READER"), HasSubstr("/nowhere")));
    EXPECT_EQ(packagesIn(error.what()), packages);
  }
}

TEST(VolumeReader, LeavesNothingBehind) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.nrrd", smallNrrd("", "big"));
  const fs::path temporary = folder / "tmp";
  fs::create_directory(temporary);
  const ReaderVariable scratch("TMPDIR", temporary.string());
  const VolumeFile file = readVolumeFile(path);
  EXPECT_TRUE(fs::is_empty(temporary));
  EXPECT_EQ(file.volumes.front().valueAt({1, 1, 1}), 7 * 256);
}

TEST(VolumeReader, NeedsAFolderForTemporaryFilesOnlyToUnpack) {
  const TemporaryFolder folder;
  const ReaderVariable scratch("TMPDIR", (folder / "nowhere").string());
  const std::string even = smallNrrd().size() % 2 == 0 ? "" : "#!\n";
  EXPECT_EQ(readVolumeFile(folder.write("a.nrrd", smallNrrd(even))).volumes.size(), 1U);
  const fs::path packed = folder.write("b.nrrd", smallNrrd("", "big"));
  EXPECT_THAT([&] { readVolumeFile(packed); },
              ThrowsMessage<WorkError>(AllOf(HasSubstr("b.nrrd"), HasSubstr("nowhere"), HasSubstr("TMPDIR"))));
}

TEST(VolumeReader, CleansUnitsOfControlCharactersAndOfLength) {
  const TemporaryFolder folder;
  const auto unitOf = [&](const std::string& unit) {
    return readVolumeFile(folder.write("a.mha", "NDims = 3\nDimSize = 1 1 1\nElementSpacing = 1 1 1\nDistanceUnits = " +
                                                    unit + "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n1"))
        .volumes.front()
        .grid()
        .unit;
  };
  EXPECT_EQ(unitOf("m\x1b[2Jm"), "m\\x1b[2Jm");
  EXPECT_EQ(unitOf(std::string(63, 'm') + "\xc2\xb5" + "mmm"), std::string(63, 'm') + "...");
}

TEST(VolumeReader, ShiftsTimesBelowZero) {
  const TemporaryFolder folder;
  const VolumeFile file = readVolumeFile(
      folder.write("a.mha",
                   "NDims = 4\nDimSize = 1 1 1 3\nElementSpacing = 1 1 1 0.5\nOffset = 0 0 0 -2\nElementType = "
                   "MET_UCHAR\nElementDataFile = LOCAL\n123"));
  EXPECT_THAT(file.times, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(file.warnings, testing::Contains(HasSubstr("begin at -2 s")));
}

TEST(VolumeReader, GivesScenes) {
  const VolumeScene scene = loadVolumeScene(volumeSample("oblique.nii").string());
  EXPECT_NEAR(glm::length(scene.bounds().size()), 2, 1e-5);
  // The marker at the head (y up) stands above the one at the foot, the one at the left of the patient to the right.
  const auto at = [&](int i, int j, int k) { return glm::dvec3(scene.worldFromIndex * glm::dvec4(i, j, k, 1)); };
  EXPECT_GT(at(0, 5, 4).y, at(0, 5, 0).y);
  EXPECT_GT(at(6, 5, 0).x, at(0, 5, 0).x);
  EXPECT_LT(at(0, 0, 0).z, at(0, 5, 0).z) << "the back is far, and j is flipped";
}

}  // namespace
}  // namespace ocelli
