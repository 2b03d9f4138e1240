#!/usr/bin/env python3
"""Draws a run of the walk between two spaces: reads what build/tools/polar_run prints, writes an SVG.

    build/tools/polar_run bipyramid 4096 1e-9 5 | docs/images/plot_polar_run.py > docs/images/polar-run.svg
"""
import math
import sys

COLOUR = {"plane": "#0072b2", "point": "#d55e00"}  # of Okabe and Ito
WIDTH, LEFT, TOP, SIDE, DEEP, LEFT2, SIDE2 = 960, 80, 80, 400, 400, 610, 330
HEIGHT = TOP + DEEP + 135


def text(x, y, words, more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" {more}>{words}</text>'


def line(x1, y1, x2, y2, colour="#dddddd", more=""):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" {more}/>'


def mark(x, y, space, held):
    if space == "primal":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{COLOUR[held]}"/>'
    if space == "polar":
        return f'<rect x="{x - 4.5:.1f}" y="{y - 4.5:.1f}" width="9" height="9" fill="{COLOUR[held]}"/>'
    return f'<path d="M{x:.1f} {y - 7:.1f}l6 11h-12z" fill="{COLOUR[held]}"/>'


def staircase(most_p, most_q, answer, rounds):
    def x(level):
        return LEFT + level / most_p * SIDE

    def y(level):
        return TOP + level / most_q * DEEP

    out = [text(LEFT, TOP - 56, "How far down both hierarchies", 'font-weight="bold"'),
           text(LEFT, TOP - 34, f"level of P: 0 a tetrahedron inside, {most_p} all of P"),
           text(0, 0, f"level of the polar of R: 0 a tetrahedron around, {most_q} all of R",
                f'transform="translate({LEFT - 44} {TOP + DEEP}) rotate(-90)"')]
    for level in range(most_p + 1):
        out.append(line(x(level), TOP, x(level), TOP + DEEP))
        if level % 2 == 0 or most_p < 16:
            out.append(text(x(level), TOP - 12, level, 'text-anchor="middle"'))
    for level in range(most_q + 1):
        out.append(line(LEFT, y(level), LEFT + SIDE, y(level)))
        if level % 2 == 0:
            out.append(text(LEFT - 12, y(level) + 4, level, 'text-anchor="end"'))
    at = [(x(r[2]), y(r[3])) for r in rounds]
    for before, a, b in zip(rounds, at, at[1:]):
        out.append(line(*a, *b, COLOUR[before[1]], 'stroke-width="3"'))
    end = (LEFT + SIDE, at[-1][1]) if answer == "apart" else (at[-1][0], TOP + DEEP)
    if at[-1] != end:
        out.append(line(*at[-1], *end, COLOUR[rounds[-1][1]], 'stroke-width="3" stroke-dasharray="2 3"'))
    for k, (r, (u, v)) in enumerate(zip(rounds, at)):
        out.append(mark(u, v, r[0], r[1]))
        # Numbers keep off the lines: above where one comes to the right, to the right where one comes down.
        out.append(text(u, v - 9, k, 'text-anchor="middle" font-size="11"') if r[0] == "primal" else
                   text(u + 9, v + (14 if r[1] == "plane" else 4), k, 'font-size="11"'))
    out.append(text(*((end[0] + 10, end[1] + 5) if answer == "apart" else (end[0] - 16, end[1] + 22)), answer,
                    'font-weight="bold"'))
    return out


def apart(u, v):
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(u, v)))


def moves(rounds):
    """How far what holds after a round is from what holds in the end."""
    far_of = {}  # of each that holds: round, space, power of ten
    for held in COLOUR:
        places = [(k, r[0], r[4]) for k, r in enumerate(rounds) if r[1] == held]
        if held == "plane":
            places = [(k, space, [c / apart(n, [0, 0, 0]) for c in n]) for k, space, n in places]
        last = places[-1][2] if places else None
        far = [(k, space, apart(at, last) / apart(last, [0, 0, 0])) for k, space, at in places[:-1]]
        if held == "plane":
            far = [(k, space, 2 * math.asin(min(1, d / 2))) for k, space, d in far]
        far_of[held] = [(k, space, math.log10(d)) for k, space, d in far if d > 0]
    powers = [power for of in far_of.values() for k, space, power in of] or [0]
    low, high = math.floor(min(powers)), math.floor(max(powers)) + 1

    def x(k):
        return LEFT2 + k / (len(rounds) - 1) * SIDE2

    def y(power):
        return TOP + (high - power) / (high - low) * DEEP

    out = [text(LEFT2 - 50, TOP - 56, "How the plane and the point settle", 'font-weight="bold"'),
           text(LEFT2 - 50, TOP - 34, "blue: angle to the last plane (radians)"),
           text(LEFT2 - 50, TOP - 16, "red: distance from the last point, over its size")]
    for power in range(low, high + 1):
        out += [line(LEFT2, y(power), LEFT2 + SIDE2, y(power)),
                text(LEFT2 - 8, y(power) + 4, f"{10.0 ** power:g}", 'text-anchor="end"')]
    for k in range(0, len(rounds), 2):
        out.append(text(x(k), TOP + DEEP + 18, k, 'text-anchor="middle"'))
    out.append(text(LEFT2, TOP + DEEP + 38, "round"))
    for held, of in far_of.items():
        path = " ".join(f"{x(k):.1f},{y(power):.1f}" for k, space, power in of)
        out.append(f'<polyline points="{path}" fill="none" stroke="{COLOUR[held]}"/>')
        out += [mark(x(k), y(power), space, held) for k, space, power in of]
    return out


def main():
    words = [w.split() for w in sys.stdin]
    if len(words) < 3 or words[0][0] != "levels":
        sys.exit("plot_polar_run.py: no run on standard input")
    rounds = [(w[0], w[1], int(w[2]), int(w[3]), [float(c) for c in w[4:]]) for w in words[1:]]
    answer = words[0][3]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
           'font-family="sans-serif" font-size="13">', "<title>A run of the walk between two spaces</title>",
           '<rect width="100%" height="100%" fill="white"/>']
    out += staircase(int(words[0][1]) - 1, int(words[0][2]) - 1, answer, rounds) + moves(rounds)
    low = TOP + DEEP + 66
    for k, (held, words_of) in enumerate((("plane", "a plane parts them so far: P goes on"),
                                          ("point", "they have a point so far: R goes on"))):
        out += [line(LEFT, low + 24 * k - 4, LEFT + 26, low + 24 * k - 4, COLOUR[held], 'stroke-width="3"'),
                text(LEFT + 34, low + 24 * k, words_of)]
    for k, (space, words_of) in enumerate((("primal", "round in the primal space: a vertex of P came beyond the plane"),
                                           ("polar", "round in the polar space: a half-space of R cut the point off"),
                                           ("top", "the beginning: both tetrahedra"))):
        out += [mark(LEFT + 340, low + 24 * k - 4, space, "plane").replace(COLOUR["plane"], "#666666"),
                text(LEFT + 354, low + 24 * k, words_of)]
    out.append(text(LEFT, low + 48, "dotted, if any: further levels change nothing"))
    print("\n".join(out) + "\n</svg>")


main()
