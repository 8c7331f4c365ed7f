// Where the viewer's eye is: along a recorded way, or as a head tracker tells it, live.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>

#include "display_driver/device/device.h"
#include "display_driver/pacing/eye_predictor.h"

namespace ocelli {

/// Display radii.
struct PredictionErrors {
  size_t count = 0;
  double median = 0;
  double most = 0;        ///< that 95 % do not exceed
  double medianLast = 0;  ///< the same of the last place that was known instead
  double mostLast = 0;
  double aheadSeconds = 0;  ///< median: from the last sample to the time that was foreseen
};

class EyeFeed {
 public:
  virtual ~EyeFeed() = default;
  /// Where the eye is at that time, in display radii, as well as it is known. nullopt: nobody has said yet.
  virtual std::optional<glm::vec3> eyeAt(HostTime seen) = 0;
  /// There will be no more.
  virtual bool ended(HostTime seen) = 0;
  /// Of lines and datagrams that were none; of the first one, for people, what was wrong: "not TIME,X,Y,Z (3 values
  /// instead of 4): \"0,1,2\"".
  virtual uint64_t malformed() const { return 0; }
  virtual std::string firstMalformed() const { return {}; }
  /// How far eyes that were foreseen were off, once it was known where they were.
  virtual PredictionErrors predictionErrors() const { return {}; }
};

/// What `--eyes` takes: FILE.csv or FILE.json (display_sim/observing/eye_path.h; begins with the first question, and
/// ends with its last pose, or begins again), `udp:[ADDRESS:]PORT` (datagrams of one line each; listens at 127.0.0.1
/// where no address is given), `-` (lines of standard input). Lines are TIME,X,Y,Z; the line that came
/// last counts, whatever its time; their times say how fast the eye moves, where they go forward as the clock does.
/// `prediction` is for lines that come live. Throws InputError for any other text and for invalid files, WorkError
/// where the port cannot be opened.
std::unique_ptr<EyeFeed> openEyeFeed(const std::string& text, bool loop,
                                     EyePrediction prediction = EyePrediction::kNone);

/// The same from a file descriptor, line by line. It stays open.
std::unique_ptr<EyeFeed> eyeFeedFromLines(int descriptor, EyePrediction prediction = EyePrediction::kNone);

}  // namespace ocelli
