//! What the algebra is judged by, without the rest of the workspace: a change to it is tested in seconds.
//!
//! The tests of the proof are those of the `tests` member, which needs every arm to be built first.

extern crate self as tests;

#[path = "../../tests/src/sample.rs"]
#[allow(dead_code, reason = "written for other tests too")]
pub mod sample;

#[path = "../../tests/tests/proof.rs"]
mod proof;

/// The printed arms of `tests/golden`, to which any change of what is printed belongs.
#[test]
fn what_is_printed_is_what_it_was() {
    let golden = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/golden");
    for arm in ["every_statement", "puma560", "ur5"] {
        let read = |kind: &str| std::fs::read_to_string(format!("{golden}/{arm}.{kind}")).expect("a golden");
        let derived = kin_gen::compile_text(&read("dh")).unwrap_or_else(|messages| panic!("{messages}"));
        for backend in &kin_gen::back::ALL {
            assert!((backend.print)(&derived) == read(backend.name), "{arm}.{}", backend.name);
        }
    }
}
