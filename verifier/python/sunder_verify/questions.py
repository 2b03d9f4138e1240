"""Which claims prove which statement, as data: docs/claims.md, "Statements".

A statement says its question, what it is about, and its verdict; its claims follow in the order of the table. Each is
checked by its rule, told what the table binds it to: so a true claim about something else proves nothing.
"""
from . import arcs, polygons, rules
from .reader import MOST_NUMBER, double, index, members, number, numbers, require
from .tables import Parts

MOST_WEIGHTS = 16  # of one combination; 4 are always enough
ALLOWED = {  # which kinds of contact do not count
    "nothing": (),
    "shared-endpoint": ("shared-endpoint", "touching"),
    "touch": ("shared-endpoint", "touch", "touching"),
}


# ---- Readers of a member: told its value, its place, and what has been read, by name. All they require is rule F.

def entry(table):
    return int, lambda value, where, read: read[table][index(value, len(read[table]), where)]


def index_of(table, of=list):
    return int, lambda value, where, read: index(value, len(of(read[table])), where)


def groups(table):
    def read_groups(value, where, read):
        require(len(value) == len(read[table]), "F", "%s is not a list of %d" % (where, len(read[table])))
        return [index(group, MOST_NUMBER + 1, where + " entry", -MOST_NUMBER) for group in value]
    return list, read_groups


def read_allowed(value, where, read):
    require(value in ALLOWED, "F", where + " is none of nothing, shared-endpoint, touch")
    return ALLOWED[value]


def kind(kinds):
    def read_kind(value, where, read):
        require(value in kinds, "F", where + " is no kind of contact")
        return value
    return str, read_kind


def read_contacts(table, kinds):
    def read_list(value, where, read):
        before = (-1, -1)
        for k, item in enumerate(value):
            require(type(item) is list and len(item) == 2 + (kinds is not None), "F", "%s[%d] is no contact" % (where, k))
            for i in item[:2]:
                index(i, len(read[table]), "%s[%d]" % (where, k))
            require(kinds is None or (type(item[2]) is str and item[2] in kinds), "F", "%s[%d] is of no kind" % (where, k))
            require(item[0] < item[1] and before < tuple(item[:2]), "F", "%s[%d] is not in order" % (where, k))
            before = tuple(item[:2])
        return value
    return list, read_list


def read_vector(value, where, read):
    dimensions = {read[key].dimension for key in "ab" if key in read} or {2}
    require(len(dimensions) == 1, "F", where + " is of bodies of different dimensions")
    return numbers(value, dimensions.pop(), number, where)


def read_weights(value, where, read):
    require(0 < len(value) <= MOST_WEIGHTS, "F", "%s has not 1 to %d entries" % (where, MOST_WEIGHTS))
    result = []
    for item in value:
        require(type(item) is list and len(item) == 2, "F", where + " has an entry that is not a list of 2")
        result.append((index(item[0], len(read["of"]), where + " entry"), number(item[1], where + " entry")))
    require(len({k for k, _ in result}) == len(result), "F", where + " names something twice")
    return result


def read_ends(value, where, read):
    require(len(value) == 2, "F", where + " is not a list of 2")
    result = []
    for item in value:
        require(item is None or (type(item) is list and len(item) == 2), "F", where + " has an entry that is no end")
        result.append(item and (read_vector(item[0], where + " entry", {}), index(item[1], len(read["of"]), where + " entry")))
    return result


def read_events(value, where, read):
    size = len(read["of"].edges)
    for k, event in enumerate(value):
        require(type(event) is list and len(event) >= 2, "F", "%s[%d] is not a list of 2 or more" % (where, k))
        index(event[0], 2 * size, "%s[%d]" % (where, k), -1)
        index(event[1], size, "%s[%d]" % (where, k), -1)
        for s in event[2:]:
            index(s, size, "%s[%d]" % (where, k))
    return value


def indices(table):
    return list, lambda value, where, read: [index(k, len(read[table]), where + " entry") for k in value]


def read_arcs(value, where, read):
    require(0 < len(value) <= 2 * len(read["circles"]), "F", where + " is empty, or has more than two arcs a circle")
    return indices("circles")[1](value, where, read)


def read_parts(value, where, read):
    for part in value:
        require(type(part) is list, "F", where + " has an entry that is not a list")
        read_arcs(part, where + " entry", read)
    return value


def read_cones(value, where, read):
    require(len(value) == len(read["of"]), "F", "%s is not a list of %d" % (where, len(read["of"])))
    # A corner is between two sides: of those that do not go round, none is after the last one.
    count = len(read["sides"]) - (read["verdict"] in ("ray", "unbounded"))
    return [index(p, count, where + " entry") for p in value]


def read_order(value, where, read):
    size = len(read["of"])
    require(len(value) == size and len({index(k, size, where + " entry") for k in value}) == size, "F",
            where + " does not name each once")
    return value


def read_polygons(value, where, read):
    which = [index(i, len(read["polygons"]), where + " entry") for i in value]
    require(0 < len(set(which)) == len(which), "F", where + " names none, or one twice")
    return Parts(read["polygons"], which)


def read_circle(value, where, read):
    rings = [index(ring, len(read["parts"].rings), where + " entry") for ring in value]
    require(1 < len(set(rings)) == len(rings), "F", where + " is not of two rings or more, each once")
    return rings


def read_points(value, where, read):
    require(len(value) == len(read["rings"]), "F", where + " is not as long as the rings")
    return [numbers(point, 2, number, where + " entry") for point in value]


def read_rule(value, where, read):
    require(value in ("valid", "simple"), "F", where + " is none of valid, simple")
    return value


ALLOW, VECTOR, WEIGHTS, ENDS = (str, read_allowed), (list, read_vector), (list, read_weights), (list, read_ends)
EVENTS, KIND, DISC_KIND = (list, read_events), kind(rules.KINDS), kind(rules.DISC_KINDS)
ORDER, NUMBER = (list, read_order), (int, lambda value, where, read: index(value, MOST_NUMBER + 1, where))
OBJECTIVE = (list, lambda value, where, read: numbers(value, 2, double, where))

# ---- Claims: what they bring, and their rule.

CLAIMS = {
    "parted": ({"direction": VECTOR}, rules.parted),
    "parted_weakly": ({"direction": VECTOR}, rules.parted_weakly),
    "holds": ({"weights": WEIGHTS}, rules.holds),
    "inside": ({"weights": WEIGHTS}, rules.inside),
    "slab": ({}, rules.slab),
    "feasible": ({}, rules.feasible),
    "bounds": ({"weights": WEIGHTS}, rules.bounds),
    "bounds_only": ({"weights": WEIGHTS}, rules.bounds_only),
    "no_objective": ({}, rules.no_objective),
    "contradict": ({"weights": WEIGHTS}, rules.contradict),
    "goes_on": ({"direction": VECTOR}, rules.goes_on),
    "ends": ({"ends": ENDS}, rules.ends),
    "contact": ({}, rules.contact),
    "none_counts": ({"events": EVENTS}, polygons.none_counts),
    "these_count": ({"events": EVENTS}, polygons.these_count),
    "number_counts": ({"events": EVENTS}, polygons.number_counts),
    "cones": ({"cones": (list, read_cones)}, rules.cones),
    "no_entries": ({}, rules.no_entries),
    "in_discs": ({}, rules.in_discs),
    "powers": ({"weights": WEIGHTS}, rules.powers),
    "arcs": ({"parts": (list, read_parts)}, arcs.arcs),
    "cover": ({"order": ORDER}, rules.cover),
    "common_point": ({}, polygons.common_point),
    "valid": ({"events": EVENTS}, polygons.valid),
    **{name: ({}, getattr(polygons, name)) for name in ("too_few_points", "comes_twice", "misplaced", "circle", "repeated",
                                                     "rings_touch")},
}

# ---- Statements. A question: the table it is about, what each statement about it says, what it may say; for each verdict
# what that says more, and its claims, each with what it is bound to: the first is what the claim's indices count.

PROGRAM = {"objective": OBJECTIVE}


def regions(given):
    """The kinds of the common part of half-planes."""
    kinds = ("point", "segment", "ray", "line", "strip", "half-plane", "unbounded", "bounded", "plane")
    return {"empty": ({}, [("contradict", given)]),
            **{kind: ({"sides": indices(given)}, [("cones", given, "verdict", "sides")]) for kind in kinds}}


RING = index_of("parts", lambda parts: parts.rings)
EDGE = index_of("parts", lambda parts: parts.edges)
QUESTIONS = {
    "pair": ("bodies", {"a": entry("bodies"), "b": entry("bodies")}, {}, {
        "apart": ({}, [("parted", "a", "b")]),
        "meet": ({"point": VECTOR}, [("holds", "a", "point"), ("holds", "b", "point")]),
        "touching": ({"point": VECTOR}, [("holds", "a", "point"), ("holds", "b", "point"), ("parted_weakly", "a", "b")]),
        "overlapping": ({"point": VECTOR}, [("inside", "a", "point"), ("inside", "b", "point")]),
    }),
    "distance": ("bodies", {"a": entry("bodies"), "b": entry("bodies")}, {}, {
        "closest": ({"from_a": VECTOR, "to_b": VECTOR}, [
            ("holds", "a", "from_a"), ("holds", "b", "to_b"), ("slab", "a", "b", "from_a", "to_b")]),
    }),
    "segments": ("segments", {"allowed": ALLOW}, {"groups": groups("segments")}, {
        "some": ({"i": index_of("segments"), "j": index_of("segments"), "kind": KIND, "point": VECTOR},
                 [("contact", "segments", "i", "j", "kind", "point", "groups", "allowed")]),
        "none": ({}, [("none_counts", "segments", "groups", "allowed")]),
        "these": ({"contacts": read_contacts("segments", rules.KINDS)},
                  [("these_count", "segments", "groups", "allowed", "contacts")]),
        "count": ({"number": NUMBER}, [("number_counts", "segments", "groups", "allowed", "number")]),
    }),
    "circles": ("circles", {"allowed": ALLOW}, {"groups": groups("circles")}, {
        "some": ({"i": index_of("circles"), "j": index_of("circles"), "kind": DISC_KIND, "point": VECTOR},
                 [("contact", "circles", "i", "j", "kind", "point", "groups", "allowed")]),
        "none": ({}, [("cover", "circles", "groups", "allowed")]),
        "these": ({"contacts": read_contacts("circles", rules.DISC_KINDS)},
                  [("cover", "circles", "groups", "allowed", "contacts")]),
        "count": ({"number": NUMBER}, [("cover", "circles", "groups", "allowed", "number")]),
    }),
    "half_planes": ("half_planes", {}, {}, regions("half_planes")),
    "kernel": ("rings", {"ring": entry("rings")}, {}, regions("ring")),
    "convex_polygons_common_part": ("convex_polygons", {}, {}, regions("convex_polygons")),
    "circles_common_part": ("circles", {}, {}, {
        "empty": ({}, [("powers", "circles", "verdict")]),
        "point": ({"point": VECTOR}, [("in_discs", "circles", "point", "verdict"), ("powers", "circles", "verdict")]),
        "region": ({"point": VECTOR, "arcs": (list, read_arcs)},
                   [("in_discs", "circles", "point", "verdict"), ("arcs", "circles", "point", "arcs")]),
        "plane": ({}, [("no_entries", "circles")]),
    }),
    "polygons": ("polygons", {"allowed": ALLOW}, {"groups": groups("polygons")}, {
        "some": ({"i": index_of("polygons"), "j": index_of("polygons"), "point": VECTOR},
                 [("common_point", "polygons", "i", "j", "point", "groups", "allowed")]),
        "none": ({}, [("none_counts", "polygons", "groups", "allowed")]),
        "these": ({"contacts": read_contacts("polygons", None)},
                  [("these_count", "polygons", "groups", "allowed", "contacts")]),
        "count": ({"number": NUMBER}, [("number_counts", "polygons", "groups", "allowed", "number")]),
    }),
    "valid": ("polygons", {"parts": (list, read_polygons), "rule": (str, read_rule)}, {}, {
        "valid": ({}, [("valid", "parts", "rule")]),
        "too_few_points": ({"ring": RING}, [("too_few_points", "parts", "ring")]),
        "edges_meet": ({"i": EDGE, "j": EDGE, "kind": KIND, "point": VECTOR},
                       [("contact", "edges", "i", "j", "kind", "point", "no_groups", "touch")]),
        "comes_twice": ({"ring": RING, "point": VECTOR}, [("comes_twice", "parts", "ring", "point")]),
        "misplaced": ({"ring": RING, "point": VECTOR}, [("misplaced", "parts", "ring", "point")]),
        "circle": ({"rings": (list, read_circle), "points": (list, read_points)},
                   [("circle", "parts", "rings", "points")]),
        "repeated": ({"edge": EDGE}, [("repeated", "parts", "rule", "edge")]),
        "rings_touch": ({"ring": RING, "other": RING, "point": VECTOR},
                        [("rings_touch", "parts", "rule", "ring", "other", "point")]),
    }),
    "linear_program": ("half_planes", PROGRAM, {}, {
        "one": ({"point": VECTOR}, [("feasible", "half_planes", "point"),
                                    ("bounds_only", "half_planes", "objective", "point")]),
        "many": ({"point": VECTOR}, [("feasible", "half_planes", "point"),
                                     ("bounds", "half_planes", "objective", "point"),
                                     ("ends", "half_planes", "objective", "point")]),
        "all": ({"point": VECTOR}, [("feasible", "half_planes", "point"), ("no_objective", "half_planes", "objective")]),
        "unbounded": ({"point": VECTOR}, [("feasible", "half_planes", "point"), ("goes_on", "half_planes", "objective")]),
        "infeasible": ({}, [("contradict", "half_planes")]),
    }),
}


def read_members(readers, item, where, read, optional=()):
    """The values of some members, as their readers give them; they may look at those read before them."""
    kinds = {key: kind for key, (kind, _) in readers.items()}
    more = {key: kind for key, (kind, _) in dict(optional).items()}
    values = members(item, kinds, where, more)
    for (key, (_, reader)), value in zip({**readers, **dict(optional)}.items(), values):
        read[key] = None if value is None else reader(value, "%s.%s" % (where, key), read)


def read_statement(item, tables, where):
    """What is said, for people, and what is to be checked: functions of the steps."""
    require(type(item) is dict, "F", where + " is not an object")
    question, verdict = item.get("question"), item.get("verdict")
    require(type(question) is str and question in QUESTIONS, "F", where + ".question is none that is known")
    about, given, optional, verdicts = QUESTIONS[question]
    require(about in tables, "F", "%s is about %s, which the file has not" % (where, about))
    require(type(verdict) is str and verdict in verdicts, "F", where + ".verdict is none of this question")
    more, needed = verdicts[verdict]
    said = (str, lambda value, where, read: value)
    read = {**tables, "no_groups": None, "touch": ALLOWED["touch"]}
    read_members({"question": said, **given, "verdict": said, **more, "claims": (list, said[1])}, item, where, read, optional)
    if question == "valid":
        read["edges"] = read["parts"].edges
    claims = read["claims"]
    require(len(claims) == len(needed), "F", "%s has not %d claims" % (where, len(needed)))
    checks = []
    for k, (claim, (kind, *bound)) in enumerate(zip(claims, needed)):
        place = "%s.claims[%d]" % (where, k)
        require(type(claim) is dict and claim.get("claim") == kind, "F", "%s is not the claim %s" % (place, kind))
        brings, rule = CLAIMS[kind]
        scope = {**read, "of": read[bound[0]]}
        read_members({"claim": said, **brings}, claim, place, scope)
        checks.append((rule, {key: scope[key] for key in brings}, [read[name] for name in bound]))
    return (question, description(item, read), verdict), checks


def description(item, read):
    """What a statement speaks of, in words: all of it."""
    words = []
    if "a" in item:
        words += [read[key].name for key in "ab"]
    if "parts" in item:
        words.append("polygons %s by the rule %s" % (item["parts"], item["rule"]))
    if "allowed" in item:
        words.append(item["allowed"] + " allowed")
    if "groups" in item:
        words.append("members of one of %d groups may meet" % len(set(item["groups"])))
    if "contacts" in item:
        words.append("%d contacts" % len(item["contacts"]))
    if "number" in item:
        words.append("%d contacts" % item["number"])
    if "ring" in item and "parts" not in item:
        words.append("ring %d" % item["ring"])
    if "objective" in item:
        words.append("along (%s, %s)" % tuple(item["objective"]))
    return words
