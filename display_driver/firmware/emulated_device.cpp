#include "display_driver/firmware/emulated_device.h"

#include <algorithm>
#include <limits>

namespace ocelli {
namespace {

/// How far a link of a given rate may run ahead of it: what a transport that looks every millisecond needs.
constexpr double kBurstSeconds = 0.002;
/// Bits are flipped within this many bytes after the byte where they are due.
constexpr size_t kFlipBytes = 4096;
constexpr size_t kFrameSearchBytes = 512;

}  // namespace

EmulatedDevice::EmulatedDevice(EmulatedDeviceOptions options)
    : firmware_(options.firmware),
      bytesPerSecond_(options.bytesPerSecond),
      random_(options.firmware.rotor.seed ^ 0x6f63656c6c69u) {
  for (const Fault& fault : options.faults.faults) {
    pending_.push_back({fault, std::nullopt});
  }
}

std::optional<std::vector<uint8_t>> EmulatedDevice::controlIn(uint8_t request, uint16_t value, size_t most,
                                                              DeviceMicroseconds now) {
  advance(now);
  return isActive(FaultKind::kDeafControl) ? std::nullopt : firmware_.controlIn(request, value, most, now);
}

bool EmulatedDevice::controlOut(uint8_t request, uint16_t value, std::span<const uint8_t> bytes,
                                DeviceMicroseconds now) {
  advance(now);
  return !isActive(FaultKind::kDeafControl) && firmware_.controlOut(request, value, bytes, now);
}

bool EmulatedDevice::isActive(FaultKind kind) const {
  return std::ranges::any_of(active_, [&](const ActiveFault& active) { return active.fault.kind == kind; });
}

double EmulatedDevice::rate() const {
  double rate = bytesPerSecond_;
  for (const ActiveFault& active : active_) {
    if (active.fault.kind == FaultKind::kSlowLink && (rate == 0 || active.fault.amount < rate)) {
      rate = active.fault.amount;
    }
  }
  return rate;
}

void EmulatedDevice::fillBudget(DeviceMicroseconds now) {
  const double most = std::max(rate() * kBurstSeconds, 512.0);
  budget_ = std::min(budget_ + rate() * static_cast<double>(now - budgetTime_) * 1e-6, most);
  budgetTime_ = now;
}

/// Such faults hit a certain byte of the stream; others begin when their time has come.
bool EmulatedDevice::beginsAfterBytes(const PendingFault& pending) const {
  return pending.fault.afterFrames > 0 || pending.fault.afterBytes > 0;
}

bool EmulatedDevice::isDue(const PendingFault& pending, DeviceMicroseconds now) const {
  return now >= pending.fault.at &&
         (!beginsAfterBytes(pending) ||
          (pending.bytesFrom && bytesTaken_ >= *pending.bytesFrom + pending.fault.afterBytes));
}

void EmulatedDevice::begin(const Fault& fault, DeviceMicroseconds now) {
  happened_.push_back({fault, now, now});
  switch (fault.kind) {
    case FaultKind::kStall:
      halted_ = true;
      return;
    case FaultKind::kShortWrite:
      shortNext_ = true;
      return;
    case FaultKind::kWrongSequence:
      firmware_.skipSequence();
      return;
    case FaultKind::kBitFlips:
      bitsToFlip_ += static_cast<size_t>(fault.amount);
      return;
    case FaultKind::kUnplug:
      pluggedIn_ = false;
      halted_ = false;
      break;
    case FaultKind::kPhaseDrift:
      firmware_.rotor().setRate(fault.amount);
      break;
    case FaultKind::kSlowLink:
    case FaultKind::kFullBuffers:
    case FaultKind::kDeafControl:
      break;
  }
  active_.push_back({fault, happened_.size() - 1, now + fault.duration});
}

void EmulatedDevice::end(const Fault& fault, DeviceMicroseconds now) {
  if (fault.kind == FaultKind::kUnplug && !isActive(FaultKind::kUnplug)) {
    firmware_.restart(now);
    pluggedIn_ = true;
  } else if (fault.kind == FaultKind::kPhaseDrift && !isActive(FaultKind::kPhaseDrift)) {
    firmware_.rotor().setRate(1);
  }
}

void EmulatedDevice::advance(DeviceMicroseconds now) {
  firmware_.advance(now);
  for (size_t i = 0; i < active_.size();) {
    if (now < active_[i].end) {
      ++i;
      continue;
    }
    const ActiveFault over = active_[i];
    happened_[over.happened].end = now;
    active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(i));
    end(over.fault, now);
  }
  for (size_t i = 0; i < pending_.size();) {
    PendingFault& pending = pending_[i];
    if (beginsAfterBytes(pending) && !pending.bytesFrom && now >= pending.fault.at &&
        firmware_.framesBegun() >= pending.fault.afterFrames) {
      pending.bytesFrom = bytesTaken_;
    }
    if (!isDue(pending, now)) {
      ++i;
      continue;
    }
    const Fault fault = pending.fault;
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
    begin(fault, now);
  }
}

/// Of the stream: so many may be taken at once without passing by where a fault begins.
size_t EmulatedDevice::bytesToNextFault(DeviceMicroseconds now) const {
  size_t most = std::numeric_limits<size_t>::max();
  for (const PendingFault& pending : pending_) {
    if (pending.bytesFrom) {
      most = std::min<size_t>(most, *pending.bytesFrom + pending.fault.afterBytes - bytesTaken_);
    } else if (beginsAfterBytes(pending) && now >= pending.fault.at) {
      most = std::min(most, kFrameSearchBytes);  // its frame may begin anywhere
    }
  }
  return most;
}

EmulatedDevice::Taken EmulatedDevice::takeBulk(std::span<const uint8_t> rest, DeviceMicroseconds now) {
  advance(now);
  Taken taken;
  while (taken.bytes < rest.size() && pluggedIn_ && !halted_ && !isActive(FaultKind::kFullBuffers)) {
    if (shortNext_) {
      shortNext_ = false;
      taken.outcome = Outcome::kShort;
      return taken;
    }
    size_t most = rest.size() - taken.bytes;
    if (rate() > 0) {
      fillBudget(now);
      most = std::min(most, static_cast<size_t>(budget_));
    }
    most = std::min(most, bytesToNextFault(now));
    std::span<const uint8_t> some = rest.subspan(taken.bytes, most);
    std::vector<uint8_t> flipped;
    if (bitsToFlip_ > 0 && !some.empty()) {
      flipped.assign(some.begin(), some.end());
      for (; bitsToFlip_ > 0; --bitsToFlip_) {
        const size_t bit = random_.below(8 * std::min(flipped.size(), kFlipBytes));
        flipped[bit / 8] = static_cast<uint8_t>(flipped[bit / 8] ^ (1u << (bit % 8)));
      }
      some = flipped;
    }
    const size_t count = firmware_.receive(some, now);
    taken.bytes += count;
    bytesTaken_ += count;
    if (rate() > 0) {
      budget_ -= static_cast<double>(count);
    }
    advance(now);
    if (count == 0) {
      break;
    }
  }
  if (halted_) {
    taken.outcome = Outcome::kStall;
  }
  return taken;
}

std::vector<uint8_t> EmulatedDevice::takeEvents(size_t most, DeviceMicroseconds now) {
  advance(now);
  return pluggedIn_ ? firmware_.takeEvents(most) : std::vector<uint8_t>();
}

DeviceMicroseconds EmulatedDevice::nextChange(DeviceMicroseconds now) const {
  DeviceMicroseconds next = firmware_.nextChange();
  for (const ActiveFault& active : active_) {
    next = std::min(next, active.end);
  }
  for (const PendingFault& pending : pending_) {
    if (!beginsAfterBytes(pending)) {
      next = std::min(next, pending.fault.at);
    }
  }
  return std::max(next, now + 1);
}

}  // namespace ocelli
