#!/usr/bin/env python3
"""Sunder's polytopes against HiGHS and SciPy, on the same inputs in one run.

    bench/polytopes.py build/bench/bin/bench_polytopes

Needs numpy, scipy and highspy. HiGHS is asked for weights of both bodies with one common point (a linear program of
d + 2 rows), as an array is passed to it and solved; SciPy's linprog for the weights of a point, and
Delaunay.find_simplex about all points at once. Times are processor time of one thread; what is asked of each peer is
the boolean only. A peer's wrong answers, by Sunder's exact ones, are counted.
"""
import subprocess
import sys
import tempfile
import time

import highspy
import numpy as np
from scipy.optimize import linprog
from scipy.spatial import Delaunay

D, PAIRS, ASKED_OF_LINPROG = 4, 32, 40


class Reader:
    def __init__(self, name):
        self.numbers, self.at = np.fromfile(name), 0

    def next(self):
        count = int(self.numbers[self.at])
        self.at += count + 1
        return self.numbers[self.at - count:self.at]


def timed(call, items):
    begin = time.process_time()
    answers = [call(*item) for item in items]
    return (time.process_time() - begin) * 1e6 / len(items), answers


def highs_meet(a, b):
    """Have the hulls a common point?"""
    n, m = len(a), len(b)
    matrix = np.vstack([np.hstack([a.T, -b.T]), np.r_[np.ones(n), np.zeros(m)], np.r_[np.zeros(n), np.ones(m)]])
    lp = highspy.HighsLp()
    lp.num_col_, lp.num_row_ = n + m, D + 2
    lp.col_cost_ = np.zeros(n + m)
    lp.col_lower_, lp.col_upper_ = np.zeros(n + m), np.full(n + m, highspy.kHighsInf)
    lp.row_lower_ = lp.row_upper_ = np.r_[np.zeros(D), 1, 1]
    lp.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    lp.a_matrix_.start_ = np.arange(0, (D + 3) * (n + m), n + m)
    lp.a_matrix_.index_ = np.tile(np.arange(n + m), D + 2)
    lp.a_matrix_.value_ = matrix.ravel()
    solver = highspy.Highs()
    solver.setOptionValue("output_flag", False)
    solver.setOptionValue("threads", 1)
    solver.passModel(lp)
    solver.run()
    return solver.getModelStatus() == highspy.HighsModelStatus.kOptimal


def main():
    with tempfile.NamedTemporaryFile() as file:
        print(subprocess.run([sys.argv[1], "--write", file.name], check=True, capture_output=True, text=True).stdout)
        reader = Reader(file.name)
    print("%-10s %12s %12s %9s  wrong" % ("pairs", "sunder, us", "HiGHS, us", "ratio"))
    for name in ("far apart", "near", "meet", "touching"):
        (_, with_evidence), truths = reader.next(), reader.next()
        pairs = [(reader.next().reshape(-1, D), reader.next().reshape(-1, D)) for _ in range(PAIRS)]
        took, answers = timed(highs_meet, pairs)
        wrong = sum(bool(t) != said for t, said in zip(truths, answers))
        print("%-10s %12.2f %12.0f %9.0f  %d of %d" % (name, with_evidence, took, took / with_evidence, wrong, PAIRS))
    (many,), truths, rows, points = reader.next(), reader.next(), reader.next().reshape(-1, D), reader.next().reshape(-1, D)
    matrix, cost = np.vstack([rows.T, np.ones(len(rows))]), np.zeros(len(rows))
    took, answers = timed(lambda p: linprog(cost, A_eq=matrix, b_eq=np.r_[p, 1]).status == 0, [(p,) for p in points[:ASKED_OF_LINPROG]])
    wrong = sum(bool(t) != said for t, said in zip(truths, answers))
    print("points: sunder %.2f us, linprog %.0f us, ratio %.0f; %d of %d wrong" % (many, took, took / many, wrong, len(answers)))
    begin = time.process_time()
    triangulation = Delaunay(rows)
    prepared = time.process_time()
    answers = triangulation.find_simplex(points) >= 0
    done = time.process_time()
    print("points: Delaunay %.1f s to prepare, find_simplex %.2f us; with preparation %.0f us a point; %d of %d wrong" % (
        prepared - begin, (done - prepared) * 1e6 / len(points), (done - begin) * 1e6 / len(points),
        int(np.sum(answers != truths.astype(bool))), len(points)))


if __name__ == "__main__":
    main()
