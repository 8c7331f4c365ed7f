// What umockdev's worker asks for each ioctl() of a client, answered as the system's USB does.
#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "display_driver/emulator/usb_emulator_state.h"
#include "display_driver/emulator/usb_function.h"

namespace ocelli {
namespace {

constexpr std::chrono::microseconds kEmptyReap{500};

template <class Field>
void write(UMockdevIoctlData* data, size_t offset, const Field& field) {
  std::array<guint8, sizeof(Field)> bytes;
  std::memcpy(bytes.data(), &field, sizeof(Field));
  umockdev_ioctl_data_update(data, offset, bytes.data(), static_cast<gint>(bytes.size()));
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

EmulatedConnection* UsbEmulator::State::connectionOf(UMockdevIoctlClient* client) {
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
  EmulatedConnection* const connection = connectionOf(client);
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
int UsbEmulator::State::answer(UMockdevIoctlClient* client, EmulatedConnection& connection, unsigned long request) {
  PluggedDisplay& display = *displays[connection.display];
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

int UsbEmulator::State::claim(EmulatedConnection& connection) {
  const bool taken = std::ranges::any_of(connections, [&](const auto& other) {
    return &other.second != &connection && other.second.display == connection.display && other.second.claimed;
  });
  if (taken || displays[connection.display]->occupied) {
    return -EBUSY;
  }
  connection.claimed = true;
  return 0;
}

int UsbEmulator::State::submit(UMockdevIoctlClient* client, EmulatedConnection& connection) {
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
  auto transfer = std::make_shared<EmulatedTransfer>(EmulatedTransfer{.address = address,
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

int UsbEmulator::State::discard(UMockdevIoctlClient* client, EmulatedConnection& connection) {
  uint64_t address = 0;
  std::memcpy(&address, umockdev_ioctl_client_get_arg(client)->data, sizeof(address));
  const auto found = std::ranges::find(connection.submitted, address, [](const auto& t) { return t->address; });
  if (found == connection.submitted.end()) {
    return -EINVAL;
  }
  end(connection, TransferPointer(*found), -ENOENT);
  return 0;
}

int UsbEmulator::State::clearHalt(UMockdevIoctlClient* client, PluggedDisplay& display) {
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
void UsbEmulator::State::end(EmulatedConnection& connection, const TransferPointer& transfer, int status) {
  if (transfer->inWork) {
    transfer->ended = status;
  } else {
    finish(connection, transfer, status);
  }
}

void UsbEmulator::State::finish(EmulatedConnection& connection, const TransferPointer& transfer, int status) {
  std::erase(connection.submitted, transfer);
  transfer->status = status;
  connection.done.push_back(transfer);
}

/// Hands a transfer back to a client that asks for one. Where there is none, the client waits for a while.
void UsbEmulator::State::reap(UMockdevIoctlClient* client, EmulatedConnection& connection) {
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
bool UsbEmulator::State::handBack(UMockdevIoctlClient* client, EmulatedTransfer& transfer) {
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

void UsbEmulator::State::shutDown(EmulatedConnection& connection) {
  connection.gone = true;
  connection.claimed = false;
  for (const TransferPointer& transfer : std::deque(connection.submitted)) {
    finish(connection, transfer, -ESHUTDOWN);
  }
}

}  // namespace ocelli
