//! Shows the linker where memory.x is: the boards are those of `thumb`.

fn main() {
    println!("cargo:rustc-link-search={}/../thumb", std::env::var("CARGO_MANIFEST_DIR").unwrap_or_default());
    println!("cargo:rerun-if-changed=../thumb/memory.x");
}
