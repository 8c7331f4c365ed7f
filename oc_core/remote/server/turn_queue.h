// Whose turn it is to be drawn for: clients that wait get equal shares of the time that drawing takes.
//
// Start-time fair queueing (Goyal, Vin, Cheng, 1996) with equal weights: each turn has a start tag, the end tag of the
// client's last turn or the tag of the turn begun last in the whole queue, whichever is larger; its end tag is its
// start tag plus what it took. The least start tag is next. Of two clients that wait all the time, neither gets more
// than one turn ahead of the other; who has not waited for a while has saved nothing up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "oc_core/remote/remote_request.h"

namespace ocelli {

struct Turn {
  uint64_t client = 0;
  RemoteRequest request;
};

/// No thread may call it while another does.
class TurnQueue {
 public:
  /// The request waits from now on; it replaces one of this client that waits already.
  void ask(uint64_t client, RemoteRequest request);
  /// Of a client that asked before: whether its turns may begin. They may unless this says otherwise.
  void setReady(uint64_t client, bool isReady);
  /// What it waits for is dropped. A turn under way is to be finished all the same.
  void leave(uint64_t client);

  /// How many other clients wait or are under way and come before this one, if it waits: an estimate for its user.
  size_t turnsBefore(uint64_t client) const;
  /// Begins the next turn, of a client that has none under way; nothing where nobody who is ready waits.
  std::optional<Turn> next();
  /// Ends a client's turn, which took so long. Does nothing for clients that have left.
  void finish(uint64_t client, double seconds);

  /// Clients that it knows of.
  size_t size() const { return clients_.size(); }

 private:
  struct Client {
    std::optional<RemoteRequest> waiting;
    uint64_t askedAt = 0;  ///< orders those with equal tags
    bool isUnderWay = false;
    bool isReady = true;
    double startTag = 0;  ///< of the turn under way
    double endTag = 0;    ///< of the last turn
  };
  double startTagOf(const Client& client) const;
  /// Whether `a` comes before `b`; both wait.
  bool comesBefore(const Client& a, const Client& b) const;

  std::map<uint64_t, Client> clients_;
  double tag_ = 0;  ///< start tag of the turn that began last
  uint64_t asked_ = 0;
};

}  // namespace ocelli
