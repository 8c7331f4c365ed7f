// Pictures of secondary rays that a device casts: all rays of an order together, those of each proxy by themselves.
#pragma once

#include <optional>

#include "oc_core/shade/shaded_picture.h"

namespace ocelli {

/// As shade(), but that the caster of the proxies (ProxyInputs::caster) casts the rays; nothing where one of the
/// proxies is on no device. Throws WorkError where the device fails.
std::optional<ShadedPicture> shadeOnDevice(const SecondaryRays& rays, const SenderProxies& proxies, int order,
                                           int runs = 1);

}  // namespace ocelli
