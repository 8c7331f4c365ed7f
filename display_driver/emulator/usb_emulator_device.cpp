// The thread that brings submitted transfers to the displays, moves time on, plugs and unplugs.
#include <algorithm>
#include <cstring>

#include "display_driver/emulator/usb_emulator_state.h"
#include "display_driver/emulator/usb_function.h"

namespace ocelli {
namespace {

using std::chrono::microseconds;

constexpr microseconds kShortestSleep{50};
constexpr microseconds kLongestSleep{1000};
constexpr int kFirstDeviceNumber = 2;  // 1 is the root hub
constexpr int kLastDeviceNumber = 127;

/// Of the transfers that a client has submitted, those that come next.
struct Turn {
  EmulatedConnection* connection;
  UMockdevIoctlClient* client;
  TransferPointer transfer;
  std::optional<int> status;  ///< it ends with
  size_t actual = 0;
  std::vector<uint8_t> bytes;
};

/// As a host's controller does: full packets do not end a transfer that has room for more.
void receiveEvents(EmulatedDevice& device, size_t packet, DeviceMicroseconds now, Turn& turn) {
  const EmulatedTransfer& transfer = *turn.transfer;
  turn.bytes = transfer.bytes;
  const std::vector<uint8_t> events = device.takeEvents(transfer.length - turn.actual, now);
  turn.bytes.insert(turn.bytes.end(), events.begin(), events.end());
  turn.actual = turn.bytes.size();
  if (turn.actual == transfer.length || events.size() % packet != 0) {
    turn.status = 0;
  }
}

}  // namespace

bool UsbEmulator::State::work(size_t index) {
  PluggedDisplay& display = *displays[index];
  std::vector<Turn> turns;
  bool clearHalt = false;
  bool reset = false;
  bool eventsHalted = false;
  {
    const std::scoped_lock lock(mutex);
    eventsHalted = display.eventsHalted;
    clearHalt = std::exchange(display.clearHalt, false);
    reset = std::exchange(display.reset, false);
    for (auto& [client, connection] : connections) {
      bool out = false;
      bool in = false;
      for (const TransferPointer& transfer : connection.submitted) {
        if (connection.display != index || connection.gone) {
          break;
        }
        const bool bulk = transfer->type == USBDEVFS_URB_TYPE_BULK;
        if (bulk && std::exchange(transfer->toHost() ? in : out, true)) {
          continue;
        }
        transfer->inWork = true;
        turns.push_back({&connection, client, transfer, std::nullopt, transfer->actual, {}});
      }
    }
  }
  {
    const std::scoped_lock lock(display.deviceMutex);
    EmulatedDevice& device = display.device;
    if (reset) {
      device.firmware().restart(now());
    }
    if (clearHalt || reset) {
      device.clearHalt();
    }
    device.advance(now());
    for (Turn& turn : turns) {
      const EmulatedTransfer& transfer = *turn.transfer;
      if (transfer.type == USBDEVFS_URB_TYPE_CONTROL) {
        ControlAnswer answer = answerControl(device, transfer.bytes, now());
        turn.status = answer.stalled ? -EPIPE : 0;
        turn.actual = transfer.bytes.empty() || (transfer.bytes[0] & 0x80) == 0 ? answer.taken : answer.bytes.size();
        turn.bytes = std::move(answer.bytes);
      } else if (transfer.toHost() && eventsHalted) {
        turn.status = -EPIPE;
      } else if (transfer.toHost()) {
        receiveEvents(device, bulkPacketBytes(display.speed), now(), turn);
      } else if (device.halted()) {
        turn.status = -EPIPE;
      } else {
        const auto taken = device.takeBulk(std::span(transfer.bytes).subspan(turn.actual), now());
        turn.actual += taken.bytes;
        if (taken.outcome == EmulatedDevice::Outcome::kStall) {
          turn.status = -EPIPE;
        } else if (taken.outcome == EmulatedDevice::Outcome::kShort || turn.actual == transfer.length) {
          turn.status = 0;
        }
      }
    }
  }
  bool moved = false;
  const std::scoped_lock lock(mutex);
  for (Turn& turn : turns) {
    turn.transfer->inWork = false;
    turn.transfer->actual = turn.actual;
    if (turn.status && turn.transfer->type == USBDEVFS_URB_TYPE_CONTROL) {
      turn.transfer->endpoint = (turn.transfer->bytes[0] & 0x80) != 0 ? 0x80 : 0;
    }
    if (turn.transfer->toHost()) {
      turn.transfer->bytes = std::move(turn.bytes);
    }
    const auto connection = connections.find(turn.client);
    const std::optional<int> status = turn.status ? turn.status : turn.transfer->ended;
    if (connection == connections.end() || !status) {
      continue;
    }
    finish(connection->second, turn.transfer, *status);
    if (connection->second.reapUntil) {
      reap(turn.client, connection->second);
    }
    moved = true;
  }
  return moved;
}

void UsbEmulator::State::plug(size_t index) {
  PluggedDisplay& display = *displays[index];
  lastNumber = lastNumber >= kLastDeviceNumber ? kFirstDeviceNumber : std::max(lastNumber + 1, kFirstDeviceNumber);
  UsbDeviceRecord record;
  record.port = display.port;
  record.number = lastNumber;
  record.speed = display.speed;
  {
    const std::scoped_lock lock(display.deviceMutex);
    record.product = display.device.firmware().options().name;
    record.serial = display.device.firmware().options().serial;
  }
  {
    const std::scoped_lock lock(mutex);
    display.number = lastNumber;
    display.plugged = true;
  }
  // In this order: clients may open the device as soon as they hear of it.
  GError* error = nullptr;
  OC_CHECK(umockdev_testbed_attach_ioctl(bed, deviceFile(record.number).c_str(), handler, &error), "umockdev");
  OC_CHECK(umockdev_testbed_add_from_string(bed, recordOf(record).c_str(), &error), "umockdev takes our record");
}

void UsbEmulator::State::unplug(size_t index) {
  PluggedDisplay& display = *displays[index];
  {
    const std::scoped_lock lock(mutex);
    display.plugged = false;
    for (auto& [client, connection] : connections) {
      if (connection.display == index) {
        shutDown(connection);
      }
    }
    endReaps();
  }
  const std::string path = "/sys" + devicePath(display.port);
  umockdev_testbed_uevent(bed, path.c_str(), "remove");
  umockdev_testbed_remove_device(bed, path.c_str());
  umockdev_testbed_detach_ioctl(bed, deviceFile(display.number).c_str(), nullptr);
}

bool UsbEmulator::State::turn(size_t index) {
  PluggedDisplay& display = *displays[index];
  bool wanted = false;
  {
    const std::scoped_lock lock(display.deviceMutex);
    display.device.advance(now());
    wanted = display.device.pluggedIn();
  }
  bool plugged = false;
  {
    const std::scoped_lock lock(mutex);
    wanted = wanted && !display.pulled;
    plugged = display.plugged;
  }
  if (wanted != plugged) {
    wanted ? plug(index) : unplug(index);
    return true;
  }
  return plugged && work(index);
}

microseconds UsbEmulator::State::untilNextChange() {
  microseconds least = kLongestSleep;
  for (const auto& display : displays) {
    const std::scoped_lock lock(display->deviceMutex);
    const DeviceMicroseconds time = now();
    least = std::min(least, microseconds(display->device.nextChange(time) - time));
  }
  return std::max(least, kShortestSleep);
}

void UsbEmulator::State::run() {
  for (;;) {
    bool moved = false;
    for (size_t i = 0; i < displays.size(); ++i) {
      moved = turn(i) || moved;
    }
    const microseconds sleep = untilNextChange();
    std::unique_lock lock(mutex);
    endReaps();
    if (!moved) {
      Clock::time_point until = Clock::now() + sleep;
      for (const auto& [client, connection] : connections) {
        until = connection.reapUntil ? std::min(until, *connection.reapUntil) : until;
      }
      changed.wait_until(lock, until, [&] { return news || stop; });
    }
    news = false;
    const bool end = stop;
    const std::vector<UMockdevIoctlClient*> left = std::exchange(answered, {});
    lock.unlock();
    for (UMockdevIoctlClient* const client : left) {
      g_object_unref(client);  // may be the last one, and lead to onVanished()
    }
    if (end) {
      return;
    }
  }
}

}  // namespace ocelli
