#include "oc_core/remote/server/turn_queue.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace ocelli {

void TurnQueue::ask(uint64_t client, RemoteRequest request) {
  Client& asking = clients_[client];
  if (!asking.waiting) {
    asking.askedAt = ++asked_;
  }
  asking.waiting = std::move(request);
}

void TurnQueue::setReady(uint64_t client, bool isReady) {
  if (const auto known = clients_.find(client); known != clients_.end()) {
    known->second.isReady = isReady;
  }
}

void TurnQueue::leave(uint64_t client) {
  clients_.erase(client);
}

double TurnQueue::startTagOf(const Client& client) const {
  return std::max(tag_, client.endTag);
}

bool TurnQueue::comesBefore(const Client& a, const Client& b) const {
  return std::tuple(startTagOf(a), a.askedAt) < std::tuple(startTagOf(b), b.askedAt);
}

size_t TurnQueue::turnsBefore(uint64_t client) const {
  const auto known = clients_.find(client);
  if (known == clients_.end() || !known->second.waiting) {
    return 0;
  }
  return static_cast<size_t>(std::ranges::count_if(clients_, [&](const auto& other) {
    const Client& each = other.second;
    return other.first != client &&
           (each.isUnderWay || (each.waiting && each.isReady && comesBefore(each, known->second)));
  }));
}

std::optional<Turn> TurnQueue::next() {
  auto first = clients_.end();
  for (auto each = clients_.begin(); each != clients_.end(); ++each) {
    const Client& client = each->second;
    if (client.waiting && client.isReady && !client.isUnderWay &&
        (first == clients_.end() || comesBefore(client, first->second))) {
      first = each;
    }
  }
  if (first == clients_.end()) {
    return std::nullopt;
  }
  Client& client = first->second;
  client.startTag = startTagOf(client);
  tag_ = client.startTag;
  client.isUnderWay = true;
  Turn turn{first->first, std::move(*client.waiting)};
  client.waiting.reset();
  return turn;
}

void TurnQueue::finish(uint64_t client, double seconds) {
  if (const auto known = clients_.find(client); known != clients_.end()) {
    known->second.isUnderWay = false;
    known->second.endTag = known->second.startTag + std::max(seconds, 0.0);
  }
}

}  // namespace ocelli
