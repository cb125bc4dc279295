//! Any bit pattern at all: poses and joint values that no arm ever had must still get an answer.

use kin_runtime::prelude::*;

use super::subject::{Bits, Subject};
use super::tally::{Fault, Tally};
use super::trial::{Try, bits, well_formed};
use crate::sample::Sampler;

/// Values at which comparisons go wrong.
const ODD: [f64; 12] = [
    0.0,
    -0.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MIN_POSITIVE,
    5e-324,
    f64::MAX,
    -f64::MAX,
    f64::EPSILON,
    1e200,
    -1e-200,
];

impl<S> Try<'_, S> {
    /// Forward kinematics and the Jacobian of any joint values, the inverse of any pose.
    pub fn wild<T: Bits, const N: usize>(&self, random: &mut Sampler, tally: &mut Tally)
    where
        S: Subject<N>,
    {
        tally.tries += 1;
        let any = Joints::<T, N>::from_fn(|_, _| T::of_bits(random.bits()));
        // Whatever comes of it: that it comes back is all that is asked.
        std::hint::black_box((self.subject.fk(&any), self.subject.jacobian(&any)));
        let target: Pose<T> = self.pose(random);
        let solutions = self.subject.solve(&target);
        let allowed = T::lit(kin_runtime::ik::ACCEPTED) * T::EPS;
        let mut good = solutions.len() <= S::Branch::ALL.len();
        for solution in solutions.iter() {
            tally.solutions += 1;
            tally.families += u64::from(!solution.is_isolated());
            good &= well_formed(&S::JOINTS, &solution.q) && solution.residual <= allowed;
        }
        if !good {
            tally.of_mut(Fault::Malformed).add(1.0, self.index, S::NAME, || bits(&entries(&target)));
        }
    }

    /// A pose of the arm with something wrong about it, or nothing but bits.
    fn pose<T: Bits, const N: usize>(&self, random: &mut Sampler) -> Pose<T>
    where
        S: Subject<N>,
    {
        let commanded = self.subject.commanded(self.sights.row_values(random));
        let q = Joints::<T, N>::from_fn(|joint, _| T::rounded(commanded[joint]));
        let mut all = entries(&self.subject.fk(&q));
        match random.below(5) {
            0 => all = all.map(|_| T::of_bits(random.bits())),
            1 => all[random.below(12)] = T::of_bits(random.bits()),
            2 => all[random.below(12)] = T::rounded(ODD[random.below(ODD.len())]),
            3 => {
                let exponent = T::of_bits(random.bits());
                all[9..].iter_mut().for_each(|x| *x *= exponent);
            }
            _ => {
                let last_bits = |x: &mut T| {
                    let off = T::rounded((random.below(33) as f64) - 16.0);
                    *x += *x * off * T::EPS;
                };
                all.iter_mut().for_each(last_bits);
            }
        }
        let [a, b, c, d, e, f, g, h, i, x, y, z] = all;
        kin_runtime::private::pose([[a, b, c], [d, e, f], [g, h, i]], [x, y, z])
    }
}

/// The rotation by rows, then the position.
fn entries<T: Bits>(pose: &Pose<T>) -> [T; 12] {
    let ([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]) = kin_runtime::private::entries(pose);
    [a, b, c, d, e, f, g, h, i, x, y, z]
}
