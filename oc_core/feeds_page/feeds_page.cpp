#include "oc_core/feeds_page/feeds_page.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <microhttpd.h>
#include <netinet/in.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "oc_core/base/error.h"
#include "oc_core/feeds_page/feeds_page_html.h"
#include "oc_core/feeds_page/page_frames.h"

namespace ocelli {
namespace {

constexpr unsigned kMaxBrowsers = 16;
constexpr unsigned kTimeoutSeconds = 30;
constexpr size_t kBlockBytes = size_t{64} << 10;
constexpr const char* kBoundary = "ocelli-image";
constexpr const char* kPlainText = "text/plain; charset=utf-8";

/// One browser that watches: what is still to be sent to it of one image.
struct Watching {
  PageFrames& frames;
  uint64_t seen = 0;
  bool hasBegun = false;
  std::string part = {};
  size_t sent = 0;

  static ssize_t read(void* self, uint64_t /*position*/, char* bytes, size_t size) {
    auto& watching = *static_cast<Watching*>(self);
    if (watching.sent == watching.part.size() && !watching.fetch()) {
      return MHD_CONTENT_READER_END_OF_STREAM;
    }
    const size_t count = std::min(size, watching.part.size() - watching.sent);
    std::memcpy(bytes, watching.part.data() + watching.sent, count);
    watching.sent += count;
    return static_cast<ssize_t>(count);
  }

  bool fetch() {
    const auto file = frames.next(seen);
    if (file == nullptr) {
      return false;
    }
    // The boundary behind an image lets browsers show it before the next one is there.
    part = fmt::format("{}Content-Type: {}\r\nContent-Length: {}\r\n\r\n{}\r\n--{}\r\n",
                       hasBegun ? "" : fmt::format("--{}\r\n", kBoundary), PageFrames::mediaType(), file->size(), *file,
                       kBoundary);
    hasBegun = true;
    sent = 0;
    return true;
  }
};

MHD_Result queue(MHD_Connection* connection, unsigned code, const std::string& type, MHD_Response* response) {
  if (response == nullptr) {
    return MHD_NO;
  }
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, const char*>>{
           {"Content-Type", type.c_str()},
           {"Cache-Control", "no-store"},
           {"Content-Security-Policy",
            "default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'unsafe-inline'; img-src 'self'; "
            "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
           {"Cross-Origin-Resource-Policy", "same-origin"},
           {"Referrer-Policy", "no-referrer"},
           {"X-Content-Type-Options", "nosniff"}}) {
    MHD_add_response_header(response, name, value);
  }
  const MHD_Result result = MHD_queue_response(connection, code, response);
  MHD_destroy_response(response);
  return result;
}

MHD_Result sendText(MHD_Connection* connection, unsigned code, const char* type, const std::string& text) {
  return queue(connection, code, type,
               MHD_create_response_from_buffer(text.size(), const_cast<char*>(text.data()), MHD_RESPMEM_MUST_COPY));
}

}  // namespace

struct FeedsPage::State {
  State(int wantedPort, std::string theTitle) : title(std::move(theTitle)) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_port = htons(static_cast<uint16_t>(wantedPort));
    here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    errno = 0;
    daemon = MHD_start_daemon(MHD_USE_INTERNAL_POLLING_THREAD | MHD_USE_THREAD_PER_CONNECTION, 0, nullptr, nullptr,
                              &State::answer, this, MHD_OPTION_SOCK_ADDR, &here, MHD_OPTION_CONNECTION_LIMIT,
                              kMaxBrowsers, MHD_OPTION_CONNECTION_TIMEOUT, kTimeoutSeconds, MHD_OPTION_END);
    if (daemon == nullptr) {
      throw WorkError(errno == EADDRINUSE ? "another program uses this port already" : "this port cannot be used",
                      fmt::format("--page {}", wantedPort), "give another port, or 0 for any that is free");
    }
    port = MHD_get_daemon_info(daemon, MHD_DAEMON_INFO_BIND_PORT)->port;
  }
  ~State() {
    frames.stop();
    MHD_stop_daemon(daemon);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

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
      return static_cast<State*>(self)->respond(connection, url, method);
    } catch (...) {
      return MHD_NO;
    }
  }

  MHD_Result respond(MHD_Connection* connection, std::string_view url, std::string_view method) {
    const char* const host = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Host");
    const std::string_view name = host != nullptr ? host : "";
    if (name != fmt::format("127.0.0.1:{}", port) && name != fmt::format("localhost:{}", port)) {
      return sendText(connection, MHD_HTTP_FORBIDDEN, kPlainText,
                      fmt::format("this page is at 127.0.0.1:{} alone\n", port));
    }
    if (method != "GET" && method != "HEAD") {
      return sendText(connection, MHD_HTTP_METHOD_NOT_ALLOWED, kPlainText, "this page can only be read\n");
    }
    if (url == "/") {
      return sendText(connection, MHD_HTTP_OK, "text/html; charset=utf-8", feedsPageHtml(title));
    }
    if (url == kFeedsScriptPath) {
      return sendText(connection, MHD_HTTP_OK, "text/javascript; charset=utf-8", feedsPageScript());
    }
    if (url == kFeedsStatusPath) {
      return sendText(connection, MHD_HTTP_OK, "application/json", nlohmann::json(frames.feeds()).dump());
    }
    if (url == kFeedsImagePath) {
      auto* const watching = new Watching{frames};
      return queue(connection, MHD_HTTP_OK, fmt::format("multipart/x-mixed-replace; boundary={}", kBoundary),
                   MHD_create_response_from_callback(MHD_SIZE_UNKNOWN, kBlockBytes, &Watching::read, watching,
                                                     [](void* self) { delete static_cast<Watching*>(self); }));
    }
    return sendText(connection, MHD_HTTP_NOT_FOUND, kPlainText, "there is nothing here\n");
  }

  std::string title;
  PageFrames frames;
  int port = 0;
  MHD_Daemon* daemon = nullptr;
};

FeedsPage::FeedsPage(int port, const std::string& title) : state_(std::make_unique<State>(port, title)) {}

FeedsPage::~FeedsPage() = default;

int FeedsPage::port() const {
  return state_->port;
}

std::string FeedsPage::address() const {
  return fmt::format("http://127.0.0.1:{}/", state_->port);
}

void FeedsPage::show(const Image<Rgb8>& image, const std::vector<std::string>& feeds) {
  state_->frames.set(image, feeds);
}

}  // namespace ocelli
