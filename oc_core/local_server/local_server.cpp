#include "oc_core/local_server/local_server.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "oc_core/base/error.h"

namespace ocelli {
namespace {

constexpr size_t kConnectionBytes = 32 << 10;
constexpr size_t kBlockBytes = size_t{64} << 10;
constexpr const char* kPlainText = "text/plain; charset=utf-8";

using LocalStream = std::function<size_t(char*, size_t)>;

/// A listening socket on 127.0.0.1. Throws WorkError.
int listenHere(int port, const LocalServerOptions& options) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (listener < 0 || setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes)) != 0 ||
      bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      listen(listener, static_cast<int>(options.maxConnections)) != 0) {
    const int problem = errno;
    if (listener >= 0) {
      close(listener);
    }
    throw WorkError(problem == EADDRINUSE ? "another program uses this port already"
                                          : fmt::format("this port cannot be used ({})", std::strerror(problem)),
                    fmt::format("{} {}", options.option, port), "give another port, or 0 for any that is free");
  }
  return listener;
}

int portOf(int listener) {
  sockaddr_in address{};
  socklen_t size = sizeof(address);
  return getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size) == 0 ? ntohs(address.sin_port) : 0;
}

ssize_t readStream(void* self, uint64_t /*position*/, char* bytes, size_t size) {
  try {
    const size_t count = (*static_cast<LocalStream*>(self))(bytes, size);
    return count > 0 ? static_cast<ssize_t>(count) : MHD_CONTENT_READER_END_OF_STREAM;
  } catch (...) {
    return MHD_CONTENT_READER_END_WITH_ERROR;
  }
}

}  // namespace

struct LocalServer::State {
  State(int wantedPort, LocalServerOptions theOptions,
        std::function<std::optional<LocalAnswer>(std::string_view)> theAnswer)
      : options(std::move(theOptions)), answerOf(std::move(theAnswer)) {
    const int listener = listenHere(wantedPort, options);
    port = portOf(listener);
    const unsigned threads = options.hasThreads ? MHD_USE_THREAD_PER_CONNECTION : 0;
    daemon = MHD_start_daemon(MHD_USE_INTERNAL_POLLING_THREAD | threads, 0, nullptr, nullptr, &State::take, this,
                              MHD_OPTION_LISTEN_SOCKET, listener, MHD_OPTION_CONNECTION_LIMIT, options.maxConnections,
                              MHD_OPTION_CONNECTION_TIMEOUT, options.timeoutSeconds, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
                              kConnectionBytes, MHD_OPTION_END);
    if (daemon == nullptr) {
      close(listener);
      throw WorkError("the page cannot be served", fmt::format("{} {}", options.option, wantedPort),
                      fmt::format("leave {} away", options.option));
    }
  }
  ~State() { MHD_stop_daemon(daemon); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  MHD_Result send(MHD_Connection* connection, unsigned code, const LocalAnswer& answer) const {
    MHD_Response* const response =
        answer.stream ? MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kBlockBytes, &readStream,
                                                          new LocalStream(answer.stream),
                                                          [](void* self) { delete static_cast<LocalStream*>(self); })
                      : MHD_create_response_from_buffer(answer.body.size(), const_cast<char*>(answer.body.data()),
                                                        MHD_RESPMEM_MUST_COPY);
    if (response == nullptr) {
      return MHD_NO;
    }
    const std::string policy =
        "default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'unsafe-inline'; img-src " +
        options.images + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
    for (const auto& [name, value] :
         std::initializer_list<std::pair<const char*, const char*>>{{"Content-Type", answer.type.c_str()},
                                                                    {"Cache-Control", "no-store"},
                                                                    {"Content-Security-Policy", policy.c_str()},
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
  static MHD_Result take(void* self, MHD_Connection* connection, const char* url, const char* method,
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
    const char* const host = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Host");
    const std::string_view name = host != nullptr ? host : "";
    if (name != fmt::format("127.0.0.1:{}", port) && name != fmt::format("localhost:{}", port)) {
      return send(connection, MHD_HTTP_FORBIDDEN,
                  {kPlainText, fmt::format("this page is at 127.0.0.1:{} alone\n", port)});
    }
    if (method != "GET" && method != "HEAD") {
      return send(connection, MHD_HTTP_METHOD_NOT_ALLOWED, {kPlainText, "this page can only be read\n"});
    }
    const std::optional<LocalAnswer> answer = answerOf(url);
    return answer ? send(connection, MHD_HTTP_OK, *answer)
                  : send(connection, MHD_HTTP_NOT_FOUND, {kPlainText, "there is nothing here\n"});
  }

  LocalServerOptions options;
  std::function<std::optional<LocalAnswer>(std::string_view)> answerOf;
  int port = 0;
  MHD_Daemon* daemon = nullptr;
};

LocalServer::LocalServer(int port, const LocalServerOptions& options,
                         std::function<std::optional<LocalAnswer>(std::string_view)> answer)
    : state_(std::make_unique<State>(port, options, std::move(answer))) {}

LocalServer::~LocalServer() = default;

int LocalServer::port() const {
  return state_->port;
}

std::string LocalServer::address() const {
  return fmt::format("http://127.0.0.1:{}/", state_->port);
}

}  // namespace ocelli
