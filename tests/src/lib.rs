//! End-to-end tests of Cogmap.
