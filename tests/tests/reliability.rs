//! A short run of the program `reliability`, and that its runs are what they say.

use std::fs;
use std::path::PathBuf;

use indicatif::ProgressBar;
use kin_runtime::prelude::*;
use tests::reliability::report;
use tests::reliability::run::{Order, State, run};

fn order(poses: u64, patterns: u64) -> Order {
    Order { poses, patterns, seed: 7, threads: 2, resume: None }
}

fn state(order: &Order) -> State {
    run(order, &ProgressBar::hidden()).expect("a run without files cannot fail")
}

#[test]
fn a_short_run_keeps_every_figure() {
    let state = state(&order(10_000, 40_000));
    println!("{}", report::table(&state));
    assert_eq!(report::all_missed(&state), Vec::<String>::new());
    // Three families in two formats, and bits in two.
    assert_eq!(state.parts.len(), 8);
    // The aim is true: families are found, and poses that determine their joints badly.
    assert!(state.parts["elbow-f64"].tally.families > 500 && state.parts["elbow-f64"].tally.blurs > 500);
}

#[test]
fn threads_and_interruptions_change_nothing() {
    let file = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("reliability.json");
    let _ = fs::remove_file(&file);
    let whole = state(&Order { threads: 1, ..order(3_000, 3_000) });
    assert_eq!(whole, state(&Order { threads: 3, ..order(3_000, 3_000) }));
    let kept = Order { resume: Some(file.clone()), ..order(3_000, 3_000) };
    assert_eq!(whole, state(&kept));
    // A part that was cut off is gone on with.
    let mut text: State =
        serde_json::from_str(&fs::read_to_string(&file).expect("a state")).expect("a state");
    text.parts.retain(|name, _| name.starts_with("elbow"));
    fs::write(&file, serde_json::to_string(&text).expect("a state")).expect("written");
    assert_eq!(whole, state(&kept));
    // Another run's file is refused.
    assert!(run(&Order { seed: 8, ..kept }, &ProgressBar::hidden()).is_err());
}

/// Why joints are called blurred: these two vectors are 1e-4 apart, and what they reach is one pose to the last bits.
#[test]
fn no_solver_can_tell_them_apart() {
    let near = joints![0.3, -0.8, 0.6, 0.4, 1e-12, 0.5];
    let other = near + joints![0.0, 0.0, 0.0, 1e-4, 0.0, -1e-4];
    let apart = robots::Puma560.fk(&near).to_homogeneous() - robots::Puma560.fk(&other).to_homogeneous();
    assert!(apart.amax() <= 2.0 * f64::EPSILON, "{apart}");
    // Neither is near enough to be a family: its other members would miss the pose.
    assert!(robots::Puma560.ik(&robots::Puma560.fk(&near)).iter().all(|solution| solution.is_isolated()));
}

/// Found by this program: the wrist centre 6e-15 off axis 1 and on the inner circle, which joint 1 at 0 misses.
#[test]
fn folded_with_the_wrist_centre_almost_on_the_first_axis() {
    let bits = [
        0x4004_6fa6_4222_5bba_u64,
        0xc013_e5a3_7b25_6008,
        0x3ffb_6a7c_c281_684e,
        0xc003_5639_f44a_07fe,
        0xc001_8e93_30b5_b942,
        0xc008_8b4b_8ddf_778d,
    ];
    let pose = robots::Irb6640.fk(&Joints::from(bits.map(f64::from_bits)));
    let solutions = robots::Irb6640.ik(&pose);
    assert!(!solutions.is_empty(), "{solutions}");
    assert!(solutions.iter().all(|solution| solution.residual <= 13.0 * f64::EPSILON), "{solutions}");
}

/// Found by this program: folded exactly, and the circle about axis 1 just touching the plane of the arm, so that both shoulders come
/// from the boundary circle of the elbow, one on either side.
#[test]
fn each_shoulder_has_its_own_folded_elbow() {
    let q: Joints<f32, 6> =
        joints![-1.713_112_2, -0.255_040_65, 1.617_774_2, 1.644_186, -0.565_532_4, -0.805_978_95];
    let solutions = robots::Puma560.ik(&robots::Puma560.fk(&q));
    let arms = [-0.255, -2.886].map(|arm| solutions.iter().filter(|s| (s.q[1] - arm).abs() < 1e-2).count());
    assert_eq!(arms, [2, 2], "{solutions}");
}
