#include "tests/feeds_calibration/calibration_rigs.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "oc_core/base/conventions.h"
#include "oc_core/feeds_calibration/lens_calibration.h"
#include "oc_core/feeds_calibration/pose_solver.h"
#include "oc_core/feeds_calibration/tag_detection.h"

namespace ocelli::test {
namespace {

constexpr glm::dvec3 kRoomLow(-3, 0, -4);
constexpr glm::dvec3 kRoomHigh(3, 2.8, 5);
constexpr double kTagMillimetres = 320;
constexpr size_t kBoardViews = 24;

double within(RandomNumbers& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

KnownTag tagAt(int id, const glm::dvec3& center, const glm::dvec3& normal) {
  const glm::dvec3 up(0, kTagMillimetres / 2000, 0);
  const glm::dvec3 right = glm::cross(up, normal);
  return {id, {center - right + up, center + right + up, center + right - up, center - right - up}};
}

KnownPlaces roomTags() {
  KnownPlaces places;
  int id = 0;
  for (const double y : {0.6, 2.1}) {
    for (const double x : {-2.0, 0.0, 2.0}) {
      places.tags.push_back(tagAt(id++, {x, y, kRoomLow.z}, {0, 0, 1}));
    }
  }
  for (const double z : {-2.5, -0.5}) {
    places.tags.push_back(tagAt(id++, {kRoomLow.x, 1.4, z}, {1, 0, 0}));
    places.tags.push_back(tagAt(id++, {kRoomHigh.x, 1.2, z}, {-1, 0, 0}));
  }
  return places;
}

bool reachesItsImage(const CalibrationRig& rig) {
  for (const double x : {0.0, 0.5, 1.0}) {
    for (const double y : {0.0, 0.5, 1.0}) {
      if (!directionOf(rig.lens, {x * rig.width, y * rig.height})) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

CalibrationRig calibrationRig(uint64_t seed) {
  RandomNumbers random(seed, 1);
  CalibrationRig rig;
  do {
    const double focal = within(random, 0.7, 1.5) * rig.width;
    rig.lens.focal = {focal, focal * within(random, 0.99, 1.01)};
    rig.lens.center = {rig.width * within(random, 0.48, 0.52), rig.height * within(random, 0.48, 0.52)};
    rig.lens.k1 = within(random, -0.3, 0.05);
    rig.lens.k2 = within(random, -0.02, 0.1);
    rig.lens.p1 = within(random, -1e-3, 1e-3);
    rig.lens.p2 = within(random, -1e-3, 1e-3);
    rig.lens.k3 = within(random, -0.01, 0.01);
  } while (!reachesItsImage(rig));
  rig.pose = {{within(random, -1.5, 1.5), within(random, 1, 2.5), within(random, 0.5, 3)},
              {within(random, -0.7, 0.7), within(random, 1, 1.6), kRoomLow.z},
              {within(random, -0.1, 0.1), 1, 0}};
  rig.places = roomTags();
  rig.noise = {within(random, 0.4, 0.9), within(random, 1, 4)};
  return rig;
}

std::vector<Image<Rgb8>> boardPictures(const CalibrationRig& rig, const CalibrationBoard& board, size_t count,
                                       RandomNumbers& random) {
  constexpr double kCellMillimetres = 4;
  const SheetCamera camera(rig.lens, rig.width, rig.height);
  const FeedPose origin{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}};
  RenderedSheet sheet = sheetOf(blackSquaresOf(board), kCellMillimetres);
  sheet.marginMetres = 0.02;
  const double width = sheet.across * sheet.cellMetres;
  const double height = sheet.below * sheet.cellMetres;
  std::vector<Image<Rgb8>> pictures;
  for (size_t i = 0; i < count; ++i) {
    // Its middle goes over the image, on a grid of 6 by 4 places.
    const glm::dvec2 place((static_cast<double>(i % 6) + within(random, 0, 1)) / 6,
                           (static_cast<double>(i / 6 % 4) + within(random, 0, 1)) / 4);
    const auto direction = directionOf(rig.lens, place * glm::dvec2(rig.width, rig.height));
    const double distance = width * rig.lens.focal.x / rig.width / within(random, 0.35, 0.7);
    const glm::dvec3 middle = glm::dvec3(direction->x, -direction->y, -1) * distance;
    const double tilt = radiansFromDegrees(within(random, 10, 40));
    const double around = within(random, 0, 6.283185307);
    const glm::dvec3 normal(std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), std::cos(tilt));
    const double roll = radiansFromDegrees(within(random, -20, 20));
    sheet.right = glm::normalize(glm::cross(glm::dvec3(std::sin(roll), std::cos(roll), 0), normal));
    sheet.down = glm::cross(sheet.right, normal);
    sheet.corner = middle - sheet.right * (width / 2) - sheet.down * (height / 2);
    pictures.push_back(camera.picture(origin, {sheet}, rig.noise, random));
  }
  return pictures;
}

Image<Rgb8> tagPicture(const CalibrationRig& rig, RandomNumbers& random) {
  std::vector<RenderedSheet> sheets;
  for (const KnownTag& tag : rig.places.tags) {
    RenderedSheet sheet = sheetOf(blackSquaresOfTag(tag.id, kTagMillimetres), kTagMillimetres / 8);
    sheet.corner = tag.corners[0];
    sheet.right = glm::normalize(tag.corners[1] - tag.corners[0]);
    sheet.down = glm::normalize(tag.corners[3] - tag.corners[0]);
    sheet.marginMetres = kTagMillimetres / 8000;
    sheets.push_back(sheet);
  }
  return SheetCamera(rig.lens, rig.width, rig.height).picture(rig.pose, sheets, rig.noise, random);
}

std::vector<glm::dvec3> seenPoints(const CalibrationRig& rig) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 16 * 12; ++i) {
    const auto d = directionOf(rig.lens, {(i % 16 + 0.5) / 16 * rig.width, (i / 16 + 0.5) / 12 * rig.height});
    const glm::dvec3 ray = rig.pose.forward() + rig.pose.right() * d->x + rig.pose.down() * d->y;
    double t = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
      const double wall = ray[axis] < 0 ? kRoomLow[axis] : kRoomHigh[axis];
      t = ray[axis] == 0 ? t : std::min(t, (wall - rig.pose.eye[axis]) / ray[axis]);
    }
    points.push_back(rig.pose.eye + ray * t);
  }
  return points;
}

RigErrors calibratedErrors(uint64_t seed) {
  const CalibrationRig rig = calibrationRig(seed);
  const CalibrationBoard board;
  RandomNumbers random(seed, 2);
  std::vector<BoardView> views;
  for (const Image<Rgb8>& picture : boardPictures(rig, board, kBoardViews, random)) {
    BoardView view = boardViewIn(picture, board);
    if (!view.empty()) {
      views.push_back(std::move(view));
    }
  }
  const LensCalibration lens = calibrateLens(differentViews(views, rig.width), rig.width, rig.height, "views");
  std::vector<WorldPoint> points;
  RigErrors errors;
  for (const SeenTag& tag : tagsIn(tagPicture(rig, random))) {
    const KnownTag* known = rig.places.tag(tag.id);
    if (known == nullptr) {
      throw std::runtime_error("a tag was found that is not there");
    }
    ++errors.tags;
    for (size_t c = 0; c < 4; ++c) {
      points.push_back({tag.corners[c], known->corners[c]});
    }
  }
  const SolvedPose solved = solvePose(points, lens.lens, "tags");
  errors.lensRms = lens.rmsPixels;
  errors.poseRms = solved.rmsPixels;
  const std::vector<glm::dvec3> seen = seenPoints(rig);
  for (const glm::dvec3& point : seen) {
    const auto truth = pixelOfPoint(rig.lens, rig.pose, point);
    const auto found = pixelOfPoint(lens.lens, solved.pose, point);
    const double error = found ? glm::distance(*truth, *found) : HUGE_VAL;
    errors.meanPixels += error / static_cast<double>(seen.size());
    errors.worstPixels = std::max(errors.worstPixels, error);
  }
  return errors;
}

}  // namespace ocelli::test
