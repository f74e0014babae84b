use std::net::{Ipv4Addr, TcpListener};

use crate::failure::Failure;

/// A port of this machine that nobody uses: the one that is asked for, or any for 0.
pub(crate) fn free(wanted: u16) -> Result<u16, Failure> {
    let taken = TcpListener::bind((Ipv4Addr::LOCALHOST, wanted)).and_then(|listener| listener.local_addr());
    taken.map(|address| address.port()).map_err(|error| {
        Failure::new(format!(
            "port {wanted} cannot be used ({error}): stop what uses it, or choose another with \
             `cargo xtask demo --port N` (0 takes any free one)"
        ))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_taken_port_is_named_with_the_way_out() {
        let holder = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let port = holder.local_addr().unwrap().port();
        let error = free(port).unwrap_err().to_string();
        assert!(error.contains(&port.to_string()) && error.contains("--port"), "{error}");
    }

    #[test]
    fn any_port_is_a_real_one_and_let_go_again() {
        let port = free(0).unwrap();
        assert_ne!(port, 0);
        assert_eq!(free(port).unwrap(), port);
    }
}
