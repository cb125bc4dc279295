//! A short run of the program `reliability`, and that its runs are what they say.

use std::f64::consts::FRAC_PI_2;
use std::fs;
use std::path::{Path, PathBuf};

use indicatif::ProgressBar;
use kin_runtime::prelude::*;
use kin_runtime::private::SolveWrist;
use kin_runtime::{Base, singularity};
use tests::invented::{HandCrossingA, Twisted};
use tests::reliability::parts::parts;
use tests::reliability::report;
use tests::reliability::run::{Order, State, run};
use tests::reliability::subject::{ByPose, ByTool, Subject, Tried};
use tests::reliability::tally::Tally;
use tests::reliability::way;
use tests::sample::Sampler;
use tests::skew::Skew;

fn order(poses: u64, patterns: u64) -> Order {
    Order { poses, patterns, seed: 7, threads: 2, resume: None }
}

fn state(order: &Order) -> State {
    run(order, &ProgressBar::hidden()).expect("a run without files cannot fail")
}

#[test]
fn a_short_run_keeps_every_figure() {
    let state = state(&order(1_000, 20_000));
    println!("{}", report::table(&state));
    assert_eq!(report::all_missed(&state), Vec::<String>::new());
    // Thirteen families in two formats, and bits in two.
    assert_eq!(state.parts.len(), 28);
    // The aim is true: families are found, and poses that determine their joints badly.
    for family in ["elbow", "telescope", "general", "meeting", "parallel", "crossing", "shoulder-general"] {
        let tally = &state.parts[&format!("{family}-f64")].tally;
        let (families, blurs) = (tally.families, tally.blurred.tries);
        assert!(families > 50 && blurs > 50, "{family}: {families} {blurs}");
    }
}

/// What `blurred` must not hide: the arm on its other side is as far from every singular set, but no way leads there.
#[test]
fn a_mirrored_arm_is_not_what_went_in() {
    let arm = Tried(robots::Puma560, ByPose);
    // Both the elbow and the wrist nearly straight: the manipulability says nothing of where solutions may be.
    let stretched = FRAC_PI_2 + (0.0203_f64 / 0.4318).atan();
    let q = joints![0.3, -0.8, stretched + 1e-9, 0.4, 1e-9, 0.5];
    let (target, window) = (robots::Puma560.fk(&q), 16.0 * f64::EPSILON);
    let solutions = robots::Puma560.ik(&target);
    let (own, other): (Vec<&Solution<_, 6, _>>, Vec<_>) =
        solutions.iter().partition(|s| (s.q[1] - q[1]).abs() < 1e-3);
    assert!(!own.is_empty() && !other.is_empty(), "{solutions}");
    assert!(own.iter().any(|s| way::leads(&arm, &target, &q, &[s.q], window)), "{solutions}");
    assert!(other.iter().all(|s| !way::leads(&arm, &target, &q, &[s.q], window)), "{solutions}");
    // Nor do joint values in between that miss the pose.
    let away = q + joints![0.0, 0.0, 0.0, 0.0, 1e-3, 0.0];
    assert!(!way::leads(&arm, &target, &q, &[away], window));
}

/// Where the smallest singular value is no less than 1e-6, though not much more, solutions that are farther apart than round-off moves
/// them are isolated: a way that led from one to another would hide that one was lost.
fn no_way_leads_away<const N: usize, S: Subject<N>>(arm: &S) {
    let (sights, mut random, mut asked) = (arm.sights(), Sampler::new(3), 0);
    let window = 64.0 * f64::EPSILON;
    while asked < 6 {
        let q = Joints::from(arm.commanded(sights.row_values(&mut random)));
        let (target, margin) = (arm.fk(&q), singularity::dexterity(arm, &q).margin);
        if !(1e-6..1e-3).contains(&margin) {
            continue;
        }
        for solution in arm.solve(&target).iter() {
            if way::between(arm, &q, &solution.q).amax() > 1e3 * window / margin {
                asked += 1;
                assert!(
                    !way::leads(arm, &target, &q, &[solution.q], window),
                    "{} {q} {}",
                    S::NAME,
                    solution.q
                );
            }
        }
    }
}

#[test]
fn no_way_leads_away_from_joints_that_the_pose_determines() {
    no_way_leads_away(&Tried(robots::Puma560, ByPose));
    no_way_leads_away(&Tried(robots::Stanford, ByPose));
    no_way_leads_away(&Tried(Skew, ByPose));
}

#[test]
fn threads_and_interruptions_change_nothing() {
    let file = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("reliability.json");
    let _ = fs::remove_file(&file);
    let whole = state(&Order { threads: 1, ..order(1_100, 2_200) });
    assert_eq!(whole, state(&Order { threads: 3, ..order(1_100, 2_200) }));
    let whole = state(&order(60, 60));
    let kept = Order { resume: Some(file.clone()), ..order(60, 60) };
    assert_eq!(whole, state(&kept));
    // A part that was cut off is gone on with.
    let mut text: State =
        serde_json::from_str(&fs::read_to_string(&file).expect("a state")).expect("a state");
    text.parts.retain(|name, _| name.starts_with("elbow"));
    fs::write(&file, serde_json::to_string(&text).expect("a state")).expect("written");
    assert_eq!(whole, state(&kept));
    // A run that was done goes on to more.
    let more = Order { poses: 1_100, patterns: 2_200, ..kept.clone() };
    assert_eq!(state(&order(1_100, 2_200)), state(&more));
    // Another run's file is refused, and one of more tries.
    let refused =
        |order: &Order| run(order, &ProgressBar::hidden()).map(|_| ()).map_err(|error| error.to_string());
    let other = Err("the file to resume has seed 7, 1100 poses and 2200 patterns".to_owned());
    assert_eq!(refused(&Order { seed: 8, ..more }), other);
    assert_eq!(refused(&kept), other);
}

/// Whatever else is built, and on whatever machine, a try is the same: those that RELIABILITY.md names are found again.
#[test]
fn the_tries_that_the_report_names_are_found_again() {
    let report = Path::new(env!("CARGO_MANIFEST_DIR")).join("../RELIABILITY.md");
    let report = fs::read_to_string(report).expect("the report");
    let (_, after) = report.split_once("--bin reliability -- --seed ").expect("how to run one again");
    let (seed, _) = after.split_once(' ').expect("a seed");
    let (all, mut count) = (parts(1, 1), 0);
    for line in report.lines().filter(|line| line.contains("| `0x")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, named, arm, _, bits, _] = cells[..] else { panic!("{line}") };
        let (name, index) = named.split_once(':').expect("a part and a number");
        let part = all.iter().find(|part| part.name == name).expect("a part");
        let mut tally = Tally::default();
        part.run(seed.parse().expect("a number"), index.parse().expect("a number"), &mut tally);
        // Every try has a residual; wild bits have none.
        let again = tally.residual.0.first().unwrap_or_else(|| panic!("{line}"));
        assert_eq!(
            (again.arm.as_str(), again.bits.join(" ").as_str()),
            (arm, bits.trim_matches('`')),
            "{line}"
        );
        count += 1;
    }
    assert!(count > 100, "{count}");
}

/// Found by this program: the hand's first joint all but free, and its way past the pole of the shoulder so near that joints 1 and 3
/// swing by half a turn while it moves by hundredths of a degree. Between the ends of such a way halving finds nothing.
#[test]
fn a_way_that_swings_past_the_pole_of_a_sphere_is_traced() {
    let bits = [
        0x3fee_7a19_1762_63b0_u64,
        0xbf50_624d_d2f1_a9fc,
        0x3fb5_1da4_3356_5ea0,
        0xc000_5d4d_0ef8_7ce1,
        0x4003_80b3_a94d_b56c,
        0x3fee_5dbd_2768_f320,
    ];
    let (arm, q) = (Tried(Twisted, ByTool), Joints::from(bits.map(f64::from_bits)));
    let (target, window) = (Twisted.fk(&q), 64.0 * f64::EPSILON);
    let solutions = Twisted.ik(&target);
    assert!(solutions.iter().any(|s| way::leads(&arm, &target, &q, &[s.q], window)), "{solutions}");
    // Off the curve there is nothing to follow.
    let away = q + joints![0.0, 0.0, 0.0, 1e-3, 0.0, 0.0];
    assert!(solutions.iter().all(|s| !way::leads(&arm, &target, &away, &[s.q], window)), "{solutions}");
}

/// Found by this program: in singles the hand's first joint is free but for 12 ε of the pose, which is nothing beside what may be missed,
/// and takes the shoulder, all but straight, with it all round. Nothing draws a way back to where the pose is met best.
#[test]
fn a_way_on_which_one_joint_turns_the_others_is_led_by_it() {
    let bits = [0x4038_924a_u32, 0xb894_bc82, 0x402d_72cc, 0xbfdf_e3ac, 0xbfc9_0fdb, 0xc021_fbc4];
    let q = Joints::from(bits.map(f32::from_bits));
    let (arm, solutions) = (Tried(HandCrossingA, ByTool), HandCrossingA.ik(&HandCrossingA.fk(&q)));
    let wide = |q: &Joints<f32, 6>| q.map(f64::from);
    let (target, window) = (HandCrossingA.fk(&wide(&q)), 64.0 * f64::from(f32::EPSILON));
    let end = solutions.iter().last().map(|s| wide(&s.q)).expect("a solution");
    let leads = |q: &Joints<f64, 6>| way::leads(&arm, &target, q, &[end], window);
    assert!(leads(&wide(&q)), "{solutions}");
    // Off the ring there is nothing to follow.
    assert!(!leads(&(wide(&q) + joints![0.0, 0.0, 0.0, 1e-3, 0.0, 0.0])), "{solutions}");
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

/// The same boundary away from there: stretched for one shoulder, a pose is out of the other's reach, and that is what its slots say.
#[test]
fn a_stretched_elbow_is_the_solution_of_one_shoulder() {
    let arm = robots::Irb2400;
    let Base::<f64>::Elbow(base) = SolveWrist::base(&arm) else { panic!("two links in a plane") };
    assert!(!base.reversed[2]);
    for second in [0.5, 1.0, 1.5, 2.0, 2.5] {
        let q = Joints::from(arm.command([0.3, second, -base.offset[2], 0.5, 0.6, 0.7]));
        let solutions = arm.ik(&arm.fk(&q));
        let empty = solutions.slots().iter().filter(|slot| matches!(slot, Slot::Empty(_))).count();
        assert_eq!(empty, 4, "{solutions}");
    }
}
