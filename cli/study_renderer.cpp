#include "cli/study_renderer.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <mutex>

#include "cli/gl_drawing.h"
#include "study/replay/trial_frame.h"
#ifdef OCELLI_WITH_OPENGL
#include "study/screen/replay_window.h"
#include "study/screen/trial_painter.h"
#endif

namespace ocelli {
namespace {

constexpr const char* kRaster = "raster";

#ifdef OCELLI_WITH_OPENGL
/// Painters of one context, for one size of the screen after the other.
class GlPainters {
 public:
  explicit GlPainters(const std::string& provider) : context_(openGlContext(provider, "--renderer")) {}

  const GlContext& context() const { return *context_; }
  template <class Paint>
  Image<Rgb8> with(const TrialScreen& screen, const Paint& paint) {
    const std::scoped_lock lock(mutex_);
    if (!painter_ || screen_ != screen) {
      painter_.reset();
      painter_ = std::make_unique<TrialPainter>(*context_, screen);
      screen_ = screen;
    }
    return paint(*painter_);
  }

 private:
  std::unique_ptr<GlContext> context_;
  std::unique_ptr<TrialPainter> painter_;
  TrialScreen screen_{};
  std::mutex mutex_;
};
#endif

}  // namespace

void addRendererOption(CLI::App& command, std::string& renderer) {
  command.add_option("--renderer", renderer, "What draws: the rasteriser on the CPU, or OpenGL through EGL or OSMesa")
      ->check(CLI::IsMember({kRaster, "egl", "osmesa"}))
      ->type_name("NAME")
      ->capture_default_str();
}

StudyRenderer studyRenderer(const std::string& renderer) {
  if (renderer == kRaster) {
    return rasterizeStudy;
  }
  const auto drawing = std::make_shared<GlDrawing>(renderer);
  return [drawing](const StudyCamera& camera, const Mesh& mesh) {
    const SceneRenderer& draw = drawing->rendererOf(mesh);
    return std::visit([&](const auto& each) { return draw.draw(each); }, camera);
  };
}

std::map<std::string, ViewPainter> viewPainters(const std::string& renderer) {
  if (renderer == kRaster) {
    return {{renderer, [](const TrialLayout& layout, const TrialScreen& screen) {
               return viewsOf(layout, screen, rasterizeStudy);
             }}};
  }
  std::map<std::string, ViewPainter> painters;
  const auto mutex = std::make_shared<std::mutex>();
  painters[renderer] = [mutex, draw = studyRenderer(renderer)](const TrialLayout& layout, const TrialScreen& screen) {
    const std::scoped_lock lock(*mutex);
    return viewsOf(layout, screen, draw);
  };
#ifdef OCELLI_WITH_OPENGL
  const auto gl = std::make_shared<GlPainters>(renderer);
  painters[gl->context().info().renderer] = [gl](const TrialLayout& layout, const TrialScreen& screen) {
    return gl->with(screen, [&](TrialPainter& painter) { return painter.renderViews(layout); });
  };
#endif
  return painters;
}

ViewPainter framePainter(const std::string& renderer) {
#ifdef OCELLI_WITH_OPENGL
  if (renderer != kRaster) {
    const auto gl = std::make_shared<GlPainters>(renderer);
    return [gl](const TrialLayout& layout, const TrialScreen& screen) {
      return gl->with(screen, [&](TrialPainter& painter) { return painter.render(layout); });
    };
  }
#endif
  return [draw = studyRenderer(renderer)](const TrialLayout& layout, const TrialScreen& screen) {
    return trialFrame(layout, screen, draw);
  };
}

#ifdef OCELLI_WITH_OPENGL
void showInWindow(const TaskBlock& block, const TrialLog& log, const Controls& controls,
                  const ReplayWindowChoice& choice) {
  showReplay(block, log, controls, {.title = choice.title, .speed = choice.speed});
}
#else
void showInWindow(const TaskBlock&, const TrialLog&, const Controls&, const ReplayWindowChoice&) {
  failWithoutOpenGl();
}
#endif

}  // namespace ocelli
