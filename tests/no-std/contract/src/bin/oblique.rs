//! Links only if `contract::tasks::oblique` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::oblique);
