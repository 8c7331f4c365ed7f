#include "display_driver/pacing/eye_feed.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>
#include <vector>

#include "display_driver/pacing/foreseen_eyes.h"
#include "display_sim/observing/eye_path.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"
#include "oc_core/base/printable_text.h"

namespace ocelli {
namespace {

class PathFeed final : public EyeFeed {
 public:
  PathFeed(std::vector<EyePose> poses, bool loop) : poses_(std::move(poses)), loop_(loop) {}

  std::optional<glm::vec3> eyeAt(HostTime seen) override {
    const double duration = poses_.back().seconds - poses_.front().seconds;
    double seconds = since(seen);
    if (loop_ && duration > 0) {
      seconds = std::fmod(seconds, duration);
    }
    return ocelli::eyeAt(poses_, poses_.front().seconds + seconds);
  }
  bool ended(HostTime seen) override { return !loop_ && since(seen) > poses_.back().seconds - poses_.front().seconds; }

 private:
  double since(HostTime seen) {
    if (!start_) {
      start_ = seen;
    }
    return std::chrono::duration<double>(seen - *start_).count();
  }

  std::vector<EyePose> poses_;
  bool loop_;
  std::optional<HostTime> start_;
};

/// Longer ones are no poses.
constexpr size_t kMaxLineBytes = 256;

/// Of a wrong one, for people.
constexpr size_t kMaxShownBytes = 80;

/// Reads on a thread of its own, so that of all that has come the newest is there when it is asked for.
class LiveFeed : public EyeFeed {
 public:
  explicit LiveFeed(EyePrediction prediction) : eyes_(prediction) {}
  ~LiveFeed() override { stop(); }

  std::optional<glm::vec3> eyeAt(HostTime seen) override {
    const std::lock_guard lock(mutex_);
    return eyes_.at(seen);
  }
  bool ended(HostTime) override { return ended_; }
  uint64_t malformed() const override { return malformed_; }
  std::string firstMalformed() const override {
    const std::lock_guard lock(mutex_);
    return firstMalformed_;
  }
  PredictionErrors predictionErrors() const override {
    const std::lock_guard lock(mutex_);
    return eyes_.errors();
  }

 protected:
  /// Calls `read` whenever there is something to read, until that returns false.
  void start(int descriptor, std::function<bool()> read) {
    thread_ = std::thread([this, descriptor, read = std::move(read)] {
      pollfd waits{.fd = descriptor, .events = POLLIN, .revents = 0};
      constexpr int kMillisecondsToStop = 50;
      while (!stopping_) {
        const int ready = poll(&waits, 1, kMillisecondsToStop);
        if (ready > 0 && !read()) {
          break;
        }
      }
      ended_ = true;
    });
  }
  void stop() {
    stopping_ = true;
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  void take(std::string_view line) {
    while (line.ends_with('\n') || line.ends_with('\r')) {
      line.remove_suffix(1);
    }
    // A header is no mistake.
    if (line.empty() || line == kEyePathHeader) {
      return;
    }
    const auto pose = line.size() <= kMaxLineBytes ? poseFromLine(line) : std::nullopt;
    const std::lock_guard lock(mutex_);
    if (pose) {
      eyes_.add(*pose, std::chrono::steady_clock::now());
    } else if (malformed_++ == 0) {
      const std::string problem = line.size() > kMaxLineBytes ? "too long" : problemOfLine(line);
      firstMalformed_ = "not TIME,X,Y,Z (" + problem + "): \"" + printableText(line.substr(0, kMaxShownBytes)) + "\"";
    }
  }

 private:
  mutable std::mutex mutex_;
  ForeseenEyes eyes_;
  std::string firstMalformed_;
  std::atomic<uint64_t> malformed_ = 0;
  std::atomic<bool> ended_ = false;
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

class LineFeed final : public LiveFeed {
 public:
  LineFeed(int descriptor, EyePrediction prediction) : LiveFeed(prediction) {
    start(descriptor, [this, descriptor] { return readSome(descriptor); });
  }
  ~LineFeed() override { stop(); }

 private:
  bool readSome(int descriptor) {
    std::array<char, 4096> bytes{};
    const ssize_t count = read(descriptor, bytes.data(), bytes.size());
    if (count <= 0) {
      if (count < 0 && (errno == EINTR || errno == EAGAIN)) {
        return true;
      }
      take(line_);
      return false;
    }
    for (const char c : std::string_view(bytes.data(), static_cast<size_t>(count))) {
      if (c == '\n') {
        take(line_);
        line_.clear();
      } else if (line_.size() <= kMaxLineBytes) {
        line_ += c;
      }
    }
    return true;
  }

  std::string line_;
};

class DatagramFeed final : public LiveFeed {
 public:
  DatagramFeed(const std::string& address, uint16_t port, const std::string& where, EyePrediction prediction)
      : LiveFeed(prediction) {
    sockaddr_in here{};
    here.sin_family = AF_INET;
    here.sin_port = htons(port);
    if (inet_pton(AF_INET, address.c_str(), &here.sin_addr) != 1) {
      throw InputError("this is no IPv4 address: " + address, where, "--eyes udp:127.0.0.1:5005");
    }
    socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    if (socket_ < 0 || bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0) {
      const std::string reason = std::strerror(errno);
      if (socket_ >= 0) {
        close(socket_);
      }
      throw WorkError("cannot listen at this port: " + reason, where, "another port");
    }
    start(socket_, [this] {
      std::array<char, kMaxLineBytes + 1> bytes{};
      const ssize_t count = recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_TRUNC);
      if (count >= 0) {
        take({bytes.data(), std::min(static_cast<size_t>(count), bytes.size())});
      }
      return true;
    });
  }
  ~DatagramFeed() override {
    stop();
    close(socket_);
  }

 private:
  int socket_ = -1;
};

}  // namespace

std::unique_ptr<EyeFeed> eyeFeedFromLines(int descriptor, EyePrediction prediction) {
  return std::make_unique<LineFeed>(descriptor, prediction);
}

std::unique_ptr<EyeFeed> openEyeFeed(const std::string& text, bool loop, EyePrediction prediction) {
  if (text == "-") {
    return eyeFeedFromLines(STDIN_FILENO, prediction);
  }
  if (!text.starts_with("udp:")) {
    return std::make_unique<PathFeed>(readEyePath(text), loop);
  }
  const std::string rest = text.substr(4);
  const size_t colon = rest.rfind(':');
  const std::string number = colon == std::string::npos ? rest : rest.substr(colon + 1);
  const uint16_t port = numberFromText<uint16_t>(number).value_or(0);
  if (port == 0) {
    throw InputError("this is no port: " + number, "--eyes " + text, "--eyes udp:5005");
  }
  return std::make_unique<DatagramFeed>(colon == std::string::npos ? "127.0.0.1" : rest.substr(0, colon), port,
                                        "--eyes " + text, prediction);
}

}  // namespace ocelli
