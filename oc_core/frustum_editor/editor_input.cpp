#include "oc_core/frustum_editor/editor_input.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "oc_core/base/number_text.h"

namespace ocelli {
namespace {

constexpr double kTopShare = 0.6;   // of the area: the plan from above
constexpr double kWheelZoom = 1.2;  // a step of the wheel
constexpr double kFineStep = 0.1;   // of the grid: what an arrow moves; Shift: a whole one
constexpr size_t kMaxEntry = 40;    // characters

const std::vector<EditorKey>& keyRows() {
  static const std::vector<EditorKey> rows = [] {
    std::vector<EditorKey> all;
    for (const EditorTool& tool : editorTools()) {
      const Key key = *keyFromName(std::string_view(&tool.key, 1));
      all.push_back({"", "", key, false,
                     [](EditorInput& input, int which) {
                       input.editor().chooseTool(editorTools()[static_cast<size_t>(which)].name);
                     },
                     static_cast<int>(&tool - editorTools().data())});
    }
    const auto move = [](EditorInput& input, int direction) {
      constexpr std::array<glm::dvec2, 4> steps{glm::dvec2{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
      input.moveBy(steps[static_cast<size_t>(direction)]);
    };
    const auto next = [](EditorInput& input, int step) {
      input.editor().selectNextHandle(input.plans()[input.active()].window.side, step);
    };
    const std::vector<EditorKey> others{
        {"Tab  PageUp", "select the next, previous handle", Key::kTab, false, next, 1},
        {"", "", Key::kPageDown, false, next, 1},
        {"", "", Key::kPageUp, false, next, -1},
        {"Arrows", "move the selected handle, or the crosshair; Shift: farther", Key::kLeft, false, move, 0},
        {"", "", Key::kRight, false, move, 1},
        {"", "", Key::kUp, false, move, 2},
        {"", "", Key::kDown, false, move, 3},
        {"Enter", "press and release at the crosshair; take what is typed", Key::kEnter, false,
         [](EditorInput& input, int) { input.pressOrRelease(); }},
        {"0 ... 9  -  .", "type the chosen number of the handle", Key::k0, false, nullptr},
        {"N", "choose another number of the handle", Key::kN, false,
         [](EditorInput& input, int) { input.chooseNextNumber(); }},
        {"F2", "type a name for the selected frustum", Key::kF2, false,
         [](EditorInput& input, int) { input.beginRename(); }},
        {"Delete", "delete the selected frustum, with all that comes from it", Key::kDelete, false,
         [](EditorInput& input, int) { input.editor().removeSelected(); }},
        {"O", "allow overlaps, and refuse them", Key::kO, false,
         [](EditorInput& input, int) { input.editor().allowOverlap(!input.editor().drawn().overlapAllowed); }},
        {"P", "keys act in the other plan", Key::kP, false, [](EditorInput& input, int) { input.switchPlan(); }},
        {"F", "the side plan from the front, or from the right", Key::kF, false,
         [](EditorInput& input, int) { input.turnSidePlan(); }},
        {"+  -", "nearer, farther", Key::kEqual, false, [](EditorInput& input, int) { input.zoomBy(kWheelZoom); }},
        {"", "", Key::kMinus, false, [](EditorInput& input, int) { input.zoomBy(1 / kWheelZoom); }},
        {"Ctrl + Z  Ctrl + Y", "undo, redo", Key::kZ, true, [](EditorInput& input, int) { input.editor().undo(); }},
        {"", "", Key::kY, true, [](EditorInput& input, int) { input.editor().redo(); }},
        {"Ctrl + S", "save the camera, for --camera", Key::kS, true, [](EditorInput& input, int) { input.save(); }},
        {"Escape", "leave the drag, or what is typed", Key::kEscape, false,
         [](EditorInput& input, int) { input.escape(); }}};
    all.insert(all.end(), others.begin(), others.end());
    return all;
  }();
  return rows;
}

/// What a key types; nothing for others.
std::optional<char> typedBy(const KeyEvent& event) {
  const std::string_view name = nameOf(event.key);
  if (name.size() == 1) {
    const char c = name[0];
    return event.modifiers.shift ? c : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return event.key == Key::kMinus    ? std::optional('-')
         : event.key == Key::kPeriod ? std::optional('.')
         : event.key == Key::kSpace  ? std::optional(' ')
                                     : std::nullopt;
}

bool isOfNumber(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '.';
}

}  // namespace

std::span<const EditorKey> editorKeys() {
  return keyRows();
}

EditorInput::EditorInput(FrustumEditor& editor, const Box& world, std::function<void()> save)
    : editor_(&editor), world_(world), save_(std::move(save)) {
  plans_[0].window.side = PlanSide::kTop;
  plans_[1].window.side = PlanSide::kFront;
}

void EditorInput::layOut(const glm::dvec2& corner, const glm::ivec2& size) {
  const int top = std::max(1, static_cast<int>(size.y * kTopShare));
  const std::array<glm::ivec2, 2> sizes{glm::ivec2(std::max(1, size.x), top),
                                        glm::ivec2(std::max(1, size.x), std::max(1, size.y - top))};
  plans_[0].corner = corner;
  plans_[1].corner = corner + glm::dvec2(0, top);
  for (size_t i = 0; i < plans_.size(); ++i) {
    if (!laidOut_) {
      plans_[i].window = PlanWindow::around(plans_[i].window.side, world_, sizes[i]);
      plans_[i].crosshair = plans_[i].window.middle;
    }
    plans_[i].window.size = sizes[i];
  }
  laidOut_ = true;
}

std::string EditorInput::chosenNumber() const {
  const std::vector<HandleNumber> numbers = editor_->numbers(plans_[active_].window.side);
  return numbers.empty() ? "" : numbers[number_ % numbers.size()].name;
}

PlanPointer EditorInput::pointerAt(size_t plan, const glm::dvec2& pointer) const {
  return PlanPointer::at(plans_[plan].window, pointer - plans_[plan].corner, !shift_);
}

std::optional<size_t> EditorInput::planAt(const glm::dvec2& pointer) const {
  for (size_t i = 0; i < plans_.size(); ++i) {
    const glm::dvec2 at = pointer - plans_[i].corner;
    if (at.x >= 0 && at.y >= 0 && at.x < plans_[i].window.size.x && at.y < plans_[i].window.size.y) {
      return i;
    }
  }
  return std::nullopt;
}

bool EditorInput::handle(const InputEvent& event, const glm::dvec2& pointer) {
  const glm::dvec2 moved = pointer - last_;
  last_ = pointer;
  if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
    shift_ = button->modifiers.shift;
    if (!button->pressed) {
      if (pressed_ && !pans_) {
        editor_->release();
      }
      return std::exchange(pressed_, std::nullopt).has_value();
    }
    pressed_ = planAt(pointer);
    if (!pressed_) {
      return false;
    }
    active_ = *pressed_;
    pans_ = button->button != PointerButton::kLeft;
    if (!pans_) {
      plan().crosshair = plan().window.paperFromPixel(pointer - plan().corner);
      editor_->press(pointerAt(active_, pointer));
      number_ = 0;
    }
    return true;
  }
  if (const auto* scroll = std::get_if<ScrollEvent>(&event)) {
    const std::optional<size_t> at = planAt(pointer);
    if (at) {
      plans_[*at].window.zoom(std::pow(kWheelZoom, scroll->up), pointer - plans_[*at].corner);
    }
    return at.has_value();
  }
  if (std::holds_alternative<PointerMoveEvent>(event) && pressed_) {
    if (pans_) {
      plan().window.pan(moved);
    } else {
      plan().crosshair = plan().window.paperFromPixel(pointer - plan().corner);
      editor_->dragTo(pointerAt(*pressed_, pointer));
    }
    return true;
  }
  return false;
}

bool EditorInput::handle(const KeyEvent& event) {
  shift_ = event.modifiers.shift;
  if (!event.pressed || event.modifiers.alt) {
    return false;
  }
  if (!event.modifiers.control && type(event)) {
    return true;
  }
  for (const EditorKey& row : keyRows()) {
    if (row.act != nullptr && row.key == event.key && row.control == event.modifiers.control) {
      row.act(*this, row.argument);
      return true;
    }
  }
  return false;
}

bool EditorInput::type(const KeyEvent& event) {
  if (entry_ && event.key == Key::kBackspace) {
    if (!entry_->text.empty()) {
      entry_->text.pop_back();
    }
    return true;
  }
  const std::optional<char> typed = typedBy(event);
  if (!typed) {
    return false;
  }
  if (!entry_) {
    // A minus alone is a key of its own; a digit begins a number.
    const std::string number = chosenNumber();
    if (number.empty() || !isOfNumber(*typed)) {
      return false;
    }
    isRenaming_ = false;
    entry_ = EditorEntry{number, ""};
  }
  if ((isRenaming_ || isOfNumber(*typed)) && entry_->text.size() < kMaxEntry) {
    entry_->text += *typed;
  }
  return true;
}

/// What is no number stays, to be corrected.
void EditorInput::finishEntry() {
  if (isRenaming_) {
    const std::string name = entry_->text;
    entry_.reset();
    editor_->renameSelected(name);
  } else if (const std::optional<double> value = numberFromText<double>(entry_->text)) {
    const std::string number = entry_->label;
    entry_.reset();
    editor_->typeNumber(plan().window.side, number, *value);
  }
}

void EditorInput::moveBy(const glm::dvec2& steps) {
  const double step = gridStep(plan().window.unitsPerPixel) * (shift_ ? 1 : kFineStep);
  if (!editor_->isDragging() && editor_->selectedHandle(plan().window.side)) {
    editor_->nudge(plan().window.side, steps * step);
    return;
  }
  plan().crosshair += steps * step;
  if (editor_->isDragging()) {
    editor_->dragTo({plan().window.side, plan().crosshair, kPlanReachPixels * plan().window.unitsPerPixel, false});
  }
}

void EditorInput::pressOrRelease() {
  if (entry_) {
    finishEntry();
  } else if (editor_->isDragging()) {
    editor_->release();
  } else {
    editor_->press({plan().window.side, plan().crosshair, kPlanReachPixels * plan().window.unitsPerPixel, !shift_});
  }
}

void EditorInput::escape() {
  if (entry_) {
    entry_.reset();
  } else {
    editor_->cancel();
    pressed_.reset();
  }
}

void EditorInput::chooseNextNumber() {
  ++number_;
}

void EditorInput::beginRename() {
  if (!editor_->selectedFrustum().empty()) {
    isRenaming_ = true;
    entry_ = EditorEntry{"name", ""};
  }
}

void EditorInput::switchPlan() {
  editor_->cancel();
  active_ = 1 - active_;
}

void EditorInput::turnSidePlan() {
  editor_->cancel();
  PlanWindow& window = plans_[1].window;
  window =
      PlanWindow::around(window.side == PlanSide::kFront ? PlanSide::kRight : PlanSide::kFront, world_, window.size);
  plans_[1].crosshair = window.middle;
}

void EditorInput::zoomBy(double factor) {
  plan().window.zoom(factor, plan().window.pixelFromPaper(plan().crosshair));
}

}  // namespace ocelli
