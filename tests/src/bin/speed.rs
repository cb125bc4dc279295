//! `cargo run --release -p tests --bin speed`: what one forward kinematics costs, by where its sines come from.
//!
//! Irb2400 over distinct random configurations, all ways interleaved in one run; the median of the rounds counts. Ratios
//! say more than nanoseconds: machines have moods.

use std::hint::black_box;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::time::Instant;

use kin_runtime::prelude::*;
use kin_runtime::{Lanes, math};
use robots::Irb2400;
use tests::sample::Sampler;

/// Distinct configurations: so many that no branch predictor learns them by heart.
const COUNT: usize = 16_384;
/// Rounds; the median counts.
const ROUNDS: usize = 41;

/// A double whose sine and cosine come one at a time, from elsewhere.
macro_rules! number {
    ($Number:ident, $sin_cos:expr) => {
        #[derive(Clone, Copy, PartialEq, Debug)]
        struct $Number(f64);
        number!($Number, Add add +, Sub sub -, Mul mul *, Div div /);
        impl Neg for $Number {
            type Output = Self;
            fn neg(self) -> Self {
                $Number(-self.0)
            }
        }
        impl Real for $Number {
            fn lit(x: f64) -> Self {
                $Number(x)
            }
            fn sqrt(self) -> Self {
                $Number(self.0.sqrt())
            }
            fn sin_cos(self) -> (Self, Self) {
                let (s, c) = $sin_cos(self.0);
                ($Number(s), $Number(c))
            }
        }
    };
    ($Number:ident, $($operation:ident $method:ident $sign:tt),*) => {$(
        impl $operation for $Number {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                $Number(self.0 $sign other.0)
            }
        }
    )*};
}

number!(Std, f64::sin_cos);
number!(Libm, libm::sincos);
number!(OneByOne, math::sin_cos::<f64>);
number!(Free, |x: f64| (x, 1.0 - x));

/// All configurations in this kind of number, once each.
fn once<T: Real>(configurations: &[Joints<T, 6>]) {
    for q in configurations {
        black_box(&Irb2400.fk(black_box(q)));
    }
}

/// The median time of one configuration in nanoseconds, for each way, rounds of all ways in turn.
fn medians<const W: usize>(ways: &mut [(&str, &mut dyn FnMut()); W]) -> [f64; W] {
    let mut times = [[0.0; ROUNDS]; W];
    for round in 0..ROUNDS {
        for ((_, way), times) in ways.iter_mut().zip(&mut times) {
            let start = Instant::now();
            way();
            times[round] = start.elapsed().as_secs_f64() * 1e9 / COUNT as f64;
        }
    }
    times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2]
    })
}

/// Bundles of configurations as joint vectors of lanes.
fn bundles<const L: usize>(configurations: &[[f64; 6]]) -> Vec<Joints<Lanes<f64, L>, 6>> {
    let bundle = |chunk: &[[f64; 6]]| -> [Lanes<f64, L>; 6] {
        std::array::from_fn(|j| Lanes(std::array::from_fn(|lane| chunk[lane][j])))
    };
    configurations.chunks_exact(L).map(|chunk| Joints::from(bundle(chunk))).collect()
}

fn main() {
    let mut sampler = Sampler::new(17);
    let q: Vec<[f64; 6]> = (0..COUNT).map(|_| sampler.angles()).collect();
    macro_rules! list {
        ($Number:ident) => {
            q.iter().map(|q| Joints::from(q.map($Number))).collect::<Vec<Joints<$Number, 6>>>()
        };
    }
    let (std, libm, apart, free) = (list!(Std), list!(Libm), list!(OneByOne), list!(Free));
    let together: Vec<Joints<f64, 6>> = q.iter().map(|q| Joints::from(*q)).collect();
    let (two, four, eight) = (bundles::<2>(&q), bundles::<4>(&q), bundles::<8>(&q));
    let mut ways: [(&str, &mut dyn FnMut()); 8] = [
        ("std", &mut || once(&std)),
        ("libm", &mut || once(&libm)),
        ("kernel, one turn at a time", &mut || once(&apart)),
        ("kernel, all turns of a program", &mut || once(&together)),
        ("kernel, Lanes<2>", &mut || once(&two)),
        ("kernel, Lanes<4>", &mut || once(&four)),
        ("kernel, Lanes<8>", &mut || once(&eight)),
        ("no sines: arithmetic alone", &mut || once(&free)),
    ];
    let times = medians(&mut ways);
    println!("Irb2400.fk over {COUNT} random configurations, median of {ROUNDS} rounds");
    for ((name, _), time) in ways.iter().zip(times) {
        println!("{name:<32}{time:>8.1} ns{:>8.2} × libm", times[1] / time);
    }
}
