# SPDX-License-Identifier: Apache-2.0
"""One word to all threads: stop."""

import os
import select


class Stopped(Exception):
    """What was waited for is not waited for any longer."""


class Stop:
    """Once said, select finds it readable for good."""

    def __init__(self):
        self._event = os.eventfd(0)

    def fileno(self):
        return self._event

    def say(self):
        os.eventfd_write(self._event, 1)

    @property
    def said(self):
        return bool(select.select([self], [], [], 0)[0])
