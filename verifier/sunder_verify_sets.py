"""Checks statements about sets and regions: the part of sunder_verify.py for files with "sunder_set_certificate".

The format and the checks are those of docs/certificates.md and docs/certificates-sets.md, a chapter for each question;
no code is shared with the library. A module has the questions about tables of one kind: its function `questions` reads
the tables of a file, and returns for each question that they allow how a statement is read. This gives what the
statement is about, the rule or what is asked for, the verdict, and a function that checks the evidence.
"""
import sunder_verify_circles
import sunder_verify_convex
import sunder_verify_polygons
import sunder_verify_regions
import sunder_verify_segments
from sunder_verify import Refused, member, require

MODULES = (sunder_verify_segments, sunder_verify_circles, sunder_verify_convex, sunder_verify_polygons,
           sunder_verify_regions)
TABLES = ("segments", "circles", "convex_polygons", "polygons", "half_planes", "rings")


def verify(top):
    """As verify of sunder_verify.py, from a JSON object: the statements are its pairs."""
    require(member(top, "sunder_set_certificate", int, "the file") == 1, "F", "sunder_set_certificate is not 1")
    require(any(table in top for table in TABLES), "F", "the file has no table")
    questions = {}
    for module in MODULES:
        questions.update(module.questions(top))
    statements = []
    for i, item in enumerate(member(top, "statements", list, "the file")):
        where = "statements[%d]" % i
        question = member(item, "question", str, where)
        require(question in questions, "F", where + ".question is none that the tables of the file allow")
        statements.append(questions[question](item, where))
    results = []
    for i, (about, rule, verdict, check) in enumerate(statements):
        refusal = None
        try:
            check()
        except Refused as error:
            refusal = error.args
        results.append((i, about, rule, verdict, refusal))
    return results
