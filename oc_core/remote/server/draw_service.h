// Draws for clients on threads of its own, in the order of turn_queue.h.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "oc_core/remote/remote_image.h"
#include "oc_core/remote/server/turn_queue.h"

namespace ocelli {

/// Draws and encodes an image. Several threads call it at the same time. It may ask between its steps whether anybody
/// still wants the image, and return nothing where nobody does. What it throws is told to the client.
using RemoteDraw = std::function<std::optional<RemoteImage>(const RemoteRequest& request, uint32_t id,
                                                            const std::function<bool()>& isWanted)>;

/// What happens to a client's request; called on the threads of the service, without a lock. None of a client that has
/// left, but for one that leaves meanwhile. What `drawing` and `drawn` throw is told to the client as what drawing
/// throws.
struct DrawEvents {
  std::function<void(uint64_t client, uint32_t sequence)> drawing;
  std::function<void(uint64_t client, RemoteImage image, double seconds)> drawn;
  std::function<void(uint64_t client, uint32_t sequence, const std::string& problem)> failed;
};

class DrawService {
 public:
  /// Throws WorkError where the computer has no more threads.
  DrawService(int threads, RemoteDraw draw, DrawEvents events);
  /// Waits for what is being drawn, and drops it.
  ~DrawService();
  DrawService(const DrawService&) = delete;
  DrawService& operator=(const DrawService&) = delete;

  /// Returns how many turns of others come before: turn_queue.h.
  size_t ask(uint64_t client, RemoteRequest request);
  /// A client whose image was drawn has no further turn until this says that it can take one.
  void setReady(uint64_t client, bool isReady);
  void leave(uint64_t client);

 private:
  void end();
  void work();
  void serve(const Turn& turn, uint32_t id);
  /// Nothing where all went well, else what went wrong.
  std::string problemOf(const Turn& turn, uint32_t id);
  bool isWanted(uint64_t client) const;

  const RemoteDraw draw_;
  const DrawEvents events_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  TurnQueue queue_;
  std::set<uint64_t> clients_;  ///< that asked and have not left
  uint32_t lastId_ = 0;
  bool isEnding_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace ocelli
