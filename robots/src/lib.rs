//! Real robot arms, ready to use: one table per file, each with the source of its numbers.
//!
//! ```
//! use kin_runtime::prelude::*;
//! use robots::Puma560;
//!
//! let q = joints![0.1, -0.4, 0.2, 0.3, 0.9, -0.5];
//! let pose = Puma560.fk(&q);
//! assert!(Puma560.ik(&pose).iter().any(|s| (s.q - q).norm() < 1e-12));
//! ```
//!
//! Lengths are in the unit of the source, [`LENGTH_UNIT`](kin_runtime::Arm::LENGTH_UNIT); angles are radians. Each file
//! holds two poses or more that the compiler checks; they were computed with 50 digits straight from the sources.
//!
//! To add an arm, write its file and add its line to [`for_each!`]; the rest of this crate and the tests follow.

#![no_std]

/// Calls the macro `$then` with the list of all arms, one line for each: its type, its file, how its inverse is found, and its
/// name in the reference data of the `tests` member, or `_`. Found is a pose of six joints with a spherical wrist (`pose`) or of
/// fewer joints (`short`); a position, or a pose, of three joints (`position`) or two (`pair`); or nothing (`none`).
///
/// ```
/// use kin_runtime::prelude::*;
///
/// macro_rules! print_names {
///     ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
///         $(println!("{}", robots::$Arm::NAME);)*
///     };
/// }
/// robots::for_each!(print_names);
/// ```
#[macro_export]
macro_rules! for_each {
    ($then:ident) => {
        $then! {
            Irb140          irb140          pose     "irb140";
            Irb2400         irb2400         pose     "abb_irb2400";
            Irb6640         irb6640         pose     "abb_irb6640";
            LrMate200ic     lr_mate200ic    pose     "fanuc_lrmate200ic";
            M10ia           m10ia           pose     "fanuc_m10ia";
            Panda           panda           none     "panda";
            Kr5Arc          kr5_arc         pose     "kr5arc";
            Kr6R700         kr6r700         pose     "opw_kuka_kr6r700";
            Kr6R900Sixx     kr6r900_sixx    pose     "kuka_kr6r900sixx";
            Kr16            kr16            pose     "kuka_kr16_2";
            Kr150R3100      kr150r3100      pose     "kuka_kr150r3100";
            Rv4fr           rv4fr           pose     "ssik_rv4fr";
            Stanford        stanford        pose     "stanford";
            Tx40            tx40            pose     "opw_staubli_tx40";
            Puma560         puma560         pose     "puma560";
            Ur5             ur5             none     "ur5";
            Gp7             gp7             pose     "motoman_gp7";
            Gp25            gp25            pose     "motoman_gp25";
            LabArm          lab_arm         pose     "seed000_lab6dof";
            Anthropomorphic anthropomorphic pose     _;
            Seed001Yzy      seed001_yzy     pose     "seed001_yzy";
            ElbowWrist      elbow_wrist     pose     "seed003_lab6dof";
            LabRrr          lab_rrr         position "seed004_3dof";
            Al5d            al5d            position "al5d";
            Cobra600        cobra600        short    "cobra600";
            Orion5          orion5          short    "orion5";
            Planar3         planar3         short    "planar3";
            TwoLink         two_link        pair     "twolink";
        }
    };
}

macro_rules! declare {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        $(
            pub mod $file;
            pub use $file::$Arm;
        )*

        /// Every arm, for programs that take an arm by its name.
        pub const ALL: &[&dyn kin_runtime::DynArm] = &[$(&$Arm),*];
    };
}
for_each!(declare);
