//! The rules of the house that a compiler does not check; ARCHITECTURE.md says why each of them holds.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A text file of the repository; its path is relative to the root, with `/`.
struct Source {
    path: String,
    text: String,
}

impl Source {
    /// Its lines, counted from 1, without comments. (No string in the workspace contains `//` before code.)
    fn code(&self) -> impl Iterator<Item = (usize, &str)> {
        let lines = self.text.lines().enumerate();
        lines.map(|(index, line)| (index + 1, line.split("//").next().unwrap_or_default()))
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every text file under `folder`, the root itself being "". Build output and git's own files are not ours.
fn sources(folder: &str) -> Vec<Source> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::from(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root().join(&folder)).expect("a folder of the repository") {
            let entry = entry.expect("a directory entry");
            let name = entry.file_name();
            let path = folder.join(&name);
            if entry.file_type().expect("a file type").is_dir() {
                if name != "target" && name != ".git" {
                    folders.push(path);
                }
            } else if name != ".git"
                && let Ok(text) = fs::read_to_string(entry.path())
            {
                found.push(Source { path: path.to_string_lossy().replace('\\', "/"), text });
            }
        }
    }
    found.sort_by(|a, b| a.path.cmp(&b.path));
    found
}

fn rust(folder: &str) -> Vec<Source> {
    sources(folder).into_iter().filter(|source| source.path.ends_with(".rs")).collect()
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Fails with every place at once.
fn none(rule: &str, places: Vec<String>) {
    assert!(places.is_empty(), "{rule}:\n  {}", places.join("\n  "));
}

/// The lines of code under `folder` that hold one of `words`, except in files whose path ends with one of `but`.
fn lines_with(folder: &str, words: &[&str], but: &[&str]) -> Vec<String> {
    let mut places = Vec::new();
    for source in rust(folder).iter().filter(|source| !but.iter().any(|end| source.path.ends_with(end))) {
        for (number, line) in source.code() {
            if words.iter().any(|word| line.contains(word)) {
                places.push(format!("{}:{number}: {}", source.path, line.trim()));
            }
        }
    }
    places
}

/// The names in one section of a manifest.
fn section(manifest: &str, title: &str) -> Vec<String> {
    let text = read(manifest);
    let lines = text.lines().skip_while(|line| line.trim() != title).skip(1);
    lines
        .take_while(|line| !line.starts_with('['))
        .filter_map(|line| {
            line.split(['.', '=', ' ']).next().filter(|name| !name.is_empty() && !name.starts_with('#'))
        })
        .map(str::to_owned)
        .collect()
}

#[test]
fn who_may_depend_on_whom() {
    let allowed: BTreeMap<&str, &[&str]> = BTreeMap::from([
        ("kin-gen", [].as_slice()),
        ("dh-macro", ["kin-gen", "proc-macro2", "quote", "syn"].as_slice()),
        ("kin-runtime", ["dh-macro", "libm", "nalgebra", "pulp", "rayon", "serde"].as_slice()),
        ("robots", ["kin-runtime"].as_slice()),
    ]);
    for (name, allowed) in allowed {
        let manifest = format!("{name}/Cargo.toml");
        let mut found = section(&manifest, "[dependencies]");
        found.extend(section(&manifest, "[target.'cfg(target_arch = \"x86_64\")'.dependencies]"));
        let strangers = found.into_iter().filter(|found| !allowed.contains(&found.as_str())).collect();
        none(&format!("{name} depends on {allowed:?} at most"), strangers);
    }
}

#[test]
fn every_package_obeys_the_workspace_lints() {
    for package in ["dh-macro", "kin-gen", "kin-runtime", "robots", "robots/report", "tests"] {
        assert_eq!(
            section(&format!("{package}/Cargo.toml"), "[lints]"),
            ["workspace"],
            "{package}/Cargo.toml"
        );
    }
}

/// kin-gen's modules in reading order: each may import those of its own line and of the lines before it, and no other.
const ORDER: [&[&str]; 13] = [
    &["report"],
    &["number"],
    &["decl"],
    &["chain"],
    &["algebra", "truth"],
    &["plan"],
    &["derive"],
    &["quantity"],
    &["family"],
    &["program", "signs", "names"],
    &["model"],
    &["textbook"],
    &["eval", "back"],
];

#[test]
fn imports_in_kin_gen_go_down_the_list() {
    let line_of = |module: &str| ORDER.iter().position(|line| line.contains(&module));
    let mut places = Vec::new();
    for source in rust("kin-gen/src").iter().filter(|source| !source.path.ends_with("src/lib.rs")) {
        let module =
            source.path.trim_start_matches("kin-gen/src/").split(['/', '.']).next().unwrap_or_default();
        let Some(own) = line_of(module) else {
            places.push(format!("{}: no place in the list", source.path));
            continue;
        };
        for (number, line) in source.code() {
            for import in line.split("crate::").skip(1) {
                let import: String =
                    import.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                if line_of(&import).is_some_and(|other| other > own) {
                    places.push(format!("{}:{number}: {module} imports {import}", source.path));
                }
            }
        }
    }
    none("imports in kin-gen go down the list", places);
}

#[test]
fn derive_never_sees_a_place_in_the_source() {
    none("derive imports report", lines_with("kin-gen/src/derive", &["crate::report"], &[]));
}

#[test]
fn back_never_sees_a_chain() {
    // The kinds of joint, unit and parameter are facts that a derived arm repeats; the chain itself is not.
    none("back reads a chain", lines_with("kin-gen/src/back", &["Chain", "Motion", "Element"], &[]));
}

#[test]
fn kin_gen_is_a_function_of_its_input() {
    let words = ["HashMap", "HashSet", "std::env", "std::time", "std::thread"];
    none("kin-gen's output is a function of its input", lines_with("kin-gen/src", &words, &["cargo.rs"]));
    let words = [".sin()", ".cos()", ".tan()", ".exp()", ".ln()", ".powi(", ".powf(", ".mul_add("];
    none("constants never come from the host's functions", lines_with("kin-gen/src", &words, &["eval.rs"]));
}

#[test]
fn kin_gen_knows_no_consumer() {
    none(
        "kin-gen names a crate it must not know",
        lines_with("kin-gen/src", &["syn::", "nalgebra::", "proc_macro"], &[]),
    );
}

#[test]
fn kin_runtime_has_no_std_and_no_alloc() {
    let lib = read("kin-runtime/src/lib.rs");
    assert!(lib.lines().any(|line| line == "#![no_std]"), "kin-runtime/src/lib.rs says #![no_std]");
    let words = ["extern crate std", "extern crate alloc", "std::", "alloc::"];
    none("kin-runtime names std or alloc", lines_with("kin-runtime/src", &words, &[]));
}

#[test]
fn only_math_calls_a_transcendental_function() {
    none(
        "only math calls libm",
        lines_with(
            "kin-runtime/src",
            &["libm::"],
            &["src/math/mod.rs", "src/math/root.rs", "src/math/wrap.rs"],
        ),
    );
    let words = [
        ".sin()",
        ".cos()",
        ".tan()",
        ".asin()",
        ".acos()",
        ".atan()",
        ".exp()",
        ".ln()",
        ".powf(",
        ".mul_add(",
    ];
    none("nalgebra's functions are not ours", lines_with("kin-runtime/src", &words, &["src/math/mod.rs"]));
}

#[test]
fn every_module_says_what_it_is() {
    let folders = [
        "dh-macro/src",
        "kin-gen/src",
        "kin-runtime/src",
        "robots/src",
        "robots/report",
        "tests/src",
        "tests/tests",
        "tests/benches",
    ];
    let silent = folders.into_iter().flat_map(rust).filter(|source| !source.text.starts_with("//! "));
    none("a module begins with its doc comment", silent.map(|source| source.path).collect());
}

#[test]
fn nothing_is_left_undone() {
    // Spelled in two parts, so that this file passes its own test.
    let words = [
        concat!("to", "do!"),
        concat!("unimple", "mented!"),
        concat!("TO", "DO"),
        concat!("FIX", "ME"),
        concat!("db", "g!("),
    ];
    let mut places = Vec::new();
    for source in
        sources("").iter().filter(|source| source.path.ends_with(".rs") || source.path.ends_with(".md"))
    {
        for (index, line) in source.text.lines().enumerate() {
            if words.iter().any(|word| line.contains(word)) {
                places.push(format!("{}:{}: {}", source.path, index + 1, line.trim()));
            }
        }
    }
    none("a note to self is an issue, not a comment", places);
}

#[test]
fn no_path_of_one_machine() {
    let words = [
        concat!("/ho", "me/"),
        concat!("/ro", "ot/"),
        concat!("/wo", "rk/"),
        concat!("/tm", "p/"),
        concat!("/Use", "rs/"),
    ];
    let mut places = Vec::new();
    for source in sources("") {
        for (index, line) in source.text.lines().enumerate() {
            if words.iter().any(|word| line.contains(word)) {
                places.push(format!("{}:{}", source.path, index + 1));
            }
        }
    }
    none("a path that only one machine has", places);
}

#[test]
fn the_commands_of_the_readme_are_what_ci_runs() {
    let (readme, ci) = (read("README.md"), read(".ci/run"));
    for command in [
        "cargo run --release --example quickstart",
        "cargo test --workspace",
        "cargo run --release --example lab_reports",
    ] {
        assert!(
            readme.lines().any(|line| line.split('#').next().unwrap_or_default().trim() == command),
            "README.md: {command}"
        );
        assert!(ci.lines().any(|line| line.trim().ends_with(command)), ".ci/run: {command}");
    }
}

#[test]
fn the_tests_that_architecture_names_exist() {
    let sources = rust("");
    let architecture = read("ARCHITECTURE.md");
    let rows = architecture.lines().filter(|line| line.starts_with('|'));
    let named =
        rows.flat_map(|row| row.split('`').skip(1).step_by(2)).filter_map(|code| code.rsplit_once("::"));
    let lost = named.filter(|(file, test)| {
        let stands =
            |source: &Source| source.path.contains(file) && source.text.contains(&format!("fn {test}()"));
        file.chars().all(|c| c.is_ascii_lowercase()) && !sources.iter().any(stands)
    });
    none(
        "ARCHITECTURE.md names a test that is not there",
        lost.map(|(file, test)| format!("{file}::{test}")).collect(),
    );
}

/// The code that the README shows is what its table compiles to, white space apart.
#[test]
fn the_readme_shows_what_is_generated() {
    let readme = read("README.md");
    let between = |start: &str, end: &str| {
        let text = readme.split_once(start).expect(start).1;
        text.split_once(end).expect(end).0.to_owned()
    };
    let dense = |text: &str| text.split_whitespace().collect::<String>();
    let arm =
        kin_gen::compile_text(&between("dh! {", "\n}\n")).unwrap_or_else(|messages| panic!("{messages}"));
    let generated = dense(&kin_gen::back::rust::items(&arm, "::kin_runtime"));
    assert!(generated.contains(&dense(&between("```rust,ignore\n", "```"))), "README.md: fn r36");
}

#[test]
fn macros_are_built_as_users_build_them() {
    // An optimised profile here would flatter the timing that users get.
    let manifest = read("Cargo.toml");
    for section in ["[profile.dev", "build-override"] {
        assert!(!manifest.contains(section), "Cargo.toml tunes {section}");
    }
}

#[test]
fn the_stated_rust_version_is_enough_for_every_dependency() {
    let manifest = root().join("Cargo.toml");
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--offline", "--all-features", "--manifest-path"])
        .arg(manifest)
        .output()
        .expect("cargo metadata runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).expect("cargo prints JSON");
    let packages = metadata["packages"].as_array().expect("packages");
    let stated = packages
        .iter()
        .find(|package| package["name"] == "kin-runtime")
        .map(rust_version)
        .expect("kin-runtime");
    let newer = packages.iter().filter(|package| rust_version(package) > stated);
    none(
        "rust-version of the workspace is too low for",
        newer.map(|package| package["name"].to_string()).collect(),
    );
}

fn rust_version(package: &serde_json::Value) -> Vec<u32> {
    let text = package["rust_version"].as_str().unwrap_or("1");
    text.split('.').map(|part| part.parse().unwrap_or(0)).chain([0, 0]).take(3).collect()
}

/// `golden/<arm>.dh` is printed by every backend into `golden/<arm>.<backend>`.
#[test]
fn goldens_are_current() {
    let update = std::env::var_os("UPDATE").is_some();
    let mut stale = Vec::new();
    for source in sources("tests/golden").iter().filter(|source| source.path.ends_with(".dh")) {
        let arm = kin_gen::compile_text(&source.text)
            .unwrap_or_else(|messages| panic!("{}\n{messages}", source.path));
        for backend in &kin_gen::back::ALL {
            let path = source.path.replace(".dh", &format!(".{}", backend.name));
            let (file, printed) = (root().join(&path), (backend.print)(&arm));
            if update {
                fs::write(&file, printed).unwrap_or_else(|error| panic!("{path}: {error}"));
            } else if fs::read_to_string(&file).ok().as_deref() != Some(&printed) {
                stale.push(path);
            }
        }
    }
    none(
        "what kin-gen prints has changed; look at it with `UPDATE=1 cargo test -p tests --test tidy`",
        stale,
    );
}
