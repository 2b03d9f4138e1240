"""What a statement says, as a sentence: in the same words as the twin's (verifier/cpp/sentences.cpp)."""
import json

MOST, LONG, LONGEST = 10, 40, 100  # entries of a list, characters of a number, and of a name, that are shown

SENTENCES = {  # of the members that a statement has
    "pair": {"apart": "{a} and {b} are apart", "meet": "{a} and {b} meet at {point}",
             "touching": "{a} and {b} touch at {point}", "overlapping": "{a} and {b} overlap at {point}"},
    "distance": {"closest": "{a} and {b} are closest at {from_a} and {to_b}"},
    "clearance": {"kept": "{a} and {b} are {least} apart, or more",
                  "broken": "{a} and {b} are nearer than {least}, at {from_a} and {to_b}"},
    "depth": {"at_most": "{a} moved by {most}, in a direction, does not overlap {b}",
              "at_least": "{a} moved by {least}, in any direction, meets {b}"},
    "clearances": {"kept": "all pairs of bodies are {least} apart, or more",
                   "broken": "exactly these pairs of bodies are nearer than {least}: {nearer}"},
    "motion": {"apart": "{a} and {b} are apart all along their ways",
               "meet": "{a} and {b} meet on their ways, at time {time}, at {point}",
               "first": "{a} and {b} first meet on their ways at time {time}, at {point}"},
    "polytopes": {"apart": "{a} and {b} are apart", "meet": "{a} and {b} meet at {point}",
                  "apart_by_hyperplanes": "{a} and {b} are apart, by half-spaces that hold them"},
    "half_spaces": {"empty": "the common part of the half-spaces of {half_spaces} is empty",
                    "bounded": "the common part of the half-spaces of {half_spaces} is bounded, of dimension {dimension}",
                    "unbounded": "the common part of the half-spaces of {half_spaces} is unbounded, of dimension {dimension}"},
    "half_spaces_vertices": {"vertices": "the common part of the half-spaces of {half_spaces} is bounded, and has exactly {vertices}"},
    "half_spaces_program": {"one": "{point} is the best point of the half-spaces of {half_spaces} along {objective}",
                            "many": "{point} is one of many best points of the half-spaces of {half_spaces} along {objective}",
                            "all": "{point} is as good as all others of the half-spaces of {half_spaces} along {objective}",
                            "unbounded": "there is no best point of the half-spaces of {half_spaces} along {objective}",
                            "infeasible": "no point is in all half-spaces of {half_spaces}"},
    "hull": {"solid": "the hull of {body} is solid, with the faces {faces}",
             "flat": "the hull of {body} is a polygon with the corners {outline}",
             "segment": "the hull of {body} is the segment between its points {i} and {j}",
             "point": "the hull of {body} is a point"},
    "polytope_hull": {"facets": "the hull of {body} has exactly {facets}",
                      "segment": "the hull of {body} is the segment between its points {i} and {j}",
                      "point": "the hull of {body} is a point"},
    "section": {"nothing": "the plane {plane} does not meet {of}",
                "touching": "the plane {plane} touches {of} at the points {corners}",
                "outlined": "the section of {of} by the plane {plane} has the corners {corners}"},
    "segments": {"some": "segments {i} and {j} meet at {point}: {kind}", "none": "no two segments meet"},
    "circles": {"some": "circles {i} and {j} meet at {point}: {kind}", "none": "no two circles meet"},
    "boxes": {"some": "boxes {i} and {j} meet at {point}: {kind}", "none": "no two boxes meet"},
    "polygons": {"some": "polygons {i} and {j} meet at {point}", "none": "no two polygons meet"},
    "half_planes": "the common part of the half-planes is {region}",
    "kernel": "the kernel of ring {ring} is {region}",
    "convex_polygons_common_part": "the common part of the convex polygons is {region}",
    "circles_common_part": {
        "empty": "the common part of the circles is empty", "plane": "the common part of the circles is the plane",
        "point": "the common part of the circles is the point {point}",
        "region": "the common part of the circles is a region around {point}, bounded by arcs of {arcs}"},
    "valid": {"valid": "polygons {parts}: {rule}", "too_few_points": "ring {ring} has too few points",
              "edges_meet": "edges {i} and {j} meet at {point}: {kind}",
              "comes_twice": "ring {ring} comes twice to {point}",
              "crosses": "ring {ring} crosses itself at {point}", "falls_apart": "one falls apart",
              "misplaced": "ring {ring} is misplaced at {point}", "circle": "rings {rings} close a circle",
              "repeated": "edge {edge} has no length", "rings_touch": "rings {ring} and {other} touch at {point}"},
    "linear_program": {"one": "{point} is the best point along {objective}",
                       "many": "{point} is one of many best points along {objective}",
                       "all": "{point} is as good as all others along {objective}",
                       "unbounded": "there is no best point along {objective}",
                       "infeasible": "no point is in all half-planes"},
}
REGIONS = {"empty": "empty", "plane": "the plane", "point": "a point", "segment": "a segment", "ray": "a ray",
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


def sentence(item, bodies):
    """Of a statement whose form is right, and of the bodies that it says."""
    question, verdict = item["question"], item["verdict"]
    said = {key: shown(value) for key, value in item.items() if key != "claims"}
    said.update({key: (body.title() + " " + body.name).lstrip() for key, body in bodies.items()})
    if item.get("facets"):
        said["facets"] = "%d facets, made of %d simplices of %d corners" % (
            len(item["facets"]), sum(map(len, item["facets"])), len(item["facets"][0][0]))
    if item.get("vertices"):
        said["vertices"] = "%d %s" % (len(item["vertices"]), "vertex" if len(item["vertices"]) == 1 else "vertices")
    said["region"] = REGIONS.get(verdict, "") + (", of sides " + said["sides"] if item.get("sides") else "")
    if verdict in ("these", "count"):
        count = len(item["contacts"]) if verdict == "these" else item["number"]
        text = ("exactly %d pair of %s meets" if count == 1 else "exactly %d pairs of %s meet") % (count, question)
        text += ": " + said["contacts"] if item.get("contacts") else ""
    else:
        known = SENTENCES[question]
        text = (known if type(known) is str else known[verdict]).format(**said)
    if question == "valid" and verdict != "valid":
        text = "polygons %s: not %s, as %s" % (said["parts"], said["rule"], text)
    rules = [said["allowed"] + " allowed"] if said.get("allowed", "nothing") != "nothing" else []
    if "groups" in item:
        rules.append("members of one of %d groups may meet" % len(set(item["groups"])))
    if item.get("members"):
        rules.append("members: " + said["members"])
    if item.get("except"):
        rules.append("not asked about: " + said["except"])
    return text + (" (%s)" % ", ".join(rules) if rules else "")
