// The experimenter's console: commands from a terminal or a pipe, and a status line. All reading and printing is on a
// thread of its own, so that no slow terminal holds a frame up.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/screen/console_command.h"

namespace ocelli {

struct ConsoleStreams {
  int input = 0;  ///< file descriptors
  int output = 1;
};

class ExperimenterConsole {
 public:
  /// A terminal shows the status as a line that stays; anything else gets a line for each change of its first part.
  explicit ExperimenterConsole(const ConsoleStreams& streams = {});
  /// Prints what is left.
  ~ExperimenterConsole();
  ExperimenterConsole(const ExperimenterConsole&) = delete;
  ExperimenterConsole& operator=(const ExperimenterConsole&) = delete;

  /// Commands that were typed since the last call. "help", mistakes and empty lines are answered here; the caller,
  /// which runs the session, gets the others.
  std::vector<ConsoleCommand> take();

  /// `step` is where the session is, `figures` what else there is to know.
  void setStatus(const std::string& step, const std::string& figures);
  /// A line that stays.
  void print(const std::string& line);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ocelli
