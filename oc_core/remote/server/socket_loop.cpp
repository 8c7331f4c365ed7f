#include "oc_core/remote/server/socket_loop.h"

#include <libwebsockets.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/steady_time.h"

namespace ocelli {
namespace {

constexpr int kCloseConnection = -1;
constexpr int kRefused = 1;  // of an upgrade, which was answered
constexpr const char* kProtocolName = "ocelli-remote";
constexpr size_t kMaxWriteBytes = size_t{64} << 10;
constexpr size_t kBodyPieceBytes = size_t{16} << 10;
constexpr unsigned kRequestBytes = 4096;  // the headers of a request together
constexpr lws_usec_t kTickMicroseconds = 200'000;
constexpr int64_t kAnswerToCloseNanoseconds = 3'000'000'000;

std::string headerOf(lws* wsi, lws_token_indexes token) {
  const int length = lws_hdr_total_length(wsi, token);
  if (length <= 0) {
    return {};
  }
  std::string text(static_cast<size_t>(length) + 1, '\0');
  const int copied = lws_hdr_copy(wsi, text.data(), static_cast<int>(text.size()), token);
  text.resize(static_cast<size_t>(std::max(copied, 0)));
  return text;
}

std::string queryOf(lws* wsi) {
  std::string query;
  std::array<char, kRequestBytes> field{};
  for (int i = 0;; ++i) {
    const int length =
        lws_hdr_copy_fragment(wsi, field.data(), static_cast<int>(field.size()), WSI_TOKEN_HTTP_URI_ARGS, i);
    if (length < 0) {
      return query;
    }
    query += (i == 0 ? "" : "&") + std::string(field.data(), static_cast<size_t>(length));
  }
}

HttpRequest requestOf(lws* wsi) {
  HttpRequest request;
  for (const auto& [token, method] : std::initializer_list<std::pair<lws_token_indexes, const char*>>{
           {WSI_TOKEN_GET_URI, "GET"}, {WSI_TOKEN_HEAD_URI, "HEAD"}, {WSI_TOKEN_POST_URI, "POST"}}) {
    if (lws_hdr_total_length(wsi, token) > 0) {
      request.method = method;
      request.path = headerOf(wsi, token);
    }
  }
  request.query = queryOf(wsi);
  request.host = headerOf(wsi, WSI_TOKEN_HOST);
  request.origin = headerOf(wsi, WSI_TOKEN_ORIGIN);
  request.upgrade = headerOf(wsi, WSI_TOKEN_UPGRADE);
  return request;
}

/// False where the connection is to be closed. What does not go at once is kept and goes before anything else.
bool writeTo(lws* wsi, std::span<const std::byte> bytes, lws_write_protocol how) {
  std::vector<unsigned char> buffer(LWS_PRE + bytes.size());
  if (!bytes.empty()) {
    std::memcpy(buffer.data() + LWS_PRE, bytes.data(), bytes.size());
  }
  return lws_write(wsi, buffer.data() + LWS_PRE, bytes.size(), how) >= static_cast<int>(bytes.size());
}

std::span<const std::byte> bytesOf(std::string_view text) {
  return std::as_bytes(std::span(text));
}

void setCloseReason(lws* wsi, const CloseReason& reason) {
  constexpr size_t kMaxReasonBytes = 123;
  std::string text = reason.text.substr(0, kMaxReasonBytes);
  lws_close_reason(wsi, static_cast<lws_close_status>(reason.code), reinterpret_cast<unsigned char*>(text.data()),
                   text.size());
}

void logNothing(int /*level*/, const char* /*line*/) {}

/// Closes it where nobody has taken it over.
class OwnedDescriptor {
 public:
  explicit OwnedDescriptor(int descriptor) : descriptor_(descriptor) {}
  ~OwnedDescriptor() {
    if (descriptor_ >= 0) {
      close(descriptor_);
    }
  }
  OwnedDescriptor(const OwnedDescriptor&) = delete;
  OwnedDescriptor& operator=(const OwnedDescriptor&) = delete;
  int release() { return std::exchange(descriptor_, -1); }

 private:
  int descriptor_;
};

struct LoopConnection {
  uint64_t number = 0;
  lws* wsi = nullptr;
  HttpAnswer answer;
  size_t bodySent = 0;
  std::optional<CloseReason> closing;
  int64_t closeBy = 0;  ///< where `closing`
};

}  // namespace

class SocketLoop::Lws {
 public:
  Lws(const LoopSetup& setup, ListeningSocket& listener, LoopEvents& events) : listener_(listener), events_(events) {
    lws_set_log_level(0, logNothing);
    retry_.secs_since_valid_ping = static_cast<uint16_t>(setup.pingSeconds);
    retry_.secs_since_valid_hangup = static_cast<uint16_t>(3 * setup.pingSeconds);
    protocols_[0].name = kProtocolName;
    protocols_[0].callback = callBack;
    protocols_[0].tx_packet_size = kMaxWriteBytes;
    lws_context_creation_info info{};
    info.port = CONTEXT_PORT_NO_LISTEN_SERVER;
    info.protocols = protocols_.data();
    info.vhost_name = kProtocolName;
    info.options = LWS_SERVER_OPTION_SKIP_SERVER_CANONICAL_NAME | LWS_SERVER_OPTION_VALIDATE_UTF8;
    info.user = this;
    info.gid = static_cast<decltype(info.gid)>(-1);
    info.uid = static_cast<decltype(info.uid)>(-1);
    info.max_http_header_data2 = kRequestBytes;
    constexpr unsigned kDescriptorsOfItsOwn = 16;
    info.fd_limit_per_thread = static_cast<unsigned>(setup.maxConnections) + kDescriptorsOfItsOwn;
    info.timeout_secs = static_cast<unsigned>(setup.handshakeSeconds);
    info.timeout_secs_ah_idle = static_cast<unsigned>(setup.handshakeSeconds);
    info.keepalive_timeout = setup.handshakeSeconds;
    info.retry_and_idle_policy = &retry_;
    context_ = lws_create_context(&info);
    vhost_ = context_ != nullptr ? lws_get_vhost_by_name(context_, kProtocolName) : nullptr;
    lws_sock_file_fd_type descriptor{};
    descriptor.filefd = listener.release();
    if (vhost_ != nullptr) {
      listenerWsi_ = lws_adopt_descriptor_vhost(vhost_, LWS_ADOPT_RAW_FILE_DESC, descriptor, kProtocolName, nullptr);
    }
    if (listenerWsi_ == nullptr) {
      destroy();
      throw WorkError("libwebsockets does not start", "the server of remote visualisation",
                      "see whether this program may open more files (ulimit -n)");
    }
    tick_.loop = this;
    scheduleTick();
  }

  ~Lws() { destroy(); }
  Lws(const Lws&) = delete;
  Lws& operator=(const Lws&) = delete;

  void start() {
    thread_ = std::thread([this] {
      while (!isStopping_ && lws_service(context_, 0) >= 0) {
      }
    });
  }

  void stop() {
    isStopping_ = true;
    lws_cancel_service(context_);
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  void post(std::function<void()> work) {
    {
      const std::lock_guard lock(postedMutex_);
      posted_.push_back(std::move(work));
    }
    lws_cancel_service(context_);
  }

  void wantToSend(uint64_t connection) {
    if (LoopConnection* const found = find(connection)) {
      lws_callback_on_writable(found->wsi);
    }
  }

  void closeSoon(uint64_t connection, const CloseReason& reason) {
    LoopConnection* const found = find(connection);
    if (found != nullptr && !found->closing) {
      found->closing = reason;
      found->closeBy = steadyNanoseconds() + kAnswerToCloseNanoseconds;
      lws_callback_on_writable(found->wsi);
    }
  }

  void closeNow(uint64_t connection) {
    if (LoopConnection* const found = find(connection)) {
      lws_set_timeout(found->wsi, PENDING_TIMEOUT_USER_OK, LWS_TO_KILL_ASYNC);
    }
  }

 private:
  struct Tick {
    lws_sorted_usec_list_t list{};  // the first member: libwebsockets hands its address back
    Lws* loop = nullptr;
  };

  void destroy() {
    if (context_ != nullptr) {
      lws_sul_schedule(context_, 0, &tick_.list, nullptr, LWS_SET_TIMER_USEC_CANCEL);
      lws_context_destroy(context_);
      context_ = nullptr;
    }
  }

  void scheduleTick() {
    lws_sul_schedule(
        context_, 0, &tick_.list,
        [](lws_sorted_usec_list_t* list) { reinterpret_cast<Tick*>(list)->loop->tickAgain(); }, kTickMicroseconds);
  }

  /// Called through libwebsockets: nothing is thrown, and there is a next time whatever happens.
  void tickAgain() noexcept {
    scheduleTick();
    try {
      tick();
    } catch (...) {  // of memory that ran out, for example: what was left out is done the next time
    }
  }

  void tick() {
    takeConnections(true);
    const int64_t now = steadyNanoseconds();
    for (const auto& [number, connection] : connections_) {
      if (connection->closing && now > connection->closeBy) {
        closeNow(number);
      }
    }
    events_.tick();
  }

  /// Not where there is no descriptor for the next one: its socket would be ready for ever, and this thread never rest.
  void takeConnections(bool isToTake) {
    if (takesConnections_ != isToTake) {
      takesConnections_ = isToTake;
      lws_rx_flow_control(listenerWsi_,
                          LWS_RXFLOW_REASON_FLAG_PROCESS_NOW |
                              (isToTake ? LWS_RXFLOW_REASON_APPLIES_ENABLE : LWS_RXFLOW_REASON_APPLIES_DISABLE) |
                              LWS_RXFLOW_REASON_USER_BOOL);
    }
  }

  LoopConnection* find(uint64_t connection) {
    const auto found = connections_.find(connection);
    return found != connections_.end() ? found->second.get() : nullptr;
  }

  static int callBack(lws* wsi, lws_callback_reasons reason, void* /*session*/, void* in, size_t length) {
    try {
      auto* const loop = static_cast<Lws*>(lws_context_user(lws_get_context(wsi)));
      return loop->handle(wsi, reason, static_cast<const char*>(in), length);
    } catch (...) {
      // Of memory that ran out, for example: of this connection alone, and never the socket that listens.
      return reason == LWS_CALLBACK_RAW_RX_FILE || reason == LWS_CALLBACK_EVENT_WAIT_CANCELLED ? 0 : kCloseConnection;
    }
  }

  int handle(lws* wsi, lws_callback_reasons reason, const char* in, size_t length) {
    if (reason == LWS_CALLBACK_RAW_RX_FILE) {
      try {
        acceptAll();
      } catch (...) {
        takeConnections(false);  // until the next tick
        events_.couldNotAccept();
      }
      return 0;
    }
    if (reason == LWS_CALLBACK_EVENT_WAIT_CANCELLED) {
      runPosted();
      return 0;
    }
    auto* const connection = static_cast<LoopConnection*>(lws_get_opaque_user_data(wsi));
    return connection != nullptr ? handleConnection(*connection, wsi, reason, in, length) : 0;
  }

  int handleConnection(LoopConnection& connection, lws* wsi, int reason, const char* in, size_t length) {
    switch (reason) {
      case LWS_CALLBACK_SERVER_NEW_CLIENT_INSTANTIATED:
        connection.wsi = wsi;
        return 0;
      case LWS_CALLBACK_WSI_DESTROY: {
        const uint64_t number = connection.number;
        lws_set_opaque_user_data(wsi, nullptr);
        connections_.erase(number);
        events_.closed(number);
        return 0;
      }
      case LWS_CALLBACK_HTTP:
        return answer(connection);
      case LWS_CALLBACK_HTTP_WRITEABLE:
        return writeBody(connection);
      case LWS_CALLBACK_HTTP_BODY:
        return kCloseConnection;
      case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
        return confirmUpgrade(connection, in != nullptr ? in : "");
      case LWS_CALLBACK_ESTABLISHED:
        events_.becameWebSocket(connection.number);
        return 0;
      case LWS_CALLBACK_RECEIVE:
        return receive(connection, std::string_view(in, length));
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return writeMessage(connection);
      case LWS_CALLBACK_TIMER:
        lws_callback_on_writable(wsi);
        return 0;
      default:
        return 0;
    }
  }

  void acceptAll() {
    while (const std::optional<AcceptedSocket> accepted = listener_.accept()) {
      OwnedDescriptor descriptor(accepted->descriptor);
      if (!events_.accepts(*accepted)) {
        continue;
      }
      const uint64_t number = ++lastNumber_;
      auto connection = std::make_unique<LoopConnection>();
      connection->number = number;
      lws_adopt_desc_t adopted{};
      adopted.vh = vhost_;
      adopted.type = static_cast<lws_adoption_type>(LWS_ADOPT_HTTP | LWS_ADOPT_SOCKET);
      adopted.opaque = connection.get();
      connections_[number] = std::move(connection);
      try {
        events_.connected(number, *accepted);
      } catch (...) {
        connections_.erase(number);
        throw;
      }
      // It closes the socket where it fails.
      adopted.fd.sockfd = descriptor.release();
      lws* const wsi = lws_adopt_descriptor_vhost_via_info(&adopted);
      if (LoopConnection* const known = find(number)) {
        if (wsi != nullptr) {
          known->wsi = wsi;
        } else {
          connections_.erase(number);
          events_.closed(number);
        }
      }
    }
  }

  void runPosted() {
    std::vector<std::function<void()>> works;
    {
      const std::lock_guard lock(postedMutex_);
      works.swap(posted_);
    }
    for (const auto& work : works) {
      try {
        work();
      } catch (...) {  // must not keep the others from what is theirs
      }
    }
  }

  int answer(LoopConnection& connection) {
    connection.answer = events_.answer(connection.number, requestOf(connection.wsi));
    connection.bodySent = 0;
    const HttpAnswer& answer = connection.answer;
    if (!writeTo(connection.wsi, bytesOf(answer.head), LWS_WRITE_HTTP_HEADERS) || !answer.withBody ||
        answer.body().empty()) {
      return kCloseConnection;
    }
    lws_callback_on_writable(connection.wsi);
    return 0;
  }

  int writeBody(LoopConnection& connection) {
    const std::string_view rest = std::string_view(connection.answer.body()).substr(connection.bodySent);
    const std::string_view piece = rest.substr(0, kBodyPieceBytes);
    if (piece.empty() || !writeTo(connection.wsi, bytesOf(piece), LWS_WRITE_HTTP)) {
      return kCloseConnection;
    }
    connection.bodySent += piece.size();
    lws_callback_on_writable(connection.wsi);
    return 0;
  }

  int confirmUpgrade(LoopConnection& connection, const std::string& to) {
    HttpRequest request = requestOf(connection.wsi);
    request.upgrade = to;
    const HttpAnswer answer = events_.upgradeAnswer(connection.number, request);
    if (answer.code == 101) {
      return 0;
    }
    const bool written = writeTo(connection.wsi, bytesOf(answer.head + answer.body()), LWS_WRITE_HTTP_HEADERS);
    return written ? kRefused : kCloseConnection;
  }

  int receive(LoopConnection& connection, std::string_view part) {
    const bool isLast = lws_is_final_fragment(connection.wsi) != 0 && lws_remaining_packet_payload(connection.wsi) == 0;
    const bool isBinary = lws_frame_is_binary(connection.wsi) != 0;
    if (connection.closing) {
      return 0;  // what it says now is too late
    }
    if (const auto reason = events_.received(connection.number, part, isBinary, isLast)) {
      setCloseReason(connection.wsi, *reason);
      return kCloseConnection;
    }
    return 0;
  }

  int writeMessage(LoopConnection& connection) {
    if (connection.closing) {
      setCloseReason(connection.wsi, *connection.closing);
      return kCloseConnection;
    }
    int64_t wait = 0;
    const std::optional<OutgoingMessage> message = events_.nextMessage(connection.number, wait);
    if (message) {
      if (!writeTo(connection.wsi, message->bytes, message->isText ? LWS_WRITE_TEXT : LWS_WRITE_BINARY)) {
        return kCloseConnection;
      }
      lws_callback_on_writable(connection.wsi);
    } else if (wait > 0) {
      lws_set_timer_usecs(connection.wsi, wait / 1000 + 1);
    }
    return 0;
  }

  ListeningSocket& listener_;
  LoopEvents& events_;
  lws_retry_bo_t retry_{};
  std::array<lws_protocols, 2> protocols_{};  // the last one is empty
  lws_context* context_ = nullptr;
  lws_vhost* vhost_ = nullptr;
  lws* listenerWsi_ = nullptr;
  bool takesConnections_ = true;
  Tick tick_;
  std::map<uint64_t, std::unique_ptr<LoopConnection>> connections_;
  uint64_t lastNumber_ = 0;
  std::mutex postedMutex_;
  std::vector<std::function<void()>> posted_;
  std::atomic<bool> isStopping_ = false;
  std::thread thread_;
};

SocketLoop::SocketLoop(const LoopSetup& setup, ListeningSocket& listener, LoopEvents& events)
    : lws_(std::make_unique<Lws>(setup, listener, events)) {}

SocketLoop::~SocketLoop() = default;

void SocketLoop::start() {
  lws_->start();
}

void SocketLoop::stop() {
  lws_->stop();
}

void SocketLoop::post(std::function<void()> work) {
  lws_->post(std::move(work));
}

void SocketLoop::wantToSend(uint64_t connection) {
  lws_->wantToSend(connection);
}

void SocketLoop::closeSoon(uint64_t connection, const CloseReason& reason) {
  lws_->closeSoon(connection, reason);
}

void SocketLoop::closeNow(uint64_t connection) {
  lws_->closeNow(connection);
}

}  // namespace ocelli
