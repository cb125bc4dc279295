//! Links only if `contract::tasks::elbow` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::elbow);
