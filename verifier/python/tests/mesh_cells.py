"""Solids of unit cells as meshes, with what is true of them by their cells."""
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


def together(p, cells):
    """Is a point in a closed cell of a solid? It is in one or two along each axis."""
    return any(cell in cells for cell in itertools.product(*({math.floor(x), math.ceil(x) - 1} for x in p)))


class Given:
    """A solid of cells, at a place that is a multiple of a power of two, told as a mesh or as the image of one."""

    def __init__(self, name, cells, shift, dice, step=Fraction(1)):
        self.name, self.cells, self.shift, self.step = name, cells, shift, step
        self.points, self.triangles = boundary(cells, dice)
        throw = dice.random()  # turned inside out; or some triangles turned, so that only a parity tells
        self.triangles = [t[::-1] if throw < .1 or (throw < .2 and dice.random() < .3) else t for t in self.triangles]
        self.is_image = dice.random() < .5

    def places(self):
        return [[self.step * (x + s) for x, s in zip(p, self.shift)] for p in self.points]

    def entries(self, base):
        linear = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]  # a turn: x, y, z become z, x, y
        points = [[p[1], p[2], p[0]] for p in self.points] if self.is_image else self.places()
        shown = [[hexadecimal(Fraction(x)) for x in p] for p in points]
        mesh = {"name": self.name, "points": shown, "triangles": self.triangles}
        if not self.is_image:
            return [mesh]
        return [mesh, {"name": self.name, "of": base, "linear": [hexadecimal(self.step * n) for row in linear for n in row],
                       "translation": [hexadecimal(self.step * s) for s in self.shift]}]

    def is_in(self, p):
        return together([x / self.step - s for x, s in zip(p, self.shift)], self.cells)


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
    places = a.places(), b.places()

    def part(of, first, end):
        return [places[of][corner] for t in (a, b)[of].triangles[first:end] for corner in t]

    def found(of_a, of_b):
        corners = part(0, *of_a), part(1, *of_b)
        gaps = [box_gap([p[c] for p in corners[0]], [p[c] for p in corners[1]]) for c in range(3)]
        axes = [[(g > 0) - (g < 0) if k == c else 0 for k in range(3)] for c, g in enumerate(gaps) if g and g * g >= square]
        return axes or ([gaps] if square and sum(g * g for g in gaps) >= square else [])
    return walk(a, b, found, dice)


def box_gap(of_a, of_b):
    """From A to B along an axis: how far it is from numbers of the one to those of the other; 0 where they overlap."""
    return max(min(of_b) - max(of_a), 0) or min(max(of_b) - min(of_a), 0)


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
    tree = {"cuts": [], "planes": [], "cells": []}
    truth = []

    def middles(box):
        spans = [[(x + y) / 2 for x, y in zip(marks[c][i:j], marks[c][i + 1:j + 1])] for c, (i, j) in enumerate(box)]
        return [*itertools.product(*spans)]

    waiting = [[(0, len(m) - 1) for m in marks]]
    while waiting:
        box = waiting.pop()
        if len(truth) + len(waiting) >= most:
            return None
        places = middles(box)
        first = a.is_in(places[0]), b.is_in(places[0])
        if all((a.is_in(p), b.is_in(p)) == first for p in places):
            tree["cuts"].append(0)
            tree["cells"].append(told_point(dice.choice(places)))
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
        b = Given("b", {(0, 0, 0)}, [Fraction(4 * n + 1, 4) + s for n, s in zip(cell, a.shift)], dice, step)
        b.points = [[Fraction(x, 2) for x in p] for p in b.points]
        b.is_image = False
        b.is_in = lambda p: all(s <= x / step <= s + Fraction(1, 2) for x, s in zip(p, b.shift))
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
