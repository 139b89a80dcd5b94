"""@DEFINITION@

States are rows of the variables; `evolve` follows many at once.  The code that does it is C, in
csrc/, built when the package is first imported where that has not been done.
"""

import ctypes
import os
import subprocess

import numpy as np

variables = @VARIABLES@
parameters = @PARAMETERS@
first_is_time = @CLOCK@

_folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "csrc")


def _load():
    path = os.path.join(_folder, "lib@NAME@.so")
    if not os.path.exists(path):
        subprocess.run(["make", "-s", "lib@NAME@.so"], cwd=_folder, check=True)
    library = ctypes.CDLL(path)
    library.@NAME@_ensemble.restype = ctypes.c_long
    library.dop853_reason.restype = ctypes.c_char_p
    return library


_library = _load()


def _pointer(array):
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def _row(x, names, what):
    row = np.ascontiguousarray(x, dtype=np.float64)
    if row.shape != (len(names),):
        raise ValueError(f"expected {what} as {len(names)} numbers {names}, given {row.shape}")
    return row


def derivative(state, p=()):
    """How fast each variable changes at a state."""
    y, q = _row(state, variables, "a state"), _row(p, parameters, "parameters")
    rates = np.empty_like(y)
    _library.@NAME@_derivative(_pointer(y), _pointer(q), _pointer(rates))
    return rates


def jacobian(state, p=()):
    """The derivatives of the rates by the variables, then by the parameters."""
    if not @JACOBIAN@:
        raise NotImplementedError("export the system with #:derivatives? #t")
    y, q = _row(state, variables, "a state"), _row(p, parameters, "parameters")
    J = np.empty((len(variables), len(variables) + len(parameters)))
    _library.@NAME@_jacobian(_pointer(y), _pointer(q), _pointer(J))
    return J


def _rows(x, names, what):
    rows = np.array(x, dtype=np.float64, ndmin=2, order="C")
    if rows.ndim != 2 or rows.shape[1] != len(names):
        raise ValueError(f"expected {what} as rows of {len(names)} numbers {names}, "
                         f"given {rows.shape}")
    return rows


def evolve_with_status(starts, p, t, tolerance=1e-10):
    """-> the states at the time t, and for each start 0 or the number of a reason."""
    states = _rows(starts, variables, "starts")
    count = len(states)
    if count == 0:
        raise ValueError("there are no starts")
    q = _rows(p, parameters, "parameters") if parameters else np.zeros((1, 1))
    common = len(q) == 1
    if not common and len(q) != count:
        raise ValueError(f"there are {count} starts and {len(q)} rows of parameters")
    status = np.zeros(count, dtype=np.intc)
    _library.@NAME@_ensemble(
        ctypes.c_long(count), _pointer(states), _pointer(q), ctypes.c_int(common),
        ctypes.c_double(t), ctypes.c_double(tolerance),
        status.ctypes.data_as(ctypes.POINTER(ctypes.c_int)))
    return states, status


def evolve(starts, p=(), t=1.0, tolerance=1e-10):
    """The states that the starts reach at the time t, row by row.

    starts: rows of the variables; p: a row of parameters for each, or one for all.
    What cannot be followed to the end has rows of nan: `evolve_with_status` says why.
    """
    states, status = evolve_with_status(starts, p, t, tolerance)
    states[status != 0] = np.nan
    return states


def reason(status):
    """What a status that is not 0 means."""
    return _library.dop853_reason(ctypes.c_int(int(status))).decode()
