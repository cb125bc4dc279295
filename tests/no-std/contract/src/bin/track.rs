//! Links only if `contract::tasks::track` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::track);
