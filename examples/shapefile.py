#!/usr/bin/env python3
"""The polygons of an ESRI shapefile as WKT, one a line, with all digits: examples/shapefile.py FILE.shp > file.wkt

Rings are in the order of the file; a part turned clockwise begins a polygon, the others are its holes. A record of
several polygons becomes a MULTIPOLYGON. Null records are left out.
Format: ESRI Shapefile Technical Description, July 1998.
"""
import struct
import sys


def rings_of(content):
    parts, points = struct.unpack_from("<2i", content, 36)
    begins = struct.unpack_from("<%di" % parts, content, 44) + (points,)
    numbers = struct.unpack_from("<%dd" % (2 * points), content, 44 + 4 * parts)
    corners = list(zip(numbers[::2], numbers[1::2]))
    return [corners[begins[k]:begins[k + 1]] for k in range(parts)]


def is_clockwise(ring):
    return sum((x2 - x1) * (y2 + y1) for (x1, y1), (x2, y2) in zip(ring, ring[1:])) > 0


def text(polygon):
    return "(%s)" % ", ".join("(%s)" % ", ".join("%r %r" % p for p in ring) for ring in polygon)


def main():
    data = open(sys.argv[1], "rb").read()
    at = 100
    while at < len(data):
        (words,) = struct.unpack_from(">i", data, at + 4)
        content = data[at + 8:at + 8 + 2 * words]
        at += 8 + 2 * words
        kind = struct.unpack_from("<i", content)[0]
        if kind == 0:
            continue
        if kind != 5:
            sys.exit("a shape of type %d; only polygons (5) are read" % kind)
        polygons = []
        for ring in rings_of(content):
            if is_clockwise(ring) or not polygons:
                polygons.append([])
            polygons[-1].append(ring)
        if len(polygons) == 1:
            print("POLYGON " + text(polygons[0]))
        else:
            print("MULTIPOLYGON (%s)" % ", ".join(text(p) for p in polygons))


if __name__ == "__main__":
    main()
