#!/usr/bin/env python3
"""Circles on a sphere as circles of the plane: a stereographic projection keeps circles circles.

    examples/stereographic.py RADIUS_KM LATITUDE LONGITUDE [DEGREES] < craters.csv > circles.csv

Reads lines "diameter in km, latitude, longitude" in degrees (and, if there is one, a name), after a line of names;
diameters are measured along the sphere. Writes lines x,y,r in km, as seen from above the given point, with distances
true there. Circles that reach further than DEGREES from that point are left out, and counted; without it those that
hold its antipode, which have no image that is a disc.
What meets on the sphere meets in the plane, but for the rounding of the coordinates written.
"""
import csv
import math
import sys


def project(diameter, latitude, longitude, radius, latitude_0, longitude_0, furthest):
    """The image's centre and radius, or None."""
    half = diameter / (2 * radius)
    phi, phi_0, l = (math.radians(v) for v in (latitude, latitude_0, longitude - longitude_0))
    # Where the centre is, seen from the middle of the map: east, north, and away along the sphere.
    east = math.cos(phi) * math.sin(l)
    north = math.cos(phi_0) * math.sin(phi) - math.sin(phi_0) * math.cos(phi) * math.cos(l)
    up = math.sin(phi_0) * math.sin(phi) + math.cos(phi_0) * math.cos(phi) * math.cos(l)
    away, way = math.atan2(math.hypot(east, north), up), math.atan2(east, north)
    if away + half >= furthest:
        return None
    near, far = (2 * radius * math.tan(c / 2) for c in (away - half, away + half))
    middle = (near + far) / 2
    return middle * math.sin(way), middle * math.cos(way), (far - near) / 2


def main():
    radius, latitude_0, longitude_0 = (float(word) for word in sys.argv[1:4])
    furthest = math.radians(float(sys.argv[4])) if len(sys.argv) > 4 else math.pi
    rows = csv.reader(sys.stdin)
    next(rows)
    left_out = 0
    print("x,y,r,name")
    for number, row in enumerate(rows, 1):
        image = project(*(float(field) for field in row[:3]), radius, latitude_0, longitude_0, furthest)
        if image is None:
            left_out += 1
            continue
        print("%.6f,%.6f,%.6f,%s" % (*image, row[3] if len(row) > 3 else number))
    if left_out:
        print("%d left out: they reach too far" % left_out, file=sys.stderr)


if __name__ == "__main__":
    main()
