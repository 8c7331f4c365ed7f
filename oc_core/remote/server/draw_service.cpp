#include "oc_core/remote/server/draw_service.h"

#include <exception>
#include <utility>

#include "oc_core/base/steady_time.h"

namespace ocelli {

DrawService::DrawService(int threads, RemoteDraw draw, DrawEvents events)
    : draw_(std::move(draw)), events_(std::move(events)) {
  for (int i = 0; i < threads; ++i) {
    threads_.emplace_back([this] { work(); });
  }
}

DrawService::~DrawService() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

size_t DrawService::ask(uint64_t client, RemoteRequest request) {
  size_t before = 0;
  {
    const std::lock_guard lock(mutex_);
    clients_.insert(client);
    queue_.ask(client, std::move(request));
    before = queue_.turnsBefore(client);
  }
  changed_.notify_one();
  return before;
}

void DrawService::setReady(uint64_t client, bool isReady) {
  {
    const std::lock_guard lock(mutex_);
    queue_.setReady(client, isReady);
  }
  if (isReady) {
    changed_.notify_one();
  }
}

void DrawService::leave(uint64_t client) {
  const std::lock_guard lock(mutex_);
  queue_.leave(client);
  clients_.erase(client);
}

bool DrawService::isWanted(uint64_t client) const {
  const std::lock_guard lock(mutex_);
  return !isEnding_ && clients_.contains(client);
}

void DrawService::work() {
  for (;;) {
    std::optional<Turn> turn;
    uint32_t id = 0;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return isEnding_ || (turn = queue_.next()); });
      if (isEnding_) {
        return;
      }
      id = ++lastId_;
    }
    const uint64_t client = turn->client;
    const uint32_t sequence = turn->request.sequence;
    events_.drawing(client, sequence);
    const int64_t begin = steadyNanoseconds();
    std::optional<RemoteImage> image;
    std::string problem;
    try {
      image = draw_(turn->request, id, [this, client] { return isWanted(client); });
    } catch (const std::exception& error) {
      problem = error.what();
    }
    const double seconds = static_cast<double>(steadyNanoseconds() - begin) * 1e-9;
    if (isWanted(client)) {
      // Before the client's next turn may begin: what it hears of both stays in order.
      if (image) {
        setReady(client, false);
        events_.drawn(client, std::move(*image), seconds);
      } else if (!problem.empty()) {
        events_.failed(client, sequence, problem);
      }
    }
    {
      const std::lock_guard lock(mutex_);
      queue_.finish(client, seconds);
    }
    changed_.notify_one();
  }
}

}  // namespace ocelli
