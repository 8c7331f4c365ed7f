#include "oc_core/explore_window/explore_window.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "oc_core/base/error.h"
#include "oc_core/base/free_file_name.h"
#include "oc_core/base/output_file.h"
#include "oc_core/explore_window/explore_gui_pieces.h"
#include "oc_core/explore_window/explore_overlays.h"

namespace ocelli {
namespace {

constexpr double kMessageSeconds = 4;
/// A hint that has gone, or that who walks needs no more.
constexpr double kHintOver = 60;
constexpr double kFrameSmoothing = 0.1;  // share of the newest picture in the rate that is shown

/// Under the next free name, which stays free where it cannot be written. Returns it.
std::string writeNextFree(const std::filesystem::path& folder, const std::string& stem, const std::string& ending,
                          const std::function<void(const std::filesystem::path& path)>& write) {
  const std::filesystem::path path = makeFreeFile(folder, stem, ending);
  try {
    write(path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    throw;
  }
  return path.string();
}

/// Returns where.
std::string writeCamera(const std::filesystem::path& folder, const std::string& text) {
  return writeNextFree(folder, "camera", ".json", [&](const std::filesystem::path& path) {
    OutputFile file(path);
    file.write(text);
    file.commit();
  });
}

}  // namespace

ExploreWindow::ExploreWindow(GlContext& context, ExploreWindowOptions options)
    : context_(context),
      options_(std::move(options)),
      work_(options_.make, options_.way, options_.woken),
      gui_(context, 1),
      target_(context) {
  for (const ExplorePaneKind& kind : explorePanes()) {
    panes_.push_back(kind.make());
  }
}

std::vector<size_t> ExploreWindow::shownKinds() const {
  std::vector<size_t> shown;
  const auto kinds = explorePanes();
  for (size_t i = 0; i < kinds.size(); ++i) {
    if (i == 0 || state_.shown.contains(kinds[i].name)) {
      shown.push_back(i);
    }
  }
  return shown;
}

ExploreWindowLayout ExploreWindow::layout() const {
  const std::vector<size_t> shown = shownKinds();
  float share = 0;
  for (const size_t kind : shown) {
    share = std::max(share, explorePanes()[kind].widthShare);
  }
  return exploreWindowLayout(shown, share, {window_.width, window_.height}, lengthScale());
}

ExplorePaneFrame ExploreWindow::frameOf(const ExploreWindowLayout::Pane& pane) {
  return {pane.rect, lengthScale(), static_cast<float>(window_.pixelsPerUnit), status_.picture.get(), isFresh_,
          state_,    work_};
}

ExploreKeyTarget ExploreWindow::keyTarget() {
  return {state_, work_, wishes_, status_.picture.get()};
}

void ExploreWindow::say(const std::string& text, bool isError) {
  state_.message = text;
  state_.messageIsError = isError;
  state_.messageSeconds = kMessageSeconds;
  needsDrawing_ = true;
}

void ExploreWindow::takeStatus() {
  const uint64_t before = status_.pictureCount;
  const std::string stage = status_.stage;
  const double fraction = status_.fraction;
  status_ = work_.status();
  if (status_.pictureCount != before) {
    isFresh_ = needsDrawing_ = true;
    // Pictures of one walk follow each other; after a rest the time between says nothing.
    if (sincePicture_ > 0 && sincePicture_ < 0.5) {
      secondsOfFrame_ =
          secondsOfFrame_ == 0 ? sincePicture_ : secondsOfFrame_ + (sincePicture_ - secondsOfFrame_) * kFrameSmoothing;
    }
    sincePicture_ = 0;
  }
  needsDrawing_ = needsDrawing_ || stage != status_.stage || fraction != status_.fraction;
  for (const ExploreWindowMessage& message : status_.messages) {
    say(message.text, message.isError);
  }
  status_.messages.clear();
}

WindowMotion ExploreWindow::motion() const {
  WindowMotion motion = heldByOthers_;
  const auto add = [&](const WindowMotion& more) {
    for (float WindowMotion::*part : {&WindowMotion::ahead, &WindowMotion::right, &WindowMotion::up,
                                      &WindowMotion::turnRight, &WindowMotion::lookUp}) {
      motion.*part = std::clamp(motion.*part + more.*part, -1.0f, 1.0f);
    }
    motion.fast = motion.fast || more.fast;
  };
  add(padMotion_);
  for (const ExploreHeldKey& row : exploreHeldKeys()) {
    if (held_[static_cast<size_t>(row.key)]) {
      WindowMotion part;
      part.*row.part = row.amount;
      part.fast = shift_;
      add(part);
    }
  }
  motion.turnedDegrees += state_.turnedDegrees;
  return motion;
}

WindowShape ExploreWindow::shape() {
  WindowShape shape;
  for (const ExploreWindowLayout::Pane& pane : layout().panes) {
    panes_[pane.kind]->ask(frameOf(pane), shape);
  }
  return shape;
}

void ExploreWindow::update(double seconds) {
  seconds_ += seconds;
  sincePicture_ += seconds;
  const WindowMotion wanted = motion();
  state_.turnedDegrees = {0, 0};
  work_.want(wanted, shape());
  heldByOthers_.turnedDegrees = {0, 0};
  if (options_.way == ExploreWindowWork::Way::kStepwise) {
    work_.step(seconds);
  }
  takeStatus();
  if (status_.picture && state_.hintSeconds < kHintOver) {
    const float before = exploreHintOpacity(state_.hintSeconds);
    state_.hintSeconds += seconds;
    needsDrawing_ = needsDrawing_ || exploreHintOpacity(state_.hintSeconds) != before;
  }
  if (!state_.message.empty() && !state_.messageIsError) {
    state_.messageSeconds -= seconds;
    if (state_.messageSeconds <= 0) {
      state_.message.clear();
      needsDrawing_ = true;
    }
  }
}

bool ExploreWindow::isLively() const {
  return work_.isBusy() || !(motion() == WindowMotion{.fast = shift_}) || isPressed_ || state_.captured;
}

void ExploreWindow::draw() {
  const GlScope scope(context_);
  const auto pixels = [this](int units) {
    return std::max(1, static_cast<int>(std::lround(units * window_.pixelsPerUnit)));
  };
  target_.resize(pixels(window_.width), pixels(window_.height));
  target_.clear(kGuiBackground);
  const ExploreWindowLayout places = layout();
  for (const ExploreWindowLayout::Pane& pane : places.panes) {
    panes_[pane.kind]->paint(frameOf(pane), context_, target_.framebuffer());
  }
  target_.bind();
  gui_.beginFrame(seconds_);
  seconds_ = 0;
  ExploreKeyTarget target = keyTarget();
  std::vector<ExplorePaneHelp> paneHelp;
  for (const ExploreWindowLayout::Pane& pane : places.panes) {
    if (state_.active == explorePanes()[pane.kind].name) {
      paneHelp = panes_[pane.kind]->help();
    }
  }
  const ExploreOverlayFrame overlay{places,
                                    target,
                                    status_,
                                    lengthScale(),
                                    static_cast<float>(window_.width),
                                    options_.showTimes,
                                    secondsOfFrame_ > 0 ? 1 / secondsOfFrame_ : 0,
                                    paneHelp};
  for (const ExploreWindowLayout::Pane& pane : places.panes) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});  // what is drawn ends with the pane
    beginExploreArea(explorePanes()[pane.kind].name, pane.rect, kGuiBackground, 0, false);
    ImGui::PopStyleVar();
    panes_[pane.kind]->draw(frameOf(pane));
    ImGui::End();
  }
  for (const auto draw : {drawExploreChoices, drawExploreTitles, drawExploreStatus, drawExploreForm, drawExploreHint,
                          drawExploreProgress, drawExploreMessage, drawExploreHelp}) {
    draw(overlay);
  }
  gui_.endFrame();
  context_.check("drawing the window");
  isFresh_ = false;
  // Panels are laid out in the frame that opens them, and show in the next.
  needsDrawing_ = gui_.hasWaitingEvents() || std::exchange(needsAnother_, false);
  performWishes();
}

Image<Rgb8> ExploreWindow::screenshot() const {
  const GlScope scope(context_);
  return target_.read();
}

void ExploreWindow::performWishes() {
  try {
    if (std::exchange(wishes_.saveImage, false)) {
      saveImage();
    }
    if (std::exchange(wishes_.saveCamera, false)) {
      saveCamera();
    }
    if (const std::optional<std::string> text = std::exchange(state_.cameraToSave, std::nullopt)) {
      say("saved " + writeCamera(options_.folder, *text) + ", for --camera", false);
    }
  } catch (const Error& error) {
    say(error.what(), true);
  }
}

void ExploreWindow::saveImage() {
  say("saved " + writeNextFree(options_.folder, "explore", ".png",
                               [this](const std::filesystem::path& path) { writePng(path, screenshot()); }),
      false);
}

void ExploreWindow::saveCamera() {
  // On the thread that walks, so that it is the camera of a moment.
  work_.tell([folder = options_.folder](const ExploreWindowModel& model) {
    // The camera first: where there is none, no file is made.
    const std::string text = model.cameraFile();
    return "saved " + writeCamera(folder, text) + ", for --camera" + model.cameraFileLacks();
  });
}

}  // namespace ocelli
