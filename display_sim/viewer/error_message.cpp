#include "display_sim/viewer/error_message.h"

#include <new>

namespace ocelli {

std::string errorMessage(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    return "out of memory\n  try: a smaller scene or image";
  } catch (const std::exception& known) {
    return known.what();
  }
}

}  // namespace ocelli
