// The cameras of the tests of renderers: each with a distortion, all of the small camera's size.
#pragma once

#include "oc_core/camera/ddoc_camera.h"
#include "oc_core/camera/reverse_pinhole_camera.h"
#include "oc_core/camera/spoc_camera.h"
#include "tests/ocri/test_scenes.h"

namespace ocelli::test {

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
  visit("ddoc", DdocCamera(smallCamera(), wavyMap(kWidth, kHeight, 3, 40)));
}

}  // namespace ocelli::test
