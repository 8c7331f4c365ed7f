#include "tests/display_driver_devices/acted_display.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <thread>

namespace ocelli::test {

std::string uniqueObject() {
  static std::atomic<int> count = 0;
  return "/ocelli_test_" + std::to_string(getpid()) + "_" + std::to_string(++count);
}

ActedDisplay::ActedDisplay(std::string object, const VoxelGrid& grid, int bitsPerChannel)
    : object_(std::move(object)), grid_(grid), bitsPerChannel_(bitsPerChannel) {
  open();
}

ActedDisplay::~ActedDisplay() {
  close();
  shm_unlink(object_.c_str());
}

void ActedDisplay::open() {
  descriptor_ = shm_open(object_.c_str(), O_CREAT | O_RDWR, 0600);
  EXPECT_GE(descriptor_, 0);
  resize(multivoxBytes(grid_));
  void* const mapped = mmap(nullptr, multivoxBytes(grid_), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
  ASSERT_NE(mapped, MAP_FAILED);
  memory_ = static_cast<uint8_t*>(mapped);
  setTelemetry(bitsPerChannel_, 0, 0);
}

void ActedDisplay::close() {
  munmap(memory_, multivoxBytes(grid_));
  ::close(descriptor_);
}

void ActedDisplay::restart() {
  close();
  shm_unlink(object_.c_str());
  open();
}

void ActedDisplay::resize(size_t bytes) {
  EXPECT_EQ(ftruncate(descriptor_, static_cast<off_t>(bytes)), 0);
}

uint8_t* ActedDisplay::footer() const {
  return memory_ + 2 * grid_.cells();
}

int ActedDisplay::shownPage() const {
  return std::atomic_ref(*footer()).load();
}

void ActedDisplay::setShownPage(uint8_t page) {
  std::atomic_ref(*footer()).store(page);
}

const uint8_t* ActedDisplay::page(int number) const {
  return memory_ + (number != 0 ? grid_.cells() : 0);
}

std::vector<uint8_t> ActedDisplay::shown(size_t parts, std::chrono::microseconds pause) const {
  const uint8_t* const from = page(shownPage());
  const size_t bytes = grid_.cells() / parts;
  std::vector<uint8_t> cells;
  cells.reserve(grid_.cells());
  for (size_t part = 0; part < parts; ++part) {
    cells.insert(cells.end(), from + part * bytes, from + (part + 1) * bytes);
    std::this_thread::sleep_for(pause);
  }
  return cells;
}

void ActedDisplay::setTelemetry(int bitsPerChannel, int revolutionsPerMinute, int microsecondsPerFrame) {
  footer()[1] = static_cast<uint8_t>(bitsPerChannel);
  const uint16_t numbers[2] = {static_cast<uint16_t>(revolutionsPerMinute),
                               static_cast<uint16_t>(microsecondsPerFrame)};
  std::memcpy(footer() + 4, numbers, sizeof numbers);
}

std::optional<uint8_t> onlyNumber(const std::vector<uint8_t>& cells) {
  return std::ranges::count(cells, cells.front()) == std::ssize(cells) ? std::optional(cells.front()) : std::nullopt;
}

}  // namespace ocelli::test
