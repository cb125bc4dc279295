//! Must not link: it can panic, and shows that the others would be caught.

#![no_std]
#![no_main]

contract::no_panic!(out_of_bounds);

fn out_of_bounds(_: &mut contract::tasks::Inputs, _: contract::tasks::Run<'_>) {
    core::hint::black_box([1, 2, 3][core::hint::black_box(2)]);
}
