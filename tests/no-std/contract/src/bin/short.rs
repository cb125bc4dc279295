//! Links only if `contract::tasks::short` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::short);
