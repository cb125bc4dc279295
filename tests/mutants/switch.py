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
import hashlib, json, os, pathlib, re, resource, signal, subprocess, sys

# The tests that may see what is changed in a crate: its own, as `package::program`, and those of the `tests` member.
TESTS = {
    "kin-gen": ["kin-gen::algebra", "kin-gen::kin_gen", "polynomial", "fk", "jacobian", "params", "cost", "mathml"],
    "kin-runtime": ["kin-runtime::kin_runtime", "bits", "params", "rim", "straight", "units", "general", "short", "choice", "track",
                    "census", "closest", "crossings", "ik", "batch", "folded", "roots", "reference", "families", "shoulders",
                    "bases", "watch", "open", "reliability"],
}
# Slower to build, and many times as fast.
OPTIMISED = ["--config", "profile.dev.opt-level=1"]
SWITCH = """
/// Which change is on, and, if the variable MET names a file, in it which functions with changes have been met.
#[doc(hidden)]
#[allow(missing_docs, unused, unreachable_pub)]
pub mod switch {
    extern crate std;
    use std::io::Write;
    use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
    static ON: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    static MET: [AtomicBool; COUNT] = [const { AtomicBool::new(false) }; COUNT];
    #[inline(never)]
    fn meet(function: usize) {
        if let (false, Some(file)) = (MET[function].swap(true, Relaxed), std::env::var_os("MET")) {
            let mut file = std::fs::OpenOptions::new().append(true).create(true).open(file).unwrap();
            file.write_all(std::format!("{function}\\n").as_bytes()).unwrap();
        }
    }
    #[inline(never)]
    pub fn on(function: usize) -> u32 {
        if !MET[function].load(Relaxed) {
            meet(function);
        }
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
    """The text with all changes in it; for each change the lines that are its own, and the first one of its function; and those
    that cannot be in it."""
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
    pieces, own, heads, done, line = [], {}, {}, 0, 1

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
        head = inside[0][0]
        add(f"match crate::switch::on({head}) {{\n")
        for number, change in inside:
            a, b = places.span(change["span"])
            begin = line
            add(f"{number} => {{" + original[first:a] + change["replacement"] + " " + original[b:last] + "}\n")
            own[number], heads[number] = (begin, line - 1), head
        add("_ => {" + original[first:last] + "}\n}")
        done = last
    add(original[done:])
    return "".join(pieces), own, heads, apart


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
    """Writes all changes that compile into the tree; those that do not are added to the others, with the reason. Gives the
    first change of each one's function, and those that must be tried alone."""
    sources, apart, heads = {}, set(), {}
    switch = SWITCH.replace("COUNT", str(len(changes) + 1)).encode()
    for number, change in changes.items():
        sources.setdefault(change["file"], []).append((number, change))
    for path in plain.rglob("*"):
        file = path.relative_to(plain).as_posix()
        if path.is_file() and file not in sources:
            text = path.read_bytes()
            put(tree / file, text + switch if re.fullmatch("kin-(gen|runtime)/src/lib.rs", file) else text)
    while True:
        own = {}
        for file, inside in sources.items():
            original = (plain / file).read_text()
            text, own[file], first, alone = written(original, [c for c in inside if c[0] not in unviable])
            put(tree / file, text.encode())
            apart.update(alone)
            heads.update(first)
        wrong = errors(tree)
        if not wrong:
            return heads, apart
        before = len(unviable)
        for file, line, message in wrong:
            for number, (first, last) in own.get(file, {}).items():
                if first <= line <= last:
                    unviable[number] = message
        print(f"{len(unviable) - before} do not compile", flush=True)
        if len(unviable) == before:
            sys.exit(f"mistakes outside of every change: {wrong}")


class Program:
    """A program of tests: where it is run, its file, the functions with changes that it meets, and how long it takes with no
    change on."""

    def __init__(self, name, folder, file, note):
        self.folder, self.file = folder, file
        self.digest = hashlib.sha256(pathlib.Path(file).read_bytes()).hexdigest()[:16]
        note.unlink(missing_ok=True)
        wrong, self.took = self.fails(0, 1800, MET=str(note))
        if wrong:
            sys.exit(f"{name} fails as it is: {wrong}")
        self.met = {int(line) for line in note.read_text().splitlines()} if note.exists() else set()
        print(f"{name}: {self.took:.1f} s, {len(self.met)} functions", flush=True)

    def fails(self, change, limit, **more):
        """The first test that fails with the change on, "endless" after so many seconds of the processor, or None; and how many
        it took."""
        def used():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime

        before = used()
        # Not by the clock, which says nothing on a machine that others use too.
        bounded = lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
        run = subprocess.Popen([self.file], cwd=self.folder, env={**os.environ, "CHANGE": str(change), **more},
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
        return wrong, used() - before


def built(tree, name):
    """The file of a program of tests."""
    package, _, target = name.rpartition("::")
    package = package or "tests"
    which = ["--lib"] if target == package.replace("-", "_") else ["--test", target]
    command = ["cargo", *OPTIMISED, "test", "--offline", "-p", package, *which, "--no-run", "--message-format", "json"]
    run = subprocess.run(command, cwd=tree, stdout=subprocess.PIPE, text=True)
    messages = [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]
    if run.returncode:
        sys.exit("".join((m.get("message") or {}).get("rendered") or "" for m in messages))
    return tree / package, next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == target)


def trial(tree, names, changes, heads, out):
    """Those changes that none of the programs sees. One program after the other is asked about what is left, if it meets the
    function at all. Who was asked stands in a file, with what the program was then, so that it is not asked again."""
    lines = lambda name: (out / name).read_text().splitlines() if (out / name).exists() else []
    caught, asked = {line.split("\t")[0] for line in lines("caught.txt")}, set(lines("asked.txt"))
    left = {n: change for n, change in changes.items() if change["name"] not in caught}
    for name in names:
        if not left:
            break
        program = Program(name, *built(tree, name), out / "met.txt")
        ask = [n for n in left if heads[n] in program.met and f"{program.digest}\t{name}\t{left[n]['name']}" not in asked]
        for done, n in enumerate(ask, 1):
            print(f"\r{name}: {done} of {len(ask)}, {len(left)} left", end="\n" if done == len(ask) else "", file=sys.stderr)
            wrong, took = program.fails(n, int(5 + 10 * program.took))
            file, line = ("caught.txt", f"{left[n]['name']}\t{name}::{wrong}\t{took:.1f} s") if wrong else \
                ("asked.txt", f"{program.digest}\t{name}\t{left[n]['name']}")
            with (out / file).open("a") as told:
                print(line, file=told)
            if wrong:
                del left[n]
    return left


def main():
    every, sample, plain, tree, out = (pathlib.Path(x) for x in sys.argv[1:6])
    every = {change["name"]: change for change in json.loads(every.read_text())}
    changes = dict(enumerate((every[name] for name in sample.read_text().splitlines()), 1))
    known = (out / "unviable.txt").read_text().splitlines() if (out / "unviable.txt").exists() else []
    known = dict(line.partition("\t")[::2] for line in known)
    unviable = {n: known[change["name"]] for n, change in changes.items() if change["name"] in known}
    heads, apart = switched(changes, plain, tree, unviable)
    tell = lambda name, lines: (out / name).write_text("".join(line + "\n" for line in lines))
    tell("unviable.txt", [f"{changes[n]['name']}\t{unviable[n]}" for n in sorted(unviable)])
    tell("apart.txt", [changes[n]["name"] for n in sorted(apart)])
    inside = {n: change for n, change in changes.items() if n not in unviable and n not in apart}
    print(f"{len(inside)} are built in", flush=True)
    missed = {}
    for package, names in TESTS.items():
        missed |= trial(tree, names, {n: c for n, c in inside.items() if c["package"] == package}, heads, out)
    tell("missed.txt", [change["name"] for change in missed.values()])


if __name__ == "__main__":
    main()
