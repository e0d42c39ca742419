// Types that refer to Python's objects and may be referred to by them: its garbage collector must see through them.
#pragma once
#include <nanobind/nanobind.h>

namespace tamis::python {

template <class T>
int visit_instance(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  return nanobind::inst_ready(self) ? nanobind::inst_ptr<T>(self)->traverse(visit, arg) : 0;
}

template <class T>
int clear_instance(PyObject* self) {
  if (nanobind::inst_ready(self)) nanobind::inst_ptr<T>(self)->clear();
  return 0;
}

/// For nanobind::type_slots; T has traverse() and clear().
template <class T>
inline PyType_Slot collected[] = {{Py_tp_traverse, reinterpret_cast<void*>(&visit_instance<T>)},
                                  {Py_tp_clear, reinterpret_cast<void*>(&clear_instance<T>)},
                                  {0, nullptr}};

}  // namespace tamis::python
