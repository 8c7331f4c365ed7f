#include "display_driver/wire/bandwidth_plan.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "display_driver/wire/frame_encoder.h"
#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/base/number_text.h"

namespace ocelli::wire {
namespace {

constexpr std::array kCodings{Coding::kRaw, Coding::kRunLength, Coding::kZstd};
/// Slices that are coded before they are handed to the link.
constexpr size_t kBatch = 32;

uint32_t capabilitiesFor(const CodingPlan& plan) {
  uint32_t capabilities = plan.changes ? kCanDelta : 0;
  switch (plan.coding) {
    case Coding::kRaw:
      break;
    case Coding::kRunLength:
      capabilities |= kCanRunLength;
      break;
    case Coding::kZstd:
      capabilities |= kCanZstd;
      break;
  }
  return capabilities;
}

}  // namespace

PlannedLink plannedLink(const std::string& text) {
  if (text == "usb2") {
    return {text, kUsb2BytesPerSecond};
  }
  if (text == "usb3") {
    return {text, kUsb3BytesPerSecond};
  }
  const double bytes = numberFromText<double>(text).value_or(0);
  if (!(bytes >= 1 && bytes <= 1e15)) {
    throw InputError("there is no link \"" + text + "\"", "--link", "usb2, usb3, or bytes a second: --link 25e6");
  }
  return {text, bytes};
}

const char* nameOf(PlanLimit limit) {
  switch (limit) {
    case PlanLimit::kNone:
      return "none";
    case PlanLimit::kLink:
      return "link";
    case PlanLimit::kOverhead:
      return "overhead";
    case PlanLimit::kCoding:
      return "coding";
  }
  return "";
}

const char* nameOf(Coding coding) {
  switch (coding) {
    case Coding::kRaw:
      return "raw";
    case Coding::kRunLength:
      return "run length";
    case Coding::kZstd:
      return "zstd";
  }
  return "";
}

double CodingPlan::hertz(const PlannedLink& link) const {
  return std::min(linkHertz(link), codingHertz());
}

PlanLimit CodingPlan::limit(const PlannedLink& link, double wantedHertz) const {
  if (hertz(link) >= wantedHertz) {
    return PlanLimit::kNone;
  }
  if (codingHertz() < linkHertz(link)) {
    return PlanLimit::kCoding;
  }
  return link.bytesPerSecond >= wantedHertz * payloadBytes ? PlanLimit::kOverhead : PlanLimit::kLink;
}

void BandwidthPlanner::add(const Volume& frame) {
  if (sums_.empty()) {
    for (const bool changes : {false, true}) {
      for (const Coding coding : kCodings) {
        sums_.push_back({.total = {.coding = coding, .changes = changes}});
      }
    }
  }
  OC_CHECK(!last_ || last_->profile() == frame.profile(), "frames of different displays");
  for (Sum& sum : sums_) {
    if (!sum.total.changes) {
      code(sum, frame, nullptr);
    } else if (last_) {
      code(sum, frame, &*last_);
    }
  }
  last_ = frame;
}

void BandwidthPlanner::code(Sum& sum, const Volume& frame, const Volume* base) {
  CodingPlan& total = sum.total;
  FrameEncoder encoder(frame.profile(), capabilitiesFor(total));
  MessageWriter writer(1);
  std::vector<uint8_t> bytes;
  const auto start = std::chrono::steady_clock::now();
  encoder.begin(frame, base, std::nullopt);
  total.slices += static_cast<double>(encoder.slicesLeft());
  size_t all = 0;
  const auto send = [&] {
    all += bytes.size();
    bytes.clear();
  };
  writer.frameBegin(bytes, 2, {base == nullptr ? 0u : 1u, encoder.records()});
  while (encoder.slicesLeft() > 0) {
    for (const FrameEncoder::Coded& coded : encoder.next(kBatch)) {
      writer.slice(bytes, 2, coded.slice, coded.coded);
      total.payloadBytes += static_cast<double>(coded.coded.payload.size());
      total.overheadBytes -= static_cast<double>(coded.coded.payload.size());
    }
    send();
  }
  writer.frameEnd(bytes, 2);
  writer.present(bytes, 2, {});
  send();
  total.codingSeconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  total.overheadBytes += static_cast<double>(all);
  ++sum.frames;
}

std::vector<CodingPlan> BandwidthPlanner::plans() const {
  std::vector<CodingPlan> plans;
  for (const Sum& sum : sums_) {
    if (sum.frames == 0) {
      continue;
    }
    CodingPlan mean = sum.total;
    for (double* figure : {&mean.slices, &mean.payloadBytes, &mean.overheadBytes, &mean.codingSeconds}) {
      *figure /= sum.frames;
    }
    plans.push_back(mean);
  }
  return plans;
}

const CodingPlan& bestPlan(const std::vector<CodingPlan>& plans, const PlannedLink& link, double wantedHertz) {
  OC_CHECK(!plans.empty(), "no frame was planned with");
  return *std::ranges::min_element(plans, [&](const CodingPlan& a, const CodingPlan& b) {
    const bool aReaches = a.hertz(link) >= wantedHertz;
    const bool bReaches = b.hertz(link) >= wantedHertz;
    if (aReaches != bReaches) {
      return aReaches;
    }
    return aReaches ? a.bytes() < b.bytes() : a.hertz(link) > b.hertz(link);
  });
}

}  // namespace ocelli::wire
