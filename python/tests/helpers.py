"""What the tests share."""
import json
import os
import subprocess

import pytest
import sunder
import sunder_verify

CASES = os.environ["SUNDER_CASES_DIR"]
PROGRAM = os.environ.get("SUNDER_PROGRAM", "")
SOURCE = os.path.dirname(CASES)


def proved(certificate):
    """What the checker says that a certificate proves. Nothing of it may be refused."""
    assert isinstance(certificate, bytes)
    statements = sunder_verify.verify(certificate, True).statements
    assert statements
    assert [refusal for _, refusal in statements if refusal] == []
    return [sentence for sentence, _ in statements]


def statements(certificate):
    """Question and verdict of each statement."""
    return [(statement["question"], statement["verdict"]) for statement in json.loads(certificate)["statements"]]


def refused(kind, place, call, *arguments, **options):
    """The call raises an Error of this kind at this place; returns its text."""
    with pytest.raises(sunder.Error) as caught:
        call(*arguments, **options)
    error = caught.value
    assert (error.kind, error.place) == (kind, place), error
    assert error.text and error.text in str(error) and "\n" not in error.text
    return error.text


def program(*words):
    """The report in JSON of the program that the C++ build made."""
    done = subprocess.run([PROGRAM, words[0], "--json", *words[1:]], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)
