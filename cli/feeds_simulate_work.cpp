// The work of `ocelli feeds simulate`.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "cli/values.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli {

void simulateFeedsCommand(const FeedsSimulateChoice& choice, const CommandContext& context) {
  FeedSimulationOptions options = choice.options;
  if (!choice.freeze.empty()) {
    const size_t at = choice.freeze.find('@');
    const auto seconds = at == std::string::npos ? std::nullopt : numberFromText<double>(choice.freeze.substr(at + 1));
    if (!seconds || *seconds < 0) {
      throw InputError("\"" + choice.freeze + "\" is no feed and time", "--freeze", "write FEED@SECONDS, as left@3.5");
    }
    options.frozenFeed = choice.freeze.substr(0, at);
    options.frozenSeconds = *seconds;
  }
  if (!choice.size.empty()) {
    const ImageSize size = imageSizeFromText(choice.size, "--size");
    options.width = size.width;
    options.height = size.height;
  }
  const FeedSimulationFigures figures = simulateFeeds(options, choice.output, context.progress());
  context.clearProgress();
  context.note(fmt::format("wrote {}/setup.json, truth.json and feeds: {} frames, {} of them dropped", choice.output,
                           figures.frames, figures.dropped));
}

}  // namespace ocelli
