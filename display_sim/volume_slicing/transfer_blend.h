// Transfer functions between two others: what is shown while one turns into the other.
#pragma once

#include "oc_core/volume/transfer_function.h"

namespace ocelli {

/// At every value the extinction is that of `from` and of `to` in proportion, and the colour that of both, weighed with
/// their extinctions. `share` is that of `to`, from 0 to 1.
TransferFunction blendedTransfer(const TransferFunction& from, const TransferFunction& to, double share);

}  // namespace ocelli
