# Sets of segments, and sweeps over them, by brute force and fractions: for tests of the checkers, with which it shares
# nothing.
import itertools
from fractions import Fraction

RULES = ("nothing", "shared-endpoint", "touch")
ALLOWED = {"nothing": (), "shared-endpoint": ("shared-endpoint",), "touch": ("shared-endpoint", "touch")}


def kind_by_fractions(s, t):
    """The kind of contact another way: by the parameters of the common point, or of the common part."""
    (ax, ay), (bx, by) = s
    (cx, cy), (dx, dy) = t
    ux, uy, vx, vy, wx, wy = bx - ax, by - ay, dx - cx, dy - cy, cx - ax, cy - ay
    across = ux * vy - uy * vx
    if across:
        p, q = Fraction(wx * vy - wy * vx, across), Fraction(wx * uy - wy * ux, across)
        if not (0 <= p <= 1 and 0 <= q <= 1):
            return None
        ends = (p in (0, 1)) + (q in (0, 1))
        return ("crossing", "touch", "shared-endpoint")[ends]
    if (ux, uy) == (0, 0):
        s, t = t, s
        (ax, ay), (bx, by) = s
        (cx, cy), (dx, dy) = t
        ux, uy = bx - ax, by - ay
    if (ux, uy) == (0, 0):
        return "shared-endpoint" if s == t else None
    if ux * (cy - ay) != uy * (cx - ax):
        return None
    length2 = ux * ux + uy * uy
    p, q = sorted(Fraction(ux * (x - ax) + uy * (y - ay), length2) for x, y in t)
    if q < 0 or p > 1:
        return None
    if p == q:
        return "shared-endpoint" if p in (0, 1) else "touch"
    return "shared-endpoint" if q == 0 or p == 1 else "overlap"


def some_set(rng):
    """Small sets on small grids: every degeneracy is common, and none meet often enough."""
    side, short = rng.choice((3, 5, 9)), rng.choice((1, 2, 9))
    segments = []
    for _ in range(rng.randint(1, 6)):
        x, y = rng.randint(0, side), rng.randint(0, side)
        ends = [(x, y), (x + rng.randint(-short, short), y + rng.randint(-short, short))]
        segments.append(tuple(sorted(ends)))
    return segments


def some_groups(rng):
    """A set with a group for each. Half of the sets are parted into groups so that none meet, as finely as can be."""
    segments, allowed = some_set(rng), rng.choice(RULES)
    while rng.randrange(3):
        x, y = rng.choice(segments)[rng.randrange(2)]  # some pencils, some on one line
        u, v = rng.choice(((1, 0), (1, 1), (0, 1), (1, -1), (2, 1)))
        k, l = rng.randint(-2, 2), rng.randint(-2, 2)
        segments.append(tuple(sorted(((x + k * u, y + k * v), (x + l * u, y + l * v)))))
    is_joint = rng.randrange(4) == 0
    if is_joint:  # some that begin or end on the inside of one
        x, y = rng.randint(0, 4), rng.randint(0, 4)
        segments = segments[:2] + [((x - k, y - k), (x + 1, y + 1)) for k in range(1, rng.randint(2, 3))]
        segments += [tuple(sorted(((x, y), (x + rng.randint(-2, 2), y + rng.randint(-2, 2))))) for _ in range(3)]
    rng.shuffle(segments)
    groups = [rng.randint(1, rng.choice((1, 2, 3)))] * len(segments)
    if rng.randrange(2 if is_joint else 4) == 0:
        groups = [rng.randint(1, 2 if is_joint else 3) for _ in segments]
    elif rng.randrange(3):
        groups = list(range(len(segments)))
        for i, j in itertools.combinations(range(len(segments)), 2):
            if kind_by_fractions(segments[i], segments[j]) not in (None,) + ALLOWED[allowed]:
                groups = [groups[i] if group == groups[j] else group for group in groups]
        if rng.randrange(2):
            groups[rng.randrange(len(groups))] = rng.choice(groups)
    return segments, groups, allowed


def is_free(segments, groups, allowed):
    """Does nothing count?"""
    return not any(groups[i] != groups[j] and
                   kind_by_fractions(segments[i], segments[j]) not in (None,) + ALLOWED[allowed]
                   for i, j in itertools.combinations(range(len(segments)), 2))


def crossing_by_fractions(s, t):
    """The point where two segments cross, or None."""
    if kind_by_fractions(s, t) != "crossing":
        return None
    ((ax, ay), (bx, by)), ((cx, cy), (dx, dy)) = s, t
    ux, uy, vx, vy = bx - ax, by - ay, dx - cx, dy - cy
    p = Fraction((cx - ax) * vy - (cy - ay) * vx, ux * vy - uy * vx)
    return ax + p * ux, ay + p * uy


class Line:
    """The sweep line at a point p, in fractions."""

    def __init__(self, segments, groups):
        self.segments, self.groups, self.cut = segments, groups, []

    def height(self, i, p):
        """Where segment i cuts the line, and how steeply it goes on."""
        (ax, ay), (bx, by) = self.segments[i]
        if ax == bx:
            return p[1], 1, 0
        slope = Fraction(by - ay, bx - ax)
        return ay + slope * (p[0] - ax), 0, slope

    def exchanges(self, p):
        """The neighbours that cross at p and may do so: the places in the list of the lower ones."""
        return [k for k, (i, j) in enumerate(zip(self.cut, self.cut[1:]))
                if self.groups[i] == self.groups[j] and crossing_by_fractions(self.segments[i], self.segments[j]) == p]

    def place_of_first_end(self, i):
        p = self.segments[i][0]
        key = self.height(i, p)
        for at, other in enumerate(self.cut):
            height = self.height(other, p)
            if height[0] > p[1]:
                return at
            if height[0] == p[1] and self.segments[i][1] != p:
                if height > key or (height == key and self.groups[other] != self.groups[i]):
                    return at
        return len(self.cut)


def places_of_sweep(segments):
    pairs = itertools.combinations(segments, 2)
    return sorted({p for segment in segments for p in segment} |
                  {crossing_by_fractions(s, t) for s, t in pairs} - {None})


def events_at(segments, p):
    """What happens at p, but for exchanges: those that end there, points, those that begin there."""
    numbered = list(enumerate(segments))
    return ([i for i, (a, b) in numbered if a < b == p], [i for i, (a, b) in numbered if a == b == p],
            [i for i, (a, b) in numbered if p == a < b])


def sweep(rng, segments, groups):
    """A transcript: events, below, exchanges. Right if nothing counts. What comes first is random where either may."""
    line, events, below, exchanges = Line(segments, groups), [], [], []

    def enter(i):
        at = line.place_of_first_end(i)
        events.append(2 * i)
        below.append(line.cut[at - 1] if at else -1)
        line.cut.insert(at, i)

    def leave(i):
        events.append(2 * i + 1)
        line.cut.remove(i)

    for p in places_of_sweep(segments):
        ending, points, beginning = events_at(segments, p)
        rng.shuffle(ending)
        rng.shuffle(beginning)
        for i in ending:
            leave(i)
        while True:
            wrong = [k for k in line.exchanges(p)
                     if line.height(line.cut[k], p)[1:] > line.height(line.cut[k + 1], p)[1:]]
            if not wrong:
                break
            k = rng.choice(wrong)
            events.append(-1)
            exchanges.append(line.cut[k:k + 2])
            line.cut[k:k + 2] = reversed(line.cut[k:k + 2])
        for i in points:
            enter(i)
            leave(i)
        for i in beginning:
            enter(i)
    return events, below, exchanges


def all_transcripts(segments, groups, most):
    """All transcripts in which the events have an order that T1 allows, each segment begins above one that is cut, and
    neighbours of one group are exchanged where they cross; no two exchanges at a point lead back to one list. At most
    so many."""
    places = places_of_sweep(segments)
    count = [0]

    def orders(line, p):
        """The lists that exchanges at p make of one, each with the exchanges: all ways without a way back."""
        found = [(line, [])]
        stack = [(line, [], {tuple(line.cut)})]
        while stack and len(found) < 40:
            now, done, seen = stack.pop()
            for k in now.exchanges(p):
                after = Line(segments, groups)
                after.cut = now.cut[:k] + [now.cut[k + 1], now.cut[k]] + now.cut[k + 2:]
                if tuple(after.cut) not in seen:
                    found.append((after, done + [now.cut[k:k + 2]]))
                    stack.append((after, found[-1][1], seen | {tuple(after.cut)}))
        return found

    def enter(line, kinds, events, below):
        """All ways to enter the segments in the order of `kinds`; the points leave at once."""
        if not kinds:
            yield line, events, below
            return
        i = kinds[0]
        for at in range(len(line.cut) + 1):
            after = Line(segments, groups)
            after.cut = line.cut[:at] + [i] + line.cut[at:]
            now = events + [2 * i]
            if segments[i][0] == segments[i][1]:
                after.cut.remove(i)
                now.append(2 * i + 1)
            yield from enter(after, kinds[1:], now, below + [line.cut[at - 1] if at else -1])

    def go(n, line, events, below, exchanges):
        if count[0] >= most:
            return
        if n == len(places):
            count[0] += 1
            yield events, below, exchanges
            return
        ending, points, beginning = events_at(segments, places[n])
        for order in itertools.permutations(ending):
            left = Line(segments, groups)
            left.cut = [i for i in line.cut if i not in ending]
            for changed, done in orders(left, places[n]):
                now = events + [2 * i + 1 for i in order] + [-1] * len(done)
                for begun in itertools.permutations(beginning):
                    for after, then, lower in enter(changed, points + list(begun), now, below):
                        yield from go(n + 1, after, then, lower, exchanges + done)

    return go(0, Line(segments, groups), [], [], [])


def mutate(rng, segments, groups, events, below, exchanges):
    """One change of a transcript or of a group, in place; what was changed, or None where that cannot be."""
    what = rng.choice(("drop", "move", "turn", "repeat", "group", "event", "below", "other"))
    at = [k for k, event in enumerate(events) if event < 0]
    if what == "group":
        groups[rng.randrange(len(groups))] = rng.choice(groups)
    elif what == "below":
        below[rng.randrange(len(below))] = rng.randint(-1, len(segments) - 1)
    elif what == "event":
        i, event = rng.randrange(len(events)), rng.randrange(len(events))
        events.insert(i, events.pop(event))
    elif not at:
        return None
    else:
        n = rng.randrange(len(at))
        if what == "drop":
            del events[at[n]], exchanges[n]
        elif what == "repeat":
            events.insert(at[n], -1)
            exchanges.insert(n, rng.choice((exchanges[n], exchanges[n][::-1])))
        elif what == "turn":
            exchanges[n] = exchanges[n][::-1]
        elif what == "other":
            exchanges[n] = [rng.randrange(len(segments)) for _ in range(2)]
        else:
            to = rng.randrange(len(events))
            exchange = exchanges.pop(n)
            del events[at[n]]
            exchanges.insert(sum(event < 0 for event in events[:to]), exchange)
            events.insert(to, -1)
    return what
