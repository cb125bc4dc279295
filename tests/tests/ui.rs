//! What rustc shows for a mistake: one file per mistake, in a folder per topic, and its message beside it.
//!
//! `TRYBUILD=overwrite cargo test -p tests --test ui` writes the messages anew; read the difference before committing.
//! There is one runner for all of them, since each builds the workspace once more.

use std::fs;
use std::path::Path;

#[test]
fn messages() {
    let cases = trybuild::TestCases::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("ui");
    let mut topics: Vec<String> = fs::read_dir(folder)
        .expect("the folder of cases")
        .map(|entry| entry.expect("a topic").file_name().to_string_lossy().into_owned())
        .collect();
    topics.sort();
    for topic in topics {
        match topic.as_str() {
            "pass" => cases.pass("ui/pass/*.rs"),
            _ => cases.compile_fail(format!("ui/{topic}/*.rs")),
        }
    }
}
