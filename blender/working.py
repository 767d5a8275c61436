# SPDX-License-Identifier: GPL-3.0-or-later
"""Long work on a thread of its own, which tells how far it is and can be cancelled. Nothing here knows Blender."""

import threading

import mindeg


class _Cancelled(Exception):
    pass


class Work:
    """Runs ``task`` at once; its result, or its fault, is there when it is over."""

    def __init__(self, task):
        #: How far it is, in words.
        self.words = "mindeg is working"
        self.is_cancelled = False
        self._result, self._fault = None, None
        self._thread = threading.Thread(target=self._run, args=(task,), daemon=True)
        self._thread.start()

    def _run(self, task):
        try:
            with mindeg.progress(self._told):
                self._result = task()
        except _Cancelled:
            pass
        except Exception as fault:  # It is raised where the result is asked for.
            self._fault = fault

    def _told(self, stage, done, total):
        if self.is_cancelled:
            raise _Cancelled
        share = f" {100 * done // total} %" if total > 1 else ""
        self.words = f"mindeg: {stage}{share}"

    def cancel(self):
        """Ends it soon, without a result."""
        self.is_cancelled = True

    def is_over(self, wait=0.0):
        """Whether it is over, after at most so many seconds."""
        self._thread.join(wait)
        return not self._thread.is_alive()

    def result(self):
        """The result of the task. Raises what it raised."""
        if self._fault is not None:
            raise self._fault
        return self._result
