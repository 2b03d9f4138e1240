"""Solids of unit cells as meshes, with what is true of them by their cells."""
import functools
import itertools
import math
from fractions import Fraction

from files import fraction, hexadecimal

AXES = [tuple(int(a == b) for b in range(3)) for a in range(3)]


def boundary(cells, dice):
    """Of a solid of unit cells: its points, and two triangles for each side of a cell that has no other cell beyond it,
    counterclockwise as seen from outside."""
    points, triangles = {}, []
    for cell, axis, way in itertools.product(sorted(cells), range(3), (0, 1)):
        beyond = tuple(x + (a == axis) * (1 if way else -1) for a, x in enumerate(cell))
        if beyond in cells:
            continue
        u, v = AXES[(axis + 1) % 3], AXES[(axis + 2) % 3]
        start = tuple(x + (a == axis) * way for a, x in enumerate(cell))
        ring = [tuple(s + j * x + k * y for s, x, y in zip(start, u, v)) for j, k in ((0, 0), (1, 0), (1, 1), (0, 1))]
        ring = [points.setdefault(p, len(points)) for p in (ring if way else ring[::-1])]
        turn = dice.randrange(4)
        ring = ring[turn:] + ring[:turn]
        triangles += [[ring[0], ring[1], ring[2]], [ring[0], ring[2], ring[3]]]
    dice.shuffle(triangles)
    return [list(p) for p in points], triangles


def some_cells(dice, size):
    """Cells of a cube of so many: some, or a shell around a hole."""
    cube = [*itertools.product(range(size), repeat=3)]
    if dice.random() < .3:
        return {cell for cell in cube if any(x in (0, size - 1) for x in cell)}
    return set(dice.sample(cube, dice.randint(1, max(1, len(cube) // 3))))


class Given:
    """A solid of cells, at a place that is a multiple of a power of two, told as a mesh or as the image of one."""

    def __init__(self, name, cells, shift, dice, step=Fraction(1)):
        self.name, self.cells, self.shift, self.step = name, cells, shift, step
        self.points, self.triangles = boundary(cells, dice)
        throw = dice.random()  # turned inside out; or some triangles turned, so that only a parity tells
        self.triangles = [t[::-1] if throw < .1 or (throw < .2 and dice.random() < .3) else t for t in self.triangles]
        self.is_image = dice.random() < .5
        self._places = [[self.step * (x + s) for x, s in zip(p, self.shift)] for p in self.points]

    def places(self):
        return self._places

    def triangle_boxes(self):
        """Around each triangle, for each axis the least and the greatest coordinate."""
        return [[[f(self._places[k][c] for k in t) for f in (min, max)] for c in range(3)] for t in self.triangles]

    def entries(self, base):
        linear = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]  # a turn: x, y, z become z, x, y
        points = [[p[1], p[2], p[0]] for p in self.points] if self.is_image else self.places()
        shown = [[hexadecimal(Fraction(x)) for x in p] for p in points]
        mesh = {"name": self.name, "points": shown, "triangles": self.triangles}
        if not self.is_image:
            return [mesh]
        return [mesh, {"name": self.name, "of": base, "linear": [hexadecimal(self.step * n) for row in linear for n in row],
                       "translation": [hexadecimal(self.step * s) for s in self.shift]}]

    def layers(self, c, x):
        """The one or two layers of cells across an axis that a coordinate is in."""
        x = x / self.step - self.shift[c]
        return {math.floor(x), math.ceil(x) - 1}

    def is_in_layers(self, layers):
        return any(cell in self.cells for cell in itertools.product(*layers))

    def is_in(self, p):
        """Is a point in a closed cell?"""
        return self.is_in_layers([self.layers(c, x) for c, x in enumerate(p)])


def walk(a, b, found, dice):
    """Cuts and directions down the pairs of parts of two meshes; found(part of A, part of B): the directions that part them.
    None where two triangles have none."""
    cuts, directions, pairs = [], [], [((0, len(a.triangles)), (0, len(b.triangles)))]
    while pairs:
        of_a, of_b = pairs.pop()
        ways = found(of_a, of_b)
        if ways:
            cuts.append(0)
            directions.append(told_point(dice.choice(ways)))
            continue
        sizes = of_a[1] - of_a[0], of_b[1] - of_b[0]
        if max(sizes) == 1:
            return None
        which = sizes[1] > sizes[0]
        first, end = (of_a, of_b)[which]
        middle = dice.randint(first + 1, end - 1)
        cuts.append(-middle if which else middle)
        for half in (middle, end), (first, middle):
            pairs.append((of_a, half) if which else (half, of_b))
    return cuts, directions


def cover(a, b, dice, square=0):
    """The walk, where each pair of triangles that are apart is so along an axis, which it is of sides of cells; or that far
    apart, squared, along the way between the boxes around both parts."""
    boxes = a.triangle_boxes(), b.triangle_boxes()
    unit = math.lcm(*(x.denominator for those in boxes for box in those for side in box for x in side))
    boxes = [[[[int(x * unit) for x in side] for side in box] for box in those] for those in boxes]
    square *= unit * unit

    @functools.cache
    def part(of, first, end):
        those = boxes[of][first:end]
        return [[min(box[c][0] for box in those), max(box[c][1] for box in those)] for c in range(3)]

    def found(of_a, of_b):
        gaps = [box_gap(*sides) for sides in zip(part(0, *of_a), part(1, *of_b))]
        axes = [[(g > 0) - (g < 0) if k == c else 0 for k in range(3)] for c, g in enumerate(gaps) if g and g * g >= square]
        return axes or ([gaps] if square and sum(g * g for g in gaps) >= square else [])
    return walk(a, b, found, dice)


def box_gap(of_a, of_b):
    """From A to B along an axis: how far it is from the one's least to greatest coordinate to the other's; 0 where they overlap."""
    return max(of_b[0] - of_a[1], 0) or min(of_b[1] - of_a[0], 0)


def direction(dice):
    return [str(dice.choice((-1, 1)) * dice.randint(1, 10 ** 4)) for _ in range(3)]


def pieces(given):
    """A triangle of each."""
    parent = [*range(len(given.points))]

    def find(i):
        while parent[i] != i:
            i = parent[i]
        return i
    for i, j, k in given.triangles:
        parent[find(i)] = find(j)
        parent[find(j)] = find(k)
    return {find(t[0]): n for n, t in enumerate(given.triangles)}.values()


def divided(a, b, dice, most):
    """A tree of planes across the axes, at places of corners, down to boxes that are each all in or all outside of a, and
    of b; with a point of each, and where it is. None, where there are more boxes than that."""
    marks = [sorted({Fraction(p[c]) for of in (a, b) for p in of.places()}) for c in range(3)]
    marks = [[m[0] - 1, *m, m[-1] + 1] for m in marks]
    middles = [[(x + y) / 2 for x, y in zip(m, m[1:])] for m in marks]
    layers = [[[of.layers(c, x) for x in middles[c]] for c in range(3)] for of in (a, b)]
    tree = {"cuts": [], "planes": [], "cells": []}
    truth = []

    @functools.cache
    def told(spot):
        return tuple(of.is_in_layers(those[c][k] for c, k in enumerate(spot)) for of, those in zip((a, b), layers))

    waiting = [[(0, len(m) - 1) for m in marks]]
    while waiting:
        box = waiting.pop()
        if len(truth) + len(waiting) >= most:
            return None
        spots = [*itertools.product(*(range(i, j) for i, j in box))]
        first = told(spots[0])
        if all(told(spot) == first for spot in spots):
            tree["cuts"].append(0)
            tree["cells"].append(told_point(middles[c][k] for c, k in enumerate(dice.choice(spots))))
            truth.append(first)
            continue
        axis = dice.choice([c for c, (i, j) in enumerate(box) if j - i > 1])
        at = dice.randrange(box[axis][0] + 1, box[axis][1])
        way = dice.choice((1, -1, 3))  # the same plane, and what is above it
        tree["cuts"].append(1)
        tree["planes"].append([str(way * (c == axis)) for c in range(3)] + [fraction(way * marks[axis][at])])
        high, low = [*box], [*box]
        high[axis], low[axis] = (at, box[axis][1]), (box[axis][0], at)
        waiting += [low, high] if way > 0 else [high, low]
    return tree, truth


def told_point(p):
    return [fraction(Fraction(x)) for x in p]


def inside(given, dice):
    """A point of a triangle, and the claim that it is one."""
    t = dice.randrange(len(given.triangles))
    weights = [Fraction(dice.randint(0, 4)) for _ in range(3)]
    weights[dice.randrange(3)] += 1
    total, places = sum(weights), given.places()
    named = [(k, w / total) for k, w in zip(given.triangles[t], weights)]
    point = [sum(w * places[k][c] for k, w in named) for c in range(3)]
    return point, {"claim": "on_triangle", "triangle": t, "weights": [[k, fraction(w)] for k, w in named]}


def some_pair(dice):
    """Two solids, beside each other, in each other, or of some of the same cells."""
    step = Fraction(2) ** dice.choice((-60, -1, 0, 0, 40))
    size = dice.choice((1, 1, 2, 3))
    a = Given("a", some_cells(dice, size), [dice.randint(-2, 2) for _ in range(3)], dice, step)
    if dice.random() < .4:  # half as large, in a cell of A or in a hole of it
        cell = dice.choice([*a.cells]) if dice.random() < .6 else [dice.randrange(size) for _ in range(3)]
        b = Given("b", {(0, 0, 0)}, [2 * (Fraction(4 * n + 1, 4) + s) for n, s in zip(cell, a.shift)], dice, step / 2)
        return (a, b) if dice.random() < .5 else (b, a)
    if dice.random() < .4:  # the same cells, some of them, or others of the same cube
        cells, cube = a.cells, {*itertools.product(range(size), repeat=3)}
        other = dice.choice(({*cells}, {*dice.sample(sorted(cells), dice.randint(1, len(cells)))}, cube - cells or {(1, 1, 0)}))
        b = Given("b", other, a.shift, dice, step)
        return (a, b) if dice.random() < .5 else (b, a)
    gap = dice.choice((0, 0, Fraction(1, 2 ** 20), Fraction(1, 2), 3))
    axis = dice.randrange(3)
    shift = [dice.randint(-4, 4) + (gap if c == axis else 0) for c in range(3)]
    return a, Given("b", some_cells(dice, dice.choice((1, 1, 2))), shift, dice, step)


def tables_of(a, b):
    """The table of both; and which of its entries they are."""
    entries = a.entries(0)
    first = len(entries) - 1
    entries += b.entries(len(entries))
    return {"meshes": entries}, first, len(entries) - 1
