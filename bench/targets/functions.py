# SPDX-License-Identifier: Apache-2.0
"""Adds the counts of translated blocks up by function: nm -nC PROGRAM | python3 bench/targets/functions.py COUNTS"""

import bisect
import collections
import sys

MOST = 40  # lines

symbols = [line.rstrip("\n").split(" ", 2) for line in sys.stdin]
functions = [(int(address, 16) & ~1, name) for address, kind, name in symbols if kind in "tTwW"]
begins = [address for address, _ in functions]
own, calls = collections.Counter(), collections.Counter()
with open(sys.argv[1]) as counts:
    for line in counts:
        address, instructions, runs = int(line.split()[0], 16), *map(int, line.split()[1:])
        begin, name = functions[bisect.bisect_right(begins, address) - 1]
        own[name] += instructions * runs
        if begin == address:
            calls[name] += runs
total = sum(own.values())
for name, count in own.most_common(MOST):
    print(f"{count:14,} {count / total:6.1%} {calls[name]:11,} calls  {name}")
