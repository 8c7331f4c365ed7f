#include "oc_core/explore_window/explorer_window_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "oc_core/explore/explore_picking.h"
#include "oc_core/explore/explore_renderer.h"
#include "oc_core/explore/explore_shown_camera.h"
#include "oc_core/explore_window/explorer_plan.h"

namespace ocelli {
namespace {

/// Steps over the range of an option that takes any number.
constexpr double kFieldSteps = 40;
/// Where the eye is higher or lower than it was by this, metres, it is on another storey: the ground is cut anew.
constexpr double kStorey = 1.2;
/// How far below a place of the plan its floor may be, metres.
constexpr double kFloorReach = 30;

WindowField fieldOf(const LiveOption& option, double value) {
  WindowField field{option.name, option.label, option.meaning, option.unit, option.min,
                    option.max,  option.step,  value,          {}};
  for (const char* choice : option.choices) {
    field.names.emplace_back(choice);
  }
  if (!field.names.empty()) {
    field.step = 1;
  } else if (field.step <= 0) {
    field.step = (field.upper - field.lower) / kFieldSteps;
  }
  return field;
}

/// Something that can be picked, and where it is.
struct PickCandidate {
  ExplorePick pick;
  double order = 0;  ///< what is near and ahead comes first
};

/// Whatever there is to pick, what is near and ahead first. Of openings, those that the eye is before.
std::vector<PickCandidate> candidatesFrom(const Explorer& explorer) {
  const glm::dvec3 eye = explorer.walker().view().eye;
  const glm::dvec3 ahead = headingOf(explorer.walker().view());
  std::vector<PickCandidate> candidates;
  const auto add = [&](const ExplorePick& pick) {
    const glm::dvec3 way = glm::dvec3(pick.position) - eye;
    const double distance = glm::length(way);
    // Twice as far where it is beside the view, three times where it is behind.
    candidates.push_back({pick, distance * (2 - (distance > 0 ? glm::dot(way, ahead) / distance : 1))});
  };
  for (const Portal& portal : knownPortals(explorer.scene())) {
    if (glm::dot(glm::dvec3(portal.normal), eye - glm::dvec3(portal.center)) > 0) {
      ExplorePick pick;
      pick.position = portal.center;
      pick.portal = portal;
      add(pick);
    }
  }
  const std::vector<Box>& objects = explorer.scene().objects();
  for (size_t i = 1; i < objects.size(); ++i) {
    if (!objects[i].empty()) {
      ExplorePick pick;
      pick.position = objects[i].center();
      pick.object = static_cast<uint32_t>(i);
      pick.surface = true;
      add(pick);
    }
  }
  std::ranges::stable_sort(candidates, {}, &PickCandidate::order);
  return candidates;
}

std::string whatToPick(const LiveConstructorRow& row) {
  return *row.clickMeans == '\0' ? fmt::format("The {} camera takes no clicks: choose another one first.", row.name)
                                 : fmt::format("Nothing to pick: click {}.", row.clickMeans);
}

bool isSamePick(const ExplorePick& a, const ExplorePick& b) {
  return a.object == b.object && a.portal.has_value() == b.portal.has_value() && a.position == b.position;
}

}  // namespace

struct ExplorerWindowModel::State {
  State(const ExplorerWindowOptions& options, const Progress& progress)
      : scene(options.read(progress)), explorer(*scene, options.explorer), renderer(*scene) {
    if (options.start) {
      explorer.jumpTo(*options.start);
    }
    start = explorer.walker().view();
    if (!options.camera.empty()) {
      exploreFrom(explorer, options.camera);
    }
    path = std::make_shared<const std::vector<glm::vec2>>(planPath(*scene));
  }

  const LiveOption& option(const std::string& name) const {
    const std::vector<LiveOption>& options = explorer.chosen().options;
    const auto found = std::ranges::find_if(options, [&](const LiveOption& each) { return name == each.name; });
    if (found == options.end()) {
      throw InputError("this camera has no such option", name, "choose another camera");
    }
    return *found;
  }

  std::shared_ptr<const WindowGround> groundNow() {
    const double eye = explorer.walker().view().eye.y;
    if (!ground || std::abs(eye - groundEye) > kStorey * scene->metre()) {
      ground = std::make_shared<const WindowGround>(groundBelow(*scene, static_cast<float>(eye)));
      groundEye = eye;
    }
    return ground;
  }

  void takeWays() {
    const WalkMap* const map = scene->walkMap();
    if (openings && map == knownMap) {
      return;
    }
    knownMap = map;
    openings = std::make_shared<const std::vector<WindowPlan::Opening>>(planOpenings(*scene));
    cells = map != nullptr ? std::make_shared<const std::vector<WindowPlan::Cell>>(planCells(*map)) : nullptr;
  }

  std::shared_ptr<ExploreScene> scene;
  Explorer explorer;
  ExploreRenderer renderer;
  WalkerView start;
  glm::ivec2 size{0};
  std::shared_ptr<const WindowGround> ground;
  double groundEye = 0;
  const WalkMap* knownMap = nullptr;
  std::shared_ptr<const std::vector<WindowPlan::Cell>> cells;
  std::shared_ptr<const std::vector<WindowPlan::Opening>> openings;
  std::shared_ptr<const std::vector<glm::vec2>> path;
  std::optional<ExplorePick> lastPick;
};

ExplorerWindowModel::ExplorerWindowModel(const ExplorerWindowOptions& options, const Progress& progress)
    : state_(std::make_unique<State>(options, progress)) {}

ExplorerWindowModel::~ExplorerWindowModel() = default;

Explorer& ExplorerWindowModel::explorer() {
  return state_->explorer;
}

void ExplorerWindowModel::advance(double seconds, const WindowMotion& motion) {
  state_->explorer.advance(walkInputOf(motion), seconds);
}

WindowPicture ExplorerWindowModel::draw(const WindowShape& shape) {
  const auto begin = std::chrono::steady_clock::now();
  State& state = *state_;
  if (shape.view != state.size) {
    state.explorer.resize(shape.view.x, shape.view.y);
    state.size = shape.view;
  }
  const ExploreFrame& frame = state.explorer.frame();
  WindowPicture picture;
  picture.scene = state.scene;
  picture.pinholeCamera = frame.pinhole;
  picture.view = state.renderer.draw(frame).image;
  if (shape.pinhole) {
    const WalkerOptions& walker = state.explorer.walker().options();
    picture.pinhole = state.renderer.draw(GraphCamera(
        walkerCamera(frame.walker, *state.scene, walker.fovHorizontal, shape.pinhole->x, shape.pinhole->y)));
  }
  for (const ExploreOutline& outline : frame.outlines) {
    WindowTint tint{{}, outline.part};
    std::ranges::transform(outline.corners, std::back_inserter(tint.outline),
                           [](const glm::dvec2& corner) { return glm::vec2(corner); });
    picture.tints.push_back(std::move(tint));
  }
  state.takeWays();
  picture.plan = planOfExplorer(state.explorer);
  picture.plan.cells = state.cells;
  picture.plan.openings = state.openings;
  picture.plan.path = state.path;
  if (shape.ground) {
    picture.ground = state.groundNow();
  }
  const LiveConstructorRow& chosen = state.explorer.chosen();
  for (const LiveConstructorRow& row : liveConstructors()) {
    if (&row == &chosen) {
      picture.chosen = picture.choices.size();
    }
    picture.choices.push_back({row.name, row.description});
  }
  for (const LiveOption& option : chosen.options) {
    picture.fields.push_back(fieldOf(option, state.explorer.option(option.name)));
  }
  for (const ExploreNote& note : frame.notes) {
    picture.notes.push_back(
        {note.text, note.kind == ExploreNote::Kind::kProblem ? WindowNoteKind::kAttention : WindowNoteKind::kPlain});
  }
  const bool isInMetres = state.scene->metre() == 1;
  picture.lengthUnit = isInMetres ? "m" : "";
  const double heading = std::round(frame.walker.headingDegrees);
  picture.place = fmt::format("at {:.1f}, {:.1f}{}, heading {:.0f}°", frame.walker.eye.x, frame.walker.eye.z,
                              isInMetres ? " m" : "", heading - 360 * std::floor(heading / 360));
  const WalkMapStatus ways = state.scene->waysStatus();
  const bool isSearching = ways.state == WalkMapStatus::State::kSearching;
  if (isSearching) {
    picture.stage = ways.stage.empty() ? "finding where one can walk" : ways.stage;
    picture.fraction = ways.fraction;
  }
  picture.isMoving = isSearching || !state.explorer.atRest();
  picture.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return picture;
}

void ExplorerWindowModel::choose(size_t choice) {
  const auto& rows = liveConstructors();
  if (choice < rows.size()) {
    state_->explorer.choose(rows[choice].name);
  }
}

void ExplorerWindowModel::setField(const std::string& name, double value) {
  state_->explorer.setOption(name, value);
}

void ExplorerWindowModel::changeField(const std::string& name, double steps) {
  const LiveOption& option = state_->option(name);
  const WindowField field = fieldOf(option, state_->explorer.option(name));
  const double value = field.value + steps * field.step;
  if (field.names.empty()) {
    setField(name, std::clamp(value, field.lower, field.upper));
    return;
  }
  const auto count = static_cast<double>(field.names.size());
  setField(name, value - std::floor(value / count) * count);
}

std::string ExplorerWindowModel::pick(const glm::dvec2& viewPixel) {
  return state_->explorer.pick(viewPixel) ? "" : whatToPick(state_->explorer.chosen());
}

std::string ExplorerWindowModel::pickNext(int step) {
  const std::vector<PickCandidate> candidates = candidatesFrom(state_->explorer);
  const auto count = static_cast<int>(candidates.size());
  int at = step > 0 ? -1 : count;
  for (int i = 0; i < count; ++i) {
    if (state_->lastPick && isSamePick(candidates[static_cast<size_t>(i)].pick, *state_->lastPick)) {
      at = i;
    }
  }
  for (int tried = 0; tried < count; ++tried) {
    at = (at + step + count) % count;
    const ExplorePick& pick = candidates[static_cast<size_t>(at)].pick;
    if (state_->explorer.pick(pick)) {
      state_->lastPick = pick;
      return "";
    }
  }
  return whatToPick(state_->explorer.chosen());
}

void ExplorerWindowModel::showDrawn(const MultiperspectiveCamera& camera, const std::string& name) {
  state_->explorer.showDrawn(camera, name);
}

void ExplorerWindowModel::openCamera(const std::string& nameOrFile) {
  showCamera(state_->explorer, nameOrFile);
}

void ExplorerWindowModel::toggleFlying() {
  state_->explorer.setFlying(!state_->explorer.walker().options().fly);
}

void ExplorerWindowModel::goToStart() {
  state_->explorer.glideTo(state_->start);
}

void ExplorerWindowModel::goTo(const glm::vec2& planPoint) {
  const ExploreWalker& walker = state_->explorer.walker();
  WalkerView to = walker.view();
  to.eye = {planPoint.x, to.eye.y, planPoint.y};
  if (const std::optional<glm::vec3> floor = walker.floorBelow(to.eye, kFloorReach)) {
    to.eye.y = static_cast<double>(floor->y) + walker.options().eyeHeight * state_->scene->metre();
  }
  state_->explorer.glideTo(to);
}

std::string ExplorerWindowModel::cameraFile() const {
  return std::visit([](const auto& camera) { return jsonText(camera); }, state_->explorer.frame().camera);
}

std::string ExplorerWindowModel::cameraFileLacks() const {
  return state_->explorer.frame().behind ? ": the part ahead alone, not what is behind" : "";
}

ExploreWindowWork::Make makeExplorerModel(ExplorerWindowOptions options) {
  return [options = std::move(options)](const Progress& progress) {
    return std::make_unique<ExplorerWindowModel>(options, progress);
  };
}

WalkInput walkInputOf(const WindowMotion& motion) {
  return {motion.ahead,
          motion.right,
          motion.up,
          motion.turnRight,
          motion.lookUp,
          motion.fast,
          {motion.turnedDegrees.x, motion.turnedDegrees.y}};
}

WindowMotion windowMotionOf(const WalkInput& input) {
  const auto part = [](double share) { return static_cast<float>(share); };
  return {part(input.forward),
          part(input.right),
          part(input.up),
          part(input.turnRight),
          part(input.lookUp),
          input.fast,
          glm::vec2(input.pointerDegrees)};
}

}  // namespace ocelli
