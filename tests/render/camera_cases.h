// The cameras of the tests of renderers: each with a distortion, all of the small camera's size.
#pragma once

#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/camera/gpc_camera.h"
#include "oc_core/camera/reverse_pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

/// Regions of each sampling: one large, or two of which the second shows less than the pinhole.
inline GpcLayout oneRegion(const char* sampling, float zoom = 3) {
  return {findGpcSampling(sampling), {{{0.5f, 0.5f}, {0.4f, 0.4f}, zoom, 1.2f}}};
}
inline GpcLayout twoRegions(const char* sampling) {
  return {findGpcSampling(sampling),
          {{{0.3f, 0.45f}, {0.2f, 0.3f}, 4, 0.9f}, {{0.8f, 0.6f}, {0.15f, 0.3f}, 0.8f, 1.5f}}};
}

/// Calls visit(name, camera).
template <class Visit>
void forEachSmallCamera(const Visit& visit) {
  View narrow;
  narrow.zNear = 8;
  narrow.zFar = 13;
  visit("ppc", smallCamera());
  visit("rppc", ReversePinholeCamera(PinholeCamera(narrow, kWidth, kHeight), 10, 20));
  visit("spoc", SpocCamera(smallCamera(), {{40.3f, 28.7f}, 9, 11, 0, 6}));
  visit("spoc, d_n > 0", SpocCamera(smallCamera(), {{40.3f, 28.7f}, 9, 11, 2, 6}));
  visit("spoc, pole out of the image", SpocCamera(smallCamera(), {{-30, 70}, 9, 11, 0, 6}));
  visit("gpc, quadratic", GpcCamera(smallCamera(), oneRegion("quadratic")));
  visit("gpc, cubic", GpcCamera(smallCamera(), twoRegions("cubic")));
  visit("ddoc", DdocCamera(smallCamera(), wavyMap(kWidth, kHeight, 3, 40)));
}

}  // namespace ocelli::test
