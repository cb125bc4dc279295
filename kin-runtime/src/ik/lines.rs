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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ik::base::{ElbowBase, TelescopeBase};
    use crate::ik::general::{length, less};
    use crate::sample::Random;

    /// What the figures place, the axes do too, whichever way a joint turns and wherever its figure value is nothing.
    #[test]
    fn the_axes_carry_the_point_where_the_figures_do() {
        let mut random = Random(86);
        let mut placed = 0;
        for _ in 0..2_000 {
            let offset = [random.angle(), random.angle(), random.within(-0.2, 0.2)];
            let reversed = [(); 3].map(|()| random.coin());
            let (twist, lateral, reach) = ((0.6, 0.8), 0.05, 1.0);
            let base = if random.coin() {
                Base::Elbow(ElbowBase {
                    a1: 0.1,
                    twist,
                    lateral,
                    upper: 0.4,
                    fore: 0.3,
                    offset,
                    reversed,
                    reach,
                })
            } else {
                Base::Telescope(TelescopeBase { a1: 0.1, twist, lateral, arm: 0.2, offset, reversed, reach })
            };
            let p = [(); 3].map(|()| random.within(-0.5, 0.5));
            let GeneralBase { axes: [first, second, third], carried, offset: [o1, o2, o3], .. } =
                base.lines();
            for found in base.place(p, 1.0, [None; 2]).iter().flatten() {
                let [t1, t2, t3] = found.rows;
                let reached = first.moved(second.moved(third.moved(carried, t3 + o3), t2 + o2), t1 + o1);
                assert!(length(less(reached, p)) < 1e-12, "{base:?} {p:?} {reached:?}");
                placed += 1;
            }
        }
        assert!(placed > 2_000, "{placed}");
    }
}
