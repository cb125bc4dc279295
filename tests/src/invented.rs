//! Invented arms, declared as users declare theirs: structures that the arms of `robots` and of the reference do not have.
//!
//! Those whose name ends in A, or B, stand in `data/invented` too, with truth from a multistart that knows nothing of this
//! project; a test below holds the two tables together. Compiled, they are tried millions of times, which interpreted
//! programs would be too slow for. [`each_invented!`](crate::each_invented) lists those that
//! are tried.

use kin_runtime::dh;

pub use crate::skew::Skew;

/// Calls the macro `$then` with a list, one line for each arm: its type, how its inverse is found, and its name in
/// `data/invented`, or `_`. The words for the inverse are those of `robots::for_each!`, and `shoulder`.
#[macro_export]
macro_rules! each_invented {
    ($then:ident) => {
        $then! {
            Skew            pose     "bases/general_a";
            Square          pose     _;
            Meeting         pose     _;
            MeetingB        pose     "bases/axes_1_2_meet_b";
            ParallelA       pose     "bases/axes_1_2_parallel_a";
            ParallelB       pose     "bases/axes_1_2_parallel_b";
            CrossingA       pose     "bases/axes_2_3_meet_a";
            Swinging        pose     _;
            RrpA            pose     "bases/rrp_a";
            Sliding         pose     "bases/rpr_a";
            PrrA            pose     "bases/prr_a";
            RppB            pose     "bases/rpp_b";
            PrpA            pose     "bases/prp_a";
            PprA            pose     "bases/ppr_a";
            PppA            pose     "bases/ppp_a";
            Human           shoulder _;
            Folding         shoulder _;
            TelescopeA      shoulder "shoulders/telescope_a";
            Twisted         shoulder _;
            HandMeetingA    shoulder "shoulders/axes_5_6_meet_a";
            HandParallelA   shoulder "shoulders/axes_5_6_parallel_a";
            HandCrossingA   shoulder "shoulders/axes_4_5_meet_a";
            HandRprA        shoulder "shoulders/rpr_a";
            HandRrpA        shoulder "shoulders/rrp_a";
            PlanarRrOffset  pair     _;
            SkewRr          pair     _;
            PolarRp         pair     _;
            SkewPr          pair     _;
            PlanarRrr       short    _;
            PlanarRrp       short    _;
            SkewRrr         position _;
            ScaraRrpr       short    _;
            ScaraPrrr       short    _;
            ScaraFolding    short    _;
            WaistRrrr       short    _;
            SkewRrrr        short    _;
            RollRrrrr       short    _;
            SlidingRrprr    short    _;
        }
    };
}

dh! {
    /// Neighbouring axes at right angles, and the arm cuspidal: joints 1 to 3 can change from one solution to another without a
    /// singular pose between.
    pub struct Square(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0   | 1   | -90   |
    | J2    | q     | 1   | 2   | 90    |
    | J3    | q     | 0   | 1.5 | -90   |
    | J4    | q     | 0   | 0   | 90    |
    | J5    | q     | 0   | 0   | -90   |
    | J6    | q     | 0.1 | 0   | 0     |
}

dh! {
    /// Axes 1 and 2 meet.
    pub struct Meeting(standard, mm, deg);

    | joint | theta  | d   | a   | alpha |
    |-------|--------|-----|-----|-------|
    | J1    | q      | 400 | 0   | 90    |
    | J2    | q + 30 | 150 | 500 | 70    |
    | J3    | q      | 100 | 200 | 90    |
    | J4    | q      | 300 | 0   | -90   |
    | J5    | q      | 0   | 0   | 90    |
    | J6    | q      | 100 | 0   | 0     |
}

dh! {
    /// Joint 2 slides between two that turn.
    pub struct Sliding(standard, m, deg);

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.3 | 0.2  | 60    |
    | J2    | 35    | q   | 0.3  | 70    |
    | J3    | q     | 0.2 | 0.35 | 90    |
    | J4    | q     | 0.3 | 0    | -90   |
    | J5    | q     | 0   | 0    | 90    |
    | J6    | q     | 0.1 | 0    | 0     |
}

dh! {
    /// A shoulder like a ball, an elbow, and a hand of two axes.
    pub struct Human(standard, m, deg);

    param upper = 0.4; param fore = 0.35; param stretch = 0.1; param lean = 20deg;

    | joint | theta  | d     | a    | alpha | limits      |
    |-------|--------|-------|------|-------|-------------|
    | J1    | q      | 0.3   | 0    | -90   | -170 .. 170 |
    | J2    | q      | 0     | 0    | 90    |             |
    | J3    | q + 90 | upper | 0    | -90   | -170 .. 170 |
    | J4    | q      | 0     | fore | 0     |             |
    | J5    | q      | 0.03  | 0    | 90    |             |
    | J6    | q      | 0.08  | 0    | 0     |             |

    base: Rx(lean) Tz(0.5);
    tool: Tz(stretch) Ry(30);
}

dh! {
    /// The upper arm as long as the forearm, so that it folds onto axis 5; an oblique shoulder; drives that reach across.
    pub struct Folding(standard, mm, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 250 | 0   | -80   |
    | J2    | q     | 0   | 0   | 75    |
    | J3    | q     | 300 | 0   | 90    |
    | J4    | q     | 0   | 300 | 0     |
    | J5    | q     | 40  | 60  | 90    |
    | J6    | q     | 70  | 20  | 30    |

    couple: J2 += J1, J5 -= J4;
}

dh! {
    /// Joints 4 to 6 are a general base, seen from the tool.
    pub struct Twisted(standard, m, deg);

    | joint | theta | d    | a    | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.3  | 0    | -90   |
    | J2    | q     | 0    | 0    | 90    |
    | J3    | q     | 0.35 | 0.1  | -70   |
    | J4    | q     | 0.1  | 0.3  | 80    |
    | J5    | q     | 0.05 | 0.25 | -75   |
    | J6    | q     | 0.1  | 0.1  | 20    |
}

dh! {
    /// Axes 2 and 3 meet at right angles, and the wrist centre can swing onto axis 2.
    pub struct Swinging(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0.2 | 60    |
    | J2    | q     | 0.4 | 0   | 90    |
    | J3    | q     | 0   | 0.3 | -90   |
    | J4    | q     | 0   | 0   | 90    |
    | J5    | q     | 0   | 0   | -90   |
    | J6    | q     | 0.1 | 0   | 0     |
}

dh! {
    /// A SCARA whose links are equal, so that its quill comes onto axis 1.
    pub struct ScaraFolding(standard, m, deg);

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.4 | 0.25 | 0     |
    | J2    | q     | 0   | 0.25 | 180   |
    | J3    | 0     | q   | 0    | 0     |
    | J4    | q     | 0   | 0    | 0     |
}

/// Declares arms of one table each: name, unit of length and rows.
macro_rules! arms {
    ($($Arm:ident $unit:ident { $($table:tt)* })*) => { $(dh! {
        /// An arm of one structure, named after it.
        pub struct $Arm(standard, $unit, deg);
        $($table)*
    })* };
}

// A table with the rows of an orthogonal wrist after those of the base, and with those of a shoulder before those of the hand.
macro_rules! under_a_wrist {
    ($($Arm:ident { $($base:tt)* })*) => { arms! { $($Arm m {
        | theta | d | a | alpha |
        $($base)*
        | q | 0.3 | 0 | -90 | | q | 0 | 0 | 90 | | q | 0.1 | 0 | 0 |
    })* } };
}
macro_rules! behind_a_shoulder {
    ($($Arm:ident { $($rest:tt)* })*) => { arms! { $($Arm m {
        | theta | d | a | alpha |
        | q | 0.3 | 0 | -90 | | q | 0 | 0 | 90 |
        $($rest)*
    })* } };
}

under_a_wrist! {
    MeetingB { | q | 0.2 | 0 | 55 | | q | 0 | 0.6 | -90 | | q | 0.05 | 0.3 | 45 | }
    ParallelA { | q | 0.3 | 0.5 | 0 | | q | 0.1 | 0.4 | 90 | | q | 0 | 0.3 | -90 | }
    ParallelB { | q | 0.1 | 0.35 | 180 | | q | 0.2 | 0 | 65 | | q | 0.3 | 0.25 | 90 | }
    CrossingA { | q | 0.3 | 0.3 | 90 | | q | 0.4 | 0 | 90 | | q | 0.2 | 0.3 | -90 | }
    RrpA { | q | 0.3 | 0.2 | 90 | | q | 0.1 | 0.1 | 50 | | 20 | q | 0.15 | 90 | }
    PrrA { | 30 | q | 0.2 | 70 | | q | 0.1 | 0.4 | 60 | | q | 0.1 | 0.3 | 90 | }
    RppB { | q | 0.1 | 0.3 | 40 | | -20 | q | 0.2 | 65 | | 15 | q | 0.1 | -90 | }
    PrpA { | 10 | q | 0.2 | 50 | | q | 0.1 | 0.3 | 40 | | 20 | q | 0.2 | 90 | }
    PprA { | 0 | q | 0.1 | 90 | | 40 | q | 0.2 | 55 | | q | 0.1 | 0.5 | 90 | }
    PppA { | 0 | q | 0.1 | 90 | | -90 | q | 0.2 | 90 | | 30 | q | 0.1 | 45 | }
}

behind_a_shoulder! {
    TelescopeA { | q | 0.2 | 0.1 | 90 | | 30 | q | 0.1 | 90 | | q | 0.1 | 0.15 | 90 | | q | 0.2 | 0 | 0 | }
    HandMeetingA { | q | 0.35 | 0.1 | 90 | | q | 0.1 | 0.4 | 70 | | q | 0.2 | 0 | 90 | | q | 0.15 | 0.1 | 0 | }
    HandParallelA { | q | 0.3 | 0.1 | 90 | | q | 0.1 | 0.3 | 80 | | q | 0.1 | 0.4 | 0 | | q | 0.1 | 0.15 | 0 | }
    HandCrossingA { | q | 0.4 | 0.1 | 90 | | q | 0.3 | 0 | 90 | | q | 0.1 | 0.3 | 80 | | q | 0.1 | 0.1 | 0 | }
    HandRrpA { | q | 0.35 | 0.1 | 80 | | q | 0.1 | 0.4 | 90 | | q | 0.1 | 0.1 | 55 | | 20 | q | 0.1 | 0 | }
    HandRprA { | q | 0.3 | 0.1 | 90 | | q | 0.1 | 0.2 | 60 | | 35 | q | 0.2 | 80 | | q | 0.1 | 0.15 | 0 | }
}

arms! {
    PlanarRr m { | theta | d | a | alpha | | q | 0.2 | 0.5 | 0 | | q | 0 | 0.4 | 0 | }
    PlanarRrOffset mm { | theta | d | a | alpha | | q + 30 | 200 | 300 | 180 | | q | 50 | 450 | 20 | base: Rx(40) Tz(100); tool: Tx(20) Ry(15); }
    SpatialRr m { | theta | d | a | alpha | | q | 0.2 | 0.5 | 90 | | q | 0.1 | 0.4 | 0 | }
    SkewRr m { | theta | d | a | alpha | | q | 0.2 | 0.3 | 55 | | q - 20 | 0.1 | 0.5 | 30 | tool: Tz(0.1); }
    PolarRp m { | theta | d | a | alpha | | q | 0.2 | 0.1 | 90 | | 0 | q | 0 | 0 | tool: Tx(0.1); }
    SkewRp m { | theta | d | a | alpha | | q | 0.2 | 0.3 | 60 | | 30 | q | 0.2 | 0 | }
    SlidePr m { | theta | d | a | alpha | | 20 | q | 0.3 | 90 | | q | 0.1 | 0.4 | 0 | }
    SkewPr m { | theta | d | a | alpha | | 0 | q | 0.2 | 40 | | q | 0 | 0.5 | 15 | }
    PlanarRrr m { | theta | d | a | alpha | | q | 0.1 | 0.5 | 0 | | q | 0 | 0.4 | 180 | | q | 0 | 0.2 | 0 | }
    PlanarRrp m { | theta | d | a | alpha | | q | 0.1 | 0.2 | 90 | | 0 | q | 0.1 | -90 | | q | 0.1 | 0.3 | 0 | }
    SkewRrr m { | theta | d | a | alpha | | q | 0.3 | 0.15 | 60 | | q | 0.1 | 0.45 | 75 | | q | -0.2 | 0.25 | 10 | }
    ScaraRrpr m { | theta | d | a | alpha | | q | 0.4 | 0.35 | 0 | | q + 10 | 0 | 0.25 | 180 | | 0 | q | 0.05 | 0 | | q | 0.1 | 0.02 | 0 | }
    ScaraRrrp mm { | theta | d | a | alpha | | q | 400 | 350 | 0 | | q | 0 | 250 | 0 | | q - 15 | 30 | 50 | 180 | | 25 | q | 0 | 10 | }
    ScaraPrrr m { | theta | d | a | alpha | | 0 | q | 0.1 | 0 | | q | 0 | 0.3 | 0 | | q | 0 | 0.25 | 0 | | q | 0.1 | 0.05 | 0 | }
    WaistRrrr m { | theta | d | a | alpha | | q | 0.3 | 0.05 | 90 | | q | 0 | 0.4 | 0 | | q | 0 | 0.35 | 0 | | q | 0 | 0.1 | 0 | tool: Ry(90); }
    SkewRrrr m { | theta | d | a | alpha | | q | 0.3 | 0.15 | 60 | | q | 0.1 | 0.45 | 75 | | q | -0.2 | 0.25 | 50 | | q | 0.1 | 0.1 | 0 | }
    RollRrrrr m { | theta | d | a | alpha | | q | 0.3 | 0.05 | 90 | | q | 0 | 0.4 | 0 | | q | 0 | 0.35 | 0 | | q + 90 | 0 | 0 | 90 | | q | 0.15 | 0 | 0 | }
    SkewRrrrr m { | theta | d | a | alpha | | q | 0.3 | 0.15 | 60 | | q | 0.1 | 0.45 | 75 | | q | -0.2 | 0.25 | 50 | | q | 0.2 | 0 | 65 | | q | 0.15 | 0.1 | 0 | base: Ry(25); }
    SlidingRrprr m { | theta | d | a | alpha | | q | 0.3 | 0 | 90 | | q | 0.1 | 0 | 90 | | 0 | q | 0 | 0 | | q | 0 | 0 | -70 | | q | 0.2 | 0.05 | 0 | }
}

#[cfg(test)]
mod tests {
    use kin_runtime::prelude::*;

    use crate::interpreted::interpret;
    use crate::sample::Sampler;

    /// Whether the two tables are one arm, asked of forward kinematics.
    fn same<const N: usize, A: Arm<N> + Default>(place: &str) {
        let (file, name) = place.split_once('/').expect("a file and a name");
        let path = format!("{}/data/invented/{file}.json", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("the data stands beside the tests");
        let all: Vec<serde_json::Value> = serde_json::from_str(&text).expect("a list of arms");
        let listed = all.iter().find(|arm| arm["name"] == name).unwrap_or_else(|| panic!("no {place}"));
        let table = listed["table"].as_str().expect("a table is text");
        let derived = kin_gen::compile_text(table).expect("the data's tables compile");
        let mut random = Sampler::new(1);
        for _ in 0..5 {
            let q = Joints::<f64, N>::from(random.angles::<N>());
            let (rows, position) = kin_runtime::private::entries(&A::default().fk(&q));
            let listed = interpret(&derived.forward.fk, q.as_slice(), &[], &[]);
            let declared = rows.as_flattened().iter().chain(&position);
            assert!(declared.zip(&listed).all(|(a, b)| (a - b).abs() < 1e-13), "{place} is another arm");
        }
    }

    macro_rules! check {
        ($($Arm:ident $inverse:ident $place:tt;)*) => {
            #[test]
            fn declared_arms_are_those_of_the_data() {
                $(check!($Arm $place);)*
            }
        };
        ($Arm:ident _) => {};
        ($Arm:ident $place:literal) => {
            same::<6, super::$Arm>($place)
        };
    }
    crate::each_invented!(check);
}
