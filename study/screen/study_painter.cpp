#include "study/screen/study_painter.h"

#include <fmt/format.h>

#include "oc_core/gl/gl_api.h"
#include "oc_core/window/screen_target.h"
#include "study/screen/form_drawing.h"
#include "study/screen/gaze_drawing.h"
#include "study/screen/page_drawing.h"
#include "study/screen/trial_overlay.h"
#include "study/task/trial_image.h"

namespace ocelli {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

}  // namespace

struct StudyPainter::State {
  State(GlContext& of, const TrialScreen& screen, const Controls& controls, const std::set<char32_t>& characters,
        const SubjectTexts& texts)
      : context(of),
        target(of, screen.width, screen.height),
        canvas(of, screen.width, screen.height, characters, texts),
        views(of),
        images(of, screen, controls) {}

  /// White or black, in the lower left corner, over all else.
  void drawPatch(bool white) {
    const GladGLContext& gl = context.gl();
    const auto size = static_cast<GLsizei>(canvas.length(56));
    const std::array<uint8_t, 4> color =
        white ? std::array<uint8_t, 4>{255, 255, 255, 255} : std::array<uint8_t, 4>{0, 0, 0, 255};
    gl.ClearTexSubImage(target.color().id(), 0, 0, target.height() - size, 0, size, size, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                        color.data());
  }

  GlContext& context;
  ScreenTarget target;
  StudyCanvas canvas;
  SceneViews views;
  InstructionImages images;
  PageScroll scroll;
  std::string shown;     ///< identity of the last screen
  double keyScroll = 0;  ///< pages that the keys ask for
};

StudyPainter::StudyPainter(GlContext& context, const TrialScreen& screen, const Controls& controls,
                           const std::set<char32_t>& characters, const SubjectTexts& texts) {
  const GlScope scope(context);
  state_ = std::make_unique<State>(context, screen, controls, characters, texts);
}

StudyPainter::~StudyPainter() = default;

void StudyPainter::handle(const InputEvent& event) {
  state_->canvas.handle(event);
  if (const auto* key = std::get_if<KeyEvent>(&event); key != nullptr && key->pressed) {
    state_->keyScroll += key->key == Key::kPageDown ? 1 : (key->key == Key::kPageUp ? -1 : 0);
  }
}

bool StudyPainter::hasWaitingEvents() const {
  return state_->canvas.hasWaitingEvents();
}

StudyFrame StudyPainter::draw(const SessionScreen& screen, double secondsSinceLast, bool hash) {
  State& state = *state_;
  const std::string identity = identityOf(screen);
  if (identity != state.shown) {
    state.shown = identity;
    state.scroll = {};
    state.keyScroll = 0;
  }
  const auto* const trial = std::get_if<TrialScreenView>(&screen);
  StudyFrame frame;
  if (trial != nullptr && hash) {
    state.target.clear(kOkabeItoBlack);
    state.views.draw(trial->layout, state.target.color());
    frame.pixelHash = pixelHashOf(state.target.read());
  }
  state.target.clear(kStudyBackground);
  if (trial != nullptr) {
    state.views.draw(trial->layout, state.target.color());
  }
  state.target.bind();
  StudyCanvas& canvas = state.canvas;
  canvas.begin(secondsSinceLast);
  const double lines = 3 * canvas.lineHeight(StudyText::kBody);
  state.scroll.move(state.keyScroll * 0.6 * state.target.height() - canvas.wheel() * lines);
  state.keyScroll = 0;
  std::visit(
      Overloaded{
          [&](const PageScreen& page) {
            const PageClick click = drawPage(canvas, page, state.images, state.scroll);
            frame.action = click.action;
            frame.key = click.key;
          },
          [&](const ConsentScreen& consent) { frame.action = drawConsent(canvas, consent, state.scroll).action; },
          [&](const FormScreen& form) { frame.action = drawForm(canvas, form, state.scroll); },
          [&](const TrialScreenView& view) {
            drawTrialOverlay(canvas, view.layout, state.views);
            drawGazeMarks(canvas, view.gaze);
          },
          [&](const PauseScreen& pause) { drawPause(canvas, pause); },
      },
      screen);
  state.target.bind();
  canvas.end();
  if (trial != nullptr && trial->showsPatch) {
    state.drawPatch(trial->patchWhite);
  }
  return frame;
}

bool StudyPainter::canShow(const std::string& text) const {
  return state_->canvas.canShow(text);
}

const GlObject& StudyPainter::framebuffer() const {
  return state_->target.framebuffer();
}

Image<Rgb8> StudyPainter::image() const {
  return state_->target.read();
}

const std::vector<TextBox>& StudyPainter::textBoxes() const {
  return state_->canvas.textBoxes();
}

const char* kindOf(const SessionScreen& screen) {
  return std::visit(Overloaded{
                        [](const PageScreen&) { return "page"; },
                        [](const ConsentScreen&) { return "consent"; },
                        [](const FormScreen&) { return "form"; },
                        [](const TrialScreenView&) { return "trial"; },
                        [](const PauseScreen&) { return "pause"; },
                    },
                    screen);
}

std::string identityOf(const SessionScreen& screen) {
  const std::string kind = kindOf(screen);
  return std::visit(Overloaded{
                        [&](const PageScreen& page) {
                          return fmt::format("{} {} {}", kind, page.title,
                                             page.paragraphs.empty() ? "" : page.paragraphs.front());
                        },
                        [&](const ConsentScreen& consent) { return fmt::format("{} {}", kind, consent.text.title); },
                        [&](const FormScreen& form) { return fmt::format("{} {}", kind, form.form->name); },
                        [&](const TrialScreenView& view) {
                          return fmt::format("{} {} {} {}", kind, view.layout.prompt, view.layout.views.size(),
                                             view.layout.choices.size());
                        },
                        [&](const PauseScreen& pause) { return fmt::format("{} {}", kind, pause.reason); },
                    },
                    screen);
}

}  // namespace ocelli
