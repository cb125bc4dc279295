//! Links only if `contract::tasks::forward` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::forward);
