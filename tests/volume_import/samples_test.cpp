// Files that other programs wrote (samples/make_samples.py says which): the markers of the block that they hold land
// where they should be in the patient, whatever the format, the order of its axes and its frame.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <ostream>
#include <set>
#include <vector>

#include "oc_core/volume/import/volume_file_readers.h"
#include "oc_core/volume/volume_reader.h"
#include "tests/volume_import/volume_samples.h"

namespace ocelli {
namespace {

using test::volumeSample;

const glm::ivec3 kSize(7, 6, 5);
/// NIfTI has positions of float32, and DICOM of nine digits: a millionth of the 50 mm that the block reaches.
constexpr double kTolerance = 1e-4;

struct VolumeSample {
  std::string file;
  bool isOblique;
  bool isAnatomical;
  VoxelType type;
  double scale = 1;
  double offset = 0;
};

/// The parameter as tests are listed with it: without this, as raw bytes.
void PrintTo(const VolumeSample& sample, std::ostream* out) {
  *out << sample.file;
}

/// Positions by value: make_samples.py.
std::map<double, glm::dvec3> markers(bool isOblique) {
  glm::dmat3 turn(1);
  if (isOblique) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 3));
    const double angle = 25 * std::acos(-1.0) / 180;
    const glm::dmat3 cross(glm::dvec3(0, axis.z, -axis.y), glm::dvec3(-axis.z, 0, axis.x),
                           glm::dvec3(axis.y, -axis.x, 0));
    turn = glm::dmat3(1) + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;
  }
  const auto at = [&](int i, int j, int k) { return glm::dvec3(-10, 20, 30) + turn * glm::dvec3(2 * i, 3 * j, 4 * k); };
  return {{100, at(0, 0, 0)}, {120, at(6, 0, 0)}, {140, at(0, 5, 0)}, {160, at(0, 0, 4)}, {180, at(1, 2, 3)}};
}

void expectBlock(const ScalarVolume& volume, const std::map<double, glm::dvec3>& expected, double rise) {
  ASSERT_EQ(volume.grid().size, kSize);
  std::map<double, glm::dvec3> found;
  for (int k = 0; k < kSize.z; ++k) {
    for (int j = 0; j < kSize.y; ++j) {
      for (int i = 0; i < kSize.x; ++i) {
        if (const double value = volume.valueAt({i, j, k}) - rise; value != 10) {
          EXPECT_TRUE(found.emplace(value, volume.grid().worldFromIndex * glm::dvec4(i, j, k, 1)).second) << value;
        }
      }
    }
  }
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [value, position] : expected) {
    ASSERT_EQ(found.count(value), 1U) << value;
    EXPECT_LT(glm::distance(found[value], position), kTolerance) << "the marker " << value;
  }
}

class VolumeSampleFile : public testing::TestWithParam<VolumeSample> {};

TEST_P(VolumeSampleFile, HasItsMarkersWhereTheyAreInThePatient) {
  const VolumeSample& sample = GetParam();
  const VolumeFile file = readVolumeFile(volumeSample(sample.file));
  ASSERT_EQ(file.volumes.size(), 1U);
  EXPECT_TRUE(file.times.empty());
  const ScalarVolume& volume = file.volumes.front();
  expectBlock(volume, markers(sample.isOblique), 0);
  EXPECT_EQ(volume.grid().isAnatomical, sample.isAnatomical);
  EXPECT_EQ(volume.grid().unit, sample.isAnatomical ? "mm" : "");
  EXPECT_EQ(volume.type(), sample.type);
  EXPECT_EQ(volume.scale(), sample.scale);
  EXPECT_EQ(volume.offset(), sample.offset);
  const glm::dvec3 spacing = volume.grid().spacing();
  EXPECT_LT(glm::distance(spacing, glm::dvec3(2, 3, 4)), kTolerance);
}

const std::vector<VolumeSample> kVolumeSamples{
    VolumeSample{"upright.nii", false, true, VoxelType::kInt16},
    VolumeSample{"upright.nii.gz", false, true, VoxelType::kInt16},
    VolumeSample{"oblique.nii", true, true, VoxelType::kInt16},
    VolumeSample{"oblique.nii.gz", true, true, VoxelType::kInt16},
    VolumeSample{"big_endian_qform.nii", true, true, VoxelType::kInt16, 0.5, -20},
    VolumeSample{"itk_upright.mha", false, true, VoxelType::kInt16},
    VolumeSample{"itk_oblique.mha", true, true, VoxelType::kInt16},
    VolumeSample{"itk_upright.mhd", false, true, VoxelType::kInt16},
    VolumeSample{"itk_oblique.mhd", true, true, VoxelType::kInt16},
    VolumeSample{"itk_upright.nrrd", false, true, VoxelType::kInt16},
    VolumeSample{"itk_oblique.nrrd", true, true, VoxelType::kInt16},
    VolumeSample{"teem_ras.nrrd", true, true, VoxelType::kInt16},
    VolumeSample{"teem_las.nrrd", true, true, VoxelType::kInt16},
    VolumeSample{"teem_gzip.nrrd", true, true, VoxelType::kInt16},
    VolumeSample{"teem_bzip2.nrrd", true, true, VoxelType::kInt16},
    VolumeSample{"teem_ascii.nrrd", true, true, VoxelType::kInt16},
    VolumeSample{"teem_hex.nrrd", true, true, VoxelType::kInt16},
    VolumeSample{"teem_detached.nhdr", true, true, VoxelType::kInt16},
    VolumeSample{"dicom_upright", false, true, VoxelType::kUint16, 1, -1024},
    VolumeSample{"dicom_oblique", true, true, VoxelType::kUint16, 2, -1000},
    VolumeSample{"dicom_slopes", true, true, VoxelType::kFloat32},
    VolumeSample{"dicom_frames.dcm", true, true, VoxelType::kUint16, 1, -1024},
    VolumeSample{"ascii.vti", false, false, VoxelType::kFloat32},
    VolumeSample{"binary.vti", false, false, VoxelType::kInt16},
    VolumeSample{"binary_zlib.vti", false, false, VoxelType::kInt16},
    VolumeSample{"appended_raw.vti", false, false, VoxelType::kUint8},
    VolumeSample{"appended_raw_zlib.vti", false, false, VoxelType::kFloat64},
    VolumeSample{"appended_base64.vti", false, false, VoxelType::kFloat64},
    VolumeSample{"appended_base64_zlib.vti", false, false, VoxelType::kUint16}};

INSTANTIATE_TEST_SUITE_P(Files, VolumeSampleFile, testing::ValuesIn(kVolumeSamples), [](const auto& test) {
  std::string name = test.param.file;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

// The recipe at the top of volume_formats.h: a new format is a row with a reader, and this test asks for its sample.
TEST(VolumeSamples, ThereIsOneOfEachFormatWhichAReaderReads) {
  std::set<std::string> read;
  for (const VolumeSample& sample : kVolumeSamples) {
    read.insert(readVolumeFile(volumeSample(sample.file)).volumes.front().facts().format);
  }
  for (const VolumeFormat& format : volumeFormats()) {
    EXPECT_TRUE(hasVolumeFileReader(format.name)) << format.name << ": add it to volume_reader_rows.h";
    EXPECT_TRUE(read.contains(std::string(format.name))) << format.name << ": add a file that another program wrote";
  }
  EXPECT_EQ(volumeFormats().size(), kVolumeFileReaders.size()) << "readers of formats that nobody finds";
}

// VTK writes no orientation into MetaImages, but their letters: the axes are those of LPS all the same.
TEST(VolumeSamples, ReadAMetaImageOfVtk) {
  const VolumeFile file = readVolumeFile(volumeSample("vtk.mha"));
  expectBlock(file.volumes.front(), markers(false), 0);
}

// Teem's plain NRRD says how far apart voxels are, and not where the first one is.
TEST(VolumeSamples, ReadANrrdWithoutASpace) {
  const VolumeFile file = readVolumeFile(volumeSample("teem_plain.nrrd"));
  std::map<double, glm::dvec3> expected = markers(false);
  for (auto& [value, position] : expected) {
    position -= glm::dvec3(-10, 20, 30);
  }
  expectBlock(file.volumes.front(), expected, 0);
  EXPECT_FALSE(file.volumes.front().grid().isAnatomical);
}

TEST(VolumeSamples, ReadASeriesWithItsTimes) {
  const VolumeFile file = readVolumeFile(volumeSample("series_nifti2.nii.gz"));
  EXPECT_THAT(file.times, testing::ElementsAre(0, 2.5, 5));
  ASSERT_EQ(file.volumes.size(), 3U);
  for (size_t at = 0; at < 3; ++at) {
    expectBlock(file.volumes[at], markers(false), static_cast<double>(at));
  }
}

TEST(VolumeSamples, ReadDicomSlicesOfSeveralTimes) {
  const VolumeFile file = readVolumeFile(volumeSample("dicom_times"));
  EXPECT_THAT(file.times, testing::ElementsAre(0, 0.4));
  ASSERT_EQ(file.volumes.size(), 2U);
  expectBlock(file.volumes[0], markers(false), 0);
  expectBlock(file.volumes[1], markers(false), 1);
}

TEST(VolumeSamples, KeepWhatDicomSaysOfItsValues) {
  const VolumeFacts facts = readVolumeFile(volumeSample("dicom_upright")).volumes.front().facts();
  EXPECT_EQ(facts.modality, "CT");
  EXPECT_EQ(facts.valueUnit, "HU");
  EXPECT_EQ(facts.format, "DICOM");
}

}  // namespace
}  // namespace ocelli
