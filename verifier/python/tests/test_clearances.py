#!/usr/bin/env python3
"""Tests of statements about how far apart all of many bodies are: python3 verifier/python/tests/test_clearances.py."""
import itertools
import unittest

from files import FORCED, MUTANT, Twins, dice_of, file_of, hexadecimal, lacking, main, some

QUESTION = "clearances"


def box(x, y, w, h):
    return {"name": "box", "points": [[hexadecimal(p), hexadecimal(q)] for p in (x, x + w) for q in (y, y + h)]}


def clearance_of(boxes, i, j, least):
    """What is so of two boxes, stated and proved."""
    ends = []  # by axis: of each box the side that is nearest to the other
    for axis in (0, 1):
        lows, highs = zip(*((b[axis], b[axis] + b[axis + 2]) for b in (boxes[i], boxes[j])))
        if highs[0] < lows[1]:
            ends.append((1, 0, lows[1] - highs[0]))
        elif highs[1] < lows[0]:
            ends.append((0, 1, highs[1] - lows[0]))
        else:
            ends.append(None)
    start = {"question": "clearance", "a": i, "b": j, "least": hexadecimal(least)}
    way = [end[2] if end else 0 for end in ends]
    if way[0] ** 2 + way[1] ** 2 >= least ** 2:
        return {**start, "verdict": "kept", "claims": [{"claim": "clear", "direction": list(map(str, way))}]}
    # Points of both: along an axis without a gap, the greater of the lower ends.
    points, holds = [[], []], []
    for k, b in enumerate((boxes[i], boxes[j])):
        shares = []
        for axis in (0, 1):
            if ends[axis]:
                at = b[axis] + ends[axis][k] * b[axis + 2]
            else:
                at = max(boxes[i][axis], boxes[j][axis])
            points[k].append(str(at))
            shares.append((b[axis] + b[axis + 2] - at, at - b[axis]))
        size = b[2] * b[3]
        holds.append([[2 * m + n, "%d/%d" % (shares[0][m] * shares[1][n], size)] for m, n in itertools.product((0, 1), (0, 1))])
    return {**start, "verdict": "broken", "from_a": points[0], "to_b": points[1],
            "claims": [{"claim": "holds", "weights": w} for w in holds] + [{"claim": "nearer"}]}


def some_scene(dice):
    """Boxes, statements about how far apart two of them are, and what may be said of all of them."""
    boxes = [(dice.randint(0, 12), dice.randint(0, 12), dice.randint(1, 3), dice.randint(1, 3)) for _ in range(dice.randint(2, 5))]
    members, least = dice.sample(range(len(boxes)), dice.randint(1, len(boxes))), dice.choice((1, 2, 3, 5))
    groups = [dice.randint(0, 2) for _ in members] if dice.random() < .5 else None
    pairs = list(itertools.combinations(range(len(members)), 2))
    besides = [pair for pair in pairs if dice.random() < .2]
    statements, nearer, is_known = [], [], True
    for i, j in pairs:
        if groups and groups[i] == groups[j]:
            continue
        if (i, j) in besides and dice.random() < .7:
            continue
        ends = (members[i], members[j]) if dice.random() < .5 else (members[j], members[i])
        pair = clearance_of(boxes, *ends, least)
        throw = dice.random()
        if throw < .95:
            statements.append(pair)
        else:  # of another distance, or none
            if throw < .98:
                statements.append(clearance_of(boxes, *ends, dice.choice([x for x in (1, 2, 3, 5) if x != least])))
            is_known = is_known and (i, j) in besides
        if (i, j) not in besides and pair["verdict"] == "broken":
            nearer.append([i, j])
    dice.shuffle(statements)
    one = {"question": QUESTION, "members": members, "except": [list(pair) for pair in besides],
           "least": dice.choice((hexadecimal(least), "0x%xp-1" % (2 * least))), "verdict": "broken" if nearer else "kept",
           "claims": [{"claim": "each_clearance"}]}
    if nearer:
        one["nearer"] = nearer
    if groups:
        one["groups"] = groups
    return file_of({"bodies": [box(*b) for b in boxes]}, *statements, one), is_known


class ClearancesTest(unittest.TestCase):
    def test_all_is_accepted_where_each_pair_is_proved_and_only_there(self):
        dice, twins = dice_of(1), Twins(self)
        for _ in range(some(1500)):
            top, is_known = some_scene(dice)
            self.assertEqual(twins.look(top), "accepted" if is_known else "each_clearance", top)
        twins.compare()
        self.assertTrue(some(100) < 100 or min(twins.tally()[word] for word in ("accepted", "each_clearance")) > 50)

    def test_what_is_not_so_is_not_accepted(self):
        dice, twins, tried = dice_of(2), Twins(self), 0
        while tried < 400 or lacking(FORCED, QUESTION):
            top, is_known = some_scene(dice)
            *pairs, one = top["statements"]
            if not is_known or len(one["members"]) < 2:
                continue
            tried += 1
            pair = sorted(dice.sample(range(len(one["members"])), 2))
            listed = one.get("nearer", [])
            other = sorted(c for c in listed if c != pair) if pair in listed else sorted(listed + [pair])
            bare = {key: value for key, value in one.items() if key != "nearer"}
            changed = [{**bare, "verdict": "broken", "nearer": other}, {**bare, "verdict": "kept"},
                       {**one, "least": hexadecimal(dice.randint(1, 9))}, {**one, "except": []},
                       {**one, "groups": [0] * len(one["members"])}, {**one, "members": one["members"][::-1]}]
            said = [twins.force({**top, "statements": pairs + [change]}) for change in changed]
            if pair not in one["except"]:
                self.assertNotEqual(said[0], "accepted", twins.last)
            if listed:
                self.assertNotEqual(said[1], "accepted", twins.last)
            self.force(twins, pairs, one, top)
        twins.compare()

    def force(self, twins, pairs, one, top):
        """A statement before it that is refused, or comes after, or is left out, proves nothing."""
        besides = {tuple(sorted(one["members"][k] for k in pair)) for pair in one["except"]}
        group = dict(zip(one["members"], one.get("groups", range(len(one["members"])))))
        for k, pair in enumerate(pairs):
            ends = tuple(sorted((pair["a"], pair["b"])))
            if ends in besides or group[ends[0]] == group[ends[1]] or float.fromhex(pair["least"]) != float.fromhex(one["least"]):
                continue
            bad = dict(pair, claims=[{**claim, **({"direction": ["0", "0"]} if "direction" in claim else {"weights": [[0, "2"]]}
                                                  if "weights" in claim else {})} for claim in pair["claims"]])
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
