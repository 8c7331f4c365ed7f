#include "study/screen/trial_painter.h"

#include "oc_core/window/screen_target.h"
#include "study/screen/trial_overlay.h"

namespace ocelli {
namespace {

/// Kept together with the scope in which its parts are made and go.
struct Parts {
  Parts(GlContext& context, const TrialScreen& screen)
      : target(context, screen.width, screen.height), canvas(context, screen.width, screen.height), views(context) {}

  ScreenTarget target;
  StudyCanvas canvas;
  SceneViews views;
};

}  // namespace

struct TrialPainter::State {
  GlContext& context;
  std::unique_ptr<Parts> parts;
};

TrialPainter::TrialPainter(GlContext& context, const TrialScreen& screen) : state_(new State{context, nullptr}) {
  const GlScope scope(context);
  state_->parts = std::make_unique<Parts>(context, screen);
}

TrialPainter::~TrialPainter() = default;

Image<Rgb8> TrialPainter::render(const TrialLayout& layout) {
  const GlScope scope(state_->context);
  Parts& parts = *state_->parts;
  parts.target.clear(kStudyBackground);
  parts.views.draw(layout, parts.target.color());
  parts.target.bind();
  parts.canvas.begin(0);
  drawTrialOverlay(parts.canvas, layout, parts.views);
  parts.target.bind();
  parts.canvas.end();
  return parts.target.read();
}

Image<Rgb8> TrialPainter::renderViews(const TrialLayout& layout) {
  const GlScope scope(state_->context);
  Parts& parts = *state_->parts;
  parts.target.clear(kOkabeItoBlack);
  parts.views.draw(layout, parts.target.color());
  return parts.target.read();
}

Image<Rgb8> renderTrialImage(GlContext& context, const TrialLayout& layout, const TrialScreen& screen) {
  return TrialPainter(context, screen).render(layout);
}

}  // namespace ocelli
