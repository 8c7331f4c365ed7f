// Where markers go, a row each: `ocelli study run --markers udp:10.0.0.5:5005 --markers file:markers.csv`.
//
// Recipe for a new output, two places and a line:
//   1. study/markers/NAME_output.cpp: a MarkerOutput and a function that makes its row.
//   2. study/markers/marker_outputs.cpp: that function, at the end of the table.
//   3. The name of the file in the CMakeLists.txt beside it.
// Then its row in docs/markers.md.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/markers/marker.h"

namespace ocelli {

struct MarkerCounts {
  int64_t sent = 0;
  int64_t lost = 0;  ///< that could not be handed over
};

/// Sends are made between two frames: they never wait, and never throw. What cannot be sent at once is lost and
/// counted.
class MarkerOutput {
 public:
  virtual ~MarkerOutput() = default;

  virtual void send(const Marker& marker) = 0;
  /// Hands over what is under way, once no more is sent. May wait for a moment.
  virtual void finish() {}
  virtual MarkerCounts counts() const = 0;
};

struct MarkerOutputKind {
  std::string name;         ///< before the first colon: "udp"
  std::string form;         ///< "udp:HOST:PORT"
  std::string description;  ///< for people
  /// Of what stands after the colon. Throws InputError for a text that is wrong, WorkError where it cannot be opened.
  std::unique_ptr<MarkerOutput> (*open)(const std::string& text) = nullptr;
};

const std::vector<MarkerOutputKind>& markerOutputKinds();
/// "udp:HOST:PORT, serial:DEVICE[,BAUD], ...".
std::string markerOutputForms();
/// Throws as open() does, and InputError for a kind that there is not.
std::unique_ptr<MarkerOutput> openMarkerOutput(const std::string& text);

}  // namespace ocelli
