//! The server as a browser meets it: over a socket.

use std::io::Write;
use std::net::TcpStream;

use super::scratch::Scratch;
use super::*;

const PAGE: &str = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'self'\">";

/// Serves a folder with one page and one module, and returns it with the port.
fn serve(name: &str) -> (Scratch, u16) {
    let folder = Scratch::new(name, &[("index.html", PAGE), ("app.wasm", "\0asm")]);
    let site = Site::open(folder.path()).unwrap();
    let listener = listen(0).unwrap();
    let port = listener.local_addr().unwrap().port();
    std::thread::spawn(move || site.serve(listener));
    (folder, port)
}

/// The status, the headers and the body, as they came.
fn ask(port: u16, method: &str, path: &str) -> String {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
    let request = format!("{method} {path} HTTP/1.1\r\nHost: here\r\nConnection: close\r\n\r\n");
    stream.write_all(request.as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

#[test]
fn every_answer_carries_the_policy_of_the_page() {
    let (_folder, port) = serve("policy");
    for path in ["/", "/app.wasm", "/missing"] {
        let answer = ask(port, "GET", path);
        let policy = "Content-Security-Policy: default-src 'self'; frame-ancestors *\r\n";
        assert!(answer.contains(policy), "{path}: {answer}");
        assert!(answer.contains("Cache-Control: no-cache\r\n"), "{path}: {answer}");
    }
}

#[test]
fn files_come_whole_and_typed() {
    let (_folder, port) = serve("files");
    let page = ask(port, "GET", "/?embed");
    assert!(page.starts_with("HTTP/1.1 200") && page.ends_with(PAGE), "{page}");
    let module = ask(port, "GET", "/app.wasm");
    assert!(module.contains("Content-Type: application/wasm\r\n"), "{module}");
    assert!(module.ends_with("\r\n\r\n\0asm"), "{module}");
}

#[test]
fn what_is_not_there_or_not_allowed_says_so() {
    let (_folder, port) = serve("refusals");
    assert!(ask(port, "GET", "/missing").starts_with("HTTP/1.1 404"));
    assert!(ask(port, "GET", "/../Cargo.toml").starts_with("HTTP/1.1 404"));
    assert!(ask(port, "POST", "/").starts_with("HTTP/1.1 405"));
}

#[test]
fn a_page_without_a_policy_is_not_served() {
    let folder = Scratch::new("bare", &[("index.html", "<p>bare</p>")]);
    let refusal = Site::open(folder.path()).unwrap_err().to_string();
    assert!(refusal.contains("Content-Security-Policy"), "{refusal}");
}
