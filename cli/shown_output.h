// What a simulated or emulated display showed, as files: its volumes refresh by refresh, and what an observer saw.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/command.h"
#include "display_driver/devices/shown_recorder.h"
#include "display_sim/observing/observer.h"

namespace CLI {
class App;
}

namespace ocelli {

struct ShownChoice {
  std::string folder;
  std::string watch;
  std::string from;
  std::string size = "480x480";

  bool given() const { return !folder.empty() || !watch.empty(); }
};

/// Adds --shown, --watch, --watch-from and --watch-size.
void addShownOptions(CLI::App& command, ShownChoice& choice);

/// The recording in the folder of --shown.
std::filesystem::path shownRecord(const ShownChoice& choice);

/// Throws InputError where the options make no sense, before anything is written.
void checkShownOptions(const ShownChoice& choice, const DisplayProfile& profile);

class ShownOutput {
 public:
  /// Throws where something cannot be written, and as checkShownOptions() does.
  ShownOutput(const ShownChoice& choice, const DisplayProfile& profile);
  ~ShownOutput();

  /// Who hears of the refreshes. nullptr: nobody needs to.
  RefreshSink* sink() { return recorder_ ? &*recorder_ : nullptr; }
  /// After the display has ended: draws and writes what there is.
  void finish(const CommandContext& context);

 private:
  ShownChoice choice_;
  DisplayProfile profile_;
  ObserverOptions observer_;
  std::filesystem::path record_;  ///< the .svol file; one of our own where nobody asked to keep it
  UnfinishedOutput ownRecord_;
  std::optional<ShownRecorder> recorder_;
};

}  // namespace ocelli
