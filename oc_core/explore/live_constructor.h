// A constructor of cameras that lives while someone walks (section 4.3.1): it is asked for a camera each frame, and
// remembers what it has to, such as how far rays bend around what hides a target.
//
// Images must not jump. So every camera can be collapsed: `deployed` goes from 0, where it is the pinhole, to 1, and
// the explorer chooses, picks and switches only where it is 0. What changes with the view must change steadily with it,
// and what a constructor remembers may change by a little from frame to frame.
//
// Recipe for a new one, three places:
//   1. oc_core/explore/explore_NAME.cpp: a class that is a LiveConstructor, and `LiveConstructorRow liveNAME()`.
//   2. oc_core/explore/live_constructor_rows.h: its declaration.
//   3. oc_core/explore/live_constructors.cpp: one line in the table.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oc_core/explore/explore_frame.h"
#include "oc_core/explore/explore_scene.h"
#include "oc_core/explore/explore_walker.h"

namespace ocelli {

/// What someone clicked: what the ray of a pixel of the picture meets.
struct ExplorePick {
  glm::vec3 position{0};
  uint32_t object = 0;           ///< identity; 0 is structure
  bool surface = false;          ///< the ray met one, at `position`
  bool floor = false;            ///< one that is level
  std::vector<int> parts;        ///< of the camera, that the ray passes up to there: frusta, or segments of curved rays
  std::optional<Portal> portal;  ///< the nearest opening that the ray passes before that, seen from where it came
};

/// An option of a constructor that people set while they walk. Numbers; of a choice, the number of the word.
struct LiveOption {
  const char* name;  ///< in scripts and files
  const char* label;
  const char* unit;
  double min;
  double max;
  double otherwise;  ///< the default
  const char* meaning;
  double step = 0;                        ///< 0: any number; else multiples of it
  std::vector<const char*> choices = {};  ///< words for 0, 1, 2, ...
  /// Whether the image changes steadily with it. Otherwise it is set where the camera is collapsed.
  bool steady = true;
};

/// What a constructor makes of a moment.
struct LiveCamera {
  MultiperspectiveCamera camera;
  std::optional<MultiperspectiveCamera> behind = {};
  std::vector<SplitLine> splits = {};  ///< of `camera`, pixels of its image; smoothed over time
  std::vector<SplitLine> splitsBehind = {};
  std::vector<ExploreNote> notes = {};
  /// Its image cannot follow from that of the frame before: the picture dissolves into it.
  bool dissolves = false;
  /// Of a camera that stands still: the same pointer as long as `camera` is the same. Null: it may differ.
  std::shared_ptr<const void> still = {};
};

struct LiveMoment {
  const ExploreScene& scene;
  const PinholeCamera& view;  ///< of the walker, as large as the image that is wanted
  const WalkerView& walker;
  const WalkerOptions& walkerOptions;
  double seconds;                        ///< since the moment before; 0 where nothing but the view is asked for
  double deployed;                       ///< 0 to 1
  std::optional<glm::ivec2> behindSize;  ///< of the image behind, where it is shown
};

class LiveConstructor {
 public:
  virtual ~LiveConstructor() = default;

  /// Advances by the seconds of the moment, and builds. An InputError stands for a state in which there is no such
  /// camera: the explorer shows the pinhole, and says why.
  virtual LiveCamera camera(const LiveMoment& moment) = 0;

  /// Where the walker goes, where this constructor leads it: along a path, or in four steps through a turn. Nothing:
  /// it walks freely.
  virtual std::optional<WalkerView> lead(const LiveMoment& /*moment*/, const WalkInput& /*input*/) { return {}; }
  /// Where it wants the walker before it deploys; nothing where any place will do.
  virtual std::optional<WalkerView> wantedView(const LiveMoment& /*moment*/) { return {}; }

  /// Whether a click is of use to it, and differs from what is picked.
  virtual bool accepts(const ExploreScene& /*scene*/, const ExplorePick& /*pick*/) const { return false; }
  /// Takes what was clicked, where it accepts that. Called where the camera is collapsed.
  virtual void pick(const ExploreScene& /*scene*/, const ExplorePick& /*pick*/) {}
  /// Whether a click is taken at once, as it moves the walker and not the camera.
  virtual bool picksAtOnce() const { return false; }
  /// Whether it is about to do something that has to end before the camera collapses: a turn, for example.
  virtual bool busy() const { return false; }
  /// Whether one looks level with it.
  virtual bool looksLevel() const { return false; }
  /// Takes a camera that was made elsewhere; false where it makes its own.
  virtual bool show(const MultiperspectiveCamera& /*camera*/, const std::string& /*name*/) { return false; }
  /// What is picked, as a box around it, for the plan; nothing for none.
  virtual std::optional<Box> picked() const { return {}; }
  /// Shows the image behind to the left of that ahead.
  virtual bool showsBehind() const { return false; }

  /// `index` of the row's options.
  virtual double option(size_t /*index*/) const { return 0; }
  virtual void setOption(size_t /*index*/, double /*value*/) {}
};

struct LiveConstructorRow {
  const char* name;
  const char* description;  ///< one sentence
  const char* clickMeans;   ///< what a click chooses; empty for nothing
  std::vector<LiveOption> options;
  /// Whether its camera comes from the pinhole by bending rays. Where not, the picture dissolves into it.
  bool collapses = true;
  /// Makes one for a scene.
  std::function<std::unique_ptr<LiveConstructor>(const ExploreScene& scene)> make;
  /// Whether in this scene it needs to know where one can walk, which may have to be searched. Empty: in none.
  std::function<bool(const ExploreScene& scene)> needsWays = {};
  /// Of the usual speed, how fast the head turns while its camera is deployed. Bent rays show more than straight ones,
  /// so the same turn changes the image more.
  double turnShare = 1;
  /// Of the usual speed, how fast its camera deploys and collapses. One that moves all of the image takes longer.
  double deployShare = 1;
  /// Whether its camera deploys at one speed, but for the beginning and the end. It is as fast as it ever is for
  /// longer, so that it need not be as fast.
  bool deploysEvenly = false;
  /// Whether it shows cameras that were made elsewhere: LiveConstructor::show(). One row does.
  bool showsOthers = false;
};

/// In the order in which a window offers them; the first is the pinhole.
const std::vector<LiveConstructorRow>& liveConstructors();
/// Throws InputError naming those that there are.
const LiveConstructorRow& findLiveConstructor(std::string_view name);
/// That which shows cameras that were made elsewhere.
const LiveConstructorRow& liveConstructorForOthers();

}  // namespace ocelli
