"""Files that are too long to be written into the data: `make = {"file" = "name 1 2"}` calls name(1, 2)."""
import math
import os
import random
import struct

CASES = os.environ.get("SUNDER_CASES_DIR") or os.path.join(os.path.dirname(__file__), "..", "..", "cases")


def _polygon(rings):
    return "POLYGON (%s)\n" % ", ".join("(%s)" % ", ".join("%f %f" % p for p in ring) for ring in rings)


def pie(count):
    """Slices about one point, neighbours of which share a side."""
    rim = [(1000 * math.cos(2 * math.pi * k / count), 1000 * math.sin(2 * math.pi * k / count)) for k in range(count)]
    return "".join(_polygon([[(0, 0), rim[k], rim[(k + 1) % count], (0, 0)]]) for k in range(count))


def frames(count):
    """Frames around one another: none meets another."""
    def square(d):
        return [(-d, -d), (d, -d), (d, d), (-d, d), (-d, -d)]
    return "".join(_polygon([square(k), square(k - 0.5)]) for k in range(1, count + 1))


def nested_holes(side):
    """One polygon: side^2 holes, and in each of them another one."""
    def square(x, y, half):
        return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half), (x - half, y - half)]
    places = [(x, y) for x in range(side) for y in range(side)]
    middle = (side - 1) / 2
    return _polygon([square(middle, middle, side)] + [square(x, y, half) for x, y in places for half in (0.4, 0.2)])


def sphere(dimension, count, seed):
    """Points of a sphere, as CSV."""
    source, text = random.Random(seed), ""
    for _ in range(count):
        p = [source.uniform(-1, 1) for _ in range(dimension)]
        text += ",".join("%f" % (x / math.hypot(*p)) for x in p) + "\n"
    return text


def rails(count):
    """Placements of two boxes on rails, and an arm that turns twice."""
    return "to_x,to_y,to_arm\n" + "".join("%d,%d,%d\n" % (k * 7 % 11 - 5, k * 5 % 7 - 3, k % 50 == 0) for k in range(count))


def box_npy(how):
    """The case box.npy, made wrong."""
    with open(os.path.join(CASES, "polytopes", "box.npy"), "rb") as stream:
        data = stream.read()
    return {"cut": data[:-1], "nan": data[:-8] + struct.pack("<d", math.nan), "wide": data.replace(b"(8, 5)", b"(4,10)"),
            "complex": data.replace(b"<f8", b"<c8"), "none": b"no array"}[how]


def poses_npy():
    """Two placements of two joints in single precision."""
    header = "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 2), }".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00\x76\x00" + header.encode() + struct.pack("<4f", -1.5, 1.5, -1.75, 1.5)


def bends(count):
    """Values of four joints of the arm that sweep them; every tenth row or so is folded into itself."""
    text = "panda_joint2,panda_joint4,panda_joint6,panda_joint1\n"
    for k in range(count):
        part = k * 37 % 100 / 100
        text += "%f,%f,%f,%f\n" % (-1.7 + 3.4 * part, -3.0 + 2.9 * part * part, 3.7 * part, k / 500)
    return text


def bends_of_three(count):
    """The same of three joints."""
    return "".join(line.rpartition(",")[0] + "\n" for line in bends(count).splitlines())


def far(count, at):
    """Values of one joint, of which one is too large."""
    return "j\n" + "".join("1e308\n" if k == at else "1\n" for k in range(count))


def through_one_point(count):
    """Segments that cross in the origin, as CSV; no two on one line."""
    return "x1,y1,x2,y2\n" + "".join("%d,%d,%d,%d\n" % (-count, -k, count, k) for k in range(count))


def flower(petals):
    """A ring that comes to the origin once for each petal."""
    ring = []
    for k in range(petals):
        turns = [2 * math.pi * (k + part) / petals for part in (0, 0.5)]
        ring += [(0, 0)] + [(math.cos(t), math.sin(t)) for t in turns]
    return "POLYGON ((%s))\n" % ", ".join("%r %r" % p for p in ring + [(0, 0)])


def letters(count):
    return "x" * count
