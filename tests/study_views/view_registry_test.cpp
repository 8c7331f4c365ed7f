#include "study/views/view_registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oc_core/base/error.h"
#include "tests/study_views/view_examples.h"

namespace ocelli::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ViewRegistry, RowsAreWhole) {
  for (const ViewKind& kind : viewKinds()) {
    EXPECT_FALSE(kind.name.empty());
    EXPECT_FALSE(kind.description.empty());
    EXPECT_NE(kind.read, nullptr);
    EXPECT_THAT(viewNames(), HasSubstr(kind.name));
  }
}

TEST(ViewRegistry, SaysWhatIsWrongWithAView) {
  EXPECT_THAT(errorOfView(R"("hologram")"), AllOf(HasSubstr("\"view\""), HasSubstr("hologram"), HasSubstr("pinhole")));
  EXPECT_THAT(errorOfView(R"({"kind": "hologram"})"), AllOf(HasSubstr("\"kind\""), HasSubstr("ocri")));
  EXPECT_THAT(errorOfView("3"), HasSubstr("must be one of"));
  EXPECT_THAT(errorOfView("{}"), HasSubstr("\"kind\""));
  EXPECT_THAT(errorOfView(R"({"kind": "pinhole", "fov": 3})"), HasSubstr("fov"));
  EXPECT_THAT(errorOfView(R"({"kind": "panes"})"), HasSubstr("headings_degrees"));
  EXPECT_THAT(errorOfView(R"({"kind": "panes", "headings_degrees": []})"), HasSubstr("1 to 8"));
  EXPECT_THAT(errorOfView(R"({"kind": "panes", "headings_degrees": [500]})"), HasSubstr("headings_degrees"));
  EXPECT_THAT(errorOfView(R"({"kind": "ocri", "camera": "ddoc"})"), HasSubstr("eye_offset_meters"));
  EXPECT_THAT(errorOfView(R"({"kind": "ocri", "eye_offset_meters": [0, 0, 0]})"), HasSubstr("camera"));
  EXPECT_THAT(errorOfView(R"({"kind": "ocri", "camera": "lens", "eye_offset_meters": [0, 0, 0]})"),
              HasSubstr("no camera \"lens\""));
  EXPECT_THAT(errorOfView(R"({"kind": "camera", "camera": 3})"), HasSubstr("must be the name of a camera"));
  EXPECT_THAT(errorOfView(R"({"kind": "camera", "camera": {"camera": "ddoc", "lens": 1}})"), HasSubstr("lens"));
  EXPECT_EQ(errorOfView(R"({"kind": "camera", "camera": {"camera": "ddoc", "smoothing_sigma_pixels": 1}})"), "");
  EXPECT_THAT(errorOfView(R"({"kind": "ocri", "camera": "ddoc", "eye_offset_meters": [0, 0, 99]})"),
              HasSubstr("eye_offset_meters"));
  EXPECT_THAT(errorOfView(R"({"kind": "display", "profile": "cube"})"), HasSubstr("must be one of perspecta"));
  EXPECT_THAT(errorOfView(R"({"kind": "display", "profile": "/tmp/profile.json"})"), HasSubstr("must be one of"));
  EXPECT_THAT(errorOfView(R"({"kind": "display", "profile": 3})"), HasSubstr("must be one of"));
  EXPECT_THAT(errorOfView(R"({"kind": "display", "profile": {"name": "mine"}})"), HasSubstr("\"profile\""));
  EXPECT_EQ(errorOfView(R"({"kind": "display", "profile": {"name": "mine", "radius_metres": 0.1, "width": 64,
                            "height": 64, "slices_per_half_turn": 16, "rotations_per_minute": 600}})"),
            "");
  EXPECT_THAT(errorOfView(R"({"kind": "display", "distance_meters": 4, "radius_meters": 3})"),
              HasSubstr("outside of the display"));
  EXPECT_THAT(errorOfView(R"({"kind": "camera", "camera": "geometry"})"), HasSubstr("no image"));
}

TEST(ViewRegistry, RefusesRowsThatNobodyCouldUse) {
  EXPECT_THROW(registerView({"", "nothing", viewKinds().front().get().read}), InputError);
  EXPECT_THROW(registerView({"mirror", "a mirror", nullptr}), InputError);
  EXPECT_THROW(registerView({"ocri", "again", viewKinds().front().get().read}), InputError);
}

}  // namespace
}  // namespace ocelli::test
