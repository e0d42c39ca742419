#include <exception>

#include "files/error.hpp"
#include "python/src/bindings.hpp"
#include "tamis/error.hpp"

namespace tamis::python {
namespace {

namespace nb = nanobind;

void raise(const char* name, const std::exception& error) {
  PyErr_SetString(nb::module_::import_("tamis._errors").attr(name).ptr(), error.what());
}

}  // namespace

void bind_errors() {
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const InvalidMesh& error) {
      raise("InvalidMesh", error);
    } catch (const InvalidStep& error) {
      raise("InvalidStep", error);
    } catch (const InvalidOptions& error) {
      raise("InvalidOptions", error);
    } catch (const InvalidPath& error) {
      raise("InvalidPath", error);
    } catch (const Cancelled& error) {
      raise("Cancelled", error);
    } catch (const Busy& error) {
      raise("Busy", error);
    } catch (const io::FileError& error) {
      raise("FileError", error);
    } catch (const Error& error) {
      raise("Error", error);
    }
  });
}

}  // namespace tamis::python
