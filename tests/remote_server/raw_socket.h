// A client of TCP for tests, which sends what it is told to, however wrong, and a WebSocket by hand on top of it.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ocelli::test {

/// How long a test waits for what should come at once: far more than a loaded computer needs, as sanitizers are slow.
inline constexpr std::chrono::milliseconds kPatience{20'000};

class RawSocket {
 public:
  /// Connects to 127.0.0.1, from an address of this computer: each of 127.0.0.0/8 is one.
  explicit RawSocket(int port, const std::string& from = "127.0.0.1");
  ~RawSocket();
  RawSocket(RawSocket&& other) noexcept;
  RawSocket& operator=(RawSocket&&) = delete;

  bool isConnected() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }
  /// False where the other end has closed.
  bool send(std::string_view bytes) const;
  /// What has come, at most so much; empty at the end, and where nothing came in time.
  std::string receive(size_t maxBytes, std::chrono::milliseconds patience = kPatience);
  /// Whether the last receive() met the end of the connection.
  bool hasEnded() const { return hasEnded_; }
  /// All that comes until the other end closes.
  std::string receiveAll(std::chrono::milliseconds patience = kPatience);

  void close();
  /// Ends the connection by RST: without a word, as a program that crashes does.
  void reset();

 private:
  int descriptor_ = -1;
  bool hasEnded_ = false;
};

/// A frame of RFC 6455, section 5.2, as clients send them. Each part may be wrong.
struct Frame {
  static constexpr int kContinuation = 0;
  static constexpr int kText = 1;
  static constexpr int kBinary = 2;
  static constexpr int kClose = 8;
  static constexpr int kPing = 9;
  static constexpr int kPong = 10;

  int opcode = kText;
  std::string payload{};
  bool isLast = true;
  int reservedBits = 0;  ///< 0 to 7
  bool isMasked = true;
  std::optional<uint64_t> saidLength{};  ///< in place of the payload's
};
std::string bytesOf(const Frame& frame);

struct Handshake {
  std::string path = "/ws";
  std::string host{};    ///< empty: that of the port
  std::string origin{};  ///< empty: none
  std::string more{};    ///< further headers, each with its end of line
};
std::string bytesOf(const Handshake& handshake, int port);

class TestWebSocket {
 public:
  /// Connects and shakes hands. isOpen() says whether the server did, too.
  explicit TestWebSocket(int port, const Handshake& handshake = {}, const std::string& from = "127.0.0.1");

  bool isOpen() const { return isOpen_; }
  /// The answer to the handshake.
  const std::string& answer() const { return answer_; }
  RawSocket& socket() { return socket_; }

  bool send(const Frame& frame) const { return socket_.send(bytesOf(frame)); }
  bool sendText(const std::string& text) const { return send({.payload = text}); }
  /// The next frame of the server; pings are answered and left out. Nothing at the end of the connection, or where none
  /// came in time.
  std::optional<Frame> receive(std::chrono::milliseconds patience = kPatience);
  /// Of a frame that closes; 0 where there is none.
  static int closeCode(const Frame& frame);
  /// The code with which the server closes, which is answered; other frames are left out. 0 where it closes without
  /// one, -1 where it does not.
  int awaitClose(std::chrono::milliseconds patience = kPatience);
  void stopAnsweringPings() { answersPings_ = false; }

 private:
  using Clock = std::chrono::steady_clock;
  bool fill(size_t bytes, Clock::time_point deadline);
  std::optional<Frame> receiveUntil(Clock::time_point deadline);

  RawSocket socket_;
  std::string buffer_;
  std::string answer_;
  bool isOpen_ = false;
  bool answersPings_ = true;
};

}  // namespace ocelli::test
