// Plays the receiver of a multivox display on the network: listens at this machine, takes messages, and keeps the cells
// that the last one shows. Reads gzip on its own.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "display_driver/devices/voxel_grid.h"

namespace ocelli::test {

class ActedReceiver {
 public:
  /// At a free port of 127.0.0.1.
  explicit ActedReceiver(const VoxelGrid& grid = {});
  ~ActedReceiver();
  ActedReceiver(const ActedReceiver&) = delete;
  ActedReceiver& operator=(const ActedReceiver&) = delete;

  int port() const { return port_; }
  /// "127.0.0.1:PORT"
  std::string place() const { return "127.0.0.1:" + std::to_string(port_); }

  /// While it is deaf it reads nothing, and the network holds senders back.
  void setDeaf(bool deaf) { deaf_ = deaf; }
  /// Ends the connection, in the middle of a message once so many more bytes have come.
  void dropAfter(size_t bytes) { dropAfter_ = static_cast<int64_t>(bytes); }
  /// Nobody listens any more / again, at the same port, with nothing shown.
  void end();
  void start();
  /// Sends this to whoever is connected.
  void say(const std::string& text);

  std::vector<uint8_t> shown() const;  ///< empty before the first message
  size_t messages() const { return messages_; }
  size_t connections() const { return connections_; }
  std::string complaint() const;  ///< what was wrong with a message; empty where nothing was

 private:
  void run();
  bool serve(int connection);
  bool takeMessages(std::vector<uint8_t>& bytes);
  void show(const std::vector<uint8_t>& lit);
  void complain(const std::string& what);

  VoxelGrid grid_;
  int port_ = 0;
  int listener_ = -1;
  std::thread thread_;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> deaf_ = false;
  std::atomic<int64_t> dropAfter_ = -1;
  std::atomic<size_t> messages_ = 0;
  std::atomic<size_t> connections_ = 0;
  mutable std::mutex mutex_;
  std::vector<uint8_t> shown_;
  std::string complaint_;
  std::string toSay_;
};

}  // namespace ocelli::test
