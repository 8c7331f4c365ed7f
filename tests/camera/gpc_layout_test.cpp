#include "oc_core/camera/gpc_layout.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

using ::testing::HasSubstr;

std::string complaintOf(const std::vector<GpcRegion>& regions, const char* sampling = "cubic") {
  try {
    validate({findGpcSampling(sampling), regions}, "here");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

GpcLayout layoutFrom(const std::string& text) {
  const nlohmann::json json = parseJson(text, "test");
  JsonFields fields(json, "test");
  GpcLayout layout;
  readGpcLayout(fields, layout);
  fields.rejectUnknown();
  return layout;
}

TEST(GpcLayout, regionsMustLieWithinTheImage) {
  EXPECT_EQ(complaintOf({GpcRegion{}}), "") << "the default reaches from border to border";
  EXPECT_THAT(complaintOf({{{0.4f, 0.5f}, {0.5f, 0.5f}, 2, 1}}), HasSubstr("here, region 1"));
  EXPECT_THAT(complaintOf({{{0.4f, 0.5f}, {0.5f, 0.5f}, 2, 1}}), HasSubstr("from (-0.1, 0) to (0.9, 1)"));
}

TEST(GpcLayout, regionsMustLieApart) {
  const GpcRegion left{{0.25f, 0.5f}, {0.25f, 0.5f}, 3, 1};
  const GpcRegion right{{0.75f, 0.5f}, {0.25f, 0.5f}, 3, 1};
  EXPECT_EQ(complaintOf({left, right}), "") << "they may touch";
  GpcRegion moved = right;
  moved.center.x = 0.74f;
  EXPECT_THAT(complaintOf({left, moved}), HasSubstr("region 1 overlap by 0.01 x 1"));
}

TEST(GpcLayout, transitionsMustNotFold) {
  GpcRegion minified{{0.5f, 0.5f}, {0.4f, 0.4f}, 0.7f, 0.5f};
  // zoom > 1 / outer and zoom > (outer + 1) / (2 outer) = 0.8333 with outer = 1.5.
  EXPECT_EQ(complaintOf({minified}, "linear"), "");
  EXPECT_THAT(complaintOf({minified}, "quadratic"), HasSubstr("zoom by more than 0.8333"));
  minified.zoom = 0.84f;
  EXPECT_EQ(complaintOf({minified}, "quadratic"), "");
  minified.zoom = 20;
  minified.transitionWidth = 0.01f;
  EXPECT_EQ(complaintOf({minified}), "") << "never from a zoom of 1 on";
}

TEST(GpcLayout, numbersMustBeInTheirRanges) {
  constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();
  for (const float wrong : {kNoNumber, -1.0f, 1000.0f}) {
    GpcRegion region;
    region.zoom = wrong;
    EXPECT_THAT(complaintOf({region}), HasSubstr("\"zoom\""));
    region = {};
    region.transitionWidth = wrong;
    EXPECT_THAT(complaintOf({region}), HasSubstr("\"transition_width\""));
    region = {};
    region.center.y = wrong;
    EXPECT_THAT(complaintOf({region}), HasSubstr("\"center\""));
    region = {};
    region.extent.x = wrong;
    EXPECT_THAT(complaintOf({region}), HasSubstr("\"extent\""));
  }
}

TEST(GpcLayout, readsWhatItWrites) {
  const GpcLayout layout{findGpcSampling("quadratic"),
                         {{{0.25f, 0.5f}, {0.25f, 0.5f}, 3, 1}, {{0.75f, 0.3f}, {0.1f, 0.125f}, 6.5f, 0.3f}}};
  EXPECT_EQ(layoutFrom(jsonText(layout)), layout);
  EXPECT_EQ(layoutFrom("{}"), GpcLayout{});
  EXPECT_EQ(layoutFrom(R"({"regions": [{"zoom": 3}]})").regions[0].zoom, 3);
}

TEST(GpcLayout, wrongFieldsAreNamed) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      layoutFrom(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(complaint(R"({"sampling": "quartic"})"), HasSubstr("\"sampling\""));
  EXPECT_THAT(complaint(R"({"regions": []})"), HasSubstr("\"regions\""));
  EXPECT_THAT(complaint(R"({"regions": [{"zoom": 100}]})"), HasSubstr("\"zoom\""));
  EXPECT_THAT(complaint(R"({"regions": [{"size": 1}]})"), HasSubstr("\"size\""));
  EXPECT_THAT(complaint(R"({"regions": [{}, {"center": [0.5]}]})"), HasSubstr("\"regions\" 2"));
  EXPECT_THAT(complaint(R"({"regions": [{"extent": [0.9, 0.5]}]})"), HasSubstr("region 1"));
}

}  // namespace
}  // namespace ocelli
