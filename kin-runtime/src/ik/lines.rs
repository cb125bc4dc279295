//! A base of figures seen as three axes in space, as any base can be.

use crate::ik::base::Base;
use crate::ik::general::{Axis, GeneralBase};
use crate::math::Float;

/// What the two kinds of base that work in a plane have in common, and what joint 3 does there.
struct Planar<T> {
    a1: T,
    twist: (T, T),
    lateral: T,
    /// Along the arm: from axis 2 to where joint 3 begins, and from there to the wrist centre.
    links: [T; 2],
    slides: bool,
    offset: [T; 3],
    reversed: [bool; 3],
    reach: T,
}

impl<T: Float> Base<T> {
    /// The same three joints as axes in space.
    pub fn lines(&self) -> GeneralBase<T> {
        let planar = match *self {
            Base::General(base) => return base,
            Base::Elbow(b) => Planar {
                a1: b.a1,
                twist: b.twist,
                lateral: b.lateral,
                links: [b.upper, b.fore],
                slides: false,
                offset: b.offset,
                reversed: b.reversed,
                reach: b.reach,
            },
            Base::Telescope(b) => Planar {
                a1: b.a1,
                twist: b.twist,
                lateral: b.lateral,
                links: [b.arm, T::lit(0.0)],
                slides: true,
                offset: b.offset,
                reversed: b.reversed,
                reach: b.reach,
            },
        };
        planar.lines()
    }
}

impl<T: Float> Planar<T> {
    /// The axes where all figure values are zero: the arm stretched along the common normal of axes 1 and 2. A joint that is
    /// reversed turns about its axis seen from the other end.
    fn lines(&self) -> GeneralBase<T> {
        let (zero, (sine, cosine), [upper, fore]) = (T::lit(0.0), self.twist, self.links);
        let second = [zero, -sine, cosine];
        let third = if self.slides { [zero, cosine, sine] } else { second };
        let axis = |slides, direction: [T; 3], along: T, reversed: bool| {
            let direction = if reversed { direction.map(|c| -c) } else { direction };
            Axis { slides, direction, point: [along, zero, zero] }
        };
        let ([r1, r2, r3], [o1, o2, o3]) = (self.reversed, self.offset);
        let signed = |offset: T, reversed: bool| if reversed { -offset } else { offset };
        GeneralBase {
            axes: [
                axis(false, [zero, zero, T::lit(1.0)], zero, r1),
                axis(false, second, self.a1, r2),
                axis(self.slides, third, self.a1 + upper, r3),
            ],
            carried: [self.a1 + upper + fore, -sine * self.lateral, cosine * self.lateral],
            offset: [signed(o1, r1), signed(o2, r2), signed(o3, r3)],
            reach: self.reach,
        }
    }
}
