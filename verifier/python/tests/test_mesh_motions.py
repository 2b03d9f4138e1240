"""Statements about meshes that move, forced: of solids of unit cells, which meet when two of their cells do."""
import itertools
import unittest
from fractions import Fraction

import files
from files import MUTANT, Twins, dice_of, fraction, hexadecimal, lacking, some
from mesh_cells import direction, inside, pieces, some_pair, told_point, walk
from test_mesh_distances import on_surface, sizes_of

AXES = [[int(a == b) for b in range(3)] for a in range(3)]


def first_contact(a, b, way):
    """When two cells first meet, while B goes that way; and a point of both then, where A is."""
    contacts = []
    for of_a, of_b in itertools.product(sizes_of(a), sizes_of(b)):
        begin, end = Fraction(0), Fraction(1)
        for x, y, v in zip(of_a, of_b, way):
            low, high = x[0] - y[1], x[1] - y[0]  # B's way, while they overlap along this axis
            if v:
                begin, end = max(begin, min(low / v, high / v)), min(end, max(low / v, high / v))
            elif low > 0 or high < 0:
                end = Fraction(-1)
        if begin <= end:
            contacts.append((begin, [max(x[0], y[0] + begin * v) for x, y, v in zip(of_a, of_b, way)]))
    return min(contacts, default=None)


def cover_on_the_way(a, b, way, time, dice):
    """The walk, where each pair of triangles is parted along an axis, or across one and the way; at the beginning, and, where
    a time is given, weakly then, else at the end. None where one is not."""
    places = a.places(), b.places()
    across = [[e[1] * way[2] - e[2] * way[1], e[2] * way[0] - e[0] * way[2], e[0] * way[1] - e[1] * way[0]] for e in AXES]
    tried = [[sign * x for x in d] for d in AXES + [d for d in across if any(d)] for sign in (1, -1)]

    seen = []  # of each direction how far its way goes, and of each triangle of A where it ends, of each of B where it begins
    for d in tried:
        of_a, of_b = ([sum(x * y for x, y in zip(p, d) if y) for p in some] for some in places)
        seen.append((d, sum(x * y for x, y in zip(way, d)) * (1 if time is None else time),
                     [max(of_a[k] for k in t) for t in a.triangles], [min(of_b[k] for k in t) for t in b.triangles]))

    def parts(of_a, of_b):
        for d, far, ends, begins in seen:
            gap = min(begins[slice(*of_b)]) - max(ends[slice(*of_a)])
            if gap > 0 and (gap + far > 0 or time is not None and gap + far == 0):
                yield d
    return walk(a, b, lambda *those: [*parts(*those)], dice)


def tables_of_motion(a, b, way_a, way_b):
    """The table of both, at the beginning and at the end; and which of its entries they are: A, B, to A, to B."""
    entries, named = [], []
    for given, way in (a, way_a), (b, way_b):
        base = len(entries)
        entries += given.entries(base)
        begin = len(entries) - 1
        if not any(way):
            named.append((begin, begin))
            continue
        linear = entries[begin].get("linear", [hexadecimal(Fraction(n)) for row in AXES for n in row])
        from_ = [given.step * s for s in given.shift] if given.is_image else [Fraction(0)] * 3
        entries.append({"name": given.name, "of": base, "linear": linear,
                        "translation": [hexadecimal(Fraction(x + w)) for x, w in zip(from_, way)]})
        named.append((begin, len(entries) - 1))
    (i, to_i), (j, to_j) = named
    return {"meshes": entries}, {"a": i, "b": j, "to_a": to_i, "to_b": to_j}


def statement(verdict, named, *claims, **says):
    return {"question": "mesh_motion", **named, "verdict": verdict, **says, "claims": list(claims)}


class MeshMotions(unittest.TestCase):
    def setUp(self):
        self.dice, self.twins = dice_of(4005), Twins(self)

    def ask(self, tables, make, is_true):
        """What is true is accepted, but where a ray meets an edge: then others are taken."""
        for _ in range(30 if is_true else 1):
            top = files.file_of(tables, make())
            found = self.twins.force(top)
            if found == "accepted":
                break
        self.assertEqual(found == "accepted", is_true, (found, top))

    def some_motion(self, most=800):
        """Two solids that move, when they meet, and where then; nothing that begins in another one, or touches it."""
        dice = self.dice
        while True:
            a, b = some_pair(dice)
            if len(a.triangles) * len(b.triangles) > most:
                continue
            ways = [[a.step * Fraction(dice.randint(-6, 6), 2) for _ in range(3)] if dice.random() < .7 else [Fraction(0)] * 3
                    for _ in range(2)]
            if dice.random() < .8:  # B goes where a corner of A comes
                ends = [dice.choice(of.places()) for of in (a, b)]
                ways[1] = [p - q + x for p, q, x in zip(*ends, ways[0])]
            way = [y - x for x, y in zip(*ways)]
            contact = first_contact(a, b, way)
            nested = any(b.is_in(a.places()[a.triangles[t][0]]) for t in pieces(a)) or any(
                a.is_in(b.places()[b.triangles[t][0]]) for t in pieces(b))
            if any(way) and not nested and (contact is None or contact[0]):
                return a, b, ways, way, contact

    def covered(self, rule, found, a, b):
        rays = [[[t, direction(self.dice)] for t in pieces(of)] for of in (a, b)]
        return {"claim": rule, "cuts": found[0], "directions": found[1], "rays_a": rays[0], "rays_b": rays[1]}

    def at_contact(self, a, b, ways, way, contact):
        """The time, the point in the world, and the claims that triangles have it."""
        time, at = contact  # where A is at the beginning
        claims = [on_surface(of, point) for of, point in ((a, at), (b, [x - time * v for x, v in zip(at, way)]))]
        said = {"time": fraction(time), "point": told_point([x + time * w for x, w in zip(at, ways[0])])}
        return said, [{**claim, "claim": "on_triangle_at"} for claim in claims]

    def test_motions(self):
        dice = self.dice
        for n in range(some(120)):
            a, b, ways, way, contact = self.some_motion()
            while (contact is None) != (n % 3 == 0):  # two of three meet
                a, b, ways, way, contact = self.some_motion()
            tables, named = tables_of_motion(a, b, *ways)
            if contact is None:
                found = cover_on_the_way(a, b, way, None, dice)
                if found:
                    self.ask(tables, lambda: statement("apart", named, self.covered("covered_all_along", found, a, b)), True)
                continue
            # What parts them until they meet does not part them all the way: then they would not meet.
            time = contact[0]
            found = cover_on_the_way(a, b, way, time, dice)
            said, claims = self.at_contact(a, b, ways, way, contact)
            self.ask(tables, lambda: statement("meet", named, *claims, **said), True)
            before = fraction(time * dice.choice((Fraction(0), Fraction(1, 2), 1 - Fraction(1, 2 ** 30))))
            self.ask(tables, lambda: statement("meet", named, *claims, **{**said, "time": before}),
                     all(x == 0 for x in way))
            if not found:
                continue
            self.ask(tables, lambda: statement("apart", named, self.covered("covered_all_along", found, a, b)), False)
            self.ask(tables, lambda: statement("first", named, *claims, self.covered("covered_before", found, a, b), **said), True)
            # A cover of another time. Until later than they meet there is none, whatever the point.
            for other in {time / 2, (time + 1) / 2} - {time}:
                cover = cover_on_the_way(a, b, way, other, dice) if other < time else found
                if cover:
                    self.twins.force(files.file_of(tables, statement(
                        "first", named, *claims, self.covered("covered_before", cover, a, b), **{**said, "time": fraction(other)})))
                    self.assertNotEqual(self.twins.told(self.twins.last), "accepted")
        self.twins.compare()

    def test_within(self):
        dice = self.dice
        for _ in range(some(60)):
            a, b = some_pair(dice)
            ways = [[a.step * dice.randint(-3, 3) for _ in range(3)] for _ in range(2)]
            tables, named = tables_of_motion(a, b, *ways)
            for verdict, of, other in ("a_within", a, b), ("b_within", b, a):
                point, claim = inside(of, dice)
                claims = [claim, {"claim": "encloses", "direction": direction(dice)}]
                said = statement(verdict, named, *(claims if verdict[0] == "a" else claims[::-1]), point=told_point(point))
                found = self.twins.force(files.file_of(tables, said))
                if found == "accepted":
                    self.assertTrue(other.is_in(point), said)
        self.twins.compare()

    def test_another_end(self):
        """What is another body at the end, or turned, is no end."""
        a, b, ways, *_ = self.some_motion()
        while not any(ways[0]) or not any(ways[1]):
            a, b, ways, *_ = self.some_motion()
        tables, named = tables_of_motion(a, b, *ways)
        claims = [{"claim": "covered_all_along", "cuts": [0], "directions": [["1", "0", "0"]], "rays_a": [], "rays_b": []}]
        for wrong in {**named, "to_a": named["to_b"]}, {**named, "to_b": named["a"]}:
            self.assertEqual(self.twins.look(files.file_of(tables, statement("apart", wrong, *claims))), "F")
        turned = [dict(entry) for entry in tables["meshes"]]
        turned[named["to_a"]]["linear"] = ["0x1p+0", "0x1p+0", *turned[named["to_a"]]["linear"][2:]]
        self.assertEqual(self.twins.look(files.file_of({"meshes": turned}, statement("apart", named, *claims))), "F")
        self.twins.compare()

    def test_mutants(self):
        dice = dice_of(4006)
        while lacking(MUTANT, "mesh_motion"):
            a, b, ways, way, contact = self.some_motion(300)
            tables, named = tables_of_motion(a, b, *ways)
            found = cover_on_the_way(a, b, way, contact and contact[0], dice)
            if not found:
                continue
            if contact is None:
                said = [statement("apart", named, self.covered("covered_all_along", found, a, b))]
            else:
                says, claims = self.at_contact(a, b, ways, way, contact)
                said = [statement("meet", named, *claims, **says),
                        statement("first", named, *claims, self.covered("covered_before", found, a, b), **says)]
            for verdict, of in ("a_within", a), ("b_within", b):
                point, claim = inside(of, dice)
                claims = [claim, {"claim": "encloses", "direction": direction(dice)}]
                said.append(statement(verdict, named, *(claims if of is a else claims[::-1]), point=told_point(point)))
            for one in said:
                if one["verdict"] in lacking(MUTANT, "mesh_motion"):
                    self.twins.spoil(files.file_of(tables, one), dice)
        self.twins.compare()


if __name__ == "__main__":
    files.main()
