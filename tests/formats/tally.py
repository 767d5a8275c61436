"""Counts checks and prints a line for each; the last line is what `run` adds up."""

import sys


class Tally:
    def __init__(self):
        self.passed = self.failed = 0

    def record(self, name, is_right, what=""):
        if is_right:
            self.passed += 1
            print(f"ok      {name}")
        else:
            self.failed += 1
            print(f"FAILED  {name}: {what}", flush=True)

    def attempt(self, name, work, *arguments):
        """The result of the work; an exception is a check that failed."""
        try:
            result = work(*arguments)
        except Exception as problem:
            self.record(name, False, f"{type(problem).__name__}: {' '.join(str(problem).split())[:300]}")
            return None
        self.record(name, True)
        return result

    def finish(self):
        print(f"{self.passed} passed, {self.failed} failed")
        sys.exit(1 if self.failed else 0)
