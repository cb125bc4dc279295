//! A table made by `macro_rules`, whose fragments arrive in invisible groups.
mod vendor {
    pub use kin_runtime as runtime;
}

macro_rules! planar {
    ($(#[$attribute:meta])* $vis:vis $name:ident, $unit:ident, $upper:expr, $fore:literal, $twist:tt) => {
        kin_runtime::dh! {
            $(#[$attribute])*
            #[dh(crate = $crate::vendor::runtime)]
            $vis struct $name(standard, $unit, deg);
            | joint | alpha  | a      | d | theta |
            | J1    | $twist | $upper | 0 | q     |
            | J2    | -0     | $fore  | 0 | q     |
        }
    };
}

planar!(
    /// Two links.
    #[derive(Debug, Eq)]
    pub(crate) Planar, mm, 2 * (100 + 20.5), -150, 0
);

fn main() {
    use kin_runtime::prelude::*;
    let pose = Planar.fk(&joints![0.0, 0.0]);
    assert_eq!(pose.translation.vector.x, 91.0);
}
