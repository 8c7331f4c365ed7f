// A response box on a serial line: each byte that it sends is a key. A thread of its own waits for bytes and gives each
// the time when it came.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/serial_port.h"
#include "oc_core/base/steady_time.h"
#include "study/responses/key_map.h"
#include "study/responses/response_device.h"

namespace ocelli {
namespace {

constexpr int kLookMilliseconds = 50;  ///< after which the thread sees that it shall end

/// What a byte does: nothing, or a key.
struct ByteMeaning {
  std::optional<Key> key{};
  bool releases = false;
};
using ByteMap = std::array<ByteMeaning, 256>;

std::optional<uint8_t> byteFromText(const std::string& text) {
  if (text.size() == 1) {
    return static_cast<uint8_t>(text.front());
  }
  unsigned value = 0;
  const char* const end = text.data() + text.size();
  const auto read = text.starts_with("0x") ? std::from_chars(text.data() + 2, end, value, 16)
                                           : std::from_chars_result{text.data(), std::errc::invalid_argument};
  return read.ec == std::errc() && read.ptr == end && value < 256 ? std::optional(static_cast<uint8_t>(value))
                                                                  : std::nullopt;
}

/// Without a map: the digits and letters of ASCII are the keys of that name, and a line feed or carriage return Enter.
ByteMap usualMap() {
  ByteMap map;
  for (int byte = 0; byte < 256; ++byte) {
    const char c = static_cast<char>(byte >= 'a' && byte <= 'z' ? byte - 'a' + 'A' : byte);
    map[static_cast<size_t>(byte)].key = keyFromName(std::string_view(&c, 1));
  }
  map['\n'].key = map['\r'].key = Key::kEnter;
  map[' '].key = Key::kSpace;
  return map;
}

ByteMap byteMapFromText(std::string_view text, const std::string& where) {
  if (text.empty()) {
    return usualMap();
  }
  ByteMap map;
  for (const KeyMapEntry& entry : keyMapFromText(text, where)) {
    const std::optional<uint8_t> byte = byteFromText(entry.from);
    if (!byte) {
      throw InputError("\"" + entry.from + "\" is no byte", where, "a character of ASCII, or its number such as 0x41");
    }
    map[*byte] = {entry.key, entry.releases};
  }
  return map;
}

class SerialResponses : public ResponseDevice {
 public:
  SerialResponses(const SerialPlace& place, const ByteMap& map, const std::string& where)
      : place_(place), map_(map), port_(place, where) {
    for (const ByteMeaning& meaning : map_) {
      if (meaning.releases) {
        released_.insert(*meaning.key);
      }
    }
    thread_ = std::thread([this] { run(); });
  }
  ~SerialResponses() override {
    ends_ = true;
    thread_.join();
  }
  SerialResponses(const SerialResponses&) = delete;
  SerialResponses& operator=(const SerialResponses&) = delete;

  std::vector<KeyChange> take() override {
    const std::scoped_lock lock(mutex_);
    return std::exchange(changes_, {});
  }
  bool send(uint8_t byte) override { return port_.send(byte); }
  bool isConnected() const override { return connected_; }
  ResponseCounts counts() const override {
    const std::scoped_lock lock(mutex_);
    return counts_;
  }
  std::string description() const override {
    return fmt::format("serial:{}, {} bits a second, {}", place_.device, place_.bitsPerSecond,
                       port_.hasLowLatency() ? "low latency" : "latency of the driver as it is");
  }

 private:
  void run() {
    std::array<uint8_t, 64> bytes{};
    while (!ends_ && connected_) {
      pollfd watched{port_.descriptor(), POLLIN, 0};
      if (::poll(&watched, 1, kLookMilliseconds) <= 0) {
        continue;
      }
      const int64_t now = steadyNanoseconds();
      const ssize_t count = read(port_.descriptor(), bytes.data(), bytes.size());
      if (count > 0) {
        const std::scoped_lock lock(mutex_);
        std::for_each(bytes.begin(), bytes.begin() + count, [&](uint8_t byte) { add(byte, now); });
      } else if (count == 0 || (errno != EAGAIN && errno != EINTR)) {
        disconnect(now);
      }
    }
  }

  /// With the lock.
  void add(uint8_t byte, int64_t now) {
    const ByteMeaning& meaning = map_[byte];
    if (!meaning.key) {
      ++counts_.unknown;
      return;
    }
    if (meaning.releases) {
      held_.erase(*meaning.key);
      changes_.push_back({*meaning.key, false, now});
      return;
    }
    ++counts_.presses;
    changes_.push_back({*meaning.key, true, now});
    if (released_.contains(*meaning.key)) {
      held_.insert(*meaning.key);
    } else {
      changes_.push_back({*meaning.key, false, now});  // it tells of presses alone
    }
  }

  void disconnect(int64_t now) {
    const std::scoped_lock lock(mutex_);
    for (const Key key : held_) {
      changes_.push_back({key, false, now});
    }
    held_.clear();
    connected_ = false;
  }

  SerialPlace place_;
  ByteMap map_;
  SerialPort port_;
  std::set<Key> released_{};  ///< keys whose release the device tells of
  std::atomic<bool> ends_{false};
  std::atomic<bool> connected_{true};
  mutable std::mutex mutex_;
  std::vector<KeyChange> changes_{};  ///< guarded, as all below
  std::set<Key> held_{};
  ResponseCounts counts_{};
  std::thread thread_;  ///< the last, as it uses the others
};

std::unique_ptr<ResponseDevice> openSerial(const std::string& text, const ResponseTools& /*tools*/) {
  const std::string where = "--responses serial:" + text;
  // The map begins after the comma before the first "=".
  const size_t comma = text.rfind(',', text.find('='));
  const bool hasMap = text.find('=') != std::string::npos && comma != std::string::npos;
  const std::string place = hasMap ? text.substr(0, comma) : text;
  return std::make_unique<SerialResponses>(serialPlaceFromText(place, where),
                                           byteMapFromText(hasMap ? text.substr(comma + 1) : "", where), where);
}

}  // namespace

ResponseDeviceKind serialResponses() {
  return {
      "serial", "serial:DEVICE[,BAUD][,BYTE=KEY...]",
      "a box on a serial line: each byte that it sends is a key, \"-KEY\" that it is released. 115200 bits a second "
      "where no rate is given; without a map digits and letters are the keys of that name",
      openSerial};
}

}  // namespace ocelli
