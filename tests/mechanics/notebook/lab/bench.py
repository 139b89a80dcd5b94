"""A class on one server: kernels that start at once, each with a formula and a picture.

    bench.py [COUNT]      30, unless told otherwise

Prints when a kernel alone and the last of all have their results, and what they take: each with its
two processes together, all of them as the system sees it, where shared pages count once.
"""

import concurrent.futures
import os
import pathlib
import sys
import time

import psutil

os.environ["JUPYTER_PATH"] = str(pathlib.Path(sys.prefix) / "share" / "jupyter")
from client import Kernel  # noqa: E402

FORMULA = ("(define ((L-pendulum g l) (up t a v))\n"
           "  (+ (* 1/2 (square (* l v))) (* g l (cos a))))\n"
           "(((Lagrange-equations (L-pendulum 'g 'l)) (literal-function 'q)) 't)")
PICTURE = ("(require mechanics/plot)\n"
           "(plot-phase-portrait (frame -3.2 3.2 -8 8) (Lagrangian->energy (L-pendulum 9.8 1)))")


class Student:
    def __init__(self, began):
        self.kernel, self.began, self.seconds = Kernel(), began, {}

    def run(self, code, mime):
        ran = self.kernel.run(code, patience=300)
        if not any(ran.data(mime)):
            raise RuntimeError(ran.error or "nothing was shown")
        self.seconds[mime] = time.monotonic() - self.began

    def megabytes(self, kind):
        first = psutil.Process(self.kernel.manager.provisioner.pid)
        return sum(getattr(p.memory_full_info(), kind)
                   for p in (first, *first.children())) / (1 << 20)


def alone():
    student = Student(time.monotonic())
    student.run(FORMULA, "text/latex")
    formula = student.megabytes("rss")
    student.run(PICTURE, "image/svg+xml")
    print(f"one kernel      formula after {student.seconds['text/latex']:.1f} s, {formula:.0f} MB; "
          f"with a picture {student.megabytes('rss'):.0f} MB")
    student.kernel.close()


def everyone(count):
    began = time.monotonic()

    def work(_):
        student = Student(began)
        student.run(FORMULA, "text/latex")
        student.run(PICTURE, "image/svg+xml")
        return student

    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        futures = [pool.submit(work, k) for k in range(count)]
        concurrent.futures.wait(futures)
    there = [f.result() for f in futures if not f.exception()]
    for f in futures:
        if f.exception():
            print(f"lost: {f.exception()}")
    total = sum(s.megabytes("pss") for s in there) / 1024
    each = sorted(s.megabytes("rss") for s in there)
    last = max((s.seconds["image/svg+xml"] for s in there), default=0)
    print(f"{count} at once      last picture after {last:.1f} s; {total:.1f} GB, "
          f"each {each[0]:.0f} to {each[-1]:.0f} MB; {count - len(there)} lost")
    for s in there:
        s.kernel.close()


alone()
everyone(int((sys.argv[1:] or ["30"])[0]))
