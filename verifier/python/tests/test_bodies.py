#!/usr/bin/env python3
"""Tests of statements about all pairs of many bodies: python3 verifier/python/tests/test_bodies.py."""
import itertools
import unittest

from files import FORCED, MUTANT, Twins, dice_of, file_of, hexadecimal, lacking, main, some

QUESTION = "bodies"


def box(x, y, w, h):
    return {"name": "box", "points": [[hexadecimal(p), hexadecimal(q)] for p in (x, x + w) for q in (y, y + h)]}


def pair_of(boxes, i, j, dice):
    """What is so of two boxes, stated and proved; of those that meet by any of the words that are right."""
    (x, y, w, h), (p, q, v, g) = boxes[i], boxes[j]
    start = {"question": "pair", "a": i, "b": j}
    for axis, (lo, size, other, length) in enumerate(((x, w, p, v), (y, h, q, g))):
        for sign in (1, -1):
            if (lo + size < other) if sign == 1 else (other + length < lo):
                direction = ["0", "0"]
                direction[axis] = str(sign)
                return {**start, "verdict": "apart", "claims": [{"claim": "parted", "direction": direction}]}
    low, high = (max(x, p), max(y, q)), (min(x + w, p + v), min(y + h, q + g))
    is_inside = all(a < b for a, b in zip(low, high))
    claims = []
    for (x, y, w, h) in (boxes[i], boxes[j]):
        along = ["%d/%d" % (low[0] + high[0] - 2 * x, 2 * w), "%d/%d" % (low[1] + high[1] - 2 * y, 2 * h)]
        back = ["%d/%d" % (2 * w - low[0] - high[0] + 2 * x, 2 * w), "%d/%d" % (2 * h - low[1] - high[1] + 2 * y, 2 * h)]
        claims.append([[2 * m + n, "%d/%d" % (int(s.split("/")[0]) * int(t.split("/")[0]), 4 * w * h)]
                       for m, s in enumerate((back[0], along[0])) for n, t in enumerate((back[1], along[1]))])
    point = ["%d/2" % (low[0] + high[0]), "%d/2" % (low[1] + high[1])]
    words = dice.choice(["meet", "exact", "exact", "exact"])
    if words == "meet":
        return {**start, "verdict": "meet", "point": point, "claims": [{"claim": "holds", "weights": c} for c in claims]}
    if is_inside:
        return {**start, "verdict": "overlapping", "point": point,
                "claims": [{"claim": "inside", "weights": c} for c in claims]}
    axis = 0 if low[0] == high[0] else 1
    sign = 1 if boxes[i][axis] < low[axis] else -1
    direction = ["0", "0"]
    direction[axis] = str(sign)
    return {**start, "verdict": "touching", "point": point,
            "claims": [{"claim": "holds", "weights": c} for c in claims] + [{"claim": "parted_weakly", "direction": direction}]}


def some_scene(dice):
    """Boxes, statements about their pairs, and what may be said of all of them."""
    boxes = [(dice.randint(0, 5), dice.randint(0, 5), dice.randint(1, 3), dice.randint(1, 3)) for _ in range(dice.randint(2, 5))]
    members = dice.sample(range(len(boxes)), dice.randint(1, len(boxes)))
    groups = [dice.randint(0, 2) for _ in members] if dice.random() < .5 else None
    allowed = dice.choice(["nothing", "touch", "shared-endpoint"])
    pairs = list(itertools.combinations(range(len(members)), 2))
    besides = [pair for pair in pairs if dice.random() < .2]
    statements, contacts, is_known = [], [], True
    for i, j in pairs:
        if groups and groups[i] == groups[j]:
            continue
        if (i, j) in besides and dice.random() < .7:
            continue
        ends = (members[i], members[j]) if dice.random() < .5 else (members[j], members[i])
        pair = pair_of(boxes, *ends, dice)
        if dice.random() < .97:
            statements.append(pair)
        elif (i, j) not in besides:
            is_known = False
        if (i, j) in besides:
            continue
        if allowed != "nothing":
            is_known = is_known and pair["verdict"] != "meet"
            if pair["verdict"] == "overlapping":
                contacts.append([i, j])
        elif pair["verdict"] != "apart":
            contacts.append([i, j])
    dice.shuffle(statements)
    one = {"question": QUESTION, "members": members, "allowed": allowed, "except": [list(pair) for pair in besides],
           "verdict": "these", "contacts": contacts, "claims": [{"claim": "each_pair"}]}
    if groups:
        one["groups"] = groups
    return file_of({"bodies": [box(*b) for b in boxes]}, *statements, one), is_known


class BodiesTest(unittest.TestCase):
    def test_all_is_accepted_where_each_pair_is_proved_and_only_there(self):
        dice, twins = dice_of(1), Twins(self)
        for _ in range(some(1500)):
            top, is_known = some_scene(dice)
            self.assertEqual(twins.look(top), "accepted" if is_known else "each_pair", top)
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally()[word] for word in ("accepted", "each_pair")) > 50)

    def test_what_is_not_so_is_not_accepted(self):
        dice, twins, tried = dice_of(2), Twins(self), 0
        while tried < 400 or lacking(FORCED, QUESTION):
            top, is_known = some_scene(dice)
            *pairs, one = top["statements"]
            if not is_known or not one["members"]:
                continue
            tried += 1
            pair = sorted(dice.sample(range(len(one["members"])), 2)) if len(one["members"]) > 1 else None
            changes = [{"contacts": [c for c in one["contacts"] if c != pair] if pair in one["contacts"] else
                        sorted(one["contacts"] + [pair])}] if pair else []
            changes += [{"groups": [0] * len(one["members"])}, {"except": []}, {"allowed": "nothing"}, {"allowed": "touch"},
                        {"members": one["members"][::-1]}]
            said = [twins.force({**top, "statements": pairs + [{**one, **change}]}) for change in changes]
            if pair and pair not in one["except"]:
                self.assertNotEqual(said[0], "accepted", twins.last)
            self.force(twins, pairs, one, top)
        twins.compare()

    def force(self, twins, pairs, one, top):
        """A statement before it that is refused, or comes after, or is left out, proves nothing."""
        besides = {tuple(sorted(one["members"][k] for k in pair)) for pair in one["except"]}
        group = dict(zip(one["members"], one.get("groups", range(len(one["members"])))))
        for k, pair in enumerate(pairs):
            ends = tuple(sorted((pair["a"], pair["b"])))
            if ends in besides or group[ends[0]] == group[ends[1]]:
                continue
            bad = dict(pair, claims=[{**claim, **({"direction": ["0", "0"]} if "direction" in claim else {"weights": [[0, "2"]]})}
                                     for claim in pair["claims"]])
            for those in ([*pairs[:k], *pairs[k + 1:], one], [*pairs[:k], *pairs[k + 1:], one, pair],
                          [*pairs[:k], bad, *pairs[k + 1:], one]):
                said = twins.force({**top, "statements": those}, those.index(one))
                self.assertNotEqual(said, "accepted", twins.last)
            break
        twins.force({**top, "statements": [one]})

    def test_the_twins_agree_on_spoilt_files(self):
        dice, twins = dice_of(3), Twins(self)
        while lacking(MUTANT, QUESTION):
            top, _ = some_scene(dice)
            twins.spoil(top, dice)
            *pairs, one = top["statements"]
            twins.look({**top, "statements": pairs + [dict(one, members=[dice.randint(0, 5) for _ in one["members"]])]})
        twins.compare()


if __name__ == "__main__":
    main()
