#include "oc_core/explore/explorer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/explore/explore_message.h"
#include "oc_core/explore/explore_picking.h"
#include "oc_core/explore/explore_shapes.h"

namespace ocelli {
namespace {

/// Of the picture's height: narrower images of what is behind would be wider than half a turn from top to bottom.
constexpr double kMinBehind = 0.005;
constexpr double kSlowedDeployed = 0.15;  // from which on the head turns as slowly as it has to
constexpr double kRamp = 0.1;             // of an even movement, while it begins and while it ends
/// Of the range of an option, a second: how fast a steady option follows what was set.
constexpr double kOptionShareASecond = 0.5;

double eased(double share) {
  return glm::smoothstep(0.0, 1.0, share);
}

/// At one speed, which it reaches and leaves steadily.
double evenlyEased(double share) {
  if (share > 0.5) {
    return 1 - evenlyEased(1 - share);
  }
  return (share < kRamp ? share * share / (2 * kRamp) : share - kRamp / 2) / (1 - kRamp);
}

struct OptionWish {
  size_t index = 0;
  double value = 0;
};

/// A constructor, and what was asked of it that waits until it has collapsed.
struct ChosenConstructor {
  ChosenConstructor(const LiveConstructorRow& which, const ExploreScene& scene)
      : row(&which), constructor(which.make(scene)) {
    for (size_t i = 0; i < which.options.size(); ++i) {
      constructor->setOption(i, which.options[i].otherwise);
      wanted.push_back(which.options[i].otherwise);
    }
  }

  bool waits() const { return pick.has_value() || !options.empty(); }

  const LiveConstructorRow* row;
  std::unique_ptr<LiveConstructor> constructor;
  std::optional<ExplorePick> pick{};
  std::vector<OptionWish> options{};  ///< those that do not change the image steadily
  std::vector<double> wanted{};       ///< of all options, by index
};

struct Glide {
  WalkerView from;
  WalkerView to;
  double share = 0;
};

size_t indexOf(const LiveConstructorRow& row, std::string_view name) {
  std::string known;
  for (size_t i = 0; i < row.options.size(); ++i) {
    if (name == row.options[i].name) {
      return i;
    }
    known += (known.empty() ? "" : ", ") + std::string(row.options[i].name);
  }
  throw InputError(fmt::format("the constructor \"{}\" has no option \"{}\"", row.name, name), "explore",
                   known.empty() ? "choose another constructor" : "use one of: " + known);
}

}  // namespace

struct Explorer::State {
  State(const LiveConstructorRow& first, const ExploreScene& scene) : live(first, scene) {}

  ChosenConstructor live;
  std::optional<ChosenConstructor> next{};  ///< takes over when `live` has collapsed
  double deployed = 0;
  bool failed = false;  ///< the constructor has no camera for this moment
  /// Where rays cannot bend as far as they should: how far they could not. It deploys again where they can.
  std::optional<double> failedAt{};
  bool arrived = false;  ///< has been led to where the constructor wants to begin
  std::optional<Glide> glide{};
  double dissolve = 0;
  int dissolveFrom = 0;
  int width = 0;
  int height = 0;

  ChosenConstructor& chosen() { return next ? *next : live; }
  bool changes() const { return next.has_value() || live.waits(); }
  /// How far the image shows a camera that has deployed by so much.
  double shownOf(double share) const { return live.row->deploysEvenly ? evenlyEased(share) : eased(share); }
  double shown() const { return shownOf(deployed); }
};

Explorer::Explorer(ExploreScene& scene, const ExplorerOptions& options)
    : scene_(scene),
      options_(options),
      walker_(scene, options.walker),
      state_(std::make_unique<State>(liveConstructors().front(), scene)),
      frame_(walker_.camera(options.width, options.height)) {
  state_->width = options.width;
  state_->height = options.height;
  makeFrame(0);
}

Explorer::~Explorer() = default;

void Explorer::advance(const WalkInput& input, double seconds) {
  ++frame_.number;
  applyWaiting();
  followOptions(seconds);
  move(input, seconds);
  deploy(seconds);
  makeFrame(seconds);
}

/// What waits for the camera to have collapsed.
void Explorer::applyWaiting() {
  State& state = *state_;
  if (!state.changes()) {
    return;
  }
  if (state.deployed > 0) {
    if (state.live.row->collapses) {
      return;
    }
    startDissolve();
    state.deployed = 0;
  }
  if (state.next) {
    state.live = std::move(*state.next);
    state.next.reset();
    state.arrived = false;
    state.failed = false;
    state.failedAt.reset();
  }
  if (state.live.pick) {
    state.live.constructor->pick(scene_, *state.live.pick);
    state.live.pick.reset();
    state.arrived = false;
  }
  for (const OptionWish& wish : state.live.options) {
    state.live.constructor->setOption(wish.index, wish.value);
  }
  state.live.options.clear();
}

void Explorer::followOptions(double seconds) {
  ChosenConstructor& live = state_->live;
  for (size_t i = 0; i < live.row->options.size(); ++i) {
    const LiveOption& option = live.row->options[i];
    const double now = live.constructor->option(i);
    if (!option.steady || now == live.wanted[i]) {
      continue;
    }
    const double most =
        state_->deployed > 0 ? (option.max - option.min) * kOptionShareASecond * seconds : option.max - option.min;
    live.constructor->setOption(i, now + std::clamp(live.wanted[i] - now, -most, most));
  }
}

LiveMoment Explorer::momentFor(const PinholeCamera& view, double seconds, double shown) const {
  const int behind = state_->width - view.width();
  return {scene_,
          view,
          walker_.view(),
          walker_.options(),
          seconds,
          shown,
          behind > 0 ? std::optional(glm::ivec2(behind, state_->height)) : std::nullopt};
}

void Explorer::move(const WalkInput& input, double seconds) {
  State& state = *state_;
  if (state.glide) {
    Glide& glide = *state.glide;
    glide.share = std::min(1.0, glide.share + seconds / options_.glideSeconds);
    walker_.place(between(glide.from, glide.to, eased(glide.share)));
    if (glide.share >= 1) {
      walker_.place(glide.to);
      state.glide.reset();
    }
    return;
  }
  const PinholeCamera view = walker_.camera(state.width, state.height);
  const LiveMoment moment = momentFor(view, seconds, state.shown());
  if (!state.arrived && !state.next && !waysMissing()) {
    state.arrived = true;
    const std::optional<WalkerView> wanted = state.live.constructor->wantedView(moment);
    if (wanted && !(*wanted == walker_.view())) {
      state.glide = Glide{walker_.view(), *wanted, 0};
      return;
    }
  }
  const std::optional<WalkerView> led = state.failed || (state.next && !state.live.constructor->busy())
                                            ? std::nullopt
                                            : state.live.constructor->lead(moment, input);
  if (led) {
    walker_.place(*led);
    return;
  }
  WalkInput free = input;
  const double turnShare = turnDegrees() / walker_.options().turnDegrees;
  free.turnRight *= turnShare;
  free.lookUp *= turnShare;
  if (state.live.constructor->looksLevel() && !state.next) {
    free.lookUp = 0;
    free.pointerDegrees.y = 0;
  }
  walker_.step(free, seconds);
}

double Explorer::turnDegrees() const {
  // Slower before rays have bent far, as bending moves the image, too.
  const double slowed = glm::smoothstep(0.0, kSlowedDeployed, state_->deployed);
  return walker_.options().turnDegrees * glm::mix(1.0, state_->live.row->turnShare, slowed);
}

void Explorer::glideTo(const WalkerView& view) {
  state_->glide = Glide{walker_.view(), view, 0};
  state_->arrived = false;
}

void Explorer::jumpTo(const WalkerView& view) {
  walker_.jump(view);
  state_->glide.reset();
  state_->arrived = false;
}

bool Explorer::waysMissing() const {
  const LiveConstructorRow& row = *state_->live.row;
  return row.needsWays && row.needsWays(scene_) && scene_.walkMap() == nullptr;
}

void Explorer::deploy(double seconds) {
  State& state = *state_;
  if (state.dissolve > 0) {
    state.dissolve = std::max(0.0, state.dissolve - seconds / options_.dissolveSeconds);
  }
  const bool leaves = state.changes() && !state.live.constructor->busy();
  const bool wanted = !leaves && !state.failed && !state.glide && !waysMissing();
  if (state.live.row->collapses) {
    const double most = seconds / options_.deploySeconds * state.live.row->deployShare;
    state.deployed += std::clamp((wanted ? 1.0 : 0.0) - state.deployed, -most, most);
  } else if (wanted && state.deployed == 0) {
    startDissolve();
    state.deployed = 1;
  }
}

void Explorer::startDissolve() {
  state_->dissolve = 1;
  state_->dissolveFrom = frame_.number - 1;
}

PinholeCamera Explorer::viewFor(double shown) const {
  const State& state = *state_;
  const int wanted = state.live.constructor->showsBehind() ? static_cast<int>(state.width / 2 * shown) : 0;
  const int width = state.width - (wanted > kMinBehind * state.height ? wanted : 0);
  return walkerCamera(walker_.view(), scene_, walker_.options().fovHorizontal, width, state.height);
}

/// Makes the camera of the moment. One that failed while it deployed would succeed again where it has collapsed, and
/// so come and go for ever: it stays collapsed until it can be made where it failed.
LiveCamera Explorer::makeCamera(double seconds) {
  State& state = *state_;
  if (state.failedAt) {
    const double shown = state.shownOf(*state.failedAt);
    state.live.constructor->camera(momentFor(viewFor(shown), 0, shown));
    state.failedAt.reset();
  }
  return state.live.constructor->camera(momentFor(viewFor(state.shown()), seconds, state.shown()));
}

void Explorer::makeFrame(double seconds) {
  State& state = *state_;
  const PinholeCamera whole =
      walkerCamera(walker_.view(), scene_, walker_.options().fovHorizontal, state.width, state.height);

  frame_.walker = walker_.view();
  frame_.pinhole = whole;
  frame_.still.reset();
  frame_.behind.reset();
  frame_.splits.clear();
  std::vector<ExploreNote> notes;
  try {
    if (!waysMissing()) {
      LiveCamera made = makeCamera(seconds);
      notes = std::move(made.notes);
      state.failed = false;
      if (state.deployed > 0) {
        if (made.dissolves) {
          startDissolve();
        }
        frame_.camera = std::move(made.camera);
        frame_.still = std::move(made.still);
        frame_.behind = std::move(made.behind);
        frame_.splits = std::move(made.splits);
        if (frame_.behind) {
          for (SplitLine& line : frame_.splits) {
            line.u += widthOf(*frame_.behind);
          }
          frame_.splits.insert(frame_.splits.end(), made.splitsBehind.begin(), made.splitsBehind.end());
        }
      }
    }
  } catch (const InputError& error) {
    if (state.deployed > 0) {
      startDissolve();
      state.failedAt = state.deployed;
    }
    state.failed = true;
    state.deployed = 0;
    notes = {{ExploreNote::Kind::kProblem, messageOf(error).what}};
  }
  if (state.deployed == 0 || waysMissing()) {
    frame_.camera = GraphCamera(whole);
    frame_.still.reset();
  }
  frame_.deployed = state.deployed;
  frame_.dissolve = state.dissolve;
  frame_.dissolveFrom = state.dissolveFrom;
  addStateNotes(std::move(notes));
  frame_.outlines = outlinesOf(frame_);
  frame_.footprints = footprintsOf(frame_, scene_.bounds());
}

void Explorer::addStateNotes(std::vector<ExploreNote> notes) {
  frame_.notes = std::move(notes);
  const WalkMapStatus ways = scene_.waysStatus();
  if (waysMissing()) {
    frame_.notes.push_back(ways.state == WalkMapStatus::State::kFailed
                               ? ExploreNote{ExploreNote::Kind::kProblem, ways.problem}
                               : ExploreNote{ExploreNote::Kind::kState, "searching for where one can walk ..."});
  }
  if (walker_.options().fly) {
    frame_.notes.push_back({ExploreNote::Kind::kState, "flying"});
  } else if (!walker_.overFloor() && !state_->glide) {
    frame_.notes.push_back({ExploreNote::Kind::kState, "no floor here: you float"});
  }
}

void Explorer::resize(int width, int height) {
  // Throws where the size is wrong, before anything has changed.
  const PinholeCamera view = walker_.camera(width, height);
  state_->width = view.width();
  state_->height = view.height();
  makeFrame(0);
}

void Explorer::choose(std::string_view constructor) {
  choose(findLiveConstructor(constructor));
}

void Explorer::choose(const LiveConstructorRow& row) {
  State& state = *state_;
  if (state.chosen().row == &row) {
    return;
  }
  if (state.live.row == &row) {
    state.next.reset();  // it had not collapsed yet
    return;
  }
  if (row.needsWays && row.needsWays(scene_)) {
    scene_.searchWays();
    if (options_.waitForWays) {
      scene_.waitForWays();
    }
  }
  state.next.emplace(row, scene_);
}

const LiveConstructorRow& Explorer::chosen() const {
  return *state_->chosen().row;
}

double Explorer::option(std::string_view name) const {
  const ChosenConstructor& chosen = state_->chosen();
  return chosen.wanted[indexOf(*chosen.row, name)];
}

void Explorer::setOption(std::string_view name, double value) {
  ChosenConstructor& chosen = state_->chosen();
  const size_t index = indexOf(*chosen.row, name);
  const LiveOption& option = chosen.row->options[index];
  if (!(value >= option.min && value <= option.max)) {
    throw InputError(fmt::format("the option \"{}\" of \"{}\" is {}", name, chosen.row->name, value), "explore",
                     fmt::format("give a number from {} to {}", option.min, option.max));
  }
  const double stepped = option.step > 0 ? std::round(value / option.step) * option.step : value;
  chosen.wanted[index] = stepped;
  // Of several that wait, the last one counts.
  std::erase_if(chosen.options, [&](const OptionWish& wish) { return wish.index == index; });
  if (!option.steady && chosen.constructor->option(index) != stepped) {
    chosen.options.push_back({index, stepped});
  }
}

void Explorer::showDrawn(const MultiperspectiveCamera& camera, const std::string& name) {
  choose(liveConstructorForOthers().name);
  state_->chosen().constructor->show(camera, name);
}

std::optional<ExplorePick> Explorer::probe(const glm::dvec2& pixel) const {
  return pickAt(scene_, frame_, pixel);
}

bool Explorer::pick(const glm::dvec2& pixel) {
  const std::optional<ExplorePick> met = probe(pixel);
  return met && pick(*met);
}

bool Explorer::pick(const ExplorePick& pick) {
  ChosenConstructor& chosen = state_->chosen();
  if (!chosen.constructor->accepts(scene_, pick)) {
    return false;
  }
  if (chosen.constructor->picksAtOnce()) {
    chosen.constructor->pick(scene_, pick);
  } else {
    chosen.pick = pick;
  }
  return true;
}

std::optional<Box> Explorer::picked() const {
  return state_->live.constructor->picked();
}

bool Explorer::atRest() const {
  const State& state = *state_;
  // Without ways, it waits for the search.
  const bool settled = waysMissing() ? scene_.waysStatus().state == WalkMapStatus::State::kFailed
                                     : state.arrived && (state.deployed == 1 || state.failed);
  bool optionsReached = true;
  for (size_t i = 0; i < state.live.wanted.size(); ++i) {
    optionsReached = optionsReached && state.live.constructor->option(i) == state.live.wanted[i];
  }
  return settled && optionsReached && !state.changes() && !state.glide && state.dissolve == 0 &&
         !state.live.constructor->busy();
}

}  // namespace ocelli
