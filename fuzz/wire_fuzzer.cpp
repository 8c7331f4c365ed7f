// libFuzzer target: what a host sends to a display, to the firmware and to the slow display of docs/wire_protocol.md
// side by side. They must say and show the same, or the target aborts. The first byte says how the others are taken:
// as the choices of a host that does all that a host can do; as messages, whose checksums and numbers are made right;
// or as they are.
#include <algorithm>
#include <cstdlib>

#include "tests/display_driver_firmware/twin_displays.h"

namespace {

using namespace ocelli;
using namespace ocelli::test;

class Input {
 public:
  Input(const uint8_t* data, size_t size) : rest_(data, size) {}

  bool done() const { return rest_.empty(); }
  uint8_t byte() {
    if (rest_.empty()) {
      return 0;
    }
    const uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }
  size_t below(size_t count) {
    size_t value = byte();
    for (size_t most = 256; most < count; most <<= 8) {
      value = value << 8 | byte();
    }
    return value % count;
  }
  ByteSpan bytes(size_t count) {
    const ByteSpan some = rest_.first(std::min(count, rest_.size()));
    rest_ = rest_.subspan(some.size());
    return some;
  }

 private:
  ByteSpan rest_;
};

FirmwareOptions optionsFrom(Input& input) {
  const uint8_t display = input.byte();
  return {.profile = tinyProfile(2 + display % 8, 1 + display / 8 % 2),
          .frameBuffers = 2 + display / 16 % 3,
          .capabilities = input.byte() & 31u};
}

void choices(Input& input) {
  const FirmwareOptions options = optionsFrom(input);
  constexpr size_t kWildness[] = {0, 4, 30, 200};
  const size_t wildness = kWildness[input.byte() % 4];
  TwinDisplays displays(options);
  WildHost host(
      displays, slowOptions(options, 200), [&](size_t count) { return input.below(count); }, wildness);
  while (!input.done()) {
    host.doSomething();
  }
}

/// Each message is seven bytes and its payload.
void messages(Input& input) {
  FirmwareOptions options = optionsFrom(input);
  options.capabilities &= ~2u;  // the slow display reads no zstd
  TwinDisplays displays(options);
  uint32_t session = 1;
  uint32_t sequence = 0;
  displays.arm(session);
  while (!input.done()) {
    const uint8_t type = input.byte();
    if (type >= 0xf0) {
      sequence = 0;
      displays.arm(++session);
    } else if (type >= 0x80) {
      displays.step();
    } else if (displays.idle()) {
      const Header header{.type = type,
                          .coding = input.byte(),
                          .slice = static_cast<uint16_t>(input.byte()),
                          .session = session,
                          .sequence = sequence++,
                          .frame = input.byte()};
      const size_t length = input.byte();
      displays.send(messageBytes(header, input.bytes(length)));
    }
  }
}

/// As the bytes are, in pieces.
void plain(Input& input) {
  TwinDisplays displays(optionsFrom(input));
  displays.arm(0x41414141);
  while (!input.done()) {
    const size_t length = input.byte();
    displays.send(input.bytes(length));
    displays.step();
  }
}

/// Without the slow display: zstd as it comes, and slices that are skipped.
void alone(Input& input) {
  FirmwareOptions options = optionsFrom(input);
  options.capabilities |= 2;
  Firmware firmware(options);
  if (!firmware.controlOut(3, 1, armRecord(1), 0)) {
    std::abort();
  }
  Bytes stream;
  for (uint32_t sequence = 0; !input.done(); ++sequence) {
    const uint8_t kind = input.byte();
    if (kind >= 0xf0) {
      const uint8_t request = input.byte();
      const size_t most = input.byte();
      const auto answer = firmware.controlIn(request, input.byte() / 128, most, 0);
      if (answer && answer->size() > most) {
        std::abort();
      }
      // Not a new session: the stream goes on.
      if (request != 3) {
        firmware.controlOut(request == 5 ? 6 : request, input.byte() / 128, input.bytes(most % 20), 0);
      }
    }
    const Header header{.type = static_cast<uint8_t>(1 + kind % 4),
                        .coding = input.byte(),
                        .slice = input.byte(),
                        .session = 1,
                        .sequence = sequence,
                        .frame = input.byte()};
    const size_t length = input.byte();
    append(stream, messageBytes(header, input.bytes(length)));
    const DeviceMicroseconds now = DeviceMicroseconds{sequence} * input.byte() * 20;
    const size_t taken = firmware.receive(stream, now);
    if (taken > stream.size()) {
      std::abort();
    }
    stream.erase(stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(taken));
    const auto events = firmware.takeEvents(input.byte());
    if (events.size() % 32 != 0 || firmware.nextChange() < 0) {
      std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  switch (input.byte() % 4) {
    case 0:
      choices(input);
      break;
    case 1:
      messages(input);
      break;
    case 2:
      plain(input);
      break;
    default:
      alone(input);
  }
  return 0;
}
