#include "oc_core/explore_window/explore_keys.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "oc_core/explore_window/draw_pane.h"
#include "oc_core/explore_window/explore_pane_choice.h"
#include "oc_core/explore_window/pinhole_pane.h"
#include "oc_core/explore_window/plan_pane.h"

namespace ocelli {
namespace {

constexpr const char* kWalking = "Walking";
constexpr const char* kCamera = "Camera";
constexpr const char* kScreen = "Screen";
constexpr const char* kFiles = "Files and window";

constexpr std::array kHeldKeys{
    ExploreHeldKey{kWalking, "W  A  S  D", "walk, also along the path; Shift: fast", Key::kW, &WindowMotion::ahead, 1,
                   "left stick"},
    ExploreHeldKey{kWalking, "", "", Key::kS, &WindowMotion::ahead, -1},
    ExploreHeldKey{kWalking, "", "", Key::kA, &WindowMotion::right, -1},
    ExploreHeldKey{kWalking, "", "", Key::kD, &WindowMotion::right, 1},
    ExploreHeldKey{kWalking, "Arrows", "walk and turn", Key::kUp, &WindowMotion::ahead, 1, "right stick"},
    ExploreHeldKey{kWalking, "", "", Key::kDown, &WindowMotion::ahead, -1},
    ExploreHeldKey{kWalking, "", "", Key::kLeft, &WindowMotion::turnRight, -1},
    ExploreHeldKey{kWalking, "", "", Key::kRight, &WindowMotion::turnRight, 1},
    ExploreHeldKey{kWalking, "PageUp  PageDown", "look up, down", Key::kPageUp, &WindowMotion::lookUp, 1},
    ExploreHeldKey{kWalking, "", "", Key::kPageDown, &WindowMotion::lookUp, -1},
    ExploreHeldKey{kWalking, "R  F", "fly up, down, where one flies", Key::kR, &WindowMotion::up, 1},
    ExploreHeldKey{kWalking, "", "", Key::kF, &WindowMotion::up, -1},
};

void chooseByNumber(ExploreKeyTarget& target, int number) {
  const auto index = static_cast<size_t>(number - 1);
  if (target.picture != nullptr && index < target.picture->choices.size()) {
    target.state.formRow = 0;
    target.work.tell([index](ExploreWindowModel& model) {
      model.choose(index);
      return std::string();
    });
  }
}

void chooseNeighbour(ExploreKeyTarget& target, int step) {
  if (target.picture != nullptr && !target.picture->choices.empty()) {
    const int count = static_cast<int>(target.picture->choices.size());
    chooseByNumber(target, (static_cast<int>(target.picture->chosen) + step + count) % count + 1);
  }
}

void pickInTheMiddle(ExploreKeyTarget& target, int) {
  if (target.picture != nullptr) {
    const glm::dvec2 middle(target.picture->view.width() / 2.0, target.picture->view.height() / 2.0);
    target.work.tell([middle](ExploreWindowModel& model) { return model.pick(middle); });
  }
}

void pickNeighbour(ExploreKeyTarget& target, int step) {
  target.work.tell([step](ExploreWindowModel& model) { return model.pickNext(step); });
}

void goToStart(ExploreKeyTarget& target, int) {
  target.work.tell([](ExploreWindowModel& model) {
    model.goToStart();
    return std::string();
  });
}

void toggleFlying(ExploreKeyTarget& target, int) {
  target.work.tell([](ExploreWindowModel& model) {
    model.toggleFlying();
    return std::string();
  });
}

void changeRow(ExploreKeyTarget& target, int steps) {
  changeExploreField(target, target.state.formRow, steps);
}

void moveRow(ExploreKeyTarget& target, int step) {
  if (target.picture != nullptr && !target.picture->fields.empty()) {
    const int count = static_cast<int>(target.picture->fields.size());
    const int row = std::min(static_cast<int>(target.state.formRow), count - 1);
    target.state.form = true;
    target.state.formRow = static_cast<size_t>((row + step + count) % count);
  }
}

void drawAnew(ExploreKeyTarget& target, int curved) {
  showExplorePane(target.state, kDrawPane);
  target.state.drawAnew = curved != 0 ? ExploreWindowState::DrawAnew::kCurved : ExploreWindowState::DrawAnew::kGraph;
}

void zoomPlan(ExploreKeyTarget& target, int steps) {
  target.state.planZoom =
      std::clamp(target.state.planZoom * std::pow(1.5f, static_cast<float>(steps)), 1.0f, kMaxPlanZoom);
}

void escape(ExploreKeyTarget& target, int) {
  ExploreWindowState& state = target.state;
  if (state.help) {
    state.help = false;
  } else if (state.captured) {
    state.captured = false;
  } else if (state.messageIsError) {
    state.message.clear();
    state.messageIsError = false;
  } else if (state.active != mainExplorePane()) {
    state.active = mainExplorePane();
  } else {
    state.form = false;
  }
}

const std::vector<ExploreKeyAction>& actionRows() {
  static const std::vector<ExploreKeyAction> rows{
      {kWalking, "C", "the mouse looks around; Escape ends it", Key::kC, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.state.captured = !target.state.captured; }},
      {kWalking, "L", "fly through walls, and walk again", Key::kL, false, false, 0, toggleFlying},
      {kWalking, "Home", "back to the start", Key::kHome, false, false, 0, goToStart},

      {kCamera, "1 ... 9", "choose the camera named above", Key::k1, false, false, 1, chooseByNumber},
      {kCamera, "", "", Key::k2, false, false, 2, chooseByNumber},
      {kCamera, "", "", Key::k3, false, false, 3, chooseByNumber},
      {kCamera, "", "", Key::k4, false, false, 4, chooseByNumber},
      {kCamera, "", "", Key::k5, false, false, 5, chooseByNumber},
      {kCamera, "", "", Key::k6, false, false, 6, chooseByNumber},
      {kCamera, "", "", Key::k7, false, false, 7, chooseByNumber},
      {kCamera, "", "", Key::k8, false, false, 8, chooseByNumber},
      {kCamera, "", "", Key::k9, false, false, 9, chooseByNumber},
      {kCamera, "T  Shift + T", "next, previous camera", Key::kT, false, false, 1, chooseNeighbour, 5, "bumpers"},
      {kCamera, "", "", Key::kT, true, false, -1, chooseNeighbour, 4},
      {kCamera, "N  Shift + N", "pick the next, previous thing", Key::kN, false, false, 1, pickNeighbour, 1, "B"},
      {kCamera, "", "", Key::kN, true, false, -1, pickNeighbour},
      {kCamera, "Enter", "pick what is in the middle of the view", Key::kEnter, false, false, 0, pickInTheMiddle, 0,
       "A"},
      {kCamera, "O", "options of this camera", Key::kO, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.state.form = !target.state.form; }, 10, "right stick in"},
      {kCamera, "-  +", "less, more of the chosen option", Key::kMinus, false, false, -1, changeRow, 14, "left, right"},
      {kCamera, "", "", Key::kEqual, false, false, 1, changeRow, 12},
      {kCamera, "", "", Key::kEqual, true, false, 1, changeRow},
      {kCamera, "J  Shift + J", "choose the next, previous option", Key::kJ, false, false, 1, moveRow, 13, "up, down"},
      {kCamera, "", "", Key::kJ, true, false, -1, moveRow, 11},

      {kScreen, "Tab", "the pinhole's image beside it", Key::kTab, false, false, 0,
       [](ExploreKeyTarget& target, int) { toggleExplorePane(target.state, kPinholePane); }, 6, "Back"},
      {kScreen, "M", "the plan from above", Key::kM, false, false, 0,
       [](ExploreKeyTarget& target, int) { toggleExplorePane(target.state, kPlanPane); }, 3, "Y"},
      {kScreen, "Z  Shift + Z", "plan: nearer, farther", Key::kZ, false, false, 1, zoomPlan},
      {kScreen, "", "", Key::kZ, true, false, -1, zoomPlan},
      {kScreen, "B", "borders around what bends", Key::kB, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.state.borders = !target.state.borders; }, 2, "X"},
      {kScreen, "H  F1", "this help", Key::kH, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.state.help = !target.state.help; }, 7, "Start"},
      {kScreen, "", "", Key::kF1, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.state.help = !target.state.help; }},

      {kScreen, "G", "draw a camera by hand, and end it", Key::kG, false, false, 0,
       [](ExploreKeyTarget& target, int) { toggleExplorePane(target.state, kDrawPane); }},
      {kScreen, "Shift + G  Ctrl + G", "draw a new graph, curved ray camera", Key::kG, true, false, 0, drawAnew},
      {kScreen, "", "", Key::kG, false, true, 1, drawAnew},
      {kScreen, "F6", "keys to where one draws, and back", Key::kF6, false, false, 0,
       [](ExploreKeyTarget& target, int) { activateNextExplorePane(target.state); }},

      {kFiles, "P", "save an image of the window", Key::kP, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.wishes.saveImage = true; }},
      {kFiles, "K", "save the camera, for --camera", Key::kK, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.wishes.saveCamera = true; }},
      {kFiles, "V", "record a video, and end it", Key::kV, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.wishes.record = true; }},
      {kFiles, "F11", "the whole screen", Key::kF11, false, false, 0,
       [](ExploreKeyTarget& target, int) { target.wishes.fullscreen = true; }},
      {kFiles, "Escape", "leave help, the mouse, options", Key::kEscape, false, false, 0, escape},
      {kFiles, "Ctrl + Q", "quit", Key::kQ, false, true, 0,
       [](ExploreKeyTarget& target, int) { target.wishes.close = true; }},
  };
  return rows;
}

constexpr std::array kPointerRows{
    ExplorePointerRow{"Drag", "look around"},
    ExplorePointerRow{"Click", "pick a portal, an occluder, a target"},
    ExplorePointerRow{"Right click", "the mouse looks around, as C"},
    ExplorePointerRow{"Click in the plan", "go there"},
    ExplorePointerRow{"Drop a file", "show its camera"},
    ExplorePointerRow{"Wheel in the plan", "nearer, farther"},
};

}  // namespace

std::span<const ExploreHeldKey> exploreHeldKeys() {
  return kHeldKeys;
}

std::span<const ExploreKeyAction> exploreKeyActions() {
  return actionRows();
}

std::span<const ExplorePointerRow> explorePointerRows() {
  return kPointerRows;
}

const ExploreKeyAction* exploreActionOf(const KeyEvent& event) {
  const auto& rows = actionRows();
  const auto found = std::ranges::find_if(rows, [&](const ExploreKeyAction& row) {
    return row.key == event.key && row.shift == event.modifiers.shift && row.control == event.modifiers.control;
  });
  return event.pressed && !event.modifiers.alt && found != rows.end() ? &*found : nullptr;
}

const ExploreKeyAction* exploreActionOfPadButton(int button) {
  const auto& rows = actionRows();
  const auto found = std::ranges::find(rows, button, &ExploreKeyAction::padButton);
  return button >= 0 && found != rows.end() ? &*found : nullptr;
}

void changeExploreField(ExploreKeyTarget& target, size_t row, double steps) {
  if (target.picture == nullptr || row >= target.picture->fields.size()) {
    return;
  }
  // By how much, not to what: several presses may come while one frame is drawn.
  const std::string name = target.picture->fields[row].name;
  target.work.tell([name, steps](ExploreWindowModel& model) {
    model.changeField(name, steps);
    return std::string();
  });
}

}  // namespace ocelli
