// The work of `ocelli feeds faces`.
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/feeds_program.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/feeds_place/near_faces.h"

namespace ocelli {

void findFacesCommand(const FeedsFacesChoice& choice, const CommandContext& context) {
  checkWritable(choice.output);
  FeedSetup setup = readFeedSetup(choice.setup);
  const FeedPlaceScene place = loadFeedPlace(choice.place, choice.metre, true, context.progress());
  const NearFaces found = findNearFaces(setup, place, {.maxTurnDegrees = choice.maxTurnDegrees});
  context.clearProgress();
  if (!place.isMetreKnown) {
    context.note(fmt::format("note: a metre is {:.6g} units, as a guess from the size of the scene: --metre says it",
                             place.metre));
  }
  std::string table =
      fmt::format("  {:<12} {:<12} {:>8} {:>8} {:>8}\n", "feed", "parent", "opening", "turned", "filled");
  for (const FoundFace& face : found.faces) {
    table += fmt::format("  {:<12} {:<12} {:>8} {:>4.0f} deg {:>6.1f} %\n", face.feed, face.parent, face.opening,
                         face.turnDegrees, 100 * face.coverage);
  }
  if (!found.faces.empty()) {
    context.print(table);
  }
  std::string missing;
  for (const FeedWithoutFace& feed : found.missing) {
    missing += fmt::format("{}feed \"{}\": {}", missing.empty() ? "" : "\n", feed.feed, feed.why);
  }
  if (!found.faces.empty()) {
    writeFeedSetup(setup, choice.output);
    context.note("wrote " + choice.output);
  }
  if (!missing.empty()) {
    throw WorkError(fmt::format("{} of {} feeds have no near face", found.missing.size(),
                                found.missing.size() + found.faces.size()),
                    choice.setup, "`ocelli scene walk` draws the openings of the place", missing);
  }
}

}  // namespace ocelli
