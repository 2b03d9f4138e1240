"""Questions of files, answered in this process."""
import os
import subprocess
import threading

import pytest
import sunder

from helpers import CASES, proved

CUBE = os.path.join(CASES, "mesh", "cube.obj")


def ask_cubes(shift):
    return sunder.ask("pair", CUBE, CUBE, pose_b="%s,0,0" % shift, certificate=True)


def test_no_program_is_started(monkeypatch):
    monkeypatch.setattr(subprocess, "Popen", None)
    report = ask_cubes(3)
    assert report["answer"] == "apart" and isinstance(report, dict)
    assert proved(report.proof)
    assert sunder.ask("pair", CUBE, CUBE).proof is None


def test_nothing_is_printed(capfd):
    report = sunder.ask("hull", os.path.join(CASES, "mesh", "unused-inside.obj"))
    with pytest.raises(sunder.Error):
        sunder.ask("verify", CUBE)
    with pytest.raises(sunder.Error):
        sunder.ask("pair", CUBE, "no such file")
    assert report["notes"] and capfd.readouterr() == ("", "")


def test_two_calls_at_once():
    alone = {shift: ask_cubes(shift) for shift in (0, 3)}
    assert [report["answer"] for report in alone.values()] == ["meet", "apart"]
    wrong = []

    def ask(shift):
        for _ in range(50):
            report = ask_cubes(shift)
            if report != alone[shift] or report.proof != alone[shift].proof:
                wrong.append(report)

    threads = [threading.Thread(target=ask, args=(shift,)) for shift in (0, 3, 0, 3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_a_proof_is_held_against_its_files_while_others_are_read(tmp_path):
    proof = tmp_path / "proof.json"
    proof.write_bytes(ask_cubes(3).proof)
    answers = []

    def verify():
        for _ in range(30):
            answers.append(sunder.ask("verify", proof, against=CUBE)["objects"][0]["against"]["answer"])

    thread = threading.Thread(target=verify)
    thread.start()
    while thread.is_alive():
        assert ask_cubes(0)["answer"] == "meet"
    thread.join()
    assert answers == ["made of these"] * 30


def test_there_is_no_standard_input():
    for files, options in ((("-", CUBE), {}), ((CUBE, CUBE), {"certificate_": "-"}), ((CUBE, CUBE), {"svg": "-"})):
        with pytest.raises(sunder.Error) as caught:
            sunder.ask("pair", *files, **options)
        assert caught.value.kind == "bad-call"


def test_errors_have_a_place():
    with pytest.raises(sunder.Error) as caught:
        sunder.ask("pair", CUBE, CUBE, method="guess")
    assert (caught.value.kind, caught.value.place) == ("bad-call", "--method")
    assert caught.value.text.startswith("there is no method 'guess'")
