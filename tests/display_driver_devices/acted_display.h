// Plays the driver of a multivox display, or its simulator: makes the shared memory, maps it, reads what is shown.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/devices/multivox_memory.h"

namespace ocelli::test {

/// A name for shared memory that no other test uses.
std::string uniqueObject();

class ActedDisplay {
 public:
  /// Makes the object where there is none, as drivers do, and sets the bits shown of each channel.
  explicit ActedDisplay(std::string object, const VoxelGrid& grid = {}, int bitsPerChannel = 2);
  /// Takes the object's name away too.
  ~ActedDisplay();
  ActedDisplay(const ActedDisplay&) = delete;
  ActedDisplay& operator=(const ActedDisplay&) = delete;

  /// Ends and starts again, with an object of its own.
  void restart();
  /// As a driver for a display of another size would. What is mapped beyond the size must not be read.
  void resize(size_t bytes);

  int shownPage() const;
  const uint8_t* page(int number) const;
  /// Takes the number of the page that is shown, then copies that page, as readers do; in so many equal parts, with a
  /// pause after each.
  std::vector<uint8_t> shown(size_t parts = 1, std::chrono::microseconds pause = {}) const;
  void setShownPage(uint8_t page);
  void setTelemetry(int bitsPerChannel, int revolutionsPerMinute, int microsecondsPerFrame);

  const std::string& object() const { return object_; }
  const VoxelGrid& grid() const { return grid_; }

 private:
  void open();
  void close();
  uint8_t* footer() const;

  std::string object_;
  VoxelGrid grid_;
  int bitsPerChannel_;
  int descriptor_ = -1;
  uint8_t* memory_ = nullptr;
};

/// The one number that all these cells have; nullopt where they differ.
std::optional<uint8_t> onlyNumber(const std::vector<uint8_t>& cells);

}  // namespace ocelli::test
