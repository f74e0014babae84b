use std::net::{Ipv4Addr, TcpListener};

use crate::failure::Failure;

/// Takes a port of this machine alone; 0 means any that is free.
pub(crate) fn listen(port: u16) -> Result<TcpListener, Failure> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
        Failure::new(format!(
            "port {port} cannot be used ({error}): stop what uses it, or choose another with \
             `cargo xtask demo --port N` (0 takes any free one)"
        ))
    })
}

/// The address to open in a browser.
pub(crate) fn address(listener: &TcpListener) -> Result<String, Failure> {
    let socket =
        listener.local_addr().map_err(|error| Failure::new(format!("the server has no address: {error}")))?;
    Ok(format!("http://{socket}/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_taken_port_is_named_with_the_way_out() {
        let holder = listen(0).unwrap();
        let port = holder.local_addr().unwrap().port();
        let error = listen(port).unwrap_err().to_string();
        assert!(error.contains(&port.to_string()) && error.contains("--port"), "{error}");
    }
}
