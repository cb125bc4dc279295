//! Six arms, what the best of other generators make of them, and what is promised here.
//!
//! The arms are as they were measured: Puma without the height of its shoulder, Stanford with d6 and without the offset
//! of 20.3 mm at joint 3, Panda with its flange and without the hand that `robots::Panda` carries.

use kin_gen::model::{Arm, Solver};
use kin_gen::program::{Cost, Program};
use kin_runtime::Arm as _;

const PUMA: &str = "struct Puma560(standard, m, deg);
    | joint | theta | d       | a      | alpha |
    | J1    | q     | 0       | 0      | 90    |
    | J2    | q     | 0       | 0.4318 | 0     |
    | J3    | q     | 0.15005 | 0.0203 | -90   |
    | J4    | q     | 0.4318  | 0      | 90    |
    | J5    | q     | 0       | 0      | -90   |
    | J6    | q     | 0       | 0      | 0     |";

const STANFORD: &str = "struct Stanford(standard, m, deg);
    | joint | theta | d     | a | alpha |
    | J1    | q     | 0.412 | 0 | -90   |
    | J2    | q     | 0.154 | 0 | 90    |
    | J3    | -90   | q     | 0 | 0     |
    | J4    | q     | 0     | 0 | -90   |
    | J5    | q     | 0     | 0 | 90    |
    | J6    | q     | 0.263 | 0 | 0     |";

const PANDA: &str = "struct Panda(modified, m, deg);
    | joint | alpha | a       | d     | theta |
    | J1    | 0     | 0       | 0.333 | q     |
    | J2    | -90   | 0       | 0     | q     |
    | J3    | 90    | 0       | 0.316 | q     |
    | J4    | 90    | 0.0825  | 0     | q     |
    | J5    | -90   | -0.0825 | 0.384 | q     |
    | J6    | 90    | 0       | 0     | q     |
    | J7    | 90    | 0.088   | 0     | q     |
    |       | 0     | 0       | 0.107 | 0     |";

/// One of the six arms.
pub struct Measured {
    /// Its table.
    pub table: &'static str,
    /// The fewest multiplications and additions that any of today's generators needs for FK, Jacobian and both together:
    /// sympy, SymForce, CasADi, SYMORO+, SymPyBotics and Pinocchio were measured.
    pub peers: [[usize; 2]; 3],
    /// What is promised: multiplications, additions, sines and cosines, by program.
    pub promised: &'static [(&'static str, [usize; 3])],
}

/// The six arms.
pub const ARMS: [Measured; 6] = [
    Measured {
        table: PUMA,
        peers: [[58, 29], [39, 18], [66, 33]],
        promised: &[
            ("fk", [40, 20, 12]),
            ("jacobian", [32, 13, 10]),
            ("fk_jacobian", [47, 21, 12]),
            ("r36", [12, 4, 6]),
            ("r03", [14, 7, 6]),
        ],
    },
    Measured {
        table: <robots::Ur5 as kin_runtime::Arm<6>>::TABLE,
        peers: [[48, 28], [45, 24], [62, 35]],
        promised: &[("fk", [35, 21, 12]), ("jacobian", [34, 15, 10]), ("fk_jacobian", [46, 22, 12])],
    },
    Measured {
        table: STANFORD,
        peers: [[44, 22], [47, 19], [65, 29]],
        promised: &[
            ("fk", [39, 19, 10]),
            ("jacobian", [42, 14, 8]),
            ("fk_jacobian", [55, 21, 10]),
            ("r36", [12, 4, 6]),
            ("r03", [9, 3, 4]),
        ],
    },
    Measured {
        table: <robots::Irb2400 as kin_runtime::Arm<6>>::TABLE,
        peers: [[58, 30], [66, 32], [84, 42]],
        promised: &[
            ("fk", [41, 23, 12]),
            ("jacobian", [46, 20, 10]),
            ("fk_jacobian", [60, 27, 12]),
            ("r36", [12, 4, 6]),
            ("r03", [12, 7, 6]),
        ],
    },
    Measured {
        table: <robots::LabArm as kin_runtime::Arm<6>>::TABLE,
        peers: [[60, 32], [65, 31], [83, 42]],
        promised: &[
            ("fk", [41, 23, 12]),
            ("jacobian", [46, 20, 10]),
            ("fk_jacobian", [60, 27, 12]),
            ("r36", [12, 4, 6]),
            // 10/5 was measured for the origin of frame 4, before the fixed row with d5; the wrist centre lies behind it,
            // as in the arm above, whose figure is proved minimal.
            ("r03", [12, 7, 6]),
        ],
    },
    Measured {
        table: PANDA,
        peers: [[79, 44], [99, 50], [111, 57]],
        promised: &[("fk", [68, 37, 14]), ("jacobian", [89, 43, 12]), ("fk_jacobian", [105, 52, 14])],
    },
];

macro_rules! tables {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        /// The names and tables of all arms of `robots`.
        pub fn robots() -> Vec<(&'static str, &'static str)> {
            vec![$((robots::$Arm::NAME, robots::$Arm::TABLE)),*]
        }
    };
}

robots::for_each!(tables);

/// The derived arm of a table.
///
/// # Panics
///
/// Where the table is none.
pub fn derived(table: &str) -> Arm {
    kin_gen::compile_text(table).unwrap_or_else(|messages| panic!("{messages}"))
}

/// What is counted of an arm: FK, Jacobian, both, and with a spherical wrist ³R₆ and ⁰R₃ with the wrist centre.
pub fn programs(arm: &Arm) -> Vec<&Program> {
    let mut programs = vec![&arm.forward.fk, &arm.forward.jacobian, &arm.forward.fk_jacobian];
    if let Solver::Pose(solver) = &arm.solver {
        programs.extend([&solver.r36, &solver.r03]);
    }
    programs
}

/// The figures of all arms, one line for each arm and program: the six as measured first.
pub fn counts() -> String {
    let measured = ARMS.iter().map(|arm| {
        let arm = derived(arm.table);
        (arm.name.clone(), arm)
    });
    let robots = robots().into_iter().map(|(name, table)| (format!("robots::{name}"), derived(table)));
    let mut text = format!("{:24} {:12} {:>4} {:>4} {:>5}\n", "arm", "output", "mul", "add", "trig");
    for (name, arm) in measured.chain(robots) {
        for program in programs(&arm) {
            let Cost { mul, add, trig } = program.cost();
            text.push_str(&format!("{name:24} {:12} {mul:4} {add:4} {trig:5}\n", program.name));
        }
    }
    text
}
