// A small measurement from end to end, and its reports.
#include "oc_core/remote_measure/remote_measure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/image_codec.h"
#include "oc_core/remote_measure/remote_measure_page.h"
#include "oc_core/remote_measure/remote_measure_report.h"
#include "oc_core/remote_measure/video_stream.h"
#include "oc_core/worlds/scene_source.h"
#include "tests/base/temporary_folder.h"

namespace ocelli {
namespace {

using testing::HasSubstr;

RemoteMeasureOptions smallOptions() {
  RemoteMeasureOptions options;
  options.scene = "builtin:statues";
  View view;
  options.path = remotePath("look-around", view, 60, 30);
  options.screen = {96, 54};
  options.settings.samples = 1;
  options.truthSamples = 2;
  options.links = {{30e3, 0.2}, {1e6, 0.02}};
  options.modes = {"gpc", "di"};
  options.jpegQualities = {50};
  options.rateFactors = {10, 30};
  options.every = 10;
  options.serverSeconds = 0.02;
  options.clientSeconds = 0.005;
  options.decodeSeconds = 0.002;
  return options;
}

const RemoteScene& measuredScene() {
  static const RemoteScene scene(loadScene("builtin:statues"));
  return scene;
}

TEST(RemoteMeasure, measuresEachModeOverEachLink) {
  RemoteMeasureOptions options = smallOptions();
  options.modes = {"gpc", "di", "jpeg"};
  std::vector<std::string> stages;
  const RemoteMeasurement measurement =
      measureRemote(measuredScene(), options, [&](std::string_view stage, double) { stages.emplace_back(stage); });
  EXPECT_FALSE(stages.empty());
  const bool hasJpeg = findColorCodec("jpeg") != nullptr;
  ASSERT_EQ(measurement.rows.size(), hasJpeg ? 8u : 4u);
  EXPECT_EQ(measurement.leftOut.size(), hasJpeg ? 0u : 1u);
  for (const ModeFigures& row : measurement.rows) {
    EXPECT_GT(row.bytes, 0u) << row.name();
    EXPECT_EQ(row.judged.size(), 6u) << row.name() << ": all at the same frames";
    EXPECT_GE(row.blackFrames, 1u) << row.name();
    EXPECT_LT(row.pictureFlip(), row.shown.meanFlip()) << row.name();
    EXPECT_LT(row.shown.meanFlip(), 0.3) << row.name();
    EXPECT_GT(row.shown.psnrDecibels(), 14) << row.name();
    EXPECT_EQ(row.lags.size(), 60u);
    EXPECT_EQ(row.judged.size(), row.shown.flips.size());
  }
  const ModeFigures& ours = measurement.rows[0];
  EXPECT_EQ(ours.link.roundTripSeconds, 0.2);
  EXPECT_TRUE(ours.withoutLatency.flips.empty());
  if (hasJpeg) {
    // With 0.2 s of delay what is shown is late: that is an error, and there is less of it over the faster link.
    const ModeFigures& late = measurement.rows[4];
    const ModeFigures& soon = measurement.rows[5];
    EXPECT_EQ(late.name(), "jpeg 50, asked");
    EXPECT_GT(late.shown.meanFlip(), late.withoutLatency.meanFlip());
    EXPECT_GT(late.shown.meanFlip(), soon.shown.meanFlip());
    EXPECT_GT(late.stalls.totalSeconds, soon.stalls.totalSeconds);
  }
}

TEST(RemoteMeasure, isTheSameEachTime) {
  const auto table = [] { return remoteMeasureTable(smallOptions(), measureRemote(measuredScene(), smallOptions())); };
  EXPECT_EQ(table(), table());
}

TEST(RemoteMeasure, comparesBytesAtEqualError) {
  RemoteMeasureOptions options = smallOptions();
  options.modes = {"gpc", "x264"};
  options.links.resize(1);
  const RemoteMeasurement measurement = measureRemote(measuredScene(), options);
  if (!measurement.leftOut.empty()) {
    GTEST_SKIP() << measurement.leftOut.front();
  }
  ASSERT_EQ(measurement.curves.size(), 1u);
  const std::vector<RatePoint>& points = measurement.curves[0].points;
  ASSERT_EQ(points.size(), 2u);
  EXPECT_GT(points[0].bytes, points[1].bytes);
  EXPECT_LT(points[0].flip, points[1].flip);
  const auto bytes = bytesOfEqualStream(measurement, "x264", measurement.rows[0]);
  // Over the frames since the first picture.
  const ModeFigures& ours = measurement.rows[0];
  ASSERT_GT(ours.blackFrames, 0u);
  const auto flipOf = [&](const std::vector<double>& flips) {
    double sum = 0;
    for (size_t i = ours.blackFrames; i < flips.size(); ++i) {
      sum += flips[i];
    }
    return sum / static_cast<double>(flips.size() - ours.blackFrames);
  };
  const std::vector<std::vector<double>>& flips = measurement.curves[0].flips;
  ASSERT_EQ(flips.size(), 2u);
  const double flip = flipOf(ours.shown.flips);
  EXPECT_NEAR(ours.pictureFlip(), flip, 1e-12);
  EXPECT_EQ(bytes.has_value(), flip >= flipOf(flips[0]) && flip <= flipOf(flips[1]));
  EXPECT_FALSE(bytesOfEqualStream(measurement, "x265", measurement.rows[0]));
}

TEST(RemoteMeasure, reportsWhatItMeasured) {
  const RemoteMeasureOptions options = smallOptions();
  RemoteMeasurement measurement = measureRemote(measuredScene(), options);
  measurement.leftOut.emplace_back("x265: ffmpeg is <not> installed");
  const std::string table = remoteMeasureTable(options, measurement);
  EXPECT_THAT(table, HasSubstr("left out: x265"));
  EXPECT_THAT(table, HasSubstr("30 KB/s, 200 ms"));
  const std::string csv = remoteMeasureCsv(measurement);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_EQ(std::count(csv.begin(), csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n')), ','), 20);
  const auto json = nlohmann::json::parse(remoteMeasureJson(options, measurement));
  ASSERT_EQ(json["modes"].size(), 4u);
  EXPECT_EQ(json["modes"][0]["mode"], "gpc");
  EXPECT_EQ(json["modes"][0]["bytes"], measurement.rows[0].bytes);
  EXPECT_EQ(json["settings"]["samples"], 1);

  const test::TemporaryFolder folder;
  writeRemoteMeasurePage(folder / ".", "1.2.3", options, measurement);
  const std::string page = remoteMeasurePage("1.2.3", options, measurement);
  EXPECT_THAT(page, HasSubstr("ffmpeg is &lt;not&gt; installed"));
  EXPECT_THAT(page, HasSubstr("<svg"));
  // Each picture that the page shows is there.
  size_t pictures = 0;
  for (size_t at = page.find("<img src=\""); at != std::string::npos; at = page.find("<img src=\"", at + 1)) {
    const size_t from = at + 10;
    EXPECT_TRUE(std::filesystem::exists(folder / page.substr(from, page.find('"', from) - from)));
    ++pictures;
  }
  EXPECT_GE(pictures, 3 * measurement.moments.size() - 2) << "the truth and two modes at each moment";
}

TEST(RemoteMeasure, knowsNoErrorOfWhatShowsNothing) {
  RemoteMeasureOptions options = smallOptions();
  options.modes = {"gpc"};
  options.links = {{1e3, 0.2}};
  const RemoteMeasurement measurement = measureRemote(measuredScene(), options);
  const ModeFigures& row = measurement.rows.at(0);
  EXPECT_FALSE(row.firstPictureSeconds);
  EXPECT_TRUE(row.shown.flips.empty());
  EXPECT_NEAR(row.stalls.longestSeconds, 2, 1e-9);
  const auto json = nlohmann::json::parse(remoteMeasureJson(options, measurement));
  EXPECT_TRUE(json["modes"][0]["errors"].is_null());
  EXPECT_TRUE(json["modes"][0]["first_picture_seconds"].is_null());
  const std::string table = remoteMeasureTable(options, measurement);
  EXPECT_EQ(table.find("inf"), std::string::npos);
  EXPECT_EQ(table.find("0.0000"), std::string::npos);
  EXPECT_EQ(remoteMeasurePage("1.2.3", options, measurement).find("\u221e"), std::string::npos);
}

TEST(RemoteMeasure, refusesWhatItDoesNotKnow) {
  RemoteMeasureOptions options = smallOptions();
  options.modes = {"gpc", "smoke"};
  try {
    measureRemote(measuredScene(), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("smoke"));
    EXPECT_THAT(error.what(), HasSubstr("x265"));
  }
  options.modes.clear();
  EXPECT_THROW(measureRemote(measuredScene(), options), InputError);
}

TEST(PictureErrors, areMeansAndRanks) {
  PictureErrors errors;
  EXPECT_EQ(errors.meanFlip(), 0);
  EXPECT_EQ(errors.flip95(), 0);
  for (int i = 1; i <= 20; ++i) {
    errors.add(0.01 * i, 0.001);
  }
  EXPECT_NEAR(errors.meanFlip(), 0.105, 1e-12);
  EXPECT_NEAR(errors.flip95(), 0.19, 1e-12);
  EXPECT_NEAR(errors.psnrDecibels(), 30, 1e-9);
}

}  // namespace
}  // namespace ocelli
