//! The reference data is whole, and `robots` declares what it should.

use std::collections::BTreeSet;

use tests::{declared, dh, reference};

#[test]
fn the_data_is_whole() {
    let arms = reference::arms();
    assert_eq!(arms.len(), 42);
    let cases: Vec<_> = arms.iter().map(|arm| arm.cases()).collect();
    assert_eq!(cases.iter().map(|c| c.fk.len()).sum::<usize>(), 2100);
    assert_eq!(cases.iter().map(|c| c.ik.len()).sum::<usize>(), 1749);
    assert_eq!(cases.iter().flat_map(|c| &c.ik).map(|c| c.solutions.len()).sum::<usize>(), 10026);
}

#[test]
fn every_arm_of_the_family_is_declared() {
    let declared: BTreeSet<&str> = declared::all().iter().map(|arm| arm.name).collect();
    let family: Vec<_> =
        reference::arms().into_iter().filter(|a| a.family.name == "6R spherical wrist, 2||3").collect();
    assert_eq!(family.len(), 18);
    for arm in &family {
        assert!(declared.contains(arm.name.as_str()), "{}", arm.name);
    }
    let short = ["al5d", "cobra600", "orion5", "planar3", "twolink"];
    for name in ["stanford", "ur5", "panda", "seed004_3dof"].into_iter().chain(short) {
        assert!(declared.contains(name), "{name}");
    }
    let inverses = declared::all().iter().filter(|arm| arm.inverse.is_some()).count();
    assert_eq!(inverses, 25);
}

#[test]
fn every_reference_table_reads_as_a_declaration() {
    for arm in reference::arms() {
        let derived = kin_gen::compile_text(&dh::text(&arm)).unwrap_or_else(|e| panic!("{}: {e}", arm.name));
        assert_eq!(derived.joints.len(), arm.dof, "{}", arm.name);
    }
}

#[test]
fn arms_list_themselves() {
    let names: BTreeSet<_> = robots::ALL.iter().map(|arm| arm.name()).collect();
    assert_eq!((robots::ALL.len(), names.len()), (28, 28));
    for arm in robots::ALL {
        // What an arm says about itself can be derived again.
        let derived = kin_gen::compile_text(arm.table()).unwrap_or_else(|e| panic!("{}: {e}", arm.name()));
        assert_eq!(derived.name, arm.name());
        assert_eq!(derived.joints.len(), arm.joints().len());
        assert!(arm.table().matches("check").count() >= 2, "{} has too few golden poses", arm.name());
    }
}
