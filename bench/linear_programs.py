#!/usr/bin/env python3
"""Sunder's linear programs of few variables against HiGHS, on the same inputs in one run.

    bench/linear_programs.py build/bench/bin/bench_linear_programs

Needs numpy and highspy. HiGHS is passed the program as an array, and solves it, on one thread, by its default method.
Times are processor time. Of Sunder they include evidence in exact numbers. A wrong answer of HiGHS is another outcome
than Sunder's exact one (a best point, or none).
"""
import subprocess
import sys
import tempfile
import time

import highspy
import numpy as np

FAMILIES, BEST = ("sphere", "vertex", "infeasible"), (0, 1, 2)  # outcomes one, many, all


def highs(rows, objective):
    """What HiGHS says: has it a best point?"""
    n, d = len(rows), len(objective)
    lp = highspy.HighsLp()
    lp.num_col_, lp.num_row_ = d, n
    lp.col_cost_, lp.sense_ = objective, highspy.ObjSense.kMaximize
    lp.col_lower_, lp.col_upper_ = np.full(d, -highspy.kHighsInf), np.full(d, highspy.kHighsInf)
    lp.row_lower_, lp.row_upper_ = np.full(n, -highspy.kHighsInf), rows[:, d]
    lp.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    lp.a_matrix_.start_ = np.arange(0, d * (n + 1), d)
    lp.a_matrix_.index_ = np.tile(np.arange(d), n)
    lp.a_matrix_.value_ = rows[:, :d].ravel()
    solver = highspy.Highs()
    solver.setOptionValue("output_flag", False)
    solver.setOptionValue("threads", 1)
    solver.passModel(lp)
    solver.run()
    return solver.getModelStatus() == highspy.HighsModelStatus.kOptimal


def main():
    with tempfile.NamedTemporaryFile() as file:
        print(subprocess.run([sys.argv[1], "--write", file.name], check=True, capture_output=True, text=True).stdout)
        numbers, at = np.fromfile(file.name), 0

    def following():
        nonlocal at
        count = int(numbers[at])
        at += count + 1
        return numbers[at - count:at]

    print("%-11s %2s %7s %12s %12s %8s  HiGHS wrong" % ("programs", "d", "n", "sunder, us", "HiGHS, us", "ratio"))
    while at < len(numbers):
        family, d, n, count, front = following()
        d, took, wrong = int(d), 0.0, 0
        for _ in range(int(count)):
            rows, objective, answer = following().reshape(-1, d + 1), following(), following()
            begin = time.process_time()
            said = highs(rows, objective)
            took += time.process_time() - begin
            wrong += said != (answer[0] in BEST)
        took *= 1e6 / count
        print("%-11s %2d %7d %12.1f %12.1f %8.1f  %d of %d" % (FAMILIES[int(family)], d, n, front, took, took / front, wrong, count))


if __name__ == "__main__":
    main()
