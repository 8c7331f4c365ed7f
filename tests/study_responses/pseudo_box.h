// The other end of a serial line: a pseudo-terminal whose slave a device opens.
#pragma once

#include <gtest/gtest.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "study/responses/response_device.h"

namespace ocelli::test {

inline constexpr int64_t kMillisecond = 1'000'000;

class PseudoBox {
 public:
  PseudoBox() {
    std::array<char, 256> name{};
    EXPECT_EQ(openpty(&master_, &slave_, name.data(), nullptr, nullptr), 0);
    device_ = name.data();
  }
  ~PseudoBox() { unplug(); }
  PseudoBox(const PseudoBox&) = delete;
  PseudoBox& operator=(const PseudoBox&) = delete;

  const std::string& device() const { return device_; }
  int master() const { return master_; }
  void send(const std::string& bytes) const {
    EXPECT_EQ(write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  void unplug() {
    for (int* end : {&slave_, &master_}) {
      if (*end >= 0) {
        close(std::exchange(*end, -1));
      }
    }
  }

 private:
  int master_ = -1;
  int slave_ = -1;
  std::string device_;
};

/// What comes until there are so many, or two seconds are over.
inline std::vector<KeyChange> awaitChanges(ResponseDevice& device, size_t count) {
  std::vector<KeyChange> all;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  while (all.size() < count && std::chrono::steady_clock::now() < end) {
    for (const KeyChange& change : device.take()) {
      all.push_back(change);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return all;
}

inline std::string textOf(const std::vector<KeyChange>& changes) {
  std::string text;
  for (const KeyChange& change : changes) {
    text += (text.empty() ? "" : " ") + std::string(change.pressed ? "+" : "-") + std::string(nameOf(change.key));
  }
  return text;
}

}  // namespace ocelli::test
