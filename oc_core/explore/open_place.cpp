// Where a walk through any scene begins.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "oc_core/base/conventions.h"
#include "oc_core/explore/explore_walker.h"

namespace ocelli {
namespace {

constexpr int kPlaces = 15;        // tried along each side of the scene
constexpr int kMaxFloors = 8;      // over each other
constexpr int kViews = 16;         // headings
constexpr double kFarMetres = 30;  // a view that is free so far is as good as any
constexpr double kPortalFrom = 3;  // metres, from where a portal is worth looking at
constexpr double kPortalTo = 20;
constexpr double kPortalWorth = 6;  // as much as so many metres of free view
constexpr double kRiseCost = 3;     // metres of free view for each that a floor lies higher: not on roofs

struct Place {
  WalkerView view;
  double worth = -1e30;
};

/// Free sight to each of the headings, metres, at most kFarMetres.
std::array<double, kViews> sightFrom(const ExploreScene& scene, const glm::dvec3& eye) {
  std::array<double, kViews> sight{};
  const double reach = kFarMetres * scene.metre();
  for (int i = 0; i < kViews; ++i) {
    const glm::dvec3 direction = headingOf({{}, 360.0 * i / kViews, 0});
    const auto hit = scene.cast(glm::vec3(eye), glm::vec3(direction), static_cast<float>(reach));
    sight[static_cast<size_t>(i)] = hit ? static_cast<double>(hit->distance) / scene.metre() : kFarMetres;
  }
  return sight;
}

/// The portal that is best looked at, and how many there are.
std::pair<const Portal*, int> portalsSeen(const ExploreScene& scene, const glm::dvec3& eye) {
  const Portal* best = nullptr;
  double nearest = kPortalTo * scene.metre();
  int seen = 0;
  for (const Portal& portal : scene.guides().portals) {
    const glm::dvec3 way = glm::dvec3(portal.center) - eye;
    const double distance = glm::length(way);
    if (distance < kPortalFrom * scene.metre() || distance > kPortalTo * scene.metre() ||
        !(glm::dot(way, glm::dvec3(portal.normal)) < 0) ||
        scene.cast(glm::vec3(eye), glm::vec3(way / distance), static_cast<float>(0.98 * distance))) {
      continue;
    }
    ++seen;
    if (distance < nearest) {
      nearest = distance;
      best = &portal;
    }
  }
  return {best, seen};
}

Place judged(const ExploreScene& scene, const glm::dvec3& eye, double rise) {
  const std::array<double, kViews> sight = sightFrom(scene, eye);
  Place place;
  double sum = 0;
  double farthest = -1;
  for (int i = 0; i < kViews; ++i) {
    const double free = sight[static_cast<size_t>(i)];
    sum += free;
    // A view that ends at something shows more than one out of the scene.
    const double shown = free < kFarMetres ? free : 0;
    if (shown > farthest) {
      farthest = shown;
      place.view.headingDegrees = 360.0 * i / kViews;
    }
  }
  const auto [portal, count] = portalsSeen(scene, eye);
  if (portal != nullptr) {
    place.view.headingDegrees = headingDegreesOf(glm::dvec3(portal->center) - eye);
  }
  const glm::dvec3 off = (eye - glm::dvec3(scene.bounds().center())) / scene.metre();
  place.view.eye = eye;
  place.worth = sum / kViews + kPortalWorth * std::min(count, 3) - kRiseCost * rise -
                0.1 * std::min(std::hypot(off.x, off.z), kFarMetres);
  return place;
}

/// Of the floors at a place of the plan, the eye over each where one can stand.
std::vector<glm::dvec3> eyesOver(const ExploreScene& scene, double x, double z, double eyeHeight) {
  const Box& bounds = scene.bounds();
  const auto head = static_cast<float>(eyeHeight);
  std::vector<glm::dvec3> eyes;
  float top = bounds.upper.y + head;
  for (int i = 0; i < kMaxFloors; ++i) {
    const glm::vec3 from(x, top, z);
    const auto hit = scene.cast(from, {0, -1, 0}, top - bounds.lower.y + head);
    if (!hit) {
      break;
    }
    const glm::vec3 standing = hit->position + glm::vec3(0, head * 0.02f, 0);
    if (hit->normal.y >= kFloorNormal && !scene.cast(standing, {0, 1, 0}, head * 1.05f)) {
      eyes.emplace_back(hit->position + glm::vec3(0, head, 0));
    }
    top = hit->position.y - std::max(1e-3f * head, 1e-5f * bounds.size().y);
  }
  return eyes;
}

/// Before the scene, so that all of it is in view.
WalkerView outside(const ExploreScene& scene, const WalkerOptions& options) {
  const auto radius = static_cast<double>(glm::length(scene.bounds().size())) / 2;
  const double slope = std::tan(radiansFromDegrees(options.fovHorizontal) / 2) * 0.55;
  return {glm::dvec3(scene.bounds().center()) + glm::dvec3(0, 0, radius * (1 + 1 / slope)), 0, 0};
}

}  // namespace

WalkerView openPlace(const ExploreScene& scene, const WalkerOptions& options) {
  const double eyeHeight = options.eyeHeight * scene.metre();
  const SceneGuides& guides = scene.guides();
  if (guides.maze) {
    const MazeCell cell = guides.maze->entrance ? guides.maze->entrance->cell : MazeCell{};
    const glm::dvec3 heading(vectorOf(guides.maze->entrance ? guides.maze->entrance->heading : Direction::kSouth));
    const double height = std::min(eyeHeight, 0.7 * static_cast<double>(guides.maze->wallHeight));
    return {glm::dvec3(guides.maze->centerOf(cell)) + glm::dvec3(0, height, 0), headingDegreesOf(heading), 0};
  }
  if (guides.path.size() >= 2) {
    const glm::dvec3 first(guides.path.front());
    const auto next = std::find_if(guides.path.begin(), guides.path.end(),
                                   [&](const glm::vec3& point) { return glm::distance(glm::dvec3(point), first) > 0; });
    return {first, next == guides.path.end() ? 0 : headingDegreesOf(glm::dvec3(*next) - first), 0};
  }
  const Box& bounds = scene.bounds();
  std::vector<glm::dvec3> eyes;
  double lowest = 1e30;
  for (int i = 0; i < kPlaces * kPlaces; ++i) {
    const glm::dvec2 share = (glm::dvec2(i % kPlaces, i / kPlaces) + 0.5) / static_cast<double>(kPlaces);
    const double x = glm::mix(bounds.lower.x, bounds.upper.x, share.x);
    const double z = glm::mix(bounds.lower.z, bounds.upper.z, share.y);
    for (const glm::dvec3& eye : eyesOver(scene, x, z, eyeHeight)) {
      eyes.push_back(eye);
      lowest = std::min(lowest, eye.y);
    }
  }
  Place best;
  for (const glm::dvec3& eye : eyes) {
    const Place place = judged(scene, eye, (eye.y - lowest) / scene.metre());
    if (place.worth > best.worth) {
      best = place;
    }
  }
  return eyes.empty() ? outside(scene, options) : best.view;
}

}  // namespace ocelli
