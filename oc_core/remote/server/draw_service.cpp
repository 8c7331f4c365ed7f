#include "oc_core/remote/server/draw_service.h"

#include <fmt/format.h>

#include <exception>
#include <system_error>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"

namespace ocelli {

DrawService::DrawService(int threads, RemoteDraw draw, DrawEvents events)
    : draw_(std::move(draw)), events_(std::move(events)) {
  try {
    for (int i = 0; i < threads; ++i) {
      threads_.emplace_back([this] { work(); });
    }
  } catch (const std::system_error& error) {
    end();
    throw WorkError(fmt::format("no more than {} threads begin ({})", threads_.size(), error.what()),
                    "the server of remote visualisation", "draw fewer images at the same time");
  }
}

DrawService::~DrawService() {
  end();
}

void DrawService::end() {
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
    const int64_t begin = steadyNanoseconds();
    try {
      serve(*turn, id);
    } catch (...) {  // not even what went wrong can be told: the next turn may fare better
    }
    {
      const std::lock_guard lock(mutex_);
      queue_.finish(turn->client, static_cast<double>(steadyNanoseconds() - begin) * 1e-9);
    }
    changed_.notify_one();
  }
}

void DrawService::serve(const Turn& turn, uint32_t id) {
  const std::string problem = problemOf(turn, id);
  if (!problem.empty() && isWanted(turn.client)) {
    setReady(turn.client, true);
    events_.failed(turn.client, turn.request.sequence, problem);
  }
}

std::string DrawService::problemOf(const Turn& turn, uint32_t id) {
  const uint64_t client = turn.client;
  try {
    events_.drawing(client, turn.request.sequence);
    const int64_t begin = steadyNanoseconds();
    std::optional<RemoteImage> image = draw_(turn.request, id, [this, client] { return isWanted(client); });
    const double seconds = static_cast<double>(steadyNanoseconds() - begin) * 1e-9;
    if (image && isWanted(client)) {
      // Before the client's next turn may begin: what it hears of both stays in order.
      setReady(client, false);
      events_.drawn(client, std::move(*image), seconds);
    }
    return "";
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "it cannot be drawn";
  }
}

}  // namespace ocelli
