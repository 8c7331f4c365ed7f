// The integral of a transfer function over values.
#pragma once

#include <glm/vec4.hpp>

#include "oc_core/volume/transfer_function.h"

namespace ocelli {

/// From value `first` to value `last`, first <= last: of extinction (x), and of red, green and blue times extinction.
/// No peak is too thin for it: it goes from point to point of the function. The relative error is below 1e-6.
glm::dvec4 transferIntegral(const TransferFunction& transfer, double first, double last);

}  // namespace ocelli
