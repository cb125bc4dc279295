//! Links only if `contract::motion::velocity` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::motion::velocity);
