use crate::failure::Failure;
use crate::project::{Project, cargo};
use crate::setup::Need;

pub(super) const LINTERS: [Need; 1] = [Need::RustComponents];

pub(super) fn format(_: &Project) -> Result<(), Failure> {
    cargo("fmt --all --check").run()
}

pub(super) fn clippy(_: &Project) -> Result<(), Failure> {
    cargo("clippy --workspace --all-targets -- -D warnings").run()
}

pub(super) fn document(_: &Project) -> Result<(), Failure> {
    cargo("doc --workspace --no-deps").variable("RUSTDOCFLAGS", "-D warnings").run()
}

pub(super) fn test(_: &Project) -> Result<(), Failure> {
    cargo("test --workspace").run()
}
