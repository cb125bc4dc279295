#!/usr/bin/env python3
"""Who is right where a solver returns solutions that the reference does not list: 50 digits decide.

    python3 tests/tools/disputed.py ANSWERS

ANSWERS holds lines {"arm": name, "pose": 4x4, "solutions": [[...], ...]}, `-` is standard input. Each solution is polished by
Newton's method with 50 digits against the pose exactly as its doubles give it, in the least squares sense, as the pose of a
double is no exact rotation. Printed for each: how far the polished joints are from those given, and the residual that is left. A
true solution moves by round-off over the smallest singular value and leaves the pose's own rounding, about 1e-16; a spurious one
does not get there. The kinematics is that of check_poses.py: mpmath's product, nothing of this project.
"""
import argparse
import json
import sys

from check_poses import TESTS, from_table
from mpmath import lu_solve, matrix, mpf, norm, nstr

ENTRIES = [(i, j) for i in range(3) for j in range(4)]


def polished(fk, q, pose):
    """Gauss-Newton, the derivative by differences at half the digits; the joints and the residual that is left."""

    def residual(q):
        reached = fk(q)
        return matrix([reached[i, j] - pose[i][j] for i, j in ENTRIES])

    q, step = matrix(q), mpf(10) ** -25
    for _ in range(12):
        missed = residual(q)
        slopes = matrix(len(ENTRIES), len(q))
        for k in range(len(q)):
            moved = q.copy()
            moved[k] += step
            slopes[:, k] = (residual(moved) - missed) / step
        move = lu_solve(slopes.T * slopes, -(slopes.T * missed))
        q += move
        if norm(move) < mpf(10) ** -30:
            break
    return q, norm(residual(q))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("answers", type=argparse.FileType(), help="JSON lines, or - for standard input")
    records = {record["name"]: record for record in json.loads((TESTS / "data" / "arms.json").read_text())}
    wrong = 0
    for line in parser.parse_args().answers:
        case = json.loads(line)
        fk, _ = from_table(records[case["arm"]])
        pose = [[mpf(x) for x in row] for row in case["pose"]]
        for given in case["solutions"]:
            q, left = polished(fk, [mpf(x) for x in given], pose)
            moved = max(abs(a - b) for a, b in zip(q, given))
            wrong += left > mpf(10) ** -15
            print(f"{case['arm']:20} moved {nstr(moved, 3):>9}  residual {nstr(left, 3):>9}  "
                  + " ".join(f"{nstr(x, 9):>12}" for x in q))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
