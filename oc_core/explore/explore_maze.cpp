// Shows all ways that leave the crossing or room ahead, and, at the left, behind (section 4.3.1.4). A click on a way,
// or a turn to its side before the crossing, goes into it in four steps.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/constructor/walk_turn.h"
#include "oc_core/explore/explore_message.h"
#include "oc_core/explore/live_constructor_rows.h"
#include "oc_core/explore/split_visibility.h"

namespace ocelli {
namespace {

/// Of each of the four steps of a turn. The second moves all that is ahead, the third all that is behind.
constexpr std::array<double, 4> kStepSeconds{1.2, 1.8, 2.4, 1.5};
constexpr double kMazeTurnShare = 0.8;    // of the image, both parts turn
constexpr double kMazeDeployShare = 0.5;  // what is behind takes half of the image from what is ahead
/// The phase from which on the image ahead is a pinhole's before the chosen way. In the one before, rays come in almost
/// parallel, at the slant of the crossing: the way is as tall as in the pinhole's, but not quite as wide. So it
/// dissolves.
constexpr double kPinholeAhead = 3;
constexpr double kTurnWish = 0.9;    // of the full speed of turning, from which on one wants to turn at the crossing
constexpr double kTurnWithin = 2.5;  // sizes of the crossing, from its middle, from where one may

constexpr double kMinFov = 10;  // degrees, of the image behind

/// Of the image behind, which slides in from the left: while it is narrow it shows no more than 90 degrees from top to
/// bottom.
double fovBehind(double fovHorizontal, const glm::ivec2& size) {
  const double widest = degreesFromRadians(2 * std::atan(static_cast<double>(size.x) / size.y));
  return std::clamp(widest, kMinFov, fovHorizontal);
}

/// The phase of a turn, so much later.
double later(double phase, double seconds) {
  while (phase < kStepSeconds.size() && seconds > 0) {
    const auto step = static_cast<size_t>(phase);
    const double left = (static_cast<double>(step + 1) - phase) * kStepSeconds[step];
    if (seconds < left) {
      return phase + seconds / kStepSeconds[step];
    }
    seconds -= left;
    phase = static_cast<double>(step + 1);
  }
  return phase;
}

enum class MazeOption : size_t { kLeft, kAhead, kRight, kCrossingShare, kFovWay, kBehind };

class LiveMaze final : public LiveConstructor {
 public:
  LiveCamera camera(const LiveMoment& moment) override {
    if (!space_) {
      space_.emplace(*moment.scene.walkMap());
    }
    const WalkCameraOptions options = cameraOptions(moment);
    const glm::ivec2 size(moment.view.width(), moment.view.height());
    LiveCamera live = turn_ ? turning(options, size, moment) : walking(options, size, moment);
    const auto* ahead = std::get_if<GraphCamera>(&live.camera);
    if (moment.seconds > 0 && moment.deployed > 0) {
      splits_ = ahead_.next(*ahead, moment.scene);
      splitsBehind_ =
          live.behind ? behind_.next(std::get<GraphCamera>(*live.behind), moment.scene) : std::vector<SplitLine>{};
    }
    live.splits = splits_;
    live.splitsBehind = splitsBehind_;
    live.dissolves = std::exchange(dissolves_, false);
    return live;
  }

  std::optional<WalkerView> lead(const LiveMoment& moment, const WalkInput& input) override {
    if (const std::optional<uint32_t> portal = std::exchange(wish_, std::nullopt)) {
      begin(moment, *portal);
    }
    if (input.forward != 0) {
      refused_.clear();
    }
    if (!turn_ && space_ && std::abs(input.turnRight) >= kTurnWish) {
      turnAtCrossing(moment, input.turnRight > 0 ? 2 : 0);
    }
    if (!turn_) {
      return std::nullopt;
    }
    const double before = turn_->phase;
    turn_->phase = later(before, moment.seconds);
    dissolves_ = before < kPinholeAhead && turn_->phase >= kPinholeAhead;
    WalkerView view = between(turnFrom_, turnTo_, std::clamp(turn_->phase / 4, 0.0, 1.0));
    if (turn_->phase >= 4) {
      turn_.reset();
      view = turnTo_;
    }
    return view;
  }

  /// Level, along the tunnel where the walker stands in one.
  std::optional<WalkerView> wantedView(const LiveMoment& moment) override {
    if (!space_) {
      space_.emplace(*moment.scene.walkMap());
    }
    // The walker is somewhere else: a turn that was begun is over.
    turn_.reset();
    wish_.reset();
    WalkerView view = moment.walker;
    view.pitchDegrees = 0;
    const std::optional<uint32_t> cell = space_->cellAt(view.eye);
    if (cell && space_->map().cells[*cell].kind == WalkCellKind::kTunnel) {
      const glm::dvec3 axis(space_->map().cells[*cell].axis);
      view.headingDegrees = headingDegreesOf(glm::dot(axis, headingOf(view)) < 0 ? -axis : axis, view.headingDegrees);
    }
    return view;
  }

  bool picksAtOnce() const override { return true; }
  bool busy() const override { return turn_.has_value(); }
  bool looksLevel() const override { return true; }
  bool showsBehind() const override { return shows(MazeOption::kBehind) > 0; }
  bool accepts(const ExploreScene& /*scene*/, const ExplorePick& pick) const override {
    return !turn_ && wayThrough(pick) != nullptr;
  }
  void pick(const ExploreScene& /*scene*/, const ExplorePick& pick) override {
    if (const WalkWay* way = turn_ ? nullptr : wayThrough(pick)) {
      wish_ = way->portal;
    }
  }

  double option(size_t index) const override { return values_[index]; }
  void setOption(size_t index, double value) override { values_[index] = value; }

 private:
  double shows(MazeOption option) const { return values_[static_cast<size_t>(option)]; }

  WalkCameraOptions cameraOptions(const LiveMoment& moment) const {
    WalkCameraOptions options;
    const double sum = values_[0] + values_[1] + values_[2];
    options.split = {1.0 / 3, 1.0 / 3, 1.0 / 3};  // where all are at 0
    if (sum > 1e-6) {
      options.split = {values_[0] / sum, values_[1] / sum, values_[2] / sum};
    }
    options.crossingShare = shows(MazeOption::kCrossingShare);
    options.fovWayDegrees = shows(MazeOption::kFovWay);
    options.fovHorizontalDegrees = moment.walkerOptions.fovHorizontal;
    options.lowered = moment.deployed;
    return options;
  }

  static WalkPose poseOf(const WalkerView& view) { return {view.eye, headingOf(view)}; }

  /// As far deployed as both the pose and the moment say.
  WalkCamera made(WalkCameraOptions options, const glm::ivec2& size, const LiveMoment& moment) const {
    WalkCamera camera = makeWalkCamera(*space_, poseOf(moment.walker), options, size.x, size.y);
    if (moment.deployed < 1) {
      options.deployed = camera.deployed * moment.deployed;
      WalkCamera partly = makeWalkCamera(*space_, poseOf(moment.walker), options, size.x, size.y);
      camera.camera = std::move(partly.camera);
      camera.ways = std::move(partly.ways);
    }
    return camera;
  }

  LiveCamera walking(WalkCameraOptions options, const glm::ivec2& size, const LiveMoment& moment) {
    WalkCamera ahead = made(options, size, moment);
    LiveCamera live{std::move(ahead.camera)};
    if (moment.behindSize) {
      options.backward = true;
      options.fovHorizontalDegrees = fovBehind(options.fovHorizontalDegrees, *moment.behindSize);
      live.behind = made(options, *moment.behindSize, moment).camera;
    }
    ways_ = std::move(ahead.ways);
    crossing_ = ahead.crossing;
    const auto shown = std::count_if(ways_.begin(), ways_.end(), [](const WalkWay& way) { return way.frustum >= 0; });
    live.notes.push_back({ExploreNote::Kind::kState,
                          ahead.note.empty() ? fmt::format("{} of {} ways out of the {} ahead", shown, ways_.size(),
                                                           crossing_ && crossing_ == ahead.cell ? "room" : "crossing")
                                             : ahead.note});
    if (!refused_.empty()) {
      live.notes.push_back({ExploreNote::Kind::kProblem, refused_});
    }
    return live;
  }

  LiveCamera turning(WalkCameraOptions options, const glm::ivec2& size, const LiveMoment& moment) const {
    LiveCamera live{walkTurningCameras(*space_, *turn_, options, size.x, size.y).first.camera};
    if (moment.behindSize) {
      options.fovHorizontalDegrees = fovBehind(options.fovHorizontalDegrees, *moment.behindSize);
      live.behind =
          walkTurningCameras(*space_, *turn_, options, moment.behindSize->x, moment.behindSize->y).second.camera;
    }
    live.notes.push_back({ExploreNote::Kind::kState,
                          fmt::format("turning: step {} of 4", std::min(4, 1 + static_cast<int>(turn_->phase)))});
    return live;
  }

  /// The way that a click goes into.
  const WalkWay* wayThrough(const ExplorePick& pick) const {
    const auto found = std::find_if(ways_.begin(), ways_.end(), [&](const WalkWay& way) {
      return way.frustum >= 0 && std::find(pick.parts.begin(), pick.parts.end(), way.frustum) != pick.parts.end();
    });
    return found == ways_.end() ? nullptr : &*found;
  }

  void turnAtCrossing(const LiveMoment& moment, size_t side) {
    if (!crossing_) {
      return;
    }
    const WalkCell& cell = space_->map().cells[*crossing_];
    const glm::dvec3 off = glm::dvec3(cell.center) - moment.walker.eye;
    const double size = 2 * static_cast<double>(std::max(cell.halfLength, cell.halfWidth));
    const auto way = std::find_if(ways_.begin(), ways_.end(),
                                  [&](const WalkWay& each) { return each.side == side && each.frustum >= 0; });
    if (way != ways_.end() && std::hypot(off.x, off.z) < kTurnWithin * size) {
      begin(moment, way->portal);
    }
  }

  void begin(const LiveMoment& moment, uint32_t portal) {
    const WalkTurn turn{poseOf(moment.walker), portal, 0};
    try {
      const WalkPose after = walkPoseAfter(*space_, turn);
      turnFrom_ = moment.walker;
      turnTo_ = {after.eye, headingDegreesOf(after.heading, moment.walker.headingDegrees), 0};
      turn_ = turn;
      refused_.clear();
    } catch (const InputError& error) {
      refused_ = messageOf(error).what;  // one walks on freely
    }
  }

  std::array<double, 6> values_{};
  std::optional<WalkSpace> space_;
  std::vector<WalkWay> ways_;  // of the last camera ahead
  std::optional<uint32_t> crossing_;
  std::optional<uint32_t> wish_;  // a portal that was clicked
  std::optional<WalkTurn> turn_;
  bool dissolves_ = false;  // the image of the way becomes the pinhole's
  std::string refused_;     // why the last turn that was wanted could not begin
  WalkerView turnFrom_;
  WalkerView turnTo_;
  SplitVisibility ahead_;
  SplitVisibility behind_;
  std::vector<SplitLine> splits_;
  std::vector<SplitLine> splitsBehind_;
};

}  // namespace

LiveConstructorRow liveMaze() {
  const WalkCameraOptions usual;
  LiveConstructorRow row{
      "maze",
      "shows all ways that leave the crossing or room ahead, and at the left those behind",
      "a way to turn into, in four steps",
      {{"left", "To the left", "parts", 0, 4, 1, "share of the rays at a crossing"},
       {"ahead", "Ahead", "parts", 0, 4, 1, "share of the rays at a crossing"},
       {"right", "To the right", "parts", 0, 4, 1, "share of the rays at a crossing"},
       {"crossing_share", "Crossing", "of the width", 0.3, 0.95, usual.crossingShare,
        "how much of the image's width the crossing takes, however far it is"},
       {"fov_way", "Width of ways", "degrees", 15, 90, usual.fovWayDegrees,
        "field of view at the beginning of the ways that leave the crossing"},
       {"behind", "Image behind", "", 0, 1, 1, "whether what is behind shows at the left", 1, {"off", "on"}, false}},
      true,
      [](const ExploreScene&) { return std::make_unique<LiveMaze>(); },
      [](const ExploreScene&) { return true; }};
  row.turnShare = kMazeTurnShare;
  row.deployShare = kMazeDeployShare;
  row.deploysEvenly = true;
  return row;
}

}  // namespace ocelli
