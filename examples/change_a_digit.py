#!/usr/bin/env python3
"""A certificate with one digit of one proof changed, so that one can see it refused.

    examples/change_a_digit.py FILE > CHANGED

The digit is the last of the numerator of x of the first common point.
"""
import re
import sys

text = open(sys.argv[1], encoding="utf-8").read()
end = re.search(r'"verdict": "(?:meet|touching|overlapping)", "point": \["-?\d+', text).end()
print(text[:end - 1] + str((int(text[end - 1]) + 1) % 10) + text[end:], end="")
