//! The pose to be reached: whether it can be asked for at all, and whether joint values reach it.

use crate::ik::{ACCEPTED, Base};
use crate::math::{self, Float, Lanes, Real};
use crate::pose::{self, Pose};
use crate::solutions::{Boundary, Reason};

/// A pose whose rotation is one to the last bits, and the size against which it is judged.
#[derive(Clone, Copy, Debug)]
pub struct Target<T: Float> {
    /// The pose, its rotation made orthonormal.
    pub pose: Pose<T>,
    /// The arm's reach, or the largest coordinate of the pose if that is larger.
    pub scale: T,
}

impl<T: Float> Target<T> {
    /// Checks a pose for an arm with the given base.
    ///
    /// # Errors
    /// The reason that every slot is to show: not an arm, not finite, not a rotation, left-handed, or so far away that the numbers
    /// themselves would overflow.
    #[inline(always)]
    pub fn new(pose: &Pose<T>, base: &Base<T>) -> Result<Self, Reason<T>> {
        if !base.is_finite() {
            return Err(Reason::NotAnArm);
        }
        Target::for_reach(pose, base.reach())
    }

    /// Checks a pose for an arm of which only the reach is known.
    ///
    /// # Errors
    /// As [`Target::new`].
    #[inline(always)]
    pub fn for_reach(pose: &Pose<T>, reach: T) -> Result<Self, Reason<T>> {
        let (rotation, position) = pose::rows(pose);
        let scale = size(&position, reach)?;
        let rotation = orthonormal(rotation)?;
        Ok(Self { pose: pose::from_rows(rotation, position), scale })
    }

    /// How far another pose misses this one: the largest difference of position entries over the scale, or of
    /// rotation entries.
    pub fn missed_by(&self, other: &Pose<T>) -> T {
        let (rotation, position) = pose::rows(&self.pose);
        let (other_rotation, other_position) = pose::rows(other);
        let [x, y, z] = rotation;
        let [other_x, other_y, other_z] = other_rotation;
        let turned = [distance(&x, &other_x), distance(&y, &other_y), distance(&z, &other_z)];
        let zero = T::lit(0.0);
        let shifted = distance(&position, &other_position) / self.scale;
        distance(&[distance(&turned, &[zero; 3]), shifted, zero], &[zero; 3])
    }
}

impl<T: Float> Target<T> {
    /// How far several poses miss this one: see [`Target::missed_by`].
    pub(crate) fn missed_by_all<const L: usize>(&self, others: &Pose<Lanes<T, L>>) -> Lanes<T, L> {
        let (([x, y, z], p), ([a, b, c], q)) = (pose::rows(&self.pose), pose::rows(others));
        let ([x0, x1, x2], [y0, y1, y2], [z0, z1, z2], [p0, p1, p2]) = (x, y, z, p);
        let ([a0, a1, a2], [b0, b1, b2], [c0, c1, c2], [q0, q1, q2]) = (a, b, c, q);
        let mut missed = Lanes::splat(T::lit(0.0));
        for (lane, missed) in missed.0.iter_mut().enumerate() {
            let far = |entry: T, other: &Lanes<T, L>| math::abs(entry - other.lane(lane));
            let (x, sx) = largest([far(x0, &a0), far(x1, &a1), far(x2, &a2)]);
            let (y, sy) = largest([far(y0, &b0), far(y1, &b1), far(y2, &b2)]);
            let (z, sz) = largest([far(z0, &c0), far(z1, &c1), far(z2, &c2)]);
            let (p, sp) = largest([far(p0, &q0), far(p1, &q1), far(p2, &q2)]);
            let most = math::max(math::max(math::max(x, y), z), p / self.scale);
            // A comparison lets go of what is not a number; a sum does not.
            let all = (sx + sy) + (sz + sp);
            *missed = if math::is_nan(all) { all } else { most };
        }
        missed
    }
}

/// The largest of three sizes, and their sum.
#[inline(always)]
fn largest<T: Float>([a, b, c]: [T; 3]) -> (T, T) {
    (math::max(math::max(a, b), c), a + b + c)
}

/// The size of a position, at least the arm's reach.
///
/// # Errors
/// An entry is not finite, or so large that no figure can be trusted; or the arm itself is nothing to compare with.
pub fn size<T: Float>(position: &[T; 3], reach: T) -> Result<T, Reason<T>> {
    // The squares of the smallest length that counts and of the farthest position must both be numbers.
    let (least, most) = (reach * T::EPS, reach / T::EPS);
    let sound = reach > T::lit(0.0) && least * least > T::lit(0.0) && math::is_finite(most * most);
    if !sound {
        return Err(Reason::NotAnArm);
    }
    let largest = distance(position, &[T::lit(0.0); 3]);
    if !math::is_finite(largest) || !position.iter().all(|x| math::is_finite(*x)) {
        return Err(Reason::NotFinite);
    }
    if largest * T::EPS > reach {
        // Beyond this the squares of a figure could overflow, and the arm is less than round-off of the distance.
        let [x, y, z] = position.map(|x| x / largest);
        let length = largest * math::sqrt(x * x + y * y + z * z);
        let by = if math::is_finite(length) { length } else { largest } - reach;
        return Err(Reason::OutOfReach { by, towards: Boundary::Reach, theta1: None });
    }
    Ok(math::max(largest, reach))
}

/// The largest difference between two triples; NaN if there is one, so that a NaN is never taken for a hit.
pub fn distance<T: Float>([a, b, c]: &[T; 3], [x, y, z]: &[T; 3]) -> T {
    let mut largest = T::lit(0.0);
    for difference in [*a - *x, *b - *y, *c - *z] {
        let size = math::abs(difference);
        // A NaN replaces everything here, and nothing replaces it.
        if size > largest || math::is_nan(size) {
            largest = size;
        }
    }
    largest
}

/// Whether a residual is round-off.
#[inline(always)]
pub(crate) fn is_accepted<T: Float>(residual: T) -> bool {
    residual <= T::lit(ACCEPTED) * T::EPS
}

/// A residual that is round-off, or why there is no solution.
pub fn accepted<T: Float>(residual: T) -> Result<T, Reason<T>> {
    if is_accepted(residual) {
        return Ok(residual);
    }
    // The pose is finite and so are the figures: what else spoils the residual are numbers of the arm beyond them.
    Err(if math::is_finite(residual) { Reason::Inaccurate { residual } } else { Reason::NotAnArm })
}

/// A number to report, where the true one overflowed.
fn known<T: Float>(x: T) -> T {
    if math::is_finite(x) { x } else { T::lit(1.0) / T::EPS }
}

/// The rotation nearest to a matrix that is one but for rounding of its source: half of the defect 1 - RᵀR is given
/// back to R, which squares it, until nothing is left.
#[inline(always)]
pub(crate) fn orthonormal<T: Float>(r: [[T; 3]; 3]) -> Result<[[T; 3]; 3], Reason<T>> {
    if is_rotation(&r) { Ok(r) } else { mended(r) }
}

/// Whether a matrix is a rotation to the last bits: nothing that is not a number is.
#[inline(always)]
fn is_rotation<T: Float>(r: &[[T; 3]; 3]) -> bool {
    let ([a, b, c, d, e, f], determinant) = defects(r);
    let small = |defect| math::abs(defect) <= T::lit(ROUNDED) * T::EPS;
    (small(a) & small(b) & small(c)) & (small(d) & small(e) & small(f)) & (determinant > T::lit(0.0))
}

/// The entries of 1 - RRᵀ of a rotation that is one to the last bits, in units of ε.
const ROUNDED: f64 = 4.0;

/// What the rows of a matrix miss to be of length 1 and at right angles, and its determinant.
#[inline(always)]
fn defects<T: Real>([x, y, z]: &[[T; 3]; 3]) -> ([T; 6], T) {
    let short = |row| T::lit(1.0) - pose::dot(row, row);
    let oblique = [pose::dot(x, y), pose::dot(y, z), pose::dot(z, x)];
    let [d, e, f] = oblique;
    ([short(x), short(y), short(z), d, e, f], pose::dot(x, &cross(y, z)))
}

/// The size against which a pose is judged, and 0 where [`Target::for_reach`] takes it as it is; without a branch.
#[inline(always)]
pub(crate) fn judged<T: Float>(pose: &Pose<T>, reach: T) -> (T, T) {
    let (rotation, [x, y, z]) = pose::rows(pose);
    let (x, y, z) = (math::abs(x), math::abs(y), math::abs(z));
    let (largest, sum) = (math::max(math::max(x, y), z), x + y + z);
    // The largest lets go of what is not a number; the sum does not.
    let mut refused = unless::<T>(largest * T::EPS <= reach) + unless(sum < T::lit(f64::INFINITY));
    let (defects, determinant) = defects(&rotation);
    for defect in defects {
        refused += unless(math::abs(defect) <= T::lit(ROUNDED) * T::EPS);
    }
    (math::max(largest, reach), refused + unless(determinant > T::lit(0.0)))
}

/// 1 where something does not hold, 0 where it does: a number, of which compilers make vectors.
#[inline(always)]
pub(crate) fn unless<T: Float>(holds: bool) -> T {
    if holds { T::lit(0.0) } else { T::lit(1.0) }
}

/// As [`orthonormal`], for a matrix of any numbers.
#[cold]
fn mended<T: Float>(mut r: [[T; 3]; 3]) -> Result<[[T; 3]; 3], Reason<T>> {
    if r.iter().flatten().any(|x| !math::is_finite(*x)) {
        return Err(Reason::NotFinite);
    }
    let (mut gap, mut defect) = gap(&r);
    if defect > T::lit(64.0) * math::sqrt(T::EPS) || math::is_nan(defect) {
        return Err(Reason::NotARotation { defect: known(defect) });
    }
    let [x, y, z] = &r;
    if pose::dot(x, &cross(y, z)) < T::lit(0.0) {
        return Err(Reason::LeftHanded);
    }
    for _ in 0..3 {
        if defect <= T::lit(4.0) * T::EPS {
            break;
        }
        let correction = pose::product(&r, &gap);
        for (row, extra) in r.iter_mut().zip(&correction) {
            for (x, dx) in row.iter_mut().zip(extra) {
                *x += T::lit(0.5) * *dx;
            }
        }
        (gap, defect) = self::gap(&r);
    }
    Ok(r)
}

/// 1 - RᵀR and its largest entry.
fn gap<T: Float>(r: &[[T; 3]; 3]) -> ([[T; 3]; 3], T) {
    let one = T::lit(1.0);
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = pose::product(&pose::transposed(r), r);
    let gap = [[one - xx, -xy, -xz], [-xy, one - yy, -yz], [-xz, -yz, one - zz]];
    let mut defect = T::lit(0.0);
    for row in &gap {
        let size = distance(row, &[T::lit(0.0); 3]);
        if size > defect || math::is_nan(size) {
            defect = size;
        }
    }
    (gap, defect)
}

#[inline(always)]
fn cross<T: Real>([a, b, c]: &[T; 3], [x, y, z]: &[T; 3]) -> [T; 3] {
    [*b * *z - *c * *y, *c * *x - *a * *z, *a * *y - *b * *x]
}
