//! The real roots of a quartic on [-1, 1], none lost where two are close or coincide.
//!
//! Between two neighbouring extrema a polynomial is monotone, so that the signs at its extrema are a certificate: where
//! they differ there is one root, where they agree there is none, and an extremum that is zero but for round-off is a
//! double root. The extrema are the roots of the derivative, found in the same way; the chain ends with a linear
//! polynomial. Two close roots lie on either side of their extremum and cannot be taken for one another.
//!
//! The signs of the quartic itself are asked of the caller's own figure, not of its expanded coefficients: near a double
//! root the figure keeps its digits where a sum of products has lost them.

use crate::math::{self, Float};

/// Coefficients, the constant first.
pub type Quartic<T> = [T; 5];

/// Steps of one bracket: every third halves it, so that 53 halvings are never exceeded.
const STEPS: usize = 160;

/// At most eight places on [-1, 1], in rising order.
#[derive(Clone, Copy, Debug)]
pub struct Places<T> {
    values: [T; 8],
    count: usize,
}

impl<T: Float> Places<T> {
    fn none() -> Self {
        Self { values: [T::lit(0.0); 8], count: 0 }
    }

    fn push(&mut self, value: T) {
        if let Some(place) = self.values.get_mut(self.count) {
            *place = value;
            self.count += 1;
        }
    }

    /// The places in order.
    pub fn iter(&self) -> impl Iterator<Item = T> + '_ {
        self.values.iter().copied().take(self.count)
    }
}

/// A root, and what the figure does there.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Root<T> {
    /// The figure rises through zero.
    Rising(T),
    /// It falls through zero.
    Falling(T),
    /// It touches zero: two roots in one.
    Double(T),
    /// It comes this near without touching.
    Missed(T, T),
}

/// The value of a quartic.
pub fn value<T: Float>([a, b, c, d, e]: &Quartic<T>, t: T) -> T {
    *a + t * (*b + t * (*c + t * (*d + t * *e)))
}

/// (a₀ + a₁t + a₂t²)(b₀ + b₁t + b₂t²).
pub fn product<T: Float>([a0, a1, a2]: [T; 3], [b0, b1, b2]: [T; 3]) -> Quartic<T> {
    [a0 * b0, a0 * b1 + a1 * b0, a0 * b2 + a1 * b1 + a2 * b0, a1 * b2 + a2 * b1, a2 * b2]
}

/// Both ends of [-1, 1] and, between them, the extrema of the quartic.
pub fn extrema<T: Float>(p: &Quartic<T>) -> Places<T> {
    let largest = p.iter().fold(T::lit(0.0), |most, c| math::max(most, math::abs(*c)));
    let unit = if largest > T::lit(0.0) { p.map(|c| c / largest) } else { *p };
    let first = derivative(&unit);
    let second = derivative(&first);
    let third = derivative(&second);
    let mut places = Places::none();
    places.push(T::lit(-1.0));
    places.push(T::lit(1.0));
    for slope in [third, second, first] {
        places = crossings(&slope, &places);
    }
    places
}

fn derivative<T: Float>([_, b, c, d, e]: &Quartic<T>) -> Quartic<T> {
    [*b, T::lit(2.0) * *c, T::lit(3.0) * *d, T::lit(4.0) * *e, T::lit(0.0)]
}

/// Both ends and the places between neighbours where the polynomial changes its sign.
fn crossings<T: Float>(p: &Quartic<T>, places: &Places<T>) -> Places<T> {
    let mut found = Places::none();
    found.push(T::lit(-1.0));
    let at = |t: T| value(p, t);
    for (a, b) in places.iter().zip(places.iter().skip(1)) {
        if (at(a) < T::lit(0.0)) != (at(b) < T::lit(0.0)) {
            found.push(bracketed(&at, a, b));
        }
    }
    found.push(T::lit(1.0));
    found
}

/// The roots of a figure whose extrema are these; what is less than `window` is round-off. At most seven.
pub fn roots<T: Float>(
    places: &Places<T>,
    figure: &impl Fn(T) -> T,
    window: T,
    mut take: impl FnMut(Root<T>),
) {
    let zero = T::lit(0.0);
    let values = places.iter().map(figure);
    let mut before = None;
    let mut pairs = places.iter().zip(values).peekable();
    while let Some((a, at_a)) = pairs.next() {
        let next = pairs.peek().copied();
        if let Some((b, at_b)) = next
            && (at_a < zero) != (at_b < zero)
        {
            let root = bracketed(figure, a, b);
            take(if at_a < zero { Root::Rising(root) } else { Root::Falling(root) });
        } else if let (Some(earlier), Some((_, later))) = (before, next) {
            let same = |x: T| (x < zero) == (at_a < zero);
            if same(earlier) && same(later) {
                let gap = math::abs(at_a);
                take(if gap <= window { Root::Double(a) } else { Root::Missed(a, gap) });
            }
        }
        before = Some(at_a);
    }
}

/// The place between `a` and `b` where the figure, of different signs there, is zero: false position with the idle end's
/// value halved (Illinois), and a bisection in every third step so that the number of steps is bounded.
fn bracketed<T: Float>(figure: &impl Fn(T) -> T, mut a: T, mut b: T) -> T {
    let (half, zero) = (T::lit(0.5), T::lit(0.0));
    let (mut at_a, mut at_b) = (figure(a), figure(b));
    let negative = at_a < zero;
    let mut last = None;
    for step in 0..STEPS {
        let width = b - a;
        if width <= T::EPS + T::EPS {
            break;
        }
        let chord = a - at_a * (width / (at_b - at_a));
        let middle = if step % 3 == 2 || !(chord > a && chord < b) { a + width * half } else { chord };
        let at_middle = figure(middle);
        if math::abs(at_middle) <= T::EPS * T::lit(0.25) {
            return middle;
        }
        let low = (at_middle < zero) == negative;
        let idle = last == Some(low);
        if low {
            (a, at_a) = (middle, at_middle);
            at_b = if idle { at_b * half } else { at_b };
        } else {
            (b, at_b) = (middle, at_middle);
            at_a = if idle { at_a * half } else { at_a };
        }
        last = Some(low);
    }
    a + (b - a) * half
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(p: Quartic<f64>) -> ([Root<f64>; 8], usize) {
        let (mut found, mut count) = ([Root::Missed(0.0, 0.0); 8], 0);
        roots(&extrema(&p), &|t| value(&p, t), 1e-15, |root| {
            if !matches!(root, Root::Missed(..)) {
                found[count] = root;
                count += 1;
            }
        });
        (found, count)
    }

    #[test]
    fn four_roots_alternate() {
        // (t² - 1/4)(t² - 1/16)
        let (found, count) = all(product([-0.25, 0.0, 1.0], [-0.0625, 0.0, 1.0]));
        assert_eq!(count, 4);
        for (root, wanted) in found.iter().zip([-0.5, -0.25, 0.25, 0.5]) {
            let (Root::Rising(t) | Root::Falling(t)) = root else { panic!("{root:?}") };
            assert!((t - wanted).abs() < 1e-14);
        }
        assert!(matches!(found, [Root::Falling(_), Root::Rising(_), Root::Falling(_), Root::Rising(_), ..]));
    }

    #[test]
    fn close_roots_stay_apart_and_double_roots_are_kept() {
        for gap in [1e-3, 1e-5, 1e-7] {
            // (t² - gap²)(t - 2)(t + 3): two roots at ±gap
            let (_, count) = all(product([-gap * gap, 0.0, 1.0], [-6.0, 1.0, 1.0]));
            assert_eq!(count, 2, "{gap:e}");
        }
        let (found, count) = all(product([0.0625, -0.5, 1.0], [-6.0, 1.0, 1.0]));
        // Round-off may leave the extremum on the other side: then there are two, as close as the root of it.
        assert!(count == 1 || count == 2);
        for root in found.iter().take(count) {
            let (Root::Rising(t) | Root::Falling(t) | Root::Double(t) | Root::Missed(t, _)) = root;
            assert!((t - 0.25).abs() < 1e-7);
        }
        assert_eq!(all(product([1.0, 0.0, 1.0], [2.0, 0.0, 1.0])).1, 0);
    }
}
