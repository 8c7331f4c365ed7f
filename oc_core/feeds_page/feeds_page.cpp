#include "oc_core/feeds_page/feeds_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "oc_core/feeds_page/feeds_page_html.h"
#include "oc_core/feeds_page/page_frames.h"
#include "oc_core/local_server/local_server.h"

namespace ocelli {
namespace {

constexpr unsigned kTimeoutSeconds = 30;
constexpr const char* kBoundary = "ocelli-image";

/// One browser that watches: what is still to be sent to it of one image.
struct Watching {
  PageFrames& frames;
  uint64_t seen = 0;
  bool hasBegun = false;
  std::string part = {};
  size_t sent = 0;

  size_t operator()(char* bytes, size_t size) {
    if (sent == part.size() && !fetch()) {
      return 0;
    }
    const size_t count = std::min(size, part.size() - sent);
    std::memcpy(bytes, part.data() + sent, count);
    sent += count;
    return count;
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

}  // namespace

struct FeedsPage::State {
  State(int port, std::string theTitle)
      : title(std::move(theTitle)),
        server(port, {.option = "--page", .timeoutSeconds = kTimeoutSeconds, .hasThreads = true},
               [this](std::string_view path) { return answer(path); }) {}
  ~State() { frames.stop(); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  std::optional<LocalAnswer> answer(std::string_view path) {
    if (path == "/") {
      return LocalAnswer{"text/html; charset=utf-8", feedsPageHtml(title)};
    }
    if (path == kFeedsScriptPath) {
      return LocalAnswer{"text/javascript; charset=utf-8", feedsPageScript()};
    }
    if (path == kFeedsStatusPath) {
      nlohmann::json feeds = nlohmann::json::array();
      for (const PageFeed& feed : frames.feeds()) {
        feeds.push_back({{"text", feed.text}, {"good", feed.isGood}});
      }
      return LocalAnswer{"application/json", feeds.dump()};
    }
    if (path == kFeedsImagePath) {
      return LocalAnswer{fmt::format("multipart/x-mixed-replace; boundary={}", kBoundary), "", Watching{frames}};
    }
    return std::nullopt;
  }

  std::string title;
  PageFrames frames;
  LocalServer server;
};

FeedsPage::FeedsPage(int port, const std::string& title) : state_(std::make_unique<State>(port, title)) {}

FeedsPage::~FeedsPage() = default;

int FeedsPage::port() const {
  return state_->server.port();
}

std::string FeedsPage::address() const {
  return state_->server.address();
}

void FeedsPage::show(const Image<Rgb8>& image, const std::vector<PageFeed>& feeds) {
  state_->frames.set(image, feeds);
}

}  // namespace ocelli
