// Writes streams of the encoder, whole and damaged, and what the firmware acknowledges and reports of them, for
// wire_python_test.py.
//
// Usage: wire_stream_writer COUNT. One item a line: of each stream "display SESSION SLICES WIDTH HEIGHT BITS", "bytes
// HEX", "arrived FRAME HEX...", a slice each, and "error FRAME CODE".
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "display_driver/firmware/firmware.h"
#include "display_driver/wire/frame_encoder.h"
#include "tests/display_driver_wire/made_volumes.h"

namespace {

using namespace ocelli;

void printHex(std::span<const uint8_t> bytes) {
  for (const uint8_t byte : bytes) {
    std::printf("%02x", byte);
  }
}

class Printer : public ArrivalSink {
 public:
  void frameArrived(uint32_t, uint32_t frame, const Volume& volume) override { volumes_.emplace_back(frame, volume); }

  void print(std::span<const uint8_t> events) {
    size_t arrived = 0;
    for (size_t at = 0; at < events.size(); at += wire::kEventBytes) {
      const wire::Event event = wire::eventFrom(events.subspan(at, wire::kEventBytes)).value();
      if (event.type == wire::EventType::kError) {
        std::printf("error %u %u\n", event.frame, event.code);
      } else if (event.type == wire::EventType::kArrived) {
        std::printf("arrived %u", event.frame);
        const Volume& volume = volumes_.at(arrived++).second;
        for (int i = 0; i < volume.slices(); ++i) {
          std::printf(" ");
          printHex(volume.slice(i));
        }
        std::printf("\n");
      }
    }
  }

 private:
  std::vector<std::pair<uint32_t, Volume>> volumes_;
};

/// Damages some messages, in what way a cable or a wrong host may.
std::vector<uint8_t> damaged(std::vector<uint8_t> bytes, Random& random) {
  const size_t at = random.below(bytes.size());
  switch (random.below(4)) {
    case 0:
      bytes[at] = static_cast<uint8_t>(bytes[at] ^ (1u << random.below(8)));
      break;
    case 1:
      bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.end());
      break;
    case 2:
      bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), 1 + random.below(50), static_cast<uint8_t>(at));
      break;
    default:
      bytes.clear();
  }
  return bytes;
}

void writeStream(uint64_t seed) {
  Random random(seed);
  constexpr uint32_t kSession = 0xabcdef01;
  constexpr uint32_t kCapabilities[] = {31, 31 - 2, 31 - 2 - 4, 31 - 4, 24};
  FirmwareOptions options{.profile = smallProfile(static_cast<int>(2 + seed % 10), 1 + static_cast<int>(seed % 3)),
                          .frameBuffers = 200};
  options.profile.width = static_cast<int>(10 + seed % 8);
  options.profile.height = 5;
  Firmware firmware(options);
  Printer printer;
  firmware.setArrivalSink(&printer);
  if (!firmware.controlOut(3, 1, wire::toBytes(wire::Arm{.session = kSession}), 0)) {
    std::abort();
  }
  wire::FrameEncoder encoder(options.profile, kCapabilities[seed % std::size(kCapabilities)]);
  wire::MessageWriter writer(kSession);
  std::vector<uint8_t> stream;
  Volume before(options.profile);
  uint32_t base = 0;
  for (uint32_t frame = 1; frame <= 40; ++frame) {
    Volume volume = random.below(3) == 0 ? Volume(options.profile) : before;
    lightSome(volume, random, random.below(5) == 0 ? 0.5 : 0.01);
    const bool whole = base == 0 || random.below(4) == 0;
    encoder.begin(volume, whole ? nullptr : &before, std::nullopt);
    const auto send = [&](std::vector<uint8_t> message) {
      const auto& sent = seed % 2 == 1 && random.below(40) == 0 ? damaged(message, random) : message;
      stream.insert(stream.end(), sent.begin(), sent.end());
    };
    std::vector<uint8_t> message;
    writer.frameBegin(message, frame, {whole ? 0 : base, encoder.records()});
    send(std::exchange(message, {}));
    for (auto slices = encoder.next(3); !slices.empty(); slices = encoder.next(3)) {
      for (const auto& slice : slices) {
        writer.slice(message, frame, slice.slice, slice.coded);
        send(std::exchange(message, {}));
      }
      if (random.below(4) == 0) {
        writer.present(message, frame, {.atNextRefresh = true});
        send(std::exchange(message, {}));
      }
    }
    writer.frameEnd(message, frame);
    send(message);
    before = volume;
    base = frame;
  }
  if (firmware.receive(stream, 0) != stream.size()) {
    std::abort();
  }
  std::printf("display %u %d %d %d %d\nbytes ", kSession, options.profile.storedSlices(), options.profile.width,
              options.profile.height, options.profile.colorBitsPerChannel);
  printHex(stream);
  std::printf("\n");
  printer.print(firmware.takeEvents(size_t{1} << 20));
}

}  // namespace

int main(int, char** arguments) {
  const uint64_t streams = std::strtoull(arguments[1], nullptr, 10);
  for (uint64_t seed = 0; seed < streams; ++seed) {
    writeStream(seed);
  }
  return 0;
}
