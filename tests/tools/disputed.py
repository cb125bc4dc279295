#!/usr/bin/env python3
"""Who is right where a solver returns solutions that the reference does not list: 50 digits decide.

    python3 tests/tools/disputed.py [ARM ...]      seed001_yzy and seed003_lab6dof
    python3 tests/tools/disputed.py --answers FILE

Asks the example `answer` of the crate `robots` for every pose of these arms in `data/cases` that has no family, and judges the
answers to those of which it returns more solutions than are listed. FILE holds other answers, lines {"arm": name, "pose": 4x4,
"solutions": [[...], ...]}; `-` is standard input. Each solution is polished by Newton's method with 50 digits against the pose
exactly as its doubles give it, in the least squares sense, as the pose of a double is no exact rotation. Printed for each: how far
the polished joints are from those given, and the residual that is left. A true solution moves by round-off over the smallest
singular value and leaves the pose's own rounding, about 1e-16; a spurious one does not get there. The kinematics is that of
check_poses.py: mpmath's product, nothing of this project. Exit code 1 if one is spurious.
"""
import argparse
import json
import subprocess
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


def disputed(arms):
    """Poses of these arms with the answers that hold more than the reference lists."""
    asked = []
    for arm in arms:
        cases = json.loads((TESTS / "data" / "cases" / f"{arm}.json").read_text())["ik"]
        asked += [(arm, case) for case in cases if case["solutions"] and not case.get("families")]
    requests = [{"id": k, "arm": arm, "op": "ik", "task": case["task"], "pose": case["pose"]} for k, (arm, case) in enumerate(asked)]
    command = ["cargo", "run", "--release", "--quiet", "--package", "robots", "--example", "answer"]
    lines = "".join(json.dumps(request) + "\n" for request in requests)
    answers = subprocess.run(command, input=lines, stdout=subprocess.PIPE, text=True, check=True, cwd=TESTS.parent).stdout
    for answer in map(json.loads, answers.splitlines()):
        arm, case = asked[answer["id"]]
        if len(answer["solutions"]) > len(case["solutions"]):
            print(f"{arm}, {case['kind']}: {len(answer['solutions'])} came back, {len(case['solutions'])} are listed")
            yield {"arm": arm, "pose": case["pose"], "solutions": answer["solutions"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("arms", nargs="*", metavar="ARM", help="names as in data/cases")
    parser.add_argument("--answers", type=argparse.FileType(), help="JSON lines, or - for standard input")
    order = parser.parse_args()
    records = {record["name"]: record for record in json.loads((TESTS / "data" / "arms.json").read_text())}
    wrong = judged = 0
    arms = order.arms or ["seed001_yzy", "seed003_lab6dof"]
    for case in map(json.loads, order.answers) if order.answers else disputed(arms):
        fk, _ = from_table(records[case["arm"]])
        pose = [[mpf(x) for x in row] for row in case["pose"]]
        for given in case["solutions"]:
            q, left = polished(fk, [mpf(x) for x in given], pose)
            moved = max(abs(a - b) for a, b in zip(q, given))
            wrong, judged = wrong + (left > mpf(10) ** -15), judged + 1
            print(f"{case['arm']:20} moved {nstr(moved, 3):>9}  residual {nstr(left, 3):>9}  "
                  + " ".join(f"{nstr(x, 9):>12}" for x in q))
    print(f"{judged} solutions judged, {wrong} spurious")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
