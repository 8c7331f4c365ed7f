// The only file that includes umockdev.
//
// Threads: umockdev's worker calls handle() for each ioctl() of a client; our own thread brings submitted transfers to
// the device, moves time on, plugs and unplugs. A lock each: State::mutex for what clients have submitted, and
// Display::deviceMutex for the device. Neither is held where the other is taken.
//
// A client of libusb asks again and again whether a transfer is done (the emulated device file is always ready for it).
// An answer of "not yet" is held back for kEmptyReap, or until there is something: without that, the client would take
// a whole core; with more, its submissions would wait, since a file's ioctl() calls come one at a time.
#include "display_driver/emulator/usb_emulator.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <umockdev.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "display_driver/emulator/test_bed_folder.h"
#include "display_driver/emulator/usb_function.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"

namespace ocelli {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::microseconds;

constexpr microseconds kEmptyReap{500};
constexpr microseconds kShortestSleep{50};
constexpr microseconds kLongestSleep{1000};
constexpr const char* kPreloadLibrary = "libumockdev-preload.so.0";
constexpr const char* kPreloadHint = "install it (Debian: apt-get install umockdev)";
constexpr std::chrono::milliseconds kEndOfListening{30};
constexpr std::chrono::milliseconds kLastWords{500};
constexpr int kFirstDeviceNumber = 2;  // 1 is the root hub
constexpr int kLastDeviceNumber = 127;

/// A transfer that a client has submitted.
struct Transfer {
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
using TransferPointer = std::shared_ptr<Transfer>;

/// An open device file of a client.
struct Connection {
  explicit Connection(size_t to) : display(to) {}

  const size_t display;
  bool gone = false;  ///< the device has been unplugged since
  bool claimed = false;
  std::deque<TransferPointer> submitted;
  std::deque<TransferPointer> done;
  std::optional<Clock::time_point> reapUntil;  ///< the client waits in REAPURB
};

struct Display {
  Display(const EmulatedUsbDisplay& options, int atPort)
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

template <class Field>
void write(UMockdevIoctlData* data, size_t offset, const Field& field) {
  std::array<guint8, sizeof(Field)> bytes;
  std::memcpy(bytes.data(), &field, sizeof(Field));
  umockdev_ioctl_data_update(data, offset, bytes.data(), static_cast<gint>(bytes.size()));
}

/// umockdev's library, and those that the user has preloaded.
std::string preloadList() {
  const char* const others = std::getenv("LD_PRELOAD");
  const std::string list = others == nullptr ? "" : others;
  if (list.find(kPreloadLibrary) != std::string::npos) {
    return list;
  }
  return list.empty() ? kPreloadLibrary : fmt::format("{}:{}", kPreloadLibrary, list);
}

UMockdevTestbed* newTestBed(const std::filesystem::path& folder) {
  constexpr const char* kVariable = "TMPDIR";
  const char* const set = std::getenv(kVariable);
  const std::optional<std::string> before = set == nullptr ? std::nullopt : std::optional<std::string>(set);
  setenv(kVariable, folder.c_str(), 1);
  g_get_tmp_dir();  // GLib keeps it
  before ? setenv(kVariable, before->c_str(), 1) : unsetenv(kVariable);
  return umockdev_testbed_new();
}

/// Memory of a client; nullptr where it is not there.
using Memory = std::unique_ptr<UMockdevIoctlData, decltype(&umockdev_ioctl_data_unref)>;
Memory resolve(UMockdevIoctlData* pointer, size_t offset, size_t bytes) {
  GError* error = nullptr;
  UMockdevIoctlData* const data = umockdev_ioctl_data_resolve(pointer, offset, bytes, &error);
  g_clear_error(&error);
  return Memory(data, umockdev_ioctl_data_unref);
}

}  // namespace

struct UsbEmulator::State {
  explicit State(std::vector<EmulatedUsbDisplay> options);
  ~State();

  // On umockdev's thread.
  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  static void onVanished(gpointer self, GObject* client);
  void handle(UMockdevIoctlClient* client);
  int answer(UMockdevIoctlClient* client, Connection& connection, unsigned long request);
  int submit(UMockdevIoctlClient* client, Connection& connection);
  int discard(UMockdevIoctlClient* client, Connection& connection);
  int clearHalt(UMockdevIoctlClient* client, Display& display);
  int claim(Connection& connection);
  Connection* connectionOf(UMockdevIoctlClient* client);

  // On our own.
  void run();
  bool turn(size_t index);
  bool work(size_t index);
  void plug(size_t index);
  void unplug(size_t index);
  microseconds untilNextChange();

  // With the mutex held.
  void finish(Connection& connection, const TransferPointer& transfer, int status);
  void end(Connection& connection, const TransferPointer& transfer, int status);
  void shutDown(Connection& connection);
  void reap(UMockdevIoctlClient* client, Connection& connection);
  static bool handBack(UMockdevIoctlClient* client, Transfer& transfer);
  void endReaps();

  DeviceMicroseconds now() const { return std::chrono::duration_cast<microseconds>(Clock::now() - start).count(); }

  const Clock::time_point start = Clock::now();
  UMockdevTestbed* bed = nullptr;
  UMockdevIoctlBase* handler = nullptr;
  TestBedFolder folder;  ///< goes after the bed, which lies in it
  std::vector<std::unique_ptr<Display>> displays;
  int lastNumber = kFirstDeviceNumber - 1;

  std::mutex mutex;
  std::condition_variable changed;
  bool news = false;
  bool stop = false;
  std::map<UMockdevIoctlClient*, Connection> connections;
  std::set<UMockdevIoctlClient*> strangers;    ///< they have opened a device file whose device had just gone
  std::vector<UMockdevIoctlClient*> answered;  ///< no longer in a request; our references to them are to be dropped
  std::thread thread;
};

// --- ioctl() ---

gboolean UsbEmulator::State::onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  static_cast<State*>(self)->handle(client);
  return TRUE;
}

/// The client has closed the device file, or has ended.
void UsbEmulator::State::onVanished(gpointer self, GObject* client) {
  State& state = *static_cast<State*>(self);
  const std::scoped_lock lock(state.mutex);
  state.connections.erase(reinterpret_cast<UMockdevIoctlClient*>(client));
  state.strangers.erase(reinterpret_cast<UMockdevIoctlClient*>(client));
  state.changed.notify_all();
}

Connection* UsbEmulator::State::connectionOf(UMockdevIoctlClient* client) {
  const auto known = connections.find(client);
  if (known != connections.end()) {
    return &known->second;
  }
  const std::string file = umockdev_ioctl_client_get_devnode(client);
  for (size_t i = 0; i < displays.size(); ++i) {
    if (displays[i]->plugged && deviceFile(displays[i]->number) == file) {
      g_object_weak_ref(G_OBJECT(client), onVanished, this);
      return &connections.try_emplace(client, i).first->second;
    }
  }
  return nullptr;
}

void UsbEmulator::State::handle(UMockdevIoctlClient* client) {
  const unsigned long request = umockdev_ioctl_client_get_request(client);
  const std::scoped_lock lock(mutex);
  Connection* const connection = connectionOf(client);
  if (connection == nullptr) {
    if (strangers.insert(client).second) {
      g_object_weak_ref(G_OBJECT(client), onVanished, this);
    }
    umockdev_ioctl_client_complete(client, -1, ENODEV);
    return;
  }
  if (request == USBDEVFS_REAPURB || request == USBDEVFS_REAPURBNDELAY) {
    g_object_ref(client);  // it only keeps itself alive while it is not in a request
    connection->reapUntil = request == USBDEVFS_REAPURB ? Clock::time_point::max() : Clock::now() + kEmptyReap;
    reap(client, *connection);
    return;
  }
  const int result = answer(client, *connection, request);
  umockdev_ioctl_client_complete(client, result < 0 ? -1 : result, result < 0 ? -result : 0);
}

/// What ioctl() returns, or the negative error number.
int UsbEmulator::State::answer(UMockdevIoctlClient* client, Connection& connection, unsigned long request) {
  Display& display = *displays[connection.display];
  if (connection.gone) {
    return -ENODEV;
  }
  switch (request) {
    case USBDEVFS_GET_CAPABILITIES: {
      constexpr uint32_t kCapabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                         USBDEVFS_CAP_BULK_SCATTER_GATHER | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      const Memory memory = resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(uint32_t));
      if (!memory) {
        return -EFAULT;
      }
      write(memory.get(), 0, kCapabilities);
      return 0;
    }
    case USBDEVFS_GET_SPEED:
      return display.speed == EmulatedSpeed::kUsb3 ? 5 : 3;  // USB_SPEED_SUPER, USB_SPEED_HIGH
    case USBDEVFS_CLAIMINTERFACE:
    case USBDEVFS_DISCONNECT_CLAIM:
      return claim(connection);
    case USBDEVFS_RELEASEINTERFACE:
      connection.claimed = false;
      return 0;
    case USBDEVFS_SETCONFIGURATION:
    case USBDEVFS_SETINTERFACE:
      return 0;
    case USBDEVFS_GETDRIVER:
    case USBDEVFS_IOCTL:  // there is no driver to take the interface from, or to give it back to
      return -ENODATA;
    case USBDEVFS_SUBMITURB:
      return submit(client, connection);
    case USBDEVFS_DISCARDURB:
      return discard(client, connection);
    case USBDEVFS_CLEAR_HALT:
    case USBDEVFS_RESETEP:
      return clearHalt(client, display);
    case USBDEVFS_RESET:
      for (const TransferPointer& transfer : std::deque(connection.submitted)) {
        end(connection, transfer, -ESHUTDOWN);
      }
      display.reset = true;
      display.eventsHalted = false;
      return 0;
    default:
      return -ENOTTY;
  }
}

int UsbEmulator::State::claim(Connection& connection) {
  const bool taken = std::ranges::any_of(connections, [&](const auto& other) {
    return &other.second != &connection && other.second.display == connection.display && other.second.claimed;
  });
  if (taken || displays[connection.display]->occupied) {
    return -EBUSY;
  }
  connection.claimed = true;
  return 0;
}

int UsbEmulator::State::submit(UMockdevIoctlClient* client, Connection& connection) {
  UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
  uint64_t address = 0;
  std::memcpy(&address, argument->data, sizeof(address));
  const Memory memory = resolve(argument, 0, sizeof(usbdevfs_urb));
  usbdevfs_urb urb;
  if (!memory || memory->data_len < static_cast<gint>(sizeof(urb))) {
    return -EFAULT;
  }
  std::memcpy(&urb, memory->data, sizeof(urb));
  const bool control = urb.type == USBDEVFS_URB_TYPE_CONTROL;
  if (urb.buffer_length < 0 || (!control && urb.type != USBDEVFS_URB_TYPE_BULK)) {
    return -EINVAL;
  }
  size_t underWay = static_cast<size_t>(urb.buffer_length);
  for (const TransferPointer& other : connection.submitted) {
    underWay += other->length;
  }
  if (underWay > displays[connection.display]->most) {
    return -ENOMEM;
  }
  auto transfer = std::make_shared<Transfer>(Transfer{.address = address,
                                                      .type = urb.type,
                                                      .endpoint = urb.endpoint,
                                                      .length = static_cast<size_t>(urb.buffer_length),
                                                      .bytes = {}});
  if (control || !transfer->toHost()) {
    const Memory buffer = resolve(memory.get(), offsetof(usbdevfs_urb, buffer), transfer->length);
    if (!buffer && transfer->length > 0) {
      return -EFAULT;
    }
    if (buffer) {
      transfer->bytes.assign(buffer->data, buffer->data + buffer->data_len);
    }
  }
  connection.submitted.push_back(std::move(transfer));
  news = true;
  changed.notify_all();
  return 0;
}

int UsbEmulator::State::discard(UMockdevIoctlClient* client, Connection& connection) {
  uint64_t address = 0;
  std::memcpy(&address, umockdev_ioctl_client_get_arg(client)->data, sizeof(address));
  const auto found = std::ranges::find(connection.submitted, address, [](const auto& t) { return t->address; });
  if (found == connection.submitted.end()) {
    return -EINVAL;
  }
  end(connection, TransferPointer(*found), -ENOENT);
  return 0;
}

int UsbEmulator::State::clearHalt(UMockdevIoctlClient* client, Display& display) {
  const Memory memory = resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(uint32_t));
  if (!memory || memory->data_len < static_cast<gint>(sizeof(uint32_t))) {
    return -EFAULT;
  }
  uint32_t endpoint = 0;
  std::memcpy(&endpoint, memory->data, sizeof(endpoint));
  if (endpoint == kEmulatedInEndpoint) {
    display.eventsHalted = false;
  } else if (endpoint == kEmulatedOutEndpoint) {
    display.clearHalt = true;
  } else {
    return -ENOENT;
  }
  return 0;
}

/// At the host's wish: what the device has comes back when the device is done with it.
void UsbEmulator::State::end(Connection& connection, const TransferPointer& transfer, int status) {
  if (transfer->inWork) {
    transfer->ended = status;
  } else {
    finish(connection, transfer, status);
  }
}

void UsbEmulator::State::finish(Connection& connection, const TransferPointer& transfer, int status) {
  std::erase(connection.submitted, transfer);
  transfer->status = status;
  connection.done.push_back(transfer);
}

/// MotorModel a transfer back to a client that asks for one. Where there is none, the client waits for a while.
void UsbEmulator::State::reap(UMockdevIoctlClient* client, Connection& connection) {
  int error = 0;
  if (!connection.done.empty()) {
    const TransferPointer transfer = connection.done.front();
    connection.done.pop_front();
    error = handBack(client, *transfer) ? 0 : EFAULT;
  } else if (connection.gone) {
    error = ENODEV;
  } else if (*connection.reapUntil <= Clock::now()) {
    error = EAGAIN;
  } else {
    return;
  }
  connection.reapUntil.reset();
  umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
  answered.push_back(client);
}

/// Into the client's memory. False where there is none.
bool UsbEmulator::State::handBack(UMockdevIoctlClient* client, Transfer& transfer) {
  const Memory cell = resolve(umockdev_ioctl_client_get_arg(client), 0, sizeof(void*));
  if (!cell) {
    return false;
  }
  write(cell.get(), 0, transfer.address);
  const Memory urb = resolve(cell.get(), 0, sizeof(usbdevfs_urb));
  if (!urb) {
    return false;
  }
  write(urb.get(), offsetof(usbdevfs_urb, status), transfer.status);
  write(urb.get(), offsetof(usbdevfs_urb, actual_length), static_cast<int>(transfer.actual));
  const size_t before = transfer.type == USBDEVFS_URB_TYPE_CONTROL ? kSetupBytes : 0;
  if (transfer.toHost() && transfer.actual > 0) {
    if (const Memory buffer = resolve(urb.get(), offsetof(usbdevfs_urb, buffer), before + transfer.actual)) {
      umockdev_ioctl_data_update(buffer.get(), before, transfer.bytes.data(), static_cast<gint>(transfer.actual));
    }
  }
  return true;
}

void UsbEmulator::State::endReaps() {
  for (auto& [client, connection] : connections) {
    if (connection.reapUntil) {
      reap(client, connection);
    }
  }
}

void UsbEmulator::State::shutDown(Connection& connection) {
  connection.gone = true;
  connection.claimed = false;
  for (const TransferPointer& transfer : std::deque(connection.submitted)) {
    finish(connection, transfer, -ESHUTDOWN);
  }
}

// --- The device ---

/// Of the transfers that a client has submitted, those that come next.
struct Turn {
  Connection* connection;
  UMockdevIoctlClient* client;
  TransferPointer transfer;
  std::optional<int> status;  ///< it ends with
  size_t actual = 0;
  std::vector<uint8_t> bytes;
};

/// As a host's controller does: full packets do not end a transfer that has room for more.
void receiveEvents(EmulatedDevice& device, size_t packet, DeviceMicroseconds now, Turn& turn) {
  const Transfer& transfer = *turn.transfer;
  turn.bytes = transfer.bytes;
  const std::vector<uint8_t> events = device.takeEvents(transfer.length - turn.actual, now);
  turn.bytes.insert(turn.bytes.end(), events.begin(), events.end());
  turn.actual = turn.bytes.size();
  if (turn.actual == transfer.length || events.size() % packet != 0) {
    turn.status = 0;
  }
}

bool UsbEmulator::State::work(size_t index) {
  Display& display = *displays[index];
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
      const Transfer& transfer = *turn.transfer;
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
  Display& display = *displays[index];
  lastNumber = lastNumber == kLastDeviceNumber ? kFirstDeviceNumber : lastNumber + 1;
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
  Display& display = *displays[index];
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
  Display& display = *displays[index];
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

UsbEmulator::State::State(std::vector<EmulatedUsbDisplay> options) {
  OC_CHECK(!options.empty(), "an emulator has a display");
  for (const EmulatedUsbDisplay& option : options) {
    requireSerial(option.device.firmware.serial);
  }
  sweepTestBeds();
  bed = newTestBed(folder.path());
  handler = umockdev_ioctl_base_new();
  g_signal_connect(handler, "handle-ioctl", G_CALLBACK(onIoctl), this);
  GError* error = nullptr;
  OC_CHECK(umockdev_testbed_add_from_string(bed, rootHubRecord().c_str(), &error), "umockdev takes our record");
  for (const EmulatedUsbDisplay& option : options) {
    displays.push_back(std::make_unique<Display>(option, static_cast<int>(displays.size()) + 1));
    plug(displays.size() - 1);
  }
  thread = std::thread([this] { run(); });
}

UsbEmulator::State::~State() {
  {
    const std::scoped_lock lock(mutex);
    stop = true;
    changed.notify_all();
  }
  thread.join();
  for (size_t i = 0; i < displays.size(); ++i) {
    if (displays[i]->plugged) {
      unplug(i);
    }
  }
  {
    // umockdev keeps the sockets of clients of whose end it has not heard before the bed goes.
    std::unique_lock lock(mutex);
    changed.wait_for(lock, kLastWords, [&] { return connections.empty() && strangers.empty(); });
  }
  // Nor does it tell when it has ended listening for clients, which it does on its thread. Where the bed goes before, a
  // socket stays open.
  std::this_thread::sleep_for(kEndOfListening);
  g_object_unref(bed);
  g_object_unref(handler);
  for (auto& [client, connection] : connections) {
    g_object_weak_unref(G_OBJECT(client), onVanished, this);
  }
  for (UMockdevIoctlClient* const client : strangers) {
    g_object_weak_unref(G_OBJECT(client), onVanished, this);
  }
}

UsbEmulator::UsbEmulator(std::vector<EmulatedUsbDisplay> displays)
    : state_(std::make_unique<State>(std::move(displays))) {}

UsbEmulator::~UsbEmulator() = default;

bool UsbEmulator::preloaded() {
  void* const loaded = dlopen(kPreloadLibrary, RTLD_LAZY | RTLD_NOLOAD);
  if (loaded != nullptr) {
    dlclose(loaded);
  }
  return loaded != nullptr;
}

std::optional<WorkError> UsbEmulator::preloadError() {
  void* const loaded = dlopen(kPreloadLibrary, RTLD_LAZY | RTLD_LOCAL);
  if (loaded == nullptr) {
    const char* const reason = dlerror();
    return WorkError("umockdev's preload library cannot be loaded", reason == nullptr ? kPreloadLibrary : reason,
                     kPreloadHint);
  }
  dlclose(loaded);
  return std::nullopt;
}

void UsbEmulator::requirePreloaded() {
  if (const auto error = preloadError()) {
    throw *error;
  }
  restartPreloaded();
  if (!preloaded()) {
    throw WorkError("this program cannot be started anew with umockdev's preload library", kPreloadLibrary,
                    "start it with the environment variable LD_PRELOAD set to that name");
  }
}

void UsbEmulator::restartPreloaded() {
  constexpr const char* kTried = "OCELLI_EMULATOR_PRELOADED";
  if (preloaded() || std::getenv(kTried) != nullptr) {
    return;
  }
  setenv(kTried, "1", 1);
  setenv("LD_PRELOAD", preloadList().c_str(), 1);
  // AddressSanitizer wants to be the first library, and works as the second one.
  const char* const options = std::getenv("ASAN_OPTIONS");
  setenv("ASAN_OPTIONS", fmt::format("{}:verify_asan_link_order=0", options == nullptr ? "" : options).c_str(), 1);
  std::vector<std::string> words;
  {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    for (std::string word; std::getline(file, word, '\0');) {
      words.push_back(word);
    }
  }
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  execv("/proc/self/exe", arguments.data());
}

std::vector<std::pair<std::string, std::string>> UsbEmulator::environment() const {
  const std::unique_ptr<gchar, decltype(&g_free)> root(umockdev_testbed_get_root_dir(state_->bed), g_free);
  return {{"LD_PRELOAD", preloadList()}, {"UMOCKDEV_DIR", root.get()}};
}

void UsbEmulator::use(size_t display, const std::function<void(EmulatedDevice&, DeviceMicroseconds)>& use) {
  Display& used = *state_->displays.at(display);
  const std::scoped_lock lock(used.deviceMutex);
  use(used.device, state_->now());
}

void UsbEmulator::unplug(size_t display) {
  const std::scoped_lock lock(state_->mutex);
  state_->displays.at(display)->pulled = true;
  state_->news = true;
  state_->changed.notify_all();
}

void UsbEmulator::plugIn(size_t display) {
  const std::scoped_lock lock(state_->mutex);
  state_->displays.at(display)->pulled = false;
  state_->news = true;
  state_->changed.notify_all();
}

void UsbEmulator::occupy(size_t display, bool occupied) {
  const std::scoped_lock lock(state_->mutex);
  state_->displays.at(display)->occupied = occupied;
}

void UsbEmulator::haltEvents(size_t display) {
  const std::scoped_lock lock(state_->mutex);
  state_->displays.at(display)->eventsHalted = true;
  state_->news = true;
  state_->changed.notify_all();
}

size_t UsbEmulator::transfersUnderWay(size_t display) const {
  const std::scoped_lock lock(state_->mutex);
  size_t count = 0;
  for (const auto& [client, connection] : state_->connections) {
    count += connection.display == display ? connection.submitted.size() + connection.done.size() : 0;
  }
  return count;
}

}  // namespace ocelli
