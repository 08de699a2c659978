#include <Python.h>

#include "too_old.hpp"

PyMODINIT_FUNC PyInit__unbruised() {
  PyErr_SetString(PyExc_ImportError, kTooOld);
  return nullptr;
}
