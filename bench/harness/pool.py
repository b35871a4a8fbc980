# SPDX-License-Identifier: Apache-2.0
"""Several cores at once: a thread for each takes the next item; the first failure ends them all."""

from concurrent.futures import ThreadPoolExecutor, as_completed

from harness.stop import Stop


class Pool:
    def __init__(self, cores):
        self.cores = cores
        self.stop = Stop()  # said when an item failed or the main thread was interrupted: whoever waits should end

    def each(self, items, work):
        """Does work(item, core) for each item, begun in order; returns when all are done."""
        remaining = iter(list(items))

        def take(core):
            for item in remaining:
                if self.stop.said:
                    return
                work(item, core)

        with ThreadPoolExecutor(len(self.cores)) as threads:
            try:
                for finished in as_completed([threads.submit(take, core) for core in self.cores]):
                    finished.result()
            except BaseException:
                self.stop.say()
                raise
