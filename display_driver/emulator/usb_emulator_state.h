// The inside of UsbEmulator: what its clients have submitted, and the displays. For the files usb_emulator*.cpp, the
// only ones that include umockdev: usb_emulator_ioctl.cpp answers clients, usb_emulator_device.cpp turns the displays
// on.
//
// Threads: umockdev's worker calls handle() for each ioctl() of a client; our own thread brings submitted transfers to
// the device, moves time on, plugs and unplugs. A lock each: State::mutex for what clients have submitted, and
// Display::deviceMutex for the device. Neither is held where the other is taken.
//
// A client of libusb asks again and again whether a transfer is done (the emulated device file is always ready for it).
// An answer of "not yet" is held back for kEmptyReap, or until there is something: without that, the client would take
// a whole core; with more, its submissions would wait, since a file's ioctl() calls come one at a time.
#pragma once

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "display_driver/emulator/test_bed_folder.h"
#include "display_driver/emulator/usb_emulator.h"
#include "oc_core/base/check.h"

namespace ocelli {

/// A transfer that a client has submitted.
struct EmulatedTransfer {
  uint64_t address = 0;  ///< of its usbdevfs_urb in the client
  uint8_t type = 0;
  uint8_t endpoint = 0;
  size_t length = 0;
  std::vector<uint8_t> bytes;  ///< that go to the device, or have come from it
  size_t actual = 0;
  int status = 0;
  bool inWork = false;            ///< the device has it just now
  std::optional<int> ended = {};  ///< the host has ended it with this status while the device had it

  bool toHost() const { return (endpoint & 0x80) != 0; }
};
using TransferPointer = std::shared_ptr<EmulatedTransfer>;

/// An open device file of a client.
struct EmulatedConnection {
  explicit EmulatedConnection(size_t to) : display(to) {}

  const size_t display;
  bool gone = false;  ///< the device has been unplugged since
  bool claimed = false;
  std::deque<TransferPointer> submitted;
  std::deque<TransferPointer> done;
  std::optional<std::chrono::steady_clock::time_point> reapUntil;  ///< the client waits in REAPURB
};

struct PluggedDisplay {
  PluggedDisplay(const EmulatedUsbDisplay& options, int atPort)
      : device(options.device), speed(options.speed), most(options.maxBytesUnderWay), port(atPort) {}

  std::mutex deviceMutex;
  EmulatedDevice device;
  const EmulatedSpeed speed;
  const size_t most;
  const int port;
  // Under State::mutex.
  bool plugged = false;
  bool pulled = false;  ///< by hand
  bool occupied = false;
  bool clearHalt = false;
  bool eventsHalted = false;
  bool reset = false;
  int number = 0;
};

struct UsbEmulator::State {
  using Clock = std::chrono::steady_clock;

  explicit State(std::vector<EmulatedUsbDisplay> options);
  ~State();

  // On umockdev's thread.
  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  static void onVanished(gpointer self, GObject* client);
  void handle(UMockdevIoctlClient* client);
  int answer(UMockdevIoctlClient* client, EmulatedConnection& connection, unsigned long request);
  int submit(UMockdevIoctlClient* client, EmulatedConnection& connection);
  int discard(UMockdevIoctlClient* client, EmulatedConnection& connection);
  int clearHalt(UMockdevIoctlClient* client, PluggedDisplay& display);
  int claim(EmulatedConnection& connection);
  EmulatedConnection* connectionOf(UMockdevIoctlClient* client);

  // On our own.
  void run();
  bool turn(size_t index);
  bool work(size_t index);
  void plug(size_t index);
  void unplug(size_t index);
  std::chrono::microseconds untilNextChange();

  // With the mutex held.
  void finish(EmulatedConnection& connection, const TransferPointer& transfer, int status);
  void end(EmulatedConnection& connection, const TransferPointer& transfer, int status);
  void shutDown(EmulatedConnection& connection);
  void reap(UMockdevIoctlClient* client, EmulatedConnection& connection);
  static bool handBack(UMockdevIoctlClient* client, EmulatedTransfer& transfer);
  void endReaps();

  DeviceMicroseconds now() const {
    return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - start).count();
  }

  const Clock::time_point start = Clock::now();
  UMockdevTestbed* bed = nullptr;
  UMockdevIoctlBase* handler = nullptr;
  TestBedFolder folder;  ///< goes after the bed, which lies in it
  std::vector<std::unique_ptr<PluggedDisplay>> displays;
  int lastNumber = 0;  ///< of a device; 1 is the root hub's

  std::mutex mutex;
  std::condition_variable changed;
  bool news = false;
  bool stop = false;
  std::map<UMockdevIoctlClient*, EmulatedConnection> connections;
  std::set<UMockdevIoctlClient*> strangers;    ///< they have opened a device file whose device had just gone
  std::vector<UMockdevIoctlClient*> answered;  ///< no longer in a request; our references to them are to be dropped
  std::thread thread;
};

}  // namespace ocelli
