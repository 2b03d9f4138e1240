#!/usr/bin/env python3
"""Sunder's polytopes against HiGHS, GLPK, Clp and SciPy, on the same inputs in one run.

    bench/polytopes.py build/bench/bin/bench_polytopes [--pairs N] [--rounds N] [--quick] [--check]

Needs numpy, scipy and highspy; of swiglpk (GLPK) and cylp (Clp) what is there. Linear programs: bodies of points have
weights with one common point; half-spaces are rows about a point, which is free; both are of d + 2 rows, or d columns.
Times are processor time of one thread, of the solver alone: a peer's own arrays are filled before. What is asked of
each peer is the boolean only. Sunder's times are with exact evidence. A peer's wrong answers, by Sunder's exact ones,
are counted; those of bodies that touch, or are a last bit apart, are known by construction. --quick leaves Delaunay
out, which takes some 5 s and 300 MB to prepare. OpenBLAS gets one thread: with more, the matrices of Delaunay's
simplices, five numbers a side, take fifteen times the processor time.

In each round (five, if nothing else is said) Sunder answers all pairs, and then each peer all, or the first N. Times are
medians over the rounds, of means over the pairs; a ratio is the median of the rounds' ratios, with the least and the
greatest in brackets.

--check exits 1 where Sunder is less than 200 times as fast as HiGHS or 100 times as GLPK about pairs of polytopes of 1,000
points or half-spaces; less than 500 times as fast as linprog about points and a hull of 10,000; or slower than
find_simplex with its preparation.
"""
import os
import subprocess
import sys
import tempfile
import time

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when numpy is loaded

import highspy
import numpy as np
from scipy.optimize import linprog
from scipy.sparse import csr_matrix, hstack, vstack
from scipy.spatial import Delaunay

try:
    import swiglpk as glpk
except ImportError:
    glpk = None
try:
    from cylp.cy import CyClpSimplex
    from cylp.py.modeling.CyLPModel import CyLPArray
except ImportError:
    CyClpSimplex = None

D, ASKED_OF_LINPROG = 4, 40
# How many times as fast as each, about all pairs.
DEMANDED = {"HiGHS": 200, "GLPK": 100}


class Reader:
    def __init__(self, name):
        self.numbers, self.at = np.fromfile(name), 0

    def next(self):
        count = int(self.numbers[self.at])
        self.at += count + 1
        return self.numbers[self.at - count:self.at]


class Program:
    """Is there a point in both bodies? low <= matrix v <= high, lower <= v."""

    def __init__(self, bodies):
        infinite = np.inf
        (of_points_a, a), (of_points_b, b) = bodies
        self.lower = np.zeros(0)
        if of_points_a and of_points_b:
            n, m = len(a), len(b)
            matrix = np.vstack([np.hstack([a.T, -b.T]), np.r_[np.ones(n), np.zeros(m)], np.r_[np.zeros(n), np.ones(m)]])
            self.matrix = csr_matrix(matrix)
            self.low = self.high = np.r_[np.zeros(D), 1, 1]
            self.lower = np.zeros(n + m)
            return
        blocks, low, high, columns = [], [], [], D + sum(len(rows) for of_points, rows in bodies if of_points)
        for of_points, rows in bodies:
            if of_points:  # x - sum of weights times points = 0; weights sum to 1
                blocks.append(hstack([csr_matrix(np.vstack([np.eye(D), np.zeros((1, D))])),
                                      csr_matrix(np.vstack([-rows.T, np.ones((1, len(rows)))]))]))
                low += [0] * D + [1]
                high += [0] * D + [1]
            else:
                block = csr_matrix(rows[:, :D])
                block.resize((len(rows), columns))
                blocks.append(block)
                low += [-infinite] * len(rows)
                high += list(rows[:, D])
        self.matrix = csr_matrix(vstack(blocks))
        self.low, self.high = np.array(low, float), np.array(high, float)
        self.lower = np.r_[np.full(D, -infinite), np.zeros(columns - D)]


def timed(solve):
    begin = time.process_time()
    answer = solve()
    return (time.process_time() - begin) * 1e6, answer


def highs(p):
    lp = highspy.HighsLp()
    rows, columns = p.matrix.shape
    lp.num_col_, lp.num_row_ = columns, rows
    lp.col_cost_ = np.zeros(columns)
    lp.col_lower_, lp.col_upper_ = p.lower, np.full(columns, highspy.kHighsInf)
    lp.row_lower_, lp.row_upper_ = p.low, p.high
    lp.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
    lp.a_matrix_.start_, lp.a_matrix_.index_, lp.a_matrix_.value_ = p.matrix.indptr, p.matrix.indices, p.matrix.data
    solver = highspy.Highs()
    solver.setOptionValue("output_flag", False)
    solver.setOptionValue("threads", 1)
    solver.passModel(lp)
    took, _ = timed(solver.run)
    return took, solver.getModelStatus() == highspy.HighsModelStatus.kOptimal


def glpk_simplex(p):
    glpk.glp_term_out(glpk.GLP_OFF)
    problem = glpk.glp_create_prob()
    rows, columns = p.matrix.shape
    glpk.glp_add_rows(problem, rows)
    glpk.glp_add_cols(problem, columns)
    for i in range(rows):
        kind = glpk.GLP_FX if p.low[i] == p.high[i] else glpk.GLP_UP
        glpk.glp_set_row_bnds(problem, i + 1, kind, p.high[i] if kind == glpk.GLP_FX else 0.0, p.high[i])
    for j in range(columns):
        glpk.glp_set_col_bnds(problem, j + 1, glpk.GLP_LO if p.lower[j] == 0 else glpk.GLP_FR, 0.0, 0.0)
    coo = p.matrix.tocoo()
    count = coo.nnz
    at_row, at_column, values = glpk.intArray(count + 1), glpk.intArray(count + 1), glpk.doubleArray(count + 1)
    for k in range(count):
        at_row[k + 1], at_column[k + 1], values[k + 1] = int(coo.row[k]) + 1, int(coo.col[k]) + 1, float(coo.data[k])
    glpk.glp_load_matrix(problem, count, at_row, at_column, values)
    parameters = glpk.glp_smcp()
    glpk.glp_init_smcp(parameters)
    parameters.msg_lev = glpk.GLP_MSG_OFF

    def solve():
        glpk.glp_scale_prob(problem, glpk.GLP_SF_AUTO)
        glpk.glp_simplex(problem, parameters)

    took, _ = timed(solve)
    answer = glpk.glp_get_status(problem) in (glpk.GLP_OPT, glpk.GLP_FEAS)
    glpk.glp_delete_prob(problem)
    return took, answer


def clp(p):
    solver = CyClpSimplex()
    solver.logLevel = 0
    x = solver.addVariable("x", p.matrix.shape[1])
    solver += CyLPArray(p.low) <= p.matrix * x <= CyLPArray(p.high)
    solver += CyLPArray(p.lower) <= x
    took, status = timed(solver.primal)  # its dual method, called so, takes free columns amiss
    return took, status == "optimal"


SOLVERS = [("HiGHS", highs)] + ([("GLPK", glpk_simplex)] if glpk else []) + ([("Clp", clp)] if CyClpSimplex else [])


def number_after(word, default):
    words = sys.argv[2:]
    return int(words[words.index(word) + 1]) if word in words else default


def inputs():
    """Sunder's answers and times, and what it answered, as a reader."""
    with tempfile.NamedTemporaryFile() as file:
        said = subprocess.run([sys.argv[1], "--write", file.name], check=True, capture_output=True, text=True).stdout
        return said, Reader(file.name)


def regimes(reader):
    """Of each kind of pair: its name, Sunder's time, its answers, and the pairs as rows."""
    for _ in range(int(reader.next()[0])):
        of_points_a, of_points_b, _, sunder = reader.next()
        name = "".join(chr(int(c)) for c in reader.next())
        truths = reader.next()
        forms = [of_points_a > 0, of_points_b > 0]
        pairs = [[(form, reader.next().reshape(-1, D if form else D + 1)) for form in forms] for _ in truths]
        kind = "points" if all(forms) else "half-spaces and points" if any(forms) else "half-spaces"
        yield kind + " | " + name, sunder, truths, pairs


def main():
    missed, times, wrong = [], {}, {}
    for round_ in range(number_after("--rounds", 5)):
        said, reader = inputs()
        if round_ == 0:
            print(said)
        for name, sunder, truths, pairs in regimes(reader):
            programs = [Program(bodies) for bodies in pairs[:number_after("--pairs", len(pairs))]]
            took = times.setdefault(name, {"Sunder": []})
            took["Sunder"].append(sunder)
            for solver, call in SOLVERS:
                results = [call(program) for program in programs]
                took.setdefault(solver, []).append(np.mean([t for t, _ in results]))
                wrong[name, solver] = "%d of %d" % (
                    sum(bool(truth) != answer for truth, (_, answer) in zip(truths, results)), len(results))
    print("| bodies | pairs | Sunder, us |" + "".join(" %s, us | ratio | wrong |" % name for name, _ in SOLVERS))
    print("|---|---|---|" + "---|---|---|" * len(SOLVERS))
    for name, took in times.items():
        line = "| %s | %.1f |" % (name, np.median(took["Sunder"]))
        for solver, _ in SOLVERS:
            ratios = np.divide(took[solver], took["Sunder"])
            line += " %.0f | %.0f (%.0f-%.0f) | %s |" % (np.median(took[solver]), np.median(ratios), min(ratios),
                                                         max(ratios), wrong[name, solver])
            if np.median(ratios) < DEMANDED.get(solver, 0):
                missed.append("%s: %.0f times %s" % (name, np.median(ratios), solver))
        print(line, flush=True)
    rows = reader.next().reshape(-1, D)
    asked = []
    for name in ("all over", "about on the boundary"):
        many, with_evidence = reader.next()
        asked.append((name, many, with_evidence, reader.next() > 0, reader.next().reshape(-1, D)))
    missed += ask_linprog(rows, asked)
    if "--quick" not in sys.argv:
        missed += ask_delaunay(rows, asked)
    for line in missed if "--check" in sys.argv else []:
        print("missed: " + line)
    return 1 if missed and "--check" in sys.argv else 0


def ask_linprog(rows, asked):
    matrix, cost, missed = np.vstack([rows.T, np.ones(len(rows))]), np.zeros(len(rows)), []
    for name, many, with_evidence, truths, points in asked:
        every = len(points) // ASKED_OF_LINPROG + 1  # odd, for some of each kind
        results = [timed(lambda p=p: linprog(cost, A_eq=matrix, b_eq=np.r_[p, 1]).status == 0) for p in points[::every]]
        took = np.mean([t for t, _ in results])
        wrong = sum(bool(t) != said for t, (_, said) in zip(truths[::every], results))
        print("points %s, and a hull of %d: sunder %.2f us a point, %.2f with exact evidence; linprog %.0f us, ratio "
              "%.0f, %.0f with evidence; %d of %d wrong" % (name, len(rows), many, with_evidence, took, took / many,
                                                            took / with_evidence, wrong, len(results)), flush=True)
        if name == "all over" and took / with_evidence < 500:
            missed.append("points %s: %.0f times linprog" % (name, took / with_evidence))
    return missed


def ask_delaunay(rows, asked):
    """Preparation is the triangulation, and the matrices of its simplices, which the first query makes."""
    missed = []
    made, triangulation = timed(lambda: Delaunay(rows))
    inverted, _ = timed(lambda: triangulation.transform)
    for name, many, with_evidence, truths, points in asked:
        took, answers = timed(lambda points=points: triangulation.find_simplex(points) >= 0)
        each, whole = took / len(points), (made + inverted + took) / len(points)
        print("points %s, and Delaunay: %.1f s to triangulate, %.1f s for %d matrices; find_simplex %.1f us a point, %.1f "
              "times sunder's, %.1f with evidence; with preparation %.0f us, %.0f times sunder's, %.0f with evidence; %d "
              "of %d wrong" % (name, made / 1e6, inverted / 1e6, len(triangulation.simplices), each, each / many,
                               each / with_evidence, whole, whole / many, whole / with_evidence,
                               int(np.sum(answers != truths)), len(points)), flush=True)
        if whole < with_evidence:
            missed.append("points %s: find_simplex with preparation is faster" % name)
    return missed


if __name__ == "__main__":
    sys.exit(main())
