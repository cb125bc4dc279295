//! Operations and parts of polynomials, at random points.

use super::super::ring::{Factor, MAX_VARS};
use super::*;

const ROUNDS: u64 = 300;

fn rounds(test: impl Fn(&World, &mut Random)) {
    for seed in 0..ROUNDS {
        let mut random = Random(seed);
        let world = World::new(&mut random);
        test(&world, &mut random);
        assert!(!world.ring.exhausted());
    }
}

#[test]
fn operations_are_those_of_functions_and_leave_one_form() {
    rounds(|world, random| {
        let (poly, value) = world.tree(4, random);
        assert_eq!(world.at(&poly), value);
        assert_normal(world, &poly);
        assert_eq!(world.at(&poly.neg()), value.negative());
        assert_eq!((poly.len(), poly.is_empty()), (poly.terms.len(), poly.is_zero()));
    });
}

#[test]
fn equal_functions_have_equal_forms() {
    let mut nonzero = 0;
    for seed in 0..ROUNDS {
        let mut random = Random(seed);
        let world = World::new(&mut random);
        let ring = &world.ring;
        let [a, b, c] = [3, 3, 2].map(|depth| world.tree(depth, &mut random).0);
        assert_eq!(ring.mul(&a, &b), ring.mul(&b, &a));
        assert_eq!(ring.mul(&ring.add(&a, &b), &c), ring.add(&ring.mul(&a, &c), &ring.mul(&b, &c)));
        assert_eq!(ring.mul(&ring.mul(&a, &b), &c), ring.mul(&a, &ring.mul(&b, &c)));
        let square = |x: &Poly| ring.mul(x, x);
        assert_eq!(ring.mul(&ring.add(&a, &b), &ring.sub(&a, &b)), ring.sub(&square(&a), &square(&b)));
        assert!(ring.sub(&a, &a).is_zero() && ring.add(&a, &a.neg()).is_zero());
        nonzero += u32::from(!a.is_zero() && !b.is_zero() && !c.is_zero());
    }
    assert!(nonzero > 150, "{nonzero}");
}

#[test]
fn a_cosine_and_its_sine_square_to_one() {
    rounds(|world, _| {
        for &cos in &world.cosines {
            let (c, s) = (world.ring.var(cos), world.ring.var(Var(cos.0 + 1)));
            let sum = world.ring.add(&world.ring.mul(&c, &c), &world.ring.mul(&s, &s));
            assert_eq!(sum.as_unit(), Some(1));
        }
    });
}

/// Derivatives against rates of change, which follow from nothing but the rules for sums and products.
#[test]
fn derivatives_are_rates_of_change() {
    let mut changed = 0;
    for seed in 0..ROUNDS {
        let mut random = Random(seed);
        let mut world = World::new(&mut random);
        let poly = world.tree(4, &mut random).0;
        for cos in world.cosines.clone() {
            let (c, s) = (usize::from(cos.0), usize::from(cos.0) + 1);
            (world.values[c].rate, world.values[s].rate) =
                (world.values[s].negative().value, world.values[c].value);
            let derivative = world.ring.derivative_by_angle(&poly, cos);
            assert_eq!(world.at(&derivative).value, world.at(&poly).rate);
            assert_normal(&world, &derivative);
            changed += u32::from(!derivative.is_zero());
            (world.values[c].rate, world.values[s].rate) = (0, 0);
        }
        for var in world.free.clone() {
            world.values[usize::from(var.0)].rate = 1;
            let derivative = world.ring.derivative(&poly, var);
            assert_eq!(world.at(&derivative).value, world.at(&poly).rate);
            changed += u32::from(!derivative.is_zero());
            world.values[usize::from(var.0)].rate = 0;
        }
    }
    assert!(changed > 300, "{changed}");
}

#[test]
fn parts_by_a_variable_make_the_whole_and_are_free_of_it() {
    let (mut whole, mut refused) = (0, 0);
    for seed in 0..ROUNDS {
        let mut random = Random(seed);
        let world = World::new(&mut random);
        let (ring, poly) = (&world.ring, world.tree(3, &mut random).0);
        for &var in &world.free {
            let highest = poly.terms.iter().map(|(m, _)| m.exponent(var)).max().unwrap_or(0);
            let Some([by, rest]) = ring.split(&poly, var) else {
                assert!(highest > 1);
                refused += 1;
                continue;
            };
            assert!(
                highest <= 1
                    && [&by, &rest].iter().all(|p| p.terms.iter().all(|(m, _)| m.exponent(var) == 0))
            );
            assert_eq!(ring.add(&ring.mul(&by, &ring.var(var)), &rest), poly);
            whole += u32::from(!by.is_zero());
        }
        for &cos in &world.cosines {
            let (cos, sin) = (cos, Var(cos.0 + 1));
            let degree = |m: &super::super::monomial::Monomial| m.exponent(cos) + m.exponent(sin);
            let highest = poly.terms.iter().map(|(m, _)| degree(m)).max().unwrap_or(0);
            let Some([a, b, c]) = ring.split_by_angle(&poly, cos) else {
                assert!(highest > 1);
                refused += 1;
                continue;
            };
            assert!(highest <= 1 && [&a, &b, &c].iter().all(|p| p.terms.iter().all(|(m, _)| degree(m) == 0)));
            let turning = ring.add(&ring.mul(&a, &ring.var(cos)), &ring.mul(&b, &ring.var(sin)));
            assert_eq!(ring.add(&turning, &c), poly);
            whole += u32::from(!a.is_zero() || !b.is_zero());
        }
    }
    assert!(whole > 50 && refused > 50, "{whole} {refused}");
}

#[test]
fn content_is_all_that_terms_have_in_common() {
    let mut common = 0;
    for seed in 0..ROUNDS {
        let mut random = Random(seed);
        let world = World::new(&mut random);
        let ring = &world.ring;
        let (a, b) = (world.tree(2, &mut random).0, world.leaf(&mut random).0);
        let poly = ring.scale(&ring.mul(&a, &b), 6);
        let (content, rest) = ring.split_content(&poly);
        assert_eq!(ring.mul(&content, &rest), poly);
        if poly.is_zero() {
            assert_eq!((content, rest), (Poly::zero(), Poly::integer(1)));
            continue;
        }
        assert_eq!(content.len(), 1);
        assert!(!rest.leads_negative());
        let divides = |d: i64| rest.terms.iter().all(|(_, c)| c % d == 0);
        assert!((2..50).all(|d| !divides(d)));
        for index in 0..ring.vars.len() {
            assert!(rest.terms.iter().any(|(m, _)| m.exponent(Var(index as u8)) == 0));
        }
        common += u32::from(!content.terms[0].0.is_one());
    }
    assert!(common > 100, "{common}");
}

#[test]
fn what_varies_and_its_coefficients_make_the_whole() {
    rounds(|world, random| {
        let (ring, poly) = (&world.ring, world.tree(4, random).0);
        let parts = ring.by_varying(&poly);
        let sum = parts.iter().fold(Poly::zero(), |sum, (key, by)| ring.add(&sum, &ring.mul(key, by)));
        assert_eq!(sum, poly);
        for (index, (key, by)) in parts.iter().enumerate() {
            assert_normal(world, by);
            assert!(ring.is_constant(by) && !by.is_zero() && !parts[..index].iter().any(|(k, _)| k == key));
            assert!(key.as_unit() == Some(1) || !ring.is_constant(key));
        }
        let constant = parts.iter().all(|(key, _)| key.as_unit() == Some(1));
        assert_eq!(ring.is_constant(&poly), constant);
        // The value is that of the part in which nothing varies; here by doubles.
        let (s, c) = 20_f64.to_radians().sin_cos();
        let known = [vec![7.0; PADDING], vec![0.3, -12.0, c, s]].concat();
        let doubles: Vec<f64> =
            known.into_iter().chain(std::iter::repeat(0.0)).take(ring.vars.len()).collect();
        let term = |&(m, c): &(super::super::monomial::Monomial, i64)| {
            let factors =
                doubles.iter().enumerate().flat_map(|(i, x)| (0..m.exponent(Var(i as u8))).map(move |_| x));
            factors.fold(c as f64, |product, x| product * x)
        };
        let (value, plain) = (ring.value(&poly).to_f64(), poly.terms.iter().map(term).sum::<f64>());
        let size: f64 = poly.terms.iter().map(|t| term(t).abs()).sum();
        assert!((value - plain).abs() <= 1e-12 * size, "{value} {plain}");
    });
}

#[test]
fn a_polynomial_vanishes_where_the_values_of_its_constants_cancel() {
    let mut ring = Ring::new();
    let exact = |n, d| Scalar::Exact(Ratio::new(n, d).unwrap());
    let [half, third, sixth] = [2, 3, 6].map(|d| ring.constant(format!("d{d}"), exact(1, d)));
    let root = ring.constant("root", Scalar::Exact(Ratio::integer(2)).sqrt().unwrap());
    let (c, s) = ring.pair("1");
    let [half, third, sixth, root, c, s] = [half, third, sixth, root, c, s].map(|v| ring.var(v));
    // ½ - ⅓ - ⅙ = 0, exactly; √2·√2 - 6·⅓ = 0 by 256 bits.
    let difference = ring.sub(&ring.sub(&half, &third), &sixth);
    let roots = ring.sub(&ring.mul(&root, &root), &ring.scale(&third, 6));
    for zero in [&difference, &roots] {
        assert!(!zero.is_zero() && ring.vanishes(zero));
        let both = ring.add(&ring.mul(zero, &c), &ring.mul(zero, &s));
        assert!(ring.vanishes(&both));
        assert!(
            !ring.vanishes(&ring.add(&both, &sixth)) && !ring.vanishes(&ring.sub(&ring.mul(zero, &c), &s))
        );
    }
    assert!(ring.vanishes(&Poly::zero()) && !ring.vanishes(&ring.sub(&half, &third)));
    // The same values before different functions do not cancel.
    assert!(!ring.vanishes(&ring.sub(&ring.mul(&half, &c), &ring.mul(&half, &s))));
}

/// Past the ratios that fit there are 256 bits.
#[test]
fn values_that_are_no_ratio_are_rounded() {
    let mut ring = Ring::new();
    let of = |num, tail| Ratio::new(num, 100_000_000_000_000_000_000_i128 + tail).unwrap();
    let [a, b] = [of(1, 39), of(3, 129)].map(Scalar::Exact);
    assert!(a.mul(b).is_none() && a.add(b).is_none());
    let [x, y] = [ring.constant("a", a), ring.constant("b", b)].map(|v| ring.var(v));
    let (sum, product) = (ring.value(&ring.add(&x, &y)), ring.value(&ring.mul(&x, &y)));
    assert!((sum.to_f64() / (a.to_f64() + b.to_f64()) - 1.0).abs() < 1e-15);
    assert!((product.to_f64() / (a.to_f64() * b.to_f64()) - 1.0).abs() < 1e-15);
}

#[test]
fn constant_pairs_are_shared_by_angles_of_either_sign() {
    let mut ring = Ring::new();
    let degrees = |d| Angle::from_degrees(Ratio::integer(d));
    for (turn, c, s) in [(0, 1, 0), (90, 0, 1), (180, -1, 0), (270, 0, -1), (-90, 0, -1), (450, 0, 1)] {
        assert_eq!(ring.constant_pair(degrees(turn)), (Poly::integer(c), Poly::integer(s)));
    }
    assert!(ring.vars.is_empty());
    for turn in [20, -35, 20, 35, -20, 140, 35] {
        let (cos, sin) = ring.constant_pair(degrees(turn));
        let (s, c) = (turn as f64).to_radians().sin_cos();
        assert!(
            (ring.value(&cos).to_f64() - c).abs() < 1e-15 && (ring.value(&sin).to_f64() - s).abs() < 1e-15
        );
        assert!(ring.is_constant(&ring.mul(&cos, &sin)));
        let [minus_cos, minus_sin] = [cos.clone(), sin.neg()];
        assert_eq!(ring.constant_pair(degrees(-turn)), (minus_cos, minus_sin));
    }
    let names: Vec<&str> = (0..6).map(|i| ring.name(Var(i))).collect();
    assert_eq!((ring.vars.len(), names), (6, vec!["cφ1", "sφ1", "cφ2", "sφ2", "cφ3", "sφ3"]));
}

#[test]
fn factors_are_told_by_what_they_are() {
    let mut random = Random(1);
    let world = World::new(&mut random);
    let ring = &world.ring;
    let product = |names: &[&str]| {
        let vars = names.iter().map(|n| ring.named(n).unwrap());
        vars.fold(Poly::integer(-3), |product, var| ring.mul(&product, &var))
    };
    let (length, cosine, sine) = (Factor::Length(1), Factor::Cosine(0), Factor::Sine(0));
    let mixed = product(&["a", "height", "c_droop", "height", "s_droop"]);
    assert_eq!(ring.factors_in(&mixed), Some(vec![length, length, cosine, sine]));
    assert_eq!(ring.factors_in(&product(&["c_droop", "c_droop"])), Some(vec![cosine; 2]));
    assert_eq!(ring.params_in(&product(&["b", "height"])), Some(vec![1]));
    assert_eq!((ring.params_in(&mixed), ring.params_in(&Poly::zero())), (None, Some(Vec::new())));
    for other in [&["height", "c1"][..], &["s2"], &["d4", "height"]] {
        assert_eq!(ring.factors_in(&product(other)), None, "{other:?}");
    }
    assert_eq!((ring.param_name(1), ring.param_name(0)), ("height".to_owned(), String::new()));
    assert!(ring.named("nobody").is_none());
    for (names, length) in [(&["a"][..], true), (&["a", "b"], false), (&["cφ1"], false), (&["height"], false)]
    {
        assert_eq!(ring.is_length(&product(names)), length, "{names:?}");
    }
    assert!(!ring.is_length(&ring.add(&product(&["a"]), &product(&["b"]))) && !ring.is_length(&Poly::zero()));
    let shown = ring.add(&product(&["c1", "a"]), &ring.sub(&product(&["s2"]), &Poly::integer(-1)));
    assert_eq!(ring.show(&shown).to_string(), "-3·a·c1 - 3·s2 + 1");
    assert_eq!(ring.show(&ring.sub(&ring.var(world.free[0]), &Poly::integer(2))).to_string(), "d4 - 2");
    assert_eq!(ring.show(&Poly::zero()).to_string(), "0");
}

/// What does not fit must not pass for a result.
#[test]
fn what_cannot_be_represented_exhausts_the_ring() {
    let fresh = || {
        let mut ring = Ring::new();
        let (c, _) = ring.pair("1");
        let x = ring.free("x");
        (ring, c, x)
    };
    // Exponents to 15, whether of a variable or by the way of a sine.
    for (exponent, fits) in [(15, true), (16, false)] {
        let (ring, _, x) = fresh();
        let power = (0..exponent).fold(Poly::integer(1), |power, _| ring.mul(&power, &ring.var(x)));
        assert_eq!((ring.exhausted(), power.is_zero()), (!fits, !fits));
    }
    let (ring, c, _) = fresh();
    let fourteen = (0..14).fold(Poly::integer(1), |power, _| ring.mul(&power, &ring.var(c)));
    let sine = ring.var(Var(c.0 + 1));
    assert!(!ring.exhausted());
    ring.mul(&ring.mul(&fourteen, &sine), &sine);
    assert!(ring.exhausted());
    // Coefficients of 63 bits and a sign.
    let (large, two) = (Poly::integer(i64::MAX), Poly::integer(2));
    let overflows: [&dyn Fn(&Ring) -> Poly; 4] = [
        &|ring| ring.mul(&large, &two),
        &|ring| ring.add(&large, &Poly::integer(1)),
        &|ring| ring.sub(&large.neg(), &Poly::integer(1)),
        &|ring| ring.scale(&large, -2),
    ];
    for overflow in overflows {
        let (ring, _, _) = fresh();
        assert_eq!(ring.sub(&large, &Poly::integer(1)), Poly::integer(i64::MAX - 1));
        assert!(!ring.exhausted());
        overflow(&ring);
        assert!(ring.exhausted());
    }
    // Variables.
    let mut ring = Ring::new();
    for index in 0..MAX_VARS {
        assert_eq!(usize::from(ring.free("x").0), index);
    }
    assert!(!ring.exhausted());
    ring.free("x");
    assert!(ring.exhausted() && ring.mul(&two, &two).is_zero());
    let (ring, _, _) = fresh();
    ring.exhaust();
    assert!(ring.exhausted());
}

#[test]
fn work_is_counted_by_products_of_terms_and_bounded_unless_asked() {
    for (mut ring, bounded) in [(Ring::new(), true), (Ring::unbounded(), false)] {
        let vars: Vec<Var> = (0..110).map(|i| ring.free(format!("x{i}"))).collect();
        let sum = |vars: &[Var]| vars.iter().fold(Poly::zero(), |sum, v| ring.add(&sum, &ring.var(*v)));
        let [left, right] = [sum(&vars[..50]), sum(&vars[50..])];
        assert_eq!(ring.work(), 0);
        let product = ring.mul(&left, &right);
        assert_eq!((ring.work(), product.len()), (3_000, 3_000));
        for count in 2..=1_000 {
            ring.mul(&product, &ring.var(vars[0]));
            assert_eq!(ring.work(), 3_000 * count);
        }
        assert!(!ring.exhausted());
        let next = ring.mul(&Poly::integer(1), &Poly::integer(1));
        assert_eq!((ring.exhausted(), next.is_zero()), (bounded, bounded));
    }
}
