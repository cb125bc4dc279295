//! Prints the hash that every target must have, through the debugger's console.

#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};

#[allow(dead_code, reason = "the short figure is for hosts")]
#[path = "../../../src/bits/mod.rs"]
mod bits;

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

#[entry]
fn main() -> ! {
    hprintln!("{:016x}", bits::hash(bits::POSES));
    loop {
        debug::exit(debug::EXIT_SUCCESS);
    }
}
