#!/usr/bin/env python3
"""The IRB 2400 as libraries of Python have it, timed beside this one.

    python3 -m venv peers && peers/bin/pip install pin eaik ssik
    cargo bench -p tests --bench peers -- --report --python peers/bin/python

The bench starts this program and writes the file that it names: for each configuration 107 doubles, which are six angles, the
pose and the Jacobian row by row, how many inverse solutions there are, and room for eight of them. First all answers are
compared with those; then this program says in a line of JSON which ways it has. From then on it reads lines `way call start
length` and answers each with the nanoseconds that so many calls took, or, with `empty` for `call`, so many calls of the same
binding that do next to nothing. Whatever is not installed is named and left out.
"""
import contextlib
import gc
import importlib
import importlib.metadata
import json
import pathlib
import sys
import tempfile
import time

RECORD = 6 + 16 + 36 + 1 + 48
# What is added to q, d, a, alpha; as in peers.rs.
QUARTER = 3.141592653589793 / 2
OFFSET, D = [0, QUARTER, 0, 0, 0, 0], [0.615, 0, 0, 0.755, 0, 0.085]
A, ALPHA = [0.1, -0.705, -0.135, 0, 0, 0], [-QUARTER, 0, QUARTER, -QUARTER, QUARTER, 0]
# Poses and Jacobians agree so far; solutions are the same where no joint differs by more than the second.
AGREE, SAME = 1e-12, 1e-6
# What is taken off is the work of one joint too much.
ONE_JOINT = "an arm of one joint"


class Data:
    """What the bench asks of everybody."""

    def __init__(self, path):
        import numpy as np

        numbers = np.fromfile(path, "<f8").reshape(-1, RECORD)
        self.q = numbers[:, :6].copy()
        self.poses = numbers[:, 6:22].reshape(-1, 4, 4).copy()
        self.jacobians = numbers[:, 22:58].reshape(-1, 6, 6)
        self.counts = numbers[:, 58].astype(int)
        self.solutions = numbers[:, 59:].reshape(-1, 8, 6)


class Way:
    """One way of computing one thing: `call` with an entry of `items`, `empty` with one of `nothings`."""

    def __init__(self, group, name, call, items, empty, nothings, taken_off, agreement):
        self.group, self.name, self.agreement, self.taken_off = group, name, agreement, taken_off
        self.lists = {"call": (call, list(items)), "empty": (empty, list(nothings))}

    def time(self, which, start, length):
        """Nanoseconds of so many calls, one after the other."""
        function, items = self.lists[which]
        items = items[start : start + length]
        begin = time.perf_counter_ns()
        for item in items:
            function(item)
        return time.perf_counter_ns() - begin


class Batches(Way):
    """The same for a call that takes a list."""

    def time(self, which, start, length):
        function, items = self.lists[which]
        items = items[start : start + length]
        begin = time.perf_counter_ns()
        function(items)
        return time.perf_counter_ns() - begin


def same(what, found, expected):
    """That entries agree, and by how much."""
    worst = max(float(abs(f - e).max()) for f, e in zip(found, expected, strict=True))
    if not worst <= AGREE:
        raise ValueError(f"{what} differs by {worst:.1e}")
    return f"to {worst:.0e}"


def poses(angles):
    """Plain products of the table's matrices, to judge solutions by."""
    import numpy as np

    product = np.broadcast_to(np.eye(4), (len(angles), 4, 4))
    for joint, (offset, d, a, alpha) in enumerate(zip(OFFSET, D, A, ALPHA)):
        sine, cosine = np.sin(angles[:, joint] + offset), np.cos(angles[:, joint] + offset)
        ca, sa = np.cos(alpha), np.sin(alpha)
        link = np.zeros((len(angles), 4, 4))
        link[:, 0] = np.stack([cosine, -sine * ca, sine * sa, a * cosine], axis=1)
        link[:, 1] = np.stack([sine, cosine * ca, -cosine * sa, a * sine], axis=1)
        link[:, 2], link[:, 3] = [0, sa, ca, d], [0, 0, 0, 1]
        product = product @ link
    return product


def solved(data, solve):
    """How many of our solutions another solver finds, how many it has besides, and how well all of them reach."""
    import numpy as np

    found, besides, owners, angles = 0, 0, [], []
    for index, pose in enumerate(data.poses):
        theirs = np.asarray(solve(pose), dtype=float).reshape(-1, 6)
        ours = data.solutions[index, : data.counts[index]]
        apart = ours[:, None, :] - theirs[None, :, :]
        close = (abs(apart - 2 * np.pi * np.round(apart / (2 * np.pi))) < SAME).all(axis=2)
        found += int(close.any(axis=1).sum())
        besides += int((~close.any(axis=0)).sum())
        owners.extend([index] * len(theirs))
        angles.extend(theirs)
    missed = abs(poses(np.array(angles)) - data.poses[owners]).max(axis=(1, 2))
    count = int(data.counts.sum())
    share = "all" if found == count else f"{found} of {count}"
    more = f", {besides} besides" if besides else ""
    return f"{share} solutions{more}; residual {np.median(missed):.0e}, at most {missed.max():.0e}"


def pinocchio(data):
    """Pinocchio: poses and Jacobians. It has no inverse in closed form."""
    import numpy as np
    import pinocchio as pin

    def arm(joints):
        model, rest, parent = pin.Model(), pin.SE3.Identity(), 0
        for joint in range(joints):
            turned = pin.SE3(pin.utils.rotate("z", OFFSET[joint]), np.zeros(3))
            parent = model.addJoint(parent, pin.JointModelRZ(), rest * turned, f"J{joint + 1}")
            rest = pin.SE3(pin.utils.rotate("x", ALPHA[joint]), np.array([A[joint], 0, D[joint]]))
        flange = model.addFrame(pin.Frame("flange", parent, 0, rest, pin.FrameType.OP_FRAME))
        return model, model.createData(), flange

    def fk(model, state, _):
        return lambda q: pin.framesForwardKinematics(model, state, q)

    def both(model, state, flange):
        axes = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        return lambda q: pin.computeFrameJacobian(model, state, q, flange, axes)

    def reached(call):
        def pose(q):
            call(q)
            return six[1].oMf[six[2]].homogeneous

        return [pose(q).copy() for q in data.q]

    name = f"Pinocchio {pin.__version__}"
    six, one = arm(6), arm(1)
    nothings = [q[:1].copy() for q in data.q]
    ways = []
    agreement = same("a pose", reached(fk(*six)), data.poses)
    ways.append(Way("fk", name, fk(*six), data.q, fk(*one), nothings, ONE_JOINT, agreement))
    # This call leaves the pose in its place as well.
    same("a pose beside a Jacobian", reached(both(*six)), data.poses)
    agreement = same("a Jacobian", [both(*six)(q).copy() for q in data.q], data.jacobians)
    ways.append(Way("fk and jacobian", name, both(*six), data.q, both(*one), nothings, ONE_JOINT, agreement))
    return ways


def eaik(data):
    """EAIK: poses and inverses."""
    import numpy as np
    from eaik.IK_DH import DhRobot

    def arm(joints):
        return DhRobot(np.array(ALPHA[:joints]), np.array(A[:joints]), np.array(D[:joints]))

    def exact(pose):
        solutions = six.IK(pose)
        keep = [not nearest for nearest in solutions.is_LS]
        return np.asarray(solutions.Q).reshape(-1, 6)[keep] - OFFSET

    name = f"EAIK {importlib.metadata.version('eaik')}"
    six, one = arm(6), arm(1)
    turned = list(data.q + np.array(OFFSET))
    nothings = [q[:1].copy() for q in turned]
    agreement = same("a pose", [six.fwdKin(q) for q in turned], data.poses)
    ways = [Way("fk", name, six.fwdKin, turned, one.fwdKin, nothings, ONE_JOINT, agreement)]
    agreement = solved(data, exact)
    ways.append(Way("ik", name, six.IK, data.poses, one.IK, data.poses, ONE_JOINT, agreement))

    def batch(robot):
        return lambda batch: robot.IK_batched(batch, 1)

    name += ", batches on one thread"
    ways.append(Batches("ik", name, batch(six), data.poses, batch(one), data.poses, ONE_JOINT, "the same"))
    return ways


def urdf():
    """The arm as ssik's generator reads it."""
    lines, before = ['<robot name="irb2400">', '<link name="base"/>'], (0.0, 0.0, 0.0)
    parent = "base"
    for joint, (offset, d, a, alpha) in enumerate(zip(OFFSET, D, A, ALPHA), 1):
        shift, lift, twist = before
        # Rz(offset) after Rx(twist) is Ry(offset) before it where the twist is a quarter turn back, as it is here.
        rpy = f"{twist!r} {float(offset)!r} 0" if offset else f"{twist!r} 0 0"
        lines.append(
            f'<link name="link{joint}"/><joint name="J{joint}" type="revolute"><parent link="{parent}"/>'
            f'<child link="link{joint}"/><origin xyz="{shift} 0 {lift}" rpy="{rpy}"/><axis xyz="0 0 1"/>'
            '<limit lower="-3.2" upper="3.2" effort="1" velocity="1"/></joint>'
        )
        before, parent = (a, d, alpha), f"link{joint}"
    shift, lift, twist = before
    lines.append(
        f'<link name="flange"/><joint name="end" type="fixed"><parent link="{parent}"/><child link="flange"/>'
        f'<origin xyz="{shift} 0 {lift}" rpy="{twist!r} 0 0"/></joint></robot>'
    )
    return "\n".join(lines)


def ssik(data):
    """ssik: poses, and inverses by the solver that it generates for the arm."""
    import numpy as np
    from ssik import cli
    from ssik.internals import JointSpec, build_kinbody
    from ssik.kinematics.poe_fk import poe_forward_kinematics

    with tempfile.TemporaryDirectory() as folder:
        source, artifact = pathlib.Path(folder, "irb2400.urdf"), pathlib.Path(folder, "irb2400_ik.py")
        source.write_text(urdf())
        arguments = ["build", str(source), "--base", "base", "--ee", "flange", "--out", str(artifact), "--no-validate"]
        with contextlib.redirect_stdout(sys.stderr):
            if cli.main(arguments) != 0:
                raise ValueError("ssik build failed")
        sys.path.insert(0, folder)
        irb2400 = importlib.import_module("irb2400_ik")

    def arm(joints):
        def rest(shift, lift, twist):
            frame = np.eye(4)
            frame[1:3, 1:3] = [[np.cos(twist), -np.sin(twist)], [np.sin(twist), np.cos(twist)]]
            frame[:3, 3] = [shift, 0, lift]
            return frame

        rows = list(zip(A, D, ALPHA))[:joints]
        specs = [JointSpec(np.eye(4), np.array([0.0, 0.0, 1.0]), "revolute", rest(*row), None) for row in rows]
        return build_kinbody(specs)

    def fk(joints):
        body = arm(joints)
        return lambda q: poe_forward_kinematics(body, q)

    name = f"ssik {importlib.metadata.version('ssik')}"
    turned = list(data.q + np.array(OFFSET))
    nothings = [q[:1].copy() for q in turned]
    agreement = same("a pose", [fk(6)(q) for q in turned], data.poses)
    ways = [Way("fk", name, fk(6), turned, fk(1), nothings, ONE_JOINT, agreement)]

    def solve(pose):
        return irb2400.solve(pose, respect_limits=False)

    def none(pose):
        return irb2400.solve(pose, respect_limits=False, max_solutions=0)

    agreement = solved(data, lambda pose: [solution.q for solution in solve(pose)])
    asked = "no solutions asked for"
    ways.append(Way("ik", name, solve, data.poses, none, data.poses, asked, agreement))
    ways.extend(compiled(data, irb2400, name, agreement))
    return ways


def compiled(data, irb2400, name, agreement):
    """The compiled part of ssik's solver alone, without the Python around it: not a part of its public interface, so it may
    not be there."""
    try:
        from ssik import _native

        solver = _native._solver(_native._load_ext(), irb2400._KB, irb2400.SOLVER_NAME)
        check = _native._load_ext().input_defect
        solver.solve(data.poses[0], 0)
        check(data.poses[0], 1e-6, 1e-6)
    except (ImportError, AttributeError, TypeError):
        return
    yield Way(
        "ik",
        f"{name}, its compiled part alone",
        lambda pose: solver.solve(pose, 0),
        data.poses,
        lambda pose: check(pose, 1e-6, 1e-6),
        data.poses,
        "a check of the pose",
        "the same",
    )


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    ways, missing = [], []
    data = None
    for library in (pinocchio, eaik, ssik):
        try:
            data = data or Data(sys.argv[1])
            ways.extend(library(data))
        except ImportError as error:
            missing.append(f"{library.__doc__.split(':')[0]}: not installed ({error})")
        except Exception as error:  # whatever another library does, the others are still timed
            missing.append(f"{library.__doc__.split(':')[0]}: {type(error).__name__}: {error}")
    names = ("group", "name", "taken_off", "agreement")
    listed = [{name: getattr(way, name) for name in names} for way in ways]
    print(json.dumps({"python": sys.version.split()[0], "ways": listed, "missing": missing}), flush=True)
    # The collector stays on, as for any user; what is there now it need not look through again and again.
    gc.freeze()
    for line in sys.stdin:
        way, which, start, length = line.split()
        print(ways[int(way)].time(which, int(start), int(length)), flush=True)


if __name__ == "__main__":
    main()
