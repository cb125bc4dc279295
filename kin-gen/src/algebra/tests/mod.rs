//! The algebra against functions: what it computes with symbols must hold at every point.
//!
//! A point gives each variable a residue modulo a prime, to each pair a point of the circle c² + s² = 1. Residues are exact,
//! and two different functions of the degrees met here agree at a random point with a chance of 2⁻⁵⁵ or so.

mod graph;
mod ring;
mod shape;

use super::monomial::Var;
use super::ring::{Poly, Ring};
use crate::number::{Angle, Ratio, Scalar};

/// The Mersenne prime 2⁶¹ - 1.
const PRIME: u64 = (1 << 61) - 1;

/// A residue, with its rate of change along some curve through the point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Residue {
    value: u64,
    rate: u64,
}

fn times(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn plus(a: u64, b: u64) -> u64 {
    (a + b) % PRIME
}

impl Residue {
    fn fixed(value: u64) -> Residue {
        Residue { value: value % PRIME, rate: 0 }
    }

    fn of(value: i64) -> Residue {
        Residue::fixed(value.rem_euclid(PRIME as i64) as u64)
    }

    fn plus(self, other: Residue) -> Residue {
        Residue { value: plus(self.value, other.value), rate: plus(self.rate, other.rate) }
    }

    fn times(self, other: Residue) -> Residue {
        let rate = plus(times(self.value, other.rate), times(self.rate, other.value));
        Residue { value: times(self.value, other.value), rate }
    }

    fn negative(self) -> Residue {
        self.times(Residue::of(-1))
    }

    fn inverse(self) -> Residue {
        // By Fermat's little theorem; for what does not change.
        let (mut power, mut result, mut left) = (self.value, 1, PRIME - 2);
        while left > 0 {
            if left % 2 == 1 {
                result = times(result, power);
            }
            power = times(power, power);
            left /= 2;
        }
        Residue::fixed(result)
    }
}

/// A linear congruential generator (D. Knuth, MMIX).
pub(super) struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 3
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.bits() >> 20) % count as u64) as usize
    }
}

/// A ring with variables of every kind, and a point.
pub(super) struct World {
    ring: Ring,
    values: Vec<Residue>,
    /// Cosines of what turns: the next variable is the sine.
    cosines: Vec<Var>,
    /// The variables that vary and are in no pair.
    free: Vec<Var>,
}

/// How many variables there are before those that are asked for: two words of a monomial are then in use.
const PADDING: usize = 27;

impl World {
    fn new(random: &mut Random) -> World {
        let mut ring = Ring::unbounded();
        for index in 0..PADDING {
            ring.constant(format!("pad{index}"), Scalar::Exact(Ratio::integer(7)));
        }
        let length = |n: i128, d: i128| Scalar::Exact(Ratio::new(n, d).unwrap());
        ring.constant("a", length(3, 10));
        ring.constant("b", length(-12, 1));
        ring.constant_pair(Angle::from_degrees(Ratio::integer(20)));
        let tilt = Var(PADDING as u8 + 2);
        let (c1, _) = ring.pair("1");
        let slide = ring.free("d4");
        let height = ring.param("height", 1);
        let (c2, _) = ring.pair("2");
        let (droop, _) = ring.param_pair("droop", 0);
        let mut world = World {
            ring,
            values: (0..PADDING).map(|_| Residue::fixed(7)).collect(),
            cosines: vec![c1, c2, droop],
            free: vec![slide, height],
        };
        for index in PADDING..world.ring.vars.len() {
            let var = Var(index as u8);
            if world.cosines.contains(&var) || var == tilt {
                // The circle from its point (-1, 0): t gives (1 - t²)/(1 + t²) and 2t/(1 + t²).
                let t = Residue::fixed(random.bits());
                let square = t.times(t);
                let below = Residue::of(1).plus(square).inverse();
                world.values.push(Residue::of(1).plus(square.negative()).times(below));
                world.values.push(t.plus(t).times(below));
            } else if world.values.len() == index {
                world.values.push(Residue::fixed(random.bits()));
            }
        }
        world
    }

    /// What a polynomial is here, from its terms alone.
    fn at(&self, poly: &Poly) -> Residue {
        poly.terms.iter().fold(Residue::of(0), |sum, &(monomial, coefficient)| {
            let powers = self.values.iter().enumerate().map(|(index, value)| {
                (0..monomial.exponent(Var(index as u8))).fold(Residue::of(1), |power, _| power.times(*value))
            });
            sum.plus(powers.fold(Residue::of(coefficient), Residue::times))
        })
    }

    /// The polynomial of one variable, and what it is here.
    fn leaf(&self, random: &mut Random) -> (Poly, Residue) {
        match random.below(7) {
            0 => {
                let value = random.below(11) as i64 - 5;
                (Poly::integer(value), Residue::of(value))
            }
            _ => {
                let index = PADDING + random.below(self.values.len() - PADDING);
                (self.ring.var(Var(index as u8)), self.values[index])
            }
        }
    }

    /// A sum of products made at random, and what it is here without any ring.
    fn tree(&self, depth: usize, random: &mut Random) -> (Poly, Residue) {
        if depth == 0 || random.below(8) == 0 {
            return self.leaf(random);
        }
        let (a, x) = self.tree(depth - 1, random);
        let (b, y) = self.tree(depth - 1, random);
        match random.below(5) {
            0 => (self.ring.add(&a, &b), x.plus(y)),
            1 => (self.ring.sub(&a, &b), x.plus(y.negative())),
            2 => {
                let factor = random.below(9) as i64 - 4;
                let (scaled, value) = (self.ring.scale(&a, factor), x.times(Residue::of(factor)));
                (self.ring.sub(&b.neg(), &scaled), y.plus(value).negative())
            }
            _ => (self.ring.mul(&a, &b), x.times(y)),
        }
    }
}

/// In descending order, without zeros, no sine squared: the one form that a function has.
#[track_caller]
fn assert_normal(world: &World, poly: &Poly) {
    assert!(poly.terms.windows(2).all(|pair| pair[0].0 > pair[1].0), "{:?}", poly.terms);
    assert!(poly.terms.iter().all(|(_, c)| *c != 0));
    for cosine in &world.cosines {
        assert!(poly.terms.iter().all(|(m, _)| m.exponent(Var(cosine.0 + 1)) <= 1));
    }
}
