//! Links only if `contract::motion::trajectory` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::motion::trajectory);
