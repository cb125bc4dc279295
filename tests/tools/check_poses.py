#!/usr/bin/env python3
"""The `check` poses of the arms in robots/src, computed with 50 digits straight from the sources.

  python3 tests/tools/check_poses.py            prints two poses for each arm, as they stand in the arm's file
  python3 tests/tools/check_poses.py --verify   reads every `check` in robots/src and compares it with its own product

Nothing of this project is used: the rows come from tests/data/arms.json, the chains of seeds 001 and 003 are written out
below, and the product is mpmath's.
"""
import json, pathlib, re, sys
from mpmath import mp, mpf, matrix, eye, sin, cos, atan2, sqrt, pi, fabs, nstr, nint

mp.dps = 50
TESTS = pathlib.Path(__file__).resolve().parent.parent
SOURCES = TESTS.parent / "robots" / "src"

# file of the arm: (name in arms.json or a chain, lengths per metre, unit of angles)
ARMS = {
    "irb140": ("irb140", 1, "deg"),
    "irb2400": ("abb_irb2400", 1, "rad"),
    "irb6640": ("abb_irb6640", 1, "rad"),
    "lr_mate200ic": ("fanuc_lrmate200ic", 1, "rad"),
    "m10ia": ("fanuc_m10ia", 1, "rad"),
    "kr5_arc": ("kr5arc", 1, "deg"),
    "kr6r700": ("opw_kuka_kr6r700", 1, "deg"),
    "kr6r900_sixx": ("kuka_kr6r900sixx", 1, "deg"),
    "kr16": ("kuka_kr16_2", 1, "deg"),
    "kr150r3100": ("kuka_kr150r3100", 1, "deg"),
    "gp7": ("motoman_gp7", 1, "rad"),
    "gp25": ("motoman_gp25", 1, "deg"),
    "rv4fr": ("ssik_rv4fr", 1, "deg"),
    "tx40": ("opw_staubli_tx40", 1, "deg"),
    "puma560": ("puma560", 1, "deg"),
    "stanford": ("stanford", 1, "deg"),
    "ur5": ("ur5", 1, "rad"),
    "panda": ("panda", 1, "rad"),
    "lab_arm": ("seed000_lab6dof", 1000, "deg"),
    "seed001_yzy": ("seed001_yzy", 1, "rad"),
    "lab_rrr": ("seed004_3dof", 1, "rad"),
    "anthropomorphic": ("Rz(q) Tz(1) Rx(q) Ty(3) Rx(q) Ty(1) Ry(q) Ty(1) Rz(q) Ty(1) Ry(q)", 1, "rad"),
    "elbow_wrist": (
        "Rz(q) Tz(0.3) Rz(pi/2) Rx(pi/2) Rz(q) Tx(1) Rz(q) Tx(0.5) Ry(pi/2) Rz(pi/2)"
        " Rz(q) Tz(0.3) Rx(-pi/2) Rz(-pi) Rz(q) Rx(-pi/2) Rz(q)", 1, "deg"),
}
# in degrees or in radians; of the third, a prismatic joint takes the number as metres
GENERAL = {"deg": [20, -50, "35", 70, -40, 25, 15], "rad": ["0.3", "-0.8", "0.6", "1.1", "-0.7", "0.4", "0.5"]}
SLIDE = {"simple": "0.5", "general": "0.8"}


def value(text):
    """An exact expression of the sources: decimals become exact, then + - * / with pi, sin, cos."""
    text = re.sub(r"(?<![\w.])(\d+\.?\d*(?:[eE][-+]?\d+)?)", r"mpf('\1')", str(text))
    return mpf(eval(text, {"__builtins__": {}, "mpf": mpf, "pi": +pi, "sin": sin, "cos": cos, "sqrt": sqrt}))


def turn(axis, angle):
    c, s = cos(angle), sin(angle)
    m = eye(4)
    i, j = [k for k in range(3) if k != axis]
    m[i, i] = m[j, j] = c
    m[i, j], m[j, i] = (s, -s) if axis == 1 else (-s, s)
    return m


def shift(axis, distance):
    m = eye(4)
    m[axis, 3] = distance
    return m


def placed(frame):
    x, r = [value(v) for v in frame["xyz"]], [value(v) for v in frame["rpy"]]
    place = shift(0, x[0]) * shift(1, x[1]) * shift(2, x[2])
    return place * turn(2, r[2]) * turn(1, r[1]) * turn(0, r[0])


def from_table(record):
    """The pose of the tool, metres and radians, as a function of q, and the kinds of the joints."""
    rows = [(r["type"], value(r["theta"]), value(r["d"]), value(r["a"]), value(r["alpha"])) for r in record["rows"]]

    def fk(q):
        q, pose = list(q), placed(record["base"])
        for kind, theta, d, a, alpha in rows:
            theta += q.pop(0) if kind == "R" else 0
            d += q.pop(0) if kind == "P" else 0
            screw, link = turn(2, theta) * shift(2, d), (shift(0, a), turn(0, alpha))
            pose = pose * (screw * link[0] * link[1] if record["convention"] == "standard" else link[1] * link[0] * screw)
        return pose * placed(record["tool"])

    return fk, [r[0] for r in rows if r[0] != "F"]


def from_chain(text):
    factors = re.findall(r"([RT])([xyz])\(([^)]*)\)", text)

    def fk(q):
        q, pose = list(q), eye(4)
        for what, axis, argument in factors:
            amount = q.pop(0) if argument == "q" else value(argument)
            pose = pose * (turn if what == "R" else shift)("xyz".index(axis), amount)
        return pose

    return fk, ["R"] * sum(argument == "q" for _, _, argument in factors)


def zyx(pose):
    """alpha, beta, gamma of Rz Ry Rx; gamma = 0 where the second is a quarter turn."""
    level = sqrt(pose[0, 0] ** 2 + pose[1, 0] ** 2)
    beta = atan2(-pose[2, 0], level)
    if level < mpf(10) ** -40:
        return atan2(-pose[0, 1], pose[1, 1]), beta, mpf(0)
    return atan2(pose[1, 0], pose[0, 0]), beta, atan2(pose[2, 1], pose[2, 2])


def number(x):
    if fabs(x) < mpf(10) ** -40:
        return "0"
    text = nstr(x, 13, min_fixed=-20, max_fixed=20)
    return re.sub(r"\.?0+$", "", text) if "." in text else text


def angle(x, unit):
    eighths = x / (pi / 4)
    if fabs(eighths - nint(eighths)) > mpf(10) ** -40:
        return number(x * 180 / pi if unit == "deg" else x)
    k = int(nint(eighths))
    k = 4 if k == -4 else k
    if unit == "deg":
        return str(45 * k)
    return {-3: "-3*pi/4", -2: "-pi/2", -1: "-pi/4", 0: "0", 1: "pi/4", 2: "pi/2", 3: "3*pi/4", 4: "pi"}[k]


def arms():
    records = {record["name"]: record for record in json.loads((TESTS / "data" / "arms.json").read_text())}
    for name, (source, lengths, unit) in ARMS.items():
        fk, kinds = from_chain(source) if "(" in source else from_table(records[source])
        yield name, fk, kinds, mpf(lengths), unit


def joints(texts, kinds, lengths, unit):
    turns = pi / 180 if unit == "deg" else mpf(1)
    return [value(t) * turns if kind == "R" else value(t) / lengths for t, kind in zip(texts, kinds)]


def show():
    for name, fk, kinds, lengths, unit in arms():
        print(name)
        for which, start in (("simple", [0] * 7), ("general", GENERAL[unit])):
            texts = [str(t) if kind == "R" else SLIDE[which] for t, kind in zip(start, kinds)]
            pose = fk(joints(texts, kinds, lengths, unit))
            xyz = ", ".join(number(pose[i, 3] * lengths) for i in range(3))
            left = f"    check [{', '.join(texts)}] =>"
            right = f"({xyz}) zyx({', '.join(angle(a, unit) for a in zyx(pose))});"
            print(left + ("\n        " if len(left + right) > 105 else " ") + right)


def verify():
    worst, count, wrong = mpf(0), 0, []
    for name, fk, kinds, lengths, unit in arms():
        text = (SOURCES / f"{name}.rs").read_text()
        checks = re.findall(r"check\s*\[([^\]]*)\]\s*=>\s*\(([^)]*)\)(?:\s*zyx\(([^)]*)\))?(?:\s*within ([^;]*))?", text)
        if len(checks) < 2:
            wrong.append(f"{name}: {len(checks)} poses")
        for q, xyz, angles, within in checks:
            count += 1
            pose = fk(joints(q.split(","), kinds, lengths, unit))
            error = max(fabs(pose[i, 3] - value(t) / lengths) for i, t in enumerate(xyz.split(",")))
            if angles:
                a, b, c = joints(angles.split(","), "RRR", lengths, unit)
                other = turn(2, a) * turn(1, b) * turn(0, c)
                error = max([error] + [fabs(pose[i, j] - other[i, j]) for i in range(3) for j in range(3)])
            if not within:
                worst = max(worst, error)
            if error > (value(within) if within else mpf(10) ** -12):
                wrong.append(f"{name}: check [{q}] is off by {nstr(error, 3)}")
    print(f"{count} poses of {len(ARMS)} arms, worst difference {nstr(worst, 3)}", *wrong, sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(verify() if "--verify" in sys.argv[1:] else show())
