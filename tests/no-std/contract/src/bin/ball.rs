//! Links only if `contract::tasks::ball` cannot panic.

#![no_std]
#![no_main]

contract::no_panic!(contract::tasks::ball);
