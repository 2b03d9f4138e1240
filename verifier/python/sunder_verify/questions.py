"""Which claims prove which statement, as data: docs/claims.md, "Statements".

A statement says its question, what it is about, and its verdict; its claims follow in the order of the table. Each is
checked by its rule, told what the table binds it to: so a true claim about something else proves nothing.
"""
# long because: the table of all statements is one list, and so is that of their shapes
from functools import partial

from . import arcs, boundaries, depths, hulls, meshes, polygons, polytopes, rules, sections, vertices
from .reader import (LIST, MOST_NUMBER, OBJECT, anything, common, double, form, index, list_of, members, number,
                     numbers, row_of)
from .said import notes
from .sentences import sentence
from .tables import dot

MOST_WEIGHTS = 16  # of one combination; d + 1 are always enough
MOST_MULTIPLIERS = 64
MOST_OF_HALF_SPACES = 256
ALLOWED = {  # which kinds of contact do not count
    "nothing": (),
    "shared-endpoint": ("shared-endpoint", "touching"),
    "touch": ("shared-endpoint", "touch", "touching"),
}
ALONE = range(MOST_NUMBER)  # as groups: each is one of its own


# ---- Shapes of what is said. Indices are mostly of the subject: the first thing that a claim, or the first claim of a
# statement, is bound to.

def found(read, name):
    """What has been read by that name, or an attribute of it."""
    if name in read:
        return read[name]
    table, attribute = name.split(".")
    return getattr(read[table], attribute)


def subject(read):
    return found(read, read["subject"])


def entry(table):
    return lambda value, where, read: read[table][index(value, len(read[table] or ()), where)]


def body_asked(value, where, read):
    is_beside_mesh = read["question"] in ("mesh_body", "mesh_body_clearance", "around") and "a" in read
    body = entry("bodies" if is_beside_mesh else read["about"])(value, where, read)
    form(read["question"] != "around" or not body.linear and is_of_points(body), where + " is an image, or not of points in space")
    form(read["question"] != "support" or "a" in read or is_of_points(body), where + " is not of points in space")
    form(read["question"] not in ("distance", "common_part", "nearest", "support") or not body.kind, where + " has a radius")
    form(read["question"] != "nearest" or "a" in read or body.count == len(body), where + " is not bounded")
    form(read["question"] != "depth" or (body.dimension <= 3 and body.count == len(body)),
         where + " is not bounded, in the plane or in space")
    form("a" not in read or read["a"].dimension == body.dimension,
         where.rpartition(".")[0] + " is of bodies of different dimensions")
    return body


def matrix(body):
    """Of what places a body, as integers in units of 2^e; and e."""
    d = body.dimension
    return (body.linear, body.turned) if body.linear else ([int(k % (d + 1) == 0) for k in range(d * d)], 0)


def is_placed_alike(one, other):
    return all(x == y for (m, e), (n, f) in (
        (matrix(one), matrix(other)), ((one.translation, one.moved), (other.translation, other.moved)))
        for x, y in (rules.aligned(x, e, y, f) for x, y in zip(m, n)))


def end_of(name):
    """Where the body of that name is at the end of its way: the same one, placed by the same matrix."""
    def read_end(value, where, read):
        begin, end = read[name], entry(read["about"])(value, where, read)
        (m, e), (n, f) = matrix(begin), matrix(end)
        form(begin.base == end.base and all(x == y for x, y in (rules.aligned(x, e, y, f) for x, y in zip(m, n))),
             where + " is not the same body, moved")
        return end
    return read_end


def meshes_of_members(value, where, read):
    """For each member null, or a mesh that is placed as it is: its index, and the indices of what both are images of."""
    def read_mesh(entry_, place, _, body):
        if entry_ is None:
            return None
        mesh = entry("meshes")(entry_, place, read)
        form(is_of_points(body) and is_placed_alike(body, mesh), place + " is not placed as its member")
        return entry_, mesh.base, body.base
    members_ = [read["bodies"][k] for k in read["members"]]
    form(len(LIST(value, where)) == len(members_), where + " is not as long as what it is about")
    return [read_mesh(one, where + " entry", read, body) for one, body in zip(value, members_)]


def part_of_time(value, where, read):
    n, d, e = number(value, where)
    form(0 <= n and rules.aligned(n, e, d, 0)[0] <= rules.aligned(n, e, d, 0)[1], where + " is not from 0 to 1")
    return n, d, e


def index_of(name):
    return lambda value, where, read: index(value, len(found(read, name)), where)


def subject_index(value, where, read):
    return index(value, len(subject(read)), where)


def positive(value, where, read):
    result = double(value, where)
    form(result[0] > 0, where + " is not positive")
    return result


def whole(least):
    return lambda value, where, read: index(value, MOST_NUMBER + 1, where, least)


def choice(names):
    def read_choice(value, where, read):
        form(type(value) is str and value in names, "%s is none of %s" % (where, ", ".join(names)))
        return value
    return read_choice


def kind(value, where, read):
    table = type(subject(read))
    return choice(rules.MEETING[table][2] if table in rules.MEETING else rules.KINDS)(value, where, read)


def in_order(pairs):
    return all(i < j for i, j, *_ in pairs) and all(c[:2] < d[:2] for c, d in zip(pairs, pairs[1:]))


def contacts(value, where, read):
    entries = list_of(row_of(subject_index, subject_index, *([kind] if type(subject(read)) in rules.MEETING else [])))
    result = entries(value, where, read)
    form(in_order(result), where + " is not in order")
    return result


def kinds(value, where, read):
    """Of polygons that meet, and how."""
    result = list_of(row_of(subject_index, subject_index, choice(("overlapping", "touching"))))(value, where, read)
    form(in_order(result), where + " is not in order")
    return result


def some_contacts(value, where, read):
    result = contacts(value, where, read)
    form(result, where + " is empty")
    return result


def half_spaces(value, where, read):
    given = entry("polytopes")(value, where, read)
    form(not given.is_of_points and not given.linear, where + " is not of half-spaces, or placed")
    form(len(given), where + " is of no half-spaces")
    return given


def objective(value, where, read):
    return numbers(value, read["half_spaces"].dimension if "half_spaces" in read else 2, double, where)


def vector(value, where, read):
    dimensions = {read[key].dimension for key in ("a", "b", "half_spaces") if key in read} or {2}
    form(len(dimensions) == 1, where + " is of bodies of different dimensions")
    return numbers(value, dimensions.pop(), number, where)


def end(value, where, read):
    return row_of(vector, subject_index)(value, where, read) if value is not None else None


def events(value, where, read):
    size = len(subject(read).edges)
    for k, event in enumerate(LIST(value, where)):
        place = "%s[%d]" % (where, k)
        form(type(event) is list and len(event) > 1, place + " is not a list of 2 or more")
        index(event[0], 2 * size, place, -1)
        index(event[1], size, place, -1)
        for s in event[2:]:
            index(s, size, place)
    return value


def weights(value, where, read):
    if read["about"] == "polytopes":
        return some_weights("subject", True, MOST_WEIGHTS)(value, where, read)
    result = list_of(row_of(subject_index, number))(value, where, read)
    form(0 < len(result) <= MOST_WEIGHTS, "%s has not 1 to %d entries" % (where, MOST_WEIGHTS))
    form(len({k for k, _ in result}) == len(result), where + " names something twice")
    return result


def some_weights(whose, of_points, most):
    """Of a polytope that is of points, or of half-spaces; of others none."""
    def read_some_weights(value, where, read):
        body = read[read[whose]] if whose == "subject" else read[whose]
        if body.is_of_points != of_points:
            form(value == [], where + " is not empty")
            return []
        result = list_of(row_of(lambda k, place, _: index(k, len(body), place), number))(value, where, read)
        form(of_points <= len(result) <= most, "%s has not %d to %d entries" % (where, of_points, most))
        form(len({k for k, _ in result}) == len(result), where + " names something twice")
        return result
    return read_some_weights


def rays_from(name):
    """Of each the triangle at whose first corner it begins, and its direction."""
    return lambda value, where, read: list_of(row_of(
        lambda t, place, _: index(t, len(read[name].triangles), place), vector))(value, where, read)


def multipliers(value, where, read):
    given = read["half_spaces"]
    result = list_of(row_of(lambda k, place, _: index(k, len(given), place), number))(value, where, read)
    form(len(result) <= MOST_OF_HALF_SPACES, "%s has not 0 to %d entries" % (where, MOST_OF_HALF_SPACES))
    form(len({k for k, _ in result}) == len(result), where + " names something twice")
    return result


def cones_of_vertices(value, where, read):
    """Of each vertex lists of half-spaces, as many as there are dimensions."""
    given = read["half_spaces"]
    cone = list_of(lambda k, place, _: index(k, len(given), place),
                   lambda those, _: len({*those}) == len(those) == given.dimension,
                   " has not as many half-spaces as there are dimensions, each once")
    fan = list_of(cone, lambda those, _: those, " is empty")
    return list_of(fan, lambda those, _: len(those) == len(read["vertices"]), " is not as long as the vertices")(value, where, read)


def places(value, where, read):
    return list_of(lambda entry, place, _: members(entry, {"point": vector}, place, dict(read))["point"])(value, where, read)


def some_places(value, where, read):
    result = places(value, where, read)
    form(result, where + " is empty")
    return result


def surface_end(name):
    """Of a hull the index of a point, or weights; of others the weights, the point and, of an ellipsoid, where it is from."""
    def read_end(value, where, read):
        body, told = read[name], {**read, "subject": name}
        if body.kind in (None, "radius") and type(value) is not dict:
            return [(index(value, len(body), where), (1, 1, 0))], None, None
        shapes = {"weights": weights}
        if body.kind not in (None, "radius"):
            shapes["point"] = vector
        if body.kind == "ellipsoid":
            shapes["from"] = vector
        end = members(value, shapes, where, told)
        return end["weights"], end.get("point"), end.get("from")
    return read_end


def not_negative(value, where, read):
    result = double(value, where)
    form(result[0] >= 0, where + " is negative")
    return result


def planes_around(whose):
    """Of a polytope of points half-spaces; of others none."""
    def read_planes(value, where, read):
        form(read[whose].is_of_points or value == [], where + " is not empty")
        width = read[whose].dimension + 1
        form(len(LIST(value, where)) % width == 0, where + " is no whole number of half-spaces")
        row = numbers(value, len(value), number, where)
        return [row[k:k + width] for k in range(0, len(row), width)]
    return read_planes


def some_multipliers(whose):
    """Of half-spaces: those of the polytope, or around it."""
    def read_some_multipliers(value, where, read):
        body = read[whose]
        size = len(read["planes_" + whose]) if body.is_of_points else len(body)
        result = list_of(row_of(lambda k, place, _: index(k, size, place), number))(value, where, read)
        form(len(result) <= MOST_MULTIPLIERS, "%s has not 0 to %d entries" % (where, MOST_MULTIPLIERS))
        form(len({k for k, _ in result}) == len(result), where + " names something twice")
        return result
    return read_some_multipliers


def place_in(value, where, read):
    """Of a polytope of half-spaces; of others none."""
    body = read[read["subject"]]
    return numbers(value, 0 if body.is_of_points else body.dimension, number, where)


def corner(value, where, read):
    """A corner is between two sides: of those that do not go round, none is after the last one."""
    return index(value, len(read["sides"]) - (read["verdict"] in ("ray", "unbounded")), where)


def parts(value, where, read):
    which = list_of(index_of("polygons"))(value, where, read)
    form(0 < len(set(which)) == len(which), where + " names none, or one twice")
    return read["polygons"].some(read["steps"], which)


def pair(value, where, read):
    form(type(value) is list and len(value) == 2, where + " is not a list of 2")
    return parts(value, where, read)


def members_of(name, fits, words):
    return list_of(index_of(name), lambda those, read: fits(those) and len(set(those)) == len(those), words)


def is_of_points(body):
    return body.count == len(body) and body.dimension == 3 and not body.kind


def points_alone(value, where, read):
    body = entry("bodies")(value, where, read)
    is_any = read["question"] == "polytope_hull" and body.count == len(body) and not body.kind
    form(body.linear is None and (is_any or is_of_points(body)), where + " is not of points in space")
    return body


def facets(value, where, read):
    """Lists of simplices, which are lists of corners, all of as many: two, or up to as many as there are dimensions."""
    result = list_of(list_of(list_of(subject_index)))(value, where, read)
    sizes = {len(simplex) if len({*simplex}) == len(simplex) else 0 for facet in result for simplex in facet}
    form(all(result) and len(sizes) == 1 and 2 <= max(sizes) <= subject(read).dimension,
         where + " are no simplices of as many corners")
    return result


def homes_in_simplices(value, where, read):
    """For each point null, or a simplex, counted through facets."""
    count = sum(map(len, read["facets"]))
    return for_each(lambda home, place, _: None if home is None else index(home, count, place))(value, where, read)


def points_placed(value, where, read):
    body = entry("bodies")(value, where, read)
    form(is_of_points(body), where + " is not of points in space")
    return body


def plane(value, where, read):
    """Its normal and level, as integers of one unit; given as the normal, a point, and how far above that, times it."""
    row, _, e = common(numbers(value, 7, double, where))
    form(any(row[:3]), where + " has no direction")
    up, down = max(-e, 0), max(e, 0)
    return *(n << up for n in row[:3]), (dot(row[:3], row[3:6]) << down) + (row[6] << up)


def corner_of_section(value, where, read):
    return tuple(row_of(subject_index, subject_index)(value, where, read))


def home(value, where, read):
    """Of a vertex none; else a face, and which two of its corners are one with its first."""
    if value is None:
        return None
    face, _ = row_of(index_of("faces"), lambda corner, *_: corner)(value, where, read)
    return face, index(value[1], len(read["faces"][face]) - 1, where, 1)


def for_each(shape):
    return list_of(shape, lambda those, read: len(those) == len(subject(read)), " is not as long as what it is about")


ARCS = list_of(subject_index, lambda those, read: 0 < len(those) <= 2 * len(subject(read)),
               " is empty, or has more than two arcs a circle")
FACE = list_of(subject_index, lambda those, read: len(those) > 2, " has fewer than three corners")
GIVEN = {  # what questions say
    "a": body_asked, "b": body_asked, "to_a": end_of("a"), "to_b": end_of("b"), "ring": entry("rings"), "parts": parts, "pair": pair,
    "members": members_of("bodies", lambda those: those, " is empty, or names one twice"), "except": contacts,
    "body": points_alone, "of": points_placed, "plane": plane, "rule": choice(("valid", "simple", polygons.SELF_TOUCH)),
    "allowed": lambda *told: ALLOWED[choice(ALLOWED)(*told)], "groups": for_each(whole(-MOST_NUMBER)),
    "least": positive, "objective": objective, "half_spaces": half_spaces, "as_meshes": meshes_of_members,
    "mesh_faces": list_of(FACE, lambda those, read: those, " is empty"),
}
SAID = {  # what verdicts and claims say
    "i": subject_index, "j": subject_index, "k": subject_index, "l": subject_index, "kind": kind,
    "on_first": list_of(index_of("a")), "on_last": list_of(index_of("a")), "on_plane": list_of(index_of("a")), "point": vector, "from_a": vector, "to_b": vector,
    "contacts": contacts, "nearer": some_contacts, "number": whole(0), "sides": list_of(subject_index), "arcs": ARCS,
    "ring": index_of("parts.rings"), "other": index_of("parts.rings"), "edge": index_of("parts.edges"), "face": index_of("mesh_faces"),
    "rings": members_of("parts.rings", lambda those: len(those) > 1, " is not of two rings or more, each once"),
    "points": list_of(vector, lambda those, read: len(those) == len(read["rings"]), " is not as long as the rings"),
    "faces": list_of(FACE, lambda those, read: those, " is empty"), "homes": for_each(home), "outline": FACE,
    "facets": facets, "simplices": homes_in_simplices,
    "sectors": for_each(lambda value, where, read: None if value is None else index_of("outline")(value, where, read)),
    "corners": list_of(corner_of_section, lambda those, read: 0 < len(set(those)) == len(those),
                       " is empty, or names one twice"),
    "along": list_of(whole(0), lambda those, read: len(those) == len(read["corners"]), " is not as long as the corners"),
    "of_a": some_weights("a", False, MOST_MULTIPLIERS), "of_b": some_weights("b", False, MOST_MULTIPLIERS),
    "planes_a": planes_around("a"), "planes_b": planes_around("b"), "by_a": some_multipliers("a"),
    "by_b": some_multipliers("b"),
    **dict.fromkeys(("triangle", "other_triangle"), lambda value, where, read: index(value, len(subject(read).triangles), where)),
    "cuts": list_of(whole(-MOST_NUMBER)), "directions": list_of(vector), "rays_a": rays_from("a"), "rays_b": rays_from("b"),
    **dict.fromkeys(("rays_inner", "rays_outer", "rays_first", "rays_second"), list_of(row_of(whole(0), vector))),
    "holders": list_of(list_of(index_of("b"), lambda those, read: len({*those}) == len(those) in (1, 3, 4),
                               " is not of one, three or four points, each once")),
    "held": for_each(index_of("holders")),
    "until": list_of(whole(-MOST_NUMBER)), "away": list_of(vector),
    "planes": list_of(row_of(*4 * [number])), "cells": list_of(vector),
    "at": place_in, "multipliers": multipliers, "as_good": vector, "spanned_by": places,
    "vertices": some_places, "fans": cones_of_vertices,
    "dimension": lambda value, where, read: index(value, read["half_spaces"].dimension + 1, where),
    "most": not_negative, "least": positive, "area_from": not_negative, "area_to": not_negative,
    "kinds": kinds, "overlapping": whole(0), "touching": whole(0),
    "beneath": list_of(whole(0), lambda those, read: len(those) == len(read["mesh_faces"]), " is not as long as the faces"),
    "differences": list_of(row_of(surface_end("a"), surface_end("b"))),
    "triangles": lambda value, where, read: list_of(row_of(*read["a"].dimension * [index_of("differences")]))(
        value, where, read),
    "time": part_of_time, "direction": vector, "before": vector, "after": vector, "first": vector, "last": vector, "from": vector, "weights": weights, "other_weights": weights, "events": events, "cones": for_each(corner), "parts": list_of(ARCS),
    "ends": list_of(end, lambda those, read: len(those) == 2, " is not a list of 2"),
    "order": list_of(subject_index, lambda those, read: len(set(those)) == len(those) == len(subject(read)),
                     " does not name each once"),
}

# ---- Claims: their rule, and what they bring.

CLAIMS = {
    **{rule.__name__: (rule,) for rule in (
        rules.slab, rules.nearer, rules.feasible, rules.no_objective, rules.in_discs, rules.contact,
        polygons.common_point, polygons.too_few_points, polygons.comes_twice, polygons.crosses, polygons.misplaced,
        polygons.circle, polygons.repeated, polygons.rings_touch, rules.each_pair, rules.each_clearance,
        hulls.between, hulls.one_point, hulls.leaves_hull, sections.beyond, sections.touches, sections.area)},
    **{rule.__name__: (rule, "weights") for rule in (rules.bounds, rules.contradict, rules.powers)},
    **{rule.__name__: (rule, "weights", "from") for rule in (rules.holds, rules.holds_at, rules.inside)},  # from: of ellipsoids only
    **{name: (polygons.exactly(name), "events") for name in ("none_counts", "these_count", "number_counts")},
    "these_kinds": (polygons.exactly("these_kinds", polygons.kinds_of_polygons), "events"),
    "kinds_count": (polygons.kinds_count, "events"), "how_two_meet": (polygons.how_two_meet, "events"),
    "bounds_only": (partial(rules.bounds, is_only=True), "weights"),
    "keeps": (polytopes.keeps, "weights", "at"),
    "parted_by": (polytopes.parted_by, "direction", "of_a", "of_b"),
    "parted_by_hyperplanes": (polytopes.parted_by_hyperplanes, "direction", "planes_a", "by_a", "planes_b", "by_b"),
    **{rule.__name__: (rule, "multipliers") for rule in (
        polytopes.contradicted, polytopes.spans, polytopes.enclosed, polytopes.tops)},
    "tops_only": (partial(polytopes.tops, is_only=True), "multipliers"),
    **{rule.__name__: (rule, "cuts", "directions", "rays_a", "rays_b") for rule in (
        meshes.covered, meshes.covered_apart, meshes.covered_clear, meshes.covered_all_along, meshes.covered_before)},
    "no_crossings": (meshes.no_crossings, "cuts", "directions"),
    "covered_within": (meshes.covered_within, "cuts", "directions", "rays_inner", "rays_outer"),
    **{rule.__name__: (rule, "until", "directions", "away") for rule in (meshes.beside, meshes.clear_beside)},
    **{rule.__name__: (rule, "cuts", "planes", "cells", "rays_first", "rays_second") for rule in (
        meshes.insides_apart, meshes.part_of, meshes.equal_insides)},
    "around": (meshes.around, "holders", "held"),
    **{rule.__name__: (rule, "triangle", "weights") for rule in (meshes.on_triangle, meshes.on_triangle_at)},
    "triangles_cross": (meshes.triangles_cross, "triangle", "weights", "other_triangle", "other_weights"),
    "encloses": (meshes.encloses, "direction"),
    "normal_fan": (vertices.normal_fan, "fans"),
    "recedes": (polytopes.recedes, "direction"), "rises": (polytopes.rises, "direction"),
    "another": (polytopes.another,),
    **{rule.__name__: (rule, "direction") for rule in (rules.parted, rules.parted_all_along, rules.not_before)},
    "clear": (rules.clear, "direction"),
    "leaves": (partial(rules.clear, rule="leaves", way=1, words="overlap by more than the stated depth"), "direction"),
    "first_along": (rules.first_along, "direction"),
    "wedge": (rules.wedge, "before", "after"),
    "rests": (rules.rests, "direction"),
    "full": (rules.full, "i", "j", "k", "l"),
    "no_further": (rules.no_further, "before", "after"),
    "surrounds": (depths.surrounds, "differences", "triangles"),
    "parted_weakly": (partial(rules.parted, is_weak=True), "direction"),
    "surface": (hulls.surface, "homes"),
    "bounds_hull": (hulls.bounds_hull, "beneath"),
    "outline": (hulls.outline, "sectors"),
    "boundary": (boundaries.boundary, "simplices"),
    "outlined": (sections.outlined, "along"),
    "goes_on": (rules.goes_on, "direction"),
    "ends": (rules.ends, "ends"),
    "cones": (rules.cones, "cones"),
    "arcs": (arcs.arcs, "parts"),
    "cover": (polygons.exactly("cover"), "order"),
    "valid": (polygons.valid, "events"),
    "falls_apart": (polygons.falls_apart, "events"),
}


# ---- Statements.

def region(given):
    """What is the common part of half-planes?"""
    kinds = ("point", "segment", "ray", "line", "strip", "half-plane", "unbounded", "bounded")
    return {"empty": "contradict " + given, **dict.fromkeys(kinds, "cones %s verdict sides" % given)}


def meetings(table, some, none, these, count, more=()):
    """Which entries of a table have a contact that counts?"""
    of = " %s groups allowed" % table
    return table, "allowed groups", {
        "some": some, "none": none + of, "these": these + of + " contacts", "count": count + of + " number",
        **dict(more)}


# Of each question the table that it is about, and what it says; of each verdict its claims, each with what it is bound
# to. What claims are bound to, and is neither a table nor said by the question, a statement of that verdict says, too.
QUESTIONS = {
    "pair": ("bodies", "a b", {
        "apart": "parted a b",
        "meet": "holds a point, holds b point",
        "touching": "holds a point, holds b point, parted_weakly a b",
        "overlapping": "inside a point, inside b point",
    }),
    "distance": ("bodies", "a b", {"closest": "holds a from_a, holds b to_b, slab a b from_a to_b"}),
    "common_part": ("bodies", "a b", {
        "between": "holds a first, holds b first, holds a last, holds b last, no_further a b first last"}),
    "nearest": ("bodies", "a b", {"point": "first_along a b i"}),
    "support": ("bodies", "a b", {
        "two": "wedge a b on_first on_last", "one": "rests a b on_plane",
        "none": "inside a point, holds b point, full a"}),
    "clearance": ("bodies", "a b least", {
        "kept": "clear a b least",
        "broken": "holds a from_a, holds b to_b, nearer from_a to_b least",
    }),
    "depth": ("bodies", "a b", {"at_most": "leaves a b most", "at_least": "surrounds a b least"}),
    "motion": ("bodies", "a b to_a to_b", {
        "apart": "parted_all_along a b to_a to_b",
        "meet": "holds_at a to_a time point, holds_at b to_b time point",
        "first": "holds_at a to_a time point, holds_at b to_b time point, not_before a b to_a to_b time point",
    }),
    "bodies": ("bodies", "members allowed groups except as_meshes", {
        "these": "each_pair members groups except allowed as_meshes PROVED contacts"}),
    "clearances": ("bodies", "members groups except least as_meshes", {
        "kept": "each_clearance members groups except least as_meshes PROVED",
        "broken": "each_clearance members groups except least as_meshes PROVED nearer"}),
    "around": ("meshes", "a b", {"around": "around a b"}),
    "meshes": ("meshes", "a b", {
        "apart": "covered a b",
        "meet": "on_triangle a point, on_triangle b point",
        "overlapping": "encloses a point, encloses b point",
        "touching": "on_triangle a point, on_triangle b point, insides_apart a b",
        "a_part_of_b": "part_of a b", "b_part_of_a": "part_of b a", "equal": "equal_insides a b",
        "a_inside_b": "covered_within a b", "b_inside_a": "covered_within b a",
        "a_within": "on_triangle a point, encloses b point",
        "b_within": "encloses a point, on_triangle b point"}),
    "mesh_body": ("meshes", "a b", {
        "apart": "beside a b", "meet": "on_triangle a point, holds b point",
        "b_within": "encloses a point, holds b point"}),
    "mesh_body_clearance": ("meshes", "a b least", {
        "kept": "clear_beside a b least",
        "broken": "on_triangle a from_a, holds b to_b, nearer from_a to_b least",
        "b_within": "encloses a point, holds b point"}),
    "mesh_crossing": ("meshes", "a", {"two": "triangles_cross a point", "none": "no_crossings a"}),
    "mesh_distance": ("meshes", "a b", {
        "closest": "on_triangle a from_a, on_triangle b to_b, covered_apart a b from_a to_b"}),
    "mesh_motion": ("meshes", "a b to_a to_b", {
        "apart": "covered_all_along a b to_a to_b",
        "meet": "on_triangle_at a to_a time point, on_triangle_at b to_b time point",
        "first": "on_triangle_at a to_a time point, on_triangle_at b to_b time point, covered_before a b to_a to_b time",
        "a_within": "on_triangle a point, encloses b point",
        "b_within": "encloses a point, on_triangle b point"}),
    "mesh_clearance": ("meshes", "a b least", {
        "kept": "covered_clear a b least",
        "broken": "on_triangle a from_a, on_triangle b to_b, nearer from_a to_b least",
        "a_within": "on_triangle a point, encloses b point",
        "b_within": "encloses a point, on_triangle b point"}),
    "polytopes": ("polytopes", "a b", {
        "apart": "parted_by a b",
        "apart_by_hyperplanes": "parted_by_hyperplanes a b",
        "meet": "keeps a point, keeps b point",
    }),
    "half_spaces": ("polytopes", "half_spaces", {
        "empty": "contradicted half_spaces",
        "bounded": "spans half_spaces dimension spanned_by, enclosed half_spaces",
        "unbounded": "spans half_spaces dimension spanned_by, recedes half_spaces",
    }),
    "half_spaces_vertices": ("polytopes", "half_spaces", {"vertices": "normal_fan half_spaces vertices"}),
    "half_spaces_program": ("polytopes", "half_spaces objective", {
        "one": "keeps half_spaces point, tops_only half_spaces objective point",
        "many": "keeps half_spaces point, tops half_spaces objective point, keeps half_spaces as_good, "
                "another half_spaces objective point as_good",
        "all": "keeps half_spaces point, no_objective half_spaces objective",
        "unbounded": "keeps half_spaces point, rises half_spaces objective",
        "infeasible": "contradicted half_spaces",
    }),
    "hull": ("bodies", "body", {
        "solid": "surface body faces",
        "flat": "outline body outline",
        "segment": "between body i j",
        "point": "one_point body",
    }),
    "polytope_hull": ("bodies", "body", {
        "facets": "boundary body facets",
        "segment": "between body i j",
        "point": "one_point body",
    }),
    "mesh": ("bodies", "body mesh_faces", {"convex": "bounds_hull body mesh_faces PROVED",
                                                          "not_convex": "leaves_hull body mesh_faces face PROVED"}),
    "section": ("bodies", "of plane", {
        "nothing": "beyond of plane",
        "touching": "touches of plane corners",
        "outlined": "outlined of plane corners PROVED",
        "measured": "outlined of plane corners PROVED, area of plane corners area_from area_to",
    }),
    "segments": meetings("segments", "contact segments i j kind point groups allowed",
                         "none_counts", "these_count", "number_counts"),
    "circles": meetings("circles", "contact circles i j kind point groups allowed", "cover", "cover", "cover"),
    "boxes": meetings("boxes", "contact boxes i j kind point groups allowed", "cover", "cover", "cover"),
    "polygons": meetings("polygons", "common_point polygons i j point groups allowed",
                         "none_counts", "these_count", "number_counts", {
        "these_kinds": "these_kinds polygons groups allowed kinds",
        "count_kinds": "kinds_count polygons groups allowed overlapping touching"}),
    "two_polygons": ("polygons", "pair", dict.fromkeys(
        ("apart", "touching", "overlapping"), "how_two_meet pair verdict")),
    "half_planes": ("half_planes", "", region("half_planes")),
    "kernel": ("rings", "ring", region("ring")),
    "ring": ("rings", "ring", {"simple": "valid ring.alone SIMPLE"}),
    "convex_polygons_common_part": ("convex_polygons", "", region("convex_polygons")),
    "circles_common_part": ("circles", "", {
        "empty": "powers circles verdict",
        "point": "in_discs circles point verdict, powers circles verdict",
        "region": "in_discs circles point verdict, arcs circles point arcs",
    }),
    "valid": ("polygons", "parts rule", {
        "valid": "valid parts rule",
        "too_few_points": "too_few_points parts ring",
        "edges_meet": "contact parts.edges i j kind point ALONE TOUCH",
        "comes_twice": "comes_twice parts rule ring point",
        "crosses": "crosses parts ring point",
        "misplaced": "misplaced parts ring point",
        "circle": "circle parts rings points",
        "falls_apart": "falls_apart parts",
        "repeated": "repeated parts rule edge",
        "rings_touch": "rings_touch parts rule ring other point",
    }),
    "linear_program": ("half_planes", "objective", {
        "one": "feasible half_planes point, bounds_only half_planes objective point",
        "many": "feasible half_planes point, bounds half_planes objective point, ends half_planes objective point",
        "all": "feasible half_planes point, no_objective half_planes objective",
        "unbounded": "feasible half_planes point, goes_on half_planes objective",
        "infeasible": "contradict half_planes",
    }),
}


def statement(item, where, read):
    """The statement; it as a sentence; and what is to be checked: rules, and what they are told."""
    question, verdict = OBJECT(item, where).get("question"), item.get("verdict")
    form(type(question) is str and question in QUESTIONS, where + ".question is none that is known")
    about, given, verdicts = QUESTIONS[question]
    form(read["tables"]["sizes"].get(about), "%s is about %s, of which the file has none" % (where, about))
    form(type(verdict) is str and verdict in verdicts, where + ".verdict is none of this question")
    needed = [claim.split() for claim in verdicts[verdict].split(", ")]
    given = {name: GIVEN[name] for name in given.split()}
    says = {name: SAID[name] for _, *bound in needed for name in bound if name in SAID and name not in given}
    scope = {**read["tables"], "steps": read["steps"], "ALONE": ALONE, "TOUCH": ALLOWED["touch"], "SIMPLE": "simple", "PROVED": read["proved"],
             "inputs": read["inputs"], "subject": needed[0][1], "about": about}
    shapes = {"question": anything, **given, "verdict": anything, **says, "claims": LIST, "said": notes}
    members(item, shapes, where, scope, {"groups": ALONE, "as_meshes": None, "said": ""})
    form(len(item["claims"]) == len(needed), "%s has not %d claims" % (where, len(needed)))
    checks = []
    for k, (claim, (name, *bound)) in enumerate(zip(item["claims"], needed)):
        place = "%s.claims[%d]" % (where, k)
        form(type(claim) is dict and claim.get("claim") == name, "%s is not the claim %s" % (place, name))
        rule, *brings = CLAIMS[name]
        has = [key for key in brings if key != "from" or found(scope, bound[0]).kind == "ellipsoid"]
        shapes = {"claim": anything, **{key: SAID[key] for key in has}}
        brought = members(claim, shapes, place, {**scope, "subject": bound[0]})
        checks.append((rule, [brought.get(key) for key in brings] + [found(scope, key) for key in bound]))
    things = {key: scope[key] for key in ("a", "b", "body", "of", "half_spaces") if key in item}
    of_table = read["said"].get(about, "")
    return item, sentence(item, things, about, read["tables"]["sizes"][about]) + of_table + scope["said"], checks
