"""Runs the tests of this folder; the last line is `N passed, N failed`."""

import os
import pathlib
import sys
import unittest

here = pathlib.Path(__file__).parent
os.environ["JUPYTER_PATH"] = str(pathlib.Path(sys.prefix) / "share" / "jupyter")
os.environ.setdefault("MECHANICS_KERNEL_MEMORY", "1G")
sys.path.insert(0, str(here))

suite = unittest.defaultTestLoader.discover(str(here), pattern=(sys.argv[1:] or ["test_*.py"])[0])


class Counting(unittest.TextTestResult):
    passed = 0

    def addSuccess(self, test):
        self.passed += 1
        super().addSuccess(test)


runner = unittest.TextTestRunner(stream=sys.stdout, verbosity=2, resultclass=Counting)
result = runner.run(suite)
failed = len({str(test) for test, _ in result.failures + result.errors})
skipped = f", {len(result.skipped)} skipped" if result.skipped else ""
print(f"{result.passed} passed, {failed} failed{skipped}")
sys.exit(bool(failed))
