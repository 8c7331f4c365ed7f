#include "oc_core/compositing/composite.h"

#include "oc_core/base/error.h"

namespace ocelli {

Compositing compositingFromText(const std::string& text, const std::string& where) {
  if (text == "direct") {
    return Compositing::kDirectSend;
  }
  if (text == "swap") {
    return Compositing::kBinarySwap;
  }
  throw InputError("there is no way of compositing \"" + text + "\"", where, "use direct or swap");
}

}  // namespace ocelli
