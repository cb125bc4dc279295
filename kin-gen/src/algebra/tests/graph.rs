//! The graph of expressions against doubles: what it simplifies must mean what was written.

use super::super::expr::{Exprs, Id, Node, Term};
use super::super::turn::Turn;
use super::*;
use crate::chain::AngleSum;

/// The values of joints and parameters, and what the graph's nodes are with them.
struct Point {
    joints: [f64; 4],
    params: [f64; 2],
    entries: [f64; 12],
}

impl Point {
    fn new(random: &mut Random) -> Point {
        let mut value = || random.below(1 << 20) as f64 / f64::from(1 << 19) - 1.0;
        Point {
            joints: std::array::from_fn(|_| value()),
            params: std::array::from_fn(|_| value()),
            entries: std::array::from_fn(|_| value()),
        }
    }

    fn angle(&self, turn: &Turn) -> f64 {
        let joints = turn.joints.iter().map(|(c, i)| *c as f64 * self.joints[*i]);
        let params = turn.rest.params.iter().map(|(c, i)| *c as f64 * self.params[*i]);
        joints.chain(params).sum::<f64>() + turn.rest.constant.to_f64()
    }

    fn node(&self, exprs: &Exprs, id: Id) -> f64 {
        let both = |a, b| (self.node(exprs, a), self.node(exprs, b));
        match exprs.node(id) {
            Node::Zero => 0.0,
            Node::One => 1.0,
            Node::Constant(index) => exprs.ring.value(exprs.constant_meaning(index)).to_f64(),
            Node::Param(index) => self.params[index],
            Node::Slide(joint) => self.joints[joint],
            Node::Entry(index) => self.entries[index],
            Node::Cos(turn) => self.angle(exprs.turn(turn)).sin_cos().1,
            Node::Sin(turn) => self.angle(exprs.turn(turn)).sin_cos().0,
            Node::Add(a, b) => both(a, b).0 + both(a, b).1,
            Node::Sub(a, b) => both(a, b).0 - both(a, b).1,
            Node::Mul(a, b) => both(a, b).0 * both(a, b).1,
        }
    }

    fn at(&self, exprs: &Exprs, term: Term) -> f64 {
        let value = self.node(exprs, term.id);
        if term.negative { -value } else { value }
    }
}

fn degrees(degrees: i64) -> Angle {
    Angle::from_degrees(Ratio::integer(degrees))
}

fn turn(joints: &[(i64, usize)], params: &[(i64, usize)], constant: Angle) -> Turn {
    Turn { joints: joints.to_vec(), rest: AngleSum { constant, params: params.to_vec() } }
}

/// A turn of small coefficients, with a constant that is often a quarter turn.
fn some_turn(random: &mut Random) -> Turn {
    let mut coefficients = |count: usize| -> Vec<(i64, usize)> {
        let drawn: Vec<_> = (0..count).map(|i| ([0, 0, 0, 1, -1, 2, -2][random.below(7)], i)).collect();
        drawn.into_iter().filter(|(c, _)| *c != 0).collect()
    };
    let (joints, params) = (coefficients(3), coefficients(2));
    let constant = [0, 90, 180, 270, -90, 30, -75, 20][random.below(8)];
    turn(&joints, &params, degrees(constant))
}

fn leaf(exprs: &mut Exprs, point: &Point, random: &mut Random) -> (Term, f64) {
    let ratio = [(1, 1), (-1, 1), (0, 1), (2, 1), (-7, 2), (7, 2)][random.below(6)];
    match random.below(7) {
        0 => {
            let meaning = Poly::integer(ratio.0);
            (exprs.constant(meaning), ratio.0 as f64)
        }
        1 => {
            let name = ["a", "b"][random.below(2)];
            let meaning = exprs.ring.named(name).unwrap();
            let value = exprs.ring.value(&meaning).to_f64();
            (exprs.constant(meaning), value)
        }
        2 => (exprs.param(1), point.params[1]),
        3 => (exprs.slide(3), point.joints[3]),
        4 => (exprs.entry(7), point.entries[7]),
        _ => {
            let turn = some_turn(random);
            let (s, c) = point.angle(&turn).sin_cos();
            let (cos, sin) = exprs.cos_sin(&turn);
            if random.below(2) == 0 { (cos, c) } else { (sin, s) }
        }
    }
}

fn tree(exprs: &mut Exprs, point: &Point, depth: usize, random: &mut Random) -> (Term, f64) {
    if depth == 0 {
        return leaf(exprs, point, random);
    }
    let (a, x) = tree(exprs, point, depth - 1, random);
    let (b, y) = tree(exprs, point, depth - 1, random);
    match random.below(4) {
        0 => (exprs.add(a, b), x + y),
        1 => (exprs.sub(a, b), x - y),
        2 => (exprs.mul(a, b), x * y),
        _ => {
            let product = exprs.mul(a, exprs.neg(b));
            (exprs.sub(product, a), -x * y - x)
        }
    }
}

fn graph(random: &mut Random) -> Exprs {
    Exprs::new(World::new(random).ring)
}

#[test]
fn what_is_built_means_what_was_written() {
    let mut kinds = std::collections::BTreeSet::new();
    for seed in 0..400 {
        let mut random = Random(seed);
        let mut exprs = graph(&mut random);
        let point = Point::new(&mut random);
        let (term, value) = tree(&mut exprs, &point, 4, &mut random);
        let found = point.at(&exprs, term);
        assert!((found - value).abs() <= 1e-9 * (1.0 + value.abs()), "{seed}: {found} {value}");
        // Operands are older, and every node stands once.
        for (index, node) in exprs.nodes().iter().enumerate() {
            if let Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) = node {
                assert!(a <= b && (b.0 as usize) < index);
            }
            assert!(!exprs.nodes()[..index].contains(node));
            kinds.insert(format!("{node:?}").split('(').next().unwrap().to_owned());
        }
    }
    assert_eq!(kinds.len(), 11, "{kinds:?}");
}

/// Zero, one and signs cost nothing; the same operation is the same node, whichever way round.
#[test]
fn what_need_not_be_computed_is_no_node() {
    let mut random = Random(3);
    let mut exprs = graph(&mut random);
    let (x, y) = (exprs.slide(0), exprs.entry(1));
    let (minus_x, minus_y) = (exprs.neg(x), exprs.neg(y));
    let mark = exprs.mark();
    assert_eq!((exprs.add(x, Term::ZERO), exprs.add(Term::ZERO, y)), (x, y));
    assert_eq!((exprs.mul(x, Term::ONE), exprs.mul(Term::ONE, y)), (x, y));
    assert_eq!(exprs.mul(minus_x, exprs.neg(Term::ONE)), x);
    assert_eq!((exprs.mul(x, Term::ZERO), exprs.mul(Term::ZERO, x)), (Term::ZERO, Term::ZERO));
    assert_eq!(
        (exprs.sub(x, x), exprs.add(x, minus_x), exprs.neg(Term::ZERO)),
        (Term::ZERO, Term::ZERO, Term::ZERO)
    );
    assert_eq!(exprs.work_since(mark), 0);
    let (sum, difference, product) = (exprs.add(x, y), exprs.sub(x, y), exprs.mul(x, y));
    assert_eq!(exprs.work_since(mark), 3);
    assert_eq!((exprs.add(y, x), exprs.add(minus_x, minus_y)), (sum, exprs.neg(sum)));
    assert_eq!((exprs.sub(y, x), exprs.add(minus_x, y)), (exprs.neg(difference), exprs.neg(difference)));
    assert_eq!((exprs.mul(y, minus_x), exprs.mul(minus_x, minus_y)), (exprs.neg(product), product));
    assert_eq!(exprs.work_since(mark), 3);
    let twice = exprs.add(x, x);
    assert_eq!((exprs.work_since(mark), exprs.nodes().len()), (4, 8));
    assert_eq!(exprs.node(twice.id), Node::Add(x.id, x.id));
}

#[test]
fn constants_fold_into_their_meaning() {
    let mut random = Random(3);
    let mut exprs = graph(&mut random);
    let [a, b] = ["a", "b"].map(|name| exprs.ring.named(name).unwrap());
    let (ta, tb) = (exprs.constant(a.clone()), exprs.constant(b.clone()));
    for (term, meaning) in [
        (exprs.add(ta, tb), exprs.ring.add(&a, &b)),
        (exprs.sub(tb, ta), exprs.ring.sub(&b, &a)),
        (exprs.mul(exprs.neg(ta), tb), exprs.ring.mul(&a.neg(), &b)),
    ] {
        assert_eq!(exprs.as_constant(term), Some(meaning));
    }
    assert_eq!(exprs.as_constant(Term::ONE), Some(Poly::integer(1)));
    assert_eq!(exprs.as_constant(exprs.neg(Term::ONE)), Some(Poly::integer(-1)));
    assert_eq!(exprs.as_constant(Term::ZERO), Some(Poly::zero()));
    let slide = exprs.slide(0);
    assert_eq!(exprs.as_constant(slide), None);
    assert_eq!((exprs.constant(a.neg()), exprs.constant(a.clone())), (exprs.neg(ta), ta));
    // 40·a + b is 0: 40·3/10 - 12. Neither alone is.
    let cancelled = exprs.ring.add(&exprs.ring.scale(&a, 40), &b);
    assert_eq!(exprs.constant(cancelled), Term::ZERO);
}

#[test]
fn polynomials_of_constants_and_parameters_keep_their_value() {
    let mut random = Random(3);
    let mut exprs = graph(&mut random);
    let point = Point::new(&mut random);
    let ring = exprs.ring.clone();
    let named = |name: &str| ring.named(name).unwrap();
    let (a, b, height) = (named("a"), named("b"), named("height"));
    let (cos, sin) = (named("c_droop"), named("s_droop"));
    let square = ring.mul(&height, &height);
    let meaning = ring.add(&ring.mul(&a, &ring.mul(&square, &cos)), &ring.sub(&ring.mul(&b, &sin), &height));
    let term = exprs.polynomial(&ring.add(&meaning, &b));
    let (h, (s, c)) = (point.params[1], point.params[0].sin_cos());
    let value = 0.3 * h * h * c - 12.0 * s - h - 12.0;
    assert!((point.at(&exprs, term) - value).abs() < 1e-12);
    assert_eq!(exprs.polynomial(&Poly::zero()), Term::ZERO);
}

/// All that is rolled back; the ring keeps its constants and its count of work.
fn nodes(exprs: &Exprs) -> String {
    let text = format!("{exprs:?}");
    text[text.find(" nodes: [").expect("the first field after the ring")..].to_owned()
}

#[test]
fn a_graph_rolled_back_is_what_it_was() {
    for seed in 0..50 {
        let mut random = Random(seed);
        let mut exprs = graph(&mut random);
        let point = Point::new(&mut random);
        tree(&mut exprs, &point, 4, &mut random);
        let (before, mark) = (nodes(&exprs), exprs.mark());
        let (term, _) = tree(&mut exprs, &point, 4, &mut random);
        exprs.label(term, || "later".to_owned());
        assert!(nodes(&exprs) != before);
        exprs.roll_back(mark);
        assert!(nodes(&exprs) == before);
        // And goes on as if nothing had been.
        let mut untouched = exprs.clone();
        tree(&mut exprs, &point, 3, &mut random);
        exprs.roll_back(mark);
        tree(&mut exprs, &point, 3, &mut Random(seed + 1000));
        tree(&mut untouched, &point, 3, &mut Random(seed + 1000));
        assert!(nodes(&exprs) == nodes(&untouched));
    }
}

#[test]
fn only_what_is_computed_has_a_name_and_the_first_stays() {
    let mut random = Random(3);
    let mut exprs = graph(&mut random);
    let (x, y) = (exprs.slide(0), exprs.entry(1));
    let (sum, product) = (exprs.sub(y, x), exprs.mul(x, y));
    assert!(sum.negative);
    exprs.label(x, || "x".to_owned());
    exprs.label(sum, || "first".to_owned());
    exprs.label(exprs.neg(sum), || "second".to_owned());
    exprs.label_up_to_sign(product, || "product".to_owned());
    exprs.label_up_to_sign(sum, || "third".to_owned());
    exprs.label_up_to_sign(y, || "y".to_owned());
    assert_eq!((exprs.label_of(x.id), exprs.label_of(y.id)), (None, None));
    assert_eq!(exprs.label_of(sum.id), Some(("first", Some(true))));
    assert_eq!(exprs.label_of(product.id), Some(("product", None)));
}

#[test]
fn turns_add_as_angles_do() {
    let (mut constant, mut negative) = (0, 0);
    for seed in 0..500 {
        let mut random = Random(seed);
        let point = Point::new(&mut random);
        let (a, b) = (some_turn(&mut random), some_turn(&mut random));
        let factor = random.below(7) as i64 - 3;
        let sum = a.plus(&b, factor).unwrap();
        let angle = point.angle(&a) + factor as f64 * point.angle(&b);
        assert!((point.angle(&sum) - angle).abs() < 1e-12);
        assert!(sum.joints.windows(2).chain(sum.rest.params.windows(2)).all(|p| p[0].1 < p[1].1));
        assert!(sum.joints.iter().chain(&sum.rest.params).all(|(c, _)| *c != 0));
        let back = a.plus(&b, 1).unwrap().plus(&a, -1).unwrap();
        assert_eq!((back.joints, back.rest.params), (b.joints.clone(), b.rest.params.clone()));
        let fixed = a.joints.is_empty() && a.rest.params.is_empty();
        assert_eq!(a.is_constant(), fixed);
        constant += u32::from(fixed);
        // Of two opposite turns one leads with a negative coefficient; of no turn, neither.
        let opposite = Turn::default().plus(&a, -1).unwrap();
        let none = fixed && a.rest.constant.is_zero();
        assert_eq!(a.leads_negative() != opposite.leads_negative(), !none);
        negative += u32::from(a.leads_negative());
    }
    assert!(constant > 0 && (100..400).contains(&negative), "{constant} {negative}");
    assert!(!Turn::default().leads_negative());
    let quarter = Turn::constant(degrees(90));
    assert_eq!((quarter.is_constant(), quarter.rest.constant), (true, degrees(90)));
    assert!(
        turn(&[], &[(-1, 0)], degrees(30)).leads_negative() && turn(&[], &[], degrees(-30)).leads_negative()
    );
    assert!(turn(&[(-1, 2)], &[(1, 0)], degrees(30)).leads_negative());
    let huge = turn(&[(i64::MAX, 0)], &[], Angle::zero());
    assert!(huge.plus(&huge, 1).is_none() && huge.plus(&huge, 2).is_none() && huge.plus(&huge, -1).is_some());
}
