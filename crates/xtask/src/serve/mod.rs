//! A static web server for the built page, on this machine alone.

mod files;
mod listener;
mod media_type;
mod policy;

use std::fs::File;
use std::io::{Cursor, Read};
use std::net::TcpListener;
use std::path::{Path, PathBuf};

use tiny_http::{Header, Method, Request, Response, Server, StatusCode};

use crate::failure::Failure;
use crate::project::read;

pub(crate) use listener::{address, listen};

/// How many requests are answered at the same time.
const WORKERS: usize = 4;

const NOT_FOUND: &str = "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\">\
    <title>Not found</title><h1>Not found</h1><p><a href=\"/\">To the page</a></p></html>\n";

/// A folder of files to serve, under one security policy.
#[derive(Debug)]
pub(crate) struct Site {
    root: PathBuf,
    policy: String,
}

/// What a request is answered with.
struct Answer {
    status: u16,
    media_type: &'static str,
    body: Box<dyn Read + Send>,
    length: Option<usize>,
}

impl Site {
    /// A built page: the policy is the one that its `index.html` declares for itself.
    pub(crate) fn open(root: &Path) -> Result<Self, Failure> {
        let index = root.join("index.html");
        let policy = policy::header(&read(&index)?).ok_or_else(|| {
            let index = index.display();
            Failure::new(format!("{index} declares no Content-Security-Policy"))
        })?;
        let root = root.canonicalize().map_err(|error| Failure::file(root, &error))?;
        Ok(Self { root, policy })
    }

    /// Answers requests until the listener fails.
    pub(crate) fn serve(&self, listener: TcpListener) -> Result<(), Failure> {
        let server = Server::from_listener(listener, None)
            .map_err(|error| Failure::new(format!("the server did not start: {error}")))?;
        std::thread::scope(|scope| {
            for _ in 0..WORKERS {
                scope.spawn(|| {
                    for request in server.incoming_requests() {
                        self.respond(request);
                    }
                });
            }
        });
        Err(Failure::new("the server stopped listening"))
    }

    fn respond(&self, request: Request) {
        let answer = self.answer(request.method(), request.url());
        let headers = self.headers(answer.media_type);
        let status = StatusCode(answer.status);
        let response = Response::new(status, headers, answer.body, answer.length, None);
        // A browser that went away before its answer came has lost interest: nothing to repair.
        drop(request.respond(response));
    }

    fn answer(&self, method: &Method, url: &str) -> Answer {
        if !matches!(method, Method::Get | Method::Head) {
            return Answer::text(405, "text/plain; charset=utf-8", "Only GET and HEAD\n");
        }
        files::resolve(&self.root, url)
            .and_then(|path| Answer::file(&path))
            .unwrap_or_else(|| Answer::text(404, "text/html; charset=utf-8", NOT_FOUND))
    }

    fn headers(&self, media_type: &str) -> Vec<Header> {
        [
            ("Content-Type", media_type),
            ("Content-Security-Policy", &self.policy),
            ("Cache-Control", "no-cache"),
            ("X-Content-Type-Options", "nosniff"),
        ]
        .into_iter()
        .filter_map(|(name, value)| Header::from_bytes(name, value).ok())
        .collect()
    }
}

impl Answer {
    fn file(path: &Path) -> Option<Self> {
        let file = File::open(path).ok()?;
        let length = usize::try_from(file.metadata().ok()?.len()).ok()?;
        Some(Self {
            status: 200,
            media_type: media_type::of(path),
            body: Box::new(file),
            length: Some(length),
        })
    }

    fn text(status: u16, media_type: &'static str, text: &'static str) -> Self {
        Self { status, media_type, body: Box::new(Cursor::new(text)), length: Some(text.len()) }
    }
}

#[cfg(test)]
mod scratch;
#[cfg(test)]
mod tests;
