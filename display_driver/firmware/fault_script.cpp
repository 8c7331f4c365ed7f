#include "display_driver/firmware/fault_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/base/random.h"

namespace ocelli {
namespace {

/// What a kind of fault needs besides its time.
struct KindFields {
  FaultKind kind;
  const char* name;
  bool lasts;          ///< needs "for_ms"
  const char* amount;  ///< the name of its other field; nullptr: none
  double least;
  double most;
  double otherwise;  ///< below least: the field must be there
};

constexpr std::array<KindFields, kFaultKinds> kKinds = {{
    {FaultKind::kStall, "stall", false, nullptr, 0, 0, 0},
    {FaultKind::kShortWrite, "short_write", false, nullptr, 0, 0, 0},
    {FaultKind::kSlowLink, "slow_link", true, "bytes_per_second", 1000, 1e10, -1},
    {FaultKind::kUnplug, "unplug", true, nullptr, 0, 0, 0},
    {FaultKind::kWrongSequence, "wrong_sequence", false, nullptr, 0, 0, 0},
    {FaultKind::kBitFlips, "bit_flips", false, "bits", 1, 1e6, 1},
    {FaultKind::kPhaseDrift, "phase_drift", true, "rate", 0.5, 2, -1},
    {FaultKind::kFullBuffers, "full_buffers", true, nullptr, 0, 0, 0},
    {FaultKind::kDeafControl, "deaf_control", true, nullptr, 0, 0, 0},
}};

const KindFields& fieldsOf(FaultKind kind) {
  return kKinds[static_cast<size_t>(kind)];
}

constexpr double kMaxMilliseconds = 86400e3;
constexpr size_t kMaxFaults = 10000;

Fault faultFromJson(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  const std::string name = fields.text("fault");
  const auto found = std::ranges::find_if(kKinds, [&](const KindFields& kind) { return name == kind.name; });
  if (found == kKinds.end()) {
    std::string names;
    for (const KindFields& kind : kKinds) {
      names += names.empty() ? kind.name : std::string(", ") + kind.name;
    }
    fields.fail("fault", "must be one of " + names);
  }
  Fault fault;
  fault.kind = found->kind;
  fault.at = std::llround(fields.number("at_ms", 0, kMaxMilliseconds, 0) * 1e3);
  fault.afterFrames = static_cast<uint32_t>(fields.integer("at_frame", 0, std::numeric_limits<int>::max(), 0));
  fault.afterBytes = static_cast<size_t>(fields.integer("at_byte", 0, std::numeric_limits<int>::max(), 0));
  if (found->lasts) {
    fault.duration = std::llround(fields.number("for_ms", 0.001, kMaxMilliseconds) * 1e3);
  }
  if (found->amount != nullptr) {
    fault.amount = found->otherwise >= found->least
                       ? fields.number(found->amount, found->least, found->most, found->otherwise)
                       : fields.number(found->amount, found->least, found->most);
  }
  fields.rejectUnknown();
  return fault;
}

FaultScript scriptFrom(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  const nlohmann::json& list = fields.value("faults");
  if (!list.is_array() || list.size() > kMaxFaults) {
    fields.fail("faults", "must be a list of at most " + std::to_string(kMaxFaults));
  }
  fields.rejectUnknown();
  FaultScript script;
  for (size_t i = 0; i < list.size(); ++i) {
    script.faults.push_back(faultFromJson(list[i], where + ", fault " + std::to_string(i + 1)));
  }
  return script;
}

}  // namespace

const char* nameOf(FaultKind kind) {
  return fieldsOf(kind).name;
}

FaultScript faultScriptFromJson(const std::string& text, const std::string& where) {
  return readAs("docs/emulated_device.md#faults", [&] { return scriptFrom(parseJson(text, where), where); });
}

FaultScript readFaultScript(const std::filesystem::path& path) {
  return faultScriptFromJson(readFile(path, kMaxTextBytes), path.string());
}

std::string jsonText(const FaultScript& script) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Fault& fault : script.faults) {
    const KindFields& kind = fieldsOf(fault.kind);
    nlohmann::ordered_json json = {{"fault", kind.name}};
    if (fault.at > 0) {
      json["at_ms"] = static_cast<double>(fault.at) / 1e3;
    }
    if (fault.afterFrames > 0) {
      json["at_frame"] = fault.afterFrames;
    }
    if (fault.afterBytes > 0) {
      json["at_byte"] = fault.afterBytes;
    }
    if (kind.lasts) {
      json["for_ms"] = static_cast<double>(fault.duration) / 1e3;
    }
    if (kind.amount != nullptr) {
      json[kind.amount] = fault.amount;
    }
    list.push_back(json);
  }
  return nlohmann::ordered_json{{"faults", list}}.dump();
}

FaultScript randomFaults(uint64_t seed, size_t count, DeviceMicroseconds over) {
  Random random(seed);
  FaultScript script;
  for (size_t i = 0; i < count; ++i) {
    const KindFields& kind = kKinds[random.below(kFaultKinds)];
    Fault fault;
    fault.kind = kind.kind;
    fault.at = static_cast<DeviceMicroseconds>(random.below(static_cast<size_t>(over)));
    // Most hit the middle of a frame.
    if (random.below(4) != 0) {
      fault.afterBytes = 1 + random.below(20000);
    }
    if (kind.lasts) {
      fault.duration = 1000 + static_cast<DeviceMicroseconds>(random.below(200000));
    }
    switch (kind.kind) {
      case FaultKind::kSlowLink:
        fault.amount = static_cast<double>(10000 + random.below(1000000));
        break;
      case FaultKind::kBitFlips:
        fault.amount = static_cast<double>(1 + random.below(20));
        break;
      case FaultKind::kPhaseDrift:
        fault.amount = static_cast<double>(random.inRange(0.9f, 1.1f));
        break;
      default:
        break;
    }
    script.faults.push_back(fault);
  }
  std::ranges::sort(script.faults, {}, &Fault::at);
  return script;
}

}  // namespace ocelli
