// The work of `ocelli feeds edit`.
#include "cli/command.h"
#include "cli/feeds_program.h"
#include "cli/interrupt.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#ifdef OCELLI_WITH_OPENGL
#include "oc_core/feeds_editor_window/face_window.h"
#include "oc_core/feeds_live/first_frames.h"
#include "oc_core/feeds_place/feed_place.h"
#include "oc_core/gl/gl_error.h"
#include "oc_core/multiperspective/plan_section.h"
#endif

namespace ocelli {

#ifdef OCELLI_WITH_OPENGL
namespace {

constexpr double kPlanCut = 1.2;          ///< metres over the floor: above most furniture, below lintels
constexpr double kFirstFrameSeconds = 5;  ///< for each feed

}  // namespace

void editFacesCommand(const FeedsEditChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  const FeedSetup setup = readFeedSetup(choice.setup);
  FaceWindowOptions options;
  options.title = "Ocelli: " + choice.setup;
  std::vector<SnapPoint> corners;
  if (!choice.place.empty()) {
    const FeedPlaceScene place = loadFeedPlace(choice.place, choice.metre, false, context.progress());
    const double cut = setup.floorHeight + kPlanCut;
    options.walls = sectionOf(place.mesh, PlanSide::kTop, static_cast<float>(cut));
    corners = sceneSnaps(place.mesh, {}, PlanSide::kTop, cut);
  }
  for (FirstFrame& first : firstFrames(setup, kFirstFrameSeconds)) {
    if (!first.message.empty()) {
      context.clearProgress();
      context.note("warning: " + first.message);
    }
    options.frames.push_back(std::move(first.image));
  }
  context.clearProgress();
  options.save = [&](const FeedSetup& drawn) {
    writeFeedSetup(drawn, choice.output);
    return "wrote " + choice.output;
  };
  FaceEditor editor(setup, corners);
  const InterruptGuard guard;
  try {
    runFaceWindow(editor, options, [] { return !InterruptGuard::interrupted(); });
  } catch (const GlError& error) {
    throw WorkError(error.reason(), "feeds edit",
                    "set DISPLAY to a running X server, or find near faces with `ocelli feeds faces`");
  }
}
#else
void editFacesCommand(const FeedsEditChoice& /*choice*/, const CommandContext& /*context*/) {
  throw InputError("this program was built without windows", "feeds edit",
                   "build it with -DOCELLI_WITH_OPENGL=ON (docs/install.md), or find near faces with "
                   "`ocelli feeds faces`");
}
#endif

}  // namespace ocelli
