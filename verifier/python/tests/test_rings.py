#!/usr/bin/env python3
"""Tests of statements about simple rings against brute force: python3 verifier/python/tests/test_rings.py."""
import unittest

from files import FORCED, MUTANT, Twins, dice_of, file_of, hexadecimal, lacking, main, some
from test_polygons import edges_of
from test_segments import forced, sweep
from test_valid import is_valid


def some_ring(dice):
    """Of some area, as the table wants it."""
    while True:
        ring = [(dice.randint(0, 4), dice.randint(0, 4)) for _ in range(dice.choice([3, 4, 4, 5, 6]))]
        steps = list(zip(ring, ring[1:] + ring[:1]))
        if all(p != q for p, q in steps) and sum(p[0] * q[1] - p[1] * q[0] for p, q in steps):
            return ring


def statement_of(ring, events):
    rows = [[[hexadecimal(x), hexadecimal(y)] for x, y in one] for one in ([(0, 0), (9, 0), (0, 9)], ring)]
    return file_of({"rings": rows}, {"question": "ring", "ring": 1, "verdict": "simple",
                                     "claims": [{"claim": "valid", "events": events}]})


class RingsTest(unittest.TestCase):
    def test_simple_are_those_that_are(self):
        dice, twins, simple = dice_of(1), Twins(self), 0
        for _ in range(some(400)):
            ring = some_ring(dice)
            truth = is_valid([[ring]], "simple")
            simple += truth
            said = twins.force(statement_of(ring, sweep(edges_of([ring]))))
            self.assertEqual(said, "accepted" if truth else "valid", ring)
        twins.compare()
        self.assertTrue(some(100) < 100 or simple > twins.count / 10)

    def test_no_forced_sweep_proves_what_is_not_so(self):
        dice, twins = dice_of(2), Twins(self)
        while lacking(FORCED, "ring"):
            ring = some_ring(dice)
            truth, edges = is_valid([[ring]], "simple"), edges_of([ring])
            for _ in range(3):
                said = twins.force(statement_of(ring, forced(sweep(edges), edges, dice)))
                self.assertTrue(truth or said != "accepted", twins.last)
        twins.compare()

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, "ring"):
            ring = some_ring(dice)
            twins.spoil(statement_of(ring, sweep(edges_of([ring]))), dice)
        twins.compare()


if __name__ == "__main__":
    main()
