#!/usr/bin/env python3
"""Tests of statements about sections and their areas against fractions: python3 verifier/python/tests/test_sections.py."""
import math
import unittest
from fractions import Fraction

from files import FORCED, MUTANT, Twins, dice_of, file_of, hexadecimal, lacking, main, some
from test_hulls import cross, dot, honest, minus
from test_meshes import some_solid


def double(x):
    return x.hex() if x else "0x0p+0"


def place(points, corner, heights):
    """A corner, as fractions."""
    i, j = corner
    if i == j:
        return tuple(map(Fraction, points[i]))
    part = Fraction(heights[i], heights[i] - heights[j])
    return tuple(x + part * (y - x) for x, y in zip(points[i], points[j]))


def section_of(points, faces, normal, level):
    """The corners and the faces along them, counter-clockwise from above; None where it is no polygon."""
    heights, after = [dot(normal, p) - level for p in points], {}
    for f, face in enumerate(faces):
        if not any(heights[k] for k in face):
            continue
        corners = [(i, i) for i in face if heights[i] == 0]
        corners += [(max(i, j, key=heights.__getitem__), min(i, j, key=heights.__getitem__))
                    for i, j in zip(face, face[1:] + face[:1]) if heights[i] * heights[j] < 0]
        if len(corners) != 2:
            continue
        p, q = (place(points, corner, heights) for corner in corners)
        out = cross(minus(points[face[1]], points[face[0]]), minus(points[face[2]], points[face[0]]))
        if dot(cross(normal, out), minus(q, p)) < 0:
            corners.reverse()
        if min(heights[k] for k in face) < 0 or min(heights) == 0:  # of an edge in the plane the face below it
            after[corners[0]] = corners[1], f
    corners = [min(after)] if after else []
    while corners and len(corners) <= len(after) and after.get(corners[-1], [None])[0] not in (None, corners[0]):
        corners.append(after[corners[-1]][0])
    if len(corners) < 3 or after.get(corners[-1], [None])[0] != corners[0]:
        return None
    return [list(c) for c in corners], [after[c][1] for c in corners], heights


def square_of_area(points, corners, heights, matrix):
    """Of the area of the polygon, mapped."""
    at = [place(points, corner, heights) for corner in corners]
    at = [tuple(dot(matrix[3 * r:3 * r + 3], p) for r in range(3)) for p in at]
    total = (0, 0, 0)
    for p, q in zip(at[1:], at[2:]):
        total = tuple(x + y for x, y in zip(total, cross(minus(p, at[0]), minus(q, at[0]))))
    return dot(total, total) / 4


def some_section(dice):
    """Bodies, the statements about the hull and a section, and the square of its area."""
    while True:
        points, faces = some_solid(dice)
        matrix, move = dice.choice([((1, 0, 0, 0, 1, 0, 0, 0, 1), (0, 0, 0)), ((0, -2, 0, 1, 0, 0, 0, 0, 1), (1, 2, 3))])
        normal = tuple(dice.randint(-2, 2) for _ in range(3))
        level = dice.randint(-3, 3)
        pulled = tuple(dot(normal, matrix[c::3]) for c in range(3))
        found = any(normal) and section_of(points, faces, pulled, level - dot(normal, move))
        if found:
            break
    top = honest(points)
    bodies = top["tables"]["bodies"] + [{"name": "placed", "of": 0, "linear": [hexadecimal(x) for x in matrix],
                                         "translation": [hexadecimal(x) for x in move]}]
    corners, along, heights = found
    statement = {"question": "section", "of": 1, "plane": [hexadecimal(x) for x in (*normal, 0, 0, 0, level)],
                 "verdict": "measured", "corners": corners, "claims": [{"claim": "outlined", "along": along}, {"claim": "area"}]}
    return bodies, top["statements"][0], statement, square_of_area(points, corners, heights, matrix)


class SectionsTest(unittest.TestCase):
    def test_an_area_is_between_numbers_where_it_is(self):
        dice, twins, accepted = dice_of(1), Twins(self), 0
        while "measured" in lacking(FORCED, "section"):
            bodies, hull, statement, square = some_section(dice)
            about = math.sqrt(square)
            for low, high in ((1 - 2 ** -50, 1 + 2 ** -50), (1 + 2 ** -50, 2), (0, 1 - 2 ** -50), (1, 1),
                              (dice.uniform(.99, 1.01), dice.uniform(.99, 1.01))):
                ends = [about * low, about * high]
                said = twins.force(file_of({"bodies": bodies}, hull, {
                    **statement, "area_from": double(ends[0]), "area_to": double(ends[1])}))
                truth = Fraction(ends[0]) ** 2 <= square <= Fraction(ends[1]) ** 2
                self.assertTrue(truth or said == "area", twins.last)
                is_wide = Fraction(ends[0]) ** 2 * (1 + Fraction(1, 2 ** 55)) < square < Fraction(ends[1]) ** 2 * (1 - Fraction(1, 2 ** 55))
                self.assertTrue(said == "accepted" or not is_wide, twins.last)
                accepted += said == "accepted"
        twins.compare()
        self.assertTrue(some(100) < 100 or accepted > twins.count / 10)

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(2), Twins(self)
        while "measured" in lacking(MUTANT, "section"):
            bodies, hull, statement, _ = some_section(dice)
            twins.spoil(file_of({"bodies": bodies}, hull, {**statement, "area_from": "0x0p+0", "area_to": "0x1p+9"}), dice)
        twins.compare()


if __name__ == "__main__":
    main()
