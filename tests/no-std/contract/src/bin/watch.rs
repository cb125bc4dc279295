//! Links only if `contract::motion::watch` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::motion::watch);
