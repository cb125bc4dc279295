#!/usr/bin/env python3
"""Invents arms whose first three axes meet, two for each structure of the other three joints, with all their solutions.

    python3 tests/tools/invent_shoulders.py > tests/data/invented/shoulders.json

The centre of the shoulder, seen from the tool, is moved by joints 4 to 6 alone. It is sought as invent_bases.py seeks a
wrist centre: damped Newton steps from random starts on the plain product of the table's matrices, polished with 50 digits;
the shoulder is then read, with 50 digits, from what rotation is left.
"""
import json
import math
import multiprocessing
import random
import sys

import mpmath

import invent_bases as bases

# Rows 3 to 6 (d, a, alpha; theta, a, alpha where the joint slides), joints 4 to 6 of the kinds that are named.
ARMS = {
    # Axes 4 and 5 parallel: an elbow, seen from the tool.
    "elbow_a": ("RRR", [(0.4, 0.1, 90), (0.05, 0.5, 0), (0.1, 0.2, 90), (0.15, 0.1, 30)]),
    "elbow_b": ("RRR", [(0.3, 0.0, -90), (0.0, 0.45, 180), (0.12, 0.0, -70), (0.2, 0.05, 90)]),
    # Joint 4 slides at right angles to axis 5.
    "telescope_a": ("PRR", [(0.2, 0.1, 90), (30, 0.1, 90), (0.1, 0.15, 90), (0.2, 0.0, 0)]),
    "telescope_b": ("PRR", [(0.1, 0.2, 40), (-20, 0.0, -90), (0.0, 0.3, 65), (0.1, 0.1, 90)]),
    "general_a": ("RRR", [(0.3, 0.15, 60), (0.1, 0.45, 75), (-0.2, 0.25, 110), (0.1, 0.2, 0)]),
    "general_b": ("RRR", [(0.35, 0.1, -90), (0.2, 0.3, 90), (0.1, 0.2, -90), (0.1, 0.0, 20)]),
    "axes_5_6_meet_a": ("RRR", [(0.35, 0.1, 90), (0.1, 0.4, 70), (0.2, 0.0, 90), (0.15, 0.1, 0)]),
    "axes_5_6_meet_b": ("RRR", [(0.4, 0.05, 75), (0.1, 0.3, -80), (0.1, 0.0, -60), (0.2, 0.0, 45)]),
    "axes_5_6_parallel_a": ("RRR", [(0.3, 0.1, 90), (0.1, 0.3, 80), (0.1, 0.4, 0), (0.1, 0.15, 0)]),
    "axes_5_6_parallel_b": ("RRR", [(0.4, 0.2, -70), (0.0, 0.2, 60), (0.2, 0.35, 180), (0.1, 0.05, 90)]),
    "axes_4_5_meet_a": ("RRR", [(0.4, 0.1, 90), (0.3, 0.0, 90), (0.1, 0.3, 80), (0.1, 0.1, 0)]),
    "axes_4_5_meet_b": ("RRR", [(0.3, 0.2, 60), (0.25, 0.0, -75), (0.0, 0.4, 90), (0.2, 0.1, 30)]),
    "rpr_a": ("RPR", [(0.3, 0.1, 90), (0.1, 0.2, 60), (35, 0.2, 80), (0.1, 0.15, 0)]),
    "rpr_b": ("RPR", [(0.2, 0.2, -90), (0.2, 0.3, 90), (10, 0.1, 70), (0.1, 0.0, 20)]),
    "rrp_a": ("RRP", [(0.35, 0.1, 80), (0.1, 0.4, 90), (0.1, 0.1, 55), (20, 0.1, 0)]),
    "rrp_b": ("RRP", [(0.3, 0.1, 90), (0.05, 0.4, 0), (0.2, 0.1, 60), (0, 0.1, 45)]),
}
SHOULDER = [(0.3, 0.0, -90), (0.0, 0.0, 90)]


def table(name, kinds, rows):
    lines = [f"struct {name}(standard, m, deg);", "| joint | theta | d | a | alpha |"]
    for i, (kind, (x, a, alpha)) in enumerate(zip("RRR" + kinds, SHOULDER + rows), 1):
        theta, d = ("q", x) if kind == "R" else (x, "q")
        lines.append(f"| J{i} | {theta} | {d} | {a} | {alpha} |")
    return "\n".join(lines) + "\n"


class Arm(bases.Arm):
    """The arm seen from its tool: `centre` is that of the shoulder, `kinds` are those of joints 4 to 6."""

    def __init__(self, kinds, rows, exact):
        super().__init__("RRR", SHOULDER + rows[:1], exact)
        hand = bases.Arm(kinds, rows[1:], exact)
        self.rows = self.rows[:3] + hand.rows[:3]
        self.kinds, self.point = kinds, [self.num(0), self.num(0), self.num("0.3" if exact else 0.3)]

    def centre(self, q3):
        axes, r, p = self.frames([self.num(0)] * 3 + list(q3))
        seen = lambda v: [sum(r[k][i] * v[k] for k in range(3)) for i in range(3)]
        columns = []
        for kind, (z, o) in zip(self.kinds, axes[3:]):
            back = [-c for c in z]
            arm = [c - d for c, d in zip(self.point, o)]
            columns.append(seen(back if kind == "P" else bases.cross(back, arm)))
        return seen([c - d for c, d in zip(self.point, p)]), columns


def shoulder(exact, hand, rotation):
    """Joints 1 to 3: two triples, or the sum that is free to share."""
    zero = [mpmath.mpf(0)] * 3
    _, still, _ = exact.frames(zero + list(hand))
    _, first, _ = exact.frames(zero)
    # R = Rz(q1)·Ry(q2)·Rz(q3)·still, where still is the product of all rows with the shoulder at zero.
    m = [[sum(rotation[i][k] * still[j][k] for k in range(3)) for j in range(3)] for i in range(3)]
    return bases.triples(m)


def singular(arm, rng):
    """Values of joints 4 to 6 at which the determinant vanishes, found along joint 4; None if there are none."""
    for _ in range(200):
        _, q5, q6 = bases.starts(arm, rng)
        fourth = bases.zero_of(lambda v: bases.det(arm.centre([v, q5, q6])[1]))
        if fourth is not None:
            return [fourth, q5, q6]
    return None


def case(arm, exact, kind, q, rng):
    q = [float(v) for v in q]
    _, rotation, position = exact.frames([mpmath.mpf(v) for v in q])
    centre = exact.centre([mpmath.mpf(v) for v in q[3:]])[0]
    tries = 120 if kind.startswith("hand") else 60
    ik, families = [], []
    for hand, sigma in bases.base_solutions(arm, exact, centre, q[3:], rng, tries):
        ways, total = shoulder(exact, hand, rotation)
        hand = bases.wrap(arm, [float(v) for v in hand])
        if ways is None:
            families.append({"q": hand, "sum": float(total), "sigma": sigma})
        else:
            ik += [{"q": [float(v) for v in way] + hand, "sigma": sigma} for way in ways]
    pose = [[float(x) for x in rotation[i]] + [float(position[i])] for i in range(3)]
    return {"kind": kind, "q": q, "T": pose, "ik": ik, "families": families}


def invented(name):
    kinds, rows = ARMS[name]
    rng = random.Random("shoulder " + name)
    arm, exact = Arm(kinds, rows, False), Arm(kinds, rows, True)
    cases = []

    def ball():
        return [rng.uniform(-3, 3), rng.choice([-1, 1]) * rng.uniform(0.3, 2.8), rng.uniform(-3, 3)]

    for _ in range(4):
        cases.append(case(arm, exact, "generic", ball() + bases.starts(arm, rng), rng))
    for power in (2, 5, 8):
        near = [rng.uniform(-3, 3), 10.0**-power, rng.uniform(-3, 3)]
        cases.append(case(arm, exact, f"shoulder 1e-{power}", near + bases.starts(arm, rng), rng))
    at = [rng.uniform(-3, 3), 0.0, rng.uniform(-3, 3)]
    cases.append(case(arm, exact, "shoulder", at + bases.starts(arm, rng), rng))
    at = singular(arm, rng)
    if at:
        for power in (1, 2, 3, 5):
            for side in (1, -1):
                near = [at[0] + side * 10.0**-power, at[1], at[2]]
                cases.append(case(arm, exact, f"hand 1e-{power}", ball() + near, rng))
        cases.append(case(arm, exact, "hand", ball() + at, rng))
    print(name, [len(c["ik"]) + len(c["families"]) for c in cases], file=sys.stderr)
    return {"name": name, "table": table(name, kinds, rows), "slides": "RRR" + kinds, "cases": cases}


def main():
    with multiprocessing.Pool(2) as pool:
        arms = pool.map(invented, ARMS, chunksize=1)
    print("[")
    for i, arm in enumerate(arms):
        print(json.dumps(arm, separators=(",", ":")) + ("," if i + 1 < len(arms) else ""))
    print("]")


if __name__ == "__main__":
    main()
