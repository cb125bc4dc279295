#!/usr/bin/env python3
"""Copies the reference data that the tests use into tests/data, without what they do not use.

  python3 tests/tools/import_reference.py FOLDER

FOLDER holds arms.json, seeds_truth.json and cases/. What other solvers did on each pose and how the cases were found is
left out; every number is written as it was read (Python's shortest form of the same double).
"""
import json, pathlib, sys

ARM = ("name", "manufacturer", "source", "provenance", "convention", "dof", "base", "rows", "tool", "limits", "family", "notes")
IK = ("kind", "task", "pose", "solutions", "sigma_min", "lock", "double_roots", "families", "delta", "rel_eps", "near_moving")


def pick(record, keys):
    return {key: record[key] for key in keys if key in record}


def lines(records):
    return "[\n" + ",\n".join(json.dumps(r, separators=(",", ":")) for r in records) + "\n]"


def main():
    source = pathlib.Path(sys.argv[1])
    target = pathlib.Path(__file__).resolve().parent.parent / "data"
    (target / "cases").mkdir(parents=True, exist_ok=True)
    arms = json.loads((source / "arms.json").read_text())
    (target / "arms.json").write_text(lines(pick(arm, ARM) for arm in arms) + "\n")
    for arm in arms:
        cases = json.loads((source / "cases" / (arm["name"] + ".json")).read_text())
        fk = lines(pick(case, ("q", "T", "J")) for case in cases["fk"])
        ik = lines(pick(case, IK) for case in cases["ik"])
        (target / "cases" / (arm["name"] + ".json")).write_text(f'{{"fk":{fk},\n"ik":{ik}}}\n')
    truth = json.loads((source / "seeds_truth.json").read_text())
    for case in truth["seed000"]["ik"].values():
        case.pop("peers", None)
    (target / "seeds_truth.json").write_text(json.dumps(truth, indent=1) + "\n")


if __name__ == "__main__":
    main()
