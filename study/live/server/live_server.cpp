#include "study/live/server/live_server.h"

#include <utility>

#include "study/live/live_page.h"

namespace ocelli {

LiveServer::LiveServer(int port, std::function<std::string()> status)
    : server_(port, {.option = "--live", .images = "data:"},
              [status = std::move(status)](std::string_view path) -> std::optional<LocalAnswer> {
                if (path == "/") {
                  return LocalAnswer{"text/html; charset=utf-8", livePage()};
                }
                if (path == "/live.js") {
                  return LocalAnswer{"text/javascript; charset=utf-8", liveScript()};
                }
                if (path == "/status.json") {
                  return LocalAnswer{"application/json", status()};
                }
                return std::nullopt;
              }) {}

}  // namespace ocelli
