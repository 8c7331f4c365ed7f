#include "display_driver/emulator/usb_emulator.h"

#include <cstdlib>
#include <filesystem>

#include "display_driver/emulator/preload.h"
#include "display_driver/emulator/usb_emulator_state.h"

namespace ocelli {
namespace {

constexpr std::chrono::milliseconds kEndOfListening{30};
constexpr std::chrono::milliseconds kLastWords{500};

UMockdevTestbed* newTestBed(const std::filesystem::path& folder) {
  constexpr const char* kVariable = "TMPDIR";
  const char* const set = std::getenv(kVariable);
  const std::optional<std::string> before = set == nullptr ? std::nullopt : std::optional<std::string>(set);
  setenv(kVariable, folder.c_str(), 1);
  g_get_tmp_dir();  // GLib keeps it
  before ? setenv(kVariable, before->c_str(), 1) : unsetenv(kVariable);
  return umockdev_testbed_new();
}

}  // namespace

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
    displays.push_back(std::make_unique<PluggedDisplay>(option, static_cast<int>(displays.size()) + 1));
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

std::vector<std::pair<std::string, std::string>> UsbEmulator::environment() const {
  const std::unique_ptr<gchar, decltype(&g_free)> root(umockdev_testbed_get_root_dir(state_->bed), g_free);
  return {{"LD_PRELOAD", preloadList()}, {"UMOCKDEV_DIR", root.get()}};
}

void UsbEmulator::use(size_t display, const std::function<void(EmulatedDevice&, DeviceMicroseconds)>& use) {
  PluggedDisplay& used = *state_->displays.at(display);
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
