//! The same at and around singular sets: poses aimed at where a factor of the determinant vanishes, alone and several together,
//! and everything that is told there besides solutions: families' members and ranges, the nearest reachable pose, steps of a path.

use kin_runtime::{Cause, Closest, Factor, Factored};

use super::*;

/// The poses of the figure of aimed poses.
pub const AIMED: u32 = 4_000;
/// Where a factor is looked for: a joint is moved through a turn in so many steps.
const STEPS: u32 = 24;
/// A factor and the joint, counted from 0, that is moved until it vanishes: in an order in which the later leave the earlier as
/// they are, as far as an arm allows that.
type Aims = [(Factor, usize); 4];
/// Of an arm that carries a wrist …
const CARRIED: Aims = [(Factor::Wrist, 4), (Factor::Elbow, 2), (Factor::Shoulder, 1), (Factor::Base, 1)];
/// … of one with a spherical shoulder …
const CARRYING: Aims = [(Factor::Bend, 1), (Factor::Elbow, 3), (Factor::Hand, 4), (Factor::Base, 4)];
/// … and of a base alone.
const BARE: Aims = [(Factor::Elbow, 2), (Factor::Shoulder, 1), (Factor::Base, 1), (Factor::Base, 2)];

/// Any value, in radians or a few units of length.
fn any<const N: usize>(random: &mut Random) -> Joints<f64, N> {
    kin_runtime::private::joints(core::array::from_fn(|_| random.unit() * core::f64::consts::PI))
}

/// Moves one joint to where the factor changes its sign, and from there by ±10⁻ᵏ or not at all; nothing if it does not change.
fn aim<const N: usize>(
    arm: &impl Factored<N>,
    q: &mut Joints<f64, N>,
    (factor, joint): (Factor, usize),
    random: &mut Random,
) {
    let value = |at: f64, q: &Joints<f64, N>| {
        let mut moved = *q;
        moved[joint] = at;
        arm.factors(&moved).get(factor).map(|value| value > 0.0)
    };
    let (step, start) = (core::f64::consts::TAU / f64::from(STEPS), q[joint]);
    let Some(side) = value(start, q) else { return };
    let crossed = (1..STEPS).find(|k| value(start + f64::from(*k) * step, q) == Some(!side));
    let Some(crossed) = crossed else { return };
    let (mut here, mut there) = (start + f64::from(crossed - 1) * step, start + f64::from(crossed) * step);
    for _ in 0..52 {
        let middle = here + (there - here) * 0.5;
        *(if value(middle, q) == Some(side) { &mut here } else { &mut there }) = middle;
    }
    let (offset, power) = (random.unit(), (random.unit() + 1.0) * 9.0);
    let mut by = if offset < -0.5 { 0.0 } else { offset.signum() };
    for _ in 0..power as u32 {
        by *= 0.1;
    }
    q[joint] = there + by;
}

/// Joint values aimed at one to four of these.
fn aimed<const N: usize>(arm: &impl Factored<N>, aims: &Aims, random: &mut Random) -> Joints<f64, N> {
    let mut q = any(random);
    for aimed in aims {
        if random.unit() < 0.2 {
            aim(arm, &mut q, *aimed, random);
        }
    }
    q
}

impl Hash {
    fn slot<const N: usize, B: Branch>(&mut self, slot: &Slot<f64, N, B>) {
        match slot {
            Slot::Solved(solution) => self.numbers(solution.q.data.0.into_iter().flatten()),
            _ => self.word(6),
        }
    }

    fn step<const N: usize, B: Branch>(&mut self, step: &Step<f64, N, B>) {
        match step {
            Step::Continuous(at) => self.numbers(at.q.data.0.into_iter().flatten()),
            Step::Flip { to, joint, jump, cause, .. } => {
                self.word(7 + u64::from(matches!(cause, Cause::Steep)));
                self.word(*joint as u64);
                self.numbers(to.q.data.0.into_iter().flatten().chain([*jump]));
            }
            Step::Blocked(_) => self.word(9),
        }
    }

    fn closest<const N: usize>(&mut self, closest: &Result<Closest<f64, N>, Reason<f64>>) {
        match closest {
            Ok(closest) => {
                self.numbers(closest.q.data.0.into_iter().flatten().chain([closest.by, closest.turned]));
                self.pose(&closest.pose);
            }
            Err(_) => self.word(10),
        }
    }
}

/// Solutions and, of every eighth pose, what families say: 64 members and more are tried for it.
fn solved<const N: usize, A>(arm: &A, q: &Joints<f64, N>, number: u32, hash: &mut Hash)
where
    A: InverseKinematics<N>,
{
    let pose = forward(arm, q, hash);
    let solutions = arm.ik(&pose);
    hash.solutions(&solutions);
    let families = || solutions.iter().flat_map(|solution| solution.families());
    if number.is_multiple_of(8) {
        let limits = Limits::new([Some((-2.0, 1.5)); N]);
        for family in families().take(2) {
            hash.slot(&family.nearest(arm, &pose, &q.map(|value| value * 0.5)));
            let ranges = family.ranges(arm, &pose, &limits);
            hash.numbers(ranges.iter().flat_map(|(low, high)| [low, high]));
        }
    }
}

/// Steps through the pose, in joint values that move evenly.
fn passed<const N: usize, A>(arm: &A, q: &Joints<f64, N>, random: &mut Random, hash: &mut Hash)
where
    A: InverseKinematics<N>,
{
    let way = any::<N>(random) * 0.02;
    let poses = (-3..=3).map(|k| arm.fk(&(q + way * f64::from(k))));
    for step in arm.track(&(q - way * 4.0), poses) {
        hash.step(&step);
    }
}

/// Six joints, aimed from whichever end the arm is solved; now and then what is dear, a path or the nearest pose.
fn six<A>(arm: &A, aims: &Aims, number: u32, random: &mut Random, hash: &mut Hash)
where
    A: InverseKinematics<6> + Factored<6> + ClosestPose<6>,
{
    let q = aimed(arm, aims, random);
    solved(arm, &q, number, hash);
    match number % 8 {
        1 => passed(arm, &q, random, hash),
        2 => {
            let mut pose = arm.fk(&q);
            pose.translation.vector *= 1.0 + random.unit();
            hash.closest(&arm.closest(&pose));
        }
        _ => {}
    }
}

fn position<A>(arm: &A, random: &mut Random, hash: &mut Hash)
where
    A: PositionInverse<3> + Factored<3> + ClosestPoint<3>,
{
    let q = aimed(arm, &BARE, random);
    let point = Point3 { coords: forward(arm, &q, hash).translation.vector };
    hash.solutions(&arm.ik_position(&point));
    hash.closest(&arm.closest_point(&Point3 { coords: point.coords * 1.5 }));
}

/// The hash of so many aimed poses, each of one of the arms in turn.
pub fn hash_aimed(poses: u32) -> u64 {
    let (mut random, mut hash) = (Random(2), Hash(0));
    for pose in 0..poses {
        let (number, random, hash) = (pose / 8, &mut random, &mut hash);
        match pose % 8 {
            0 => six(&Puma560, &CARRIED, number, random, hash),
            1 => six(&LabArm, &CARRIED, number, random, hash),
            2 => six(&Irb2400, &CARRIED, number, random, hash),
            3 => six(&Stanford, &CARRIED, number, random, hash),
            4 => six(&Oblique, &CARRIED, number, random, hash),
            5 => six(&Gantry, &CARRIED, number, random, hash),
            6 => six(&Ball, &CARRYING, number, random, hash),
            _ => position(&LabRrr, random, hash),
        }
    }
    hash.0
}
