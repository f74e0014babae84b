//! The same tests in a browser.
#![cfg(target_arch = "wasm32")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "in a test, a panic is how a broken promise shows"
)]

mod laboratory;

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
