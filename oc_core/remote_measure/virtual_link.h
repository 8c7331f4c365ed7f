// A link between server and client in virtual time: bytes follow each other at a rate, and take half of the round trip
// to arrive. Nothing is lost, and nothing but the bytes counts. What goes up (views: a few hundred bytes) takes its
// half of the round trip alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ocelli {

struct LinkSpeed {
  double bytesPerSecond = 300e3;
  double roundTripSeconds = 0.2;  ///< there and back: half of it either way

  double oneWaySeconds() const { return roundTripSeconds / 2; }
  /// "300 KB/s, 200 ms"
  std::string name() const;
  bool operator==(const LinkSpeed&) const = default;
};

/// The text's home connection, and 1 and 12.5 MB/s (100 Mbit/s, the text's campus), each with 20 and 200 ms.
std::vector<LinkSpeed> defaultLinks();

/// "300KB/s:200ms", "1MB/s:20ms". Throws InputError for another text, and for rates and delays out of range
/// (1 KB/s to 10 GB/s, 0 to 10 s).
LinkSpeed linkSpeedFromText(const std::string& text);

class VirtualLink {
 public:
  explicit VirtualLink(const LinkSpeed& speed) : speed_(speed) {}

  const LinkSpeed& speed() const { return speed_; }
  /// When bytes are there that are given to the link at `seconds`: after all that was given before.
  double arrival(double seconds, size_t bytes);
  /// When the link has sent all it was given.
  double freeAt() const { return free_; }
  size_t sentBytes() const { return bytes_; }

 private:
  LinkSpeed speed_;
  double free_ = 0;
  size_t bytes_ = 0;
};

}  // namespace ocelli
