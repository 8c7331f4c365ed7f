#include "oc_core/ocri/camera_option.h"

#include "oc_core/base/check.h"

namespace ocelli {
namespace {

using Choice = CameraChoice;

constexpr double kNoLimit = 1000;

/// Of a band around an edge, and what else is measured in pixels of the image.
constexpr const char* kPixels = "pixels";

constexpr CameraOption kFarDisplacement{
    .name = "far_displacement_per_height",
    .label = "displacement",
    .unit = "image heights",
    .meaning = "How far the farthest sample moves away from the pole: how much of what is hidden comes out",
    .place = [](Choice& c) -> float& { return c.spoc.farDisplacementPerHeight; },
    .min = 0,
    .max = 10,
    .formMax = 0.5};
constexpr CameraOption kMaskPole{
    .name = "mask_pole",
    .label = "mask pole",
    .unit = "",
    .meaning =
        "Begin to displace where the pole meets the object, which then covers the hole around the pole; otherwise at "
        "the nearest point of the object",
    .place = [](Choice& c) -> bool& { return c.spoc.maskPole; }};

constexpr CameraOption kMinAdded{.name = "min_added_pixels",
                                 .label = "smallest edge",
                                 .unit = kPixels,
                                 .meaning = "Steps of depth behind which the segment uncovers less are no edges",
                                 .place = [](Choice& c) -> float& { return c.eoc.minAddedPixels; },
                                 .min = 0.01,
                                 .max = kNoLimit,
                                 .formMin = 0.01,
                                 .formMax = 10,
                                 .isDetail = true};
constexpr CameraOption kCompact{.name = "compact",
                                .label = "compact",
                                .unit = "",
                                .meaning = "Bound the columns of an edge by what its occluder hides",
                                .place = [](Choice& c) -> bool& { return c.eoc.compact; },
                                .isDetail = true};
constexpr CameraOption kCompactSlack{.name = "compact_slack_pixels",
                                     .label = "slack",
                                     .unit = kPixels,
                                     .meaning = "Columns that compact leaves beyond that bound",
                                     .place = [](Choice& c) -> int& { return c.eoc.compactSlackPixels; },
                                     .min = 0,
                                     .max = kNoLimit,
                                     .formMax = 20,
                                     .isDetail = true};
constexpr CameraOption kBackgroundReach{
    .name = "background_reach_pixels",
    .label = "reach",
    .unit = kPixels,
    .meaning = "How far along its row an edge looks for the farthest surface behind it",
    .place = [](Choice& c) -> int& { return c.eoc.backgroundReachPixels; },
    .min = 1,
    .max = 100'000,
    .formMin = 1,
    .formMax = 200,
    .isDetail = true};
constexpr CameraOption kTrim{.name = "trim",
                             .label = "trim",
                             .unit = "",
                             .meaning = "Take out added columns that hold nothing",
                             .place = [](Choice& c) -> bool& { return c.eoc.trim; },
                             .isDetail = true};

constexpr CameraOption kReclaim{
    .name = "reclaim_pixels",
    .label = "reclaim pixels",
    .unit = "",
    .meaning = "Pixels that a shrunk splat has given up go to another one, and are not deleted",
    .place = [](Choice& c) -> bool& { return c.ddoc.reclaimPixels; },
    .isDetail = true};
/// Of both cameras that look for edges: a union has them alike.
constexpr CameraOption kEdgeDepthStep{
    .name = "edge_depth_step_radii",
    .label = "edges on z",
    .unit = "display radii",
    .meaning =
        "Edges are where z steps by more than its slopes explain, by this much; 0: where 1/z does, which no plane has",
    .place = [](Choice& c) -> float& { return c.ddoc.edgeDepthStepRadii; },
    .min = 0,
    .max = 100,
    .formMax = 0.5,
    .isDetail = true,
    .afterChange = [](Choice& c) { c.eoc.edgeDepthStepRadii = c.ddoc.edgeDepthStepRadii; }};

constexpr CameraOption kConstantRadius{
    .name = "constant_radius_pixels",
    .label = "constant radius",
    .unit = kPixels,
    .meaning = "The same splat radius for every edge, instead of one from the view cell",
    .place = [](Choice& c) -> float& { return c.ddoc.constantRadiusPixels; },
    .min = 0,
    .max = kNoLimit,
    .formMax = 60,
    .onOff = {
        .isOn = [](const Choice& c) { return c.ddoc.radius == DdocOptions::Radius::kConstant; },
        .turn = [](Choice& c,
                   bool on) { c.ddoc.radius = on ? DdocOptions::Radius::kConstant : DdocOptions::Radius::kViewCell; }}};
constexpr CameraOption kMaxHidden{.name = "most_hidden_pixels",
                                  .label = "most hidden",
                                  .unit = kPixels,
                                  .meaning = "Cap on the band that is fetched from behind an edge",
                                  .place = [](Choice& c) -> float& { return c.ddoc.maxHiddenPixels; },
                                  .min = 0,
                                  .max = kNoLimit,
                                  .formMax = 150};
constexpr CameraOption kSafetyFactor{.name = "safety_factor",
                                     .label = "safety",
                                     .unit = "",
                                     .meaning = "On the parallax over the view cell",
                                     .place = [](Choice& c) -> float& { return c.ddoc.safetyFactor; },
                                     .min = 0.01,
                                     .max = 100,
                                     .formMin = 0.1,
                                     .formMax = 3,
                                     .isDetail = true};
constexpr CameraOption kRoomPerHidden{
    .name = "room_per_hidden",
    .label = "room",
    .unit = "",
    .meaning = "Visible band for each pixel of the hidden one, where nothing competes for it",
    .place = [](Choice& c) -> float& { return c.ddoc.roomPerHidden; },
    .min = 0.01,
    .max = 100,
    .formMin = 0.05,
    .formMax = 3,
    .isDetail = true};
constexpr CameraOption kMaxHiddenPerRoom{
    .name = "most_hidden_per_room",
    .label = "squeeze",
    .unit = "",
    .meaning = "Hidden band for each pixel of the visible one, where edges compete: how hard samples are squeezed",
    .place = [](Choice& c) -> float& { return c.ddoc.maxHiddenPerRoom; },
    .min = 0.01,
    .max = 100,
    .formMin = 0.05,
    .formMax = 20,
    .isDetail = true};
constexpr CameraOption kBandGrowth{
    .name = "steepest_band_growth",
    .label = "band growth",
    .unit = "",
    .meaning = "How fast bands grow along a silhouette, pixels a pixel; 0 leaves them as they are",
    .place = [](Choice& c) -> float& { return c.ddoc.steepestBandGrowth; },
    .min = 0,
    .max = kNoLimit,
    .formMax = 20,
    .isDetail = true};
constexpr CameraOption kSmoothing{.name = "smoothing_sigma_pixels",
                                  .label = "smoothing",
                                  .unit = kPixels,
                                  .meaning = "Of the distortion field; 0 turns smoothing off",
                                  .place = [](Choice& c) -> float& { return c.ddoc.smoothingSigmaPixels; },
                                  .min = 0,
                                  .max = 50,
                                  .formMax = 8,
                                  .isDetail = true};
constexpr CameraOption kFeedbackRounds{.name = "feedback_rounds",
                                       .label = "feedback",
                                       .unit = "rounds",
                                       .meaning = "Most rounds of \"do no harm\"; 0 turns it off",
                                       .place = [](Choice& c) -> int& { return c.ddoc.feedbackRounds; },
                                       .min = 0,
                                       .max = 1000,
                                       .formMax = 8,
                                       .isDetail = true};
constexpr CameraOption kFeedbackShrink{.name = "feedback_shrink",
                                       .label = "shrink",
                                       .unit = "",
                                       .meaning = "What a round leaves of the hidden band of an edge that does harm",
                                       .place = [](Choice& c) -> float& { return c.ddoc.feedbackShrink; },
                                       .min = 0,
                                       .max = 1,
                                       .formMax = 1,
                                       .isDetail = true};
constexpr CameraOption kHarmless{.name = "harmless_per_hidden_pixel",
                                 .label = "harmless",
                                 .unit = "",
                                 .meaning = "Missing samples that an edge may cost for each pixel of its hidden band",
                                 .place = [](Choice& c) -> float& { return c.ddoc.harmlessPerHiddenPixel; },
                                 .min = 0,
                                 .max = kNoLimit,
                                 .formMax = 2,
                                 .isDetail = true};
constexpr CameraOption kLongestEdge{
    .name = "longest_edge_pixels",
    .label = "triangles",
    .unit = kPixels,
    .meaning = "Triangles are split until their edges are at most this long in the image",
    .place = [](Choice& c) -> float& { return c.ddoc.subdivision.longestEdgePixels; },
    .min = 0.1,
    .max = 100,
    .formMin = 0.1,
    .formMax = 8,
    .isDetail = true};

constexpr CameraOption kMaxSamples{.name = "most_samples",
                                   .label = "samples",
                                   .unit = "depth images",
                                   .meaning = "Most samples, relative to the depth image",
                                   .place = [](Choice& c) -> float& { return c.cell.maxSamples; },
                                   .min = 1,
                                   .max = 100,
                                   .formMin = 1,
                                   .formMax = 4};
constexpr CameraOption kMaxSatellites{.name = "most_satellites",
                                      .label = "satellites",
                                      .unit = "viewpoints",
                                      .meaning = "Viewpoints beside the reference that are tried",
                                      .place = [](Choice& c) -> int& { return c.cell.maxSatellites; },
                                      .min = 0,
                                      .max = 1000,
                                      .formMax = 64};

constexpr CameraStructure kGpcSampling{
    .name = "sampling",
    .meaning =
        "How samples spread between a region and the image around it; docs/general_pinhole.md shows what each does",
    .schema = [] { return gpcSamplingSchema(); },
    .text = [](const Choice& c) { return gpcSamplingText(c.gpc); },
    .read = [](JsonFields& fields, Choice& c) { readGpcLayout(fields, c.gpc); }};
constexpr CameraStructure kGpcRegions{
    .name = "regions",
    .meaning =
        "Rectangles of the image that show more detail, with a transition around each: within the image, and apart",
    .schema = [] { return gpcRegionsSchema(); },
    .text = [](const Choice& c) { return gpcRegionsText(c.gpc); },
    .read = [](JsonFields& fields, Choice& c) { readGpcLayout(fields, c.gpc); }};

}  // namespace

constinit const CameraOption kCellSide{
    .name = "cell_side_radii",
    .label = "view cell",
    .unit = "display radii",
    .meaning = "Side of the cube of viewpoints around the reference eye; 1.6 is 8 in",
    .place = [](Choice& c) -> float& { return c.cellSideRadii; },
    .min = 1e-3,
    .max = 100,
    .formMin = 0.1,
    .formMax = 4,
    .afterChange = [](Choice& c) { c.ddoc.cellSideRadii = c.cell.cell.sideRadii = c.cellSideRadii; }};
constinit const CameraOption kSegmentDirection{
    .name = "segment_direction",
    .label = "segment",
    .unit = "",
    .meaning = "The segment of viewpoints, along (right, up, backward) of the reference view",
    .place = [](Choice& c) -> glm::vec3& { return c.segmentDirection; },
    .min = -1,
    .max = 1,
    .formMin = -1,
    .formMax = 1};

const std::vector<const CameraOption*>& spocOptions() {
  static const std::vector<const CameraOption*> options{&kFarDisplacement, &kMaskPole};
  return options;
}
const std::vector<const CameraOption*>& eocOptions() {
  static const std::vector<const CameraOption*> options{&kMinAdded,        &kCompact, &kCompactSlack,
                                                        &kBackgroundReach, &kTrim,    &kEdgeDepthStep};
  return options;
}
const std::vector<const CameraOption*>& ddocOptions() {
  static const std::vector<const CameraOption*> options{
      &kConstantRadius, &kMaxHidden, &kSafetyFactor,   &kRoomPerHidden,  &kMaxHiddenPerRoom,
      &kBandGrowth,     &kSmoothing, &kFeedbackRounds, &kFeedbackShrink, &kHarmless,
      &kLongestEdge,    &kReclaim,   &kEdgeDepthStep};
  return options;
}
const std::vector<const CameraOption*>& cellOptions() {
  static const std::vector<const CameraOption*> options{&kMaxSamples, &kMaxSatellites};
  return options;
}

const std::vector<const CameraStructure*>& gpcStructures() {
  static const std::vector<const CameraStructure*> structures{&kGpcSampling, &kGpcRegions};
  return structures;
}

double numberOf(const CameraOption& option, const CameraChoice& choice) {
  CameraChoice copy = choice;
  if (const auto* real = std::get_if<float& (*)(CameraChoice&)>(&option.place)) {
    return static_cast<double>((*real)(copy));
  }
  if (const auto* integer = std::get_if<int& (*)(CameraChoice&)>(&option.place)) {
    return (*integer)(copy);
  }
  return std::get<bool& (*)(CameraChoice&)>(option.place)(copy) ? 1 : 0;
}

void setNumber(const CameraOption& option, CameraChoice& choice, double value) {
  if (const auto* real = std::get_if<float& (*)(CameraChoice&)>(&option.place)) {
    (*real)(choice) = static_cast<float>(value);
  } else if (const auto* integer = std::get_if<int& (*)(CameraChoice&)>(&option.place)) {
    (*integer)(choice) = static_cast<int>(value);
  } else {
    std::get<bool& (*)(CameraChoice&)>(option.place)(choice) = value != 0;
  }
  if (option.afterChange != nullptr) {
    option.afterChange(choice);
  }
}

glm::vec3 directionOf(const CameraOption& option, const CameraChoice& choice) {
  CameraChoice copy = choice;
  return std::get<glm::vec3& (*)(CameraChoice&)>(option.place)(copy);
}

void setDirection(const CameraOption& option, CameraChoice& choice, const glm::vec3& direction) {
  std::get<glm::vec3& (*)(CameraChoice&)>(option.place)(choice) = direction;
}

bool isInteger(const CameraOption& option) {
  return std::holds_alternative<int& (*)(CameraChoice&)>(option.place);
}
bool isBoolean(const CameraOption& option) {
  return std::holds_alternative<bool& (*)(CameraChoice&)>(option.place);
}
bool isDirection(const CameraOption& option) {
  return std::holds_alternative<glm::vec3& (*)(CameraChoice&)>(option.place);
}

}  // namespace ocelli
