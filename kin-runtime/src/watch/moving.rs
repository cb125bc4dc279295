//! A Jacobian that moves: its figures in the middle of an interval, and how far they can be from these.
//!
//! The matrix of an interval is J + E, of which the norm ‖E‖ is bounded, and so is the part of E that is not along J̇. A
//! perturbation moves each singular value by ‖E‖ at most (H. Weyl 1912): that is a bound of first order, and where a figure only
//! just reaches a threshold it would have to be asked for at many thousand times. Determinants have one of second order. With
//! the singular values βᵢ of any square matrix M, a perturbation moves det M by tr(adj M·E), of which the part that is not along
//! Ṁ is at most its norm times the sum of the products of all βᵢ but one, and by the terms of second and higher order of
//! ∏(βᵢ + ‖E‖) besides (I. Ipsen and R. Rehman, "Perturbation bounds for determinants and characteristic polynomials", 2008).
//!
//! Every figure is therefore asked of a determinant:
//!
//! * det J itself.
//! * The manipulability: with columns in excess, J + E is (X Y) in the axes of the directions of J, where Y is a part of E and X
//!   is square. Then w² = det(X·Xᵀ + Y·Yᵀ), between (det X)² and that plus ∏(σ(X)² + ‖E‖²) - ∏σ(X)².
//! * For a threshold t of the smallest singular value, ∏(t² - σ²), that of (t J; Jᵀ t), with βᵢ = |t ± σ|, and t for every column or
//!   row in excess. As long as it does not vanish no singular value is t, and the smallest stays on its side. A singular value
//!   has a kink where it meets its neighbour, and none of its derivatives is bounded near there; the product is smooth.

use super::hunt::Range;
use crate::dual::Dual;
use crate::math::{self, Float};
use crate::pose::Jacobian;
use crate::singularity::{self, Direction, length, product};

/// The normalised Jacobian in the middle of an interval.
pub(super) struct Moving<T, const N: usize> {
    pub(super) jacobian: Jacobian<Dual<T>, N>,
    /// How many rows count: 6, or the 3 linear ones, with zeros for the others.
    pub(super) rows: usize,
    /// How far the interval goes to either side, in seconds.
    pub(super) half: T,
    /// How far the matrix can be from that of the middle, but for a turn of the whole arm.
    pub(super) off: T,
    /// How far it can be from the straight line that it sets out on, but for such a turn.
    pub(super) aside: T,
}

/// A product of singular values, and what the perturbation of a matrix does to it.
#[derive(Clone, Copy)]
struct Perturbed<T> {
    /// ∏βᵢ.
    value: T,
    /// The sum of the products of all but one.
    minors: T,
    /// ∏(βᵢ + e) less the terms of order 0 and 1 in e.
    rest: T,
}

impl<T: Float> Perturbed<T> {
    fn new(sizes: impl IntoIterator<Item = T>, off: T) -> Self {
        let (one, zero) = (T::lit(1.0), T::lit(0.0));
        sizes.into_iter().fold(Self { value: one, minors: zero, rest: zero }, |all, size| Self {
            value: all.value * size,
            minors: all.minors * size + all.value,
            rest: all.rest * (size + off) + all.minors * off * off,
        })
    }

    /// How far the determinant can be from its value, if it moves by `along` with the matrix on its straight line.
    fn spread(&self, along: T, aside: T) -> T {
        math::abs(along) + self.minors * aside + self.rest
    }
}

impl<T: Float, const N: usize> Moving<T, N> {
    /// The matrix as it stands.
    fn values(&self) -> Jacobian<T, N> {
        crate::private::jacobian(self.jacobian.data.0.map(|column| column.map(|entry| entry.value)))
    }

    /// How many singular values count.
    fn counted(&self) -> usize {
        self.rows.min(N)
    }

    /// By how many its sides differ.
    fn excess(&self) -> usize {
        self.rows.abs_diff(N)
    }

    /// The square of a singular value with its rate, 2σ·uᵀJ̇v; a turn of the whole arm is no part of it.
    fn square(&self, direction: &Direction<T, N>) -> Dual<T> {
        let mut moved = [T::lit(0.0); 6];
        for (column, part) in self.jacobian.data.0.iter().zip(direction.turn) {
            for (sum, entry) in moved.iter_mut().zip(column) {
                *sum += entry.rate * part;
            }
        }
        let size = length(&direction.column);
        Dual::new(size * size, T::lit(2.0) * product(&direction.column, &moved))
    }

    /// The determinant; nothing if the matrix is not square, or if elimination finds no rate.
    pub(super) fn determinant(&self) -> Option<Range<T>> {
        let columns = self.jacobian.data.0.as_slice();
        let value = |entry: Dual<T>| entry.value;
        let det = if self.rows == 6 {
            singularity::eliminated::<_, T, 6>(columns.try_into().ok()?, 6, value)?
        } else {
            singularity::eliminated::<_, T, 3>(columns.try_into().ok()?, 3, value)?
        };
        let values = crate::pose::entries(&singularity::singular_values(&self.values()));
        let perturbed = Perturbed::new(values.into_iter().take(self.rows), self.off);
        let straight = perturbed.spread(det.rate * self.half, self.aside);
        // Where the rate is large for round-off alone, the bound that needs none is better.
        let any = perturbed.spread(T::lit(0.0), self.off);
        Some(Range { value: det.value, spread: math::min(straight, any) })
    }

    /// The product of the singular values.
    pub(super) fn manipulability(&self) -> Range<T> {
        let (one, zero) = (T::lit(1.0), T::lit(0.0));
        let directions = singularity::directions(&self.values());
        let counted = directions.get(..self.counted()).unwrap_or(&[]);
        let sizes = || counted.iter().map(|direction| length(&direction.column));
        let perturbed = Perturbed::new(sizes(), self.off);
        let any = perturbed.spread(zero, self.off);
        let volume = counted.iter().zip(sizes()).fold(Dual::new(one, zero), |volume, (direction, size)| {
            volume * Dual::new(size, self.square(direction).rate / (size + size))
        });
        let straight = perturbed.spread(volume.rate * self.half, self.aside);
        let beyond = if self.excess() == 0 {
            zero
        } else {
            let squares = sizes().map(|size| (size + self.off) * (size + self.off));
            Perturbed::new(squares, self.off * self.off).spread(zero, self.off * self.off)
        };
        let most = perturbed.value + straight;
        let wider = math::sqrt(most * most + beyond) - perturbed.value;
        // Where a singular value is 0 the product has no rate.
        Range { value: perturbed.value, spread: if wider < any { wider } else { any } }
    }

    /// The smallest singular value.
    pub(super) fn margin(&self) -> Range<T> {
        let values = crate::pose::entries(&singularity::singular_values(&self.values()));
        let value = values.get(self.counted().saturating_sub(1)).copied().unwrap_or(T::lit(0.0));
        Range { value, spread: self.off }
    }

    /// The same, with no spread where it surely stays on its side of a threshold, whatever round-off of some size does to J.
    pub(super) fn margin_about(&self, threshold: T, noise: T) -> Range<T> {
        let directions = singularity::directions(&self.values());
        let counted = directions.get(..self.counted()).unwrap_or(&[]);
        let value = counted.last().map_or(T::lit(0.0), |direction| length(&direction.column));
        let stays = self.alone(counted, threshold, noise) || self.together(counted, threshold, noise);
        Range { value, spread: if stays { T::lit(0.0) } else { self.off } }
    }

    /// βᵢ = |t ± σ| of some of the directions, and t for the excess of the larger side.
    fn sizes(&self, counted: &[Direction<T, N>], threshold: T) -> impl Iterator<Item = T> {
        let pairs = counted.iter().flat_map(move |direction| {
            let size = length(&direction.column);
            [math::abs(threshold - size), math::abs(threshold + size)]
        });
        pairs.chain(core::iter::repeat_n(math::abs(threshold), self.excess()))
    }

    /// Whether no singular value can be the threshold, by the whole product.
    fn together(&self, counted: &[Direction<T, N>], threshold: T, noise: T) -> bool {
        let perturbed = Perturbed::new(self.sizes(counted, threshold), self.off + noise);
        let one = Dual::new(T::lit(1.0), T::lit(0.0));
        let straight = counted.iter().fold(one, |all, direction| {
            let size = length(&direction.column);
            let apart = (threshold - size) * (threshold + size);
            all * Dual::new(apart, -self.square(direction).rate)
        });
        let rate = (0..self.excess()).fold(straight.rate, |rate, _| rate * threshold);
        perturbed.value > perturbed.spread(rate * self.half, self.aside + noise)
    }

    /// The same, by the smallest singular value with its rate and all others without: better where it is well apart from them, and
    /// where the threshold is small, because then σ may go through 0 and come back as -σ.
    ///
    /// In the axes of the directions of J the perturbation F of (t J; Jᵀ t), less what it does on the diagonal of the pair t ± σ, has
    /// nothing but zeros in the four places of that pair. So those minors of F vanish that take one of the pair and no other, or
    /// both and fewer than two others.
    fn alone(&self, counted: &[Direction<T, N>], threshold: T, noise: T) -> bool {
        let Some((last, others)) = counted.split_last() else { return false };
        let size = length(&last.column);
        let slope = self.square(last).rate / (size + size);
        // At 0 a singular value has no slope of its own, but none is larger than that of the matrix.
        let along = if math::is_finite(slope) { math::abs(slope) * self.half } else { self.off };
        let shift = along + self.aside + noise;
        let off = self.off + noise + shift;
        let others = Perturbed::new(self.sizes(others, threshold), off);
        let (near, far) = (math::abs(threshold - size), math::abs(threshold + size));
        let pair = math::max(near - shift, T::lit(0.0)) * math::max(far - shift, T::lit(0.0));
        let change = others.minors * off + others.rest;
        let one = off * (near + far + shift + shift) * change;
        pair * (others.value - change) > one + off * off * others.rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;
    use crate::singularity::directions;

    const ROUNDS: usize = if cfg!(debug_assertions) { 100 } else { 2_000 };

    /// A matrix with random entries, of norm 1; only so many rows are not zero.
    fn random_matrix<const N: usize>(random: &mut Random, rows: usize) -> Jacobian<f64, N> {
        let mut columns = [[0.0; 6]; N];
        for entry in columns.iter_mut().flat_map(|column| &mut column[..rows]) {
            *entry = random.within(-1.0, 1.0);
        }
        let matrix: Jacobian<f64, N> = crate::private::jacobian(columns);
        matrix / matrix.norm()
    }

    /// Ten to some power, by squaring and halving: only `math` calls anything transcendental, and it has no powers.
    fn power(exponent: f64) -> f64 {
        let (mut value, mut root, mut rest) = (1.0, 10.0_f64, exponent.abs());
        while rest >= 1.0 {
            (value, rest) = (value * 10.0, rest - 1.0);
        }
        for _ in 0..20 {
            (root, rest) = (math::sqrt(root), rest * 2.0);
            if rest >= 1.0 {
                (value, rest) = (value * root, rest - 1.0);
            }
        }
        if exponent < 0.0 { 1.0 / value } else { value }
    }

    /// One with singular values of all sizes, some of them equal or nearly so.
    fn with_sizes<const N: usize>(random: &mut Random, rows: usize) -> Jacobian<f64, N> {
        let mut size = 2.0;
        let mut sum = Jacobian::<f64, N>::zeros();
        for direction in directions(&random_matrix::<N>(random, rows)).iter().take(rows.min(N)) {
            size *= match random.bits() % 4 {
                0 => 1.0 - power(random.within(-12.0, -1.0)),
                1 => power(random.within(-4.0, 0.0)),
                _ => random.within(0.3, 1.0),
            };
            let long = length(&direction.column);
            sum += outer(&direction.column.map(|x| x / long), &direction.turn) * size;
        }
        sum
    }

    fn outer<const N: usize>(column: &[f64; 6], turn: &[f64; N]) -> Jacobian<f64, N> {
        crate::private::jacobian(turn.map(|part| column.map(|x| x * part)))
    }

    fn moving<const N: usize>(
        (now, rate): (&Jacobian<f64, N>, &Jacobian<f64, N>),
        rows: usize,
        (half, aside): (f64, f64),
    ) -> Moving<f64, N> {
        let off = rate.norm() * half + aside;
        Moving { jacobian: now.zip_map(rate, Dual::new), rows, half, off, aside }
    }

    /// The figures of a matrix as it stands.
    fn still<const N: usize>(matrix: &Jacobian<f64, N>, rows: usize) -> Moving<f64, N> {
        moving((matrix, &Jacobian::<f64, N>::zeros()), rows, (0.0, 0.0))
    }

    /// How many of the thresholds that were asked about the margin was found to stay away from.
    fn perturbed<const N: usize>(random: &mut Random, rows: usize) -> usize {
        let (now, rate) = (with_sizes::<N>(random, rows), random_matrix::<N>(random, rows));
        let rate = rate * power(random.within(-3.0, 0.5));
        let half = power(random.within(-7.0, 0.0));
        let aside = half * half * random.sometimes(0.0, 2.0);
        let moving = moving((&now, &rate), rows, (half, aside));
        let margin = moving.margin();
        let apart = power(random.within(-12.0, 1.0));
        let thresholds = [
            margin.value + random.within(-2.0, 2.0) * margin.spread,
            margin.value * random.within(0.9, 1.1),
            margin.value - apart * margin.spread,
            margin.value + apart * margin.spread,
        ];
        let about = thresholds.map(|t| moving.margin_about(t, 1e-15));
        let (det, volume) = (moving.determinant(), moving.manipulability());
        let directions = directions(&now);
        for _ in 0..20 {
            // Along the way, and aside: in any direction, or in that of the smallest singular value.
            let least = &directions[rows.min(N) - 1];
            let long = length(&least.column).max(1e-300);
            let any = if random.coin() {
                random_matrix::<N>(random, rows)
            } else {
                outer(&least.column.map(|x| x / long), &least.turn)
            };
            let part = if random.coin() { 1.0 } else { random.within(0.0, 1.0) };
            let sign = if random.coin() { 1.0 } else { -1.0 };
            let then = now + rate * (half * random.within(-1.0, 1.0)) + any * (sign * part * aside);
            let then = still(&then, rows);
            let inside = |then: f64, range: &Range<f64>| (then - range.value).abs() <= range.spread + 1e-14;
            assert!(inside(then.margin().value, &margin));
            assert!(inside(then.manipulability().value, &volume));
            if let (Some(det), Some(then)) = (&det, then.determinant()) {
                assert!(inside(then.value, det));
            }
            for (threshold, about) in thresholds.iter().zip(&about).filter(|(_, about)| about.spread == 0.0) {
                let (before, after) = (about.value - threshold, then.margin().value - threshold);
                assert!(before * after > 0.0, "{rows}x{N} {before:e} {after:e} {half:e} {aside:e}");
            }
        }
        about.iter().filter(|about| about.spread == 0.0).count()
    }

    #[test]
    fn no_perturbation_leads_out_of_a_range() {
        let mut random = Random(94);
        let mut stayed = 0;
        for _ in 0..ROUNDS {
            stayed += perturbed::<6>(&mut random, 6) + perturbed::<7>(&mut random, 6);
            stayed += perturbed::<4>(&mut random, 6) + perturbed::<6>(&mut random, 3);
            stayed += perturbed::<3>(&mut random, 3) + perturbed::<2>(&mut random, 3);
        }
        // The bounds are of use: they decide about thresholds, most of which Weyl's bound leaves open.
        assert!(stayed > 6 * ROUNDS, "{stayed} of {}", 24 * ROUNDS);
    }

    #[test]
    fn what_hardly_moves_is_told_from_a_threshold_beside_it() {
        let mut random = Random(95);
        for _ in 0..200 {
            let turns = directions(&random_matrix::<6>(&mut random, 6));
            let unit =
                |k: usize| outer(&turns[k].column.map(|x| x / length(&turns[k].column)), &turns[k].turn);
            let sizes = [2.0, 1.0, 0.8, 0.5, 0.3];
            let now = |least: f64| {
                let zip = sizes.into_iter().chain([least]).enumerate();
                zip.fold(Jacobian::<f64, 6>::zeros(), |sum, (k, size)| sum + unit(k) * size)
            };
            // The matrix moves by 1e-4, but the smallest singular value only to second order: 1e-8/0.2 or so.
            let rate = random_matrix::<6>(&mut random, 6);
            let rate = rate - unit(5) * rate.dot(&unit(5));
            for least in [0.1, 1e-3, 1e-6] {
                let moving = moving((&now(least), &rate), 6, (1e-4, 1e-8));
                for threshold in [least - 2e-7, least + 2e-7] {
                    assert_eq!(moving.margin_about(threshold, 1e-14).spread, 0.0, "{least} {threshold}");
                }
            }
            // Two equal ones, which a first order moves apart: the product sees both.
            let twice = now(0.3);
            let moving = moving((&twice, &rate), 6, (1e-6, 1e-12));
            assert_eq!(moving.margin_about(0.3 - 4e-6, 1e-14).spread, 0.0);
        }
    }
}
