//! Links only if `contract::tasks::slide` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::slide);
