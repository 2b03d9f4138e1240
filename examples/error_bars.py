#!/usr/bin/env python3
"""A measured series as half-planes: the lines through all of its error bars are the points of their common part.

    examples/error_bars.py ORIGIN [LAST] < series.csv > half-planes.csv

Reads lines "t, value, uncertainty" after a line of names, up to t = LAST. Through the bar at t goes the line
value = m (t - ORIGIN) + q iff value - uncertainty <= m (t - ORIGIN) + q <= value + uncertainty: two half-planes
a m + b q <= c, written a,b,c,name. Sums are made in decimals, so what is written is exactly what was measured.
"""
import csv
import sys
from decimal import Decimal


def main():
    origin = Decimal(sys.argv[1])
    last = Decimal(sys.argv[2]) if len(sys.argv) > 2 else None
    rows = csv.reader(sys.stdin)
    next(rows)
    print("a,b,c,name")
    for row in rows:
        if not row:
            continue
        t, value, uncertainty = (Decimal(field) for field in row[:3])
        if last is not None and t > last:
            break
        print("%s,1,%s,%s above" % (t - origin, value + uncertainty, t))
        print("%s,-1,%s,%s below" % (origin - t, uncertainty - value, t))


if __name__ == "__main__":
    main()
