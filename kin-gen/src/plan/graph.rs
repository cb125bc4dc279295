//! Values, and the ways in which each can be computed.
//!
//! A value is a polynomial up to sign: what has the same normal form is the same value, however it was found. A way is
//! one multiplication or one addition of two other values. The cost of a set of values that is closed under the ways
//! chosen for it is therefore its size, leaves apart.

use std::collections::BTreeMap;

use crate::algebra::ring::{Poly, Ring};

/// A value: an index into the graph.
pub type Id = usize;

/// A value with a sign.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Signed {
    /// The value.
    pub id: Id,
    /// Whether its negative is meant.
    pub negative: bool,
}

/// What a way does with its two operands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    /// The product.
    Mul,
    /// The sum.
    Add,
    /// The difference.
    Sub,
}

/// One way to compute a value, up to its sign.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Way {
    /// What is done.
    pub kind: Kind,
    /// With which values.
    pub operands: [Id; 2],
    /// Whether that gives the negative of the value.
    pub negative: bool,
    /// Whether it completes a rotation by a cofactor: at most one of these may lie on any path.
    pub cofactor: bool,
}

/// What identifies a value.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Key {
    /// A polynomial whose leading coefficient is positive.
    Poly(Poly),
    /// A product of two values that is too large to be multiplied out.
    Product(Id, Id),
}

/// Most term products for a product to be multiplied out.
const LARGEST_PRODUCT: usize = 256;

/// Values and ways.
#[derive(Debug)]
pub struct Graph {
    /// The ring of the values.
    pub ring: Ring,
    keys: BTreeMap<Key, Id>,
    polys: Vec<Option<Poly>>,
    /// The ways of each value; a leaf has none.
    pub ways: Vec<Vec<Way>>,
    /// Which values are leaves.
    pub leaf: Vec<bool>,
    /// Ways that belong together: those of the components of one vector.
    pub bundles: Vec<Vec<(Id, Way)>>,
    open: [Vec<(Id, Way)>; 3],
    order: Option<usize>,
    /// What each value is called, if anything.
    pub names: Vec<Option<(String, bool)>>,
}

/// The value 0.
pub const ZERO: Id = 0;
/// The value 1.
pub const ONE: Id = 1;

impl Graph {
    /// A graph with 0 and 1.
    pub fn new(ring: Ring) -> Graph {
        let mut graph = Graph {
            ring,
            keys: BTreeMap::new(),
            polys: Vec::new(),
            ways: Vec::new(),
            leaf: Vec::new(),
            bundles: Vec::new(),
            open: Default::default(),
            order: None,
            names: Vec::new(),
        };
        graph.leaf(&Poly::zero());
        graph.leaf(&Poly::integer(1));
        graph
    }

    /// How many values there are.
    pub fn count(&self) -> usize {
        self.ways.len()
    }

    /// The polynomial of a value that has been multiplied out.
    pub fn poly(&self, id: Id) -> Option<&Poly> {
        self.polys[id].as_ref()
    }

    fn intern(&mut self, key: Key) -> Id {
        if let Some(id) = self.keys.get(&key) {
            return *id;
        }
        let id = self.ways.len();
        self.polys.push(match &key {
            Key::Poly(poly) => Some(poly.clone()),
            Key::Product(..) => None,
        });
        self.keys.insert(key, id);
        self.ways.push(Vec::new());
        self.leaf.push(false);
        self.names.push(None);
        id
    }

    /// The value of a polynomial.
    pub fn value(&mut self, poly: &Poly) -> Signed {
        let negative = poly.leads_negative();
        let id = self.intern(Key::Poly(if negative { poly.neg() } else { poly.clone() }));
        Signed { id, negative }
    }

    /// The value of a polynomial if it is known.
    pub fn find(&self, poly: &Poly) -> Option<Signed> {
        let negative = poly.leads_negative();
        let key = Key::Poly(if negative { poly.neg() } else { poly.clone() });
        self.keys.get(&key).map(|id| Signed { id: *id, negative })
    }

    /// A value that is given.
    pub fn leaf(&mut self, poly: &Poly) -> Signed {
        let value = self.value(poly);
        self.leaf[value.id] = true;
        value
    }

    fn way(&mut self, of: Id, way: Way) {
        if self.leaf[of] || way.operands.contains(&of) || way.operands.contains(&ZERO) {
            return;
        }
        if !self.ways[of].contains(&way) {
            self.ways[of].push(way);
        }
        for (index, bundle) in self.open.iter_mut().enumerate() {
            if self.order.is_none_or(|o| o == index) {
                bundle.push((of, way));
            }
        }
    }

    /// Ends a bundle: all ways since the last one belong together, once for each order of three summands.
    pub fn close(&mut self) {
        let mut open = std::mem::take(&mut self.open);
        if open[0] == open[1] && open[0] == open[2] {
            open[1].clear();
            open[2].clear();
        }
        self.bundles.extend(open.into_iter().filter(|b| b.len() > 1));
    }

    /// Forgets the open bundle.
    pub fn discard(&mut self) {
        self.open = Default::default();
    }

    /// The product of two polynomials as a value, with the way to it.
    fn product(&mut self, x: &Poly, y: &Poly) -> Signed {
        let (a, b) = (self.value(x), self.value(y));
        let negative = a.negative != b.negative;
        if a.id == ZERO || b.id == ZERO {
            return Signed { id: ZERO, negative: false };
        }
        if a.id == ONE || b.id == ONE {
            return Signed { id: if a.id == ONE { b.id } else { a.id }, negative };
        }
        let value = if x.len() * y.len() <= LARGEST_PRODUCT {
            let product = self.ring.mul(x, y);
            self.value(&product)
        } else {
            Signed { id: self.intern(Key::Product(a.id.min(b.id), a.id.max(b.id))), negative }
        };
        let operands = [a.id.min(b.id), a.id.max(b.id)];
        let way = Way { kind: Kind::Mul, operands, negative: value.negative != negative, cofactor: false };
        self.way(value.id, way);
        value
    }

    /// Says that `of` is the sum of these products; for three of them, in each order.
    pub fn sum_of_products(&mut self, of: &Poly, products: &[(Poly, Poly)], cofactor: bool) {
        let terms: Vec<Signed> = products.iter().map(|(x, y)| self.product(x, y)).collect();
        let terms: Vec<Signed> = terms.into_iter().filter(|t| t.id != ZERO).collect();
        let target = self.value(of);
        match terms.as_slice() {
            [a, b] => self.sum(target, *a, *b, cofactor),
            [a, b, c] => {
                for (order, (x, y, z)) in [(a, b, c), (a, c, b), (b, c, a)].into_iter().enumerate() {
                    self.order = Some(order);
                    if let Some(partial) = self.partial_sum(*x, *y) {
                        self.sum(target, partial, *z, cofactor);
                    }
                }
                self.order = None;
            }
            _ => {}
        }
    }

    /// Says that `of` is ±a ± b.
    fn sum(&mut self, of: Signed, a: Signed, b: Signed, cofactor: bool) {
        let kind = if a.negative == b.negative { Kind::Add } else { Kind::Sub };
        let (a, b) = if a.id <= b.id { (a, b) } else { (b, a) };
        if a.id != b.id {
            let negative = of.negative != a.negative;
            self.way(of.id, Way { kind, operands: [a.id, b.id], negative, cofactor });
        }
    }

    /// The sum of two values whose polynomials are known.
    fn partial_sum(&mut self, a: Signed, b: Signed) -> Option<Signed> {
        let (x, y) = (self.poly(a.id)?.clone(), self.poly(b.id)?.clone());
        let sum = if a.negative == b.negative { self.ring.add(&x, &y) } else { self.ring.sub(&x, &y) };
        let value = self.value(&sum);
        if value.id == ZERO || a.id == b.id {
            return None;
        }
        let value = Signed { id: value.id, negative: value.negative != a.negative };
        self.sum(value, a, b, false);
        Some(value)
    }

    /// Calls a value by a name; the first name stays.
    pub fn name(&mut self, poly: &Poly, name: impl FnOnce() -> String) {
        if let Some(value) = self.find(poly)
            && !self.leaf[value.id]
            && self.names[value.id].is_none()
        {
            self.names[value.id] = Some((name(), value.negative));
        }
    }
}
