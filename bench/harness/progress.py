# SPDX-License-Identifier: Apache-2.0
"""How far a measurement is and how long it will still take: a line that a terminal rewrites, else one a round."""

import sys
import time


def shown_duration(seconds):
    if seconds < 90:
        return f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 90 else f"{minutes / 60:.1f} h"


class Progress:
    """Counts runs; time left is estimated from those that this session made itself."""

    def __init__(self, stream=sys.stderr):
        self.stream = stream
        self._to_make = 0
        self._made = 0
        self._begin = time.monotonic()

    def say(self, text):
        self.stream.write(("\r\033[K" if self.stream.isatty() else "") + text + "\n")
        self.stream.flush()

    def expect(self, runs):
        """At most that many, from now on: cells may be given up."""
        self._to_make = runs
        self._made = 0
        self._begin = time.monotonic()

    def made(self, what):
        self._made += 1
        if self.stream.isatty():
            self.stream.write(f"\r\033[K{self._how_far()} {what}")
            self.stream.flush()

    def end_round(self, number):
        self.say(f"{self._how_far()} round {number}")

    def _how_far(self):
        if not self._made:
            return f"[0 of {self._to_make} runs]"
        left = (time.monotonic() - self._begin) / self._made * max(self._to_make - self._made, 0)
        return f"[{self._made} of at most {self._to_make} runs, {shown_duration(left)} left]"
