#include "oc_core/feeds_editor_window/face_window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/window/gui_help.h"
#include "oc_core/window/gui_window_run.h"

namespace ocelli {
namespace {

constexpr double kPlanShare = 0.58;  ///< of the width of the window
constexpr float kBarHeight = 64;     ///< screen coordinates at 96 dots an inch, here and below
constexpr float kHelpWidth = 560;
constexpr double kReach = 12;
constexpr double kZoomStep = 1.15;
constexpr ImGuiWindowFlags kPaneFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace

FaceWindow::FaceWindow(GlContext& context, FaceEditor& editor, FaceWindowOptions options)
    : GuiWindow(context),
      editor_(editor),
      options_(std::move(options)),
      preview_(options_.frames),
      saved_(editor.setup()),
      message_(options_.message) {}

double FaceWindow::reach() const {
  return kReach * lengthScale() * plan_->unitsPerPixel;
}

glm::dvec2 FaceWindow::windowFromPlan(const glm::dvec2& paper) const {
  return plan_->pixelFromPaper(paper);
}

void FaceWindow::layOut() {
  const double bar = kBarHeight * lengthScale();
  planSize_ = {std::max(1, static_cast<int>(size().x * kPlanShare)), std::max(1, static_cast<int>(size().y - bar))};
  if (!plan_ || std::exchange(state_.wantsAll, false)) {
    plan_ = planAround(editor_, options_.walls, planSize_);
  }
  plan_->size = planSize_;
}

void FaceWindow::press(const KeyEvent& event) {
  hasShift_ = event.modifiers.shift;
  if (!event.pressed) {
    return;
  }
  for (const FaceKeyAction& row : faceKeyActions()) {
    if (row.hasControl == event.modifiers.control && std::ranges::find(row.keys, event.key) != row.keys.end()) {
      message_.clear();
      row.act(editor_, state_, event.modifiers);
    }
  }
  if (std::exchange(state_.wantsSave, false)) {
    save();
  }
}

void FaceWindow::save() {
  if (!editor_.problem().empty()) {
    message_ = "not saved: this is no graph camera yet";
    return;
  }
  try {
    message_ = options_.save(editor_.setup());
    saved_ = editor_.setup();
  } catch (const Error& error) {
    message_ = error.what();
  }
}

bool FaceWindow::mayClose() {
  if (saved_ == editor_.setup() || std::exchange(hasWarned_, true)) {
    return true;
  }
  message_ = "not saved: Ctrl+S saves, Escape once more leaves it";
  return false;
}

void FaceWindow::pressButton(const PointerButtonEvent& event) {
  hasShift_ = event.modifiers.shift;
  const bool isInPlan = pointer_.x < planSize_.x && pointer_.y < planSize_.y;
  if (event.button == PointerButton::kLeft) {
    if (!event.pressed) {
      editor_.release();
    } else if (isInPlan) {
      message_.clear();
      hasWarned_ = false;
      editor_.press(plan_->paperFromPixel(pointer_), reach());
    }
  } else {
    isPanning_ = event.pressed && isInPlan;
  }
}

void FaceWindow::move(const PointerMoveEvent& event) {
  const glm::dvec2 to(event.x, event.y);
  if (isPanning_) {
    plan_->pan(to - pointer_);
  }
  pointer_ = to;
  editor_.dragTo(plan_->paperFromPixel(to), reach(), gridStep(plan_->unitsPerPixel), !hasShift_);
}

void FaceWindow::take(const InputEvent& event) {
  if (std::holds_alternative<ResizeEvent>(event)) {
    layOut();
  } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
    press(*key);
  } else if (const auto* button = std::get_if<PointerButtonEvent>(&event)) {
    pressButton(*button);
  } else if (const auto* moved = std::get_if<PointerMoveEvent>(&event)) {
    move(*moved);
  } else if (const auto* scrolled = std::get_if<ScrollEvent>(&event)) {
    plan_->zoom(std::pow(kZoomStep, scrolled->up), pointer_);
  }
}

void FaceWindow::paint() {
  if (preview_.update(editor_.graph())) {
    texture_.upload(context(), preview_.image());
  }
}

void FaceWindow::drawPanels() {
  layOut();
  drawPlan();
  drawSide();
  drawBar();
  if (state_.hasHelp) {
    drawHelp();
  }
}

void FaceWindow::drawPlan() {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({static_cast<float>(planSize_.x), static_cast<float>(planSize_.y)});
  ImGui::Begin("plan", nullptr, kPaneFlags);
  drawFacePlan(*ImGui::GetWindowDrawList(), *plan_, {0, 0}, editor_, options_.walls, lengthScale());
  ImGui::End();
}

void FaceWindow::drawSide() {
  const float scale = lengthScale();
  const float left = static_cast<float>(planSize_.x);
  const float width = static_cast<float>(size().x) - left;
  ImGui::SetNextWindowPos({left, 0});
  ImGui::SetNextWindowSize({width, static_cast<float>(planSize_.y)});
  ImGui::Begin("side", nullptr, kPaneFlags);
  drawImage(ImGui::GetContentRegionAvail().x, scale);
  const auto faces = editor_.faces();
  const FeedSetup& setup = editor_.setup();
  for (size_t i = 0; i < setup.feeds.size(); ++i) {
    const std::string& name = setup.feeds[i].name;
    const auto face = std::ranges::find(faces, name, &PlanFace::feed);
    std::string line = (name == editor_.selected() ? "> " : "   ") + name;
    if (face != faces.end()) {
      line += fmt::format("   from {}, {:.2f} m wide, from {:.2f} to {:.2f} m", face->parent,
                          glm::distance(face->from, face->to), face->bottom, face->top);
    } else {
      line += name == setup.frusta.front().feed ? "   the root" : "   no face: drag in the plan to draw it";
    }
    ImGui::PushStyleColor(ImGuiCol_Text, feedColor(i).packed());
    ImGui::TextWrapped("%s", line.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::End();
}

void FaceWindow::drawImage(float width, float scale) {
  const Image<Rgb8>& image = preview_.image();
  if (image.empty()) {
    ImGui::TextUnformatted("no image: this is no graph camera yet");
    return;
  }
  const float perPixel = width / static_cast<float>(image.width());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Image(GuiLayer::imageOf(texture_.texture()), {width, perPixel * static_cast<float>(image.height())});
  const FeedGraph& graph = *preview_.graph();
  for (size_t i = 1; i < graph.frusta(); ++i) {
    std::vector<ImVec2> points;
    for (const glm::dvec2& p : graph.camera().frusta()[i].part) {
      points.emplace_back(corner.x + perPixel * static_cast<float>(p.x), corner.y + perPixel * static_cast<float>(p.y));
    }
    ImGui::GetWindowDrawList()->AddPolyline(points.data(), static_cast<int>(points.size()),
                                            feedColor(graph.feedIndexOf(i)).packed(), ImDrawFlags_Closed,
                                            (graph.feedOf(i).name == editor_.selected() ? 3 : 1.5f) * scale);
  }
}

void FaceWindow::drawBar() {
  const float scale = lengthScale();
  const glm::vec2 window(size());
  ImGui::SetNextWindowPos({0, static_cast<float>(planSize_.y)});
  ImGui::SetNextWindowSize({window.x, window.y - static_cast<float>(planSize_.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * scale, 5 * scale});
  ImGui::Begin("bar", nullptr, kPaneFlags);
  if (!editor_.problem().empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kOkabeItoOrange.packed());
    ImGui::TextWrapped("PROBLEM: %s", editor_.problem().c_str());
    ImGui::PopStyleColor();
  }
  const bool isSaved = saved_ == editor_.setup();
  ImGui::TextWrapped("%s%s   H: help", message_.empty() ? "" : (message_ + "   ").c_str(),
                     isSaved ? "" : "changed, not saved");
  ImGui::End();
  ImGui::PopStyleVar();
}

void FaceWindow::drawHelp() {
  GuiHelp help(size(), lengthScale(), kHelpWidth, 130, "Near faces: where one camera's image goes on in another's");
  help.rows(facePointerLines(), faceKeyActions());
}

void runFaceWindow(FaceEditor& editor, const FaceWindowOptions& options, const std::function<bool()>& goesOn) {
  GlWindow window({.title = options.title, .width = 1280, .height = 800});
  FaceWindow shown(window.context(), editor, options);
  runGuiWindow(window, shown, goesOn);
}

}  // namespace ocelli
