// Boards and poses: what they give, and what they refuse.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>

#include "oc_core/base/error.h"
#include "oc_core/feeds_calibration/calibrate_feeds.h"
#include "oc_core/feeds_calibration/calibration_sheet.h"

namespace ocelli::test {
namespace {

template <class Work>
std::string errorOf(const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const FeedLens kLens{{620, 626}, {318.5, 243}, -0.12, 0.03, 4e-4, -3e-4, 0.001};
const FeedPose kPose{{0.5, 2.2, 5}, {0, 1.3, -2.4}, {0.05, 1, 0}};

std::vector<WorldPoint> seenCorners(bool isMirrored) {
  std::vector<WorldPoint> points;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner((i & 1) == 0 ? -0.8 : 1.1, (i & 2) == 0 ? 0.3 : 2, (i & 4) == 0 ? -2 : 0.5);
    const glm::dvec3 told = isMirrored ? corner * glm::dvec3(-1, 1, 1) : corner;
    points.push_back({*pixelOfPoint(kLens, kPose, corner), told});
  }
  return points;
}

TEST(CalibrationBoard, isReadFromItsText) {
  EXPECT_EQ(boardFromText("8x5:32:24:4x4_100"), CalibrationBoard{});
  EXPECT_EQ(textOf(boardFromText("9x6:25")), "9x6:25");
  EXPECT_EQ(textOf(CalibrationBoard{}), kUsualBoard);
}

TEST(CalibrationBoard, refusesWhatIsNone) {
  for (const char* text : {"", "8x5", "8x5:32:24", "2x5:32", "8x5:nan", "8x5:32:31:4x4_100", "-8x5:32", "8x5:1e9"}) {
    EXPECT_NE(errorOf([&] { boardFromText(text); }).find("board"), std::string::npos) << text;
  }
  EXPECT_NE(errorOf([] { boardFromText("8x5:32:24:4x4_7"); }).find("is unknown; there are 4x4_50"), std::string::npos);
  EXPECT_NE(errorOf([] { boardFromText("20x20:32:24:4x4_100"); }).find("200 markers"), std::string::npos);
}

TEST(CalibrationSheet, isRefusedWhereItDoesNotFit) {
  EXPECT_EQ(calibrationSheetPdf({CalibrationBoard(), {}}, paperFromText("a4")).substr(0, 5), "%PDF-");
  EXPECT_NE(errorOf([] {
              calibrationSheetPdf({CalibrationBoard(), {}}, paperFromText("100x100"));
            }).find("does not fit"),
            std::string::npos);
  EXPECT_NE(errorOf([] {
              calibrationSheetPdf({{}, {0}, 400}, paperFromText("a4"));
            }).find("does not fit"),
            std::string::npos);
  EXPECT_NE(errorOf([] {
              calibrationSheetPdf({{}, {0}, 140}, paperFromText("a4"));
            }).find("squares of 139 mm"),
            std::string::npos);
  EXPECT_EQ(errorOf([] { calibrationSheetPdf({{}, {0}, 139}, paperFromText("a4")); }), "no error");
  EXPECT_NE(errorOf([] {
              calibrationSheetPdf({{}, {587}, 40}, paperFromText("a4"));
            }).find("no tag 587"),
            std::string::npos);
  EXPECT_NE(errorOf([] { paperFromText("b7"); }).find("no paper"), std::string::npos);
}

TEST(PoseSolver, findsThePoseOfExactPoints) {
  const SolvedPose solved = solvePose(seenCorners(false), kLens, "corners");
  EXPECT_LT(glm::distance(solved.pose.eye, kPose.eye), 1e-4);  // steps of the solver end below
  EXPECT_LT(glm::distance(solved.pose.forward(), kPose.forward()), 1e-4);
  EXPECT_LT(glm::distance(solved.pose.right(), kPose.right()), 1e-4);
  EXPECT_LT(solved.maxPixels, 0.01);
}

TEST(PoseSolver, findsAFocalLengthToo) {
  FeedLens pinhole;
  pinhole.focal = glm::dvec2(700);
  pinhole.center = {320, 240};
  std::vector<WorldPoint> points = seenCorners(false);
  for (WorldPoint& point : points) {
    point.pixel = *pixelOfPoint(pinhole, kPose, point.point);
  }
  EXPECT_NEAR(solvePoseAndFocal(points, 640, 480, "corners").lens.focal.x, 700, 1);
  points.resize(5);
  EXPECT_NE(errorOf([&] { solvePoseAndFocal(points, 640, 480, "corners"); }).find("6 are needed"), std::string::npos);
}

TEST(PoseSolver, refusesWhatGivesNoPose) {
  std::vector<WorldPoint> points = seenCorners(false);
  points.resize(3);
  EXPECT_NE(errorOf([&] { solvePose(points, kLens, "corners"); }).find("3 points"), std::string::npos);
  std::vector<WorldPoint> line(5);
  for (size_t i = 0; i < line.size(); ++i) {
    line[i] = {{100.0 + 50 * static_cast<double>(i), 200}, {static_cast<double>(i), 0, 0}};
  }
  EXPECT_NE(errorOf([&] { solvePose(line, kLens, "corners"); }).find("one line"), std::string::npos);
  EXPECT_NE(errorOf([] { solvePose(seenCorners(true), kLens, "corners"); }).find("mirrored"), std::string::npos);
}

/// The views of a chessboard that OpenCV's documentation brings along, and what its own file says of their lens:
/// 535.9 pixels by 13 views. Other corners, and a free aspect, move that by a few pixels.
TEST(LensCalibration, ofOpenCvsOwnPictures) {
  const std::filesystem::path folder = "/usr/share/doc/opencv-doc/examples/data";
  if (!std::filesystem::exists(folder / "left01.jpg")) {
    GTEST_SKIP() << "the package opencv-doc is not installed";
  }
  const std::filesystem::path views = std::filesystem::path(testing::TempDir()) / "ocelli_left_views";
  std::filesystem::create_directories(views);
  for (const char* number : {"01", "02", "03", "04", "05", "06", "07", "08", "09", "11", "12", "13", "14"}) {
    const std::string name = std::string("left") + number + ".jpg";
    std::filesystem::copy_file(folder / name, views / name, std::filesystem::copy_options::overwrite_existing);
  }
  const LensCalibration result = calibrateLensFrom(views.string(), boardFromText("9x6:25"));
  std::filesystem::remove_all(views);
  EXPECT_NEAR(result.lens.focal.x, 535.9, 8);
  EXPECT_NEAR(result.lens.center.x, 342.8, 5);
  EXPECT_LT(result.rmsPixels, 0.5);
  EXPECT_GE(result.views, 10u);
}

}  // namespace
}  // namespace ocelli::test
