// Transfer functions between two others: what is shown while one turns into the other, and back.
#pragma once

#include "oc_core/volume/transfer_function.h"

namespace ocelli {

/// At every value the extinction is that of `from` and of `to` in proportion, and the colour that of both, weighed with
/// their extinctions. `share` is that of `to`, from 0 to 1.
TransferFunction blendedTransfer(const TransferFunction& from, const TransferFunction& to, double share);

/// A transfer function that turns into another one in half of a period, and back in the other half.
class TransferSwing {
 public:
  /// `periodSeconds` is positive.
  TransferSwing(TransferFunction from, TransferFunction to, double periodSeconds);
  TransferFunction at(double seconds) const;

 private:
  TransferFunction from_;
  TransferFunction to_;
  double periodSeconds_;
};

}  // namespace ocelli
