// Errors of the toolkit as Python exceptions, whose three parts are attributes: python/ocelli/errors.py has the
// classes.
#include "oc_core/base/error.h"
#include "python/bindings/bindings.h"

namespace py = pybind11;

namespace ocelli {
namespace {

void raise(const char* className, const Error& error) {
  const py::object type = py::module_::import("ocelli.errors").attr(className);
  const Error::Parts& parts = error.parts();
  const py::object made = type(parts.problem, parts.where, parts.next, parts.details, error.what());
  PyErr_SetObject(type.ptr(), made.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) {
      std::rethrow_exception(thrown);
    }
  } catch (const InputError& error) {
    raise("InputError", error);
  } catch (const Error& error) {
    raise("WorkError", error);
  }
}

}  // namespace

void bindErrors(py::module_& /*module*/) {
  py::register_exception_translator(translate);
}

}  // namespace ocelli
