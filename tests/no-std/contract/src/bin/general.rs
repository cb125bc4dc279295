//! Links only if `contract::tasks::general` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::general);
