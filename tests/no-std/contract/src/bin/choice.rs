//! Links only if `contract::tasks::choice` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::choice);
