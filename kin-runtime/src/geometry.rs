//! The alphabet of figures from which every closed-form solution is spelled.
//!
//! Each figure says what it is: how it closes, that it just touches, that it has collapsed so that an angle is free,
//! or by how much it stays open. Half-angle formulae throughout: the sides of a triangle enter as differences, which
//! keep their digits where a cosine near ±1 has lost them.

use crate::math::{self, Float};

/// A plane vector turned by the angle whose sine and cosine are given.
pub fn turn<T: Float>([x, y]: [T; 2], (s, c): (T, T)) -> [T; 2] {
    [c * x - s * y, s * x + c * y]
}

/// Where a circle meets a plane parallel to its axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Chord<T> {
    /// In two points, this far to either side of the foot of the perpendicular; zero where it just touches.
    Cut(T),
    /// The circle is a point and lies in the plane: every direction will do.
    Free,
    /// Not at all: the plane is this much too far from the centre.
    Apart(T),
}

/// The circle of the given radius about the origin meets the plane at a distance from it. What is less than `window`
/// is round-off.
pub fn circle_meets_plane<T: Float>(radius: T, distance: T, window: T) -> Chord<T> {
    let far = math::abs(distance);
    if far - radius > window {
        Chord::Apart(far - radius)
    } else if radius <= window {
        Chord::Free
    } else if radius - far <= window * T::lit(0.5) {
        Chord::Cut(T::lit(0.0))
    } else {
        Chord::Cut(math::sqrt_or_zero((radius - far) * (radius + far)))
    }
}

/// How two links span a distance.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Span<T> {
    /// The fore link is turned against the upper one by this angle, in [0, π], to either side.
    Bend(T),
    /// The links are equal and the distance is nothing: folded, in every direction.
    Free,
    /// The distance is this much longer than both links together.
    TooFar(T),
    /// The distance is this much shorter than the difference of the links.
    TooNear(T),
}

/// Two links, `upper` and `fore`, span `distance`: where two circles meet. What is less than `window` is round-off.
///
/// tan²(bend/2) = (S - D)(S + D) / ((D - d)(D + d)), with S the sum of the links and d their difference.
pub fn circle_meets_circle<T: Float>(upper: T, fore: T, distance: T, window: T) -> Span<T> {
    let (sum, difference, touching) = (upper + fore, math::abs(upper - fore), window * T::lit(0.5));
    if distance - sum > window {
        Span::TooFar(distance - sum)
    } else if difference - distance > window {
        Span::TooNear(difference - distance)
    } else if distance <= window {
        Span::Free
    } else if sum - distance <= touching {
        Span::Bend(T::lit(0.0))
    } else if distance - difference <= touching {
        Span::Bend(math::half_turn())
    } else {
        let open = math::sqrt_or_zero((sum - distance) * (sum + distance));
        let shut = math::sqrt_or_zero((distance - difference) * (distance + difference));
        Span::Bend(T::lit(2.0) * math::atan2(open, shut))
    }
}

/// How two arcs of great circles span a third.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Corner<T> {
    /// The arcs meet at this angle, in [0, π], to either side.
    Angle(T),
    /// The arc to be spanned is this much too long, in radians.
    TooFar(T),
    /// It is this much too short, in radians.
    TooNear(T),
}

/// Two arcs, `upper` and `fore` in (0, π), span an arc `distance` in [0, π] on the unit sphere: where two cones about
/// one point meet. The spherical sister of [`circle_meets_circle`], but that the angle is the one between the arcs:
///
/// tan²(corner/2) = sin((D - d)/2) sin((D + d)/2) / (sin((S - D)/2) sin((S + D)/2)).
pub fn cone_meets_cone<T: Float>(upper: T, fore: T, distance: T, window: T) -> Corner<T> {
    let (sum, difference) = (upper + fore, math::abs(upper - fore));
    // Arcs that go more than half around come back from the other side.
    let longest = math::min(sum, T::TURN.0 - sum);
    if distance - longest > window {
        Corner::TooFar(distance - longest)
    } else if difference - distance > window {
        Corner::TooNear(difference - distance)
    } else {
        let sine = |x: T| math::sin_cos(x * T::lit(0.5)).0;
        let open = math::sqrt_or_zero(sine(sum - distance) * sine(sum + distance));
        let shut = math::sqrt_or_zero(sine(distance - difference) * sine(distance + difference));
        Corner::Angle(T::lit(2.0) * math::atan2(shut, open))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn a_right_triangle_bends_as_pythagoras_says() {
        match circle_meets_circle(3.0_f64, 4.0, 5.0, 1e-14) {
            Span::Bend(bend) => assert!((bend - FRAC_PI_2).abs() < 1e-15),
            other => panic!("{other:?}"),
        }
        assert_eq!(circle_meets_circle(3.0, 4.0, 7.0, 1e-14), Span::Bend(0.0));
        assert_eq!(circle_meets_circle(3.0, 4.0, 1.0, 1e-14), Span::Bend(PI));
        assert_eq!(circle_meets_circle(3.0, 4.0, 7.5, 1e-14), Span::TooFar(0.5));
        assert_eq!(circle_meets_circle(3.0, 4.0, 0.25, 1e-14), Span::TooNear(0.75));
        assert_eq!(circle_meets_circle(3.0_f32, 3.0, 0.0, 1e-6), Span::Free);
    }

    #[test]
    fn round_off_beyond_the_boundary_touches_and_a_picometre_does_not() {
        let window = 8.0 * f64::EPSILON;
        let beyond = |by: f64| circle_meets_circle(1.0, 1.0, 2.0 + by, window);
        assert_eq!(beyond(4.0 * f64::EPSILON), Span::Bend(0.0));
        assert_eq!(beyond(-2.0 * f64::EPSILON), Span::Bend(0.0));
        assert!(matches!(beyond(-1e-12), Span::Bend(bend) if bend > 1e-6));
        assert!(matches!(beyond(1e-12), Span::TooFar(_)));
        assert_eq!(circle_meets_plane(1.0, 1.0 + f64::EPSILON, window), Chord::Cut(0.0));
        assert!(matches!(circle_meets_plane(1.0, 1.0 + 1e-12, window), Chord::Apart(_)));
    }

    #[test]
    fn a_plane_cuts_a_circle_by_pythagoras() {
        assert_eq!(circle_meets_plane(5.0, -3.0, 1e-14), Chord::Cut(4.0));
        assert_eq!(circle_meets_plane(0.0, 0.0, 1e-14), Chord::Free);
        assert_eq!(circle_meets_plane(1.0, -3.0, 1e-14), Chord::Apart(2.0));
    }

    #[test]
    fn a_spherical_triangle_with_three_right_angles() {
        let meet = |upper, fore, distance| cone_meets_cone(upper, fore, distance, 1e-15);
        match meet(FRAC_PI_2, FRAC_PI_2, FRAC_PI_2) {
            Corner::Angle(corner) => assert!((corner - FRAC_PI_2).abs() < 1e-15),
            other => panic!("{other:?}"),
        }
        assert!(matches!(meet(0.5, 0.5, 1.25), Corner::TooFar(by) if (by - 0.25_f64).abs() < 1e-15));
        assert!(matches!(meet(0.5, 0.25, 0.125), Corner::TooNear(by) if (by - 0.125_f64).abs() < 1e-15));
        assert!(matches!(meet(2.0, 2.5, 3.0), Corner::TooFar(by) if (by - (7.5 - 2.0 * PI)).abs() < 1e-15));
    }

    #[test]
    fn a_quarter_turn_takes_x_to_y() {
        assert_eq!(turn([2.0, 3.0], (1.0, 0.0)), [-3.0, 2.0]);
    }
}
