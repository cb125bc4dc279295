//! What is promised to embedded programs, in tasks that a program can link and a board can run.
//!
//! Each [task](tasks) asks one thing of the library with values that the optimiser does not know. The programs of `bin`
//! are one task each with a [panic handler](no_panic) that calls a function which nobody has defined: the linker refuses
//! them as long as a path leads there. `figures` runs all tasks under an emulator and prints what they take.

#![no_std]

pub mod motion;
pub mod tasks;

#[allow(dead_code, reason = "the hash is for other programs")]
#[path = "../../../src/bits/mod.rs"]
mod bits;

/// A program of one task that links only if it cannot panic.
#[macro_export]
macro_rules! no_panic {
    ($task:path) => {
        use core::panic::PanicInfo;

        unsafe extern "C" {
            safe fn a_path_to_a_panic_is_left() -> !;
        }

        #[panic_handler]
        fn panic(_: &PanicInfo) -> ! {
            a_path_to_a_panic_is_left()
        }

        #[cortex_m_rt::entry]
        fn main() -> ! {
            let mut inputs = $crate::tasks::Inputs::unknown();
            loop {
                $task(&mut inputs, &mut |step| step());
            }
        }
    };
}
