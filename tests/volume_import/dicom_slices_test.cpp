#include "oc_core/volume/import/dicom_slices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Slices at these heights, of 4 x 3 pixels that are 0.5 mm apart.
std::vector<DicomSlice> slicesAt(const std::vector<double>& heights, double tilt = 0) {
  std::vector<DicomSlice> slices;
  for (const double height : heights) {
    DicomSlice& slice = slices.emplace_back();
    slice.file = "folder/s" + std::to_string(slices.size());
    slice.seriesUid = "1.2";
    slice.columns = 4;
    slice.rows = 3;
    slice.columnSpacing = slice.rowSpacing = 0.5;
    slice.alongColumns = {1, 0, 0};
    slice.alongRows = {0, 1, 0};
    slice.position = {1, 2 + tilt * height, height};
  }
  return slices;
}

VolumeGrid gridOf(std::vector<DicomSlice> slices) {
  VolumeRecord record;
  arrangeSlices(slices, record, "folder");
  return record.grid;
}

TEST(DicomSlices, AreSortedAlongTheirNormal) {
  std::vector<DicomSlice> slices = slicesAt({4, 0, 2});
  VolumeRecord record;
  arrangeSlices(slices, record, "folder");
  EXPECT_EQ(slices.front().position.z, 0);
  EXPECT_EQ(record.grid.size, glm::ivec3(4, 3, 3));
  EXPECT_EQ(record.grid.worldFromIndex[2], glm::dvec4(0, 0, 2, 0));
  EXPECT_EQ(record.grid.worldFromIndex[3], glm::dvec4(1, 2, 0, 1));
}

TEST(DicomSlices, OfATiltedGantryShearTheGrid) {
  EXPECT_EQ(gridOf(slicesAt({0, 2, 4}, 0.25)).worldFromIndex[2], glm::dvec4(0, 0.5, 2, 0));
}

TEST(DicomSlices, MayBeRounded) {
  EXPECT_NO_THROW(gridOf(slicesAt({0, 0.63, 1.25, 1.88, 2.5})));
}

TEST(DicomSlices, ThatMakeNoVolumeAreErrors) {
  const auto expect = [](const std::vector<DicomSlice>& slices, const std::string& message) {
    EXPECT_THAT([&] { gridOf(slices); }, ThrowsMessage<InputError>(HasSubstr(message)));
  };
  expect(slicesAt({0}), "but one slice");
  expect(slicesAt({0, 2, 2, 4}), "s2 and s3 stand in one place, at 2 mm");
  expect(slicesAt({0, 0, 2, 2, 4, 4}), "stand in one place");
  expect(slicesAt({0, 2, 8, 10, 12}), "2 slices are missing between s2 and s3, which are 6 mm apart, not 2 mm");
  expect(slicesAt({0, 2, 4, 5, 7}), "s3 and s4 are 1 mm apart, and most others 2 mm");
  std::vector<DicomSlice> slices = slicesAt({0, 2, 4});
  slices[1].columns = 5;
  expect(slices, "s2: this slice has 5 x 3 pixels");
  slices = slicesAt({0, 2, 4});
  std::swap(slices[1].alongColumns, slices[1].alongRows);
  expect(slices, "this slice is turned");
  slices = slicesAt({0, 2, 4});
  slices[1].rowSpacing = 0.6;
  expect(slices, "not as far apart");
  slices = slicesAt({0, 2, 4});
  slices[1].position.x += 1;
  expect(slices, "s2: this slice is 1 mm from where");
}

TEST(DicomSlices, OfSeveralTimesAreToldApart) {
  std::vector<DicomSlice> slices = slicesAt({0, 2, 0, 2});
  EXPECT_EQ(momentsOf(slices).size(), 1U) << "nothing tells them apart";
  for (size_t at = 0; at < slices.size(); ++at) {
    slices[at].temporalPosition = at < 2 ? 2 : 1;
  }
  const std::vector<DicomMoment> moments = momentsOf(slices);
  ASSERT_EQ(moments.size(), 2U);
  EXPECT_EQ(moments[0].slices[0].file, "folder/s3");
  EXPECT_EQ(moments[1].seconds, 2);
  EXPECT_TRUE(moments[1].isNumbered);
  slices[3].temporalPosition = 2;
  EXPECT_EQ(momentsOf(slices).size(), 1U) << "a time lacks a slice";
  // Scanners write trigger times to slices of one time, too.
  std::vector<DicomSlice> one = slicesAt({0, 2, 4});
  for (size_t at = 0; at < one.size(); ++at) {
    one[at].triggerSeconds = static_cast<double>(at);
  }
  EXPECT_EQ(momentsOf(one).size(), 1U);
}

TEST(DicomSlices, ThatAreMissingAtAnEndAreTold) {
  const auto told = [](const std::vector<DicomSlice>& slices) { return missingSlices(momentsOf(slices)).value_or(""); };
  std::vector<DicomSlice> slices = slicesAt({0, 2, 4, 6});
  EXPECT_EQ(told(slices), "") << "nothing says how many there should be";
  for (DicomSlice& slice : slices) {
    slice.imagesInAcquisition = 4;
  }
  EXPECT_EQ(told(slices), "");
  slices.pop_back();
  EXPECT_THAT(told(slices), AllOf(HasSubstr("4 images"), HasSubstr("has 3 of them")));
  // Two acquisitions of a series, of which one lacks an image.
  slices = slicesAt({0, 2, 4, 6, 8});
  for (size_t at = 0; at < slices.size(); ++at) {
    slices[at].acquisitionNumber = at < 2 ? "1" : "2";
    slices[at].imagesInAcquisition = at < 2 ? 2 : 3;
  }
  EXPECT_EQ(told(slices), "");
  slices.erase(slices.begin());
  EXPECT_THAT(told(slices), AllOf(HasSubstr("2 images"), HasSubstr("has 1 of them")));
}

TEST(DicomSlices, ThatAreMissingAtAnEndOfOneTimeAreTold) {
  std::vector<DicomSlice> slices = slicesAt({0, 2, 0, 2});
  for (size_t at = 0; at < slices.size(); ++at) {
    slices[at].temporalPosition = at < 2 ? 1 : 2;
    slices[at].slicesOfTime = 2;
    slices[at].imagesInAcquisition = 4;  // of both times
  }
  EXPECT_EQ(missingSlices(momentsOf(slices)), std::nullopt);
  for (DicomSlice& slice : slices) {
    slice.slicesOfTime = 3;
  }
  EXPECT_THAT(missingSlices(momentsOf(slices)).value_or(""), AllOf(HasSubstr("3 slices"), HasSubstr("there are 2")));
}

TEST(DicomSlices, BelongToTheSeriesThatIsChosen) {
  std::vector<DicomSlice> slices = slicesAt({0, 2, 4});
  slices[2].seriesUid = "1.3";
  slices[2].seriesNumber = "5";
  EXPECT_EQ(chooseSeries(slices, "1.2", "folder").size(), 2U);
  EXPECT_EQ(chooseSeries(slices, "5", "folder").size(), 1U);
  EXPECT_THAT([&] { chooseSeries(slices, "", "folder"); }, ThrowsMessage<InputError>(HasSubstr("2 series")));
  EXPECT_THAT([&] { chooseSeries(slices, "6", "folder"); }, ThrowsMessage<InputError>(HasSubstr("no series \"6\"")));
}

TEST(DicomSlices, OfTheChosenSeriesAloneMustBeSound) {
  std::vector<DicomSlice> slices = slicesAt({0, 2, 4});
  slices[2].seriesUid = "1.3";
  slices[2].unplaced = "nowhere";
  EXPECT_EQ(chooseSeries(slices, "1.2", "folder").size(), 2U);
  EXPECT_EQ(chooseSeries(slices, "", "folder").size(), 2U) << "a report beside the only volume";
  slices[0].seriesNumber = slices[1].seriesNumber = slices[2].seriesNumber = "7";
  EXPECT_EQ(chooseSeries(slices, "7", "folder").size(), 2U) << "which has its number";
  EXPECT_THAT([&] { chooseSeries(slices, "1.3", "folder"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("s3"), HasSubstr("nowhere"))));
  slices[1].malformed = "its slope is odd";
  EXPECT_THAT([&] { chooseSeries(slices, "1.2", "folder"); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("s2"), HasSubstr("its slope is odd"))));
  slices[2].malformed = "its slope is odd";
  EXPECT_THAT([&] { chooseSeries(slices, "", "folder"); }, ThrowsMessage<InputError>(HasSubstr("2 series")))
      << "what may be a volume is not passed over";
}

}  // namespace
}  // namespace ocelli
