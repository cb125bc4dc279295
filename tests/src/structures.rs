//! The structures whose plans ship with `kin-gen`.

use std::collections::BTreeSet;

use kin_gen::plan::shape::{Group, Link, Shape};
use kin_gen::plan::{WANTED, Wanted};
use kin_gen::report::Report;
use kin_gen::{chain, decl, model};

use crate::{dh, measured, reference};

/// Structures of common arms that are declared nowhere here: Kinova's Gen3 with seven joints.
const OTHERS: [&str; 1] = ["d. d. d. d. d. . d."];

/// All of them, in the order of the file: those of `robots`, of the measured arms, of the reference and of other common arms,
/// and what stands before a wrist, with all lengths.
pub fn all() -> Vec<(Wanted, Shape)> {
    let tables = measured::robots().into_iter().map(|(_, table)| table.to_owned());
    let tables = tables.chain(measured::ARMS.iter().map(|arm| arm.table.to_owned()));
    let tables = tables.chain(reference::arms().into_iter().map(|arm| dh::text(&arm)));
    let mut found: BTreeSet<(Wanted, usize, String)> = BTreeSet::new();
    let declared = tables.flat_map(|table| of_table(&table));
    let others = OTHERS.into_iter().filter_map(Shape::parse);
    let others = others.flat_map(|shape| WANTED.map(|wanted| (wanted, shape.clone())));
    for (wanted, shape) in declared.chain(others).chain(groupings()) {
        found.insert((wanted, shape.joints().count(), shape.to_string()));
    }
    let parsed = |(wanted, _, shape): (Wanted, usize, String)| Some((wanted, Shape::parse(&shape)?));
    found.into_iter().filter_map(parsed).collect()
}

/// The structures that a table needs plans of.
///
/// # Panics
///
/// Where the table is none.
pub fn of_table(table: &str) -> Vec<(Wanted, Shape)> {
    let (tokens, _, mut report) = decl::lex(table);
    let chain = decl::parse(&tokens, &mut report).and_then(|decl| chain::check(&decl, &mut report));
    let chain = chain.unwrap_or_else(|| panic!("{table}\n{:?}", report as Report));
    model::structures(&chain).unwrap_or_else(|mismatch| panic!("{table}\n{mismatch}"))
}

/// Three joints as they stand before a wrist, however they do, with all their lengths.
fn groupings() -> Vec<(Wanted, Shape)> {
    let three = (1..=3).flat_map(|run| with_one_run(3, run));
    three.map(|runs| (Wanted::Pose, with_all_lengths(&runs))).collect()
}

/// So many joints, all alone but for one run of neighbours, wherever it stands.
fn with_one_run(joints: usize, run: usize) -> Vec<Vec<usize>> {
    let places = if run == 1 { 1 } else { joints - run + 1 };
    (0..places).map(|before| [vec![1; before], vec![run], vec![1; joints - run - before]].concat()).collect()
}

fn with_all_lengths(runs: &[usize]) -> Shape {
    let link = Link { x: true, y: false };
    let mut groups: Vec<Group> = runs.iter().map(|run| Group { d: true, links: vec![link; *run] }).collect();
    if let Some(last) = groups.last_mut().and_then(|group| group.links.last_mut()) {
        last.y = true;
    }
    Shape { groups, slides: Vec::new() }
}
