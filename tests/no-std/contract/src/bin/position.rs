//! Links only if `contract::tasks::position` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::position);
