#!/usr/bin/env python3
"""A certificate with one digit of one proof changed, so that one can see it refused.

    examples/change_a_digit.py FILE > CHANGED

The digit is the last of the numerator of x of the first common point.
"""
import re
import sys

text = open(sys.argv[1], encoding="utf-8").read()
found = re.search(r'"verdict": "(?:meet|touching|overlapping)", "point": \["-?(?:0x([0-9a-f]+)|\d+)', text)
end, base = found.end(), 16 if found[1] else 10
print(text[:end - 1] + "%x" % ((int(text[end - 1], base) + 1) % base) + text[end:], end="")
