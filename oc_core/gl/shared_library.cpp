#include "oc_core/gl/shared_library.h"

#include <dlfcn.h>

#include "oc_core/gl/gl_error.h"

namespace ocelli {

SharedLibrary::SharedLibrary(const char* file, const char* package)
    : file_(file), package_(package), handle_(dlopen(file, RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE)) {
  if (handle_ == nullptr) {
    const char* reason = dlerror();
    throw GlError(reason != nullptr ? reason : "it cannot be opened", file_, "install " + package_);
  }
}

SharedLibrary::Function SharedLibrary::find(const char* name) const {
  return reinterpret_cast<Function>(dlsym(handle_, name));
}

SharedLibrary::Function SharedLibrary::require(const char* name) const {
  const Function function = find(name);
  if (function == nullptr) {
    throw GlError(std::string("it has no function ") + name, file_, "update " + package_);
  }
  return function;
}

}  // namespace ocelli
