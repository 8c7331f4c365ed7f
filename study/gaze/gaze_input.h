// Where samples of gaze come from, a row each: `ocelli study run --gaze udp:127.0.0.1:5010`.
//
// Recipe for a new input, two places and a line:
//   1. study/gaze/NAME_gaze.cpp: a GazeBytes, and a function that makes its row.
//   2. study/gaze/gaze_inputs.cpp: that function, at the end of the table.
//   3. The name of the file in the CMakeLists.txt beside it.
// Then its row in docs/gaze.md.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "study/gaze/gaze_lines.h"

namespace ocelli {

/// A source of lines.
class GazeBytes {
 public:
  virtual ~GazeBytes() = default;
  /// Waits for whole lines, at most so long; empty where none came.
  virtual std::string read(int waitMilliseconds) = 0;
};

struct GazeInputKind {
  std::string name;         ///< before the first colon: "udp"
  std::string form;         ///< "udp:HOST:PORT"
  std::string description;  ///< for people
  /// Of what stands after the colon. Throws InputError for a text that is wrong, WorkError where it cannot be opened.
  std::unique_ptr<GazeBytes> (*open)(const std::string& text) = nullptr;
};

const std::vector<GazeInputKind>& gazeInputKinds();
/// "udp:HOST:PORT[,norm], file:PATH[,norm]".
std::string gazeInputForms();

struct GazeCounts {
  int64_t samples = 0;
  int64_t valid = 0;      ///< of these
  int64_t malformed = 0;  ///< lines
  int64_t lost = 0;       ///< samples that came faster than they were taken
};

/// Reads on a thread of its own, and gives each sample the time when it came. Samples wait in a queue, so that no frame
/// waits for the network; where nobody takes them, the newest are lost and counted.
class GazeInput {
 public:
  /// Half a minute of a tracker of 2000 Hz: no frame takes that long.
  static constexpr size_t kMaxWaiting = 60'000;

  GazeInput(std::unique_ptr<GazeBytes> bytes, GazeLines lines, size_t maxWaiting = kMaxWaiting);
  ~GazeInput();
  GazeInput(const GazeInput&) = delete;
  GazeInput& operator=(const GazeInput&) = delete;

  /// Those since the last call, times by the steady clock. Never waits.
  std::vector<GazeRecord> take();
  GazeCounts counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// "udp:HOST:PORT": shares of the screen where ",norm" follows, else pixels. Throws as open() does, and InputError for
/// a kind that there is not.
std::unique_ptr<GazeBytes> openGazeBytes(const std::string& text);
GazeUnit gazeUnitOf(const std::string& text);

}  // namespace ocelli
