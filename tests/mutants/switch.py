#!/usr/bin/env python3
"""Tests a sample of changes with one build: all of them are written into a copy of the sources, and a variable says which
one is on. `run.sh` calls it; the changes are those of cargo-mutants, word for word.

  python3 switch.py ALL.json SAMPLE.txt PLAIN TREE OUT

ALL.json      all changes, as `cargo mutants --list --json` tells them
SAMPLE.txt    the names of those to be tried
PLAIN         the sources
TREE          where they are written with the changes in them; only what is not yet so is written
OUT           where to write: caught.txt, missed.txt, unviable.txt and apart.txt, one change a line

A function with changes becomes a choice between its body and the same body with one of them. A change that does not
compile there is found by the compiler's own report, taken out, and told in unviable.txt. What cannot be told apart at run
time, a `const fn` or an item that is no function, is told in apart.txt, for cargo-mutants itself to try. No change is on
while arms are compiled: of those in kin-gen only the tests that call it hear.
"""
import json, os, pathlib, re, resource, signal, subprocess, sys

# The tests that reach what is changed in a crate, the quick and sharp ones first: its own, as `package::program`, and those of
# the `tests` member.
TESTS = {
    "kin-gen": ["kin-gen::algebra", "kin-gen::kin_gen", "polynomial", "fk", "jacobian", "params", "cost", "mathml"],
    "kin-runtime": ["bits", "kin-runtime::kin_runtime", "params", "rim", "straight", "general", "short", "choice", "track",
                    "census", "closest", "watch", "ik", "batch", "folded", "reference", "families", "shoulders", "bases",
                    "reliability"],
}
# What a file is about is asked before the others, as most changes do not outlive it.
FIRST = {
    "(general|sheaf|conic|quartic|lines|refine)": ["general"],
    "closest": ["closest"],
    "(short|freed)": ["short"],
    "sphere": ["shoulders"],
    "(track/|choice)": ["track", "census", "choice"],
}
# Dependencies only: all those changes make the solvers slow to optimise.
OPTIMISED = ["--config", 'profile.dev.package."*".opt-level=1']
SWITCH = """
/// Which change is on.
#[doc(hidden)]
#[allow(missing_docs, unused, unreachable_pub)]
pub mod switch {
    extern crate std;
    static ON: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    #[inline(never)]
    pub fn on() -> u32 {
        *ON.get_or_init(|| std::env::var("CHANGE").ok().and_then(|n| n.parse().ok()).unwrap_or(0))
    }
}
"""


class Text:
    """The text of a file, with places given as lines and columns from 1."""

    def __init__(self, text):
        self.text, self.starts = text, [0]
        for line in text.splitlines(keepends=True):
            self.starts.append(self.starts[-1] + len(line))

    def place(self, at):
        return self.starts[at["line"] - 1] + at["column"] - 1

    def span(self, span):
        return self.place(span["start"]), self.place(span["end"])


def body(text, start, end):
    """Where the body of the function in start..end begins, behind its brace; None if a switch cannot stand in it."""
    depth, at = 0, re.compile(r"\bfn\s").search(text, start, end).end()
    signature = re.sub(r"//.*", "", text[start:at])
    while depth or text[at] != "{":
        depth += (text[at] in "([") - (text[at] in ")]")
        at += 1
    if re.search(r"\bconst (unsafe )?fn\s", signature) or re.search(r"->\s*impl\b", text[start:at]):
        return None
    return at + 1


def written(original, changes):
    """The text with all changes in it, and for each change the lines that are its own."""
    places, functions, apart = Text(original), [], []
    for number, change in sorted(changes, key=lambda c: c[1]["function"] is None or places.span(c[1]["function"]["span"])[0]):
        if change["function"] is None:
            apart.append(number)
            continue
        start, end = places.span(change["function"]["span"])
        if functions and start < functions[-1][1]:  # a function in a function: its changes are also the outer one's
            functions[-1][2].append((number, change))
        else:
            functions.append((start, end, [(number, change)]))
    pieces, own, done, line = [], {}, 0, 1

    def add(piece):
        nonlocal line
        pieces.append(piece)
        line += piece.count("\n")

    for start, end, inside in functions:
        first, last = body(original, start, end), end - 1
        if first is None:
            apart += [number for number, _ in inside]
            continue
        add(original[done:first])
        add("match crate::switch::on() {\n")
        for number, change in inside:
            a, b = places.span(change["span"])
            begin = line
            add(f"{number} => {{" + original[first:a] + change["replacement"] + " " + original[b:last] + "}\n")
            own[number] = (begin, line - 1)
        add("_ => {" + original[first:last] + "}\n}")
        done = last
    add(original[done:])
    return "".join(pieces), own, apart


def errors(tree):
    """Where the compiler sees mistakes: (file, line)."""
    found = []
    for package in ["kin-gen", "kin-runtime"]:
        command = ["cargo", "check", "--offline", "-p", package, "--lib", "--message-format", "json"]
        run = subprocess.run(command, cwd=tree, capture_output=True, text=True)
        for line in run.stdout.splitlines():
            message = json.loads(line).get("message") or {}
            if message.get("level") == "error" and message.get("spans"):
                spans = [s for s in message["spans"] if s["is_primary"]]
                # A mistake inside a macro of the standard library is where it was called.
                while spans[0]["file_name"].startswith("/") and spans[0]["expansion"]:
                    spans = [spans[0]["expansion"]["span"]]
                found += [(s["file_name"], s["line_start"], message["message"]) for s in spans]
        if run.returncode and not found:
            sys.exit(run.stderr)
        if found:
            break
    return found


def put(path, text):
    """Leaves a file that is so already alone, for cargo looks at its age."""
    if not path.exists() or path.read_bytes() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)


def switched(changes, plain, tree, unviable):
    """Writes all changes that compile into the tree; those that do not are added to the others, with the reason. Gives
    those that must be tried alone."""
    sources, apart = {}, set()
    for number, change in changes.items():
        sources.setdefault(change["file"], []).append((number, change))
    for path in plain.rglob("*"):
        file = path.relative_to(plain).as_posix()
        if path.is_file() and file not in sources:
            text = path.read_bytes()
            put(tree / file, text + SWITCH.encode() if re.fullmatch("kin-(gen|runtime)/src/lib.rs", file) else text)
    while True:
        own = {}
        for file, inside in sources.items():
            original = (plain / file).read_text()
            text, own[file], alone = written(original, [c for c in inside if c[0] not in unviable])
            put(tree / file, text.encode())
            apart.update(alone)
        wrong = errors(tree)
        if not wrong:
            return apart
        before = len(unviable)
        for file, line, message in wrong:
            for number, (first, last) in own.get(file, {}).items():
                if first <= line <= last:
                    unviable[number] = message
        print(f"{len(unviable) - before} do not compile", flush=True)
        if len(unviable) == before:
            sys.exit(f"mistakes outside of every change: {wrong}")


def programs(tree, names):
    """The tests' programs: where each is run, its file, and how long it takes with no change on."""
    found = {}
    for package in sorted({name.rpartition("::")[0] or "tests" for name in names}):
        inside = [name for name in names if (name.rpartition("::")[0] or "tests") == package]
        targets = {name.rpartition("::")[2]: name for name in inside}
        which = [word for target in targets
                 for word in (["--lib"] if target == package.replace("-", "_") else ["--test", target])]
        command = ["cargo", *OPTIMISED, "test", "--offline", "-p", package, *which, "--no-run", "--message-format", "json"]
        run = subprocess.run(command, cwd=tree, stdout=subprocess.PIPE, text=True)
        messages = [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]
        if run.returncode:
            sys.exit("".join((m.get("message") or {}).get("rendered") or "" for m in messages))
        for message in messages:
            name = targets.get(message["target"]["name"]) if message.get("executable") else None
            if name:
                wrong, took = fails(tree / package, message["executable"], 0, 1800)
                print(f"{name}: {took:.1f} s", flush=True)
                if wrong:
                    sys.exit(f"{name} fails as it is: {wrong}")
                found[name] = (tree / package, message["executable"], took)
    return found


def fails(folder, program, change, limit):
    """The first test that fails with the change on, "endless" after so many seconds of the processor, or None; and how many
    it took."""
    used = lambda: resource.getrusage(resource.RUSAGE_CHILDREN)
    before = used()
    # Not by the clock, which says nothing on a machine that others use too.
    bounded = lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
    run = subprocess.Popen([program], cwd=folder, env={**os.environ, "CHANGE": str(change)},
                           stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, preexec_fn=bounded)
    wrong = None
    for line in run.stdout:
        failed = re.match(r"test (\S+) .*FAILED$", line)
        if failed:
            wrong = failed.group(1)
            run.kill()
            break
    run.stdout.close()
    if run.wait() != 0 and wrong is None:
        wrong = "endless" if -run.returncode in (signal.SIGXCPU, signal.SIGKILL) else "crash"
    after = used()
    return wrong, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def trial(tree, names, changes, caught):
    """Those changes that none of the tests sees; what others see goes to the file."""
    told = {line.split("\t")[0] for line in pathlib.Path(caught.name).read_text().splitlines()}
    left = {n: change for n, change in changes.items() if change["name"] not in told}
    missed, found = {}, programs(tree, names) if left else {}
    for done, (number, change) in enumerate(left.items(), 1):
        first = [name for part, about in FIRST.items() if re.search(part, change["file"]) for name in about]
        order = sorted(found, key=lambda name: (name != names[0], name not in first, names.index(name)))
        for name in order:
            folder, path, took = found[name]
            wrong = fails(folder, path, number, int(20 + 10 * took))[0]
            if wrong:
                print(f"{change['name']}\t{name}::{wrong}", file=caught, flush=True)
                break
        else:
            missed[number] = change
            print(f"not caught: {change['name']}", flush=True)
        print(f"\r{done} of {len(left)}, {len(missed)} not caught", end="\n" if done == len(left) else "", file=sys.stderr)
    return missed


def main():
    every, sample, plain, tree, out = (pathlib.Path(x) for x in sys.argv[1:6])
    every = {change["name"]: change for change in json.loads(every.read_text())}
    changes = dict(enumerate((every[name] for name in sample.read_text().splitlines()), 1))
    known = (out / "unviable.txt").read_text().splitlines() if (out / "unviable.txt").exists() else []
    known = dict(line.partition("\t")[::2] for line in known)
    unviable = {n: known[change["name"]] for n, change in changes.items() if change["name"] in known}
    apart = switched(changes, plain, tree, unviable)
    tell = lambda name, lines: (out / name).write_text("".join(line + "\n" for line in lines))
    tell("unviable.txt", [f"{changes[n]['name']}\t{unviable[n]}" for n in sorted(unviable)])
    tell("apart.txt", [changes[n]["name"] for n in sorted(apart)])
    built = {n: change for n, change in changes.items() if n not in unviable and n not in apart}
    print(f"{len(built)} are built in", flush=True)
    missed = {}
    with (out / "caught.txt").open("a") as caught:
        for package, names in TESTS.items():
            missed |= trial(tree, names, {n: c for n, c in built.items() if c["package"] == package}, caught)
    tell("missed.txt", [change["name"] for change in missed.values()])


if __name__ == "__main__":
    main()
