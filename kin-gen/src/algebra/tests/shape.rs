//! Monomials against lists of exponents, vectors against integers.

use super::super::monomial::Monomial;
use super::super::ring::MAX_VARS;
use super::super::vector::{self, Algebra, M3, V3};
use super::*;

/// Exponents of all variables, most of them 0.
fn exponents(random: &mut Random, most: usize) -> Vec<u32> {
    (0..MAX_VARS).map(|_| if random.below(3) == 0 { random.below(most + 1) as u32 } else { 0 }).collect()
}

fn monomial(exponents: &[u32]) -> Monomial {
    exponents.iter().enumerate().fold(Monomial::default(), |product, (index, exponent)| {
        product.times(Monomial::of(Var(index as u8), u128::from(*exponent))).expect("no exponent is above 15")
    })
}

fn listed(monomial: Monomial) -> Vec<u32> {
    (0..MAX_VARS).map(|index| monomial.exponent(Var(index as u8))).collect()
}

#[test]
fn monomials_are_lists_of_exponents() {
    for seed in 0..300 {
        let mut random = Random(seed);
        let (a, b) = (exponents(&mut random, 7), exponents(&mut random, 8));
        let (x, y) = (monomial(&a), monomial(&b));
        let zip = |op: fn(u32, u32) -> u32| a.iter().zip(&b).map(|(a, b)| op(*a, *b)).collect::<Vec<_>>();
        assert_eq!((listed(x), listed(y)), (a.clone(), b.clone()));
        let product = x.times(y).unwrap();
        assert_eq!(listed(product), zip(|a, b| a + b));
        assert_eq!((product.without(y), product.without(x)), (x, y));
        assert_eq!((listed(x.masked(y)), listed(x.united(y))), (zip(|a, b| a & b), zip(|a, b| a | b)));
        assert_eq!(x.cmp(&y), a.cmp(&b));
        let first = a.iter().position(|e| *e > 0);
        assert_eq!((x.first(), x.is_one()), (first.map(|i| Var(i as u8)), first.is_none()));
        // One exponent that does not fit is enough, wherever it stands.
        let place = random.below(MAX_VARS);
        let room = 15 - listed(product)[place];
        let more = |exponent: u32| product.times(Monomial::of(Var(place as u8), u128::from(exponent)));
        assert!(more(room).is_some_and(|full| full.exponent(Var(place as u8)) == 15));
        assert!((room + 1..16).all(|exponent| more(exponent).is_none()));
    }
    assert!(Monomial::default().is_one() && Monomial::default().first().is_none());
}

#[test]
fn units_are_told_by_their_value() {
    let mut ring = Ring::new();
    let x = ring.free("x");
    for (poly, unit) in [
        (Poly::zero(), Some(0)),
        (Poly::integer(1), Some(1)),
        (Poly::integer(-1), Some(-1)),
        (Poly::integer(2), None),
        (ring.var(x), None),
        (ring.add(&ring.var(x), &Poly::integer(1)), None),
    ] {
        assert_eq!(poly.as_unit(), unit);
    }
    assert!(
        ring.var(x).neg().leads_negative() && !ring.var(x).leads_negative() && !Poly::zero().leads_negative()
    );
    assert_eq!((ring.name(x), ring.name(Var(1))), ("x", ""));
}

/// Integers, in which every formula can be written out.
struct Integers;

impl Algebra for Integers {
    type Value = i64;

    fn zero(&self) -> i64 {
        0
    }

    fn one(&self) -> i64 {
        1
    }

    fn plus(&mut self, a: &i64, b: &i64) -> i64 {
        a + b
    }

    fn times(&mut self, a: &i64, b: &i64) -> i64 {
        a * b
    }

    fn minus(&mut self, a: &i64) -> i64 {
        -a
    }
}

#[test]
fn vectors_and_matrices_are_those_of_geometry() {
    let on = &mut Integers;
    for seed in 0..100 {
        let mut random = Random(seed);
        let mut number = || random.below(19) as i64 - 9;
        let [a, b]: [V3<i64>; 2] = std::array::from_fn(|_| std::array::from_fn(|_| number()));
        let [m, n]: [M3<i64>; 2] =
            std::array::from_fn(|_| std::array::from_fn(|_| std::array::from_fn(|_| number())));
        let ([a0, a1, a2], [b0, b1, b2]) = (a, b);
        assert_eq!(vector::add(on, &a, &b), [a0 + b0, a1 + b1, a2 + b2]);
        assert_eq!(vector::sub(on, &a, &b), [a0 - b0, a1 - b1, a2 - b2]);
        assert_eq!(vector::negate(on, &a), [-a0, -a1, -a2]);
        assert_eq!(vector::scale(on, &5, &a), [5 * a0, 5 * a1, 5 * a2]);
        assert_eq!(vector::dot(on, &a, &b), a0 * b0 + a1 * b1 + a2 * b2);
        assert_eq!(vector::cross(on, &a, &b), [a1 * b2 - a2 * b1, a2 * b0 - a0 * b2, a0 * b1 - a1 * b0]);
        // (M·N)·a = M·(N·a); columns are what unit vectors become; Mᵀ by its definition.
        let product = vector::product(on, &m, &n);
        let inner = vector::apply(on, &n, &a);
        assert_eq!(vector::apply(on, &product, &a), vector::apply(on, &m, &inner));
        for axis in 0..3 {
            let unit = vector::unit(on, axis);
            assert_eq!(vector::apply(on, &m, &unit), vector::column(&m, axis));
            assert_eq!(vector::transpose(&m)[axis], vector::column(&m, axis));
        }
        let identity = vector::identity(on);
        assert_eq!((vector::product(on, &identity, &m), vector::apply(on, &identity, &a)), (m, a));
        let [x, y, z] = [0, 1, 2].map(|axis| vector::column(&m, axis));
        assert_eq!(vector::from_columns(&x, &y, &z), m);
        assert_eq!((vector::origin(on), vector::apply(on, &m, &[1, 0, 0])), ([0; 3], x));
    }
    assert_eq!([0, 1, 2].map(|axis| vector::unit(on, axis)), [[1, 0, 0], [0, 1, 0], [0, 0, 1]]);
}

/// About each axis, by the right hand: a quarter turn takes the next axis to the one after it.
#[test]
fn rotations_are_right_handed() {
    let on = &mut Integers;
    for axis in 0..3 {
        let [here, next, last] = [0, 1, 2].map(|i| vector::unit(on, (axis + i) % 3));
        let (cos, sin) = (3, 4);
        let m = vector::rotation(on, axis, &cos, &sin);
        assert_eq!(vector::apply(on, &m, &here), here);
        let turned = |u: &V3<i64>, v: &V3<i64>, s: i64| [0, 1, 2].map(|i| cos * u[i] + s * v[i]);
        assert_eq!(vector::apply(on, &m, &next), turned(&next, &last, sin));
        assert_eq!(vector::apply(on, &m, &last), turned(&last, &next, -sin));
    }
}

/// The same through polynomials and through expressions, whose operations are others.
#[test]
fn domains_are_what_they_say() {
    let mut random = Random(9);
    let mut world = World::new(&mut random);
    let (a, x) = world.tree(3, &mut random);
    let (b, y) = world.tree(3, &mut random);
    let ring = &mut world.ring;
    assert_eq!((ring.zero(), ring.one()), (Poly::zero(), Poly::integer(1)));
    let (sum, product, negative) = (ring.plus(&a, &b), ring.times(&a, &b), ring.minus(&a));
    assert_eq!((world.at(&sum), world.at(&product)), (x.plus(y), x.times(y)));
    assert_eq!(world.at(&negative), x.negative());
    let mut exprs = super::super::expr::Exprs::new(Ring::new());
    let (s, e) = (exprs.slide(0), exprs.entry(0));
    let built = (exprs.plus(&s, &e), exprs.times(&s, &e), exprs.minus(&s));
    assert_eq!(built, (exprs.add(s, e), exprs.mul(s, e), exprs.neg(s)));
    assert_eq!((exprs.zero(), exprs.one()), (super::super::expr::Term::ZERO, super::super::expr::Term::ONE));
}
