// The study whose sessions are killed, and what is said and asked of its trials.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "study/protocol/protocol.h"
#include "study/session/records.h"

namespace ocelli::test {

/// Two sessions of 36 trials, with consent, forms, practice and breaks.
Protocol killProtocol();

/// Of all that was logged of a trial, in its order.
class TrialDigest {
 public:
  void add(const FrameRecord& frame) {
    addBits(static_cast<uint64_t>(frame.frame));
    addBits(static_cast<uint64_t>(frame.tick));
    addBits(static_cast<uint64_t>(frame.shownNanoseconds));
    for (const double value : {frame.pose.x, frame.pose.z, frame.pose.headingRadians}) {
      uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      addBits(bits);
    }
  }
  /// Frames and inputs come in pieces of their own: the order between them is left out.
  void add(const InputRecord& input) {
    inputs_ =
        inputs_ * 1099511628211u + static_cast<uint64_t>(input.tick) + 31 * static_cast<uint64_t>(input.nanoseconds);
  }
  void add(const GazeRecord& sample) {
    uint64_t bits = 0;
    std::memcpy(&bits, &sample.x, sizeof bits);
    gaze_ = (gaze_ * 1099511628211u + bits) ^ static_cast<uint64_t>(sample.nanoseconds);
  }
  uint64_t value() const { return frames_ ^ (inputs_ * 0x9e3779b97f4a7c15u) ^ (gaze_ * 0xbf58476d1ce4e5b9u); }

 private:
  void addBits(uint64_t bits) { frames_ = (frames_ ^ bits) * 1099511628211u; }
  uint64_t frames_ = 14695981039346656037u;
  uint64_t inputs_ = 1;
  uint64_t gaze_ = 1;
};

struct AcknowledgedTrial {
  int plan = 0;
  int attempt = 1;
  bool practice = false;
  std::string ending;
  std::string answer;
  uint64_t digest = 0;

  bool operator==(const AcknowledgedTrial&) const = default;
};
std::string lineOf(const AcknowledgedTrial& trial);

}  // namespace ocelli::test
