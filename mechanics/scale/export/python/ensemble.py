"""Many motions over a cluster of Dask.

    from dask.distributed import Client
    from @NAME@.ensemble import evolve_on
    states, status = evolve_on(Client(), starts, parameters, t, checkpoint="run-1")

Work is done in batches.  Dask does one again whose worker has died.  With a checkpoint, a
folder, each batch is written when it is done; the same call goes on from there.
"""

import hashlib
import json
import os

import numpy as np

from . import evolve_with_status, parameters as parameter_names, variables


def _batch(index, starts, p, t, tolerance):
    states, status = evolve_with_status(starts, p, t, tolerance)
    return index, states, status


def _fingerprint(starts, p, t, tolerance, batch):
    h = hashlib.sha256()
    with open(os.path.join(os.path.dirname(__file__), "csrc", "@NAME@.c"), "rb") as source:
        h.update(source.read())
    for x in (starts, p, np.array([t, tolerance, batch])):
        h.update(np.ascontiguousarray(x, dtype=np.float64).tobytes())
    return h.hexdigest()


class Checkpoint:
    """A folder with a file for each batch that is done, and what they are batches of."""

    def __init__(self, folder, fingerprint):
        self.folder = folder
        about = os.path.join(folder, "ensemble.json")
        if os.path.exists(about):
            with open(about) as f:
                found = json.load(f).get("fingerprint")
            if found != fingerprint:
                raise ValueError(f"the checkpoint {folder} is of another ensemble")
        elif os.path.isdir(folder) and os.listdir(folder):
            raise ValueError(f"the folder {folder} is no checkpoint")
        else:
            os.makedirs(folder, exist_ok=True)
            self._write("ensemble.json", lambda f: f.write(
                json.dumps({"fingerprint": fingerprint}).encode()))

    def _write(self, name, write):
        path = os.path.join(self.folder, name)
        with open(path + ".part", "wb") as f:
            write(f)
        os.replace(path + ".part", path)

    def _name(self, index):
        return f"batch-{index:08d}.npz"

    def save(self, index, states, status):
        self._write(self._name(index), lambda f: np.savez(f, states=states, status=status))

    def load(self, index):
        path = os.path.join(self.folder, self._name(index))
        if not os.path.exists(path):
            return None
        with np.load(path) as found:
            return found["states"], found["status"]


def evolve_on(client, starts, p, t, tolerance=1e-10, batch=256, checkpoint=None, each=None):
    """-> the states at t and the statuses, in the order of the starts.

    client: of dask.distributed; each: called with the index of a batch when it is done.
    """
    from dask.distributed import as_completed

    starts = np.array(starts, dtype=np.float64, ndmin=2)
    p = np.array(p, dtype=np.float64, ndmin=2)
    count = len(starts)
    if starts.size == 0:
        raise ValueError("there are no starts")
    if starts.shape[1] != len(variables) or (parameter_names and
                                              p.shape[1] != len(parameter_names)):
        raise ValueError(f"expected rows of {variables} and of {parameter_names}")
    if len(p) not in (1, count):
        raise ValueError(f"there are {count} starts and {len(p)} rows of parameters")
    states, status = np.empty_like(starts), np.empty(count, dtype=np.intc)
    kept = checkpoint and Checkpoint(checkpoint, _fingerprint(starts, p, t, tolerance, batch))

    def place(index):
        return slice(index * batch, min(count, (index + 1) * batch))

    def take(index, found, codes):
        states[place(index)], status[place(index)] = found, codes

    futures = []
    for index in range(-(-count // batch)):
        done = kept and kept.load(index)
        if done:
            take(index, *done)
        else:
            own = p if len(p) == 1 else p[place(index)]
            futures.append(client.submit(_batch, index, starts[place(index)], own, t, tolerance,
                                         pure=False))
    for future in as_completed(futures):
        index, found, codes = future.result()
        take(index, found, codes)
        if kept:
            kept.save(index, found, codes)
        future.release()
        if each:
            each(index)
    return states, status
