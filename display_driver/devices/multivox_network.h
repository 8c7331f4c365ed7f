// Displays of the multivox project that take frames over TCP, as the project's python/pointvision.py does on the
// machine of the display.
//
// A message is ff ff ff ff, the length of what follows as a 32-bit number, the highest byte first, and a gzip file: for
// each lit cell of the grid x, y, z and its colour (RGB332), a byte each. Receivers show a message when it has come,
// answer nothing, and pass messages over that come faster than they are shown. A message without cells would end some
// receivers, so a dark frame has one dark cell.
//
// It follows that nothing tells whether a frame was seen. show() returns when the other machine has the whole message;
// the next one is sent after that, so that at most one is under way however slow the network is. Where a connection
// breaks, or takes no byte for 5 seconds, a new one is tried at growing intervals, at most 2 seconds apart.
#pragma once

#include <memory>
#include <vector>

#include "display_driver/devices/multivox_target.h"
#include "display_driver/devices/tcp_stream.h"
#include "display_driver/devices/voxel_grid.h"

namespace ocelli {

inline constexpr int kMultivoxPort = 0x5658;

struct MultivoxPlace {
  std::string text;  ///< as the user wrote it, for messages
  HostPort host;
  int bitsPerChannel = 2;  ///< that the display shows: what drivers and simulators show when they start
};

/// "HOST[:PORT][,bits=1|2|3]"; an address of IPv6 stands in brackets. Nothing for names of displays in shared memory,
/// which have no dot, no colon and no bracket, or begin with a slash. Throws InputError.
std::optional<MultivoxPlace> multivoxPlace(const std::string& text);

/// The message of a frame.
std::vector<uint8_t> multivoxMessage(std::span<const uint8_t> cells, const VoxelGrid& grid);

class MultivoxNetwork final : public MultivoxTarget {
 public:
  static constexpr std::chrono::milliseconds kStall{5000};

  /// Connects. Throws InputError for an unknown host, WorkError where nothing answers.
  MultivoxNetwork(const MultivoxPlace& place, const VoxelGrid& grid, std::chrono::milliseconds stall = kStall);

  std::string name() const override { return place_.host.host; }
  std::string link() const override;
  /// Connects again where the connection is lost and it is time to try.
  Found look() override;
  std::optional<MultivoxStatus> status() const override;
  /// Makes the message.
  bool write(std::span<const uint8_t> cells) override;
  /// Sends it.
  bool show() override;
  Clock::time_point rested() const override { return rested_; }
  bool sendsWhenShown() const override { return true; }
  size_t frameBytes() const override { return message_.size(); }
  uint64_t bytesSent() const override { return stream_.bytesSent(); }
  const std::string& problem() const override { return stream_.problem(); }
  void stop() override { stream_.stop(); }

 private:
  MultivoxPlace place_;
  VoxelGrid grid_;
  TcpStream stream_;
  std::vector<uint8_t> message_;
  bool isNew_ = true;    ///< connected, and look() has not told yet
  bool wasOpen_ = true;  ///< at the last look
  Clock::time_point nextTry_;
  std::chrono::milliseconds pause_;
  Clock::time_point rested_;
};

}  // namespace ocelli
