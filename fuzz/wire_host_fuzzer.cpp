// libFuzzer target: what a display, or a file, may tell the host: events in any pieces, the answers to requests, and
// scripts of faults.
#include <cstdlib>
#include <string>

#include "display_driver/firmware/fault_script.h"
#include "display_driver/wire/link_inbox.h"
#include "oc_core/base/error.h"

namespace {

using namespace ocelli;

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

/// However the bytes are cut, the same events come.
void events(std::span<const uint8_t> bytes, size_t piece) {
  LinkInbox whole;
  whole.listener([] {}).received(bytes);
  LinkInbox cut;
  const wire::LinkListener listener = cut.listener([] {});
  for (size_t at = 0; at < bytes.size(); at += piece) {
    listener.received(bytes.subspan(at, std::min(piece, bytes.size() - at)));
  }
  const LinkInbox::News news = whole.take();
  require(news.events == cut.take().events && news.events.size() <= bytes.size() / wire::kEventBytes);
}

/// What is read and written again says the same.
void records(std::span<const uint8_t> bytes) {
  if (const auto identity = wire::identityFrom(bytes)) {
    require(wire::identityFrom(wire::toBytes(*identity)) == identity);
  }
  if (const auto telemetry = wire::telemetryFrom(bytes)) {
    require(wire::telemetryFrom(wire::toBytes(*telemetry)) == telemetry);
  }
  if (const auto event = wire::eventFrom(bytes)) {
    require(wire::eventFrom(wire::toBytes(*event)) == event);
  }
}

/// As they are, and with a checksum that fits in the last four bytes.
void recordsRepaired(std::vector<uint8_t> bytes) {
  records(bytes);
  if (bytes.size() >= 4) {
    const uint32_t sum = wire::crc32c(std::span(bytes).first(bytes.size() - 4));
    for (size_t i = 0; i < 4; ++i) {
      bytes[bytes.size() - 4 + i] = static_cast<uint8_t>(sum >> (8 * i));
    }
    records(bytes);
  }
}

void script(const std::string& text) {
  try {
    const FaultScript faults = faultScriptFromJson(text, "fuzz");
    require(faultScriptFromJson(jsonText(faults), "again") == faults);
  } catch (const InputError&) {
    // Any other exception is a finding.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) {
    return 0;
  }
  const std::span bytes(data + 1, size - 1);
  if (data[0] == '{') {
    script(std::string(data, data + size));
    return 0;
  }
  events(bytes, 1 + data[0] % 64);
  // Events whose checksums fit.
  std::vector<uint8_t> repaired(bytes.begin(), bytes.end());
  for (size_t at = 0; at + wire::kEventBytes <= repaired.size(); at += wire::kEventBytes) {
    if (data[0] >= 128) {
      std::copy_n("OCLE", 4, repaired.begin() + static_cast<std::ptrdiff_t>(at));
    }
    const uint32_t sum = wire::crc32c(std::span(repaired).subspan(at, wire::kEventBytes - 4));
    for (size_t i = 0; i < 4; ++i) {
      repaired[at + wire::kEventBytes - 4 + i] = static_cast<uint8_t>(sum >> (8 * i));
    }
  }
  events(repaired, 1 + data[0] % 64);
  for (const size_t length : {wire::kIdentityBytes, wire::kTelemetryBytes, wire::kEventBytes}) {
    if (bytes.size() >= length) {
      recordsRepaired({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)});
    }
  }
  return 0;
}
