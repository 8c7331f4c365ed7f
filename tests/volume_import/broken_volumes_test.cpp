// Files that are damaged, of another kind, or not of scalars, through the process that reads them: a clear error, which
// names the file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <ostream>

#include "oc_core/base/error.h"
#include "oc_core/volume/volume_reader.h"
#include "tests/base/temporary_folder.h"
#include "tests/volume_import/volume_samples.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using test::fileBytes;
using test::TemporaryFolder;
using test::volumeSample;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct BrokenVolume {
  std::string name;  ///< of the test
  std::string file;  ///< the sample that it is made of
  std::string from;  ///< what is replaced in it; empty: its last bytes are cut off
  std::string to;
  std::string message;  ///< a part of the error
  size_t cut = 60;      ///< bytes, where some are cut off
};

void PrintTo(const BrokenVolume& broken, std::ostream* out) {
  *out << broken.name;
}

std::string littleEndian(int16_t number) {
  std::array<char, 2> bytes{};
  std::memcpy(bytes.data(), &number, 2);
  return {bytes.data(), 2};
}

/// Two fields of a NIfTI-1 header: the type and its bits.
std::string niftiType(int16_t type, int16_t bits) {
  return littleEndian(type) + littleEndian(bits);
}

class BrokenVolumeFile : public testing::TestWithParam<BrokenVolume> {};

TEST_P(BrokenVolumeFile, IsAClearError) {
  const BrokenVolume& broken = GetParam();
  std::string bytes = fileBytes(volumeSample(broken.file));
  if (broken.from.empty()) {
    bytes.resize(bytes.size() - broken.cut);
  } else {
    const size_t at = bytes.find(broken.from);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, broken.from.size(), broken.to);
  }
  const TemporaryFolder folder;
  const fs::path path = folder.write(broken.file, bytes);
  EXPECT_THAT([&] { readVolumeFile(path); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr(folder.path().string()), HasSubstr(broken.message), HasSubstr("\n  try: "))));
}

INSTANTIATE_TEST_SUITE_P(
    Files, BrokenVolumeFile,
    testing::Values(
        BrokenVolume{"NrrdTooShort", "teem_ras.nrrd", "", "", "360 bytes of voxels, 60 fewer than its header says"},
        BrokenVolume{"NrrdGzipTooShort", "teem_gzip.nrrd", "", "", "compressed voxels end too early", 12},
        BrokenVolume{"NrrdTextTooShort", "teem_ascii.nrrd", "", "", "no NRRD file that can be read"},
        BrokenVolume{"NrrdOtherMagic", "teem_ras.nrrd", "NRRD", "NARD", "does not begin with \"NRRD\""},
        BrokenVolume{"NrrdUnknownType", "teem_ras.nrrd", "type: short", "type: shore", "no NRRD file that can be read"},
        BrokenVolume{"NrrdNoSizes", "teem_ras.nrrd", "sizes: 7 6 5", "sizes: 7 6  ", "no NRRD file that can be read"},
        BrokenVolume{"NrrdZeroSize", "teem_ras.nrrd", "sizes: 7 6 5", "sizes: 7 0 5", "no NRRD file that can be read"},
        BrokenVolume{"NrrdHugeSize", "teem_ras.nrrd", "sizes: 7 6 5", "sizes: 7000000 6 5", "7000000 x 6 x 5 voxels"},
        BrokenVolume{"NrrdTwoDimensions", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
                     "dimension: 2\nsizes: 7 30\n", "the file has 2 dimensions"},
        BrokenVolume{"NrrdColours", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
                     "dimension: 4\nsizes: 3 7 2 5\nkinds: RGB-color domain domain domain\n", "3 numbers each"},
        BrokenVolume{"NrrdTimeFirst", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
                     "dimension: 4\nsizes: 3 7 2 5\nkinds: list domain domain domain\n", "unu permute -p 1 2 3 0"},
        BrokenVolume{"NrrdTimeBeforeSpace", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
                     "dimension: 4\nsizes: 3 7 2 5\nkinds: time domain domain domain\n", "unu permute -p 1 2 3 0"},
        BrokenVolume{"NrrdTimeWithinSpace", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
                     "dimension: 4\nsizes: 7 2 3 5\nkinds: domain domain time domain\n", "unu permute -p 0 1 3 2"},
        BrokenVolume{"NrrdPlaneAtTimes", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
                     "dimension: 3\nsizes: 7 6 5\nkinds: domain domain time\n", "a plane at several times"},
        BrokenVolume{"NrrdNoKindWithin", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
                     "dimension: 4\nsizes: 7 3 2 5\nkinds: domain none domain domain\n",
                     "axis 1 of the file (the first is 0) has the kind none"},
        BrokenVolume{
            "NrrdNoDirectionWithin", "teem_plain.nrrd", "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n",
            "dimension: 4\nsizes: 7 3 2 5\nspace dimension: 3\nspace directions: (1,0,0) none (0,1,0) (0,0,1)\n",
            "3 numbers each"},
        BrokenVolume{"NrrdNoDataFile", "teem_detached.nhdr", "teem_detached.raw", "teem_nowhere.raw",
                     "teem_nowhere.raw"},
        BrokenVolume{"NiftiTooShort", "upright.nii", "", "", "360 bytes of voxels, 60 fewer"},
        BrokenVolume{"NiftiGzipTooShort", "upright.nii.gz", "", "", "compressed voxels end too early", 12},
        BrokenVolume{"NiftiOtherMagic", "upright.nii", std::string("n+1\0", 4), std::string("n-1\0", 4),
                     "no NIfTI file of one piece"},
        BrokenVolume{"NiftiColours", "upright.nii", niftiType(4, 16), niftiType(128, 24),
                     "NIFTI_TYPE_RGB24 are not read"},
        BrokenVolume{"NiftiComplex", "upright.nii", niftiType(4, 16), niftiType(32, 64), "COMPLEX64 are not read"},
        BrokenVolume{
            "NiftiVectors", "upright.nii",
            littleEndian(3) + littleEndian(7) + littleEndian(6) + littleEndian(5) + littleEndian(1) + littleEndian(1),
            littleEndian(5) + littleEndian(7) + littleEndian(2) + littleEndian(5) + littleEndian(1) + littleEndian(3),
            "several numbers each"},
        BrokenVolume{"NiftiNegativeSize", "upright.nii", littleEndian(3) + littleEndian(7) + littleEndian(6),
                     littleEndian(3) + littleEndian(7) + littleEndian(-6), "-6 samples along axis 2"},
        BrokenVolume{"NiftiZeroSize", "upright.nii", littleEndian(3) + littleEndian(7) + littleEndian(6),
                     littleEndian(3) + littleEndian(7) + littleEndian(0), "0 samples along axis 2"},
        BrokenVolume{"NiftiNegativeOffset", "upright.nii", std::string("\0\0\xb0\x43", 4),
                     std::string("\0\0\xb0\xc3", 4), "begin at byte -352"},
        BrokenVolume{"NrrdGzipFromTheEnd", "teem_gzip.nrrd", "encoding: gzip\n", "encoding: gzip\nbyte skip: -1\n",
                     "byte skip -1"},
        BrokenVolume{"MetaTooShort", "itk_oblique.mha", "", "", "60 fewer than its header says"},
        BrokenVolume{"MetaCompressedTooShort", "vtk.mha", "", "", "compressed voxels end too early", 12},
        BrokenVolume{"MetaNoDataFile", "itk_oblique.mhd", "itk_oblique.raw", "nowhere.raw",
                     "nowhere.raw, which is not there"},
        BrokenVolume{"MetaUnknownType", "itk_oblique.mha", "MET_SHORT", "MET_SHIRT",
                     "ElementType MET_SHIRT are not read"},
        BrokenVolume{"VtiTooShort", "appended_raw.vti", "", "", "the file has"},
        BrokenVolume{"VtiOtherExtent", "appended_raw.vti", "Piece Extent=\"0 6 0 5 0 4", "Piece Extent=\"0 6 0 5 0 5",
                     "the array has 210 bytes, and its extent and type need 252"},
        BrokenVolume{"VtiOfAnotherKind", "appended_raw.vti", "type=\"ImageData\"", "type=\"PolyData\" ",
                     "\"PolyData\""}),
    [](const auto& test) { return test.param.name; });

/// The sample without a space, of 210 voxels, with other axes.
VolumeFile readNrrdOfAxes(const std::string& axes) {
  const std::string from = "dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n";
  std::string bytes = fileBytes(volumeSample("teem_plain.nrrd"));
  const size_t at = bytes.find(from);
  EXPECT_NE(at, std::string::npos);
  const TemporaryFolder folder;
  return readVolumeFile(folder.write("a.nrrd", bytes.replace(at, from.size(), axes)));
}

TEST(NrrdAxes, OfOneSampleStayWhereTheyAreOfSpace) {
  for (const char* kinds : {"kinds: domain domain domain time\n", ""}) {
    const VolumeFile file = readNrrdOfAxes(std::string("dimension: 4\nsizes: 7 6 1 5\n") + kinds);
    EXPECT_EQ(file.volumes.size(), 5U) << kinds;
    EXPECT_EQ(file.volumes.front().grid().size, glm::ivec3(7, 6, 1)) << kinds;
  }
  for (const char* axes : {"dimension: 4\nsizes: 1 7 6 5\n", "dimension: 4\nsizes: 7 6 5 1\n",
                           "dimension: 4\nsizes: 7 1 6 5\nkinds: domain list domain domain\n",
                           "dimension: 4\nsizes: 7 1 6 5\nkinds: domain none domain domain\n"}) {
    const VolumeFile file = readNrrdOfAxes(axes);
    EXPECT_EQ(file.volumes.size(), 1U) << axes;
    EXPECT_EQ(file.volumes.front().grid().size, glm::ivec3(7, 6, 5)) << axes;
  }
}

TEST(NrrdAxes, WithoutAKindBesideTwoOfSpaceAreOfSpaceWithAWarning) {
  const VolumeFile file = readNrrdOfAxes("dimension: 3\nsizes: 7 6 5\nkinds: domain none domain\n");
  EXPECT_EQ(file.volumes.front().grid().size, glm::ivec3(7, 6, 5));
  EXPECT_THAT(file.warnings, testing::Contains(HasSubstr("axis 1 of the file")));
  const VolumeFile plain = readNrrdOfAxes("dimension: 3\nsizes: 7 6 5\nspacings: 2 3 4\n");
  EXPECT_THAT(plain.warnings, testing::Not(testing::Contains(HasSubstr("kind"))));
}

/// A folder with DICOM slices of a sample, which a test changes.
class DicomFolder : public testing::Test {
 protected:
  void copy(const std::string& sample, const std::string& prefix = "") const {
    for (const fs::directory_entry& entry : fs::directory_iterator(volumeSample(sample))) {
      fs::copy_file(entry.path(), folder_ / (prefix + entry.path().filename().string()));
    }
  }
  void expectError(const testing::Matcher<std::string>& message) const {
    EXPECT_THAT([&] { readVolumeFile(folder_.path()); }, ThrowsMessage<InputError>(message));
  }

  TemporaryFolder folder_;
};

TEST_F(DicomFolder, WithAMissingSliceNamesItsNeighbours) {
  copy("dicom_upright");
  // Of slices 0 to 4, which are im0, im3, im1, im4, im2.
  fs::remove(folder_ / "im1.dcm");
  expectError(AllOf(HasSubstr("1 slice is missing between im3.dcm and im4.dcm"), HasSubstr("8 mm apart, not 4 mm")));
}

TEST_F(DicomFolder, WithAMissingSliceAtAnEndTellsOfIt) {
  // Fields that say that there are 5, each before the first field of the group behind it.
  for (const auto& [field, before] :
       {std::pair(std::string("\x20\0\x02\x10IS\x02\0"
                              "5 ",
                              10),
                  std::string("\x28\0\x02\0US", 6)),
        std::pair(std::string("\x54\0\x81\0US\x02\0\x05\0", 10), std::string("\xe0\x7f\x10\0", 4))}) {
    copy("dicom_upright");
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path())) {
      std::string bytes = fileBytes(entry.path());
      const size_t at = bytes.find(before);
      ASSERT_NE(at, std::string::npos);
      folder_.write(entry.path().filename().string(), bytes.insert(at, field));
    }
    EXPECT_THAT(readVolumeFile(folder_.path()).warnings, testing::IsEmpty());
    fs::remove(folder_ / "im0.dcm");  // the lowest
    const VolumeFile file = readVolumeFile(folder_.path());
    EXPECT_EQ(file.volumes.front().grid().size.z, 4);
    EXPECT_THAT(file.warnings, testing::Contains(HasSubstr("may be missing at an end")));
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path())) {
      fs::remove(entry.path());
    }
  }
}

TEST_F(DicomFolder, WithOneSliceTwiceNamesBoth) {
  copy("dicom_upright");
  fs::copy_file(folder_ / "im1.dcm", folder_ / "again.dcm");
  expectError(AllOf(HasSubstr("again.dcm and im1.dcm stand in one place"), HasSubstr("at 38 mm")));
}

TEST_F(DicomFolder, WithTwoSeriesListsThemAndTakesOneByNumberOrUid) {
  copy("dicom_upright");
  copy("dicom_oblique", "b_");
  expectError(AllOf(HasSubstr("there are 2 series"),
                    HasSubstr("series 7: 5 slices of 7 x 6, \"dicom_upright\", UID 1.2.826"), HasSubstr("series 8"),
                    HasSubstr("--series")));
  EXPECT_EQ(readVolumeFile(folder_.path(), {"8"}).volumes.front().scale(), 2);
  EXPECT_EQ(readVolumeFile(folder_.path(), {"1.2.826.0.1.3680043.8.498.7"}).volumes.front().scale(), 1);
  EXPECT_THAT([&] { readVolumeFile(folder_.path(), {"9"}); },
              ThrowsMessage<InputError>(HasSubstr("no series \"9\" among the 2 here")));
}

TEST_F(DicomFolder, WithADamagedFileNamesIt) {
  copy("dicom_upright");
  const std::string bytes = fileBytes(folder_ / "im1.dcm");
  for (const size_t size : {bytes.size() - 1, bytes.size() - 30, size_t{300}}) {
    folder_.write("im1.dcm", bytes.substr(0, size));
    expectError(HasSubstr("im1.dcm"));
  }
}

TEST_F(DicomFolder, WithADamagedCompressedFileNamesIt) {
  copy("dicom_oblique");
  const std::string bytes = fileBytes(folder_ / "im1.dcm");
  folder_.write("im1.dcm", bytes.substr(0, bytes.size() - 30));
  expectError(HasSubstr("im1.dcm"));
}

TEST_F(DicomFolder, PassesOverWhatIsNoDicom) {
  copy("dicom_upright");
  folder_.write("readme.txt", "a letter");
  EXPECT_EQ(readVolumeFile(folder_.path()).volumes.front().grid().size, glm::ivec3(7, 6, 5));
}

TEST_F(DicomFolder, PassesOverAReportWithoutAPosition) {
  copy("dicom_upright");
  std::string report = fileBytes(folder_ / "im1.dcm");
  const std::string uid = "1.2.826.0.1.3680043.8.498.7";
  const size_t series = report.find(std::string("\x20\0\x0e\0", 4));
  ASSERT_NE(series, std::string::npos);
  ASSERT_EQ(report.find(uid, series), series + 8);
  report[series + 7 + uid.size()] = '6';
  const size_t position = report.find(std::string("\x20\0\x32\0", 4));
  ASSERT_NE(position, std::string::npos);
  report[position + 2] = '\x33';  // another field, which nobody reads
  folder_.write("report.dcm", report);
  const VolumeFile file = readVolumeFile(folder_.path());
  EXPECT_EQ(file.volumes.front().grid().size, glm::ivec3(7, 6, 5));
  EXPECT_THAT(file.warnings, testing::Contains(HasSubstr("1 of the folder's images")));
  EXPECT_EQ(readVolumeFile(folder_.path(), {uid}).volumes.front().grid().size, glm::ivec3(7, 6, 5));
}

TEST_F(DicomFolder, WithAnInterceptThatIsNoNumberNamesIt) {
  copy("dicom_upright");
  std::string bytes = fileBytes(folder_ / "im1.dcm");
  const size_t at = bytes.rfind("-1024");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 2] = ',';
  folder_.write("im1.dcm", bytes);
  expectError(AllOf(HasSubstr("im1.dcm"), HasSubstr("its RescaleIntercept is \"-1,24\", which is no number")));
}

TEST_F(DicomFolder, WithPixelsInUpperBitsNamesIt) {
  copy("dicom_upright");
  std::string bytes = fileBytes(folder_ / "im1.dcm");
  const size_t at = bytes.find(std::string("\x28\0\x02\x01US\x02\0", 8));
  ASSERT_NE(at, std::string::npos);
  // BitsStored stands before it, of 8 + 2 bytes.
  bytes[at - 2] = 12;
  bytes[at + 8] = 15;
  folder_.write("im1.dcm", bytes);
  expectError(AllOf(HasSubstr("im1.dcm"), HasSubstr("12 bits of a pixel (BitsStored) end at bit 15")));
}

// What is called DICOM is meant to be a slice: at the ends nobody would miss it.
TEST_F(DicomFolder, NamesAnEmptySlice) {
  copy("dicom_upright");
  folder_.write("im0.dcm", "");
  expectError(HasSubstr("im0.dcm"));
}

TEST_F(DicomFolder, OneSliceIsNoVolume) {
  copy("dicom_upright");
  EXPECT_THAT([&] { readVolumeFile(folder_ / "im0.dcm"); }, ThrowsMessage<InputError>(HasSubstr("give the folder")));
}

}  // namespace
}  // namespace ocelli
