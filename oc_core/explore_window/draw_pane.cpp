#include "oc_core/explore_window/draw_pane.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <future>
#include <optional>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/explore/explore_scene.h"
#include "oc_core/explore_window/explore_colors.h"
#include "oc_core/explore_window/explore_drawing_painter.h"
#include "oc_core/explore_window/explore_gui_pieces.h"
#include "oc_core/explore_window/explore_pane_choice.h"
#include "oc_core/frustum_editor/editor_drawing.h"
#include "oc_core/frustum_editor/editor_input.h"
#include "oc_core/frustum_editor/editor_preview.h"
#include "oc_core/page/page_colors.h"
#include "oc_core/window/gui_layer.h"
#include "oc_core/window/image_texture.h"

namespace ocelli {
namespace {

constexpr int kBackdropPixels = 1200;
constexpr float kDrawLineHeight = 26;  // of the lines of words below the plans, at 96 dots an inch

/// The scene under a plan, made on the thread that walks.
class DrawBackdrop {
 public:
  /// What is there of it; null while it is being made.
  const PlanBackdrop* of(PlanSide side, const glm::dvec3& eye, const std::shared_ptr<const ExploreScene>& scene,
                         ExploreWindowWork& work) {
    if (!asked_) {
      asked_ = true;
      const auto promise = std::make_shared<std::promise<PlanBackdrop>>();
      coming_ = promise->get_future();
      work.tell([promise, scene, side, eye](ExploreWindowModel&) {
        try {
          promise->set_value(planBackdrop(scene->mesh(), side, eye, kBackdropPixels));
        } catch (...) {
          promise->set_exception(std::current_exception());
          throw;  // which is said
        }
        return std::string();
      });
    }
    if (coming_.valid() && coming_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      try {
        backdrop_ = coming_.get();
        ground_ = std::exchange(backdrop_->ground, Image<Rgb8>());
      } catch (const std::exception&) {  // said already: the plan stays without it
      }
    }
    return backdrop_ ? &*backdrop_ : nullptr;
  }

  /// Hold a GlScope.
  void upload(GlContext& context) {
    if (!ground_.empty()) {
      texture_.upload(context, ground_);
      ground_ = Image<Rgb8>();
    }
  }

  void draw(ImDrawList& list, const EditorInput::Plan& plan, float scale) const {
    if (!texture_ || !backdrop_) {
      return;
    }
    const auto at = [&](const glm::vec2& paper) {
      const glm::vec2 point(plan.corner + plan.window.pixelFromPaper(glm::dvec2(paper)));
      return ImVec2(point.x * scale, point.y * scale);
    };
    list.AddImage(GuiLayer::imageOf(texture_.texture()), at(backdrop_->lower), at(backdrop_->upper));
  }

 private:
  bool asked_ = false;
  std::future<PlanBackdrop> coming_;
  std::optional<PlanBackdrop> backdrop_;
  Image<Rgb8> ground_;
  ImageTexture texture_;
};

class DrawPane : public ExplorePane {
 public:
  void paint(const ExplorePaneFrame& frame, GlContext& context, const GlObject&) override {
    begin(frame);
    for (DrawBackdrop& backdrop : backdrops_) {
      backdrop.upload(context);
    }
  }

  void draw(const ExplorePaneFrame& frame) override {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (!input_) {
      return;
    }
    // The editor draws and points in lengths at 96 dots an inch.
    const float scale = frame.scale;
    input_->layOut(glm::dvec2(frame.rect.x, frame.rect.y) / static_cast<double>(scale),
                   {std::max(1, static_cast<int>(frame.rect.width / scale)),
                    std::max(1, static_cast<int>(frame.rect.height / scale - 2 * kDrawLineHeight))});
    for (size_t i = 0; i < input_->plans().size(); ++i) {
      drawPlan(frame, list, i);
    }
    drawWords(frame, list);
    show(frame);
  }

  bool handlePointer(const ExplorePaneFrame& frame, const InputEvent& event, const glm::vec2& pointer) override {
    if (const auto* drop = std::get_if<DropEvent>(&event); drop != nullptr && input_ && !drop->files.empty()) {
      open(frame, drop->files.front());
      return true;
    }
    const bool used = input_ && input_->handle(event, glm::dvec2(pointer / frame.scale));
    if (used) {
      show(frame);
    }
    return used;
  }

  bool handleKey(const ExplorePaneFrame& frame, const KeyEvent& event) override {
    const bool isIdleEscape = event.key == Key::kEscape && input_ && !input_->entry() && !input_->editor().isDragging();
    if (!input_ || isIdleEscape || !input_->handle(event)) {
      return false;
    }
    show(frame);
    if (wantsSave_) {
      wantsSave_ = false;
      frame.state.cameraToSave = editor_->text();
    }
    return true;
  }

  std::vector<ExplorePaneHelp> help() const override {
    std::vector<ExplorePaneHelp> lines;
    for (const EditorTool& tool : editorTools()) {
      lines.push_back({std::string(1, tool.key) + "  " + tool.name, tool.says});
    }
    for (const EditorKey& key : editorKeys()) {
      if (*key.keys != '\0') {
        lines.push_back({key.keys, key.says});
      }
    }
    return lines;
  }

 private:
  /// A camera to begin with: as the walker looks, when the pane is opened or anew is asked for.
  void begin(const ExplorePaneFrame& frame) {
    if (frame.picture == nullptr || !frame.picture->scene || !frame.picture->pinholeCamera ||
        (editor_ && !frame.state.drawAnew)) {
      return;
    }
    const bool isCurved = frame.state.drawAnew == ExploreWindowState::DrawAnew::kCurved;
    frame.state.drawAnew.reset();
    const std::shared_ptr<const ExploreScene> scene = frame.picture->scene;
    const PinholeCamera& root = *frame.picture->pinholeCamera;
    std::unique_ptr<FrustumEditor> editor;
    std::unique_ptr<EditorInput> input;
    try {
      editor = std::make_unique<FrustumEditor>(
          isCurved ? FrustumEditor::newCurvedCamera(root) : FrustumEditor::newGraphCamera(root), "a new camera", root,
          scene->mesh(), scene->guides());
      input = std::make_unique<EditorInput>(*editor, scene->bounds(), [this] { wantsSave_ = true; });
    } catch (const InputError& error) {
      // Camera files do not take every view: too far away, or too near to it.
      say(frame, error);
      hideExplorePane(frame.state, kDrawPane);
      return;
    }
    // Each needs the one after it.
    input_ = std::move(input);
    editor_ = std::move(editor);
    scene_ = scene;
    eye_ = glm::dvec3(root.eye());
    backdrops_ = {};  // those of where the eye was
    shownRevision_ = -1;
  }

  void drawPlan(const ExplorePaneFrame& frame, ImDrawList& list, size_t index) {
    const EditorInput::Plan& plan = input_->plans()[index];
    const glm::vec2 corner = glm::vec2(plan.corner) * frame.scale;
    const glm::vec2 size = glm::vec2(plan.window.size) * frame.scale;
    const ImVec2 from(corner.x, corner.y);
    const ImVec2 to(corner.x + size.x, corner.y + size.y);
    list.PushClipRect(from, to, true);
    list.AddRectFilled(from, to, kDrawPaper.packed());
    DrawBackdrop& backdrop = backdrops_[static_cast<size_t>(plan.window.side)];
    const PlanBackdrop* const lines = backdrop.of(plan.window.side, eye_, scene_, frame.work);
    backdrop.draw(list, plan, frame.scale);
    paintExploreDrawing(list, planDrawing(*editor_, plan.window, lines), corner, frame.scale);
    const bool isActive = index == input_->active();
    if (isActive && frame.state.active == kDrawPane) {
      list.AddRect({from.x + 1, from.y + 1}, {to.x - 1, to.y - 1}, kGuiAccent.packed(), 0, 0, 2 * frame.scale);
    }
    list.PopClipRect();
    drawExploreBadge(list, corner + glm::vec2(34, 14) * frame.scale, nameOf(plan.window.side), kGuiText, frame.scale);
  }

  void drawWords(const ExplorePaneFrame& frame, ImDrawList& list) const {
    const float scale = frame.scale;
    const float left = frame.rect.x + 10 * scale;
    const float width = frame.rect.width - 20 * scale;
    float y = frame.rect.bottom() - 2 * kDrawLineHeight * scale + 5 * scale;
    const EditorTool& tool = editor_->tool();
    const std::string first =
        input_->entry() ? fmt::format("{}: {}_   Enter takes it", input_->entry()->label, input_->entry()->text)
                        : fmt::format("{}  {}: {}", tool.key, tool.name, tool.says);
    list.AddText({left, y}, kGuiText.packed(), fittedExploreText(first, width).c_str());
    y += kDrawLineHeight * scale;
    const bool isMessage = !editor_->message().empty();
    std::string tools;
    for (const EditorTool& each : editorTools()) {
      tools += std::string(1, each.key) + " ";
    }
    const std::string second =
        isMessage ? "!  " + editor_->message() : "Tools: " + tools + "   undo: Ctrl + Z   all keys: F1   back: Escape";
    list.AddText({left, y}, (isMessage ? kExploreAttention : kGuiTextDim).packed(),
                 fittedExploreText(second, width).c_str());
  }

  /// To go on with a camera of a file. The words below the plans say what is wrong with it.
  void open(const ExplorePaneFrame& frame, const std::string& file) {
    try {
      editor_->open(readFile(file, kMaxTextBytes), file);
    } catch (const InputError& error) {
      say(frame, error);
    }
    show(frame);
  }

  /// The camera as it is now, in the view: small while a drag goes on, so that the view keeps up with the hand.
  void show(const ExplorePaneFrame& frame) {
    const bool isSmall = editor_->isDragging();
    if (editor_->revision() == shownRevision_ && isSmall == shownSmall_) {
      return;
    }
    shownRevision_ = editor_->revision();
    shownSmall_ = isSmall;
    const int small = std::max(1, static_cast<int>(editor_->drawn().imageSize().x) / EditorPreview::kSmaller);
    try {
      frame.work.tell(
          [camera = isSmall ? editor_->cameraOfWidth(small) : editor_->camera()](ExploreWindowModel& model) {
            model.showDrawn(camera, "drawn by hand");
            return std::string();
          });
    } catch (const Error& error) {
      say(frame, error);
    }
  }

  static void say(const ExplorePaneFrame& frame, const Error& error) {
    frame.state.message = error.what();
    frame.state.messageIsError = true;
  }

  static constexpr GuiColor kDrawPaper{246, 246, 243};

  std::shared_ptr<const ExploreScene> scene_;  ///< which the editor needs
  std::unique_ptr<FrustumEditor> editor_;
  std::unique_ptr<EditorInput> input_;
  std::array<DrawBackdrop, 3> backdrops_;
  glm::dvec3 eye_{0};
  int shownRevision_ = -1;
  bool shownSmall_ = false;
  bool wantsSave_ = false;
};

}  // namespace

std::unique_ptr<ExplorePane> makeDrawPane() {
  return std::make_unique<DrawPane>();
}

}  // namespace ocelli
