//! Arms for the tests of this crate, written as plain products of matrices: they share nothing with generated code.

/// What follows from forward kinematics: the Jacobian by dual numbers, and frames, which no solver asks for.
macro_rules! by_forward_kinematics {
    ($n:literal) => {
        fn frames<T: Real>(&self, q: &Joints<T, $n>) -> [Pose<T>; $n] {
            [self.fk(q); $n]
        }

        fn jacobian<T: Real>(&self, q: &Joints<T, $n>) -> $crate::Jacobian<T, $n> {
            $crate::sample::jacobian(self, q)
        }

        fn fk_jacobian<T: Real>(&self, q: &Joints<T, $n>) -> (Pose<T>, $crate::Jacobian<T, $n>) {
            (self.fk(q), self.jacobian(q))
        }
    };
}

mod figures;
mod table;

pub(crate) use figures::Figures;
pub(crate) use table::{LAB_ARM, LabRrr, PUMA_560, STANFORD_ARM, Table};

use crate::dual::Dual;
use crate::math::{self, Real};
use crate::pose::{self, Jacobian, Joints, Pose};
use crate::{Arm, private};
use core::fmt::{self, Write};

/// Rows of a rotation.
pub(crate) type Rotation = [[f64; 3]; 3];

/// Text of fixed capacity, because there is no allocator here.
pub(crate) struct Text {
    bytes: [u8; 4096],
    length: usize,
}

impl Text {
    pub(crate) fn of(value: &dyn fmt::Display) -> Text {
        let mut text = Text { bytes: [0; 4096], length: 0 };
        write!(text, "{value}").unwrap();
        text
    }

    pub(crate) fn as_str(&self) -> &str {
        core::str::from_utf8(&self.bytes[..self.length]).unwrap()
    }
}

impl Write for Text {
    fn write_str(&mut self, s: &str) -> fmt::Result {
        let room = self.bytes.get_mut(self.length..self.length + s.len()).ok_or(fmt::Error)?;
        room.copy_from_slice(s.as_bytes());
        self.length += s.len();
        Ok(())
    }
}

/// A small counter-based generator (splitmix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [low, high).
    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn angle(&mut self) -> f64 {
        self.within(-core::f64::consts::PI, core::f64::consts::PI)
    }

    pub(crate) fn coin(&mut self) -> bool {
        self.bits() & 1 == 1
    }

    /// Uniform in the range, or zero.
    pub(crate) fn sometimes(&mut self, low: f64, high: f64) -> f64 {
        if self.coin() { self.within(low, high) } else { 0.0 }
    }

    pub(crate) fn rotation(&mut self) -> Rotation {
        let (z, y, x) = (about_z(self.angle()), about_x(self.angle()), about_z(self.angle()));
        pose::product(&z, &pose::product(&y, &x))
    }
}

pub(crate) fn about_x<T: Real>(angle: T) -> [[T; 3]; 3] {
    let ((s, c), o, l) = (math::sin_cos(angle), T::lit(0.0), T::lit(1.0));
    [[l, o, o], [o, c, -s], [o, s, c]]
}

pub(crate) fn about_z<T: Real>(angle: T) -> [[T; 3]; 3] {
    let ((s, c), o, l) = (math::sin_cos(angle), T::lit(0.0), T::lit(1.0));
    [[c, -s, o], [s, c, o], [o, o, l]]
}

/// What an elementary transform may do.
#[derive(Clone, Copy)]
pub(crate) enum Step<T> {
    TurnX(T),
    TurnZ(T),
    Turn([[T; 3]; 3]),
    Shift([T; 3]),
}

/// The product of elementary transforms.
pub(crate) fn chain<T: Real>(steps: impl IntoIterator<Item = Step<T>>) -> Pose<T> {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let (mut r, mut p) = ([[one, zero, zero], [zero, one, zero], [zero, zero, one]], [zero; 3]);
    for step in steps {
        match step {
            Step::TurnX(angle) => r = pose::product(&r, &about_x(angle)),
            Step::TurnZ(angle) => r = pose::product(&r, &about_z(angle)),
            Step::Turn(m) => r = pose::product(&r, &m),
            Step::Shift(by) => {
                for (x, row) in p.iter_mut().zip(&r) {
                    *x = *x + pose::dot(row, &by);
                }
            }
        }
    }
    pose::from_rows(r, p)
}

/// A constant rotation as the number type wants it.
pub(crate) fn lit<T: Real>(m: &Rotation) -> [[T; 3]; 3] {
    m.map(|row| row.map(T::lit))
}

/// A matrix times a column.
pub(crate) fn apply<T: Real>(m: &[[T; 3]; 3], v: &[T; 3]) -> [T; 3] {
    m.map(|row| pose::dot(&row, v))
}

/// The geometric Jacobian by dual numbers: forward kinematics, differentiated as it is written.
pub(crate) fn jacobian<T: Real, const N: usize, A: Arm<N>>(arm: &A, q: &Joints<T, N>) -> Jacobian<T, N> {
    let mut columns = [[T::lit(0.0); 6]; N];
    for (j, column) in columns.iter_mut().enumerate() {
        let mut moving = pose::entries(q).map(|value| Dual::new(value, T::lit(0.0)));
        moving[j].rate = T::lit(1.0);
        let (r, [x, y, z]) = pose::rows(&arm.fk(&pose::column(moving)));
        let spin = pose::product(
            &r.map(|row| row.map(|e| e.rate)),
            &pose::transposed(&r.map(|row| row.map(|e| e.value))),
        );
        *column = [x.rate, y.rate, z.rate, spin[2][1], spin[0][2], spin[1][0]];
    }
    private::jacobian(columns)
}
