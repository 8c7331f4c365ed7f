#include "oc_core/feeds_place/opening_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "oc_core/feeds/feed_graph.h"

namespace ocelli {
namespace {

constexpr double kToWalls = 0.5;  ///< metres: walls so near to the sides of an opening are its jambs
constexpr double kSlide = 0.25;   ///< metres that an opening is moved to where it has jambs: maps are made of squares
constexpr double kSlideStep = 0.01;
constexpr double kMinBefore = 0.1;     ///< metres that a camera stands before an opening
constexpr double kJustBefore = 0.995;  ///< of a line of sight, so that what stands at its end hides nothing
constexpr double kOffJamb = 0.05;      ///< metres from a jamb, so that rays do not begin in the wall
constexpr double kMaxWidening = 3;     ///< of the width of a face, as it is turned
constexpr std::array<double, 3> kHeights{0.3, 0.5, 0.7};  ///< of a face, at which walls are looked for

glm::dvec3 level(const glm::dvec3& v) {
  return {v.x, 0, v.z};
}

glm::dvec3 turnedLevel(const glm::dvec3& v, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, -s * v.x + c * v.z};
}

bool isNearWall(const glm::dvec3& center, const glm::dvec3& half, const PlaceWalls& walls) {
  const double length = glm::length(half);
  return walls.distance(center, half / length, length + kToWalls) < length + kToWalls;
}

/// The middle of an opening where walls stand on both of its sides, as near as there is such a place.
glm::dvec3 betweenJambs(const Portal& opening, const PlaceWalls& walls) {
  const glm::dvec3 center(opening.center);
  const glm::dvec3 right(opening.halfRight);
  for (double way = 0; way <= kSlide; way += kSlideStep) {
    for (const double sign : {1.0, -1.0}) {
      const glm::dvec3 moved = center + sign * way * glm::dvec3(opening.normal);
      if (isNearWall(moved, right, walls) && isNearWall(moved, -right, walls)) {
        return moved;
      }
    }
  }
  return center;
}

}  // namespace

double PlaceWalls::distance(const glm::dvec3& from, const glm::dvec3& direction, double reach) const {
  const auto met = tree_.meet(glm::vec3(from), glm::vec3(direction), reach);
  return met ? met->share : reach;
}

bool PlaceWalls::isFree(const glm::dvec3& from, const glm::dvec3& to) const {
  return !tree_.meet(glm::vec3(from), glm::vec3(to - from), kJustBefore);
}

FaceCorners faceOf(const Portal& opening, const PlaceWalls& walls) {
  const glm::dvec3 center = betweenJambs(opening, walls);
  const auto reach = [&](const glm::dvec3& half) {
    const double length = glm::length(half);
    const double limit = length + kToWalls;
    const double met = walls.distance(center, half / length, limit);
    return half * (met < limit ? std::max(1.0, met / length) : 1.0);
  };
  const glm::dvec3 right = reach(glm::dvec3(opening.halfRight));
  const glm::dvec3 left = reach(-glm::dvec3(opening.halfRight));
  const glm::dvec3 up = reach(glm::dvec3(opening.halfUp));
  const glm::dvec3 down = reach(-glm::dvec3(opening.halfUp));
  return {center + left + down, center + left + up, center + right + up, center + right + down};
}

bool seesMiddle(const Feed& feed, const Portal& opening, const PlaceWalls& walls) {
  const glm::dvec3 middle(opening.center);
  const auto pixel = feedPixelOf(feed, middle);
  return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= feed.width && pixel->y <= feed.height &&
         walls.isFree(feed.pose.eye, middle);
}

bool looksThrough(const Feed& feed, const glm::dvec3& eye, const Portal& opening, const PlaceWalls& walls) {
  const glm::dvec3 middle(opening.center);
  const glm::dvec3 normal(opening.normal);
  const double feedHeight = glm::dot(feed.pose.eye - middle, normal);
  const double eyeHeight = glm::dot(eye - middle, normal);
  if (std::abs(feedHeight) < kMinBefore || std::abs(eyeHeight) < kMinBefore || feedHeight * eyeHeight < 0 ||
      !seesMiddle(feed, opening, walls)) {
    return false;
  }
  for (const double right : {-0.8, 0.0, 0.8}) {
    for (const double up : {-0.8, 0.0, 0.8}) {
      const glm::dvec3 point = middle + right * glm::dvec3(opening.halfRight) + up * glm::dvec3(opening.halfUp);
      if (walls.isFree(eye, point)) {
        return true;
      }
    }
  }
  return false;
}

double angleTowards(const FaceCorners& face, const glm::dvec3& eye) {
  const glm::dvec3 along = level(face[3] - face[0]);
  const glm::dvec3 away = level(eye - (face[0] + face[2]) * 0.5);
  const double sine = std::abs(glm::dot(along, away)) / (glm::length(along) * glm::length(away));
  return std::asin(std::min(1.0, sine));
}

FaceCorners turnedFace(const FaceCorners& face, const glm::dvec3& eye, double angle, const PlaceWalls& walls) {
  const bool isFirstNearer = glm::length(level(face[0] - eye)) <= glm::length(level(face[3] - eye));
  const glm::dvec3 bottom = isFirstNearer ? face[0] : face[3];
  const glm::dvec3 top = isFirstNearer ? face[1] : face[2];
  const glm::dvec3 along = level((isFirstNearer ? face[3] : face[0]) - bottom);
  const double width = glm::length(along);
  glm::dvec3 direction = along / width;
  // Of both ways to turn, the one by which it faces the eye more.
  const auto facing = [&](const glm::dvec3& d) {
    const glm::dvec3 end = bottom + d * width;
    return angleTowards({bottom, top, end + (top - bottom), end}, eye);
  };
  const glm::dvec3 one = turnedLevel(direction, angle);
  const glm::dvec3 other = turnedLevel(direction, -angle);
  direction = facing(one) < facing(other) ? one : other;
  double length = 0;
  const double reach = kMaxWidening * width;
  for (const double height : kHeights) {
    length = std::max(
        length, kOffJamb + walls.distance(bottom + height * (top - bottom) + kOffJamb * direction, direction, reach));
  }
  length = length > reach ? width : length;
  const glm::dvec3 end = bottom + direction * length;
  return {bottom, top, end + (top - bottom), end};
}

}  // namespace ocelli
