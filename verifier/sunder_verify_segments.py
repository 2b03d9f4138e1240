"""Checks statements about sets of segments: the part of sunder_verify.py for files with "sunder_set_certificate".

The format and the checks C1-C3 and T1-T4 are those of docs/certificates.md, "Sets"; no code is shared with the library.
All coordinates are integers here: multiples of one power of two, which all comparisons may leave out.
"""
from sunder_verify import Refused, common, double, index, member, number, numbers, require

ALLOWED = {  # which kinds of contact do not count
    "nothing": (),
    "shared-endpoint": ("shared-endpoint",),
    "touch": ("shared-endpoint", "touch"),
}
KINDS = ("shared-endpoint", "touch", "crossing", "overlap")


def turn(p, q, r):
    """Positive: p, q, r turn left."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def kind_of(s, t):
    """How two segments meet: one of KINDS, or None. A segment is a pair of points, the lesser one first."""
    (a, b), (c, d) = s, t
    c_side, d_side, a_side, b_side = turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)
    if c_side == d_side == a_side == b_side == 0:  # on one line, where the order of points is the order along it
        first, last = max(a, c), min(b, d)
        if first > last:
            return None
        if first < last:
            return "overlap"
        return "shared-endpoint" if first in s and first in t else "touch"
    if c_side * d_side > 0 or a_side * b_side > 0:
        return None
    if c_side * d_side < 0 and a_side * b_side < 0:
        return "crossing"
    return "shared-endpoint" if a in t or b in t else "touch"


def is_above(s, t):
    """Is s, just after it begins, above t, which has begun? A segment of length zero is above those that it lies on."""
    side = turn(t[0], t[1], s[0])
    return side > 0 or (side == 0 and (s[0] == s[1] or turn(t[0], t[1], s[1]) > 0))


def check_some(segments, exponent, allowed, i, j, kind, point):
    require(kind not in ALLOWED[allowed], "C1", "%s does not count where %s is allowed" % (kind, allowed))
    (px, dx, ex), (py, dy, ey) = point
    low = min(ex, ey, exponent)
    unit = dx * dy << (exponent - low)  # one unit of the coordinates
    for k in (i, j):
        a, b = segments[k]
        # p - a, times dx * dy * 2^-low: integers.
        ux = (px * dy << (ex - low)) - (a[0] * unit)
        uy = (py * dx << (ey - low)) - (a[1] * unit)
        vx, vy = b[0] - a[0], b[1] - a[1]
        inner = ux * vx + uy * vy
        require(ux * vy == uy * vx and 0 <= inner <= (vx * vx + vy * vy) * unit and
                (vx or vy or not (ux or uy)), "C2", "the point is not on segment %d" % k)
    found = kind_of(segments[i], segments[j])
    require(found == kind, "C3", "the contact is %s" % (found or "none"))


def check_none(segments, allowed, events, below):
    size = len(segments)
    require(sorted(events) == list(range(2 * size)), "T1", "the events are not each end of each segment once")

    def place(event):  # what orders events; at one point: ends, then points, then beginnings
        a, b = segments[event // 2]
        if a == b:
            return a, 1, event  # a segment of length zero comes and goes at once
        return (b, 0, 0) if event % 2 else (a, 2, 0)

    places = [place(event) for event in events]
    for k in range(1, len(events)):
        require(places[k - 1] <= places[k], "T1", "event %d is out of order" % k)
        if allowed == "nothing" and places[k - 1][0] == places[k][0]:
            require(events[k - 1] // 2 == events[k] // 2, "T1", "event %d shares its point with another segment" % k)

    def neighbours(lower, upper):
        if lower >= 0 and upper >= 0:
            kind = kind_of(segments[lower], segments[upper])
            require(kind is None or kind in ALLOWED[allowed], "T4",
                    "segments %d and %d become neighbours and meet: %s" % (lower, upper, kind))

    above_of, below_of = {-1: -1}, {-1: -1}  # a ring: -1 stands below and above all
    begun = 0
    for event in events:
        s = event // 2
        if event % 2 == 0:
            lower = below[begun]
            begun += 1
            require(lower in above_of, "T2", "segment %d begins above %d, which is not cut then" % (s, lower))
            upper = above_of[lower]
            require(lower < 0 or is_above(segments[s], segments[lower]), "T3",
                    "segment %d does not begin above %d" % (s, lower))
            require(upper < 0 or not is_above(segments[s], segments[upper]), "T3",
                    "segment %d does not begin below %d" % (s, upper))
            above_of[lower], above_of[s], below_of[s], below_of[upper] = s, upper, lower, s
            neighbours(lower, s)
            neighbours(s, upper)
        else:
            require(s in above_of, "T2", "segment %d ends before it begins" % s)
            lower, upper = below_of.pop(s), above_of.pop(s)
            above_of[lower], below_of[upper] = upper, lower
            neighbours(lower, upper)


def read_statement(item, size, where):
    require(member(item, "question", str, where) == "segments_any", "F", where + ".question is not segments_any")
    allowed = member(item, "allowed", str, where)
    require(allowed in ALLOWED, "F", where + ".allowed is none of nothing, shared-endpoint, touch")
    verdict = member(item, "verdict", str, where)
    require(verdict in ("none", "some"), "F", where + ".verdict is neither none nor some")
    if verdict == "some":
        i, j = (index(member(item, key, int, where), size, "%s.%s" % (where, key)) for key in "ij")
        require(i != j, "F", where + " names one segment twice")
        kind = member(item, "kind", str, where)
        require(kind in KINDS, "F", where + ".kind is no kind of contact")
        return verdict, (allowed, i, j, kind, numbers(member(item, "point", list, where), 2, number, where + ".point"))
    events = [index(e, 2 * size, where + " event") for e in member(item, "events", list, where)]
    below = member(item, "below", list, where)
    require(len(below) == size, "F", where + ".below is not a list of %d" % size)
    for b in below:
        require(type(b) is int and -1 <= b < size, "F", where + ".below has an entry that is no index and not -1")
    return verdict, (allowed, events, below)


def verify(top):
    """As verify of sunder_verify.py, from a JSON object: the statements are its pairs, without names."""
    require(member(top, "sunder_set_certificate", int, "the file") == 1, "F", "sunder_set_certificate is not 1")
    flat = []
    for i, item in enumerate(member(top, "segments", list, "the file")):
        flat += numbers(item, 4, double, "segments[%d]" % i)
    flat, _, exponent = common(flat)
    segments = [((flat[k], flat[k + 1]), (flat[k + 2], flat[k + 3])) for k in range(0, len(flat), 4)]
    for i, (a, b) in enumerate(segments):
        require(a <= b, "F", "segments[%d] does not begin with its lexicographically first end" % i)
    statements = [read_statement(item, len(segments), "statements[%d]" % i)
                  for i, item in enumerate(member(top, "statements", list, "the file"))]
    results = []
    for i, (verdict, evidence) in enumerate(statements):
        refusal = None
        try:
            if verdict == "some":
                check_some(segments, exponent, *evidence)
            else:
                check_none(segments, *evidence)
        except Refused as error:
            refusal = error.args
        results.append((i, "segments", evidence[0] + " allowed", verdict, refusal))
    return results
