#include "oc_core/feeds_window/feeds_window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/free_file_name.h"
#include "oc_core/feeds_window/feed_marks.h"
#include "oc_core/image/png_file.h"
#include "oc_core/window/gui_help.h"

namespace ocelli {
namespace {

constexpr double kMessageSeconds = 4;
constexpr double kRateSmoothing = 0.1;  ///< share of the newest image in the rate that is shown
constexpr float kRim = 10;              ///< screen coordinates at 96 dots an inch, here and below
constexpr float kHelpWidth = 520;
constexpr float kOutlineWidth = 2;

}  // namespace

FeedsWindow::FeedsWindow(GlContext& context, const FeedGraph& graph, FeedsScreen& screen, std::filesystem::path folder)
    : GuiWindow(context), graph_(graph), screen_(screen), folder_(std::move(folder)) {}

void FeedsWindow::take(const InputEvent& event) {
  const auto* key = std::get_if<KeyEvent>(&event);
  if (key == nullptr || !key->pressed) {
    return;
  }
  const bool wasRed = state_.hasRedErased;
  for (const FeedsKeyAction& row : feedsKeyActions()) {
    if (std::ranges::find(row.keys, key->key) != row.keys.end()) {
      row.act(state_);
    }
  }
  if (wasRed != state_.hasRedErased) {
    screen_.setErased(state_.hasRedErased ? ErasedLook::kRed : ErasedLook::kBackground);
  }
}

void FeedsWindow::advance(double seconds) {
  sinceImage_ += seconds;
  if (auto newest = screen_.take()) {
    if (shown_ && !screen_.isPaused()) {
      imageSeconds_ += (imageSeconds_ > 0 ? kRateSmoothing : 1) * (sinceImage_ - imageSeconds_);
    }
    sinceImage_ = 0;
    shown_ = std::move(newest);
    isUploaded_ = false;
    requestDrawing();
  }
  if (!message_.empty() && (messageLeft_ -= seconds) <= 0) {
    message_.clear();
    requestDrawing();
  }
  if (std::exchange(state_.wantsPause, false)) {
    if (screen_.isLive()) {
      say("live feeds cannot be paused");
    } else {
      screen_.setPaused(!screen_.isPaused());
    }
  }
  if (std::exchange(state_.wantsStep, false)) {
    screen_.step();
  }
  if (std::exchange(state_.wantsSave, false)) {
    save();
  }
  if (wasEnded_ != screen_.hasEnded()) {
    wasEnded_ = !wasEnded_;
    requestDrawing();
  }
}

void FeedsWindow::say(const std::string& message) {
  message_ = message;
  messageLeft_ = kMessageSeconds;
  requestDrawing();
}

void FeedsWindow::save() {
  const Image<Rgb8> image = picture();
  if (image.empty()) {
    say("there is no image yet");
    return;
  }
  try {
    const std::filesystem::path path = makeFreeFile(folder_, "feeds", ".png");
    writePng(path, image);
    say("wrote " + path.string());
  } catch (const Error& error) {
    say(error.what());
  }
}

void FeedsWindow::layOut(float barHeight) {
  const glm::ivec2 room(pixels().x, std::max(1, pixels().y - static_cast<int>(std::ceil(barHeight * pixelsPerUnit()))));
  const glm::dvec2 image(graph_.setup().output.width, graph_.setup().output.height);
  const double scale = std::min(room.x / image.x, room.y / image.y);
  imageSize_ = glm::max(glm::ivec2(1), glm::ivec2(glm::dvec2(image * scale) + 0.5));
  corner_ = (room - imageSize_) / 2;
}

void FeedsWindow::paint() {
  if (shown_ && !std::exchange(isUploaded_, true)) {
    texture_.upload(context(), shown_->image);
  }
}

void FeedsWindow::drawPanels() {
  const float bar = barHeight();  // known within a frame of Dear ImGui alone
  layOut(bar);
  if (shown_) {
    texture_.copyTo(context(), target().framebuffer(), corner_, imageSize_);
  }
  if (shown_ && state_.hasOutlines) {
    drawOutlines();
  }
  if (shown_ && state_.hasLabels) {
    drawLabels();
  }
  if (std::exchange(isBare_, false)) {
    return;
  }
  drawBar(bar);
  if (state_.hasHelp) {
    drawHelp();
  }
}

void FeedsWindow::drawOutlines() {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float scale = lengthScale();
  const double perPixel = imageSize_.x / (pixelsPerUnit() * graph_.setup().output.width);
  for (size_t i = 1; i < graph_.frusta(); ++i) {
    std::vector<ImVec2> points;
    for (const glm::dvec2& p : graph_.camera().frusta()[i].part) {
      const glm::vec2 at(glm::dvec2(corner_) / pixelsPerUnit() + p * perPixel);
      points.emplace_back(at.x, at.y);
    }
    const int count = static_cast<int>(points.size());
    list.AddPolyline(points.data(), count, kOkabeItoBlack.packed(), ImDrawFlags_Closed, 2 * kOutlineWidth * scale);
    list.AddPolyline(points.data(), count, kOkabeItoYellow.packed(), ImDrawFlags_Closed, kOutlineWidth * scale);
  }
}

void FeedsWindow::drawLabels() {
  const float scale = lengthScale();
  const double perPixel = imageSize_.x / (pixelsPerUnit() * graph_.setup().output.width);
  for (size_t i = 0; i < shown_->labels.size(); ++i) {
    glm::dvec2 corner(graph_.setup().output.width, graph_.setup().output.height);
    for (const glm::dvec2& p : graph_.camera().frusta()[i].part) {
      corner = glm::min(corner, p);
    }
    const glm::vec2 at(glm::dvec2(corner_) / pixelsPerUnit() + corner * perPixel);
    drawFeedPlate(*ImGui::GetBackgroundDrawList(), at + 0.5f * kRim * scale, graph_.feedOf(i).name, shown_->labels[i],
                  scale);
  }
}

float FeedsWindow::barHeight() const {
  const float scale = lengthScale();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  float lines = 2;
  float x = 0;
  const float width = static_cast<float>(size().x) - 2 * kRim * scale;
  for (size_t i = 0; shown_ && i < shown_->labels.size(); ++i) {
    const float each = feedStateWidth(graph_.feedOf(i).name, shown_->labels[i], scale);
    if (x > 0 && x + each > width) {
      ++lines;
      x = 0;
    }
    x += each;
  }
  return lines * line + kRim * scale;
}

void FeedsWindow::drawBar(float height) {
  const float scale = lengthScale();
  const glm::vec2 window(size());
  ImGui::SetNextWindowPos({0, window.y - height});
  ImGui::SetNextWindowSize({window.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kRim * scale, kRim * scale / 2});
  ImGui::Begin(
      "bar", nullptr,
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs);
  std::string line = shown_ ? fmt::format("{:.1f} s", shown_->seconds) : "waits for the feeds";
  if (imageSeconds_ > 0) {
    line += fmt::format("   {:.0f} images a second", 1 / imageSeconds_);
  }
  line += state_.hasRedErased ? "   red: erased, not live" : "";
  line += screen_.isPaused() ? "   PAUSED" : "";
  line += screen_.hasEnded() ? "   the run has ended" : "";
  line += "   H: help";
  line += message_.empty() ? "" : "   " + message_;
  ImGui::TextUnformatted(line.c_str());
  glm::vec2 at(ImGui::GetCursorScreenPos().x, ImGui::GetCursorScreenPos().y);
  const float left = at.x;
  for (size_t i = 0; shown_ && i < shown_->labels.size(); ++i) {
    const std::string& name = graph_.feedOf(i).name;
    const float width = feedStateWidth(name, shown_->labels[i], scale);
    if (at.x > left && at.x + width > window.x - kRim * scale) {
      at = {left, at.y + ImGui::GetTextLineHeightWithSpacing()};
    }
    drawFeedState(*ImGui::GetWindowDrawList(), at, name, shown_->labels[i], scale);
    at.x += width;
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void FeedsWindow::drawHelp() {
  const float scale = lengthScale();
  GuiHelp help(size(), scale, kHelpWidth, 110, "One image of several cameras' feeds");
  help.rows(feedsKeyActions());
  ImGui::Separator();
  for (const FeedStateMeaning& row : feedStateMeanings()) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    drawFeedMark(*ImGui::GetWindowDrawList(), {at.x, at.y}, row.state, scale);
    ImGui::SetCursorScreenPos({at.x + 20 * scale, at.y});
    ImGui::TextUnformatted(row.meaning);
  }
}

Image<Rgb8> FeedsWindow::picture() {
  if (!shown_ || pixels().x <= 0 || pixels().y <= 0) {
    return {};
  }
  isBare_ = true;
  draw();
  requestDrawing();
  const Image<Rgb8> whole = screenshot();
  Image<Rgb8> image(imageSize_.x, imageSize_.y);
  for (int y = 0; y < imageSize_.y; ++y) {
    for (int x = 0; x < imageSize_.x; ++x) {
      image(x, y) = whole(corner_.x + x, corner_.y + y);
    }
  }
  return image;
}

}  // namespace ocelli
