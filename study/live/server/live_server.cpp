#include "study/live/server/live_server.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "oc_core/base/error.h"
#include "study/live/live_page.h"

namespace ocelli {
namespace {

constexpr unsigned kMaxConnections = 16;
constexpr unsigned kTimeoutSeconds = 10;
constexpr size_t kConnectionBytes = 32 << 10;

/// A listening socket on 127.0.0.1. Throws WorkError.
int listenHere(int port) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (listener < 0 || setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes)) != 0 ||
      bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      listen(listener, static_cast<int>(kMaxConnections)) != 0) {
    const int problem = errno;
    if (listener >= 0) {
      close(listener);
    }
    throw WorkError(problem == EADDRINUSE ? "another program uses this port already"
                                          : fmt::format("this port cannot be used ({})", std::strerror(problem)),
                    fmt::format("--live {}", port), "give another port, or 0 for any that is free");
  }
  return listener;
}

int portOf(int listener) {
  sockaddr_in address{};
  socklen_t size = sizeof(address);
  return getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size) == 0 ? ntohs(address.sin_port) : 0;
}

}  // namespace

struct LiveServer::State {
  State(int wantedPort, std::function<std::string()> theStatus) : status(std::move(theStatus)) {
    const int listener = listenHere(wantedPort);
    port = portOf(listener);
    daemon = MHD_start_daemon(MHD_USE_INTERNAL_POLLING_THREAD, 0, nullptr, nullptr, &State::answer, this,
                              MHD_OPTION_LISTEN_SOCKET, listener, MHD_OPTION_CONNECTION_LIMIT, kMaxConnections,
                              MHD_OPTION_CONNECTION_TIMEOUT, kTimeoutSeconds, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
                              kConnectionBytes, MHD_OPTION_END);
    if (daemon == nullptr) {
      close(listener);
      throw WorkError("the page of the session cannot be served", fmt::format("--live {}", wantedPort),
                      "leave --live away: the terminal tells the same");
    }
  }
  ~State() { MHD_stop_daemon(daemon); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  bool isOurs(MHD_Connection* connection) const {
    const char* const host = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Host");
    const std::string_view name = host != nullptr ? host : "";
    return name == fmt::format("127.0.0.1:{}", port) || name == fmt::format("localhost:{}", port);
  }

  static MHD_Result send(MHD_Connection* connection, unsigned code, const char* type, const std::string& body) {
    MHD_Response* const response =
        MHD_create_response_from_buffer(body.size(), const_cast<char*>(body.data()), MHD_RESPMEM_MUST_COPY);
    if (response == nullptr) {
      return MHD_NO;
    }
    for (const auto& [name, value] : std::initializer_list<std::pair<const char*, const char*>>{
             {"Content-Type", type},
             {"Cache-Control", "no-store"},
             {"Content-Security-Policy",
              "default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'unsafe-inline'; img-src data:; "
              "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
             {"Cross-Origin-Resource-Policy", "same-origin"},
             {"Referrer-Policy", "no-referrer"},
             {"X-Content-Type-Options", "nosniff"}}) {
      MHD_add_response_header(response, name, value);
    }
    if (code == MHD_HTTP_METHOD_NOT_ALLOWED) {
      MHD_add_response_header(response, "Allow", "GET, HEAD");
    }
    const MHD_Result result = MHD_queue_response(connection, code, response);
    MHD_destroy_response(response);
    return result;
  }

  // Exceptions must not leave it, as C calls it.
  static MHD_Result answer(void* self, MHD_Connection* connection, const char* url, const char* method,
                           const char* /*version*/, const char* /*data*/, size_t* size, void** request) {
    static char seen = 0;
    if (*request == nullptr) {  // the headers: whatever follows them is thrown away below
      *request = &seen;
      return MHD_YES;
    }
    if (*size != 0) {
      *size = 0;
      return MHD_YES;
    }
    try {
      return static_cast<const State*>(self)->respond(connection, url, method);
    } catch (...) {
      return MHD_NO;
    }
  }

  MHD_Result respond(MHD_Connection* connection, std::string_view url, std::string_view method) const {
    constexpr const char* kPlain = "text/plain; charset=utf-8";
    if (!isOurs(connection)) {
      return send(connection, MHD_HTTP_FORBIDDEN, kPlain, fmt::format("this page is at 127.0.0.1:{} alone\n", port));
    }
    if (method != "GET" && method != "HEAD") {
      return send(connection, MHD_HTTP_METHOD_NOT_ALLOWED, kPlain, "this page can only be read\n");
    }
    if (url == "/") {
      return send(connection, MHD_HTTP_OK, "text/html; charset=utf-8", livePage());
    }
    if (url == "/live.js") {
      return send(connection, MHD_HTTP_OK, "text/javascript; charset=utf-8", liveScript());
    }
    if (url == "/status.json") {
      return send(connection, MHD_HTTP_OK, "application/json", status());
    }
    return send(connection, MHD_HTTP_NOT_FOUND, kPlain, "there is nothing here\n");
  }

  std::function<std::string()> status;
  int port = 0;
  MHD_Daemon* daemon = nullptr;
};

LiveServer::LiveServer(int port, std::function<std::string()> status)
    : state_(std::make_unique<State>(port, std::move(status))) {}

LiveServer::~LiveServer() = default;

int LiveServer::port() const {
  return state_->port;
}

std::string LiveServer::address() const {
  return fmt::format("http://127.0.0.1:{}/", state_->port);
}

}  // namespace ocelli
