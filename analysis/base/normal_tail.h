// The upper tail of the normal distribution, exact far out too: what a censored time adds to a likelihood.
#pragma once

namespace ocelli {

/// log P(Z > z).
double logNormalTail(double z);
/// Density over P(Z > z).
double normalHazard(double z);

}  // namespace ocelli
