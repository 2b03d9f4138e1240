"""What a statement says, as a sentence: in the same words as the twin's (verifier/cpp/sentences.cpp)."""
import json
from collections import Counter

MOST, LONG, LONGEST = 10, 40, 100  # entries of a list, characters of a number, and of a name, that are shown

SENTENCES = {  # of the members that a statement has
    "pair": {"apart": "{a} and {b} are apart", "meet": "{a} and {b} meet at {point}",
             "touching": "{a} and {b} touch at {point}", "overlapping": "{a} and {b} overlap at {point}"},
    "distance": {"closest": "{a} and {b} are closest at {from_a} and {to_b}"},
    "common_part": {"between": "{a} and {b} have in common what is between {first} and {last}"},
    "nearest": {"point": "no point of {a} is nearer to {b}, or further within it, than its point {i}"},
    "support": {"two": "of the planes through {b}, two have all of {a} on one side and a point of it beside the line; "
                       "they touch it at its points {on_first}, and {on_last}",
                "one": "of the planes through {b}, one has all of {a} on one side; it touches it at its points {on_plane}",
                "none": "no plane through {b} has all of {a} on one side, as {point} is inside"},
    "clearance": {"kept": "{a} and {b} are {least} apart, or more",
                  "broken": "{a} and {b} are nearer than {least}, at {from_a} and {to_b}"},
    "depth": {"at_most": "{a} moved by {most}, in a direction, does not overlap {b}",
              "at_least": "{a} moved by {least}, in any direction, meets {b}"},
    "clearances": {"kept": "all pairs of the {all} are {least} apart, or more",
                   "broken": "exactly {pairs} nearer than {least}: {nearer}"},
    "motion": {"apart": "{a} and {b} are apart all along their ways",
               "meet": "{a} and {b} meet on their ways, at time {time}, at {point}",
               "first": "{a} and {b} first meet on their ways at time {time}, at {point}"},
    "meshes": {"apart": "{a} and {b} are apart", "meet": "{a} and {b} meet at {point}",
               "overlapping": "{a} and {b} overlap at {point}",
               "touching": "{a} and {b} meet at {point}, and no point is inside of both",
               "a_part_of_b": "what is inside of {a} is inside of {b} or on its triangles", "b_part_of_a": "what is inside of {b} is inside of {a} or on its triangles",
               "equal": "{a} and {b} have the same inside, but for points on their triangles",
               "a_inside_b": "{a} is inside of {b}, away from its surface",
               "b_inside_a": "{b} is inside of {a}, away from its surface",
               "a_within": "{point} of {a} is inside of {b}", "b_within": "{point} of {b} is inside of {a}"},
    "around": {"around": "{b} holds all points of {a}"},
    "mesh_body": {"apart": "{a} and {b} are apart", "meet": "{a} and {b} meet at {point}",
                  "b_within": "{point} of {b} is inside of {a}"},
    "mesh_body_clearance": {"kept": "{a} and {b} are {least} apart, or more",
                            "broken": "{a} and {b} are nearer than {least}, at {from_a} and {to_b}",
                            "b_within": "{a} and {b} are nearer than {least}, as {point} of {b} is inside of {a}"},
    "mesh_crossing": {"two": "two triangles of {a} cross at {point}",
                      "none": "no two triangles of {a} have more in common than corners, or an edge, of both"},
    "mesh_distance": {"closest": "{a} and {b} are closest at {from_a} and {to_b}"},
    "mesh_motion": {"apart": "{a} and {b} are apart all along their ways",
                    "meet": "{a} and {b} meet on their ways, at time {time}, at {point}",
                    "first": "{a} and {b} first meet on their ways at time {time}, at {point}",
                    "a_within": "{a} and {b} meet at the beginning of their ways, as {point} of {a} is inside of {b}",
                    "b_within": "{a} and {b} meet at the beginning of their ways, as {point} of {b} is inside of {a}"},
    "mesh_clearance": {"kept": "{a} and {b} are {least} apart, or more",
                       "broken": "{a} and {b} are nearer than {least}, at {from_a} and {to_b}",
                       "a_within": "{a} and {b} are nearer than {least}, as {point} of {a} is inside of {b}",
                       "b_within": "{a} and {b} are nearer than {least}, as {point} of {b} is inside of {a}"},
    "polytopes": {"apart": "{a} and {b} are apart", "meet": "{a} and {b} meet at {point}",
                  "apart_by_hyperplanes": "{a} and {b} are apart, by half-spaces that hold them"},
    "half_spaces": {"empty": "{half_spaces} is empty",
                    "bounded": "{half_spaces} is bounded, of dimension {dimension}",
                    "unbounded": "{half_spaces} is unbounded, of dimension {dimension}"},
    "half_spaces_vertices": {"vertices": "{half_spaces} is bounded, and has exactly {vertices}"},
    "half_spaces_program": {"one": "{point} is the best point of {half_spaces} along {objective}",
                            "many": "{point} is one of many best points of {half_spaces} along {objective}",
                            "all": "{point} is as good as all others of {half_spaces} along {objective}",
                            "unbounded": "there is no best point of {half_spaces} along {objective}",
                            "infeasible": "no point is in {half_spaces}"},
    "hull": {"solid": "{body} is solid, with the {n_faces} faces {faces}",
             "flat": "{body} is a polygon with the {n_outline} corners {outline}",
             "segment": "{body} is the segment between its points {i} and {j}",
             "point": "{body} is a point"},
    "polytope_hull": {"facets": "{body} has exactly {facets}",
                      "segment": "{body} is the segment between its points {i} and {j}",
                      "point": "{body} is a point"},
    "mesh": {"convex": "a mesh of {n_mesh_faces} polygons bounds {body} exactly",
             "not_convex": "a mesh of {n_mesh_faces} polygons is not exactly convex: polygon {face} is in no face of {body}"},
    "section": {"nothing": "the plane {plane} does not meet {of}",
                "touching": "the plane {plane} touches {of} at the points {corners}",
                "outlined": "the section of {of} by the plane {plane} has the {n_corners} corners {corners}",
                "measured": "the section of {of} by the plane {plane} has the {n_corners} corners {corners}, and an area "
                            "from {area_from} to {area_to}"},
    **dict.fromkeys(("segments", "circles", "boxes"), {
        "some": "{question} {i} and {j} of {all} meet at {point}: {kind}", "none": "no two of the {all} meet"}),
    "polygons": {"some": "polygons {i} and {j} of {all} meet at {point}", "none": "no two of the {all} meet",
                 "count_kinds": "of the {all}, so many pairs overlap: {overlapping}; touch: {touching}"},
    "two_polygons": "polygons {pair} of {all} are {verdict}",
    "half_planes": "the common part of {all} is {region}",
    "kernel": "the kernel of ring {ring} of {all} is {region}",
    "ring": {"simple": "ring {ring} of {all} is simple"},
    "convex_polygons_common_part": "the common part of {all} is {region}",
    "circles_common_part": {
        "empty": "the common part of {all} is empty",
        "point": "the common part of {all} is the point {point}",
        "region": "the common part of {all} is a region around {point}, bounded by {n_arcs} arcs of {arcs}"},
    "valid": {"valid": "polygons {parts} of {all}: {rule}", "too_few_points": "ring {ring} has too few points",
              "edges_meet": "edges {i} and {j} meet at {point}: {kind}",
              "comes_twice": "ring {ring} comes twice to {point}",
              "crosses": "ring {ring} crosses itself at {point}", "falls_apart": "one falls apart",
              "misplaced": "ring {ring} is misplaced at {point}", "circle": "rings {rings} close a circle",
              "repeated": "edge {edge} has no length", "rings_touch": "rings {ring} and {other} touch at {point}"},
    "linear_program": {"one": "{point} is the best point of {all} along {objective}",
                       "many": "{point} is one of many best points of {all} along {objective}",
                       "all": "{point} is as good as all others of {all} along {objective}",
                       "unbounded": "there is no best point of {all} along {objective}",
                       "infeasible": "no point is in all of {all}"},
}
ONE = {"bodies": "body", "polytopes": "polytope", "meshes": "mesh", "segments": "segment", "circles": "circle", "boxes": "box",
       "polygons": "polygon", "half_planes": "half-plane", "rings": "ring", "convex_polygons": "convex polygon"}
REGIONS = {"empty": "empty", "point": "a point", "segment": "a segment", "ray": "a ray",
           "line": "a line", "strip": "a strip", "half-plane": "a half-plane",
           "unbounded": "a region without bounds", "bounded": "a bounded region"}


def in_quotes(text, most=LONGEST):
    """The text in quotes, as one line of ASCII without control characters; of a longer one its beginning."""
    return json.dumps(text[:most]).replace("\x7f", "\\u007f") + ("..." if len(text) > most else "")


def shown(value):
    """A word, a number, a point of numbers as they stand in the file, or a list of entries."""
    if type(value) is not list:
        return str(value) if len(str(value)) <= LONG else "a number that the file has"
    if value and type(value[0]) is str:
        return "(%s)" % ", ".join(value) if max(map(len, value)) <= LONG else "a point that the file has"
    entries = [" ".join(map(str, entry)) if type(entry) is list else str(entry) for entry in value[:MOST]]
    return ", ".join(entries) + (" and %d more" % (len(value) - MOST) if len(value) > MOST else "")


def counted(n, one):
    """A number of things: "1 box", "2 boxes"."""
    for end, ends in ("ex", "ices"), ("x", "xes"), ("sh", "shes"), ("ay", "ays"), ("y", "ies"), ("", "s"):
        if one.endswith(end):
            return "1 " + one if n == 1 else "%d %s%s" % (n, one[:len(one) - len(end)], ends)


def pairs_asked(item, size):
    """How many pairs of so many members a statement is about."""
    groups = item.get("groups")
    same = sum(n * (n - 1) // 2 for n in Counter(groups).values()) if groups else 0
    return size * (size - 1) // 2 - same - sum(not groups or groups[i] != groups[j] for i, j in item.get("except", ()))


def sentence(item, things, about, size):
    """Of a statement whose form is right, of the bodies that it says, and of the table that it is about."""
    question, verdict = item["question"], item["verdict"]
    size = len(item["members"]) if "members" in item else size
    said = {key: shown(value) for key, value in item.items() if key not in ("claims", "said")}
    said.update({"n_" + key: len(value) for key, value in item.items() if type(value) is list})
    said.update({key: thing.title() for key, thing in things.items()}, all=counted(size, ONE[about]))
    meshes = sum(mesh is not None for mesh in item.get("as_meshes", ()))
    said["all"] += ", of which %d %s," % (meshes, "is a mesh" if meshes == 1 else "are meshes") if meshes else ""
    if item.get("facets"):
        said["facets"] = "%d facets, made of %d simplices of %d corners" % (
            len(item["facets"]), sum(map(len, item["facets"])), len(item["facets"][0][0]))
    if item.get("vertices"):
        said["vertices"] = counted(said["n_vertices"], "vertex")
    said["region"] = REGIONS.get(verdict, "") + (", of sides " + said["sides"] if item.get("sides") else "")
    count = said.get("n_nearer", said.get("n_kinds", said.get("n_contacts", item.get("number"))))
    if count is not None:
        said["pairs"] = counted(count, "pair") + " of the " + said["all"] + (" is" if count == 1 else " are")
    if ("allowed" in item or "members" in item) and verdict != "some" and not pairs_asked(item, size):
        text = "no pair of %s is asked about" % said["all"]
    elif verdict in ("these", "these_kinds", "count"):
        text = "exactly %s of the %s meet" % (counted(count, "pair"), said["all"]) + "s" * (count == 1)
        text += ": " + said.get("kinds", said.get("contacts")) if item.get("kinds") or item.get("contacts") else ""
    else:
        known = SENTENCES[question]
        text = (known if type(known) is str else known[verdict]).format(**said)
    if question == "valid" and verdict != "valid":
        text = "polygons %s of %s: not %s, as %s" % (said["parts"], said["all"], said["rule"], text)
    rules = [said["allowed"] + " allowed"] if said.get("allowed", "nothing") != "nothing" else []
    if rules and meshes:
        rules.append("of meshes insides alone are compared")
    if "groups" in item:
        rules.append("members of one of %d groups may meet" % len(set(item["groups"])))
    if item.get("members"):
        rules.append("members: " + said["members"])
    if meshes:
        those = ["member %d is mesh %d" % told for told in enumerate(item["as_meshes"]) if told[1] is not None]
        rules.append(", ".join(those[:MOST]) + (" and %d more" % (meshes - MOST) if meshes > MOST else ""))
    if item.get("except"):
        rules.append("%s not asked about: %s" % (counted(said["n_except"], "pair"), said["except"]))
    text += " (%s)" % ", ".join(rules) if rules else ""
    return text + "".join("; %s is said to be made of %s" % (thing.name, thing.said)
                          for thing in things.values() if thing.said)
