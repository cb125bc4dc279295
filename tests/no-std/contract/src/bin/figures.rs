//! Runs every task on a board and prints, for each, the most stack that it took and how many instructions.
//!
//! The stack below the running function is painted before a step and looked at afterwards. Instructions are counted by the
//! system timer of an emulator that takes one nanosecond for each (`qemu-system-arm -icount shift=0`): 40 to a tick of the
//! board's 25 MHz; and once more, where that clock would come round, 1,000 to a tick of its reference of 1 MHz.

#![no_std]
#![no_main]

use core::panic::PanicInfo;
use core::ptr;

use contract::tasks::{ALL, Inputs};
use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::register::msp;
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};

/// Inputs for each task …
const INPUTS: usize = 200;
/// … or, once there are a tenth of them, as many as so many instructions go through: an emulator does some 10⁸ in a second.
const ENOUGH: u64 = 2_000_000_000;
/// Bytes that are painted: no task may take more.
const PAINTED: usize = 64 * 1024;
const COLOUR: u32 = 0xc0_1055_a1;
/// Instructions to a tick of the processor's clock, and of the reference.
const TICKS: [(SystClkSource, u64); 2] = [(SystClkSource::Core, 40), (SystClkSource::External, 1000)];
/// The most ticks that are told from fewer.
const LONGEST: u32 = 0x00ff_ffff;

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

/// Runs a step on painted stack; how many bytes of it lost their paint.
#[inline(never)]
fn stack(step: &mut dyn FnMut()) -> usize {
    let top = (msp::read() & !3) as usize;
    let words = || (0..PAINTED / 4).map(move |word| (top - PAINTED + 4 * word) as *mut u32);
    for word in words() {
        // SAFETY: below the stack pointer nothing is alive, interrupts are off, and the board has 4 MiB of stack.
        unsafe { ptr::write_volatile(word, COLOUR) };
    }
    step();
    // SAFETY: as above; what is read is compared only.
    let kept = words().take_while(|word| unsafe { ptr::read_volatile(*word) } == COLOUR).count();
    PAINTED - 4 * kept
}

/// Instructions of a step, by one of the clocks.
#[inline(never)]
fn instructions(timer: &mut SYST, (clock, tick): (SystClkSource, u64), step: &mut dyn FnMut()) -> u64 {
    timer.set_clock_source(clock);
    timer.clear_current();
    let start = SYST::get_current();
    step();
    u64::from(start.wrapping_sub(SYST::get_current()) & LONGEST) * tick
}

#[entry]
fn main() -> ! {
    let mut timer = Peripherals::take().map(|all| all.SYST);
    if let Some(timer) = &mut timer {
        let [fine, coarse] = TICKS;
        timer.set_reload(LONGEST);
        timer.clear_current();
        timer.enable_counter();
        for (name, task) in ALL {
            let (mut inputs, mut deepest, mut longest, mut sum, mut steps) =
                (Inputs::unknown(), 0, 0, 0_u64, 0);
            for input in 0..INPUTS {
                if input >= INPUTS / 10 && sum > ENOUGH {
                    break;
                }
                task(&mut inputs, &mut |step| {
                    let mut about = 0;
                    deepest = deepest.max(stack(&mut || about = instructions(timer, coarse, step)));
                    let comes_round = about > u64::from(LONGEST) * fine.1 / 2;
                    let count = if comes_round { about } else { instructions(timer, fine, step) };
                    longest = longest.max(count);
                    sum += count;
                    steps += 1;
                });
            }
            hprintln!("{} {} {} {}", name, deepest, sum / steps, longest);
        }
        loop {
            debug::exit(debug::EXIT_SUCCESS);
        }
    }
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}
