#include "oc_core/volume_render/march_kernel.h"

#include <array>

#include "oc_core/base/vector_targets.h"

// This file is compiled once for each of these instruction sets; foreach_target.h includes it again and again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oc_core/volume_render/march_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "oc_core/volume_render/march_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ocelli::HWY_NAMESPACE {

/// Some rays at once, in turns, until none is left.
template <class Field>
HWY_ATTR void marchWith(const MarchSetup& setup, size_t count, const PiecesOfRay& piecesOfRay, bool stopsAtDepth,
                        MarchResult* results) {
  constexpr size_t kRays = 8;
  const Field field(setup);
  std::array<March<Field>, kRays> marches;
  std::array<size_t, kRays> rays;
  std::array<size_t, kRays> order;  // of those that are on their way, the first `active`
  VolumeExtent::Pieces pieces;
  size_t next = 0;
  // The next ray that has a group. False where none is left.
  const auto start = [&](size_t slot) HWY_ATTR {
    while (next < count) {
      rays[slot] = next++;
      marches[slot].begin(std::span(pieces).first(piecesOfRay(rays[slot], pieces)));
      if (marches[slot].prepare()) {
        return true;
      }
      results[rays[slot]] = marches[slot].result();
    }
    return false;
  };
  size_t active = 0;
  for (size_t slot = 0; slot < kRays; ++slot) {
    marches[slot].attach(setup, field, stopsAtDepth);
    if (start(slot)) {
      order[active++] = slot;
    }
  }
  while (active > 0) {
    for (size_t i = 0; i < active; ++i) {
      marches[order[i]].read();
    }
    for (size_t i = 0; i < active; ++i) {
      marches[order[i]].findEntries();
    }
    for (size_t i = 0; i < active; ++i) {
      marches[order[i]].weighChanges();
    }
    for (size_t i = 0; i < active; ++i) {
      marches[order[i]].lookUp();
    }
    for (size_t i = 0; i < active; ++i) {
      marches[order[i]].sum();
    }
    for (size_t i = 0; i < active; ++i) {
      marches[order[i]].pass();
    }
    for (size_t i = 0; i < active;) {
      March<Field>& march = marches[order[i]];
      march.add();
      if (march.prepare()) {
        ++i;
        continue;
      }
      results[rays[order[i]]] = march.result();
      if (start(order[i])) {
        ++i;
      } else {
        order[i] = order[--active];
      }
    }
  }
}

HWY_ATTR void marchRays(const MarchSetup& setup, size_t count, const PiecesOfRay& piecesOfRay, bool stopsAtDepth,
                        MarchResult* results) {
#if HWY_TARGET != HWY_SCALAR
  if (fitsWords(*setup.volume)) {
    switch (setup.volume->type()) {
      case VoxelType::kUint8:
        return marchWith<NativeField<uint8_t>>(setup, count, piecesOfRay, stopsAtDepth, results);
      case VoxelType::kInt8:
        return marchWith<NativeField<int8_t>>(setup, count, piecesOfRay, stopsAtDepth, results);
      case VoxelType::kUint16:
        return marchWith<NativeField<uint16_t>>(setup, count, piecesOfRay, stopsAtDepth, results);
      case VoxelType::kInt16:
        return marchWith<NativeField<int16_t>>(setup, count, piecesOfRay, stopsAtDepth, results);
      case VoxelType::kFloat32:
        return marchWith<NativeField<float>>(setup, count, piecesOfRay, stopsAtDepth, results);
      case VoxelType::kUint32:
      case VoxelType::kInt32:
      case VoxelType::kFloat64:
        break;
    }
  }
#endif
  marchWith<AnyField>(setup, count, piecesOfRay, stopsAtDepth, results);
}

const char* marchTarget() {
  return hwy::TargetName(HWY_TARGET);
}

}  // namespace ocelli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ocelli {

HWY_EXPORT(marchRays);
HWY_EXPORT(marchTarget);

void march(const MarchSetup& setup, const PiecesOfRay& piecesOfRay, bool stopsAtDepth, std::span<MarchResult> results) {
  HWY_DYNAMIC_DISPATCH(marchRays)(setup, results.size(), piecesOfRay, stopsAtDepth, results.data());
}

std::string marchInstructionSet() {
  return HWY_DYNAMIC_DISPATCH(marchTarget)();
}

}  // namespace ocelli
#endif  // HWY_ONCE
