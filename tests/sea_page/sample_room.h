// A room whose colours say where they are, and the images of a sea in it, worked out ray by ray.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "oc_core/base/conventions.h"
#include "oc_core/sea_page/sea_page.h"

namespace ocelli::test {

inline constexpr glm::dvec3 kRoomLower{-3, 0, -2};
inline constexpr glm::dvec3 kRoomUpper{3, 3, 2};

/// Where a ray from within the room meets it.
inline glm::dvec3 roomHit(const glm::dvec3& eye, const glm::dvec3& ray) {
  double nearest = 1e9;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    if (ray[axis] != 0) {
      nearest = std::min(nearest, ((ray[axis] > 0 ? kRoomUpper : kRoomLower)[axis] - eye[axis]) / ray[axis]);
    }
  }
  return eye + ray * nearest;
}

inline Image<Rgb8> roomImage(const SeaPagePlace& place, int width, int height) {
  Image<Rgb8> image(width, height);
  const glm::dvec3 right = glm::cross(place.forward, place.up);
  for (int y = 0; y < height; ++y) {
    const double latitude = kPi * (0.5 - (y + 0.5) / height);
    for (int x = 0; x < width; ++x) {
      const double longitude = 2 * kPi * ((x + 0.5) / width - 0.5);
      const glm::dvec3 ray = std::cos(latitude) * (std::cos(longitude) * place.forward + std::sin(longitude) * right) +
                             std::sin(latitude) * place.up;
      const glm::dvec3 share = (roomHit(place.eye, ray) - kRoomLower) / (kRoomUpper - kRoomLower);
      image(x, y) = Rgb8(glm::clamp(share * 255.0 + 0.5, 0.0, 255.0));
    }
  }
  return image;
}

/// Five by four places half a metre apart, each turned another way.
inline SeaPage roomSea() {
  SeaPage page;
  page.title = "A room & its <images>";
  for (int k = 0; k < 20; ++k) {
    const double turn = radiansFromDegrees(37.0 * k);
    SeaPagePlace place;
    place.eye = {-1.0 + 0.5 * (k % 5), 1.6 + 0.01 * (k % 3), -0.75 + 0.5 * (k / 5)};
    place.forward = {std::sin(turn), 0, -std::cos(turn)};
    page.places.push_back(place);
  }
  page.proxy = Box{glm::vec3(kRoomLower), glm::vec3(kRoomUpper)};
  page.quality = 95;
  return page;
}

}  // namespace ocelli::test
