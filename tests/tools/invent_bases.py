#!/usr/bin/env python3
"""Invents two arms for each structure of a three-joint base and finds all their inverse solutions without this project.

    python3 tests/tools/invent_bases.py > tests/data/invented/bases.json

Needs mpmath. The wrist centre is sought from random starts by damped Newton steps on the plain product of the table's
matrices; what converges is polished with 50 digits, then the wrist is read from what rotation is left, with 50 digits.
Nothing here knows of conics, quartics or structures.
"""
import json
import math
import multiprocessing
import random
import sys

import mpmath

mpmath.mp.dps = 50
# Rows (kind, theta or d offset's other coordinate, a, alpha): standard convention, metres and degrees.
ARMS = {
    "general_a": ("RRR", [(0.3, 0.15, 60), (0.1, 0.45, 75), (-0.2, 0.25, 110)]),
    "general_b": ("RRR", [(0.0, 0.4, -90), (0.25, 0.3, 90), (0.1, 0.35, -90)]),
    "axes_1_2_meet_a": ("RRR", [(0.4, 0.0, 90), (0.15, 0.5, 70), (0.1, 0.2, 90)]),
    "axes_1_2_meet_b": ("RRR", [(0.2, 0.0, 55), (0.0, 0.6, -90), (0.05, 0.3, 45)]),
    "axes_1_2_parallel_a": ("RRR", [(0.3, 0.5, 0), (0.1, 0.4, 90), (0.0, 0.3, -90)]),
    "axes_1_2_parallel_b": ("RRR", [(0.1, 0.35, 180), (0.2, 0.0, 65), (0.3, 0.25, 90)]),
    "axes_2_3_meet_a": ("RRR", [(0.3, 0.3, 90), (0.4, 0.0, 90), (0.2, 0.3, -90)]),
    "axes_2_3_meet_b": ("RRR", [(0.1, 0.45, 50), (0.3, 0.0, 70), (0.1, 0.4, 90)]),
    "rrp_a": ("RRP", [(0.3, 0.2, 90), (0.1, 0.1, 50), (20, 0.15, 90)]),
    "rrp_b": ("RRP", [(0.2, 0.0, 60), (0.3, 0.4, 35), (-40, 0.0, 90)]),
    "rpr_a": ("RPR", [(0.3, 0.2, 60), (35, 0.3, 70), (0.2, 0.35, 90)]),
    "rpr_b": ("RPR", [(0.2, 0.1, 90), (90, 0.2, 90), (0.1, 0.4, -90)]),
    "prr_a": ("PRR", [(30, 0.2, 70), (0.1, 0.4, 60), (0.1, 0.3, 90)]),
    "prr_b": ("PRR", [(0, 0.0, 0), (0.2, 0.5, 60), (0.1, 0.4, 90)]),
    "rpp_a": ("RPP", [(0.3, 0.2, 0), (50, 0.1, 90), (0, 0.2, 90)]),
    "rpp_b": ("RPP", [(0.1, 0.3, 40), (-20, 0.2, 65), (15, 0.1, -90)]),
    "prp_a": ("PRP", [(10, 0.2, 50), (0.1, 0.3, 40), (20, 0.2, 90)]),
    "prp_b": ("PRP", [(0, 0.0, 0), (0.2, 0.2, 90), (0, 0.3, -90)]),
    "ppr_a": ("PPR", [(0, 0.1, 90), (40, 0.2, 55), (0.1, 0.5, 90)]),
    "ppr_b": ("PPR", [(20, 0.2, 70), (-30, 0.1, 90), (0.2, 0.4, -90)]),
    "ppp_a": ("PPP", [(0, 0.1, 90), (-90, 0.2, 90), (30, 0.1, 45)]),
    "ppp_b": ("PPP", [(20, 0.2, 60), (15, 0.1, 75), (40, 0.1, -90)]),
}
WRIST = [(0.3, 0.0, -90), (0.0, 0.0, 90), (0.1, 0.0, 0)]


def table(name, kinds, rows):
    lines = [f"struct {name}(standard, m, deg);", "| joint | theta | d | a | alpha |"]
    for i, (kind, (x, a, alpha)) in enumerate(zip(kinds + "RRR", rows + WRIST), 1):
        theta, d = ("q", x) if kind == "R" else (x, "q")
        lines.append(f"| J{i} | {theta} | {d} | {a} | {alpha} |")
    return "\n".join(lines) + "\n"


class Arm:
    """One table, in floats or in mpmath's numbers."""

    def __init__(self, kinds, rows, exact):
        self.kinds = kinds + "RRR"
        self.num = (lambda x: mpmath.mpf(str(x))) if exact else float
        self.sin, self.cos, self.pi = (mpmath.sin, mpmath.cos, mpmath.pi) if exact else (math.sin, math.cos, math.pi)
        self.rows = []
        for kind, (x, a, alpha) in zip(self.kinds, rows + WRIST):
            alpha = self.num(alpha) * self.pi / 180
            turn = (self.cos(alpha), self.sin(alpha))
            if exact:
                turn = tuple(mpmath.mpf(round(t)) if abs(t - round(t)) < mpmath.mpf(10) ** -40 else t for t in turn)
            self.rows.append((kind, self.num(x) * (self.pi / 180 if kind == "P" else 1), self.num(a), turn))

    def frames(self, q):
        """Axis directions and points before each row, then the last frame: rotation rows and position."""
        one, zero = self.num(1), self.num(0)
        r, p, axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]], [zero] * 3, []
        for (kind, x, a, (ca, sa)), value in zip(self.rows, q):
            axes.append(([row[2] for row in r], list(p)))
            theta, d = (value, x) if kind == "R" else (x, value)
            c, s = self.cos(theta), self.sin(theta)
            step = [[c, -s * ca, s * sa], [s, c * ca, -c * sa], [zero, sa, ca]]
            move = [a * c, a * s, d]
            p = [p[i] + sum(r[i][k] * move[k] for k in range(3)) for i in range(3)]
            r = [[sum(r[i][k] * step[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
        return axes, r, p

    def centre(self, q3):
        """The wrist centre and its Jacobian, columns of joints 1 to 3."""
        axes, r, p = self.frames(list(q3) + [self.num(0)])
        columns = []
        for kind, (z, o) in zip(self.kinds, axes[:3]):
            v = [p[i] - o[i] for i in range(3)]
            columns.append(z if kind == "P" else cross(z, v))
        return p, columns


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def det(columns):
    return dot(columns[0], cross(columns[1], columns[2]))


def damped(columns, gap, damping):
    """(JᵀJ + damping)⁻¹Jᵀ·gap."""
    n = [[dot(a, b) + (damping if i == j else 0) for j, b in enumerate(columns)] for i, a in enumerate(columns)]
    right = [dot(a, gap) for a in columns]
    whole = det(n)
    if whole == 0:
        return [0] * 3
    return [det([right if j == i else n[j] for j in range(3)]) / whole for i in range(3)]


def wrap(arm, q):
    return [v if k == "P" else (v + math.pi) % (2 * math.pi) - math.pi for k, v in zip(arm.kinds, q)]


def starts(arm, rng):
    return [rng.uniform(-math.pi, math.pi) if k == "R" else rng.gauss(0, 2) for k in arm.kinds[:3]]


def sought(arm, wanted, q):
    """One descent; None where it gets stuck."""
    damping = 1e-3
    p, columns = arm.centre(q)
    miss = math.dist(p, wanted)
    for _ in range(80):
        if miss < 1e-13:
            break
        step = damped(columns, [w - x for w, x in zip(wanted, p)], damping)
        there = [v + d for v, d in zip(q, step)]
        p2, columns2 = arm.centre(there)
        miss2 = math.dist(p2, wanted)
        if miss2 < miss:
            q, p, columns, miss, damping = there, p2, columns2, miss2, damping * 0.1
        else:
            damping *= 10
            if damping > 1e6:
                break
    return wrap(arm, q) if miss < 1e-9 else None


def distance(arm, a, b):
    return max(abs(x) for x in wrap(arm, [float(u - v) for u, v in zip(a, b)]))


def polished(exact, wanted, q):
    """Newton with 50 digits; halves the distance at a double root, so it may take long."""
    q = [mpmath.mpf(v) for v in q]
    for _ in range(60):
        p, columns = exact.centre(q)
        gap = [w - x for w, x in zip(wanted, p)]
        if max(abs(g) for g in gap) < mpmath.mpf(10) ** -42:
            break
        step = damped(columns, gap, mpmath.mpf(10) ** -38)
        q = [v + d for v, d in zip(q, step)]
    return q


def base_solutions(arm, exact, wanted, known, rng, tries):
    """All isolated base solutions, each with the size of its determinant."""
    found = []
    for q in [known] + [starts(arm, rng) for _ in range(tries)]:
        hit = sought(arm, [float(w) for w in wanted], q)
        if hit is None or any(distance(arm, hit, f) < 1e-9 for f in found):
            continue
        found.append(hit)
    solutions = []
    for q in found:
        fine = polished(exact, wanted, q)
        sigma = abs(float(det(exact.centre(fine)[1])))
        if sigma < 1e-6 and any(distance(arm, fine, f) < 1e-5 for f, s in solutions if s < 1e-5 and distance(arm, fine, f) < 30 * s + 1e-7):
            continue
        if not any(distance(arm, fine, f) < 1e-10 for f, _ in solutions):
            solutions.append((fine, sigma))
    return solutions


def wrist(exact, base, rotation):
    """Joints 4 to 6 of a base solution: two triples, or the sum that is free to share."""
    _, r, _ = exact.frames(list(base))
    m = [[sum(r[k][i] * rotation[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    # Rz(q4)·Rx(-90)·Rz(q5)·Rx(90)·Rz(q6): third column (c4 s5, s4 s5, c5).
    return triples(m)


def triples(m):
    """The angles of Rz·Ry·Rz: two triples, or the sum that is free to share."""
    sine = mpmath.hypot(m[0][2], m[1][2])
    if sine < mpmath.mpf(10) ** -14:
        return None, mpmath.atan2(m[1][0], m[0][0])
    ways = []
    for sign in (1, -1):
        first = mpmath.atan2(sign * m[1][2], sign * m[0][2])
        c, s = mpmath.cos(first), mpmath.sin(first)
        second = mpmath.atan2(c * m[0][2] + s * m[1][2], m[2][2])
        third = mpmath.atan2(c * m[1][0] - s * m[0][0], c * m[1][1] - s * m[0][1])
        ways.append([first, second, third])
    return ways, None


def zero_of(at):
    """An angle at which a function changes its sign; None if none is seen on a grid."""
    grid = [-math.pi + 2 * math.pi * k / 40 for k in range(41)]
    for low, high in zip(grid, grid[1:]):
        if at(low) * at(high) < 0:
            for _ in range(80):
                middle = (low + high) / 2
                low, high = (middle, high) if at(low) * at(middle) > 0 else (low, middle)
            return (low + high) / 2
    return None


def singular(arm, rng):
    """Base joints where the determinant vanishes, and the third joint's neighbourhood; None if there is none near."""
    for _ in range(200):
        q = starts(arm, rng)
        third = zero_of(lambda v: det(arm.centre([q[0], q[1], v])[1]))
        if third is not None:
            return [q[0], q[1], third]
    return None


def case(arm, exact, kind, q, rng):
    _, rotation, position = exact.frames([mpmath.mpf(v) for v in q])
    centre = exact.centre([mpmath.mpf(v) for v in q[:3]])[0]
    near = kind.startswith("base")
    bases = base_solutions(arm, exact, centre, list(q[:3]), rng, 120 if near else 60)
    ik, families = [], []
    for base, sigma in bases:
        ways, total = wrist(exact, base, rotation)
        base = wrap(arm, [float(v) for v in base])
        if ways is None:
            families.append({"q": base, "sum46": float(total), "sigma": sigma})
        else:
            ik += [{"q": base + [float(v) for v in way], "sigma": sigma} for way in ways]
    pose = [[float(x) for x in rotation[i]] + [float(position[i])] for i in range(3)]
    return {"kind": kind, "q": q, "T": pose, "ik": ik, "families": families}


def invented(name):
    kinds, rows = ARMS[name]
    rng = random.Random(name)
    arm, exact = Arm(kinds, rows, False), Arm(kinds, rows, True)
    cases = []

    def hand():
        return [rng.uniform(-3, 3), rng.choice([-1, 1]) * rng.uniform(0.3, 2.8), rng.uniform(-3, 3)]

    for _ in range(4):
        cases.append(case(arm, exact, "generic", starts(arm, rng) + hand(), rng))
    for power in (2, 5, 8):
        wrist_near = [rng.uniform(-3, 3), 10.0**-power, rng.uniform(-3, 3)]
        cases.append(case(arm, exact, f"wrist 1e-{power}", starts(arm, rng) + wrist_near, rng))
    wrist_at = [rng.uniform(-3, 3), 0.0, rng.uniform(-3, 3)]
    cases.append(case(arm, exact, "wrist", starts(arm, rng) + wrist_at, rng))
    at = singular(arm, rng)
    if at:
        for power in (1, 2, 3, 5):
            for side in (1, -1):
                near = [at[0], at[1], at[2] + side * 10.0**-power]
                cases.append(case(arm, exact, f"base 1e-{power}", near + hand(), rng))
        cases.append(case(arm, exact, "base", at + hand(), rng))
    counts = [len(c["ik"]) + len(c["families"]) for c in cases]
    print(name, counts, file=sys.stderr)
    return {"name": name, "table": table(name, kinds, rows), "slides": kinds, "cases": cases}


def main():
    with multiprocessing.Pool(2) as pool:
        arms = pool.map(invented, ARMS, chunksize=1)
    print("[")
    for i, arm in enumerate(arms):
        print(json.dumps(arm, separators=(",", ":")) + ("," if i + 1 < len(arms) else ""))
    print("]")


if __name__ == "__main__":
    main()
