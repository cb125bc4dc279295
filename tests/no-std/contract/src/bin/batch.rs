//! Links only if `contract::tasks::batch` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::batch);
