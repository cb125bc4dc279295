//! Three-vectors and matrices over anything that can be added and multiplied exactly.
//!
//! Written once for the two exact domains: polynomials, in which truth is stated, and expressions, in which code is
//! built.

use super::ring::{Poly, Ring};

/// A domain of exact values with its operations.
pub trait Algebra {
    /// A value.
    type Value: Clone + PartialEq;
    /// The value 0.
    fn zero(&self) -> Self::Value;
    /// The value 1.
    fn one(&self) -> Self::Value;
    /// The sum.
    fn plus(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// The product.
    fn times(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value;
    /// The value with its sign changed.
    fn minus(&mut self, a: &Self::Value) -> Self::Value;
}

impl Algebra for Ring {
    type Value = Poly;

    fn zero(&self) -> Poly {
        Poly::zero()
    }

    fn one(&self) -> Poly {
        Poly::integer(1)
    }

    fn plus(&mut self, a: &Poly, b: &Poly) -> Poly {
        self.add(a, b)
    }

    fn times(&mut self, a: &Poly, b: &Poly) -> Poly {
        self.mul(a, b)
    }

    fn minus(&mut self, a: &Poly) -> Poly {
        a.neg()
    }
}

/// A vector.
pub type V3<T> = [T; 3];

/// A matrix by rows.
pub type M3<T> = [[T; 3]; 3];

/// The zero vector.
pub fn origin<A: Algebra>(on: &A) -> V3<A::Value> {
    [on.zero(), on.zero(), on.zero()]
}

/// The unit vector of one axis, 0 to 2.
pub fn unit<A: Algebra>(on: &A, axis: usize) -> V3<A::Value> {
    [0, 1, 2].map(|i| if i == axis { on.one() } else { on.zero() })
}

/// The identity.
pub fn identity<A: Algebra>(on: &A) -> M3<A::Value> {
    [unit(on, 0), unit(on, 1), unit(on, 2)]
}

/// The sum of two vectors.
pub fn add<A: Algebra>(on: &mut A, a: &V3<A::Value>, b: &V3<A::Value>) -> V3<A::Value> {
    [0, 1, 2].map(|i| on.plus(&a[i], &b[i]))
}

/// The difference of two vectors.
pub fn sub<A: Algebra>(on: &mut A, a: &V3<A::Value>, b: &V3<A::Value>) -> V3<A::Value> {
    let minus_b = negate(on, b);
    add(on, a, &minus_b)
}

/// The vector with its sign changed.
pub fn negate<A: Algebra>(on: &mut A, a: &V3<A::Value>) -> V3<A::Value> {
    [0, 1, 2].map(|i| on.minus(&a[i]))
}

/// The multiple of a vector.
pub fn scale<A: Algebra>(on: &mut A, factor: &A::Value, a: &V3<A::Value>) -> V3<A::Value> {
    [0, 1, 2].map(|i| on.times(factor, &a[i]))
}

/// The scalar product.
pub fn dot<A: Algebra>(on: &mut A, a: &V3<A::Value>, b: &V3<A::Value>) -> A::Value {
    let mut sum = on.zero();
    for i in 0..3 {
        let product = on.times(&a[i], &b[i]);
        sum = on.plus(&sum, &product);
    }
    sum
}

/// The vector product.
pub fn cross<A: Algebra>(on: &mut A, a: &V3<A::Value>, b: &V3<A::Value>) -> V3<A::Value> {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let left = on.times(&a[i], &b[j]);
        let right = on.times(&a[j], &b[i]);
        let minus_right = on.minus(&right);
        on.plus(&left, &minus_right)
    })
}

/// The product of a matrix and a vector.
pub fn apply<A: Algebra>(on: &mut A, m: &M3<A::Value>, v: &V3<A::Value>) -> V3<A::Value> {
    [0, 1, 2].map(|i| dot(on, &m[i], v))
}

/// The product of two matrices.
pub fn product<A: Algebra>(on: &mut A, a: &M3<A::Value>, b: &M3<A::Value>) -> M3<A::Value> {
    let columns = transpose(b);
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot(on, &a[i], &columns[j])))
}

/// The transposed matrix.
pub fn transpose<T: Clone>(m: &M3<T>) -> M3<T> {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i].clone()))
}

/// One column, 0 to 2.
pub fn column<T: Clone>(m: &M3<T>, index: usize) -> V3<T> {
    [0, 1, 2].map(|i| m[i][index].clone())
}

/// The matrix with these columns.
pub fn from_columns<T: Clone>(x: &V3<T>, y: &V3<T>, z: &V3<T>) -> M3<T> {
    [0, 1, 2].map(|i| [x[i].clone(), y[i].clone(), z[i].clone()])
}

/// The rotation by an angle, given as (cosine, sine), about one axis, 0 to 2.
pub fn rotation<A: Algebra>(on: &mut A, axis: usize, cos: &A::Value, sin: &A::Value) -> M3<A::Value> {
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut m = identity(on);
    m[next][next] = cos.clone();
    m[last][last] = cos.clone();
    m[last][next] = sin.clone();
    m[next][last] = on.minus(sin);
    m
}
